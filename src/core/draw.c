/* SPDX-License-Identifier: Apache-2.0 */
/* Drawing directions for a material. A sum is a mixture: u.z chooses a lobe, which draws; the
   density is the mean of the lobes' by their chances, the weight the whole sum over it. */
#include "core/draw.h"

#include "core/eval.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const float BELOW_ONE = 0x1.fffffep-1f;

static int sampler_of(const nd_lobe *l) {
    static const unsigned char of_kernel[ND_KERNELS] = {
#define K(model, name, traits) [ND_KERNEL_##name] = ND_SAMPLER_##model,
#define MODEL(name, NAME) NAME##_KERNELS(K)
#define COMPOSED(name, NAME, ndf)
#include "core/models.def"
#undef K
#undef MODEL
#undef COMPOSED
    };
    static const unsigned char of_ndf[ND_NDFS] = {
#define T(ndf) [ND_NDF_IS_##ndf] = ND_SAMPLER_microfacet_##ndf,
        NDF_LIST(T)
#undef T
    };
    return l->model->ndf != ND_NO_FACET ? of_ndf[l->facet.ndf] : of_kernel[l->kernel];
}

/* ---- a tile of whole groups ------------------------------------------------------------------ */

/* At most ND_TILE lanes, n a multiple of ND_MOST_GROUP. */
typedef struct {
    size_t n;
    const float *wo[3], *u[3];
    float *wi[3], *weight[3], *pdf;
} tile;

typedef struct {
    float x[3][ND_TILE];
} vectors;

static void sample_lobe(const nd_lobe *l, const tile *t) {
    nd_batch q = {t->n,
                  {t->u[0], t->u[1], t->u[2]},
                  {t->wo[0], t->wo[1], t->wo[2]},
                  {t->wi[0], t->wi[1], t->wi[2]}};
    nd_draws()->sample[sampler_of(l)]((nd_inputs){l->fields, NULL}, &q);
}

static void lobe_pdf(const nd_lobe *l, const nd_batch *pairs, float *pdf) {
    nd_batch q = *pairs;
    q.out[0] = pdf;
    nd_draws()->pdf[sampler_of(l)]((nd_inputs){l->fields, NULL}, &q);
}

float nd_lobe_share(const nd_lobe *l, float wo_z) {
    float m = 1.0f - wo_z, m2 = m * m;
    return l->share[0] + l->share[1] * (m2 * m2 * m);
}

static void total_shares(const ndl_material *m, size_t n, const float *wo_z, float *total) {
    memset(total, 0, n * sizeof *total);
    for (size_t at = 0; at < m->count; at++)
        for (size_t i = 0; i < n; i++)
            total[i] += nd_lobe_share(&m->lobes[at], wo_z[i]);
}

/* The density of pairs (their out is not used), whole groups of them; pdf may be one of the
   inputs. */
static void pairs_pdf(const ndl_material *m, const nd_batch *pairs, float *pdf) {
    if (m->count == 1) {
        lobe_pdf(&m->lobes[0], pairs, pdf);
        return;
    }
    float total[ND_TILE], one[ND_TILE], sum[ND_TILE];
    total_shares(m, pairs->n, pairs->wo[2], total);
    memset(sum, 0, sizeof sum);
    for (size_t at = 0; at < m->count; at++) {
        const nd_lobe *l = &m->lobes[at];
        lobe_pdf(l, pairs, one);
        for (size_t i = 0; i < pairs->n; i++)
            sum[i] += nd_lobe_share(l, pairs->wo[2][i]) / total[i] * one[i];
    }
    for (size_t i = 0; i < pairs->n; i++)
        pdf[i] = sum[i] < FLT_MAX ? sum[i] : FLT_MAX;
}

