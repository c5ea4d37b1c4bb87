/* SPDX-License-Identifier: Apache-2.0 */
#include "render/tonemap.h"

#include "render/call.h"
#include "shade/prelude_c.h"

#include <math.h>

#define TONEMAP(name, PARAMS)                  \
    typedef struct { PARAMS(FIELD) } name##_p; \
    ND_DEFINE_SCHEMA(name##_schema, #name, PARAMS, name##_p)
#include "render/tonemaps.def"
#undef TONEMAP

static double at_most_one(double x) {
    return x < 1.0 ? x : 1.0;
}

static double apply_clamp(double x, double parameter) {
    (void)parameter;
    return at_most_one(x);
}

/* x / (1 + x). Source: [Reinhard02] eq. 3, per channel. */
static double apply_reinhard(double x, double parameter) {
    (void)parameter;
    return isinf(x) ? 1.0 : x / (1.0 + x);
}

/* x (1 + x / white^2) / (1 + x); `white` becomes 1. Source: [Reinhard02] eq. 4, per channel. */
static double apply_reinhard_extended(double x, double white) {
    if (x >= white) return 1.0;
    return at_most_one(x * (1.0 + x / (white * white)) / (1.0 + x));
}

/* 1 - exp(-k x) */
static double apply_exponential(double x, double k) {
    return -expm1(-k * x);
}

/* A fit of the ACES reference transform's curve. Source: [Narkowicz15]. */
static double apply_aces(double x, double parameter) {
    (void)parameter;
    if (x > 1e6) return 1.0;
    return at_most_one(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
}

bool nd_tonemap_parse(const char *text, nd_tonemap *map, ndl_error *error) {
#define TONEMAP(name, PARAMS) name##_schema(),
    const nd_schema *const schemas[] = {
#include "render/tonemaps.def"
        NULL};
#undef TONEMAP
#define TONEMAP(name, PARAMS) apply_##name,
    static double (*const apply[])(double, double) = {
#include "render/tonemaps.def"
    };
#undef TONEMAP
    nd_arena arena = {0};
    nd_binding b;
    float parameter = 0.0f; /* at most one key each */
    int kind = nd_call_parse(text, "tone map", schemas, &arena, &b, &parameter, error);
    nd_arena_free(&arena);
    if (kind < 0) return false;
    *map = (nd_tonemap){apply[kind], (double)parameter};
    return true;
}
