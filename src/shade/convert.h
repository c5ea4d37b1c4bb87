/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* Conversions between the parameters that documents and programs use for one thing, each in one
   function. Values outside a domain give a finite number or FLT_MAX; ranges are checked before. */
#ifndef ND_SHADE_CONVERT_H
#define ND_SHADE_CONVERT_H
#include "shade/common.h"

#define ROUGHNESS_MAP_WORDS "square direct sqrt"
#define ANISOTROPY_WORDS "burley kulla openpbr gltf"

/* Widths along the tangent and the bitangent. */
STRUCT(widths) {
    num x;
    num y;
};

/* alpha = roughness^2: the default everywhere. Source: [Burley12], formulas S3.1. */
FN num alpha_from_roughness(num roughness) {
    return roughness * roughness;
}
FN num roughness_from_alpha(num alpha) {
    return sqrt_(alpha);
}

/* alpha = roughness: what document S2's code means (S2.11) and S4 does (S4.44). */
FN num alpha_from_roughness_direct(num roughness) {
    return roughness;
}
FN num roughness_from_alpha_direct(num alpha) {
    return alpha;
}

/* alpha = sqrt(roughness), as pbrt-v4 has it. Source: [Pharr23] 9.6. */
FN num alpha_from_roughness_sqrt(num roughness) {
    return sqrt_(roughness);
}
FN num roughness_from_alpha_sqrt(num alpha) {
    return alpha * alpha;
}

FN widths widths_of(num x, num y) {
    widths w;
    w.x = x;
    w.y = y;
    return w;
}

/* alpha/s and alpha s with s = sqrt(1 - 0.9 anisotropy); the product stays alpha^2.
   Domain: anisotropy in [0, 1], here and below; 0 gives alpha twice. Source: [Burley12]. */
FN widths widths_burley(num alpha, num anisotropy) {
    num s = sqrt_(1.0f - NUM(0.9) * anisotropy);
    return widths_of(alpha / s, alpha * s);
}

/* alpha (1 + anisotropy), alpha (1 - anisotropy). Source: [Kulla17]. */
FN widths widths_kulla(num alpha, num anisotropy) {
    return widths_of(alpha * (1.0f + anisotropy), alpha * (1.0f - anisotropy));
}

/* alpha s and alpha s (1 - anisotropy) with s = sqrt(2/(1 + (1 - anisotropy)^2)); the mean square
   stays alpha^2. Source: [OpenPBR24]. */
FN widths widths_openpbr(num alpha, num anisotropy) {
    num r = 1.0f - anisotropy;
    num x = alpha * sqrt_(2.0f / (1.0f + r * r));
    return widths_of(x, r * x);
}

/* lerp(alpha, 1, anisotropy^2) along the tangent, alpha along the bitangent.
   Source: [glTF], KHR_materials_anisotropy. */
FN widths widths_gltf(num alpha, num anisotropy) {
    num t = anisotropy * anisotropy;
    return widths_of(alpha * (1.0f - t) + t, alpha);
}

/* Width of the microfacet lobe NoH^p, alpha = sqrt(2/(p + 2)), and back, p = 2/alpha^2 - 2, which
   is negative for alpha > 1. Domain: p >= 0, alpha > 0. Source: [Walter07], formulas S3.4. */
FN num alpha_from_blinn_exponent(num exponent) {
    return sqrt_(2.0f / (exponent + 2.0f));
}
FN num blinn_exponent_from_alpha(num alpha) {
    return 2.0f * (1.0f - alpha) * (1.0f + alpha) / max_(alpha * alpha, SMALLEST);
}

/* The half vector moves half as far as the mirror, so Blinn's exponent that makes Phong's highlight
   is four times as large (20 degrees off: .537 for Phong 10, .542 for Blinn 40, .858 for Blinn 10).
   Source: formulas S4.24. */
FN num blinn_exponent_from_phong(num exponent) {
    return 4.0f * exponent;
}
FN num phong_exponent_from_blinn(num exponent) {
    return 0.25f * exponent;
}

/* Reflectance straight on between two dielectrics, ((n1 - n2)/(n1 + n2))^2: the square is of the
   whole fraction (S2.5). Domain: n1, n2 > 0. */
FN num f0_from_indices(num n1, num n2) {
    return sq_((n1 - n2) / (n1 + n2));
}
FN num f0_from_ior(num ior) {
    return f0_from_indices(ior, NUM(1.0));
}

/* (1 + sqrt f0)/(1 - sqrt f0), the larger of the two indices with this reflectance, written so
   that it keeps its digits near f0 = 1, where it is FLT_MAX. Source: formulas S3.20. */
FN num ior_from_f0(num f0) {
    return storable(sq_(1.0f + sqrt_(f0)) / max_(1.0f - f0, SMALLEST));
}

/* Oren and Nayar's A = 1 - s2/(2 (s2 + t)), s2 = sigma^2, with t = 0.33 or 0.57. */
FN num oren_nayar_a(num sigma2, num t) {
    return (0.5f * sigma2 + t) / (sigma2 + t);
}
/* sigma, radians, of A: sigma^2 = t (1 - A)/(A - 1/2). Domain: A in (0.5, 1]. */
FN num oren_nayar_sigma(num a, num t) {
    return sqrt_(t * (1.0f - a) / max_(a - 0.5f, SMALLEST));
}

/* The lecture's A, with 0.33. Source: formulas S4.29, S4.32. */
FN num a_from_sigma(num sigma) {
    return oren_nayar_a(sigma * sigma, NUM(0.33));
}
FN num sigma_from_a(num a) {
    return oren_nayar_sigma(a, NUM(0.33));
}

/* A of the variant that makes up for interreflection, with 0.57. Source: [OrenNayar94]. */
FN num a57_from_sigma(num sigma) {
    return oren_nayar_a(sigma * sigma, NUM(0.57));
}
FN num sigma_from_a57(num a57) {
    return oren_nayar_sigma(a57, NUM(0.57));
}

#endif