/* The lobe that u_z falls on, and what is left of u_z there, in [0, 1) again. */
static size_t chosen_lobe(const ndl_material *m, float total, float wo_z, float u_z, float *rest) {
    size_t last = 0;
    float begin = 0.0f, begin_of_last = 0.0f, chance_of_last = 1.0f;
    for (size_t at = 0; at < m->count; at++) {
        float chance = nd_lobe_share(&m->lobes[at], wo_z) / total;
        if (!(chance > 0.0f)) continue;
        last = at;
        begin_of_last = begin;
        chance_of_last = chance;
        begin += chance;
        if (u_z < begin) break;
    }
    /* Chances may add up to a little less than 1: what is beyond them belongs to the last lobe. */
    float x = (u_z - begin_of_last) / chance_of_last;
    *rest = x > 0.0f ? (x < BELOW_ONE ? x : BELOW_ONE) : 0.0f;
    return last;
}

/* Lanes lane[0..n) of a tile, drawn from one lobe together. */
static void sample_lanes(const nd_lobe *l, const tile *t, const float *rest, const size_t *lane,
                         size_t n) {
    vectors wo, u, wi;
    tile some = {(n + ND_MOST_GROUP - 1) / ND_MOST_GROUP * ND_MOST_GROUP,
                 {wo.x[0], wo.x[1], wo.x[2]},
                 {u.x[0], u.x[1], u.x[2]},
                 {wi.x[0], wi.x[1], wi.x[2]},
                 {NULL, NULL, NULL},
                 NULL};
    for (size_t i = 0; i < some.n; i++) {
        size_t from = lane[i < n ? i : n - 1];
        for (int c = 0; c < 3; c++) {
            wo.x[c][i] = t->wo[c][from];
            u.x[c][i] = c < 2 ? t->u[c][from] : rest[from];
        }
    }
    sample_lobe(l, &some);
    for (size_t i = 0; i < n; i++)
        for (int c = 0; c < 3; c++)
            t->wi[c][lane[i]] = wi.x[c][i];
}

static void sample_sum(const ndl_material *m, const tile *t) {
    float total[ND_TILE], rest[ND_TILE];
    size_t lobe[ND_TILE], lane[ND_TILE];
    total_shares(m, t->n, t->wo[2], total);
    for (size_t i = 0; i < t->n; i++)
        lobe[i] = chosen_lobe(m, total[i], t->wo[2][i], t->u[2][i], &rest[i]);
    for (size_t at = 0; at < m->count; at++) {
        size_t n = 0;
        for (size_t i = 0; i < t->n; i++)
            if (lobe[i] == at) lane[n++] = i;
        if (n) sample_lanes(&m->lobes[at], t, rest, lane, n);
    }
}

/* f cos in, f cos/pdf out. */
static void divide(const tile *t) {
    nd_batch q = {
        t->n, {t->pdf, NULL, NULL}, {NULL, NULL, NULL}, {t->weight[0], t->weight[1], t->weight[2]}};
    nd_draws()->weigh((nd_inputs){NULL, NULL}, &q);
}

static nd_batch pairs_of(const tile *t) {
    return (nd_batch){t->n,
                      {t->wi[0], t->wi[1], t->wi[2]},
                      {t->wo[0], t->wo[1], t->wo[2]},
                      {t->weight[0], t->weight[1], t->weight[2]}};
}

static void draw_tile(const ndl_material *m, const tile *t) {
    if (m->count == 1)
        sample_lobe(&m->lobes[0], t);
    else
        sample_sum(m, t);
    nd_batch pairs = pairs_of(t);
    pairs_pdf(m, &pairs, t->pdf);
    ndl_brdf_cos_n(m, t->n, (ndl_vec3_n){t->wi[0], t->wi[1], t->wi[2]},
                   (ndl_vec3_n){t->wo[0], t->wo[1], t->wo[2]},
                   (ndl_rgb_n){t->weight[0], t->weight[1], t->weight[2]});
    divide(t);
}

/* ---- batches --------------------------------------------------------------------------------- */

static size_t lanes_of_tile(size_t n, size_t at) {
    return n - at < ND_TILE ? n - at : ND_TILE;
}

