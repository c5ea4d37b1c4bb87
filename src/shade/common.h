/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* Constants, the lit gate and the half vector: what every shading header shares. */
#ifndef ND_SHADE_COMMON_H
#define ND_SHADE_COMMON_H

#define PI NUM(3.14159265358979323846)
#define INV_PI NUM(0.31830988618379067154)
#define SQRT_PI NUM(1.77245385090551602730)
#define INV_SQRT_PI NUM(0.56418958354775628695)
#define SQRT_TWO_OVER_PI NUM(0.79788456080286535588)
#define LARGEST NUM(3.4028234663852885981e38) /* FLT_MAX: what overflows is this */
#define SMALLEST NUM(1.1754943508222875080e-38) /* keeps a denominator from being 0 */
#define ALPHA_FLOOR NUM(0.001) /* a perfectly smooth microfacet surface is not a function */

/* True where light arrives and the viewer sees it: both directions above the horizon.
   Outside, every value of every model is exactly 0. Source: formulas S4.11, S4.15, S4.39. */
FN cond lit(vec3 wi, vec3 wo) {
    return both(wi.z > 0.0f, wo.z > 0.0f);
}

/* x cut to [0, FLT_MAX]; 0 for NaN and for -0. */
FN num storable(num x) {
    return min_(max_(x, 0.0f), LARGEST);
}

/* The last step of every model: f where `on`, exactly 0 elsewhere, never NaN or negative, and
   FLT_MAX where f overflows. The gate moves the upper end, so that compilers keep it in vector
   registers. */
FN vec3 gated(cond on, vec3 f) {
    num most = sel(on, LARGEST, 0.0f);
    return v3(min_(max_(f.x, 0.0f), most), min_(max_(f.y, 0.0f), most),
              min_(max_(f.z, 0.0f), most));
}

/* sin^2 of the polar angle of a unit vector, from the tangent components: the 1 - z^2 of S1.1
   would cancel near the normal. */
FN num sin2_theta(vec3 w) {
    return w.x * w.x + w.y * w.y;
}

/* A quotient that is not divided yet, so that a product of terms needs one division in all. */
STRUCT(ratio) {
    num n;
    num d;
};

#endif
