/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* Masking-shadowing G(wi, wo), unitless, 0 to 1: the share of the microsurface that light and
   viewer both see. It is written as V = G/(4 NoL NoV), because the cosines cancel in most forms,
   and as V NoL, which stays finite where the light is at the horizon. NoL = wi.z, NoV = wo.z. */
#ifndef ND_SHADE_MASKING_H
#define ND_SHADE_MASKING_H
#include "shade/halfway.h"

#define MASKING_WORDS                                                                              \
    "none implicit neumann cook_torrance kelemen smith smith_correlated smith_walter "             \
    "schlick_beckmann schlick_ggx schlick_direct"
#define MASKING_LIST(T)                                                                            \
    T(none)                                                                                        \
    T(implicit)                                                                                    \
    T(neumann) T(cook_torrance) T(kelemen) T(smith) T(smith_correlated) T(smith_walter)            \
        T(schlick_beckmann) T(schlick_ggx) T(schlick_direct)

/* T(M, word, what, formula, notes, source); M is what T makes a section with. */
#define MASKING_MANUAL(T, M)                                                                       \
    T(M, none, "Nothing is hidden: S1's eq. (3) with Beckmann.", "G = 1",                          \
      "Gains energy without bound towards the horizon: E with GGX, F = 1 at NoV = .1 and .01 is "  \
      "1.16 and 5.51 (alpha .1), 2.90 and 25.4 (.5), 5.00 and 50.0 (1); at alpha = 1 exactly "     \
      "1/(2 NoV).",                                                                                \
      "S1.2, S1.13, S2.14")                                                                        \
    T(M, implicit, "The cosines themselves, so V = 1/4.", "G = NoL NoV",                           \
      "Ignores roughness and is far too dark: E with GGX, alpha .1 is .930 .258 .035 .020 at "     \
      "NoV = 1 .5 .1 .01.",                                                                        \
      "[Karis13b]; S3.8")                                                                          \
    T(M, neumann, "The smaller cosine.", "G = NoL NoV / max(NoL, NoV) = min(NoL, NoV)",            \
      "Dark: E with GGX, alpha .1 is .930 .443 .109 .055 at NoV = 1 .5 .1 .01. As G looks at no "  \
      "width, it gains for very wide ones: E at the horizon is alpha/2 with GGX, 2 at alpha 4, "   \
      "and 1.14 with Beckmann there; none up to alpha 2.",                                         \
      "[Neumann99]; S3.9")                                                                         \
    T(M, cook_torrance, "V-shaped grooves (Torrance and Sparrow; Blinn; Cook and Torrance).",      \
      "G = min(1, 2 NoH NoV / VoH, 2 NoH NoL / VoH)",                                              \
      "E <= 1. As printed it is negative for a light below the horizon (-.336 at NoL = -.1, "      \
      "NoV = .9); here everything is 0 there.",                                                    \
      "[CookTorrance82], [Blinn77]; S3.10, S4.51")                                                 \
    T(M, kelemen, "Kelemen and Szirmay-Kalos: V = 1/|wi + wo|^2.", "G = NoL NoV / VoH^2",          \
      "G <= 1 and E <= 1, whatever the roughness. Times Beckmann's D it is ward's default.",       \
      "[Kelemen01]; S3.11, S1.14")                                                                 \
    T(M, smith, "Smith, separable: light and viewer hidden independently.",                        \
      "G = G1(wi) G1(wo), G1 = 1/(1 + Lambda) of the ndf. GGX: G1(w) = 2 wz / (wz + l(w)), "       \
      "l^2 = alpha_x^2 wx^2 + alpha_y^2 wy^2 + wz^2. Beckmann, a = wz/(alpha sin): "               \
      "G1 = 2 / (1 + erf(a) + exp(-a^2)/(a sqrt(pi)))",                                            \
      "S3's 1/(G_V G_L) is exactly this V for GGX. Up to .090 below the correlated form, V up to " \
      "13 times (alpha .5, NoL = NoV = .01). With ndf=blinn, which takes Beckmann's Lambda, it "   \
      "gains energy: E = 1.060 (alpha .5, NoV .01), 1.137, 1.321 and 1.344 (alpha 1, NoV .1, .01 " \
      "and 0); off the exact masking of that ndf by up to .0015 .014 .040 .119 .219 at alpha .1 "  \
      ".3 .5 .8 1.",                                                                               \
      "[Smith67], [Walter07], [Heitz14]; S3.12, S3.14, S3.15, S3.21, S4.52")                       \
    T(M, smith_correlated,                                                                         \
      "Smith, height-correlated: what sticks out is seen by both; the default.",                   \
      "G = 1 / (1 + Lambda(wi) + Lambda(wo)); GGX: Lambda = (l(w)/wz - 1)/2, "                     \
      "V = 1 / (2 (wo.z l(wi) + wi.z l(wo))), l as in smith",                                      \
      "S1 prints the letters Lambda_L, Lambda_V twice: put into 1/(1 + L + V), the second pair "   \
      "gives .537 instead of .929 (NoL .5, NoV .8, alpha .3). With ndf=blinn E is 1.69 at alpha "  \
      "1, NoV .01, and 1.77 at the horizon.",                                                      \
      "[Heitz14] eq. 99; S1.8, S1.9, S1.10, S1.11, S1.12")                                         \
    T(M, smith_walter, "Walter's rational fit of Beckmann's G1, separable, whatever the ndf.",     \
      "c = wz/(alpha sin): G1 = (3.535 c + 2.181 c^2)/(1 + 2.276 c + 2.577 c^2) if c < 1.6, "      \
      "else 1; cut to 1",                                                                          \
      "Within .313 % of the exact form, whose value at 1.6 is .9982. The printed fit exceeds 1 "   \
      "from c = 1.548133 (at most 1.0000613, at 1.58884) and jumps by -5.7e-5 at 1.6; the cut "    \
      "makes it continuous. It is Beckmann's: with ndf=ggx, whose wide slopes it hides too "       \
      "little, E reaches 1.74 at the horizon (alpha .03; 1.34 at alpha 1), with ndf=blinn 1.34 "   \
      "(alpha 1).",                                                                                \
      "[Walter07]; S3.13")                                                                         \
    T(M, schlick_beckmann, "Schlick's rational form with his k.",                                  \
      "G1 = wz / (wz (1 - k) + k), k = alpha sqrt(2/pi)",                                          \
      "Approximates another function than Smith's: the slope at the horizon is 1.2533 instead of " \
      "3.5449, 2 sqrt(2) too dark; off by .44 (alpha .1) to .34 (1). A matched k is "              \
      "alpha/(2 sqrt(pi)).",                                                                       \
      "[Schlick94]; S3.16")                                                                        \
    T(M, schlick_ggx, "Schlick's rational form matched to GGX, for image-based light.",            \
      "G1 = wz / (wz (1 - k) + k), k = alpha/2",                                                   \
      "Exact at alpha = 1, else off by up to .161 (alpha .01), .109 (.25), .066 (.5).",            \
      "[Karis13]; S3.17, S2.18")                                                                   \
    T(M, schlick_direct, "Schlick's rational form with the k for direct light, S2's own.",         \
      "G1 = wz / (wz (1 - k) + k), k = (roughness + 1)^2 / 8",                                     \
      "roughness as given, or sqrt(alpha) if only alpha is known. k is never below 1/8, so a "     \
      "mirror loses light: G1(.1) = .47. With roughness_map=direct, where alpha is the roughness " \
      "itself, this is document S2; with the default map it is UE4. E(F = 1) at NoV 1 .5 .1, "     \
      "roughness .5: S2 .652 .582 .620; UE4 .860 .585 .360; smith_correlated .916 .857 .892.",     \
      "[Karis13]; S2.15, S2.16, S2.17, S2.18, S2.19")

