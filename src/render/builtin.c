/* SPDX-License-Identifier: Apache-2.0 */
/* Surfaces turned about the y axis. A profile is a row of arcs and lines in the half plane (r, y),
   each smooth in itself; where two of them meet there is an edge unless they share their normal.
   On a turned surface u runs once around, u = 0.5 facing +z, and t is along +u; v rises along each
   piece of the profile. */
#include "render/builtin.h"

#include "base/error.h"

#include <math.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

enum { AROUND = 192 }; /* steps around: chords deviate 1.3e-4 radii from the circle */

/* An arc about (r, y) from angle `from` to `to` (radians, 0 along +r, rising towards +y), or, with
   radius 0, a line from (r, y) to (from, to). side: 1 when the outside is away from the centre of
   the arc, or to the right of the line; else -1. */
typedef struct {
    int part, steps;
    double r, y, radius, from, to, side;
} piece;

typedef struct { double r, y, nr, ny; } profile_point;

static profile_point point_on(const piece *p, double x) {
    if (p->radius > 0.0) {
        double a = p->from + (p->to - p->from) * x, nr = cos(a), ny = sin(a);
        return (profile_point){p->r + p->radius * nr, p->y + p->radius * ny, p->side * nr,
                               p->side * ny};
    }
    double dr = p->from - p->r, dy = p->to - p->y, length = hypot(dr, dy);
    return (profile_point){p->r + dr * x, p->y + dy * x, p->side * dy / length,
                           -p->side * dr / length};
}

static void put(float *to, double x, double y, double z) {
    to[0] = (float)x;
    to[1] = (float)y;
    to[2] = (float)z;
}

static void turn_point(nd_mesh *m, size_t vertex, profile_point p, int step, double v) {
    double u = (double)step / AROUND, phi = 2.0 * PI * (u - 0.5);
    /* Both ends of the seam are the same point, to the bit. */
    double s = step == AROUND ? 0.0 : sin(phi), c = step % AROUND ? cos(phi) : -1.0;
    if (step == 0) s = 0.0;
    double r = fabs(p.r) < 1e-12 ? 0.0 : p.r;
    put(m->position + 3 * vertex, r * s, p.y, r * c);
    put(m->normal + 3 * vertex, p.nr * s, p.ny, p.nr * c);
    put(m->tangent + 3 * vertex, c, 0.0, -s);
    m->uv[2 * vertex] = (float)u;
    m->uv[2 * vertex + 1] = (float)v;
}

static void stitch(nd_mesh *m, size_t *triangle, size_t first, int steps) {
    const uint32_t row = AROUND + 1;
    for (int i = 0; i < steps; i++)
        for (int j = 0; j < AROUND; j++) {
            uint32_t a = (uint32_t)first + (uint32_t)i * row + (uint32_t)j;
            const uint32_t corners[6] = {a, a + 1, a + row, a + 1, a + row + 1, a + row};
            memcpy(m->index + 3 * *triangle, corners, sizeof corners);
            *triangle += 2;
        }
}

/* Turns the pieces, whose parts rise from 0, into a mesh. */
static bool turn(const piece *pieces, size_t count, const char *const *parts, size_t part_count,
                 nd_mesh *m) {
    size_t rows = 0, bands = 0;
    for (size_t i = 0; i < count; i++) {
        rows += (size_t)pieces[i].steps + 1;
        bands += (size_t)pieces[i].steps;
    }
    if (!nd_mesh_new(m, rows * (AROUND + 1), bands * AROUND * 2, part_count, true)) return false;
    size_t vertex = 0, triangle = 0;
    for (size_t i = 0; i < count; i++) {
        const piece *p = &pieces[i];
        nd_part *part = &m->part[p->part];
        if (!part->mesh[0]) part->first = (uint32_t)triangle;
        strcpy(part->mesh, parts[p->part]);
        size_t first = vertex;
        for (int k = 0; k <= p->steps; k++) {
            double v = (double)k / p->steps;
            profile_point at = point_on(p, v);
            for (int j = 0; j <= AROUND; j++) turn_point(m, vertex++, at, j, v);
        }
        stitch(m, &triangle, first, p->steps);
        part->count = (uint32_t)triangle - part->first;
    }
    return true;
}

/* A ball of radius 1 at the origin with a groove around its shoulder, on a flared stand. The lips
   of the groove are rounded by circles of radius ROUND that touch the ball and the groove's wall;
   TURN is the angle, seen from the origin, between the centre of such a circle and the wall. */
static bool make_shaderball(nd_mesh *m) {
    const double degree = PI / 180.0, round = 0.03, depth = 0.08;
    const double low = 35.0 * degree, high = 46.0 * degree; /* walls of the groove */
    const double reach = 1.0 - round, turned = asin(round / reach), top = reach * cos(turned);
    const double floor = 1.0 - depth;
    const double c0 = low - turned, c1 = high + turned;
    const piece pieces[] = {
        {0, 64, 0.0, 0.0, 1.0, -70.0 * degree, c0, 1.0},
        {0, 12, reach * cos(c0), reach * sin(c0), round, c0, low + 0.5 * PI, 1.0},
        {0, 4, top * cos(low), top * sin(low), 0.0, floor * cos(low), floor * sin(low), 1.0},
        {0, 12, 0.0, 0.0, floor, low, high, 1.0},
        {0, 4, floor * cos(high), floor * sin(high), 0.0, top * cos(high), top * sin(high), 1.0},
        {0, 12, reach * cos(c1), reach * sin(c1), round, high - 0.5 * PI, c1, 1.0},
        {0, 32, 0.0, 0.0, 1.0, c1, 0.5 * PI, 1.0},
        {1, 4, 0.52, -0.75, 0.0, 0.52, -0.9, -1.0},
        {1, 24, 0.92, -0.9, 0.4, PI, 1.5 * PI, -1.0},
        {1, 16, 0.92, -1.34, 0.04, 0.5 * PI, -0.5 * PI, 1.0},
        {1, 8, 0.92, -1.38, 0.0, 0.0, -1.38, -1.0},
    };
    static const char *const parts[] = {"ball", "stand"};
    return turn(pieces, sizeof pieces / sizeof *pieces, parts, 2, m);
}

static const struct {
    const char *name;
    bool (*make)(nd_mesh *m);
} builtins[] = {{"shaderball", make_shaderball}};

bool nd_builtin_is(const char *name) {
    for (size_t i = 0; i < sizeof builtins / sizeof *builtins; i++)
        if (strcmp(builtins[i].name, name) == 0) return true;
    return false;
}

bool nd_builtin_mesh(const char *name, nd_mesh *m, ndl_error *error) {
    for (size_t i = 0; i < sizeof builtins / sizeof *builtins; i++)
        if (strcmp(builtins[i].name, name) == 0 && builtins[i].make(m)) return true;
    return nd_fail(error, NDL_E_MEMORY, 0, "out of memory", NULL);
}
