/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* What the toon models share: a colour chosen by one cosine, which is the value times the cosine
   of wi itself. */
#ifndef ND_SHADE_TOON_H
#define ND_SHADE_TOON_H
#include "shade/sampling.h"

#define TOON_COLOR_PARAMS(P)                                                                       \
    P(RGB, color1, 0.0, 1.0, 0.8, "1", "where the cosine has reached the threshold")               \
    P(RGB, color2, 0.0, 1.0, 0.2, "1", "below the threshold")                                      \
    P(NUM, threshold, -1.0, 1.0, 0.5, "1", "cosine at which the colour changes")
#define TOON_RAMP_PARAMS(P)                                                                        \
    P(RAMP, ramp,                                                                                  \
      "instead of the two colours: stops over the cosine; straight between them, constant "        \
      "outside, and a step where two share a place")                                               \
    P(GROUP, toon)

/* color1 from the threshold on, color2 below. Source: formulas S4.26. */
FN vec3 toon_step(vec3 color1, vec3 color2, num threshold, num cosine) {
    return v3_sel(cosine >= threshold, color1, color2);
}

/* The colour divided by the cosine of wi, so that brdf times the cosine is the colour. */
FN vec3 toon_over_cosine(vec3 color, vec3 wi, vec3 wo) {
    num z = max_(wi.z, SMALLEST);
    return gated(lit(wi, wo), v3(color.x / z, color.y / z, color.z / z));
}

#endif
