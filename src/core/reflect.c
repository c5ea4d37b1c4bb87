/* SPDX-License-Identifier: Apache-2.0 */
#include "ndotl/ndotl.h"

ndl_vec3 ndl_reflect(ndl_vec3 w, ndl_vec3 n) {
    double x = (double)n.x, y = (double)n.y, z = (double)n.z;
    double twice = 2.0 * (x * (double)w.x + y * (double)w.y + z * (double)w.z);
    ndl_vec3 r = {(float)(twice * x - (double)w.x), (float)(twice * y - (double)w.y),
                  (float)(twice * z - (double)w.z)};
    return r;
}
