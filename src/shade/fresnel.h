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

/* T(word, what, formula, notes, source) */
#define FRESNEL_MANUAL(T)                                                                          \
    T(none, "The same reflectance at every angle.", "F = f0", "", "[Karis13b]; S3.18")             \
    T(schlick, "Schlick's approximation from f0; the default.", "F = f0 + (1 - f0)(1 - VoH)^5",    \
      "Rises for every material; real metals dip first: aluminium at 650 nm has F0 = .9115 and "   \
      "its minimum .834 at VoH = .13, where Schlick is .124 too high (.193 for chromium, .022 "    \
      "for copper). The angle is the one to the half vector, not to the normal as S2's text says " \
      "(S2.6). f0 of two indices is ((n1 - n2)/(n1 + n2))^2 = .04 for 1 and 1.5; S2.5 can be "     \
      "misread with the square on the denominator only, -.08. S2's code mixes f0 by roughness "    \
      "where its text says metalness (S2.8): dielectric .04, base .8, metalness 0, roughness .9 "  \
      "gives .724 instead of .04; not offered.",                                                   \
      "[Schlick94]; S2.4, S2.5, S2.9, S3.19, S4.49")                                               \
    T(cook_torrance, "Exact unpolarised Fresnel of the dielectric that has this f0.",              \
      "eta = (1 + sqrt f0)/(1 - sqrt f0), g^2 = eta^2 + VoH^2 - 1, c = VoH: "                      \
      "F = (1/2) ((g - c)/(g + c))^2 (1 + (((g + c) c - 1)/((g - c) c + 1))^2)",                   \
      "The printed form divides by 0 at f0 = 1, where F is 1, and is 0/0 at f0 = 0, c = 0, "       \
      "where F is 0. Meant for dielectrics: at f0 = .04 it stays within .036 of Schlick, at "      \
      "f0 = .95 they differ by up to .49.",                                                        \
      "[CookTorrance82]; S3.20")                                                                   \
    T(dielectric, "Exact unpolarised Fresnel of a dielectric, seen from either side.",             \
      "Rs = ((a - c)/(a + c))^2, Rp = Rs ((a c - s2)/(a c + s2))^2, F = (Rs + Rp)/2 with "         \
      "c = VoH, s2 = 1 - c^2, a = sqrt(ior^2 - s2); F = 1 where ior^2 <= s2",                      \
      "ior = 1 reflects nothing.", "[BornWolf99]; S3.20")                                          \
    T(conductor, "Exact unpolarised Fresnel of a conductor, per channel.",                         \
      "2 a^2 = sqrt(t^2 + 4 eta^2 k^2) + t, b = eta k/a with t = eta^2 - k^2 - s2; "               \
      "Rs = ((a - c)^2 + b^2)/((a + c)^2 + b^2), "                                                 \
      "Rp = Rs ((a c - s2)^2 + b^2 c^2)/((a c + s2)^2 + b^2 c^2), F = (Rs + Rp)/2",                \
      "The extended version that S4 leaves out (S4.50). Presets reproduce the colour that the "    \
      "measured spectrum has under D65; gold's red reflectance comes out above 1 there and is "    \
      "cut to .999.",                                                                              \
      "[BornWolf99]; S4.50")

/* (1 - c)^5. Domain: c in [0, 1]. */
FN num schlick_weight(num c) {
    num m = 1.0f - c;
    num m2 = m * m;
    return m2 * m2 * m;
}

/* Schlick's reflectance. Domain: f0 in [0, 1]. Source: [Schlick94]. */
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
   digits near ior = 1. Source: [BornWolf99]; equal to S3.20 for ior >= 1. */
FN vec3 fresnel_dielectric(num ior, num c) {
    num e = (ior - 1.0f) * (ior + 1.0f);
    num a2 = e + c * c;
    num a = sqrt_(max_(a2, 0.0f));
    num s2 = (1.0f - c) * (1.0f + c);
    num f = unpolarised(e, a + c, a * c - s2, a * c + s2);
    return v3_splat(sel(a2 >= 0.0f, f, 1.0f));
}

/* One channel of fresnel_conductor. Of a^2 and b^2 the larger is formed by adding, the smaller
   from their product (eta k)^2: neither cancels. */
FN num conductor_channel(num eta, num k, num c) {
    num t = (eta - 1.0f) * (eta + 1.0f) - k * k + c * c;
    num ek2 = sq_(eta * k);
    num larger = 0.5f * (sqrt_(t * t + 4.0f * ek2) + abs_(t));
    num smaller = ek2 / max_(larger, SMALLEST);
    num a2 = sel(t >= 0.0f, larger, smaller);
    num b2 = sel(t >= 0.0f, smaller, larger);
    num a = sqrt_(a2);
    num s2 = (1.0f - c) * (1.0f + c);
    num b2c2 = b2 * c * c;
    num pn = sq_(a * c - s2) + b2c2 + SMALLEST; /* 0/0 counts as 1: Rp = Rs where a = s2 = 0 */
    num pd = sq_(a * c + s2) + b2c2 + SMALLEST;
    num rn = sq_(a - c) + b2;
    num rd = sq_(a + c) + b2;
    return min_(rn * (pd + pn) / max_(2.0f * rd * pd, SMALLEST), 1.0f);
}

/* Exact unpolarised reflectance of a conductor, per channel; k = 0 is the exact dielectric, total
   reflection included. Domain: eta in (0, 1e4], k in [0, 1e4]. Source: [BornWolf99]. */
FN vec3 fresnel_conductor(vec3 eta, vec3 k, num c) {
    return v3(conductor_channel(eta.x, k.x, c), conductor_channel(eta.y, k.y, c),
              conductor_channel(eta.z, k.z, c));
}

#endif
