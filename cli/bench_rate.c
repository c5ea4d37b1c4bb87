/* SPDX-License-Identifier: Apache-2.0 */
/* Batches to measure with, and calls per second. */
#include "base/threads.h"
#include "bench.h"

#include <math.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
    LINE = 16, /* floats */
    SKEW = 5 * LINE,
    PERIOD = 1 << 17, /* pairs after which a batch repeats itself */
    ARRAYS = BENCH_INPUTS + BENCH_OUTPUTS + BENCH_LANES + BENCH_RANDOM
};

static float uniform(uint64_t *state) {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return (float)(*state >> 40) * 0x1p-24f;
}

/* A unit vector above the horizon, or below it. */
static void direction(uint64_t *state, bool above, float *w[3], size_t i) {
    float x, y, z, l;
    do {
        x = 2.0f * uniform(state) - 1.0f;
        y = 2.0f * uniform(state) - 1.0f;
        z = uniform(state);
        l = x * x + y * y + z * z;
    } while (l > 1.0f || l < 1e-3f);
    l = (above ? 1.0f : -1.0f) / sqrtf(l);
    w[0][i] = x * l;
    w[1][i] = y * l;
    w[2][i] = z * l;
}

static void fill_pair(bench_batch *b, uint64_t *state, size_t i) {
    float kind = uniform(state); /* one in ten: one of the two, or both, below */
    direction(state, kind < 0.934f, b->in, i);
    direction(state, kind < 0.9f || kind > 0.967f, b->in + 3, i);
    for (int k = 0; k < BENCH_LANES; k++)
        b->lane[k][i] = 0.5f;
    for (int k = 0; k < BENCH_RANDOM; k++)
        b->random[k][i] = uniform(state);
}

/* The first PERIOD pairs again from `at` on. */
static void repeat(bench_batch *b, size_t at) {
    size_t bytes = (b->n - at < PERIOD ? b->n - at : PERIOD) * sizeof(float);
    for (int k = 0; k < BENCH_INPUTS; k++)
        memcpy(b->in[k] + at, b->in[k], bytes);
    for (int k = 0; k < BENCH_LANES; k++)
        memcpy(b->lane[k] + at, b->lane[k], bytes);
    for (int k = 0; k < BENCH_RANDOM; k++)
        memcpy(b->random[k] + at, b->random[k], bytes);
}

bool bench_batch_new(bench_batch *b, size_t n, unsigned seed) {
    size_t room = (n + LINE - 1) / LINE * LINE + SKEW;
    *b = (bench_batch){.n = n};
    if (room > SIZE_MAX / ARRAYS / sizeof(float) - LINE) return false;
    b->memory = malloc((room * ARRAYS + LINE) * sizeof(float));
    if (!b->memory) return false;
    float *at = (float *)(((uintptr_t)b->memory + 63) / 64 * 64);
    float **const sets[] = {b->in, b->out, b->lane, b->random};
    static const int counts[] = {BENCH_INPUTS, BENCH_OUTPUTS, BENCH_LANES, BENCH_RANDOM};
    for (int s = 0; s < 4; s++)
        for (int i = 0; i < counts[s]; i++, at += room)
            sets[s][i] = at;
    uint64_t state = 0x9E3779B97F4A7C15ULL * (seed + 1);
    for (size_t i = 0; i < n && i < PERIOD; i++)
        fill_pair(b, &state, i);
    for (size_t done = PERIOD; done < n; done += PERIOD)
        repeat(b, done);
    /* Touched, so that no page is taken while the clock runs. */
    for (int k = 0; k < BENCH_OUTPUTS; k++)
        memset(b->out[k], 0, n * sizeof(float));
    return true;
}

void bench_batch_free(bench_batch *b) {
    free(b->memory);
    *b = (bench_batch){0};
}

bench_batch bench_batch_part(const bench_batch *b, int i, int parts) {
    size_t from = b->n / (size_t)parts * (size_t)i / LINE * LINE;
    size_t to = i + 1 < parts ? b->n / (size_t)parts * (size_t)(i + 1) / LINE * LINE : b->n;
    bench_batch part = *b;
    part.n = to - from;
    part.memory = NULL;
    for (int k = 0; k < BENCH_INPUTS; k++)
        part.in[k] += from;
    for (int k = 0; k < BENCH_OUTPUTS; k++)
        part.out[k] += from;
    for (int k = 0; k < BENCH_LANES; k++)
        part.lane[k] += from;
    for (int k = 0; k < BENCH_RANDOM; k++)
        part.random[k] += from;
    return part;
}

typedef struct {
    bench_call *call;
    void *context;
    int threads;
    double seconds;
    atomic_int waiting;
    atomic_bool failed;
    double rate[]; /* one a thread */
} race;

/* Waits until all threads are there, so that they run side by side; false after two seconds. */
static bool all_have_come(race *r) {
    double start = nd_clock();
    atomic_fetch_add(&r->waiting, 1);
    while (atomic_load(&r->waiting) < r->threads && !atomic_load(&r->failed))
        if (nd_clock() - start > 2.0) atomic_store(&r->failed, true);
    return !atomic_load(&r->failed);
}

static void run_one(void *context, int thread, size_t item) {
    race *r = context;
    (void)thread;
    if (r->threads > 1 && !all_have_come(r)) return;
    double start = nd_clock(), before = start, now, most = 0.0625 * r->seconds;
    size_t calls = 0, chunk = 1;
    for (;;) {
        for (size_t i = 0; i < chunk; i++)
            r->call(r->context, (int)item);
        calls += chunk;
        now = nd_clock();
        if (now - start >= r->seconds) break;
        if (now - before < 0.5 * most) chunk *= 2;
        before = now;
    }
    r->rate[item] = (double)calls / (now - start);
}

double bench_rate(bench_call *call, void *context, int threads, double seconds) {
    race *r = calloc(1, sizeof *r + (size_t)threads * sizeof r->rate[0]);
    if (!r) return 0.0;
    r->call = call;
    r->context = context;
    r->threads = threads;
    r->seconds = seconds;
    nd_jobs_run(&(nd_jobs){(size_t)threads, run_one, NULL, r}, threads);
    double sum = 0.0;
    for (int i = 0; i < threads; i++)
        sum += r->rate[i];
    if (atomic_load(&r->failed)) sum = 0.0;
    free(r);
    return sum;
}

static int by_size(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double bench_median(double *values, size_t n) {
    if (!n) return 0.0;
    qsort(values, n, sizeof *values, by_size);
    return 0.5 * (values[n / 2] + values[(n - 1) / 2]);
}
