/* SPDX-License-Identifier: Apache-2.0 */
/* ndotl: conversions between parameters that mean one thing, and directions from what people type.

   QUANTITIES of ndl_convert, numbers unless said otherwise
     alpha, alpha_x, alpha_y   microfacet widths, [0, 4]
     roughness                 perceptual width, [0, 1]; alpha by roughness_map
     anisotropy                [0, 1], 0 if not given; alpha_x, alpha_y of alpha by anisotropy_kind
     blinn_exponent            exponent of the NDF NoH^p, >= 0: alpha = sqrt(2/(p + 2))
     phong_exponent            a quarter of blinn_exponent
     ior, f0                   index of refraction > 0; reflectance straight on, [0, 1]
     sigma, sigma_deg          Oren-Nayar roughness in radians, degrees
     a, a57                    Oren and Nayar's A with 0.33 and 0.57, (0.5, 1]
   and, as words, how some of them belong together
     roughness_map             square (default), direct, sqrt
     anisotropy_kind           burley (default), kulla, openpbr, gltf */
#ifndef NDOTL_CONVERT_H
#define NDOTL_CONVERT_H
#include "ndotl/ndotl.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One thing that is known: a number, or a word for the keys that take one (else NULL). */
typedef struct { const char *key; float value; const char *word; } ndl_known;

/* The value of `key` that follows from `count` known quantities, through as many steps as needed.
   Domain:   each known value in its range above.
   Errors:   NDL_E_UNKNOWN_NAME: a key or word; NDL_E_TYPE: a word for a number or the reverse;
             NDL_E_RANGE: a value out of its range, or the result has none; NDL_E_DUPLICATE,
             NDL_E_CONFLICT: a quantity is given twice, or follows from the others already;
             NDL_E_UNSUPPORTED: the known quantities do not say it; the text names what would. */
NDL_API int ndl_convert(const ndl_known *known, size_t count, const char *key, float *to,
                        ndl_error *error);

/* The keys of ndl_convert, separated by blanks. */
NDL_API const char *ndl_convert_keys(void);
/* The words of a key that takes one, separated by blanks; NULL for every other key. */
NDL_API const char *ndl_convert_words(const char *key);

/* The unit vector along (x, y, z), normalised in double and rounded once, into *to.
   Returns the length of (x, y, z): 0, infinite or NaN where it has no direction; *to is then 0. */
NDL_API double ndl_direction(double x, double y, double z, ndl_vec3 *to);

/* The direction at `theta_deg` from the normal and `phi_deg` from the tangent towards the
   bitangent, in degrees; multiples of 90 are exact. Returns 1, or NaN for angles not finite. */
NDL_API double ndl_direction_deg(double theta_deg, double phi_deg, ndl_vec3 *to);

#ifdef __cplusplus
}
#endif
#endif
