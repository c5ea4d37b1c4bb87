/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
#ifndef ND_SHADE_PHONG_H
#define ND_SHADE_PHONG_H
#include "shade/sampling.h"

#define PHONG_WORDS "lecture normalized"

#define PHONG_PARAMS(P)                                                                            \
    P(RGB, color, 0.0, 1.0, 1.0, "1", "colour of the highlight: white for plastic")                \
    P(NUM, exponent, 0.0, 3.4028234663852886e38, 30.0, "1",                                        \
      "how small the highlight is: 5 satin, 30 plastic, 200 polished")                             \
    P(CHOICE, variant, PHONG_WORDS, lecture,                                                       \
      "lecture: the power takes the place of f cos; normalized: (exponent + 2)/(2 pi) times it, "  \
      "a reflectance")

#define PHONG_KERNELS(K)                                                                           \
    K(phong, phong_lecture, 0)                                                                     \
    K(phong, phong_normalized, ND_CLAIM_ALL)

#define PHONG_MANUAL(M)                                                                            \
    M(WHAT, "A highlight around the mirror direction of the light: a power of the cosine between " \
            "it and the viewer.")                                                                  \
    M(FORMULA, "r = 2 (n.wi) n - wi, c = max(0, wo.r). lecture: brdf_cos = color c^exponent, "     \
               "brdf = brdf_cos/wi.z; normalized: brdf = color (exponent + 2)/(2 pi) "             \
               "c^exponent.")                                                                      \
    M(WHEN, "Old assets and lectures. blinn_phong needs four times the exponent for the same "     \
            "highlight.")                                                                          \
    M(LIMITS, "Isotropic; no brightening towards the edge. The lecture's form is not reciprocal: " \
              "exponent 5, NoL .2, NoV .8 gives 1.170, exchanged .292.")                           \
    M(ENERGY, "lecture gains below exponent 5.28: it reflects pi, 1.047, .571, .0622 of a white "  \
              "furnace at NoV = 1 for exponent 1, 5, 10, 100. normalized reflects at most 1.")     \
    M(DEPARTURES,                                                                                  \
      "S4's text adds d' = n' - d twice, but says n' is subtracted from the light "                \
      "vector: that order gives 3 d - 2 n' ((.6, 0, .8) becomes (1.8, 0, .8)). In "                \
      "GLSL r = -reflect(d, n) for d towards the light, as here; with the opposite d "             \
      "r points into the surface. 0^0 is 1: exponent 0 is white everywhere. S4 has no "            \
      "test of the horizon: light 5.7 degrees below it still gives v.r = .98.")                    \
    M(SAMPLING,                                                                                    \
      "Directions around the mirrored viewer, pdf = (exponent + 1)/(2 pi) c^exponent; those "      \
      "below the horizon are no sample.")                                                          \
    M(SOURCE, "[Phong75], [LafortuneWillems94]; formulas S4.18 to S4.22, S4.41, S4.55")

STRUCT(phong_p) {
    PHONG_PARAMS(FIELD)
};

/* max(0, wo . mirrored wi)^exponent; exponent 0 gives 1, also for 0^0. Source: [Phong75]. */
FN num phong_lobe(num exponent, vec3 wi, vec3 wo) {
    return pow_(clamp_(mirror_cosine(wi, wo), 0.0f, 1.0f), exponent);
}

/* The lecture's quantity over the cosine of wi, 1/sr; ..._cos is the quantity itself.
   Source: formulas S4.22. */
FN vec3 phong_lecture_brdf(phong_p p, vec3 wi, vec3 wo) {
    num f = phong_lobe(p.exponent, wi, wo) / max_(wi.z, SMALLEST);
    return gated(lit(wi, wo), v3_scale(p.color, f));
}
FN vec3 phong_lecture_brdf_cos(phong_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), v3_scale(p.color, phong_lobe(p.exponent, wi, wo)));
}

/* color (exponent + 2)/(2 pi) c^exponent, 1/sr: 1 of a white furnace at NoV = 1, less elsewhere.
   Source: [LafortuneWillems94]. */
FN num phong_normalized_lobe(num exponent, vec3 wi, vec3 wo) {
    return (exponent + 2.0f) * (0.5f * INV_PI) * phong_lobe(exponent, wi, wo);
}
FN vec3 phong_normalized_brdf(phong_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), v3_scale(p.color, phong_normalized_lobe(p.exponent, wi, wo)));
}
FN vec3 phong_normalized_brdf_cos(phong_p p, vec3 wi, vec3 wo) {
    num f = phong_normalized_lobe(p.exponent, wi, wo) * wi.z;
    return gated(lit(wi, wo), v3_scale(p.color, f));
}

/* wi around the mirrored wo, with the power of the cosine to it as density. What falls below the
   horizon is no sample. The lobe of exponent 0 is 1 also where that cosine is negative: it is drawn
   around the normal. Source: [LafortuneWillems94]. */
FN vec3 phong_sample(phong_p p, vec3 wo, vec3 u) {
    num t2 = tangent2_of_power(u.x, 1.0f / (p.exponent + 1.0f));
    num c = 1.0f / sqrt_(1.0f + t2);
    num s = c * sqrt_(t2);
    vec3 axis = v3_sel(p.exponent > NUM(1e-30), reflect_about_normal(wo), v3(0.0f, 0.0f, 1.0f));
    return if_seen(wo, about(axis, s * cos2pi_(u.y), s * sin2pi_(u.y), c));
}

/* (exponent + 1)/(2 pi) c^exponent, 1/sr. */
FN num phong_pdf(phong_p p, vec3 wi, vec3 wo) {
    num d = (p.exponent + 1.0f) * (0.5f * INV_PI) * phong_lobe(p.exponent, wi, wo);
    return sel(lit(wi, wo), storable(d), 0.0f);
}

#endif
