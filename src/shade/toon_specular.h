/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
#ifndef ND_SHADE_TOON_SPECULAR_H
#define ND_SHADE_TOON_SPECULAR_H
#include "shade/halfway.h"
#include "shade/toon.h"

#define TOON_SPECULAR_WORDS "reflect half"

#define TOON_SPECULAR_PARAMS(P)                                                                    \
    TOON_COLOR_PARAMS(P)                                                                           \
    P(CHOICE, by, TOON_SPECULAR_WORDS, reflect,                                                    \
      "reflect: the cosine between the viewer and the mirrored light (Phong's); half: between "    \
      "the normal and the half vector (Blinn's), about half the angle")                            \
    TOON_RAMP_PARAMS(P)

/* Claims no law: it is no reflectance. */
#define TOON_SPECULAR_KERNELS(K)                                                                   \
    K(toon_specular, toon_specular_reflect, 0)                                                     \
    K(toon_specular, toon_specular_reflect_ramp, 0)                                                \
    K(toon_specular, toon_specular_half, 0)                                                        \
    K(toon_specular, toon_specular_half_ramp, 0)

#define TOON_SPECULAR_MANUAL(M)                                                                    \
    M(WHAT, "A cartoon highlight: a spot of one colour where the viewer is near the mirror "       \
            "direction, another elsewhere; or a ramp.")                                            \
    M(FORMULA, "brdf_cos = color1 if x >= threshold, else color2; or ramp(x); x = wo . r, "        \
               "r = 2 (n.wi) n - wi, or x = n.h. brdf = brdf_cos/wi.z.")                           \
    M(WHEN, "On top of toon_diffuse: 0.8*toon_diffuse() + 0.2*toon_specular(color2=0, "            \
            "threshold=0.95).")                                                                    \
    M(LIMITS, "Not a reflectance: neither reciprocal nor bounded, and brdf grows towards the "     \
              "light's horizon. color2 is what the surface has everywhere but in the spot: 0 for " \
              "a highlight that is added.")                                                        \
    M(ENERGY, "Gains: two equal colours c reflect 2 pi c of a white furnace.")                     \
    M(DEPARTURES,                                                                                  \
      "The lecture leaves the cosine unclamped, which matters for a threshold below "              \
      "0, and so does this; it has no test of the horizon, so its highlight may light "            \
      "back faces, and this one does not.")                                                        \
    M(SAMPLING,                                                                                    \
      "Directions by the cosine, pdf = NoL/pi; the weight pi brdf_cos/NoL has no bound at the "    \
      "light's horizon.")                                                                          \
    M(SOURCE, "formulas S4.26, S4.27, S4.28")

STRUCT(toon_specular_p) {
    TOON_SPECULAR_PARAMS(FIELD)
};

/* n.h of the unit half vector, in [0, 1]; 0 where there is none. */
FN num normal_half_cosine(vec3 wi, vec3 wo) {
    halfway m = halfway_of(wi, wo);
    return min_(m.h.z / sqrt_(max_(m.hh, SMALLEST)), 1.0f);
}

/* The lecture's colour over wi.z, 1/sr; ..._cos is the colour itself. Source: formulas S4.26. */
FN vec3 toon_specular_reflect_brdf(toon_specular_p p, vec3 wi, vec3 wo) {
    num x = mirror_cosine(wi, wo);
    return toon_over_cosine(toon_step(p.color1, p.color2, p.threshold, x), wi, wo);
}
FN vec3 toon_specular_reflect_brdf_cos(toon_specular_p p, vec3 wi, vec3 wo) {
    num x = mirror_cosine(wi, wo);
    return gated(lit(wi, wo), toon_step(p.color1, p.color2, p.threshold, x));
}
FN vec3 toon_specular_reflect_ramp_brdf(toon_specular_p p, vec3 wi, vec3 wo) {
    return toon_over_cosine(lut1(p.ramp, mirror_cosine(wi, wo)), wi, wo);
}
FN vec3 toon_specular_reflect_ramp_brdf_cos(toon_specular_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), lut1(p.ramp, mirror_cosine(wi, wo)));
}

/* The same by n.h. Source: formulas S4.27. */
FN vec3 toon_specular_half_brdf(toon_specular_p p, vec3 wi, vec3 wo) {
    num x = normal_half_cosine(wi, wo);
    return toon_over_cosine(toon_step(p.color1, p.color2, p.threshold, x), wi, wo);
}
FN vec3 toon_specular_half_brdf_cos(toon_specular_p p, vec3 wi, vec3 wo) {
    num x = normal_half_cosine(wi, wo);
    return gated(lit(wi, wo), toon_step(p.color1, p.color2, p.threshold, x));
}
FN vec3 toon_specular_half_ramp_brdf(toon_specular_p p, vec3 wi, vec3 wo) {
    return toon_over_cosine(lut1(p.ramp, normal_half_cosine(wi, wo)), wi, wo);
}
FN vec3 toon_specular_half_ramp_brdf_cos(toon_specular_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), lut1(p.ramp, normal_half_cosine(wi, wo)));
}

/* The cosine's density: no sample is lost. Not the spot: the colour around it counts as much. */
FN vec3 toon_specular_sample(toon_specular_p p, vec3 wo, vec3 u) {
    return cosine_sample(wo, u);
}
FN num toon_specular_pdf(toon_specular_p p, vec3 wi, vec3 wo) {
    return cosine_pdf(wi, wo);
}

#endif
