/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
#ifndef ND_SHADE_BLINN_PHONG_H
#define ND_SHADE_BLINN_PHONG_H
#include "shade/sampling.h"

#define BLINN_PHONG_WORDS "lecture normalized normalized_exact"

#define BLINN_PHONG_PARAMS(P)                                                                      \
    P(RGB, color, 0.0, 1.0, 1.0, "1", "colour of the highlight: white for plastic")                \
    P(NUM, exponent, 0.0, 3.4028234663852886e38, 30.0, "1",                                        \
      "how small the highlight is, of the half vector: 20 satin, 120 plastic, 800 polished")       \
    P(CHOICE, variant, BLINN_PHONG_WORDS, lecture,                                                 \
      "lecture: the power takes the place of f cos; normalized: (exponent + 8)/(8 pi) times it; "  \
      "normalized_exact: the factor that reflects exactly 1 at NoV = 1")

#define BLINN_PHONG_KERNELS(K)                                                                     \
    K(blinn_phong, blinn_phong_lecture, 0)                                                         \
    K(blinn_phong, blinn_phong_normalized, ND_CLAIM_RECIPROCITY | ND_CLAIM_CONTINUITY)             \
    K(blinn_phong, blinn_phong_normalized_exact, ND_CLAIM_ALL)

#define BLINN_PHONG_MANUAL(M)                                                                      \
    M(WHAT, "A highlight by the half vector: a power of its cosine to the normal.")                \
    M(FORMULA, "c = n.h, h = (wi + wo)/|wi + wo|, g = exponent. lecture: brdf_cos = color c^g, "   \
               "brdf = brdf_cos/wi.z; normalized: brdf = color (g + 8)/(8 pi) c^g; "               \
               "normalized_exact: brdf = color (g + 2)(g + 4)/(8 pi (2^(-g/2) + g)) c^g.")         \
    M(WHEN, "Old assets and lectures. The angle to h is about half of Phong's angle to the "       \
            "mirror, so the same highlight needs four times phong's exponent (20 degrees off: "    \
            ".537 for phong 10, .542 here for 40, .858 for 10).")                                  \
    M(LIMITS, "Isotropic; no masking, no Fresnel. The lecture's form is not reciprocal.")          \
    M(ENERGY, "lecture reflects 5.416, 2.062, .246 of a white furnace at NoV = 1 for exponent 1, " \
              "10, 100; normalized 1.024, 1.075, 1.018, 1.002 for 1, 10, 100, 1000; "              \
              "normalized_exact 1 there and less elsewhere.")                                      \
    M(DEPARTURES, "The cosine is taken from the tangent of h, since near the normal a float "      \
                  "cosine is 1. S4 has no test of the horizon: wo = n and light at 100 degrees "   \
                  "give n.h = .643. (p + 2)/(2 pi) normalises the distribution of microfacets, "   \
                  "not this: microfacet(ndf=blinn).")                                              \
    M(SAMPLING,                                                                                    \
      "Half vectors by (g + 1)/(2 pi) c^g, pdf = that/(4 VoH); directions below the horizon "      \
      "are no sample.")                                                                            \
    M(SOURCE, "[Blinn77], [Akenine18]; formulas S4.24, S4.25, S4.41, S4.55")

STRUCT(blinn_phong_p) {
    BLINN_PHONG_PARAMS(FIELD)
};

/* (n.h)^exponent, exponent 0 gives 1. From tan^2 of the half vector: log of the cosine without
   the digits that 1 - c would lose. Source: [Blinn77]. */
FN num blinn_phong_lobe(num exponent, vec3 wi, vec3 wo) {
    vec3 h = halfway_of(wi, wo).h;
    return exp_(-0.5f * exponent * log1p_(sin2_theta(h) * inverse_square_z(h)));
}

/* The lecture's quantity over the cosine of wi, 1/sr; ..._cos is the quantity itself.
   Source: formulas S4.25. */
FN vec3 blinn_phong_lecture_brdf(blinn_phong_p p, vec3 wi, vec3 wo) {
    num f = blinn_phong_lobe(p.exponent, wi, wo) / max_(wi.z, SMALLEST);
    return gated(lit(wi, wo), v3_scale(p.color, f));
}
FN vec3 blinn_phong_lecture_brdf_cos(blinn_phong_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), v3_scale(p.color, blinn_phong_lobe(p.exponent, wi, wo)));
}

/* color (g + 8)/(8 pi) c^g, 1/sr. Source: [Akenine18], formulas S4.25. */
FN num blinn_phong_normalized_lobe(num exponent, vec3 wi, vec3 wo) {
    return (exponent + 8.0f) * (0.125f * INV_PI) * blinn_phong_lobe(exponent, wi, wo);
}
FN vec3 blinn_phong_normalized_brdf(blinn_phong_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), v3_scale(p.color, blinn_phong_normalized_lobe(p.exponent, wi, wo)));
}
FN vec3 blinn_phong_normalized_brdf_cos(blinn_phong_p p, vec3 wi, vec3 wo) {
    num f = blinn_phong_normalized_lobe(p.exponent, wi, wo) * wi.z;
    return gated(lit(wi, wo), v3_scale(p.color, f));
}

/* color (g + 2)(g + 4)/(8 pi (2^(-g/2) + g)) c^g, 1/sr; the quotient comes before the product, so
   that a huge exponent does not overflow. Adding 0 wi.z ties the factor to its lane: gcc 12 takes
   a uniform exponential out of the loop and then leaves the loop scalar.
   Source: formulas S4.25. */
FN num blinn_phong_exact_lobe(num exponent, vec3 wi, vec3 wo) {
    num half_exponent = 0.5f * exponent + 0.0f * wi.z;
    num power = exp_(-NUM(0.69314718055994530942) * half_exponent); /* 2^(-g/2) */
    num factor = (exponent + 2.0f) * ((exponent + 4.0f) / (power + exponent));
    return factor * (0.125f * INV_PI) * blinn_phong_lobe(exponent, wi, wo);
}
FN vec3 blinn_phong_normalized_exact_brdf(blinn_phong_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), v3_scale(p.color, blinn_phong_exact_lobe(p.exponent, wi, wo)));
}
FN vec3 blinn_phong_normalized_exact_brdf_cos(blinn_phong_p p, vec3 wi, vec3 wo) {
    num f = blinn_phong_exact_lobe(p.exponent, wi, wo) * wi.z;
    return gated(lit(wi, wo), v3_scale(p.color, f));
}

/* A half vector with density (g + 1)/(2 pi) NoH^g, which mirrors wo. What falls below the horizon
   is no sample. Source: [Ashikhmin00]. */
FN vec3 blinn_phong_sample(blinn_phong_p p, vec3 wo, vec3 u) {
    num t2 = tangent2_of_power(u.x, 1.0f / (p.exponent + 1.0f));
    return if_seen(wo, mirrored_at(wo, normal_at(t2, u)));
}

/* (g + 1)/(2 pi) NoH^g/(4 VoH), 1/sr. */
FN num blinn_phong_pdf(blinn_phong_p p, vec3 wi, vec3 wo) {
    num d = (p.exponent + 1.0f) * (0.125f * INV_PI) * blinn_phong_lobe(p.exponent, wi, wo);
    return sel(lit(wi, wo), storable(d / max_(halfway_of(wi, wo).cosine, SMALLEST)), 0.0f);
}

#endif
