/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* Drawing the normals that the viewer sees, with density D(h) max(0, wo.h) G1(wo)/NoV, and the
   density of wi, that divided by 4 VoH: D G1(wo)/(4 NoV). Both distributions are one shape
   stretched by alpha_x, alpha_y: wo is stretched to unit widths, a normal drawn there and
   stretched back. */
#ifndef ND_SHADE_VISIBLE_NORMALS_H
#define ND_SHADE_VISIBLE_NORMALS_H
#include "shade/masking.h"
#include "shade/ndf.h"
#include "shade/sampling.h"

/* wo in the space where the widths are 1. */
FN vec3 stretched_view(num alpha_x, num alpha_y, vec3 wo) {
    return v3_unit(v3(alpha_x * wo.x, alpha_y * wo.y, wo.z));
}

/* The share k, in [0, 1], of the cap below the horizon whose normals may mirror wo to above the
   surface, not divided yet: k = n/d. k = 1 would be all visible normals; below it, fewer samples
   are lost under the surface. Source: [Tokuyoshi23]. */
FN ratio ggx_cap_share(num alpha_x, num alpha_y, vec3 wo) {
    num a = min_(min_(alpha_x, alpha_y), 1.0f);
    num s = sq_(1.0f + sqrt_(sin2_theta(wo)));
    ratio k;
    k.n = (1.0f - a) * (1.0f + a) * s;
    k.d = s + sq_(a * wo.z);
    return k;
}

/* A visible normal of GGX for wo: the normal of a sphere's cap, halfway between wo and the
   direction in which the sphere mirrors it. With t = (1 - u)(cap height), sin^2 = t (2 - t)
   does not cancel. Domain: wo above the horizon. Source: [Dupuy23], bounded by [Tokuyoshi23]. */
FN vec3 ggx_visible_normal(num alpha_x, num alpha_y, vec3 wo, vec3 u) {
    vec3 s = stretched_view(alpha_x, alpha_y, wo);
    ratio k = ggx_cap_share(alpha_x, alpha_y, wo);
    num t = u.x * (1.0f + s.z * (k.n / k.d));
    num r = sqrt_(t * (2.0f - t));
    num x = alpha_x * (r * cos2pi_(u.y) + s.x);
    num y = alpha_y * (r * sin2pi_(u.y) + s.y);
    return v3_unit(v3(x, y, max_((1.0f - t) + s.z, 0.0f)));
}
FN vec3 ggx_visible_sample(num alpha_x, num alpha_y, vec3 wo, vec3 u) {
    return if_seen(wo, mirrored_at(wo, ggx_visible_normal(alpha_x, alpha_y, wo, u)));
}

/* D/(2 (k NoV + l(wo))), 1/sr; with k = 1 it would be D G1(wo)/(4 NoV).
   Source: [Tokuyoshi23]. */
FN num ggx_visible_pdf(num alpha_x, num alpha_y, vec3 wi, vec3 wo) {
    halfway m = halfway_of(wi, wo);
    ratio d = ndf_ggx(alpha_x, alpha_y, m.h, m.hh);
    ratio k = ggx_cap_share(alpha_x, alpha_y, wo);
    num cap = 2.0f * (k.n * wo.z + k.d * ggx_length(alpha_x, alpha_y, wo));
    num p = d.n * k.d / max_(d.d * cap, SMALLEST);
    return sel(lit(wi, wo), storable(p), 0.0f);
}

/* One step of Halley's method towards the b = erf(x) at which the share of visible slopes below x,
       c (1 + b) + s e^(-x^2)/sqrt(pi),   c, s: cosine and sine of the stretched wo,
   reaches `aim`. Its slope in b is c - s x, the slope of that -s dx/db, dx/db = sqrt(pi)/2 e^(x^2).
   The floors keep a step finite where the slope vanishes, at the last visible x. */
FN num beckmann_slope_step(num b, num c, num s, num aim, num last) {
    num x = erfinv_(b);
    num e = exp_(-(x * x));
    num rise = max_(c - s * x, NUM(1e-6));
    num newton = (c * (1.0f + b) + INV_SQRT_PI * s * e - aim) / rise;
    num bend = 0.25f * SQRT_PI * s / (max_(e, NUM(1e-12)) * rise);
    num next = b - newton / max_(1.0f + newton * bend, 0.5f);
    return clamp_(next, NUM(-0.9999999), last);
}

/* The slope, along wo, of a normal of the surface of unit width that wo sees; c, s: its cosine and
   sine. The start is between the ends by a blend of 1 - u and its root, fitted.
   Accuracy: 1e-6 in the distribution function, at every c and u (tests/sampling/test_slopes.c).
   Source: [HeitzDEon14]; inversion in erf: [Jakob14]. */
FN num beckmann_visible_slope(num c, num s, num u) {
    num a = min_(c / max_(s, SMALLEST), 10.0f);
    num last = erf_(a);
    num aim = u * (c * (1.0f + last) + INV_SQRT_PI * s * exp_(-(a * a)));
    num root = sqrt_(1.0f - u);
    num blend = 1.0f - s * (1.75f - NUM(0.642) * s);
    num start = last - (1.0f + last) * (root * (1.0f - blend + blend * root));
    num first = beckmann_slope_step(clamp_(start, NUM(-0.9999999), last), c, s, aim, last);
    return erfinv_(beckmann_slope_step(first, c, s, aim, last));
}

/* A visible normal of Beckmann for wo. The slope across wo is Gaussian. */
FN vec3 beckmann_visible_normal(num alpha_x, num alpha_y, vec3 wo, vec3 u) {
    vec3 w = stretched_view(alpha_x, alpha_y, wo);
    num s = sqrt_(sin2_theta(w));
    num inverse = 1.0f / max_(s, SMALLEST);
    num cos_phi = sel(s > 0.0f, w.x * inverse, 1.0f);
    num sin_phi = w.y * inverse;
    num x = beckmann_visible_slope(w.z, s, u.x);
    num y = erfinv_(2.0f * u.y - 1.0f);
    return normal_of_slopes(-alpha_x * (cos_phi * x - sin_phi * y),
                            -alpha_y * (sin_phi * x + cos_phi * y));
}
FN vec3 beckmann_visible_sample(num alpha_x, num alpha_y, vec3 wo, vec3 u) {
    return if_seen(wo, mirrored_at(wo, beckmann_visible_normal(alpha_x, alpha_y, wo, u)));
}

/* D G1(wo)/(4 NoV) = D/(4 NoV (1 + Lambda(wo))), 1/sr. Source: [Heitz14]. */
FN num beckmann_visible_pdf(num alpha_x, num alpha_y, vec3 wi, vec3 wo) {
    halfway m = halfway_of(wi, wo);
    ratio d = ndf_beckmann(alpha_x, alpha_y, m.h, m.hh);
    num p = 0.25f * d.n / max_(d.d * beckmann_length(alpha_x, alpha_y, wo), SMALLEST);
    return sel(lit(wi, wo), storable(p), 0.0f);
}

#endif
