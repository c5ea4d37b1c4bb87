/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* Normal distributions D(h), 1/sr: how much microsurface faces h, per area of the surface.
   All are normalised (the integral of D(h) h.z over the hemisphere is 1) and homogeneous in h:
   h need not be a unit vector. Each is a quotient that is not divided yet, D = n/d. */
#ifndef ND_SHADE_NDF_H
#define ND_SHADE_NDF_H
#include "shade/halfway.h"

#define NDF_WORDS "ggx beckmann blinn"
#define NDF_LIST(T) T(ggx) T(beckmann) T(blinn)

/* T(M, word, what, formula, notes, source); M is what T makes a section with. */
#define NDF_MANUAL(T, M)                                                                           \
    T(M, ggx, "GGX, also Trowbridge-Reitz: a sharp peak with a long tail; the default.",           \
      "D = 1 / (pi alpha_x alpha_y (hx^2/alpha_x^2 + hy^2/alpha_y^2 + hz^2)^2), h unit; "          \
      "isotropic: alpha^2 / (pi (hz^2 (alpha^2 - 1) + 1)^2)",                                      \
      "At one alpha its peak equals Beckmann's, 1/(pi alpha^2), and its half width is narrower "   \
      "(tan = .644 alpha against .833 alpha); only beyond tan = 1.585 alpha is it the higher "     \
      "one, so S2's 'broader but lower peak' (S2.12) does not hold. S4's max(NoH, 0) inside "      \
      "(S4.48) leaves alpha^2/pi below the horizon; here D is 0 outside the lit gate.",            \
      "[Walter07] eq. 33, [TrowbridgeReitz75], [Burley12]; S1.6, S1.7, S2.10, S2.11, S3.6, "       \
      "S3.7, S4.48")                                                                               \
    T(M, beckmann, "Beckmann-Spizzichino: a surface whose slopes are Gaussian; no tail.",          \
      "D = exp(-(hx^2/alpha_x^2 + hy^2/alpha_y^2) / hz^2) / (pi alpha_x alpha_y hz^4), h unit",    \
      "alpha is the root mean square of the slope; its mean is .886 alpha, where S4.46 says "      \
      "average.",                                                                                  \
      "[CookTorrance82], [Walter07] eq. 25; S1.4, S1.5, S3.5, S4.46, S4.47")                       \
    T(M, blinn, "Blinn's power of a cosine, normalised; isotropic, alpha <= 1.",                   \
      "D = NoH^(2/alpha^2 - 2) / (pi alpha^2) = (p + 2)/(2 pi) NoH^p with p = 2/alpha^2 - 2",      \
      "Close to Beckmann for small alpha. It has no Smith masking of its own: the documents take " \
      "Beckmann's, which gains energy (E = 1.32 at alpha = 1, NoV = .01). (p + 8)/(8 pi) is "      \
      "another normalisation, that of the BRDF without microfacets: blinn_phong.",                 \
      "[Blinn77], [Walter07], [Karis13b]; S3.4, S4.45")

/* 1 / (alpha_x alpha_y): hoisted out of a batch where the widths are uniform. */
FN num inverse_area(num alpha_x, num alpha_y) {
    return 1.0f / (alpha_x * alpha_y);
}

/* (h.x/alpha_x)^2 + (h.y/alpha_y)^2 by one shared reciprocal: x is the tangent's, y the bitangent's
   (S4.34, S4.35). */
FN num stretched2(num alpha_x, num alpha_y, num inverse, vec3 h) {
    num x = h.x * (alpha_y * inverse);
    num y = h.y * (alpha_x * inverse);
    return x * x + y * y;
}

/* GGX. Domain: alpha in [1e-3, 4]; hh = h.h > 0. Source: [Walter07] eq. 33, anisotropic as in
   [Burley12]; the tangent components keep the accuracy that 1 - hz^2 would lose. Formulas S1.6,
   S1.7, S2.10, S2.12, S3.2, S3.3, S3.6, S3.7, S4.48. */
FN ratio ndf_ggx(num alpha_x, num alpha_y, vec3 h, num hh) {
    num inverse = inverse_area(alpha_x, alpha_y);
    num q = stretched2(alpha_x, alpha_y, inverse, h) + h.z * h.z;
    ratio r;
    r.n = hh * hh * (INV_PI * inverse);
    r.d = q * q;
    return r;
}

/* Beckmann. Domain: as ndf_ggx. The order of the products keeps 0 * inf out: the exponential is
   0 long before hh / hz^2 is large. Source: [Walter07] eq. 25; formulas S1.4, S1.5, S2.12, S3.2,
   S3.3, S3.5, S4.46, S4.47. */
FN ratio ndf_beckmann(num alpha_x, num alpha_y, vec3 h, num hh) {
    num inverse = inverse_area(alpha_x, alpha_y);
    num z2 = inverse_square_z(h);
    num secant2 = hh * z2;
    num e = exp_(-(stretched2(alpha_x, alpha_y, inverse, h) * z2));
    ratio r;
    r.n = e * secant2 * secant2 * (INV_PI * inverse);
    r.d = 1.0f;
    return r;
}

/* ln(cos^2) of the angle between h and the normal, from the tangent: accurate near the normal,
   where the cosine rounds to 1. */
FN num log_cosine2(vec3 h) {
    return -log1p_(sin2_theta(h) * inverse_square_z(h));
}

/* Blinn. Domain: alpha in [1e-3, 1]. Source: [Karis13b], formulas S3.2, S3.3, S3.4, S4.45; the
   exponent 2/alpha^2 - 2 as 2 (1 - alpha)(1 + alpha)/alpha^2 does not cancel near alpha = 1. */
FN ratio ndf_blinn(num alpha, vec3 h) {
    num inverse = inverse_area(alpha, alpha);
    num exponent2 = (1.0f - alpha) * (1.0f + alpha) * inverse;
    ratio r;
    r.n = exp_(exponent2 * log_cosine2(h)) * (INV_PI * inverse);
    r.d = 1.0f;
    return r;
}

#endif
