/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
#ifndef ND_SHADE_TOON_DIFFUSE_H
#define ND_SHADE_TOON_DIFFUSE_H
#include "shade/toon.h"

#define TOON_DIFFUSE_PARAMS(P) TOON_COLOR_PARAMS(P) TOON_RAMP_PARAMS(P)

/* Claims no law: it is no reflectance. */
#define TOON_DIFFUSE_KERNELS(K)                                                                    \
    K(toon_diffuse, toon_diffuse, 0) K(toon_diffuse, toon_diffuse_ramp, 0)

#define TOON_DIFFUSE_MANUAL(M)                                                                     \
    M(WHAT, "Cartoon shading: lambert's cosine cut into two colours, or mapped by a ramp.")        \
    M(FORMULA, "brdf_cos = color1 if wi.z >= threshold, else color2; or ramp(wi.z). "              \
               "brdf = brdf_cos/wi.z.")                                                            \
    M(WHEN, "Comics, technical drawings, pictures that should read at a glance.")                  \
    M(LIMITS, "Not a reflectance: neither reciprocal nor bounded, and brdf grows towards the "     \
              "light's horizon. Below the horizon it is 0, not color2.")                           \
    M(ENERGY, "Gains: two equal colours c reflect 2 pi c of a white furnace.")                     \
    M(DEPARTURES,                                                                                  \
      "The lecture draws its gradients from 1-D textures without saying their domain "             \
      "or filter; here a ramp is the exact piecewise linear function of the cosine in "            \
      "linear RGB, so no texel shifts the threshold. The lecture has no test of the "              \
      "horizon.")                                                                                  \
    M(SAMPLING,                                                                                    \
      "Directions by the cosine, pdf = NoL/pi; the weight pi brdf_cos/NoL has no bound at the "    \
      "light's horizon.")                                                                          \
    M(SOURCE, "formulas S4.26, S4.28")

STRUCT(toon_diffuse_p) {
    TOON_DIFFUSE_PARAMS(FIELD)
};

/* The lecture's colour over wi.z, 1/sr; ..._cos is the colour itself. Source: formulas S4.26. */
FN vec3 toon_diffuse_brdf(toon_diffuse_p p, vec3 wi, vec3 wo) {
    return toon_over_cosine(toon_step(p.color1, p.color2, p.threshold, wi.z), wi, wo);
}
FN vec3 toon_diffuse_brdf_cos(toon_diffuse_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), toon_step(p.color1, p.color2, p.threshold, wi.z));
}

/* The same with the ramp's colour at wi.z. Source: formulas S4.28. */
FN vec3 toon_diffuse_ramp_brdf(toon_diffuse_p p, vec3 wi, vec3 wo) {
    return toon_over_cosine(lut1(p.ramp, wi.z), wi, wo);
}
FN vec3 toon_diffuse_ramp_brdf_cos(toon_diffuse_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), lut1(p.ramp, wi.z));
}

/* The cosine's density: no sample is lost. The colour over it grows towards the horizon: the
   weight has no bound. */
FN vec3 toon_diffuse_sample(toon_diffuse_p p, vec3 wo, vec3 u) {
    return cosine_sample(wo, u);
}
FN num toon_diffuse_pdf(toon_diffuse_p p, vec3 wi, vec3 wo) {
    return cosine_pdf(wi, wo);
}

#endif
