/* SPDX-License-Identifier: Apache-2.0 */
/* Law `continuity`: brdf_cos as a function of wi, wo fixed above the horizon, has no jump; at the
   horizon of wi it goes to 0, the value below. Along an arc of wi the interval with the largest
   step is cut finer and finer: a step that does not shrink is a jump. */
#include "directions.h"

#ifndef LAW_VECTORS
#define LAW_VECTORS 16
#endif
/* 128 intervals, cut three times: 1e-6 rad, far below the narrowest lobe, alpha = 1e-3. */
enum { SAMPLES = 129, CUTS = 3, ARCS = 4 };
/* Over the last interval the flank of that lobe at FLANK of its peak changes by some 3 %. */
static const double JUMP = 0.1;
/* Smaller shares of the value in the mirror direction lie on a flank that is steeper still. */
static const double FLANK = 1e-5;
/* V NoL of the slowest model, ward92, goes like sqrt(wi.z): 3e-5 at 1e-9. */
static const double AT_HORIZON = 1e-3;

typedef struct { double polar, phi, turn; } arc; /* phi + turn t: azimuth; t: polar angle */

static void fill_arc(const arc *a, double t0, double t1, pairs *p, const float wo[3]) {
    for (size_t i = 0; i < SAMPLES; i++) {
        double t = t0 + (t1 - t0) * (double)i / (SAMPLES - 1);
        float wi[3];
        direction_at(cos(a->polar * t), a->phi + a->turn * t, wi);
        for (int k = 0; k < 3; k++) {
            p->wi[k][i] = wi[k];
            p->wo[k][i] = wo[k];
        }
    }
}

/* The largest step between neighbours and where it is; the largest value in *peak. */
static double largest_step(const pairs *p, size_t *at, double *peak) {
    double step = 0.0;
    for (size_t i = 0; i < SAMPLES; i++) {
        double f = (double)p->rgb[1][i];
        *peak = fmax(*peak, f);
        if (i + 1 < SAMPLES && fabs((double)p->rgb[1][i + 1] - f) > step) {
            step = fabs((double)p->rgb[1][i + 1] - f);
            *at = i;
        }
    }
    return step;
}

static void try_arc(const ndl_material *m, const arc *a, const float wo[3]) {
    static pairs p;
    ndl_vec3 mirror = {-wo[0], -wo[1], wo[2]}, view = {wo[0], wo[1], wo[2]};
    double t0 = 0.0, t1 = 1.0, step = 0.0;
    double peak = FLANK * (double)ndl_brdf_cos(m, mirror, view).g;
    size_t at = 0;
    for (int k = 0; k < CUTS; k++) {
        fill_arc(a, t0, t1, &p, wo);
        ndl_brdf_cos_n(m, SAMPLES, wi_of(&p), wo_of(&p), rgb_of(&p));
        step = largest_step(&p, &at, &peak);
        double width = (t1 - t0) / (SAMPLES - 1);
        t0 += width * (double)at;
        t1 = t0 + width;
    }
    if (step > JUMP * peak) broken(m, " --cos", &p, at, "a jump from here to the next", step);
}

static void try_horizon(const ndl_material *m, double phi, const float wo[3]) {
    static pairs p;
    double peak = 0.0;
    for (size_t i = 0; i < SAMPLES; i++) { /* from 1e-9 above the horizon to the normal */
        float wi[3];
        direction_at(pow(10.0, -9.0 + 9.0 * (double)i / (SAMPLES - 1)), phi, wi);
        for (int k = 0; k < 3; k++) {
            p.wi[k][i] = wi[k];
            p.wo[k][i] = wo[k];
        }
    }
    ndl_brdf_cos_n(m, SAMPLES, wi_of(&p), wo_of(&p), rgb_of(&p));
    for (size_t i = 0; i < SAMPLES; i++) peak = fmax(peak, (double)p.rgb[1][i]);
    double low = (double)p.rgb[1][0];
    if (low > AT_HORIZON * peak) broken(m, " --cos", &p, 0, "not 0 at the horizon of wi", low);
}

static void the_value_times_the_cosine_has_no_jump(void **state) {
    size_t model = model_of(state), tried = 0;
    int axes, all = combinations(model, &axes);
    draws d = draws_of(model + 200);
    for (int c = 0; c < all; c++) {
        for (unsigned i = 0; i < LAW_VECTORS; i++) {
            ndl_material *m = vector_material(model, c, i, true);
            bool claimed = ndl_material_claims(m) & NDL_CLAIM_CONTINUITY;
            for (int k = 0; claimed && k < ARCS; k++) {
                float wo[3];
                direction_at(0.05 + 0.95 * draw(&d), TURN * draw(&d), wo);
                arc a = {1.6, TURN * draw(&d), draw(&d)};
                if (k == 0) a = (arc){1.6, 0.5 * TURN + atan2((double)wo[1], (double)wo[0]), 0.0};
                try_arc(m, &a, wo);
                try_horizon(m, a.phi, wo);
            }
            tried += claimed;
            ndl_material_free(m);
        }
    }
    print_message("%zu materials claim it, %d arcs each\n", tried, ARCS);
}

int main(void) {
    return run_over_models("continuity", the_value_times_the_cosine_has_no_jump);
}
