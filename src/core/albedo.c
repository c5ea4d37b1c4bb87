/* SPDX-License-Identifier: Apache-2.0 */
/* Directional albedo by adaptive quadrature.

   The hemisphere of wi is cut into rectangles of polar angle and azimuth, so that the horizon,
   where many integrands end, is an edge. A rectangle that a narrow highlight crosses is halved
   until the highlight is resolved (its half vectors span few widths of the lobe), whatever the
   quadrature says: an unseen peak has no error estimate. After that the rectangle with the largest
   estimated error is halved, along the axis where the error is, until the sum is small enough.
   Rule: tensor products of Kronrod's 15 points, with Gauss's 7 among them as the estimate
   (Piessens et al., QUADPACK, 1983). */
#include "core/eval.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double TWO_PI = 6.283185307179586477, HALF_PI = 1.570796326794896619;
static const float DEFAULT_TOLERANCE = 1e-5f;
/* 225 values each: 6 million in all, some 20 ms in the widest kernels, then the error is stated. */
enum { POINTS = 15, MOST_CELLS = 24000, FIRST_ROOM = 1024 };

static const double NODE[POINTS] = {
    -0.991455371120812639206854697526, -0.949107912342758524526189684048,
    -0.864864423359769072789712788641, -0.741531185599394439863864773281,
    -0.586087235467691130294144691694, -0.405845151377397166906606412077,
    -0.207784955007898467600689403773, 0.0,
    0.207784955007898467600689403773,  0.405845151377397166906606412077,
    0.586087235467691130294144691694,  0.741531185599394439863864773281,
    0.864864423359769072789712788641,  0.949107912342758524526189684048,
    0.991455371120812639206854697526};
static const double KRONROD[POINTS] = {
    0.022935322010529224963732008059, 0.063092092629978553290700663189,
    0.104790010322250183839876322542, 0.140653259715525918745189590510,
    0.169004726639267902826583426599, 0.190350578064785409913256402421,
    0.204432940075298892414161999235, 0.209482141084727828012999174892,
    0.204432940075298892414161999235, 0.190350578064785409913256402421,
    0.169004726639267902826583426599, 0.140653259715525918745189590510,
    0.104790010322250183839876322542, 0.063092092629978553290700663189,
    0.022935322010529224963732008059};
/* Weights of Gauss's rule at the odd nodes. */
static const double GAUSS[POINTS] = {
    0, 0.129484966168869693270611432679, 0, 0.279705391489276667901467771424,
    0, 0.381830050505118944950369775489, 0, 0.417959183673469387755102040816,
    0, 0.381830050505118944950369775489, 0, 0.279705391489276667901467771424,
    0, 0.129484966168869693270611432679, 0};

/* theta in [t0, t1], phi in [p0, p1]. */
typedef struct {
    double t0, t1, p0, p1;
    double value[3], error;
    bool halve_theta; /* where most of the error is */
} cell;

typedef struct {
    const nd_kernel_table *kernels;
    const nd_lobe *lobe;
    ndl_vec3 wo;
    double width[2]; /* of the lobe, as slopes of the half vector along t and b */
    cell *heap;      /* the largest error on top */
    int count, room;
    bool no_memory;
} integral;

/* ---- one cell -------------------------------------------------------------------------------- */

static void evaluate(const integral *in, const cell *c, float f[3][POINTS * POINTS],
                     double sines[POINTS]) {
    float x[POINTS * POINTS], y[POINTS * POINTS], z[POINTS * POINTS];
    float ox[POINTS * POINTS], oy[POINTS * POINTS], oz[POINTS * POINTS];
    for (int j = 0; j < POINTS; j++) {
        double theta = 0.5 * (c->t0 + c->t1) + 0.5 * (c->t1 - c->t0) * NODE[j];
        sines[j] = sin(theta);
        double cosine = cos(theta);
        for (int i = 0; i < POINTS; i++) {
            double phi = 0.5 * (c->p0 + c->p1) + 0.5 * (c->p1 - c->p0) * NODE[i];
            int k = POINTS * j + i;
            x[k] = (float)(sines[j] * cos(phi));
            y[k] = (float)(sines[j] * sin(phi));
            z[k] = (float)cosine;
            ox[k] = in->wo.x;
            oy[k] = in->wo.y;
            oz[k] = in->wo.z;
        }
    }
    nd_batch q = {POINTS * POINTS, {x, y, z}, {ox, oy, oz}, {f[0], f[1], f[2]}};
    nd_lobe_values(in->kernels, in->lobe, true, &q);
}

