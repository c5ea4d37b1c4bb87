/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* Elementary functions of the shading text. In C float they are branch-free polynomials on
   correctly rounded + - * / sqrt, so they vectorise and give the same bits everywhere; with
   ND_WIDE the prelude has libm's double functions instead; a shader target (ND_NATIVE) has its own
   exp and log and shares the rest of the text, because its own asin, sin or log near 1 are too
   coarse. Coefficients: relative minimax fits, made by tools/math/fit.py.
   Errors are in units of the last place of the float result, over every float of the range; found
   by tests/shade/test_math.c, pow_ and atan2_ at 2 million random pairs. A NaN argument gives some
   number or NaN. */
#ifndef ND_SHADE_MATH_H
#define ND_SHADE_MATH_H
#ifndef ND_PRELUDE
#include "shade/prelude_c.h"
#endif

/* x^2. */
FN num sq_(num x) {
    return x * x;
}

/* a (1 - t) + b t: exactly a at 0 and b at 1. */
FN num lerp_(num a, num b, num t) {
    return a * (1.0f - t) + b * t;
}
FN vec3 v3_lerp(vec3 a, vec3 b, num t) {
    return v3_add(v3_scale(a, 1.0f - t), v3_scale(b, t));
}

/* v/|v|. Domain: |v| in [1e-18, 1e18]; zero stays zero. */
FN vec3 v3_unit(vec3 v) {
    return v3_scale(v, 1.0f / sqrt_(max_(v3_dot(v, v), NUM(1.0e-37))));
}

#ifndef ND_WIDE
/* log(1 + f) for f in [-0.293, 0.4143], 1 ulp there, also next to 0. */
FN num log1p_core_(num f) {
    num q = NUM(0.128816515) + f * NUM(-0.0785961747);
    num p = NUM(0.141811922) + f * (NUM(-0.131287545) + f * q);
    num r = NUM(0.200022861) + f * (NUM(-0.166245535) + f * p);
    num s = NUM(0.333333164) + f * (NUM(-0.250008106) + f * r);
    return f - f * f * (0.5f - f * s);
}

#ifdef ND_NATIVE
FN num exp_(num x) {
    return native_exp(min_(x, 88.71875f));
}
FN num log_(num x) {
    num f = x - 1.0f;
    num wide = native_log(max_(x, NUM(1.17549435e-38)));
    return sel(both(f > -0.25f, f < 0.375f), log1p_core_(f), wide);
}
#else
/* e^x.
   Domain:   every x; 0 below -69.3147 (2^-100), FLT_MAX from log(FLT_MAX) on.
   Accuracy: 1.05 ulp. */
FN num exp_(num x) {
    num y = clamp_(x, -70.0f, 88.75f);
    num n = round_(y * NUM(1.44269504088896340736));
    num r = (y - n * 0.693359375f) - n * NUM(-2.12194440054690582e-4); /* n log 2, in two parts */
    num q = NUM(0.00836890843) + r * NUM(0.00139505242);
    num p = 0.5f + r * (NUM(0.166665182) + r * (NUM(0.041666206) + r * q));
    num e = 1.0f + (r + r * r * p);
    num big = min_(e * pow2_(n - 1.0f) * 2.0f, NUM(3.40282346638528859812e38));
    return sel(x < NUM(-69.314718055994530942), 0.0f, big);
}

/* log(x), accurate relative to itself next to 1 too.
   Domain:   x > 0, subnormal ones too; -105.4 at 0, so that no infinity appears.
   Accuracy: 1 ulp. */
FN num log_(num x) {
    cond tiny = x < NUM(1.17549435082228750797e-38);
    num y = sel(tiny, x * 33554432.0f, x);
    num n = exponent_(y) - sel(tiny, 25.0f, 0.0f);
    num f = fraction_(y) - 1.0f;
    return n * 0.693359375f + (log1p_core_(f) + n * NUM(-2.12194440054690582e-4));
}
#endif

/* e^x - 1, accurate relative to itself next to 0.
   Domain:   every x; FLT_MAX from log(FLT_MAX) on.
   Accuracy: 2 ulp. */
FN num expm1_(num x) {
    num q = NUM(0.00833307207) + x * (NUM(0.00139974465) + x * NUM(0.000199931848));
    num p = NUM(0.50000006) + x * (NUM(0.166666687) + x * (NUM(0.0416653156) + x * q));
    return sel(abs_(x) < 0.5f, x + x * x * p, exp_(x) - 1.0f);
}

