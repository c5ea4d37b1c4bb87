/* SPDX-License-Identifier: Apache-2.0 */
/* Large batches by several threads, a fixed number of pairs at a time. */
#include "base/threads.h"
#include "ndotl/ndotl.h"

/* Pairs that a thread takes at once: enough to outweigh taking them, a multiple of every kernel's
   group, and past the second cache, so that a tile is stored like the whole batch. */
enum { TILE = 32768 };

typedef void batch_call(const ndl_material *m, size_t n, ndl_vec3_n wi, ndl_vec3_n wo,
                        ndl_rgb_n rgb);

typedef struct {
    const ndl_material *m;
    batch_call *call;
    size_t n;
    ndl_vec3_n wi, wo;
    ndl_rgb_n rgb;
} batch;

static void evaluate_tile(void *context, int thread, size_t item) {
    const batch *b = context;
    size_t at = item * TILE, n = b->n - at < TILE ? b->n - at : TILE;
    (void)thread;
    b->call(b->m, n, (ndl_vec3_n){b->wi.x + at, b->wi.y + at, b->wi.z + at},
            (ndl_vec3_n){b->wo.x + at, b->wo.y + at, b->wo.z + at},
            (ndl_rgb_n){b->rgb.r + at, b->rgb.g + at, b->rgb.b + at});
}

static void run(batch b, int threads) {
    if (threads < 1) threads = nd_processors();
    if (threads == 1 || b.n < NDL_THREADS_LEAST) {
        b.call(b.m, b.n, b.wi, b.wo, b.rgb);
        return;
    }
    nd_jobs_run(&(nd_jobs){(b.n + TILE - 1) / TILE, evaluate_tile, NULL, &b}, threads);
}

void ndl_brdf_threads_n(const ndl_material *m, int threads, size_t n, ndl_vec3_n wi, ndl_vec3_n wo,
                        ndl_rgb_n rgb) {
    run((batch){m, ndl_brdf_n, n, wi, wo, rgb}, threads);
}

void ndl_brdf_cos_threads_n(const ndl_material *m, int threads, size_t n, ndl_vec3_n wi,
                            ndl_vec3_n wo, ndl_rgb_n rgb) {
    run((batch){m, ndl_brdf_cos_n, n, wi, wo, rgb}, threads);
}
