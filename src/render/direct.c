/* SPDX-License-Identifier: Apache-2.0 */
#include "render/direct.h"

#include "base/process.h"
#include "base/threads.h"
#include "ndotl/convert.h"
#include "render/sampler.h"

#include <float.h>

/* A run of sorted hits with one material. */
typedef struct { int first, count; const ndl_material *material; } group;

static ndl_vec3_n input(const nd_lanes *l, int first) {
    return (ndl_vec3_n){l->x + first, l->y + first, l->z + first};
}

static ndl_rgb_n output(nd_lanes *l, int first) {
    return (ndl_rgb_n){l->x + first, l->y + first, l->z + first};
}

/* A world direction in the frame of the surface. */
static dvec to_local(const nd_surface *s, dvec w) {
    return dv(dv_dot(w, s->t), dv_dot(w, dv_cross(s->n, s->t)), dv_dot(w, s->n));
}

/* Shading takes directions as `ndotl eval` takes the numbers that `--show` gives it: rounded to
   float, made unit in double, rounded again. So a pixel is what eval prints for its directions. */
static void set_lane(nd_lanes *l, int i, dvec w, bool for_shading) {
    ndl_vec3 v = dv_round(w);
    if (for_shading) ndl_direction((double)v.x, (double)v.y, (double)v.z, &v);
    l->x[i] = v.x;
    l->y[i] = v.y;
    l->z[i] = v.z;
}

static void set_result(nd_tile_room *room, int i, dvec value) {
    room->result[i][0] = value.x;
    room->result[i][1] = value.y;
    room->result[i][2] = value.z;
}

/* ---- one light, or one shown quantity, on one group ------------------------------------------ */

static bool is_lit(const nd_tile_room *room, int i) {
    return room->wi.z[i] > 0.0f && room->wo.z[i] > 0.0f;
}

/* Fills wi and light of the group from one light; occlusion where shadows are asked for. */
static void aim_at_light(const nd_direct *d, nd_tile_room *room, group g, const nd_light *light,
                         bool for_shading) {
    for (int i = g.first; i < g.first + g.count; i++) {
        const nd_surface *s = &room->sorted[i];
        dvec direction = dv(0.0, 0.0, 0.0);
        double distance;
        room->light[i][0] = room->light[i][1] = room->light[i][2] = 0.0;
        bool arrives = nd_light_arrives(light, s->p, &direction, &distance, room->light[i]);
        set_lane(&room->wi, i, arrives ? to_local(s, direction) : dv(0.0, 0.0, 0.0), for_shading);
        if (!for_shading || !d->desc->shadows || !arrives || !is_lit(room, i)) continue;
        room->stats.shadow_rays++;
        if (nd_geometry_blocks(&d->scene->geometry, s, direction, distance))
            room->light[i][0] = room->light[i][1] = room->light[i][2] = 0.0;
    }
}

/* light * value, where infinity (an inverse square nearly at the light) meets 0 as 0. */
static double lit_by(double light, float value) {
    if (!(light > 0.0) || !(value > 0.0f)) return 0.0;
    double product = light * (double)value;
    return product < (double)FLT_MAX ? product : (double)FLT_MAX;
}

static void shade_group(const nd_direct *d, nd_tile_room *room, group g) {
    for (int i = g.first; i < g.first + g.count; i++) set_result(room, i, dv(0.0, 0.0, 0.0));
    for (size_t k = 0; k < d->scene->lights; k++) {
        aim_at_light(d, room, g, &d->scene->light[k], true);
        (d->desc->scanline ? ndl_scanline_n : ndl_brdf_cos_n)(
            g.material, (size_t)g.count, input(&room->wi, g.first), input(&room->wo, g.first),
            output(&room->value, g.first));
        room->stats.shaded += (unsigned long long)g.count;
        for (int i = g.first; i < g.first + g.count; i++) {
            room->result[i][0] += lit_by(room->light[i][0], room->value.x[i]);
            room->result[i][1] += lit_by(room->light[i][1], room->value.y[i]);
            room->result[i][2] += lit_by(room->light[i][2], room->value.z[i]);
        }
    }
}

static void show_term(const nd_direct *d, nd_tile_room *room, group g, ndl_term_kind term) {
    aim_at_light(d, room, g, &d->scene->light[0], true);
    ndl_term_n(g.material, term, (size_t)g.count, input(&room->wi, g.first),
               input(&room->wo, g.first), output(&room->value, g.first));
    for (int i = g.first; i < g.first + g.count; i++)
        set_result(room, i, dv((double)room->value.x[i], (double)room->value.y[i],
                               (double)room->value.z[i]));
}

static void show_lanes(nd_tile_room *room, group g, const nd_lanes *l) {
    for (int i = g.first; i < g.first + g.count; i++)
        set_result(room, i, dv((double)l->x[i], (double)l->y[i], (double)l->z[i]));
}

static void show_surface(nd_tile_room *room, group g, ndl_show show) {
    for (int i = g.first; i < g.first + g.count; i++) {
        const nd_surface *s = &room->sorted[i];
        set_result(room, i, show == NDL_SHOW_NORMAL    ? s->n
                            : show == NDL_SHOW_TANGENT ? s->t
                            : show == NDL_SHOW_UV      ? dv(s->u, s->v, 0.0)
                                                       : s->p);
    }
}

