/* SPDX-License-Identifier: Apache-2.0 */
#include "render/geometry.h"

#include "base/error.h"
#include "render/builtin.h"

#include <string.h>

/* Generous for a mesh of ten million triangles; what needs more is no mesh or an attack. */
static const nd_limits IMPORT_LIMITS = {
    .seconds = 120.0, .memory = (size_t)6 << 30, .output = (size_t)4 << 30};

static void bound_mesh(nd_geometry *g) {
    const nd_mesh *m = &g->mesh;
    dvec low = dv((double)INFINITY, (double)INFINITY, (double)INFINITY), high = dv_scale(low, -1.0);
    for (size_t i = 0; i < 3 * (size_t)m->triangles; i++) {
        dvec p = dv_from(m->position + 3 * (size_t)m->index[i]);
        low = dv(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        high = dv(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
    g->centre = dv_scale(dv_add(low, high), 0.5);
    double square = 0.0;
    for (size_t i = 0; i < 3 * (size_t)m->triangles; i++) {
        dvec d = dv_sub(dv_from(m->position + 3 * (size_t)m->index[i]), g->centre);
        square = fmax(square, dv_dot(d, d));
    }
    g->radius = sqrt(square);
}

static bool load_shape(const nd_shape *shape, nd_geometry *g, ndl_error *error) {
    g->shape = shape;
    g->radius = shape->radius;
    if (!nd_mesh_new(&g->mesh, 0, 0, 1, false))
        return nd_fail(error, NDL_E_MEMORY, 0, "out of memory", NULL);
    strcpy(g->mesh.part[0].mesh, shape->name);
    return true;
}

bool nd_geometry_load(const char *name, nd_geometry *g, ndl_error *error) {
    *g = (nd_geometry){0};
    const nd_shape *shape = nd_shape_find(name);
    if (shape) return load_shape(shape, g, error);
    bool loaded = nd_builtin_is(name) ? nd_builtin_mesh(name, &g->mesh, error)
                                      : nd_mesh_import(name, IMPORT_LIMITS, &g->mesh, error);
    if (!loaded) return false;
    bound_mesh(g);
    g->tracer = nd_tracer_new(&g->mesh, error);
    if (!g->tracer) nd_mesh_free(&g->mesh);
    return g->tracer != NULL;
}

void nd_geometry_free(nd_geometry *g) {
    nd_tracer_free(g->tracer);
    nd_mesh_free(&g->mesh);
    *g = (nd_geometry){0};
}

dvec nd_horizontal(dvec n) {
    dvec t = dv_unit(dv(n.z, 0.0, -n.x));
    return dv_dot(t, t) > 0.0 ? t : dv(1.0, 0.0, 0.0);
}

/* ---- triangles ------------------------------------------------------------------------------- */

/* The corners of a triangle, and the weights of its vertices at the point of the ray. */
typedef struct {
    const uint32_t *index;
    dvec a, ab, ac; /* a corner and two edges */
    double weight[3];
} triangle;

/* Weights in double, so that they do not depend on how the tracer found the triangle; held inside
   of it where they lie outside by the tracer's rounding. Source: [MoellerTrumbore97]. */
static void weigh(triangle *t, nd_ray ray) {
    dvec across = dv_cross(ray.direction, t->ac);
    double determinant = dv_dot(t->ab, across);
    dvec from = dv_sub(ray.origin, t->a);
    double b = dv_dot(from, across) / determinant;
    double c = dv_dot(ray.direction, dv_cross(from, t->ab)) / determinant;
    b = isfinite(b) ? fmin(fmax(b, 0.0), 1.0) : 0.0;
    c = isfinite(c) ? fmin(fmax(c, 0.0), 1.0) : 0.0;
    double total = fmax(b + c, 1.0);
    t->weight[1] = b / total;
    t->weight[2] = c / total;
    t->weight[0] = fmax(0.0, 1.0 - t->weight[1] - t->weight[2]);
}

static dvec interpolate(const triangle *t, const float *values) {
    dvec sum = dv(0.0, 0.0, 0.0);
    for (int k = 0; k < 3; k++)
        sum = dv_add(sum, dv_scale(dv_from(values + 3 * (size_t)t->index[k]), t->weight[k]));
    return sum;
}

static uint32_t part_of(const nd_mesh *m, uint32_t number) {
    uint32_t low = 0, high = m->parts;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (m->part[middle].first <= number) low = middle;
        else high = middle;
    }
    return low;
}

/* Sets u, v and returns d(position)/du, up to a positive factor; zero where there are no texture
   coordinates. */
static dvec along_u(const nd_mesh *m, const triangle *t, nd_surface *s) {
    double u[3], v[3];
    for (int k = 0; k < 3; k++) {
        u[k] = (double)m->uv[2 * (size_t)t->index[k]];
        v[k] = (double)m->uv[2 * (size_t)t->index[k] + 1];
    }
    s->u = t->weight[0] * u[0] + t->weight[1] * u[1] + t->weight[2] * u[2];
    s->v = t->weight[0] * v[0] + t->weight[1] * v[1] + t->weight[2] * v[2];
    double determinant = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]);
    double sign = determinant > 0.0 ? 1.0 : determinant < 0.0 ? -1.0 : 0.0;
    return dv_sub(dv_scale(t->ab, sign * (v[2] - v[0])), dv_scale(t->ac, sign * (v[1] - v[0])));
}

