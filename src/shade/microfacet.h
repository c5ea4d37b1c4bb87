/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
#ifndef ND_SHADE_MICROFACET_H
#define ND_SHADE_MICROFACET_H
#include "shade/convert.h"
#include "shade/fresnel.h"
#include "shade/masking.h"
#include "shade/ndf.h"
#include "shade/visible_normals.h"

#define MICROFACET_WIDTH_PARAMS(P)                                                                 \
    P(NUM, alpha_x, 0.0, 4.0, 0.3, "1",                                                            \
      "width along the tangent: 0.05 polished, 0.3 satin, 0.5 matt; below 0.001 acts as 0.001")    \
    P(NUM, alpha_y, 0.0, 4.0, 0.3, "1",                                                            \
      "width along the bitangent; grooves along the tangent have alpha_x < alpha_y, and the "      \
      "highlight stretches across them")                                                           \
    P(HIDDEN, direct_roughness, 0.54772255750516611346,                                            \
      "roughness as given, or sqrt(alpha): what masking=schlick_direct uses")                      \
    P(SPELL, alpha, 0.0, 4.0, 0.3, width, "1", "both widths at once")                              \
    P(SPELL, roughness, 0.0, 1.0, 0.5, width, "1",                                                 \
      "perceptual width, alpha = roughness^2 by default: 0.2 polished, 0.5 satin, 0.8 rough")      \
    P(SPELL, anisotropy, 0.0, 1.0, 0.0, width, "1",                                                \
      "how much alpha or roughness is stretched along the tangent: 0 round, 0.9 brushed")          \
    P(SPELL_CHOICE, anisotropy_kind, ANISOTROPY_WORDS, burley, width,                              \
      "how anisotropy turns alpha into alpha_x, alpha_y")                                          \
    P(SPELL_CHOICE, roughness_map, ROUGHNESS_MAP_WORDS, square, width,                             \
      "alpha of roughness: its square, itself (document S2), its root (pbrt)")                     \
    P(GROUP, width)

#define MICROFACET_PARAMS(P)                                                                       \
    P(CHOICE, ndf, NDF_WORDS, ggx,                                                                 \
      "distribution of the microsurface's normals: ggx has a long tail, beckmann none, blinn is "  \
      "a power of a cosine (alpha <= 1, isotropic)")                                               \
    MICROFACET_SHORT_PARAMS(P)

/* The keys of the short names, whose ndf is fixed. */
#define MICROFACET_SHORT_PARAMS(P)                                                                 \
    P(CHOICE, masking, MASKING_WORDS, smith_correlated,                                            \
      "share of the microsurface that light and viewer both see")                                  \
    MICROFACET_WIDTH_PARAMS(P)                                                                     \
    FRESNEL_PARAMS(P)                                                                              \
    P(RGB, color, 0.0, 1.0, 1.0, "1",                                                              \
      "multiplies the value; leave it white where f0 or eta carry the colour already")

/* A term's part of the manual, as sections that are named like the choice, "masking=smith". */
#define NDF_SECTION(M, word, what, formula, notes, source)                                         \
    M(ndf=word, what " " formula ". " notes " Source: " source ".")
#define MASKING_SECTION(M, word, what, formula, notes, source)                                     \
    M(masking=word, what " " formula ". " notes " Source: " source ".")
#define FRESNEL_SECTION(M, word, what, formula, notes, source)                                     \
    M(fresnel=word, what " " formula ". " notes " Source: " source ".")

