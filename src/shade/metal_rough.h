/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
#ifndef ND_SHADE_METAL_ROUGH_H
#define ND_SHADE_METAL_ROUGH_H
#include "shade/microfacet.h"

#define METAL_ROUGH_PARAMS(P)                                                                      \
    P(RGB, base_color, 0.0, 1.0, 0.8, "1",                                                         \
      "colour of the diffuse part where it is no metal, of the highlight where it is one")         \
    P(NUM, metalness, 0.0, 1.0, 0.0, "1", "0 plastic, stone, wood; 1 metal; between: dirt, rust")  \
    P(HIDDEN, alpha_x, 0.25, "width along the tangent")                                            \
    P(HIDDEN, alpha_y, 0.25, "width along the bitangent")                                          \
    P(SPELL, roughness, 0.0, 1.0, 0.5, metal_width, "1",                                           \
      "perceptual width, alpha = roughness^2: 0.2 polished, 0.5 satin, 0.8 rough")                 \
    P(SPELL, anisotropy, 0.0, 1.0, 0.0, metal_width, "1",                                          \
      "how much the highlight is stretched along the tangent: 0 round, 0.9 brushed")               \
    P(GROUP, metal_width)                                                                          \
    P(NUM, dielectric_f0, 0.0, 1.0, 0.04, "1",                                                     \
      "reflectance straight on of what is no metal: 0.02 water, 0.04 plastic, 0.05 glass")

#define METAL_ROUGH_KERNELS(K)                                                                     \
    K(metal_rough, metal_rough, ND_CLAIM_RECIPROCITY | ND_CLAIM_CONTINUITY)

#define METAL_ROUGH_MANUAL(M)                                                                      \
    M(WHAT, "The material of game engines and glTF: a GGX highlight over a diffuse base, one "     \
            "slider between plastic and metal.")                                                   \
    M(FORMULA, "f = ggx(smith_correlated, schlick, f0, alpha = roughness^2) + "                    \
               "(1 - F(VoH)) (1 - metalness) base_color/pi, "                                      \
               "f0 = lerp(dielectric_f0, base_color, metalness)")                                  \
    M(WHEN, "Assets that come with base colour, metalness and roughness.")                         \
    M(LIMITS, "No clear coat, no sheen, no transmission.")                                         \
    M(ENERGY,                                                                                      \
      "Gains: the diffuse part loses only what the half vector's mirror reflects, so "             \
      "E = 1.28 at roughness .3, NoV .1, base_color 1, metalness 0. At the horizon 1.90 1.78 "     \
      "1.38 1.16 1.02 for roughness 0 .1 .3 .5 1 (1.94 with roughness 0, dielectric_f0 0).")       \
    M(DEPARTURES,                                                                                  \
      "S2 names k_d and k_s without defining them; k_s = F would square F (F = .07 "               \
      "counts .0049 at VoH .5). It mixes f0 by metalness in the text, by roughness in "            \
      "the code: dielectric .04, base .8, metalness 0, roughness .9 gives .724 there, "            \
      ".04 here. That a metal has no diffuse part is not said there but needed.")                  \
    M(SAMPLING,                                                                                    \
      "A visible normal of ggx or the cosine, with odds F(NoV) + 2^-10 to (1 - f0) (1 - "          \
      "metalness) base_color of the channels' mean; pdf is the mean of both by these odds.")       \
    M(SOURCE, "[Burley12], [Karis13], [glTF]; formulas S2.1, S2.3, S2.7, S2.8, S4.16")

STRUCT(metal_rough_p) {
    METAL_ROUGH_PARAMS(FIELD)
};

/* f0 = lerp(dielectric_f0, base_color, metalness), exact at both ends. */
FN vec3 metal_rough_f0(metal_rough_p p) {
    return v3_add(v3_scale(p.base_color, p.metalness),
                  v3_splat(p.dielectric_f0 * (1.0f - p.metalness)));
}

/* 1 - F of Schlick: (1 - f0)(1 - (1 - c)^5), the second as c (1 + m + m^2 + m^3 + m^4) with
   m = 1 - c, which keeps its digits at grazing angles. */
FN vec3 schlick_refracted(vec3 f0, num c) {
    num m = 1.0f - c;
    num w = c * (1.0f + m * (1.0f + m * (1.0f + m * (1.0f + m))));
    return v3((1.0f - f0.x) * w, (1.0f - f0.y) * w, (1.0f - f0.z) * w);
}