static bool hit_mesh(const nd_geometry *g, nd_ray ray, nd_surface *s) {
    const nd_mesh *m = &g->mesh;
    uint32_t number;
    if (!nd_tracer_hit(g->tracer, ray, &number)) return false;
    triangle t = {.index = m->index + 3 * (size_t)number};
    t.a = dv_from(m->position + 3 * (size_t)t.index[0]);
    t.ab = dv_sub(dv_from(m->position + 3 * (size_t)t.index[1]), t.a);
    t.ac = dv_sub(dv_from(m->position + 3 * (size_t)t.index[2]), t.a);
    weigh(&t, ray);
    s->part = part_of(m, number);
    s->p = dv_add(t.a, dv_add(dv_scale(t.ab, t.weight[1]), dv_scale(t.ac, t.weight[2])));
    s->g = dv_unit(dv_cross(t.ab, t.ac));
    s->n = dv_unit(interpolate(&t, m->normal));
    if (!(dv_dot(s->n, s->n) > 0.0)) s->n = s->g;
    /* The normals of a file say what is outside, also where its triangles are wound otherwise. */
    if (dv_dot(s->g, s->n) < 0.0) s->g = dv_scale(s->g, -1.0);
    dvec along = along_u(m, &t, s);
    if (m->tangent) along = interpolate(&t, m->tangent);
    s->t = dv_unit(dv_sub(along, dv_scale(s->n, dv_dot(along, s->n))));
    if (!(dv_dot(s->t, s->t) > 0.0)) s->t = nd_horizontal(s->n);
    return true;
}

/* ---- both ------------------------------------------------------------------------------------ */

bool nd_geometry_hit(const nd_geometry *g, nd_ray ray, nd_surface *s) {
    s->part = 0;
    if (g->shape) {
        if (!g->shape->hit(ray, s)) return false;
        s->g = s->n;
    } else if (!hit_mesh(g, ray, s)) {
        return false;
    }
    if (dv_dot(s->g, ray.direction) > 0.0) {
        s->g = dv_scale(s->g, -1.0);
        s->n = dv_scale(s->n, -1.0);
    }
    return true;
}

bool nd_geometry_blocks(const nd_geometry *g, const nd_surface *s, dvec direction,
                        double distance) {
    double side = dv_dot(s->g, direction) < 0.0 ? -1.0 : 1.0;
    if (g->shape) {
        nd_ray exact = {dv_add(s->p, dv_scale(s->g, 1e-9 * side)), direction};
        return g->shape->blocks(exact, distance);
    }
    /* The tracer works in float: a step of some of its roundings leaves the triangle. */
    double size = fabs(s->p.x) + fabs(s->p.y) + fabs(s->p.z) + g->radius;
    double step = 2e-6 * size;
    nd_ray ray = {dv_add(s->p, dv_scale(s->g, step * side)), direction};
    return nd_tracer_blocked(g->tracer, ray, distance * (1.0 - 1e-5));
}