/* n values, the last one repeated up to whole groups. */
static size_t fill_groups(float *to, const float *from, size_t n) {
    size_t whole = (n + ND_MOST_GROUP - 1) / ND_MOST_GROUP * ND_MOST_GROUP;
    memcpy(to, from, n * sizeof *to);
    for (size_t i = n; i < whole; i++)
        to[i] = to[n - 1];
    return whole;
}

static void draw_rest(const ndl_material *m, const tile *t) {
    vectors wo, u, wi, weight;
    float pdf[ND_TILE];
    tile full = {0};
    for (int c = 0; c < 3; c++) {
        full.n = fill_groups(wo.x[c], t->wo[c], t->n);
        fill_groups(u.x[c], t->u[c], t->n);
        full.wo[c] = wo.x[c];
        full.u[c] = u.x[c];
        full.wi[c] = wi.x[c];
        full.weight[c] = weight.x[c];
    }
    full.pdf = pdf;
    draw_tile(m, &full);
    for (int c = 0; c < 3; c++) {
        memcpy(t->wi[c], wi.x[c], t->n * sizeof(float));
        memcpy(t->weight[c], weight.x[c], t->n * sizeof(float));
    }
    memcpy(t->pdf, pdf, t->n * sizeof(float));
}

void ndl_draw_n(const ndl_material *m, size_t n, ndl_vec3_n wo, ndl_vec3_n u, ndl_vec3_out wi,
                ndl_rgb_n weight, float *pdf) {
    for (size_t at = 0; at < n; at += ND_TILE) {
        tile t = {lanes_of_tile(n, at),
                  {wo.x + at, wo.y + at, wo.z + at},
                  {u.x + at, u.y + at, u.z + at},
                  {wi.x + at, wi.y + at, wi.z + at},
                  {weight.r + at, weight.g + at, weight.b + at},
                  pdf + at};
        if (t.n % ND_MOST_GROUP)
            draw_rest(m, &t);
        else
            draw_tile(m, &t);
    }
}

ndl_sample ndl_draw(const ndl_material *m, ndl_vec3 wo, ndl_vec3 u) {
    ndl_sample s;
    ndl_draw_n(m, 1, (ndl_vec3_n){&wo.x, &wo.y, &wo.z}, (ndl_vec3_n){&u.x, &u.y, &u.z},
               (ndl_vec3_out){&s.wi.x, &s.wi.y, &s.wi.z},
               (ndl_rgb_n){&s.weight.r, &s.weight.g, &s.weight.b}, &s.pdf);
    return s;
}

static void pdf_rest(const ndl_material *m, const nd_batch *q, float *pdf) {
    vectors wi, wo;
    float out[ND_TILE];
    nd_batch full = *q;
    for (int c = 0; c < 3; c++) {
        full.n = fill_groups(wi.x[c], q->wi[c], q->n);
        fill_groups(wo.x[c], q->wo[c], q->n);
        full.wi[c] = wi.x[c];
        full.wo[c] = wo.x[c];
    }
    pairs_pdf(m, &full, out);
    memcpy(pdf, out, q->n * sizeof *pdf);
}

void ndl_pdf_n(const ndl_material *m, size_t n, ndl_vec3_n wi, ndl_vec3_n wo, float *pdf) {
    for (size_t at = 0; at < n; at += ND_TILE) {
        nd_batch q = {lanes_of_tile(n, at),
                      {wi.x + at, wi.y + at, wi.z + at},
                      {wo.x + at, wo.y + at, wo.z + at},
                      {NULL, NULL, NULL}};
        if (q.n % ND_MOST_GROUP)
            pdf_rest(m, &q, pdf + at);
        else
            pairs_pdf(m, &q, pdf + at);
    }
}

float ndl_pdf(const ndl_material *m, ndl_vec3 wi, ndl_vec3 wo) {
    float pdf;
    ndl_pdf_n(m, 1, (ndl_vec3_n){&wi.x, &wi.y, &wi.z}, (ndl_vec3_n){&wo.x, &wo.y, &wo.z}, &pdf);
    return pdf;
}