static void integrate(const integral *in, cell *c) {
    float f[3][POINTS * POINTS];
    double sines[POINTS];
    evaluate(in, c, f, sines);
    double area = 0.25 * (c->t1 - c->t0) * (c->p1 - c->p0), by_theta = 0.0, by_phi = 0.0;
    for (int k = 0; k < 3; k++) {
        double fine = 0.0, coarse_theta = 0.0, coarse_phi = 0.0;
        for (int j = 0; j < POINTS; j++) {
            double row = 0.0, coarse_row = 0.0;
            for (int i = 0; i < POINTS; i++) {
                row += KRONROD[i] * (double)f[k][POINTS * j + i];
                coarse_row += GAUSS[i] * (double)f[k][POINTS * j + i];
            }
            fine += KRONROD[j] * sines[j] * row;
            coarse_theta += GAUSS[j] * sines[j] * row;
            coarse_phi += KRONROD[j] * sines[j] * coarse_row;
        }
        c->value[k] = area * fine;
        by_theta = fmax(by_theta, area * fabs(fine - coarse_theta));
        by_phi = fmax(by_phi, area * fabs(fine - coarse_phi));
    }
    c->error = by_theta + by_phi;
    c->halve_theta = by_theta >= by_phi;
}

/* ---- where a narrow highlight is ------------------------------------------------------------- */

/* The slopes of the half vector of wi(theta, phi) and wo, in widths of the lobe. */
static void scaled_slopes(const integral *in, double theta, double phi, double s[2]) {
    double hz = fmax(cos(theta) + (double)in->wo.z, 1e-6);
    s[0] = (sin(theta) * cos(phi) + (double)in->wo.x) / (hz * in->width[0]);
    s[1] = (sin(theta) * sin(phi) + (double)in->wo.y) / (hz * in->width[1]);
}

/* How far the slopes move along one axis of the cell, at its middle and its ends. */
static double span(const integral *in, const cell *c, bool along_theta) {
    double most = 0.0;
    for (int i = 0; i <= 2; i++) {
        double a[2], b[2], t = c->t0 + 0.5 * i * (c->t1 - c->t0),
                           p = c->p0 + 0.5 * i * (c->p1 - c->p0);
        scaled_slopes(in, along_theta ? c->t0 : t, along_theta ? p : c->p0, a);
        scaled_slopes(in, along_theta ? c->t1 : t, along_theta ? p : c->p1, b);
        most = fmax(most, hypot(a[0] - b[0], a[1] - b[1]));
    }
    return most;
}

/* Whether the highlight's core may cross a cell that does not resolve it yet. */
static bool unresolved(const integral *in, const cell *c, bool *halve_theta) {
    double s[2], theta = span(in, c, true), phi = span(in, c, false);
    scaled_slopes(in, 0.5 * (c->t0 + c->t1), 0.5 * (c->p0 + c->p1), s);
    *halve_theta = theta >= phi;
    bool coarse = fmax(theta, phi) > 4.0;
    bool near = hypot(s[0], s[1]) < 4.0 + theta + phi;
    bool can_halve = fmax(c->t1 - c->t0, c->p1 - c->p0) > 1e-6;
    return coarse && near && can_halve;
}

/* ---- the heap -------------------------------------------------------------------------------- */

static void push(integral *in, const cell *c) {
    if (in->count == in->room) {
        int room = in->room ? 2 * in->room : FIRST_ROOM;
        cell *heap = realloc(in->heap, (size_t)room * sizeof *heap);
        if (!heap) {
            in->no_memory = true;
            return;
        }
        in->heap = heap;
        in->room = room;
    }
    int at = in->count++;
    for (; at && in->heap[(at - 1) / 2].error < c->error; at = (at - 1) / 2)
        in->heap[at] = in->heap[(at - 1) / 2];
    in->heap[at] = *c;
}

