/* SPDX-License-Identifier: Apache-2.0 */
/* The elementary functions of src/shade/math.h against libm in double, whose own error is below
   1e-8 ulp of a float: the bounds of their doc comments. `test_shade_math 1` tries every float of
   each range (some 10 minutes), `test_shade_math 1 'sin*'` those of some functions; without
   arguments it is every 499th. */
#include "ndl_test.h"

#include <float.h>

#include "shade/math.h"

enum { BATCH = 4096 };
static uint32_t stride = 499;

#define LOOP(f)                                                                                    \
    static void run_##f(size_t n, const float *x, float *y) {                                      \
        _Pragma("omp simd") for (size_t i = 0; i < n; i++) {                                       \
            y[i] = f(x[i]);                                                                        \
        }                                                                                          \
    }
LOOP(exp_)
LOOP(expm1_)
LOOP(log_)
LOOP(log1p_)
LOOP(acos_)
LOOP(sin_)
LOOP(cos_)
LOOP(sin2pi_)
LOOP(cos2pi_)
LOOP(erf_)
LOOP(erfc_)
LOOP(erfinv_)
LOOP(floor_)

#define TAU 6.28318530717958647693

/* By the nearest quarter, so that the zeros are exact. */
static double exact_sin2pi(double u) {
    double r = u - rint(u), a = fabs(r);
    return copysign(sin(TAU * (a > 0.25 ? 0.5 - a : a)), r);
}
static double exact_cos2pi(double u) {
    return sin(TAU * (0.25 - fabs(u - rint(u))));
}

/* Halley's method on erf and erfc from Winitzki's start, which is good to 2e-3. */
static double exact_erfinv(double x) {
    double a = fabs(x), w = -log1p(-a * a), b = 4.33 + 0.5 * -w;
    double y = sqrt(sqrt(b * b + w / 0.147) - b);
    for (int k = 0; k < 4; k++) {
        double gap = a < 0.5 ? a - erf(y) : erfc(y) - (1.0 - a);
        double step = gap * 0.88622692545275801365 * exp(y * y);
        y += step / (1.0 - y * step);
    }
    return copysign(y, x);
}

/* The unit in the last place of a float near v. */
static double unit(double v) {
    int e;
    frexp(v, &e);
    return ldexp(1.0, e - 24 < -149 ? -149 : e - 24);
}

/* Allowed: the larger of `ulps` units and `absolute`, and 2^-23 |value| `square` x^2. */
typedef struct {
    const char *name;
    void (*run)(size_t, const float *, float *);
    double (*exact)(double);
    float lo, hi;
    double ulps, absolute, square;
} bound;

#define FLUSH 0x1p-100
static const bound bounds[] = {
    {"exp_", run_exp_, exp, -200.0f, 88.7228f, 1.05, FLUSH * 1.001, 0},
    {"expm1_", run_expm1_, expm1, -200.0f, 88.7228f, 2.0, 0, 0},
    {"log_", run_log_, log, 1e-45f, FLT_MAX, 1.0, 0, 0},
    {"log1p_", run_log1p_, log1p, -0.99999994f, FLT_MAX, 3.0, 0, 0},
    {"acos_", run_acos_, acos, -1.0f, 1.0f, 1.2, 0, 0},
    {"sin_", run_sin_, sin, -1000.0f, 1000.0f, 0, 8e-8, 0},
    {"sin_ near", run_sin_, sin, -0.785f, 0.785f, 1.0, 0, 0},
    {"cos_", run_cos_, cos, -1000.0f, 1000.0f, 0, 8e-8, 0},
    {"sin2pi_", run_sin2pi_, exact_sin2pi, -1048576.0f, 1048576.0f, 1.7, 0, 0},
    {"cos2pi_", run_cos2pi_, exact_cos2pi, -1048576.0f, 1048576.0f, 1.7, 0, 0},
    {"erf_", run_erf_, erf, -FLT_MAX, FLT_MAX, 2.0, 0, 0},
    {"erfc_", run_erfc_, erfc, -FLT_MAX, FLT_MAX, 5.0, FLUSH * 1.001, 1},
    {"erfinv_", run_erfinv_, exact_erfinv, -0.99999994f, 0.99999994f, 4.0, 0, 0},
    {"floor_", run_floor_, floor, -FLT_MAX, FLT_MAX, 0, 0, 0},
};