/* Two quotients that are not divided yet: V = n/d in 1, and V NoL = n_cos/d_cos. */
STRUCT(visibility) {
    num n;
    num d;
    num n_cos;
    num d_cos;
};

/* n/d whose product with NoL is n NoL/d. */
FN visibility visibility_of(num n, num d, vec3 wi) {
    visibility v;
    v.n = n;
    v.d = d;
    v.n_cos = n * wi.z;
    v.d_cos = d;
    return v;
}

/* G = 1. Source: formulas S1.13, S2.14. */
FN visibility masking_none(vec3 wi, vec3 wo) {
    visibility v;
    v.n = 1.0f;
    v.d = 4.0f * wi.z * wo.z;
    v.n_cos = 1.0f;
    v.d_cos = 4.0f * wo.z;
    return v;
}

/* V = 1/4. Source: [Karis13b], formulas S3.8. */
FN visibility masking_implicit(vec3 wi) {
    return visibility_of(NUM(0.25), NUM(1.0), wi);
}

/* V = 1/(4 max(NoL, NoV)). Source: [Neumann99], formulas S3.9. */
FN visibility masking_neumann(vec3 wi, vec3 wo) {
    return visibility_of(NUM(1.0), 4.0f * max_(wi.z, wo.z), wi);
}

/* Grooves of V shape. In the unnormalised h: G = min(h.h, 4 h.z NoV, 4 h.z NoL)/h.h.
   Source: [CookTorrance82], formulas S3.10, S4.51, S4.56. */
