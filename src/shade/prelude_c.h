/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* What the shading text means in C: `num` is float, or double where ND_WIDE is defined (the wide
   reference of the tests). Only + - * / sqrt, comparisons, selects and conversions are used, all
   of them correctly rounded, so with -ffp-contract=off every compiler and instruction set gives
   the same bits; every function is branch-free and vectorises inside `#pragma omp simd`.
   The rules of the text are in RULES.md. */
#ifndef ND_PRELUDE
#define ND_PRELUDE

#include <stdint.h>

#ifdef ND_WIDE
#include <math.h>
/* A float literal in the text is exact, so its promotion is meant. */
#pragma GCC diagnostic ignored "-Wdouble-promotion"
typedef double num;
#else
typedef float num;
#endif
typedef int cond;
typedef struct {
    num x, y, z;
} vec3;

#define FN static inline __attribute__((always_inline, unused))
#define STRUCT(name)                                                                               \
    typedef struct name name;                                                                      \
    struct name
/* A constant that float cannot hold exactly; rounded once, to the width of the build. */
#define NUM(x) ((num)(x))

/* ---- conditions ---- */
FN num sel(cond c, num a, num b) {
    return c ? a : b;
}
FN cond both(cond a, cond b) {
    return a & b;
}
FN cond either(cond a, cond b) {
    return a | b;
}
FN cond not_(cond a) {
    return a == 0;
}

/* ---- numbers ---- */
/* The smaller, the larger; b where a is NaN. */
FN num min_(num a, num b) {
    return a < b ? a : b;
}
FN num max_(num a, num b) {
    return a > b ? a : b;
}
/* x limited to [lo, hi]; lo where x is NaN. */
FN num clamp_(num x, num lo, num hi) {
    return min_(max_(x, lo), hi);
}

#ifdef ND_WIDE
FN num abs_(num x) {
    return fabs(x);
}
FN num sqrt_(num x) {
    return sqrt(x);
}
FN num floor_(num x) {
    return floor(x);
}
FN num round_(num x) {
    return floor(x + 0.5);
}
FN num exp_(num x) {
    return exp(x);
}
FN num expm1_(num x) {
    return expm1(x);
}
FN num log_(num x) {
    return log(x);
}
FN num log1p_(num x) {
    return log1p(x);
}
FN num pow_(num x, num y) {
    return pow(x, y);
}
FN num acos_(num x) {
    return acos(clamp_(x, -1.0, 1.0));
}
FN num atan2_(num y, num x) {
    return atan2(y, x);
}
FN num sin_(num x) {
    return sin(x);
}
FN num cos_(num x) {
    return cos(x);
}
FN num sin2pi_(num u) {
    return sin(6.28318530717958647693 * (u - round_(u)));
}
FN num cos2pi_(num u) {
    return cos(6.28318530717958647693 * (u - round_(u)));
}
FN num erf_(num x) {
    return erf(x);
}
FN num erfc_(num x) {
    return erfc(x);
}

/* Halley's method on erf and erfc, which keeps its digits next to 1, from [Winitzki08]'s start,
   good to 2e-3. Domain: |x| < 1. Accuracy: 1e-15 relative. */
FN num erfinv_(num x) {
    num a = fabs(x);
    num w = -log1p(-a * a);
    num b = 4.33 - 0.5 * w;
    num y = sqrt(sqrt(b * b + w / 0.147) - b);
    for (int k = 0; k < 4; k++) {
        num gap = a < 0.5 ? a - erf(y) : erfc(y) - (1.0 - a);
        num step = gap * 0.88622692545275801365 * exp(y * y); /* sqrt(pi)/2 */
        y += step / (1.0 - y * step);
    }
    return x < 0.0 ? -y : y;
}
#else
FN num abs_(num x) {
    return __builtin_fabsf(x);
}
/* Square root, correctly rounded. Domain: x >= 0, NaN below. */
FN num sqrt_(num x) {
    return __builtin_sqrtf(x);
}

/* Largest integer not above x; exact. Adding 2^23 to |x| rounds it to an integer; from 2^23 on x
   is one. NaN stays NaN, floor_(-0) is 0. */
FN num floor_(num x) {
    num a = abs_(x);
    num n = sel(a < 8388608.0f, (a + 8388608.0f) - 8388608.0f, a);
    num t = sel(x < 0.0f, -n, n);
    return t - sel(t > x, 1.0f, 0.0f);
}

/* Nearest integer, ties to even. Domain: |x| <= 2^22. Adding 1.5 2^23 leaves no fraction bits. */
FN num round_(num x) {
    return (x + 12582912.0f) - 12582912.0f;
}

/* 2^n. Domain: integers n in [-126, 127]. */
FN num pow2_(num n) {
    uint32_t u = (uint32_t)((int32_t)n + 127) << 23;
    num r;
    __builtin_memcpy(&r, &u, sizeof r);
    return r;
}

