/* SPDX-License-Identifier: Apache-2.0 */
/* Shapes that rays meet exactly. */
#include "render/geometry.h"

#include <string.h>

static const double PI = 3.14159265358979323846;

/* A ray that starts on a surface begins a little above it. */
static const double START = 1e-9;

/* Where the ray crosses the unit sphere: 0, 1 or 2 distances, rising. The squared distance of the
   line from the centre is taken of the perpendicular itself: |o|^2 - (o.d)^2 would cancel. */
static int sphere_crossings(nd_ray ray, double at[2]) {
    double along = -dv_dot(ray.origin, ray.direction);
    dvec nearest = dv_add(ray.origin, dv_scale(ray.direction, along));
    double square = 1.0 - dv_dot(nearest, nearest);
    if (square < 0.0) return 0;
    double half = sqrt(square);
    int n = 0;
    if (along - half > START) at[n++] = along - half;
    if (along + half > START) at[n++] = along + half;
    return n;
}

static bool hit_sphere(nd_ray ray, nd_surface *s) {
    double at[2];
    if (!sphere_crossings(ray, at)) return false;
    s->p = dv_unit(dv_add(ray.origin, dv_scale(ray.direction, at[0])));
    s->n = s->p;
    s->t = nd_horizontal(s->n);
    s->u = 0.5 + atan2(s->p.x, s->p.z) / (2.0 * PI);
    s->v = 0.5 + atan2(s->p.y, hypot(s->p.x, s->p.z)) / PI;
    return true;
}

static bool blocks_sphere(nd_ray ray, double distance) {
    double at[2];
    return sphere_crossings(ray, at) && at[0] < distance;
}

/* Where the ray crosses the plane z = 0. */
static bool cross_plane(nd_ray ray, dvec *p, double *distance) {
    *distance = -ray.origin.z / ray.direction.z;
    if (!(*distance > START) || !isfinite(*distance)) return false;
    *p = dv_add(ray.origin, dv_scale(ray.direction, *distance));
    p->z = 0.0;
    return true;
}

static bool hit_plane(nd_ray ray, nd_surface *s) {
    double distance;
    if (!cross_plane(ray, &s->p, &distance)) return false;
    s->n = dv(0.0, 0.0, 1.0);
    s->t = dv(1.0, 0.0, 0.0);
    s->u = 0.5 + 0.5 * s->p.x;
    s->v = 0.5 + 0.5 * s->p.y;
    return fabs(s->p.x) <= 1.0 && fabs(s->p.y) <= 1.0;
}

static bool blocks_plane(nd_ray ray, double distance) {
    double at;
    dvec p;
    return cross_plane(ray, &p, &at) && at < distance && fabs(p.x) <= 1.0 && fabs(p.y) <= 1.0;
}

/* Turned on a lathe: the grooves are circles, and the tangent is along them. */
static bool hit_disc(nd_ray ray, nd_surface *s) {
    double distance;
    if (!cross_plane(ray, &s->p, &distance)) return false;
    double r = hypot(s->p.x, s->p.y);
    s->n = dv(0.0, 0.0, 1.0);
    s->t = r > 0.0 ? dv(-s->p.y / r, s->p.x / r, 0.0) : dv(1.0, 0.0, 0.0);
    s->u = 0.5 + atan2(s->p.y, s->p.x) / (2.0 * PI);
    s->v = r;
    return r <= 1.0;
}

static bool blocks_disc(nd_ray ray, double distance) {
    double at;
    dvec p;
    return cross_plane(ray, &p, &at) && at < distance && hypot(p.x, p.y) <= 1.0;
}

const nd_shape *nd_shape_find(const char *name) {
    static const nd_shape shapes[] = {
        {"sphere", 1.0, hit_sphere, blocks_sphere},
        {"plane", 1.4142135623730951, hit_plane, blocks_plane},
        {"disc", 1.0, hit_disc, blocks_disc},
    };
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        if (strcmp(shapes[i].name, name) == 0) return &shapes[i];
    return NULL;
}
