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

#endif