FN visibility masking_cook_torrance(vec3 wi, vec3 wo, halfway m) {
    visibility v;
    v.n = min_(m.hh, 4.0f * (m.h.z * m.scale) * min_(wi.z, wo.z));
    v.d_cos = 4.0f * wo.z * m.hh;
    v.d = v.d_cos * wi.z;
    v.n_cos = v.n;
    return v;
}

/* V = 1/|wi + wo|^2. Source: [Kelemen01], formulas S3.11. */
FN visibility masking_kelemen(vec3 wi, halfway m) {
    return visibility_of(m.scale * m.scale, m.hh, wi);
}

/* l(w) = sqrt(alpha_x^2 wx^2 + alpha_y^2 wy^2 + wz^2), so that GGX's Lambda is (l/wz - 1)/2.
   Source: formulas S1.8, S1.10, S3.15. */
FN num ggx_length(num alpha_x, num alpha_y, vec3 w) {
    return sqrt_(sq_(alpha_x * w.x) + sq_(alpha_y * w.y) + w.z * w.z);
}

/* V = 1/((NoL + l(wi)) (NoV + l(wo))): the product that S3 gives as HLSL (S3.21).
   Source: formulas S3.12, S4.52. */
FN visibility masking_ggx_smith(num alpha_x, num alpha_y, vec3 wi, vec3 wo) {
    num gl = wi.z + ggx_length(alpha_x, alpha_y, wi);
    num gv = wo.z + ggx_length(alpha_x, alpha_y, wo);
    return visibility_of(NUM(1.0), gl * gv, wi);
}

/* V = 1/(2 (NoV l(wi) + NoL l(wo))). Source: [Heitz14] eq. 99, formulas S1.9, S1.11,
   S1.12. */
FN visibility masking_ggx_smith_correlated(num alpha_x, num alpha_y, vec3 wi, vec3 wo) {
    num gl = wo.z * ggx_length(alpha_x, alpha_y, wi);
    num gv = wi.z * ggx_length(alpha_x, alpha_y, wo);
    return visibility_of(NUM(0.5), gl + gv, wi);
}

/* alpha_x^2 wx^2 + alpha_y^2 wy^2, rooted: alpha times the sine of the polar angle, with the
   alpha that the surface has in the direction of w. */
FN num alpha_sine(num alpha_x, num alpha_y, vec3 w) {
    return sqrt_(sq_(alpha_x * w.x) + sq_(alpha_y * w.y));
}

/* Beckmann's wz (1 + Lambda(w)) = (wz (1 + erf(a)) + alpha sin exp(-a^2)/sqrt(pi))/2 with
   a = wz/(alpha sin): a sum of positive terms without a pole, neither at the horizon nor at the
   normal. a is cut at 10, where erf is 1 and the exponential is 0. Source: [Heitz14]. */
FN num beckmann_length(num alpha_x, num alpha_y, vec3 w) {
    num s = alpha_sine(alpha_x, alpha_y, w);
    num a = min_(w.z / max_(s, SMALLEST), 10.0f);
    return 0.5f * (w.z * (1.0f + erf_(a)) + INV_SQRT_PI * s * exp_(-(a * a)));
}

/* V = 1/(4 m(wi) m(wo)), m(w) = wz (1 + Lambda(w)). Source: [Walter07], formulas S3.12, S3.14. */
FN visibility masking_beckmann_smith(num alpha_x, num alpha_y, vec3 wi, vec3 wo) {
    num ml = beckmann_length(alpha_x, alpha_y, wi);
    num mv = beckmann_length(alpha_x, alpha_y, wo);
    return visibility_of(NUM(0.25), ml * mv, wi);
}