/* log(1 + x), accurate relative to itself next to 0.
   Domain:   x > -1.
   Accuracy: 3 ulp. */
FN num log1p_(num x) {
    return sel(both(x > -0.25f, x < 0.375f), log1p_core_(x), log_(1.0f + x));
}

/* x^y as e^(y log x).
   Domain:   x >= 0; pow_(0, 0) = 1, pow_(0, y) = 0 for y > 2^-90, FLT_MAX for y < -2^-90.
   Accuracy: relative 2^-23 (1 + 2 |y log x|); 0 below 2^-100, FLT_MAX above. */
FN num pow_(num x, num y) {
    return exp_(y * sel(x > 0.0f, log_(x), -1.2676506002282294e30f));
}

/* Angle whose cosine is x, radians in [0, pi].
   Domain:   [-1, 1]; outside as at the end.
   Accuracy: 1.2 ulp. */
FN num acos_(num x) {
    num a = min_(abs_(x), 1.0f);
    cond steep = a > 0.5f;
    num z = sel(steep, 0.5f * (1.0f - a), a * a);
    num s = sel(steep, sqrt_(z), a);
    num q = NUM(0.031817615) + z * (NUM(0.0144025935) + z * NUM(0.0375652201));
    num p = NUM(0.166666597) + z * (NUM(0.0750051066) + z * (NUM(0.0445157215) + z * q));
    num t = s + s * z * p;                  /* asin of s */
    num low = NUM(-4.37113882867379112e-8); /* pi/2 less its float */
    num obtuse = 2.0f * (NUM(1.57079637050628662109) - (t - low));
    num middle = NUM(1.57079637050628662109) - (sel(x < 0.0f, -t, t) - low);
    return sel(steep, sel(x < 0.0f, obtuse, 2.0f * t), middle);
}

/* Angle of the point (x, y), radians in [-pi, pi]; 0 at the origin; -0 counts as 0.
   Domain:   the larger of |x|, |y| in [1e-37, 1e38].
   Accuracy: 3 ulp. */
FN num atan2_(num y, num x) {
    num ax = abs_(x);
    num ay = abs_(y);
    num t = min_(ax, ay) / max_(max_(ax, ay), NUM(1.0e-37));
    num z = t * t;
    num q = NUM(0.0435535759) + z * (NUM(-0.0165812057) + z * NUM(0.00297459518));
    num p = NUM(-0.142142102) + z * (NUM(0.106789418) + z * (NUM(-0.0758058131) + z * q));
    num r = t + t * z * (NUM(-0.333331674) + z * (NUM(0.199941367) + z * p));
    num steep = sel(ay > ax, NUM(1.57079632679489661923) - r, r);
    num whole = sel(x < 0.0f, NUM(3.14159265358979323846) - steep, steep);
    return sel(y < 0.0f, -whole, whole);
}

/* sin of q quarter turns and r + low. Domain: integers q, |r| <= 0.79, low the rest that r had to
   drop. */
FN num sin_quarters_(num q, num r, num low) {
    num turn = q - 4.0f * floor_(q * 0.25f);
    cond odd = either(turn == 1.0f, turn == 3.0f);
    num z = r * r;
    num p = NUM(-0.166666552) + z * (NUM(0.00833217334) + z * NUM(-0.000195166562));
    num k = NUM(0.0416666456) + z * (NUM(-0.00138873619) + z * NUM(2.44377297e-05));
    num c = (1.0f - 0.5f * z) + (z * z * k - r * low);
    num s = sel(odd, c, r + (r * z * p + low));
    return sel(turn > 1.5f, -s, s);
}

/* sin of x radians and `ahead` quarter turns. pi/2 is taken off in three parts, of which the first
   two times q are exact. */
FN num sin_ahead_(num x, num ahead) {
    num q = round_(x * NUM(0.63661977236758134308));
    num t = (x - q * 1.5703125f) - q * NUM(4.837512969970703e-4);
    num rest = q * NUM(7.549789948768648e-8);
    num r = t - rest;
    return sin_quarters_(q + ahead, r, (t - r) - rest);
}

