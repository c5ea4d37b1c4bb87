/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* Fresnel reflectance F(c), unitless, in [0, 1]; c = VoH = LoH, the cosine between the half
   vector and either direction, in [0, 1]. */
#ifndef ND_SHADE_FRESNEL_H
#define ND_SHADE_FRESNEL_H
#include "shade/common.h"

#define FRESNEL_WORDS "none schlick cook_torrance dielectric conductor"
#define FRESNEL_LIST(T) T(none) T(schlick) T(cook_torrance) T(dielectric) T(conductor)

#define FRESNEL_PARAMS(P)                                                                          \
    P(CHOICE, fresnel, FRESNEL_WORDS, schlick,                                                     \
      "which Fresnel term; conductor by itself with k or a metal preset, dielectric with ior")     \
    P(RGB, f0, 0.0, 1.0, 0.04, "1",                                                                \
      "reflectance straight on, for none, schlick and cook_torrance: 0.02 water, 0.04 plastic "    \
      "and glass, 0.17 diamond, 0.5 to 1 metals")                                                  \
    P(NUM_ABOVE, ior, 0.0, 1e4, 1.5, "1",                                                          \
      "n_t/n_i for dielectric: 1.33 water, 1.5 glass, 2.42 diamond; below 1 seen from inside, "    \
      "with total reflection")                                                                     \
    P(RGB_ABOVE, eta, 0.0, 1e4, 1.0, "1",                                                          \
      "real part of the index of refraction per channel, for conductor")                           \
    P(RGB, k, 0.0, 1e4, 1.0, "1",                                                                  \
      "extinction per channel, for conductor: 0 is the exact dielectric, 2 to 8 a metal")          \
    P(SPELL_WORD, preset, fresnel, "a metal (sets eta, k) or a dielectric (sets ior) by name")     \
    P(GROUP, fresnel)

/* T(M, word, what, formula, notes, source); M is what T makes a section with. */
#define FRESNEL_MANUAL(T, M)                                                                       \
    T(M, none, "The same reflectance at every angle.", "F = f0", "", "[Karis13b]; S3.18")          \
    T(M, schlick, "Schlick's approximation from f0; the default.", "F = f0 + (1 - f0)(1 - VoH)^5", \
      "Rises for every material; real metals dip first: aluminium (eta 1.49, k 7.82) has F0 = "    \
      ".9115 and its minimum .834 at VoH = .13, where Schlick is .12 too high (up to .19 for "     \
      "chromium, .024 for copper at 650 nm). The angle is the one to the half vector, not to the " \
      "normal as S2's text says (S2.6). f0 of two indices is ((n1 - n2)/(n1 + n2))^2 = .04 for 1 " \
      "and 1.5; S2.5 can be misread with the square on the denominator only, -.08. S2's code "     \
      "mixes f0 by roughness where its text says metalness (S2.8): dielectric .04, base .8, "      \
      "metalness 0, roughness .9 gives .724 instead of .04; not offered.",                         \
      "[Schlick94]; S2.4, S2.5, S2.9, S3.19, S4.49")                                               \
    T(M, cook_torrance, "Exact unpolarised Fresnel of the dielectric that has this f0.",           \
      "eta = (1 + sqrt f0)/(1 - sqrt f0), g^2 = eta^2 + VoH^2 - 1, c = VoH: "                      \
      "F = (1/2) ((g - c)/(g + c))^2 (1 + (((g + c) c - 1)/((g - c) c + 1))^2)",                   \
      "The printed form divides by 0 at f0 = 1, where F is 1, and is 0/0 at f0 = 0, c = 0, "       \
      "where F is 0. Meant for dielectrics: at f0 = .04 it stays within .036 of Schlick, at "      \
      "f0 = .95 they differ by up to .50.",                                                        \
      "[CookTorrance82]; S3.20")                                                                   \
    T(M, dielectric, "Exact unpolarised Fresnel of a dielectric, seen from either side.",          \
      "Rs = ((a - c)/(a + c))^2, Rp = Rs ((a c - s2)/(a c + s2))^2, F = (Rs + Rp)/2 with "         \
      "c = VoH, s2 = 1 - c^2, a = sqrt(ior^2 - s2); F = 1 where ior^2 <= s2",                      \
      "ior = 1 reflects nothing.", "[BornWolf99]; S3.20")                                          \
    T(M, conductor, "Exact unpolarised Fresnel of a conductor, per channel.",                      \
      "2 a^2 = sqrt(t^2 + 4 eta^2 k^2) + t, b = eta k/a with t = eta^2 - k^2 - s2; "               \
      "Rs = ((a - c)^2 + b^2)/((a + c)^2 + b^2), "                                                 \
      "Rp = Rs ((a c - s2)^2 + b^2 c^2)/((a c + s2)^2 + b^2 c^2), F = (Rs + Rp)/2",                \
      "The extended version that S4 leaves out (S4.50). Presets reproduce the colour that the "    \
      "measured spectrum has under D65, at normal incidence and at 82 degrees: averaged n and k "  \
      "would give another one (gold .990 .805 .358 instead of .999 .728 .365). Gold's red "        \
      "reflectance is above 1 there, 1.038, and is cut to .999.",                                  \
      "[BornWolf99]; S4.50")