static void show_albedo(nd_tile_room *room, group g) {
    for (int i = g.first; i < g.first + g.count; i++) {
        ndl_vec3 wo = {room->wo.x[i], room->wo.y[i], room->wo.z[i]};
        ndl_rgb e = ndl_albedo(g.material, wo, 1e-4f, NULL);
        set_result(room, i, dv((double)e.r, (double)e.g, (double)e.b));
    }
}

static void show_group(const nd_direct *d, nd_tile_room *room, group g) {
    switch (d->desc->show) {
    case NDL_SHOW_RADIANCE: shade_group(d, room, g); break;
    case NDL_SHOW_WI:
        aim_at_light(d, room, g, &d->scene->light[0], false);
        show_lanes(room, g, &room->wi);
        break;
    case NDL_SHOW_WO: show_lanes(room, g, &room->wo); break;
    case NDL_SHOW_ALBEDO: show_albedo(room, g); break;
    case NDL_SHOW_D: show_term(d, room, g, NDL_TERM_D); break;
    case NDL_SHOW_G: show_term(d, room, g, NDL_TERM_G); break;
    case NDL_SHOW_V: show_term(d, room, g, NDL_TERM_V); break;
    case NDL_SHOW_F: show_term(d, room, g, NDL_TERM_F); break;
    default: show_surface(room, g, d->desc->show); break;
    }
}

/* ---- one sample a pixel ---------------------------------------------------------------------- */

typedef struct { int x, y, width, height; } area;

static void add(double sum[3], const double value[3]) {
    for (int c = 0; c < 3; c++) sum[c] += value[c];
}

/* Traces one ray a pixel; the number of hits. */
static int gather(const nd_direct *d, nd_tile_room *room, area a, uint32_t sample) {
    int hits = 0;
    ndl_rgb back = d->desc->background;
    const double background[3] = {(double)back.r, (double)back.g, (double)back.b};
    for (int i = 0; i < a.width * a.height; i++) {
        int x = a.x + i % a.width, y = a.y + i / a.width;
        double dx, dy;
        nd_place_sample(d->desc->seed, (uint32_t)y * (uint32_t)d->image->width + (uint32_t)x,
                        sample, (uint32_t)d->desc->samples, &dx, &dy);
        nd_ray ray = nd_view_ray(&d->view, (double)x + dx, (double)y + dy);
        if (nd_geometry_hit(&d->scene->geometry, ray, &room->hit[hits])) {
            room->ray[hits] = ray;
            room->pixel[hits++] = i;
        } else if (d->desc->show == NDL_SHOW_RADIANCE) {
            add(room->sum[i], background);
        }
    }
    room->stats.rays += (unsigned long long)(a.width * a.height);
    room->stats.hits += (unsigned long long)hits;
    return hits;
}

/* Takes out the hits of one more material, in their order, and writes their lanes. */
static group next_group(const nd_direct *d, nd_tile_room *room, int *left, int done) {
    const ndl_material *const *material = d->scene->material;
    group g = {done, 0, material[room->hit[room->order[0]].part]};
    int rest = 0;
    for (int k = 0; k < *left; k++) {
        int from = room->order[k], to = done + g.count;
        if (material[room->hit[from].part] != g.material) {
            room->order[rest++] = from;
            continue;
        }
        room->sorted[to] = room->hit[from];
        room->sorted_pixel[to] = room->pixel[from];
        set_lane(&room->wo, to, to_local(&room->hit[from], dv_scale(room->ray[from].direction, -1)),
                 d->desc->show != NDL_SHOW_WO);
        g.count++;
    }
    *left = rest;
    return g;
}

static void one_sample(const nd_direct *d, nd_tile_room *room, area a, uint32_t sample) {
    double start = nd_clock();
    int hits = gather(d, room, a, sample);
    double traced = nd_clock();
    int left = hits, done = 0;
    for (int i = 0; i < hits; i++) room->order[i] = i;
    while (left) {
        group g = next_group(d, room, &left, done);
        show_group(d, room, g);
        done += g.count;
    }
    for (int i = 0; i < hits; i++) add(room->sum[room->sorted_pixel[i]], room->result[i]);
    room->stats.trace_seconds += traced - start;
    room->stats.shade_seconds += nd_clock() - traced;
}

void nd_direct_tile(const nd_direct *d, nd_tile_room *room, int x, int y) {
    int width = d->image->width - x, height = d->image->height - y;
    area a = {x, y, width < ND_TILE_SIDE ? width : ND_TILE_SIDE,
              height < ND_TILE_SIDE ? height : ND_TILE_SIDE};
    for (int i = 0; i < a.width * a.height; i++)
        room->sum[i][0] = room->sum[i][1] = room->sum[i][2] = 0.0;
    for (int s = 0; s < d->desc->samples && !nd_interrupted(); s++)
        one_sample(d, room, a, (uint32_t)s);
    for (int i = 0; i < a.width * a.height; i++) {
        size_t row = (size_t)(a.y + i / a.width);
        float *to = d->image->rgb +
                    3 * (row * (size_t)d->image->width + (size_t)(a.x + i % a.width));
        for (int c = 0; c < 3; c++) {
            double mean = room->sum[i][c] / (double)d->desc->samples;
            to[c] = (float)(mean < (double)FLT_MAX ? mean : (double)FLT_MAX);
        }
    }
}
