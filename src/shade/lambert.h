/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
#ifndef ND_SHADE_LAMBERT_H
#define ND_SHADE_LAMBERT_H
#include "shade/sampling.h"

#define LAMBERT_PARAMS(P)                                                                          \
    P(RGB, color, 0.0, 1.0, 0.8, "1",                                                              \
      "share of the arriving light that leaves again: 0.04 charcoal, 0.8 white clay, 0.9 snow")

#define LAMBERT_KERNELS(K) K(lambert, lambert, ND_CLAIM_ALL | ND_TRAIT_LECTURE_PI)

#define LAMBERT_MANUAL(M)                                                                          \
    M(WHAT, "A matt surface that looks equally bright from everywhere.")                           \
    M(FORMULA, "f = color / pi")                                                                   \
    M(WHEN, "Paper, plaster, unglazed clay under one light; the diffuse part of most materials. "  \
            "For rough clay, sand or cloth, which stay bright towards their edge, oren_nayar.")    \
    M(LIMITS, "No highlight, no edge brightening, no dependence on the viewer.")                   \
    M(DEPARTURES, "S4.8 and S4.12 write f = rho without 1/pi, and with the cosine inside: such a " \
                  "surface would reflect pi times what arrives. That quantity is "                 \
                  "--convention scanline.")                                                        \
    M(SAMPLING, "Directions by the cosine, pdf = NoL/pi: every sample weighs the same.")           \
    M(SOURCE, "[Lambert1760]; formulas S2.3, S4.8 to S4.14")

STRUCT(lambert_p) {
    LAMBERT_PARAMS(FIELD)
};

/* Reflected radiance per irradiance, 1/sr: color / pi, constant over the hemisphere.
   Source: [Lambert1760]. */
FN vec3 lambert_brdf(lambert_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), v3_scale(p.color, INV_PI));
}

/* lambert_brdf times the cosine of wi, 1/sr. */
FN vec3 lambert_brdf_cos(lambert_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), v3_scale(p.color, INV_PI * wi.z));
}

/* The cosine's density: no sample is lost. */
FN vec3 lambert_sample(lambert_p p, vec3 wo, vec3 u) {
    return cosine_sample(wo, u);
}
FN num lambert_pdf(lambert_p p, vec3 wi, vec3 wo) {
    return cosine_pdf(wi, wo);
}

#endif