/* (1 - c)^5, one factor for all channels. Domain: c in [0, 1]. Source: formulas S2.9. */
FN num schlick_weight(num c) {
    num m = 1.0f - c;
    num m2 = m * m;
    return m2 * m2 * m;
}

/* Schlick's reflectance. Domain: f0 in [0, 1]. Source: [Schlick94], formulas S2.4, S3.18, S3.19,
   S4.49. */
FN vec3 fresnel_schlick(vec3 f0, num c) {
    num w = schlick_weight(c);
    return v3(f0.x + (1.0f - f0.x) * w, f0.y + (1.0f - f0.y) * w, f0.z + (1.0f - f0.z) * w);
}

/* Both polarisations' mean, from e = (a - c)(a + c), sum = a + c and the two quotient parts
   n = a c - s2, d = a c + s2, by one division: ((e/sum^2)^2 (1 + (n/d)^2)) / 2.
   e = 0 (no boundary) gives 0; 0/0 for n/d counts as 1, which is f0 = 1 at the horizon. */
FN num unpolarised(num e, num sum, num n, num d) {
    num sum2 = sum * sum;
    num n2 = n * n + SMALLEST;
    num d2 = d * d + SMALLEST;
    num below = 2.0f * (sum2 * sum2) * d2;
    return min_(e * e * (d2 + n2) / max_(below, SMALLEST), 1.0f);
}

/* One channel of fresnel_cook_torrance. eta is never formed: with r = sqrt f0 and m = 1 - r,
   eta^2 - 1 = 4 r/m^2, so everything times m is finite up to f0 = 1. */
FN num cook_torrance_channel(num f0, num c) {
    num r = sqrt_(f0);
    num m = 1.0f - r;
    num g = sqrt_(4.0f * r + sq_(c * m));
    num s2 = (1.0f - c) * (1.0f + c);
    return unpolarised(4.0f * r, g + c * m, g * c - s2 * m, g * c + s2 * m);
}

/* Exact unpolarised reflectance of the dielectric whose normal reflectance is f0: f0 = 1 gives 1,
   f0 = 0 gives 0. Domain: f0 in [0, 1]. Source: [CookTorrance82], formulas S3.20. */
FN vec3 fresnel_cook_torrance(vec3 f0, num c) {
    return v3(cook_torrance_channel(f0.x, c), cook_torrance_channel(f0.y, c),
              cook_torrance_channel(f0.z, c));
}

/* Exact unpolarised reflectance of a dielectric, 1 beyond the critical angle.
   Domain: ior = n_t/n_i in (0, 1e4]. ior^2 - sin^2 is (ior - 1)(ior + 1) + c^2, which keeps its
   digits near ior = 1, but for small ior, where total reflection begins.
   Source: [BornWolf99]; equal to S3.20 for ior >= 1. */
FN vec3 fresnel_dielectric(num ior, num c) {
    num e = (ior - 1.0f) * (ior + 1.0f);
    num s2 = (1.0f - c) * (1.0f + c);
    num a2 = sel(ior < 0.5f, ior * ior - s2, e + c * c);
    num a = sqrt_(max_(a2, 0.0f));
    num f = unpolarised(e, a + c, a * c - s2, a * c + s2);
    return v3_splat(sel(a2 >= 0.0f, f, 1.0f));
}

/* One channel of fresnel_conductor. With a + ib the root of eta^2 - k^2 - s2 + 2i eta k, the larger
   of a^2 and b^2 is l2 = (q + |t|)/2, formed by adding, and the smaller is (eta k)^2/l2: neither
   cancels. Everything is taken times l2, so that u = l a and v = l b need no division. l2 is kept
   off 0, where a = b = 0 and all is reflected. eta^2 - s2 has two forms: one keeps its digits near
   eta = 1, where F vanishes, the other for small eta, where total reflection begins. */
FN num conductor_channel(num eta, num k, num c) {
    num s2 = (1.0f - c) * (1.0f + c);
    num t = sel(eta < 0.5f, eta * eta - s2, (eta - 1.0f) * (eta + 1.0f) + c * c) - k * k;
    num ek = eta * k;
    num q = sqrt_(t * t + 4.0f * (ek * ek));
    num l2 = max_(0.5f * (q + abs_(t)), NUM(1e-12));
    num l = sqrt_(l2);
    num u = sel(t >= 0.0f, l2, ek);
    num v = sel(t >= 0.0f, ek, l2);
    num v2 = v * v;
    num v2c2 = v2 * (c * c);
    num sn = sq_(u - c * l) + v2;
    num sd = sq_(u + c * l) + v2;
    num pn = sq_(u * c - s2 * l) + v2c2 + SMALLEST; /* 0/0 counts as 1: Rp = Rs where s2 = 0 */
    num pd = sq_(u * c + s2 * l) + v2c2 + SMALLEST;
    return min_(sn * (pd + pn) / max_(2.0f * sd * pd, SMALLEST), 1.0f);
}

/* Exact unpolarised reflectance of a conductor, per channel; k = 0 is the exact dielectric, total
   reflection included. Domain: eta in (0, 1e4], k in [0, 1e4]. Source: [BornWolf99], formulas S2.6,
   S4.50. */
FN vec3 fresnel_conductor(vec3 eta, vec3 k, num c) {
    return v3(conductor_channel(eta.x, k.x, c), conductor_channel(eta.y, k.y, c),
              conductor_channel(eta.z, k.z, c));
}

#endif