#define MICROFACET_MANUAL(M)                                                                       \
    M(WHAT, "A rough surface of tiny mirrors: the share D of them that faces the half vector, "    \
            "the share G that is not hidden, and their Fresnel reflectance F.")                    \
    M(FORMULA, "f = color F D G / (4 NoL NoV) = color F D V, V = G/(4 NoL NoV), h = (wi + wo) / "  \
               "|wi + wo|, NoL = wi.z, NoV = wo.z, VoH = wo.h = |wi + wo|/2. The 4 is inside V.")  \
    M(WHEN, "Metals, plastic, varnish, glass seen from outside: everything with a highlight. "     \
            "ggx and beckmann are its short names.")                                               \
    M(LIMITS, "Single scattering: light that leaves after a second bounce is missing, so rough "   \
              "surfaces lose energy (E of GGX at alpha 1, F = 1, NoV 1 is 1 - ln 2 = .307). "      \
              "Reflection only; nothing below alpha = 0.001.")                                     \
    M(ENERGY, "E <= 1 but for these: masking=none gains without bound towards the horizon (GGX, "  \
              "alpha .5, F = 1: 2.90 at NoV .1, 25.4 at .01); ndf=blinn gains with smith, "        \
              "smith_correlated and smith_walter at wide alpha (1.32, 1.69, 1.32 at alpha 1, NoV " \
              ".01; 1.34, 1.77, 1.34 at the horizon); ndf=ggx with smith_walter (up to 1.74 at "   \
              "the horizon, alpha .03); neumann beyond alpha 2 (alpha/2 at the horizon with GGX, " \
              "at most 1.14 with Beckmann, at alpha 4). "                                          \
              "E with GGX, smith_correlated, F = 1 at NoV 1 .5 .1 .01: alpha .1 .988 .969 .884 "   \
              ".977; .5 .688 .698 .860 .974; 1 .307 .451 .760 .954.")                              \
    M(DEPARTURES,                                                                                  \
      "alpha is the width itself. S2's code takes alpha = roughness (roughness_map=direct), S3 "   \
      "and UE4 alpha = roughness^2 (square, the default), pbrt its root (sqrt): at .5 the peak "   \
      "D(n) is 1.273 for alpha = .5 and 5.093 for .25. S2's model is roughness_map=direct, "       \
      "masking=schlick_direct. S4 has the cosine inside and no 1/pi on its diffuse part (trap of " \
      "its k blend: E 2.057 with k .5, Beckmann, cook_torrance, rho .3, NoV .8, where m_D/pi "     \
      "gives .986); its blend is the sum 0.5*lambert(...) + 0.5*microfacet(...), and S4 divides "  \
      "by 4 where Cook and Torrance 1982 had pi. S4's m_S times a coloured f0 tints twice (.78^2 " \
      "= .61). S3.2's normalisation is over the microfacet's solid angle, not the light's: with "  \
      "the latter 3.898, 3.445, 2.624 for alpha .1 .3 .6. No document tests the horizon: printed " \
      "as they are, S3's product gives V = 2025 at NoL -.1, NoV .5, alpha .01 where 100 is the "   \
      "largest legal value. Highlights stretch across the grooves, not along them (S4.34): "       \
      "alpha_x .05, alpha_y .5, wo = n, light 10 degrees off give .15 along t, 3.11 along b "      \
      "(ward92). The term f in [0, 1] of S4.2 holds for no real BRDF: D(n) is 31.8 at alpha .1; "  \
      "values are never clamped. S4 names three parameters F0, m, k (S4.53): m is its rho, the "   \
      "alpha here, and k the weight of the blend (S4.1).")                                         \
    M(SAMPLING,                                                                                    \
      "ggx: visible normals in the bounded cap [Tokuyoshi23], pdf = D/(2 (k NoV + l(wo))) with "   \
      "l^2 = alpha_x^2 wx^2 + alpha_y^2 wy^2 + wz^2, k = (1 - a^2) s^2/(s^2 + a^2 NoV^2), a = "    \
      "min(alpha_x, alpha_y, 1), s = 1 + sqrt(1 - NoV^2); k = 1 would be D G1(wo)/(4 NoV), "       \
      "which it exceeds because fewer samples are lost. beckmann: visible normals, pdf = "         \
      "D G1(wo)/(4 NoV). blinn: all normals, pdf = D NoH/(4 VoH). Directions below the "           \
      "horizon are no sample.")                                                                    \
    M(SOURCE, "[CookTorrance82], [Walter07], [Heitz14]; formulas S1.2, S1.3, S1.15, S2.1, S2.2, "  \
              "S3.1 to S3.3, S3.22, S3.23, S4.1, S4.2, S4.42, S4.43, S4.53; every term has its "   \
              "own rows")                                                                          \
    NDF_MANUAL(NDF_SECTION, M)                                                                     \
    MASKING_MANUAL(MASKING_SECTION, M)                                                             \
    FRESNEL_MANUAL(FRESNEL_SECTION, M)

STRUCT(microfacet_p) {
    MICROFACET_PARAMS(FIELD)
};

/* The last step of a microfacet value: color F n/d, with the one division of the whole formula;
   n/d = D V, or D V NoL for the cosine's form. */
FN vec3 microfacet_value(cond on, vec3 color, vec3 f, num n, num d) {
    return gated(on, v3_mul(color, v3_scale(f, n / max_(d, SMALLEST))));
}

/* One term by itself, n/d: 0 outside the gate, FLT_MAX where it overflows. */
FN num microfacet_term(cond on, num n, num d) {
    return sel(on, storable(n / max_(d, SMALLEST)), 0.0f);
}

/* G = (V NoL) (4 NoV), unitless: 0 outside the gate, at most 1. */
FN num masking_term(visibility v, vec3 wi, vec3 wo) {
    return min_(microfacet_term(lit(wi, wo), 4.0f * wo.z * v.n_cos, v.d_cos), 1.0f);
}

/* The sampler of each ndf, whatever the masking and the Fresnel term: visible normals of ggx, in
   the bounded cap, and of beckmann. Directions below the horizon are no sample. */
FN vec3 microfacet_ggx_sample(microfacet_p p, vec3 wo, vec3 u) {
    return ggx_visible_sample(p.alpha_x, p.alpha_y, wo, u);
}
FN num microfacet_ggx_pdf(microfacet_p p, vec3 wi, vec3 wo) {
    return ggx_visible_pdf(p.alpha_x, p.alpha_y, wi, wo);
}
FN vec3 microfacet_beckmann_sample(microfacet_p p, vec3 wo, vec3 u) {
    return beckmann_visible_sample(p.alpha_x, p.alpha_y, wo, u);
}
FN num microfacet_beckmann_pdf(microfacet_p p, vec3 wi, vec3 wo) {
    return beckmann_visible_pdf(p.alpha_x, p.alpha_y, wi, wo);
}

/* Blinn has no Smith masking that fits it, so all its normals are drawn: NoH = (1 - u)^(alpha^2/2),
   density D NoH. Source: [Walter07]. */
FN vec3 microfacet_blinn_sample(microfacet_p p, vec3 wo, vec3 u) {
    num t2 = tangent2_of_power(u.x, 0.5f * p.alpha_x * p.alpha_x);
    return if_seen(wo, mirrored_at(wo, normal_at(t2, u)));
}
FN num microfacet_blinn_pdf(microfacet_p p, vec3 wi, vec3 wo) {
    halfway m = halfway_of(wi, wo);
    return half_vector_pdf(m, ndf_blinn(p.alpha_x, m.h), wi, wo);
}

#endif
