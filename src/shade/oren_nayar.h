/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
#ifndef ND_SHADE_OREN_NAYAR_H
#define ND_SHADE_OREN_NAYAR_H
#include "shade/convert.h"
#include "shade/sampling.h"

#define OREN_NAYAR_WORDS "qualitative qualitative57 full table"

#define OREN_NAYAR_PARAMS(P)                                                                       \
    P(RGB, color, 0.0, 1.0, 0.8, "1",                                                              \
      "share of the light that each of the small facets reflects: 0.3 soil, 0.8 clay, plaster")    \
    P(ANGLE, sigma, 0.0, 1.57079632679489661923, 0.35,                                             \
      "standard deviation of the facets' slope angle: 0 lambert, 0.35 clay, sand, 0.7 very rough") \
    P(SPELL_ABOVE, a, 0.5, 1.0, 0.8646, oren_nayar_width, "1",                                     \
      "the lecture's A, share of lambert, instead of sigma: 1 smooth, 0.86 clay, 0.6 very rough")  \
    P(GROUP, oren_nayar_width)                                                                     \
    P(CHOICE, variant, OREN_NAYAR_WORDS, qualitative,                                              \
      "qualitative: the short form with 0.33; qualitative57: with 0.57, which makes up for "       \
      "interreflection; full: all terms of 1994; table: the lecture's, from a table")              \
    P(TABLE2, sines, "sin sin over (sqrt(1 - NoL), sqrt(1 - NoV)), for variant=table")

#define OREN_NAYAR_TRAITS (ND_CLAIM_RECIPROCITY | ND_CLAIM_CONTINUITY | ND_TRAIT_LECTURE_PI)
#define OREN_NAYAR_KERNELS(K)                                                                      \
    K(oren_nayar, oren_nayar_qualitative, OREN_NAYAR_TRAITS)                                       \
    K(oren_nayar, oren_nayar_qualitative57, OREN_NAYAR_TRAITS)                                     \
    K(oren_nayar, oren_nayar_full, OREN_NAYAR_TRAITS)                                              \
    K(oren_nayar, oren_nayar_table, OREN_NAYAR_TRAITS)

#define OREN_NAYAR_MANUAL(M)                                                                       \
    M(WHAT, "Rough matt surfaces: V-shaped grooves of Lambertian facets, brighter towards the "    \
            "light's own direction and flatter towards the edge than lambert.")                    \
    M(FORMULA, "s2 = sigma^2, B = .45 s2/(s2 + .09), a and b the larger and smaller polar angle, " \
               "dphi the azimuth between wi and wo. qualitative: f = color/pi (A + B max(0, cos "  \
               "dphi) sin a tan b), A = 1 - .5 s2/(s2 + .33); qualitative57: .57 for .33. "        \
               "full: f = color/pi (A + cos dphi C2 tan b + (1 - |cos dphi|) C3 tan((a + b)/2)) "  \
               "+ .17 color^2/pi s2/(s2 + .13) (1 - cos dphi (2 b/pi)^2), C2 = B sin a, less "     \
               "B (2 b/pi)^3 where cos dphi < 0, C3 = .125 s2/(s2 + .09) (4 a b/pi^2)^2. "         \
               "table: qualitative with sin a sin b from a bilinear table.")                       \
    M(WHEN, "Clay, plaster, sand, soil, cloth, the moon.")                                         \
    M(LIMITS, "No highlight. full is 0 where its formula is negative (rough surfaces, light and "  \
              "viewer grazing from opposite sides). table stays within 2e-4 of qualitative in "    \
              "f NoL.")                                                                            \
    M(ENERGY, "Gains a little at color 1: E at most 1.0152 for .33 (sigma .199), 1.0444 for .57 "  \
              "(sigma .289), 1.0510 for full (sigma .30), all at the horizon; rough ones lose. "   \
              "E at NoV 1 .5 .1 .01, sigma .1: qualitative .985 .999 1.006 1.008, qualitative57 "  \
              ".991 1.005 1.012 1.014, full .997 1.002 1.010 1.014; sigma .5: .785 .883 .939 "     \
              ".949, .848 .946 1.002 1.012, .896 .927 .991 1.020.")                                \
    M(DEPARTURES,                                                                                  \
      "S4 has the cosine inside and no 1/pi: pi times brdf_cos, which is --convention scanline. "  \
      "Its sigma is in radians: 20, meant as degrees, gives A .5004 and B .4499 where .8652 and "  \
      ".2588 are right. Its normalised projections are 0/0 at wi = n or wo = n; sin a tan b is 0 " \
      "there. Without angles the same is G sin a tan b = max(0, wi.x wo.x + wi.y wo.y)/max(NoL, "  \
      "NoV). Materials that give A have sigma^2 = .33 (1 - A)/(A - .5), and a means this A "       \
      "whatever the variant. The lecture's table f(p, q) = B sin a tan b is unbounded (331 at p "  \
      "= "                                                                                         \
      "q = .001, sigma .5); this one holds sin a sin b and is divided by max(p, q), and B stays "  \
      "outside, so that one table serves every sigma.")                                            \
    M(SAMPLING, "Directions by the cosine, pdf = NoL/pi.")                                         \
    M(SOURCE, "[OrenNayar94]; formulas S4.29 to S4.33")