/* V = 1/(4 (NoV m(wi) + NoL m(wo) - NoL NoV)). Source: [Heitz14] eq. 99, formulas S1.9. */
FN visibility masking_beckmann_smith_correlated(num alpha_x, num alpha_y, vec3 wi, vec3 wo) {
    num ml = wo.z * beckmann_length(alpha_x, alpha_y, wi);
    num mv = wi.z * beckmann_length(alpha_x, alpha_y, wo);
    return visibility_of(NUM(0.25), ml + mv - wi.z * wo.z, wi);
}

/* G1(w)/wz of Walter's fit, not divided; beyond c = 1.5481 the fit would exceed 1 and G1 is 1.
   The limit is the smaller root of .396 c^2 - 1.259 c + 1. Source: [Walter07], formulas S3.13. */
FN ratio walter_masking(num alpha_x, num alpha_y, vec3 w) {
    num s = alpha_sine(alpha_x, alpha_y, w);
    cond fit = w.z < NUM(1.5481329712286783735) * s;
    ratio r;
    r.n = sel(fit, NUM(3.535) * s + NUM(2.181) * w.z, 1.0f);
    r.d = sel(fit, s * s + NUM(2.276) * s * w.z + NUM(2.577) * w.z * w.z, w.z);
    return r;
}

/* V of the separable product of Walter's G1. Source: formulas S3.13, S3.14. */
FN visibility masking_smith_walter(num alpha_x, num alpha_y, vec3 wi, vec3 wo) {
    ratio l = walter_masking(alpha_x, alpha_y, wi);
    ratio v = walter_masking(alpha_x, alpha_y, wo);
    return visibility_of(0.25f * l.n * v.n, l.d * v.d, wi);
}

/* The one alpha of an anisotropic surface in the direction of w, projected on it; alpha itself
   where alpha_x = alpha_y. At the normal, where no masking depends on it, 0. */
FN num projected_alpha(num alpha_x, num alpha_y, vec3 w) {
    num along2 = sq_(alpha_x * w.x) + sq_(alpha_y * w.y);
    return sel(alpha_x == alpha_y, alpha_x, sqrt_(along2 / max_(sin2_theta(w), SMALLEST)));
}

/* wz/G1(w) of Schlick's form: wz (1 - k) + k. Domain: k >= 0; it stays positive beyond 1.
   Source: formulas S2.15, S2.18. */
FN num schlick_length(num k, vec3 w) {
    return w.z + k * (1.0f - w.z);
}

/* V of Schlick's form with one k per direction: 1/(4 (NoL (1 - k) + k)(NoV (1 - k) + k)).
   Source: formulas S2.15, S2.18. */
FN visibility masking_schlick(num k_wi, num k_wo, vec3 wi, vec3 wo) {
    return visibility_of(NUM(0.25), schlick_length(k_wi, wi) * schlick_length(k_wo, wo), wi);
}

/* k = alpha sqrt(2/pi). Source: [Schlick94]; what it approximates: formulas S3.16. */
FN visibility masking_schlick_beckmann(num alpha_x, num alpha_y, vec3 wi, vec3 wo) {
    return masking_schlick(SQRT_TWO_OVER_PI * projected_alpha(alpha_x, alpha_y, wi),
                           SQRT_TWO_OVER_PI * projected_alpha(alpha_x, alpha_y, wo), wi, wo);
}

/* k = alpha/2. Source: [Karis13], formulas S3.17. */
FN visibility masking_schlick_ggx(num alpha_x, num alpha_y, vec3 wi, vec3 wo) {
    return masking_schlick(0.5f * projected_alpha(alpha_x, alpha_y, wi),
                           0.5f * projected_alpha(alpha_x, alpha_y, wo), wi, wo);
}

/* k = (roughness + 1)^2/8 of a direction: the given roughness where the surface is isotropic,
   else the root of the projected alpha. Source: formulas S2.16. */
FN num direct_k(num alpha_x, num alpha_y, num direct_roughness, vec3 w) {
    num projected = sqrt_(projected_alpha(alpha_x, alpha_y, w));
    return 0.125f * sq_(sel(alpha_x == alpha_y, direct_roughness, projected) + 1.0f);
}

/* k = (roughness + 1)^2/8. Source: [Karis13], formulas S2.16, S2.17, S2.19. */
FN visibility masking_schlick_direct(num alpha_x, num alpha_y, num direct_roughness, vec3 wi,
                                     vec3 wo) {
    return masking_schlick(direct_k(alpha_x, alpha_y, direct_roughness, wi),
                           direct_k(alpha_x, alpha_y, direct_roughness, wo), wi, wo);
}

#endif
