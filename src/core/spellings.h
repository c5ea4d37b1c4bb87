/* SPDX-License-Identifier: Apache-2.0 */
/* Groups: quantities that several keys spell, and what each spelling means. */
#ifndef ND_CORE_SPELLINGS_H
#define ND_CORE_SPELLINGS_H
#include "core/schema.h"

extern const nd_group nd_group_width;       /* alpha_x, alpha_y of the microfacet models */
extern const nd_group nd_group_metal_width; /* of metal_rough */
extern const nd_group nd_group_ward_width;
extern const nd_group nd_group_oren_nayar_width; /* sigma, and the table of variant=table */
extern const nd_group nd_group_toon;             /* a ramp, or two colours and a threshold */
extern const nd_group nd_group_fresnel;     /* which Fresnel term, and its f0, ior or eta, k */

/* n widths from n values of one quantity, as nd_group_width does it for one: alpha or roughness by
   `map` (a word of roughness_map, -1: the values are alpha), then the stretch of `kind`, cut to the
   range that alpha acts in. anisotropy: one for all lanes, or one per lane. x and y may be one
   array of the values. */
void nd_width_lanes(size_t n, const float *values, int map, int kind, const float *anisotropy,
                    bool anisotropy_per_lane, float largest, float *x, float *y);

#endif