/* x = fraction_(x) 2^exponent_(x) with the fraction in [sqrt(1/2), sqrt(2)). Domain: normal x > 0;
   0 gives 1 and -127. 0x3f3504f3 are the bits of sqrt(1/2). */
FN num exponent_(num x) {
    uint32_t u;
    __builtin_memcpy(&u, &x, sizeof u);
    return (num)((int32_t)((u + (0x3f800000u - 0x3f3504f3u)) >> 23) - 127);
}
FN num fraction_(num x) {
    uint32_t u;
    __builtin_memcpy(&u, &x, sizeof u);
    u = ((u + (0x3f800000u - 0x3f3504f3u)) & 0x007fffffu) + 0x3f3504f3u;
    num r;
    __builtin_memcpy(&r, &u, sizeof r);
    return r;
}
#endif

/* ---- vectors ---- */
FN vec3 v3(num x, num y, num z) {
    vec3 r;
    r.x = x;
    r.y = y;
    r.z = z;
    return r;
}
FN vec3 v3_splat(num s) {
    return v3(s, s, s);
}
FN vec3 v3_add(vec3 a, vec3 b) {
    return v3(a.x + b.x, a.y + b.y, a.z + b.z);
}
FN vec3 v3_sub(vec3 a, vec3 b) {
    return v3(a.x - b.x, a.y - b.y, a.z - b.z);
}
FN vec3 v3_mul(vec3 a, vec3 b) {
    return v3(a.x * b.x, a.y * b.y, a.z * b.z);
}
FN vec3 v3_scale(vec3 a, num s) {
    return v3(a.x * s, a.y * s, a.z * s);
}
FN num v3_dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
FN vec3 v3_cross(vec3 a, vec3 b) {
    return v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
FN vec3 v3_sel(cond c, vec3 a, vec3 b) {
    return v3(sel(c, a.x, b.x), sel(c, a.y, b.y), sel(c, a.z, b.z));
}

/* ---- tables: data that the text reads only through lut1 and lut2 ---- */
/* A ramp: n stops, 1 <= n <= TABLE1_STOPS, x in rising order (two equal ones make a step),
   colours r g b. */
enum { TABLE1_STOPS = 4096 };
typedef struct {
    const float *x, *r, *g, *b;
    int n;
} table1;
/* A grid over [0, 1]^2: texel (i, j) = v[j nx + i] lies at (i/(nx - 1), j/(ny - 1)). */
typedef struct {
    const float *v;
    int nx, ny;
} table2;

/* Number of the stop `step` after k, or of the last one, if x has reached it; else k. */
FN int reached_stop(table1 t, num x, int k, int step) {
    int next = k + step < t.n ? k + step : t.n - 1;
    return t.x[next] <= x ? next : k;
}

/* Colour of the ramp at x: the exact piecewise linear function, constant outside the stops; where
   two stops share a place, the later one holds from there on. The last stop not above x is found
   by a bisection of fixed length, which vectorises (a loop over n stops does not). The way through
   a num hides from gcc that k was an index before: it would load conditionally, in scalar code. */
FN vec3 lut1(table1 t, num x) {
    int found = reached_stop(t, x, 0, 2048);
    found = reached_stop(t, x, found, 1024);
    found = reached_stop(t, x, found, 512);
    found = reached_stop(t, x, found, 256);
    found = reached_stop(t, x, found, 128);
    found = reached_stop(t, x, found, 64);
    found = reached_stop(t, x, found, 32);
    found = reached_stop(t, x, found, 16);
    found = reached_stop(t, x, found, 8);
    found = reached_stop(t, x, found, 4);
    found = reached_stop(t, x, found, 2);
    found = reached_stop(t, x, found, 1);
    int k = (int)((num)found + 0.5f);
    int m = k + 1 < t.n ? k + 1 : t.n - 1;
    num x0 = t.x[k];
    num width = t.x[m] - x0;
    cond inside = both(x > x0, width > 0.0f);
    num w = sel(inside, (x - x0) / sel(inside, width, 1.0f), 0.0f);
    vec3 a = v3(t.r[k], t.g[k], t.b[k]);
    vec3 b = v3(t.r[m], t.g[m], t.b[m]);
    return v3_add(v3_scale(a, 1.0f - w), v3_scale(b, w));
}

/* Bilinear value of the grid at (x, y), both limited to [0, 1]. */
FN num lut2(table2 t, num x, num y) {
    num u = clamp_(x, 0.0f, 1.0f) * (num)(t.nx - 1);
    num v = clamp_(y, 0.0f, 1.0f) * (num)(t.ny - 1);
    int i = (int)u, j = (int)v;
    int right = i + 1 < t.nx, up = t.nx & -(j + 1 < t.ny);
    num a = u - (num)i, b = v - (num)j;
    const float *p = t.v;
    int at = j * t.nx + i;
    num low = p[at] * (1.0f - a) + p[at + right] * a;
    num high = p[at + up] * (1.0f - a) + p[at + up + right] * a;
    return low * (1.0f - b) + high * b;
}

#endif