static cell pop(integral *in) {
    cell top = in->heap[0], last = in->heap[--in->count];
    int at = 0;
    for (int child; (child = 2 * at + 1) < in->count; at = child) {
        if (child + 1 < in->count && in->heap[child + 1].error > in->heap[child].error) child++;
        if (in->heap[child].error <= last.error) break;
        in->heap[at] = in->heap[child];
    }
    in->heap[at] = last;
    return top;
}

static void halves(const cell *c, bool theta, cell half[2]) {
    half[0] = half[1] = *c;
    double *end = theta ? &half[0].t1 : &half[0].p1, *start = theta ? &half[1].t0 : &half[1].p0;
    *end = *start = theta ? 0.5 * (c->t0 + c->t1) : 0.5 * (c->p0 + c->p1);
}

/* Depth is bounded by the cell size in unresolved(): some 22 halvings of either axis. */
static void seed(integral *in, cell c) {
    bool theta;
    if (in->count < MOST_CELLS / 2 && !in->no_memory && unresolved(in, &c, &theta)) {
        cell half[2];
        halves(&c, theta, half);
        seed(in, half[0]);
        seed(in, half[1]);
        return;
    }
    integrate(in, &c);
    push(in, &c);
}

static double total_error(const integral *in) {
    double sum = 0.0;
    for (int i = 0; i < in->count; i++) sum += in->heap[i].error;
    return sum;
}

static void refine(integral *in, double tolerance) {
    double error = total_error(in);
    while (error > tolerance && in->count < MOST_CELLS && !in->no_memory) {
        cell top = pop(in), half[2];
        error -= top.error;
        halves(&top, top.halve_theta, half);
        for (int i = 0; i < 2; i++) {
            integrate(in, &half[i]);
            push(in, &half[i]);
            error += half[i].error;
        }
    }
}

/* The integral of one lobe's brdf_cos over wi; returns the estimated error. */
static double lobe_albedo(const nd_lobe *l, ndl_vec3 wo, double tolerance, double value[3]) {
    integral in = {.kernels = nd_kernels(), .lobe = l, .wo = wo};
    nd_lobe_widths(l, in.width);
    double mirror = atan2(-(double)wo.y, -(double)wo.x), theta = acos(fmin((double)wo.z, 1.0));
    double polar[] = {0.0, theta, HALF_PI};
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++)
            if (polar[i + 1] > polar[i])
                seed(&in, (cell){.t0 = polar[i], .t1 = polar[i + 1],
                                 .p0 = mirror + 0.25 * k * TWO_PI,
                                 .p1 = mirror + 0.25 * (k + 1) * TWO_PI});
    refine(&in, tolerance);
    double error = in.no_memory ? (double)FLT_MAX : total_error(&in);
    value[0] = value[1] = value[2] = 0.0;
    for (int i = 0; i < in.count; i++)
        for (int k = 0; k < 3; k++) value[k] += in.heap[i].value[k];
    free(in.heap);
    return error;
}

ndl_rgb ndl_albedo(const ndl_material *m, ndl_vec3 wo, float tolerance, float *error) {
    double sum[3] = {0.0, 0.0, 0.0}, sum_error = 0.0;
    if (!(tolerance > 0.0f)) tolerance = DEFAULT_TOLERANCE;
    for (size_t i = 0; wo.z > 0.0f && i < m->count; i++) {
        const float *w = m->lobes[i].weight;
        double value[3], most = fmax((double)w[0], fmax((double)w[1], (double)w[2]));
        if (most == 0.0) continue;
        double share = (double)tolerance / ((double)m->count * most);
        sum_error += most * lobe_albedo(&m->lobes[i], wo, share, value);
        for (int k = 0; k < 3; k++) sum[k] += (double)w[k] * value[k];
    }
    if (error) *error = (float)fmin(sum_error, (double)FLT_MAX);
    return (ndl_rgb){(float)fmin(sum[0], (double)FLT_MAX), (float)fmin(sum[1], (double)FLT_MAX),
                     (float)fmin(sum[2], (double)FLT_MAX)};
}