STRUCT(oren_nayar_p) {
    OREN_NAYAR_PARAMS(FIELD)
};

/* Nodes along each axis of the table, and their content at x = sqrt(1 - NoL), y = sqrt(1 - NoV):
   sin a sin b, symmetric, in [0, 1]. Over the root of 1 - cos the sine is smooth; over the cosine
   itself its infinite slope at the normal would need 2500 nodes for the same error. */
#define OREN_NAYAR_TABLE_SIZE 32
FN num oren_nayar_sines(num x, num y) {
    return x * sqrt_(2.0f - x * x) * y * sqrt_(2.0f - y * y);
}

/* B = .45 s2/(s2 + .09), strength of the retroreflection, unitless. */
FN num oren_nayar_b(num sigma2) {
    return NUM(0.45) * sigma2 / (sigma2 + NUM(0.09));
}

/* color/pi (A gain + B s gain/max(NoL, NoV)): the value for gain = 1, the value times the cosine
   for gain = wi.z. s = max(0, cos dphi) sin sin. */
FN vec3 oren_nayar_value(oren_nayar_p p, vec3 wi, vec3 wo, num a, num s, num gain) {
    num b = oren_nayar_b(sq_(p.sigma));
    num f = a * gain + b * s * (gain / max_(max_(wi.z, wo.z), SMALLEST));
    return gated(lit(wi, wo), v3_scale(p.color, INV_PI * f));
}

/* max(0, cos dphi) sin sin, from the tangent components. */
FN num same_side(vec3 wi, vec3 wo) {
    return max_(wi.x * wo.x + wi.y * wo.y, 0.0f);
}

/* Reflected radiance per irradiance, 1/sr, without the cosine; ..._cos with it.
   Source: [OrenNayar94], formulas S4.29. */
FN vec3 oren_nayar_qualitative_brdf(oren_nayar_p p, vec3 wi, vec3 wo) {
    return oren_nayar_value(p, wi, wo, a_from_sigma(p.sigma), same_side(wi, wo), NUM(1.0));
}
FN vec3 oren_nayar_qualitative_brdf_cos(oren_nayar_p p, vec3 wi, vec3 wo) {
    return oren_nayar_value(p, wi, wo, a_from_sigma(p.sigma), same_side(wi, wo), wi.z);
}

/* The same with .57 for .33. Source: [OrenNayar94], note on the qualitative model. */
FN vec3 oren_nayar_qualitative57_brdf(oren_nayar_p p, vec3 wi, vec3 wo) {
    return oren_nayar_value(p, wi, wo, a57_from_sigma(p.sigma), same_side(wi, wo), NUM(1.0));
}
FN vec3 oren_nayar_qualitative57_brdf_cos(oren_nayar_p p, vec3 wi, vec3 wo) {
    return oren_nayar_value(p, wi, wo, a57_from_sigma(p.sigma), same_side(wi, wo), wi.z);
}

/* max(0, cos dphi) times the table's sin sin. Source: formulas S4.32. */
FN num same_side_table(table2 sines, vec3 wi, vec3 wo) {
    num x = sqrt_(max_(1.0f - wi.z, 0.0f));
    num y = sqrt_(max_(1.0f - wo.z, 0.0f));
    num exact = sqrt_(sin2_theta(wi) * sin2_theta(wo));
    num cosine = min_(same_side(wi, wo) / max_(exact, SMALLEST), 1.0f);
    return cosine * lut2(sines, x, y);
}
FN vec3 oren_nayar_table_brdf(oren_nayar_p p, vec3 wi, vec3 wo) {
    num s = same_side_table(p.sines, wi, wo);
    return oren_nayar_value(p, wi, wo, a_from_sigma(p.sigma), s, NUM(1.0));
}
FN vec3 oren_nayar_table_brdf_cos(oren_nayar_p p, vec3 wi, vec3 wo) {
    num s = same_side_table(p.sines, wi, wo);
    return oren_nayar_value(p, wi, wo, a_from_sigma(p.sigma), s, wi.z);
}

