/* SPDX-License-Identifier: Apache-2.0 */
/* One row of `ndotl bench`: an operation of the library on a batch, in turns with its scalar
   kernel. */
#include "base/threads.h"
#include "bench.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static ndl_vec3_n wi_of(const bench_batch *b) {
    return (ndl_vec3_n){b->in[0], b->in[1], b->in[2]};
}

static ndl_vec3_n wo_of(const bench_batch *b) {
    return (ndl_vec3_n){b->in[3], b->in[4], b->in[5]};
}

static ndl_rgb_n rgb_of(const bench_batch *b) {
    return (ndl_rgb_n){b->out[0], b->out[1], b->out[2]};
}

static void brdf(const ndl_material *m, const bench_batch *b) {
    ndl_brdf_n(m, b->n, wi_of(b), wo_of(b), rgb_of(b));
}

static void brdf_lanes(const ndl_material *m, size_t lanes, const ndl_lanes *lane,
                       const bench_batch *b) {
    ndl_brdf_lanes_n(m, lanes, lane, b->n, wi_of(b), wo_of(b), rgb_of(b));
}

static void brdf_threads(const ndl_material *m, int threads, const bench_batch *b) {
    ndl_brdf_threads_n(m, threads, b->n, wi_of(b), wo_of(b), rgb_of(b));
}

static void pdf(const ndl_material *m, const bench_batch *b) {
    ndl_pdf_n(m, b->n, wi_of(b), wo_of(b), b->out[0]);
}

static void sample(const ndl_material *m, const bench_batch *b) {
    ndl_draw_n(m, b->n, wo_of(b), (ndl_vec3_n){b->random[0], b->random[1], b->random[2]},
               (ndl_vec3_out){b->out[3], b->out[4], b->out[5]}, rgb_of(b), b->out[6]);
}

static const bench_op ops[] = {
    {"brdf", BENCH_EVAL_BYTES, brdf, brdf_lanes, brdf_threads},
    {"pdf", 28, pdf, NULL, NULL},
    {"sample", 52, sample, NULL, NULL},
};

const bench_op *bench_op_find(const char *name) {
    for (size_t i = 0; i < sizeof ops / sizeof *ops; i++)
        if (strcmp(ops[i].name, name) == 0) return &ops[i];
    return NULL;
}

/* ---- parameters per lane --------------------------------------------------------------------- */

enum { KEY_ROOM = 48 };

typedef struct {
    char key[BENCH_LANES][KEY_ROOM];
    ndl_lanes lane[BENCH_LANES];
    float low[BENCH_LANES], high[BENCH_LANES];
    size_t count;
} lane_set;

/* Values around the default of a key, inside its range. */
static void lane_range(const ndl_param *p, int channel, float *low, float *high) {
    double middle = p->initial[p->kind == NDL_KIND_COLOR ? channel : 0];
    double from = middle > 0.0 ? 0.5 * middle : p->low,
           to = middle > 0.0 ? 1.5 * middle : p->low + 1.0;
    *low = (float)(from > p->low ? from : p->low);
    *high = (float)(to < p->high ? to : p->high);
}

/* Adds a key with all its channels, if there is room and the material can vary it. */
static void add_key(lane_set *s, const ndl_material *m, const ndl_param *p) {
    size_t channels = p->kind == NDL_KIND_COLOR ? 3 : 1, first = s->count;
    if (first + channels > BENCH_LANES) return;
    for (size_t c = 0; c < channels; c++) {
        size_t at = first + c;
        snprintf(s->key[at], KEY_ROOM, channels > 1 ? "%s.%c" : "%s", p->key, "rgb"[c]);
        s->lane[at] = (ndl_lanes){s->key[at], NULL};
        lane_range(p, (int)c, &s->low[at], &s->high[at]);
    }
    if (ndl_lanes_check(m, first + channels, s->lane, NULL) == NDL_OK) s->count += channels;
}

/* The first quantities of the first lobe that fit into BENCH_LANES arrays. */
static void choose_lanes(lane_set *s, const ndl_material *m) {
    size_t count;
    int model = ndl_model_find(ndl_material_model(m, 0));
    const ndl_param *p = ndl_model_params((size_t)model, &count);
    s->count = 0;
    for (size_t i = 0; i < count; i++)
        if (!p[i].is_spelling && (p[i].kind == NDL_KIND_NUMBER || p[i].kind == NDL_KIND_COLOR))
            add_key(s, m, &p[i]);
}

static void fill_lanes(const lane_set *s, bench_batch *b) {
    for (size_t k = 0; k < s->count; k++)
        for (size_t i = 0; i < b->n; i++) {
            uint32_t mixed = (uint32_t)(i + 7919 * k) * 2654435769u;
            float u = (float)(mixed >> 8) * 0x1p-24f;
            b->lane[k][i] = s->low[k] + (s->high[k] - s->low[k]) * u;
        }
}

/* ---- measuring ------------------------------------------------------------------------------- */

