/* SPDX-License-Identifier: Apache-2.0 */
/* The machine's limits: fused multiply-adds from registers, and streams that do next to nothing
   with what they read, each with the widest instruction set that the library may use here. */
#include "bench.h"

#include <stdlib.h>
#include <string.h>
#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

enum { FMA_STEPS = 4096, CHAINS = 12 };

typedef float (*fma_loop)(float x);
typedef void (*stream_loop)(const bench_batch *b);

/* CHAINS independent chains hide the latency of the multiply-add; they converge to 1, so that
   nothing overflows or becomes denormal. Streams with `store` being a non-temporal one bypass the
   caches. n is a multiple of 16, arrays are aligned. */
#define FMA_LOOP(name, target, vector, set1, fmadd, store, lanes)                                  \
    target static float fma_##name(float x) {                                                      \
        vector chain[CHAINS], half = set1(0.5f);                                                   \
        float sum = 0.0f, part[lanes];                                                             \
        for (int k = 0; k < CHAINS; k++)                                                           \
            chain[k] = set1(x + (float)k);                                                         \
        for (int i = 0; i < FMA_STEPS; i++)                                                        \
            for (int k = 0; k < CHAINS; k++)                                                       \
                chain[k] = fmadd(chain[k], half, half);                                            \
        for (int k = 0; k < CHAINS; k++) {                                                         \
            store(part, chain[k]);                                                                 \
            for (int i = 0; i < lanes; i++)                                                        \
                sum += part[i];                                                                    \
        }                                                                                          \
        return sum;                                                                                \
    }
#define STREAM_LOOP(name, target, load, add, store, lanes)                                         \
    target static void stream_##name(const bench_batch *b) {                                       \
        for (size_t i = 0; i < b->n; i += lanes) {                                                 \
            store(b->out[0] + i, add(load(b->in[0] + i), load(b->in[3] + i)));                     \
            store(b->out[1] + i, add(load(b->in[1] + i), load(b->in[4] + i)));                     \
            store(b->out[2] + i, add(load(b->in[2] + i), load(b->in[5] + i)));                     \
        }                                                                                          \
    }
#define TRIAD_LOOP(name, target, set1, load, fmadd, store, lanes)                                  \
    target static void triad_##name(const bench_batch *b) {                                        \
        for (size_t i = 0; i < b->n; i += lanes)                                                   \
            store(b->out[0] + i, fmadd(load(b->in[0] + i), set1(3.0f), load(b->in[1] + i)));       \
    }

#define PLAIN_SET(x) (x)
#define PLAIN_LOAD(p) (*(p))
#define PLAIN_STORE(p, x) (*(p) = (x))
#define PLAIN_ADD(a, b) ((a) + (b))
#define PLAIN_FMADD(a, b, c) ((a) * (b) + (c))

#if defined(__x86_64__)
#define V3 __attribute__((target("avx2,fma")))
#define V4 __attribute__((target("avx512f")))
#define SSE_FMADD(a, b, c) _mm_add_ps(_mm_mul_ps(a, b), c)
FMA_LOOP(v1, , __m128, _mm_set1_ps, SSE_FMADD, _mm_storeu_ps, 4)
FMA_LOOP(v3, V3, __m256, _mm256_set1_ps, _mm256_fmadd_ps, _mm256_storeu_ps, 8)
FMA_LOOP(v4, V4, __m512, _mm512_set1_ps, _mm512_fmadd_ps, _mm512_storeu_ps, 16)
STREAM_LOOP(v1, , _mm_load_ps, _mm_add_ps, _mm_store_ps, 4)
STREAM_LOOP(v3, V3, _mm256_load_ps, _mm256_add_ps, _mm256_store_ps, 8)
STREAM_LOOP(v4, V4, _mm512_load_ps, _mm512_add_ps, _mm512_store_ps, 16)
STREAM_LOOP(past_v1, , _mm_load_ps, _mm_add_ps, _mm_stream_ps, 4)
STREAM_LOOP(past_v3, V3, _mm256_load_ps, _mm256_add_ps, _mm256_stream_ps, 8)
STREAM_LOOP(past_v4, V4, _mm512_load_ps, _mm512_add_ps, _mm512_stream_ps, 16)
TRIAD_LOOP(v1, , _mm_set1_ps, _mm_load_ps, SSE_FMADD, _mm_stream_ps, 4)
TRIAD_LOOP(v3, V3, _mm256_set1_ps, _mm256_load_ps, _mm256_fmadd_ps, _mm256_stream_ps, 8)
TRIAD_LOOP(v4, V4, _mm512_set1_ps, _mm512_load_ps, _mm512_fmadd_ps, _mm512_stream_ps, 16)
#elif defined(__aarch64__)
#define NEON_FMADD(a, b, c) vfmaq_f32(c, a, b)
FMA_LOOP(neon, , float32x4_t, vdupq_n_f32, NEON_FMADD, vst1q_f32, 4)
STREAM_LOOP(neon, , vld1q_f32, vaddq_f32, vst1q_f32, 4)
TRIAD_LOOP(neon, , vdupq_n_f32, vld1q_f32, NEON_FMADD, vst1q_f32, 4)
#else
FMA_LOOP(plain, , float, PLAIN_SET, PLAIN_FMADD, PLAIN_STORE, 1)
STREAM_LOOP(plain, , PLAIN_LOAD, PLAIN_ADD, PLAIN_STORE, 1)
TRIAD_LOOP(plain, , PLAIN_SET, PLAIN_LOAD, PLAIN_FMADD, PLAIN_STORE, 1)
#endif