/* color F D V + (1 - F)(1 - metalness) base/pi, both times `cosine`, with n/d = V `cosine`. */
FN vec3 metal_rough_value(metal_rough_p p, cond on, halfway m, num n, num d, num cosine) {
    vec3 f0 = metal_rough_f0(p);
    ratio r = ndf_ggx(p.alpha_x, p.alpha_y, m.h, m.hh);
    num dv = storable(r.n * n / max_(r.d * d, SMALLEST));
    vec3 highlight = v3_scale(fresnel_schlick(f0, m.cosine), dv);
    vec3 refracted = v3_mul(p.base_color, schlick_refracted(f0, m.cosine));
    num share = INV_PI * (1.0f - p.metalness) * cosine;
    return gated(on, v3_add(highlight, v3_scale(refracted, share)));
}

/* Reflected radiance per irradiance, 1/sr, without the cosine. Source: contract of the glTF 2.0
   material [glTF] with alpha, Smith and Fresnel as the FORMULA section says. */
FN vec3 metal_rough_brdf(metal_rough_p p, vec3 wi, vec3 wo) {
    visibility v = masking_ggx_smith_correlated(p.alpha_x, p.alpha_y, wi, wo);
    return metal_rough_value(p, lit(wi, wo), halfway_of(wi, wo), v.n, v.d, NUM(1.0));
}

/* metal_rough_brdf times the cosine of wi, 1/sr. */
FN vec3 metal_rough_brdf_cos(metal_rough_p p, vec3 wi, vec3 wo) {
    visibility v = masking_ggx_smith_correlated(p.alpha_x, p.alpha_y, wi, wo);
    return metal_rough_value(p, lit(wi, wo), halfway_of(wi, wo), v.n_cos, v.d_cos, wi.z);
}

/* The factors of the highlight: D 1/sr, G and V unitless, F per channel; 0 outside the gate. */
FN num metal_rough_term_d(metal_rough_p p, vec3 wi, vec3 wo) {
    halfway m = halfway_of(wi, wo);
    ratio r = ndf_ggx(p.alpha_x, p.alpha_y, m.h, m.hh);
    return microfacet_term(lit(wi, wo), r.n, r.d);
}
FN num metal_rough_term_g(metal_rough_p p, vec3 wi, vec3 wo) {
    return masking_term(masking_ggx_smith_correlated(p.alpha_x, p.alpha_y, wi, wo), wi, wo);
}
FN num metal_rough_term_v(metal_rough_p p, vec3 wi, vec3 wo) {
    visibility v = masking_ggx_smith_correlated(p.alpha_x, p.alpha_y, wi, wo);
    return microfacet_term(lit(wi, wo), v.n, v.d);
}
FN vec3 metal_rough_term_f(metal_rough_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), fresnel_schlick(metal_rough_f0(p), halfway_of(wi, wo).cosine));
}

/* The odds n : d of the highlight against the diffuse part, by what either reflects about: F(NoV)
   and (1 - f0)(1 - metalness) base, of the channels' mean; the diffuse part loses F(VoH), which a
   grazing viewer hardly changes. The highlight keeps 2^-10 where its F is 0. */
FN ratio metal_rough_odds(metal_rough_p p, vec3 wo) {
    num base = NUM(0.33333333333333333333) * (p.base_color.x + p.base_color.y + p.base_color.z);
    num f0 = base * p.metalness + p.dielectric_f0 * (1.0f - p.metalness);
    num rest = max_(1.0f - f0, 0.0f);
    ratio r;
    r.n = f0 + rest * schlick_weight(clamp_(wo.z, 0.0f, 1.0f)) + 0.0009765625f;
    r.d = (1.0f - p.metalness) * base * rest;
    return r;
}

/* A visible normal of the highlight, or the diffuse part's cosine, by u.z. */
FN vec3 metal_rough_sample(metal_rough_p p, vec3 wo, vec3 u) {
    ratio r = metal_rough_odds(p, wo);
    vec3 highlight = ggx_visible_sample(p.alpha_x, p.alpha_y, wo, u);
    return v3_sel(u.z * (r.n + r.d) < r.n, highlight, cosine_sample(wo, u));
}

/* Both densities, each times its chance, 1/sr. */
FN num metal_rough_pdf(metal_rough_p p, vec3 wi, vec3 wo) {
    ratio r = metal_rough_odds(p, wo);
    num highlight = r.n * ggx_visible_pdf(p.alpha_x, p.alpha_y, wi, wo);
    return storable((highlight + r.d * cosine_pdf(wi, wo)) / (r.n + r.d));
}

#endif