/* sin(x), cos(x), x in radians.
   Domain:   |x| <= 1000 (larger ones lose accuracy).
   Accuracy: absolute 8e-8; 1 ulp for |x| <= pi/4 (sin_). */
FN num sin_(num x) {
    return sin_ahead_(x, 0.0f);
}
FN num cos_(num x) {
    return sin_ahead_(x, 1.0f);
}

/* sin of u turns and `ahead` quarter turns; pi/2 = its float less 4.37e-8. */
FN num sin2pi_ahead_(num u, num ahead) {
    num q = round_(u * 4.0f);
    num d = u * 4.0f - q;
    num r = d * NUM(1.57079637050628662109);
    return sin_quarters_(q + ahead, r, d * NUM(-4.37113882867379112e-8));
}

/* sin(2 pi u), cos(2 pi u), u in turns; exact at the quarters.
   Domain:   |u| <= 2^20.
   Accuracy: 1.7 ulp. */
FN num sin2pi_(num u) {
    return sin2pi_ahead_(u, 0.0f);
}
FN num cos2pi_(num u) {
    return sin2pi_ahead_(u, 1.0f);
}

/* erf(x) for |x| <= 1, erfc(x) for x in [1, 8.6]. */
FN num erf_core_(num x) {
    num z = x * x;
    num q = NUM(0.00518832775) + z * (NUM(-0.000801019429) + z * NUM(7.85386437e-05));
    num p = NUM(-0.37612626) + z * (NUM(0.112835854) + z * (NUM(-0.0268538129) + z * q));
    return x + x * (NUM(0.128379166) + z * p);
}
FN num erfc_tail_(num x) {
    num t = 1.0f / (1.0f + 0.5f * x);
    num q = NUM(0.0690663159) + t * (NUM(-0.215828225) + t * NUM(0.0900922492));
    num p = NUM(0.247849315) + t * (NUM(0.175017774) + t * (NUM(0.0703022033) + t * q));
    num r = NUM(0.282104284) + t * (NUM(0.281927556) + t * p);
    return exp_(-(x * x)) * (t * r);
}

/* Error function 2/sqrt(pi) int_0^x e^(-t^2) dt.
   Domain:   every x.
   Accuracy: 2 ulp. */
FN num erf_(num x) {
    num a = min_(abs_(x), 10.0f);
    num tail = 1.0f - erfc_tail_(a);
    return sel(a < 1.0f, erf_core_(x), sel(x < 0.0f, -tail, tail));
}

/* 1 - erf(x), without cancellation for large x.
   Domain:   every x; 0 from 8.33 on.
   Accuracy: absolute 1.2e-7; the larger of 5 ulp and, relative, 2^-23 x^2. */
FN num erfc_(num x) {
    num a = min_(abs_(x), 10.0f);
    num tail = erfc_tail_(a);
    return sel(a < 1.0f, 1.0f - erf_core_(x), sel(x < 0.0f, 2.0f - tail, tail));
}

/* The y with erf(y) = x: two polynomials of w = -log(1 - x^2), the idea of [Giles10].
   Domain:   |x| <= 1 - 2^-24; beyond as there (3.83).
   Accuracy: 4 ulp. */
FN num erfinv_(num x) {
    num w = -log_(max_((1.0f - x) * (1.0f + x), NUM(1.1920928955078125e-7)));
    num u = w - 2.5f;
    num v = sqrt_(max_(w, 0.0f)) - 3.0f;
    num a = NUM(4.66170064e-07) + u * (NUM(2.323263e-08) + u * NUM(-8.79101325e-09));
    num b = NUM(0.000218344445) + u * (NUM(-4.96334496e-06) + u * (NUM(-3.46270463e-06) + u * a));
    num c = NUM(0.24664028) + u * (NUM(-0.00417738687) + u * (NUM(-0.0012527419) + u * b));
    num d = NUM(-7.66194134e-05) + v * (NUM(-0.00031872344) + v * NUM(0.000128964122));
    num e = NUM(0.00568317249) + v * (NUM(-0.00358698773) + v * (NUM(0.00149585691) + v * d));
    num f = NUM(1.00167513) + v * (NUM(0.00944568403) + v * (NUM(-0.00763940997) + v * e));
    return x * sel(w < 5.0f, NUM(1.50140941) + u * c, NUM(2.83297682) + v * f);
}
#endif

#endif
