/* SPDX-License-Identifier: Apache-2.0 */
/* Prints one hash per function of math.h over a million inputs: half of them anywhere among the
   finite floats, half in [-8, 8). test_bits.py compares the output of many builds. */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "shade/math.h"

enum { COUNT = 1 << 20 };
static float x[COUNT], y[COUNT], r[COUNT], g[COUNT], b[COUNT];

static uint32_t next(uint64_t *s) {
    *s = *s * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(*s >> 32);
}

static void fill(float *at, uint64_t s) {
    for (int i = 0; i < COUNT; i++) {
        uint32_t u = next(&s);
        u = (u & 0x7f800000u) == 0x7f800000u ? u ^ 0x40000000u : u;
        memcpy(&at[i], &u, sizeof u);
        at[i] = i % 2 ? at[i] : (float)(int32_t)next(&s) * 0x1p-28f;
    }
}

/* FNV-1a over the bits; every NaN counts as the same. */
static uint64_t hash(uint64_t h, const float *at) {
    for (int i = 0; i < COUNT; i++) {
        uint32_t u;
        memcpy(&u, &at[i], sizeof u);
        u = (u & 0x7fffffffu) > 0x7f800000u ? 0x7fc00000u : u;
        h = (h ^ u) * 1099511628211u;
    }
    return h;
}

#define START 14695981039346656037u
#define SHOW(name, h) printf("%s %016llx\n", name, (unsigned long long)(h))
#define LOOP _Pragma("omp simd") for (int i = 0; i < COUNT; i++)
#define ONE(f)                                                                                     \
    do {                                                                                           \
        LOOP {                                                                                     \
            r[i] = f(x[i]);                                                                        \
        }                                                                                          \
        SHOW(#f, hash(START, r));                                                                  \
    } while (0)
#define TWO(f)                                                                                     \
    do {                                                                                           \
        LOOP {                                                                                     \
            r[i] = f(x[i], y[i]);                                                                  \
        }                                                                                          \
        SHOW(#f, hash(START, r));                                                                  \
    } while (0)

static void numbers(void) {
    ONE(exp_);
    ONE(expm1_);
    ONE(log_);
    ONE(log1p_);
    ONE(acos_);
    ONE(sin_);
    ONE(cos_);
    ONE(sin2pi_);
    ONE(cos2pi_);
    ONE(erf_);
    ONE(erfc_);
    ONE(erfinv_);
    ONE(floor_);
    TWO(pow_);
    TWO(atan2_);
}

static void vectors_and_tables(void) {
    static const float at[5] = {-2.0f, 0.0f, 0.0f, 0.3f, 5.0f};
    static const float red[5] = {0.1f, 0.7f, 0.2f, 0.9f, 0.4f}, green[5] = {1, 0, 1, 0, 1};
    static const float grid[12] = {0.1f, 0.9f, 0.3f, 0.4f, 0.8f, 0.2f,
                                   0.7f, 0.5f, 0.6f, 1.0f, 0.0f, 0.35f};
    table1 ramp = {at, red, green, red, 5};
    table2 table = {grid, 4, 3};
    LOOP {
        vec3 c = lut1(ramp, x[i]);
        r[i] = c.x;
        g[i] = c.y;
        b[i] = c.z;
    }
    SHOW("lut1", hash(hash(hash(START, r), g), b));
    LOOP {
        r[i] = lut2(table, x[i], y[i]);
    }
    SHOW("lut2", hash(START, r));
    LOOP {
        vec3 c = v3_unit(v3(x[i], y[i], x[i] * y[i]));
        r[i] = c.x;
        g[i] = c.y;
        b[i] = c.z;
    }
    SHOW("v3_unit", hash(hash(hash(START, r), g), b));
}

int main(void) {
    fill(x, 1);
    fill(y, 2);
    numbers();
    vectors_and_tables();
    return 0;
}
