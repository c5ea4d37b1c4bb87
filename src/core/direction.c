/* SPDX-License-Identifier: Apache-2.0 */
#include "ndotl/convert.h"

#include <math.h>

double ndl_direction(double x, double y, double z, ndl_vec3 *to) {
    double scale = 1.0, square = x * x + y * y + z * z;
    *to = (ndl_vec3){0.0f, 0.0f, 0.0f};
    if (!(square > 0x1p-900 && square < 0x1p+900)) { /* squares that over- or underflow */
        double most = fmax(fabs(x), fmax(fabs(y), fabs(z)));
        if (!isfinite(x) || !isfinite(y) || !isfinite(z)) return (double)NAN;
        if (most == 0.0) return 0.0;
        int exponent;
        frexp(most, &exponent);
        scale = ldexp(0.5, exponent);
        x /= scale;
        y /= scale;
        z /= scale;
        square = x * x + y * y + z * z;
    }
    double length = sqrt(square);
    to->x = (float)(x / length);
    to->y = (float)(y / length);
    to->z = (float)(z / length);
    return length * scale;
}

typedef struct {
    double sine, cosine;
} turn;

/* Sine and cosine of an angle in degrees: exact reduction first, so 90 degrees has cosine 0. */
static turn turn_of(double degrees) {
    double quarters = floor(fmod(degrees, 360.0) / 90.0 + 0.5);
    double rest = (fmod(degrees, 360.0) - 90.0 * quarters) * (3.14159265358979323846 / 180.0);
    double s = sin(rest), c = cos(rest);
    switch ((int)quarters & 3) {
    case 0:
        return (turn){s, c};
    case 1:
        return (turn){c, -s};
    case 2:
        return (turn){-s, -c};
    default:
        return (turn){-c, s};
    }
}

double ndl_direction_deg(double theta_deg, double phi_deg, ndl_vec3 *to) {
    *to = (ndl_vec3){0.0f, 0.0f, 0.0f};
    if (!isfinite(theta_deg) || !isfinite(phi_deg)) return (double)NAN;
    turn theta = turn_of(theta_deg), phi = turn_of(phi_deg);
    /* Adding 0 turns -0 into 0. */
    return ndl_direction(theta.sine * phi.cosine + 0.0, theta.sine * phi.sine + 0.0,
                         theta.cosine + 0.0, to);
}
