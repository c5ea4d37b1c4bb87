/* SPDX-License-Identifier: Apache-2.0 */
#include "ndotl/render.h"

#include "base/error.h"
#include "base/process.h"
#include "base/threads.h"
#include "render/direct.h"

#include <stdlib.h>

enum { MOST_SAMPLES = 65536 };

typedef struct {
    nd_direct direct;
    nd_tile_room *room; /* one a thread */
    int across;         /* tiles in a row */
    size_t tiles;
} rendering;

static void work(void *context, int thread, size_t tile) {
    rendering *r = context;
    int row = (int)(tile / (size_t)r->across), column = (int)(tile % (size_t)r->across);
    nd_direct_tile(&r->direct, &r->room[thread], column * ND_TILE_SIDE, row * ND_TILE_SIDE);
}

static bool finished(void *context, size_t tiles) {
    const rendering *r = context;
    const ndl_render_desc *desc = r->direct.desc;
    if (nd_interrupted()) return false;
    return !desc->progress || desc->progress(desc->user, (double)tiles / (double)r->tiles) == 0;
}

static bool every_material_has(const ndl_scene *s, ndl_term_kind term, ndl_error *error) {
    static const char *const names[] = {"D", "G", "V", "F"};
    for (size_t i = 0; i < s->geometry.mesh.parts; i++) {
        if (ndl_has_term(s->material[i], term)) continue;
        return nd_fail(error, NDL_E_UNSUPPORTED, 0, "there is no term ", names[term],
                       " but of a single microfacet lobe, and so not of ",
                       ndl_material_text(s->material[i]), NULL);
    }
    return true;
}

static bool can_show(const ndl_scene *s, ndl_show show, ndl_error *error) {
    switch (show) {
    case NDL_SHOW_D: return every_material_has(s, NDL_TERM_D, error);
    case NDL_SHOW_G: return every_material_has(s, NDL_TERM_G, error);
    case NDL_SHOW_V: return every_material_has(s, NDL_TERM_V, error);
    case NDL_SHOW_F: return every_material_has(s, NDL_TERM_F, error);
    default: return true;
    }
}

static bool prepare(rendering *r, ndl_render_desc *desc, ndl_error *error) {
    const ndl_scene *s = r->direct.scene;
    const ndl_image *image = r->direct.image;
    if (desc->samples == 0) desc->samples = 1;
    if (desc->threads <= 0) desc->threads = nd_processors();
    if (desc->samples < 0 || desc->samples > MOST_SAMPLES)
        return nd_fail(error, NDL_E_RANGE, 0, "the samples a pixel must be from 1 to 65536", NULL);
    if (!can_show(s, desc->show, error)) return false;
    if (!nd_camera_place(&s->camera, s->geometry.centre, s->geometry.radius, image->width,
                         image->height, &r->direct.view, error))
        return false;
    r->across = (image->width + ND_TILE_SIDE - 1) / ND_TILE_SIDE;
    r->tiles = (size_t)r->across * (size_t)((image->height + ND_TILE_SIDE - 1) / ND_TILE_SIDE);
    if ((size_t)desc->threads > r->tiles) desc->threads = (int)r->tiles;
    if (desc->threads > ND_MOST_THREADS) desc->threads = ND_MOST_THREADS;
    r->room = calloc((size_t)desc->threads, sizeof *r->room);
    return r->room ? true : nd_fail(error, NDL_E_MEMORY, 0, "out of memory", NULL);
}

static void sum_stats(const rendering *r, double seconds, ndl_render_stats *stats) {
    *stats = (ndl_render_stats){.seconds = seconds, .threads = r->direct.desc->threads};
    for (int i = 0; i < r->direct.desc->threads; i++) {
        const ndl_render_stats *one = &r->room[i].stats;
        stats->trace_seconds += one->trace_seconds;
        stats->shade_seconds += one->shade_seconds;
        stats->rays += one->rays;
        stats->hits += one->hits;
        stats->shadow_rays += one->shadow_rays;
        stats->shaded += one->shaded;
    }
}

int ndl_render(const ndl_scene *scene, const ndl_render_desc *given, ndl_image *image,
               ndl_render_stats *stats, ndl_error *err) {
    ndl_error own = {0};
    ndl_render_desc desc = *given;
    rendering r = {.direct = {.scene = scene, .desc = &desc, .image = image}};
    double start = nd_clock();
    if (prepare(&r, &desc, &own)) {
        nd_jobs jobs = {r.tiles, work, finished, &r};
        if (!nd_jobs_run(&jobs, desc.threads))
            nd_fail(&own, NDL_E_CANCELLED, 0, "interrupted", NULL);
        else if (stats)
            sum_stats(&r, nd_clock() - start, stats);
    }
    free(r.room);
    if (own.code && err) *err = own;
    return own.code;
}