void ndl_brdf_cos_pdf_n(const ndl_material *m, size_t n, ndl_vec3_n wi, ndl_vec3_n wo,
                        ndl_rgb_n rgb, float *pdf) {
    ndl_pdf_n(m, n, wi, wo, pdf);
    ndl_brdf_cos_n(m, n, wi, wo, rgb);
}

ndl_rgb ndl_brdf_cos_pdf(const ndl_material *m, ndl_vec3 wi, ndl_vec3 wo, float *pdf) {
    *pdf = ndl_pdf(m, wi, wo);
    return ndl_brdf_cos(m, wi, wo);
}

/* ---- how often a lobe of a sum is drawn ------------------------------------------------------ */

enum { TRIALS = 64 };

/* Trial k of the R2 sequence, whose steps are powers of the root of x^3 = x + 1, and a viewer at
   wo_z that turns with it, so that anisotropic lobes are seen from all sides. */
static void set_trial(int k, float wo_z, vectors *wo, vectors *u) {
    double whole;
    float turn = (float)modf(0.6180339887498949 * (k + 0.5), &whole);
    float sine = sqrtf((1.0f - wo_z) * (1.0f + wo_z));
    wo->x[0][k] = sine * cos2pi_(turn);
    wo->x[1][k] = sine * sin2pi_(turn);
    wo->x[2][k] = wo_z;
    u->x[0][k] = (float)modf(0.7548776662466927 * (k + 0.5), &whole);
    u->x[1][k] = (float)modf(0.5698402909980532 * (k + 0.5), &whole);
    u->x[2][k] = ((float)k + 0.5f) / TRIALS;
}

/* The mean of the channels of a lobe's weighted albedo, roughly, by its own sampler. */
static double rough_albedo(const nd_lobe *l, float wo_z) {
    vectors wo, u, wi, weight;
    float pdf[ND_TILE];
    for (int k = 0; k < TRIALS; k++)
        set_trial(k, wo_z, &wo, &u);
    tile t = {TRIALS,
              {wo.x[0], wo.x[1], wo.x[2]},
              {u.x[0], u.x[1], u.x[2]},
              {wi.x[0], wi.x[1], wi.x[2]},
              {weight.x[0], weight.x[1], weight.x[2]},
              pdf};
    sample_lobe(l, &t);
    nd_batch pairs = pairs_of(&t);
    lobe_pdf(l, &pairs, pdf);
    nd_lobe_values(nd_kernels(), l, true, &pairs);
    divide(&t);
    double sum = 0.0;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < TRIALS; k++)
            sum += (double)l->weight[c] * (double)weight.x[c][k];
    return sum / (3.0 * TRIALS);
}

static double mean_weight(const nd_lobe *l) {
    return ((double)l->weight[0] + (double)l->weight[1] + (double)l->weight[2]) / 3.0;
}

/* The share of a lobe: Schlick's curve through its albedos at wo.z = .9 and .1, each within a
   factor of 64 of its weight; in units of the largest weight. */
static void set_share(nd_lobe *l, double largest) {
    double w = mean_weight(l), low = rough_albedo(l, 0.9f), high = rough_albedo(l, 0.1f);
    double straight = fmin(fmax(low, w / 64.0), 64.0 * w);
    double grazing = fmin(fmax(high - straight, 0.0) / 0.59049, 64.0 * w); /* (1 - .1)^5 */
    l->share[0] = w > 0.0 ? (float)fmax(straight / largest, 1e-6) : 0.0f;
    l->share[1] = (float)(grazing / largest);
}

void nd_share_draws(ndl_material *m) {
    double largest = 0.0;
    for (size_t i = 0; i < m->count; i++)
        largest = fmax(largest, mean_weight(&m->lobes[i]));
    for (size_t i = 0; i < m->count; i++) {
        m->lobes[i].share[0] = 1.0f;
        if (m->count > 1 && largest > 0.0) set_share(&m->lobes[i], largest);
    }
}