/* Place of a float on the line of all floats, and back. */
static int64_t place(float x) {
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    return u & 0x80000000u ? -(int64_t)(u & 0x7fffffffu) : (int64_t)u;
}
static float at_place(int64_t k) {
    uint32_t u = k < 0 ? (uint32_t)-k | 0x80000000u : (uint32_t)k;
    float x;
    memcpy(&x, &u, sizeof x);
    return x;
}

static void stays_within_its_bound(void **state) {
    const bound *b = *state;
    static float x[BATCH], y[BATCH];
    int64_t at = place(b->lo), end = place(b->hi);
    double worst_ulps = 0, worst_absolute = 0, worst_share = 0;
    float worst_x = 0;
    while (at <= end) {
        size_t n = 0;
        for (; n < BATCH && at <= end; n++, at += stride) {
            x[n] = at_place(at);
        }
        b->run(n, x, y);
        for (size_t i = 0; i < n; i++) {
            double want = b->exact((double)x[i]), error = fabs((double)y[i] - want);
            double ulps = error / unit(want);
            double allowed = fmax(b->ulps * unit(want), b->absolute);
            allowed += 0x1p-23 * fabs(want) * b->square * (double)x[i] * (double)x[i];
            double share = error / fmax(allowed, 1e-300);
            if (!(share <= worst_share)) {
                worst_share = share;
                worst_x = x[i];
            }
            worst_ulps = fmax(worst_ulps, fabs(want) > b->absolute ? ulps : 0);
            worst_absolute = fmax(worst_absolute, error);
        }
    }
    print_message("%-10s [%g, %g]: %.3f ulp, absolute %.3g, %.2f of what is allowed at %.9g\n",
                  b->name, (double)b->lo, (double)b->hi, worst_ulps, worst_absolute, worst_share,
                  (double)worst_x);
    assert_true(worst_share <= 1.0);
}

/* A reproducible stream of floats in [0, 1). */
static float uniform(uint64_t *s) {
    *s = *s * 6364136223846793005u + 1442695040888963407u;
    return (float)(*s >> 40) * 0x1p-24f;
}

static void pow_is_as_accurate_as_its_condition_allows(void **state) {
    (void)state;
    uint64_t s = 1;
    double worst = 0;
    for (int i = 0; i < 2000000; i++) {
        float u = uniform(&s), v = uniform(&s);
        float x = i % 3 == 0 ? u : i % 3 == 1 ? 1.0f - u * u * u * u * u : 1000.0f * u;
        float y = (float)pow(10.0, 9.0 * (double)v - 3.0) * (i % 7 ? 1.0f : -1.0f);
        double want = pow((double)x, (double)y);
        want = want > (double)FLT_MAX ? (double)FLT_MAX : want;
        double k = fabs((double)y * log((double)x)), error = fabs((double)pow_(x, y) - want);
        double allowed = 0x1p-23 * want * (1 + 2 * k) + 1.001 * FLUSH;
        if (x > 0 && !(error <= worst * allowed)) {
            worst = error / allowed;
        }
    }
    print_message("pow_: %.2f of 2^-23 (1 + 2 |y log x|)\n", worst);
    assert_true(worst <= 1.0);
}

static void atan2_covers_the_circle_and_the_axes(void **state) {
    (void)state;
    uint64_t s = 2;
    double worst = 0;
    for (int i = 0; i < 2000000; i++) {
        float scale = (float)pow(10.0, 60.0 * (double)uniform(&s) - 30.0);
        float tilt = (float)pow(10.0, -6.0 * (double)uniform(&s));
        float x = scale * (uniform(&s) - 0.5f), y = scale * tilt * (uniform(&s) - 0.5f);
        float a = i % 2 ? x : y, b = i % 2 ? y : x;
        double want = atan2((double)a, (double)b);
        worst = fmax(worst, fabs((double)atan2_(a, b) - want) / unit(want));
    }
    print_message("atan2_: %.3f ulp\n", worst);
    assert_true(worst <= 3.0);
    assert_same_float(atan2_(0.0f, 0.0f), 0.0f);
    assert_same_float(atan2_(0.0f, 1.0f), 0.0f);
    assert_ulp(atan2_(0.0f, -1.0f), 3.14159265f, 0);
    assert_ulp(atan2_(-1.0f, 0.0f), -1.57079633f, 0);
}