typedef struct {
    const bench_order *o;
    const lane_set *lanes;
    const bench_batch *part;   /* one a thread */
    const bench_batch *shared; /* where the library starts the threads: their one batch */
    size_t most, *at;          /* for scalar: so many pairs at once, beginning here; one a thread */
    volatile float sink;
} work;

static void evaluate(const work *w, const bench_batch *b) {
    const bench_order *o = w->o;
    ndl_lanes lane[BENCH_LANES];
    if (!o->has_lanes) {
        o->op->uniform(o->material, b);
        return;
    }
    for (size_t k = 0; k < w->lanes->count; k++)
        lane[k] = (ndl_lanes){w->lanes->key[k], b->lane[k]};
    o->op->lanes(o->material, w->lanes->count, lane, b);
}

static void call(void *context, int thread) {
    work *w = context;
    const bench_batch *b = w->shared ? w->shared : &w->part[thread];
    if (w->shared)
        w->o->op->threads(w->o->material, w->o->threads, b);
    else
        evaluate(w, b);
    if (thread == 0) w->sink = b->out[0][b->n - 1];
}

/* A scalar call takes the next `most` pairs: a whole large batch would outlast the measurement. */
static void call_some(void *context, int thread) {
    work *w = context;
    bench_batch b = w->part[thread];
    size_t *at = &w->at[64 * (size_t)thread];
    if (*at + w->most > b.n) *at = 0;
    for (int k = 0; k < BENCH_INPUTS; k++)
        b.in[k] += *at;
    for (int k = 0; k < BENCH_OUTPUTS; k++)
        b.out[k] += *at;
    for (int k = 0; k < BENCH_LANES; k++)
        b.lane[k] += *at;
    for (int k = 0; k < BENCH_RANDOM; k++)
        b.random[k] += *at;
    b.n = w->most;
    *at += w->most;
    evaluate(w, &b);
    if (thread == 0) w->sink = b.out[0][0];
}

/* Both in turns, and the medians of their rates. */
static bool measure(work *w, bench_result *to) {
    enum { ROUNDS = 5 };
    const bench_order *o = w->o;
    double fast[ROUNDS], plain[ROUNDS], slice = o->seconds / (2 * ROUNDS), start = nd_clock();
    int racers = w->shared ? 1 : o->threads;
    double pairs = w->shared ? (double)w->shared->n : (double)w->part[0].n;
    int done = 0;
    while (done < ROUNDS && (done == 0 || nd_clock() - start < o->seconds - slice)) {
        ndl_use_isa(o->isa);
        if (done == 0) call(w, 0);
        fast[done] = pairs * bench_rate(call, w, racers, slice);
        ndl_use_isa("scalar");
        plain[done] = (double)w->most * bench_rate(call_some, w, o->threads, slice);
        if (!(fast[done] > 0.0 && plain[done] > 0.0)) return false;
        done++;
    }
    ndl_use_isa(o->isa);
    double rate = bench_median(fast, (size_t)done);
    to->meval_per_s = 1e-6 * rate;
    to->vs_scalar = rate / bench_median(plain, (size_t)done);
    return true;
}

void bench_batches_free(bench_batches *b) {
    for (int i = 0; i < b->count; i++)
        bench_batch_free(&b->own[i]);
    free(b->own);
    *b = (bench_batches){0};
}

static bool prepare(bench_batches *b, size_t n, int count) {
    if (b->n == n && b->count == count) return true;
    bench_batches_free(b);
    b->own = calloc((size_t)count, sizeof *b->own);
    bool good = b->own != NULL;
    for (; good && b->count < count; b->count++)
        good = bench_batch_new(&b->own[b->count], n, (unsigned)b->count);
    b->n = n;
    if (!good) bench_batches_free(b);
    return good;
}

bool bench_row_measure(const bench_order *o, bench_batches *b, bench_result *to) {
    bool shared = o->threads == 1 || o->n >= NDL_THREADS_LEAST;
    bool driver = shared && o->threads > 1 && !o->has_lanes && o->op->threads;
    lane_set lanes = {.count = 0};
    if (o->has_lanes) choose_lanes(&lanes, o->material);
    to->lanes = lanes.count;
    bench_batch *parts = calloc((size_t)o->threads, sizeof *parts);
    size_t *at = calloc(64 * (size_t)o->threads, sizeof *at); /* each in a cache line of its own */
    bool good = parts && at && prepare(b, o->n, shared ? 1 : o->threads);
    if (good) {
        enum { SOME = 1 << 14 };
        for (int i = 0; i < b->count; i++)
            fill_lanes(&lanes, &b->own[i]);
        for (int i = 0; i < o->threads; i++)
            parts[i] = shared ? bench_batch_part(&b->own[0], i, o->threads) : b->own[i];
        work w = {.o = o,
                  .lanes = &lanes,
                  .part = parts,
                  .shared = driver ? &b->own[0] : NULL,
                  .most = parts[0].n < SOME ? parts[0].n : SOME,
                  .at = at};
        good = measure(&w, to);
    }
    free(parts);
    free(at);
    return good;
}