/* The angles of the full model. */
STRUCT(oren_nayar_angles) {
    num cos_phi;      /* cos dphi, in [-1, 1] */
    num sin2_phi;     /* sin^2 dphi */
    num sin_a;        /* of a, the larger polar angle */
    num sin_b;        /* of b, the smaller one */
    num cos_a;
    num cos_b;
    num turn_a;       /* 2 a/pi */
    num less_b;       /* 1 - 2 b/pi, in [0, 1] */
};

FN oren_nayar_angles oren_nayar_angles_of(vec3 wi, vec3 wo) {
    num si = sqrt_(sin2_theta(wi));
    num so = sqrt_(sin2_theta(wo));
    cond steeper = wi.z < wo.z; /* wi makes the larger angle */
    num inverse = 1.0f / max_(si * so, SMALLEST);
    oren_nayar_angles g;
    g.cos_phi = clamp_((wi.x * wo.x + wi.y * wo.y) * inverse, -1.0f, 1.0f);
    g.sin2_phi = min_(sq_((wi.x * wo.y - wi.y * wo.x) * inverse), 1.0f);
    g.sin_a = sel(steeper, si, so);
    g.sin_b = sel(steeper, so, si);
    g.cos_a = min_(wi.z, wo.z);
    g.cos_b = max_(wi.z, wo.z);
    g.turn_a = (2.0f * INV_PI) * atan2_(g.sin_a, g.cos_a);
    g.less_b = (2.0f * INV_PI) * atan2_(g.cos_b, g.sin_b);
    return g;
}

/* First bounce of the full model over color/pi, times gain. With w = 1 - 2 b/pi, the bracket of
   C2 where cos dphi < 0, sin a - (2 b/pi)^3, is w (3 - 3 w + w^2) - cos^2 a/(1 + sin a): at the
   horizon tan b multiplies it, and the printed difference would have no digits left there. For the
   same reason 1 - |cos dphi| is sin^2/(1 + |cos|). */
FN num oren_nayar_first(oren_nayar_angles g, num sigma2, num gain) {
    num w = g.less_b;
    num away = w * (3.0f - 3.0f * w + w * w) - g.cos_a * g.cos_a / (1.0f + g.sin_a);
    num c2 = oren_nayar_b(sigma2) * sel(g.cos_phi >= 0.0f, g.sin_a, away);
    num c3 = 0.125f * sigma2 / (sigma2 + NUM(0.09)) * sq_(g.turn_a * (1.0f - w));
    num tan_b = g.sin_b * (gain / max_(g.cos_b, SMALLEST));
    num tan_mean = (g.sin_a + g.sin_b) * (gain / max_(g.cos_a + g.cos_b, SMALLEST));
    num across = g.sin2_phi / (1.0f + abs_(g.cos_phi));
    num a = oren_nayar_a(sigma2, NUM(0.33));
    return a * gain + g.cos_phi * c2 * tan_b + across * c3 * tan_mean;
}

/* Light that meets two facets, over color^2/pi. Source: [OrenNayar94], interreflection. */
FN num oren_nayar_second(oren_nayar_angles g, num sigma2) {
    num c = NUM(0.17) * sigma2 / (sigma2 + NUM(0.13));
    return c * (1.0f - g.cos_phi * sq_(1.0f - g.less_b));
}

FN vec3 oren_nayar_full_value(oren_nayar_p p, vec3 wi, vec3 wo, num gain) {
    num sigma2 = sq_(p.sigma);
    oren_nayar_angles g = oren_nayar_angles_of(wi, wo);
    num one = INV_PI * oren_nayar_first(g, sigma2, gain);
    num two = INV_PI * gain * oren_nayar_second(g, sigma2);
    vec3 c = p.color;
    vec3 f = v3(c.x * (one + c.x * two), c.y * (one + c.y * two), c.z * (one + c.z * two));
    return gated(lit(wi, wo), f);
}

/* All terms of the 1994 model, 1/sr; 0 where their sum is negative. Source: [OrenNayar94]. */
FN vec3 oren_nayar_full_brdf(oren_nayar_p p, vec3 wi, vec3 wo) {
    return oren_nayar_full_value(p, wi, wo, NUM(1.0));
}
FN vec3 oren_nayar_full_brdf_cos(oren_nayar_p p, vec3 wi, vec3 wo) {
    return oren_nayar_full_value(p, wi, wo, wi.z);
}

/* The cosine's density: no sample is lost. */
FN vec3 oren_nayar_sample(oren_nayar_p p, vec3 wo, vec3 u) {
    return cosine_sample(wo, u);
}
FN num oren_nayar_pdf(oren_nayar_p p, vec3 wi, vec3 wo) {
    return cosine_pdf(wi, wo);
}

#endif
