/* SPDX-License-Identifier: Apache-2.0 */
#include "core/tone.h"

#include <math.h>

float nd_srgb_decode(float encoded) {
    double e = (double)encoded;
    return (float)(e <= 0.04045 ? e / 12.92 : pow((e + 0.055) / 1.055, 2.4));
}

float nd_srgb_encode(float linear) {
    double x = (double)linear;
    return (float)(x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055);
}