typedef struct {
    const char *isa;
    int lanes;
    fma_loop fma;
    stream_loop stream, past, triad; /* past: stores that bypass the caches, where there are any */
} loops;

/* From the widest on. */
static const loops ALL[] = {
#if defined(__x86_64__)
    {"x86-64-v4", 16, fma_v4, stream_v4, stream_past_v4, triad_v4},
    {"x86-64-v3", 8, fma_v3, stream_v3, stream_past_v3, triad_v3},
    {"x86-64", 4, fma_v1, stream_v1, stream_past_v1, triad_v1},
#elif defined(__aarch64__)
    {"neon", 4, fma_neon, stream_neon, stream_neon, triad_neon},
#else
    {"scalar", 1, fma_plain, stream_plain, stream_plain, triad_plain},
#endif
};

static const loops *widest(void) {
    char before[32];
    size_t at = 0, last = sizeof ALL / sizeof *ALL - 1;
    strncpy(before, ndl_isa(), sizeof before - 1);
    before[sizeof before - 1] = '\0';
    while (at < last && ndl_use_isa(ALL[at].isa) != NDL_OK)
        at++;
    ndl_use_isa(before);
    return &ALL[at];
}

typedef struct {
    const loops *l;
    stream_loop stream;
    bench_batch *part; /* one a thread */
    volatile float sink;
} work;

static void call_fma(void *context, int thread) {
    work *w = context;
    float sum = w->l->fma(1.0f + (float)thread);
    if (thread == 0) w->sink = sum;
}

static void call_stream(void *context, int thread) {
    work *w = context;
    w->stream(&w->part[thread]);
}

/* Elements per second of a stream over the whole batch. */
static double elements(work *w, stream_loop stream, int threads, double seconds) {
    w->stream = stream;
    call_stream(w, 0);
    return bench_rate(call_stream, w, threads, seconds) * (double)w->part[0].n;
}

/* The streams of one level: each thread has a batch of its own, or its part of the large one. */
static bool measure_level(work *w, bench_level level, size_t n, int threads, double seconds,
                          bench_limits *to) {
    bench_batch own[1024];
    int batches = level == BENCH_DRAM ? 1 : threads;
    bool good = true;
    memset(own, 0, sizeof own);
    for (int i = 0; i < batches && good; i++)
        good = bench_batch_new(&own[i], n, (unsigned)i);
    for (int i = 0; i < threads && good; i++) {
        w->part[i] = level == BENCH_DRAM ? bench_batch_part(&own[0], i, threads) : own[i];
        w->part[i].n -= w->part[i].n % 16;
    }
    if (good) {
        double best = elements(w, w->l->stream, threads, seconds);
        if (level == BENCH_DRAM) {
            double past = elements(w, w->l->past, threads, seconds);
            best = past > best ? past : best;
            to->triad = 12e-9 * elements(w, w->l->triad, threads, seconds);
        }
        to->stream[level] = 1e-6 * best;
        good = best > 0.0;
    }
    for (int i = 0; i < batches; i++)
        bench_batch_free(&own[i]);
    return good;
}

bool bench_limits_measure(const bench_machine *m, int threads, double seconds, bench_limits *to) {
    bench_batch *parts = calloc((size_t)threads, sizeof *parts);
    work w = {.l = widest(), .part = parts};
    bool good = parts != NULL;
    *to = (bench_limits){.isa = w.l->isa};
    if (good)
        to->fma =
            2e-9 * FMA_STEPS * CHAINS * w.l->lanes * bench_rate(call_fma, &w, threads, seconds);
    for (int level = 0; level < BENCH_LEVELS && good; level++)
        good = measure_level(&w, (bench_level)level,
                             bench_level_pairs(m, (bench_level)level, BENCH_EVAL_BYTES), threads,
                             seconds, to);
    free(parts);
    return good && to->fma > 0.0;
}