static void ends_and_exact_points(void **state) {
    (void)state;
    assert_same_float(exp_(0.0f), 1.0f);
    assert_same_float(exp_(-69.4f), 0.0f);
    assert_same_float(exp_(-INFINITY), 0.0f);
    assert_same_float(exp_(88.73f), FLT_MAX);
    assert_same_float(exp_(INFINITY), FLT_MAX);
    assert_same_float(expm1_(0.0f), 0.0f);
    assert_same_float(expm1_(-INFINITY), -1.0f);
    assert_same_float(log_(1.0f), 0.0f);
    assert_true(log_(0.0f) < log_(1e-45f) && isfinite(log_(0.0f)));
    assert_same_float(log1p_(0.0f), 0.0f);
    assert_same_float(acos_(1.0f), 0.0f);
    assert_same_float(acos_(1.5f), 0.0f);
    assert_ulp(acos_(-1.0f), 3.14159265f, 0);
    assert_ulp(acos_(-1.5f), 3.14159265f, 0);
    assert_same_float(cos_(0.0f), 1.0f);
    assert_same_float(sin2pi_(0.5f), 0.0f);
    assert_same_float(sin2pi_(0.25f), 1.0f);
    assert_same_float(cos2pi_(0.25f), 0.0f);
    assert_same_float(cos2pi_(7.5f), -1.0f);
    assert_same_float(erf_(INFINITY), 1.0f);
    assert_same_float(erf_(-INFINITY), -1.0f);
    assert_same_float(erfc_(INFINITY), 0.0f);
    assert_same_float(erfc_(-INFINITY), 2.0f);
    assert_same_float(erfinv_(0.0f), 0.0f);
    assert_ulp(erfinv_(1.0f), erfinv_(0.99999994f), 1);
    assert_same_float(floor_(-0.5f), -1.0f);
}

static void pow_at_its_ends(void **state) {
    (void)state;
    assert_same_float(pow_(0.0f, 0.0f), 1.0f);
    assert_same_float(pow_(0.0f, 1e-20f), 0.0f);
    assert_same_float(pow_(0.0f, 1e6f), 0.0f);
    assert_same_float(pow_(0.0f, -1.0f), FLT_MAX);
    assert_same_float(pow_(1.0f, 1e6f), 1.0f);
    assert_same_float(pow_(0.5f, 0.0f), 1.0f);
    assert_same_float(pow_(2.0f, 200.0f), FLT_MAX);
}

/* No conversion to int may see a NaN or an infinity: the sanitized build stops there. */
static void strange_arguments_do_not_trap(void **state) {
    (void)state;
    static const float odd[] = {NAN, INFINITY, -INFINITY, FLT_MAX, -FLT_MAX, 1e-45f, -0.0f, -1.0f};
    float y[8];
    for (size_t k = 0; k < sizeof bounds / sizeof *bounds; k++) {
        bounds[k].run(8, odd, y);
    }
    for (int i = 0; i < 8; i++) {
        for (int j = 0; j < 8; j++) {
            y[j] = pow_(odd[i], odd[j]) + atan2_(odd[i], odd[j]);
        }
    }
    vec3 zero = v3_unit(v3(0.0f, 0.0f, 0.0f));
    assert_true(zero.x == 0.0f && zero.y == 0.0f && zero.z == 0.0f);
}

int main(int argc, char **argv) {
    enum { BOUNDS = sizeof bounds / sizeof *bounds };
    struct CMUnitTest tests[BOUNDS + 5] = {
        cmocka_unit_test(pow_is_as_accurate_as_its_condition_allows),
        cmocka_unit_test(atan2_covers_the_circle_and_the_axes),
        cmocka_unit_test(ends_and_exact_points),
        cmocka_unit_test(pow_at_its_ends),
        cmocka_unit_test(strange_arguments_do_not_trap),
    };
    for (int k = 0; k < BOUNDS; k++) {
        struct CMUnitTest test = {bounds[k].name, stays_within_its_bound, NULL, NULL,
                                  (void *)(uintptr_t)&bounds[k]};
        tests[5 + k] = test;
    }
    if (argc > 1) {
        stride = (uint32_t)strtoul(argv[1], NULL, 10);
    }
    if (argc > 2) {
        cmocka_set_test_filter(argv[2]);
    }
    return cmocka_run_group_tests_name("math", tests, NULL, NULL);
}
