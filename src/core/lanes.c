/* SPDX-License-Identifier: Apache-2.0 */
/* Parameters per lane: from keys and arrays to the streams that kernels read. A lane means what
   ndl_material_with() means for each value. */
#include "core/lanes.h"

#include "base/error.h"
#include "core/spellings.h"
#include "shade/convert.h"

#include <string.h>

/* One lane of one lobe. */
typedef struct {
    char key[64];
    int param, channel; /* of the model's table; -1: all channels */
    bool degrees;
    const float *values;
} lane_use;

static bool lane_of(const ndl_material *m, const ndl_lanes *lane, size_t *lobe, lane_use *use) {
    if (!lane->key || !nd_parameter_path(lane->key, lobe, use->key, sizeof use->key, &use->channel))
        return false;
    if (*lobe >= m->count) return false;
    use->param = nd_key(m->lobes[*lobe].model->schema(), use->key, &use->degrees);
    use->values = lane->values;
    if (use->param < 0) return false;
    const ndl_param *p = &m->lobes[*lobe].model->schema()->params[use->param];
    bool color = p->kind == NDL_KIND_COLOR;
    return color || (p->kind == NDL_KIND_NUMBER && use->channel < 0);
}

static bool is(const lane_use *use, const char *key) {
    return strcmp(use->key, key) == 0;
}

/* Whether the formula of the lobe looks at the quantity at all. */
static bool used_by(const nd_lobe *l, const lane_use *use) {
    if (l->model->ndf == ND_NO_FACET) return true;
    int f = l->facet.fresnel;
    if (is(use, "f0"))
        return f == ND_FRESNEL_IS_none || f == ND_FRESNEL_IS_schlick ||
               f == ND_FRESNEL_IS_cook_torrance;
    if (is(use, "ior")) return f == ND_FRESNEL_IS_dielectric;
    if (is(use, "eta") || is(use, "k")) return f == ND_FRESNEL_IS_conductor;
    bool stretches = is(use, "anisotropy") || is(use, "alpha_x") || is(use, "alpha_y");
    return !(stretches && l->facet.ndf == ND_NDF_IS_blinn);
}

/* Two lanes that no material could have at once. */
static bool exclude(const lane_use *a, const lane_use *b) {
    static const char *const pairs[][2] = {{"alpha", "roughness"},    {"alpha", "alpha_x"},
                                           {"alpha", "alpha_y"},      {"roughness", "alpha_x"},
                                           {"roughness", "alpha_y"},  {"anisotropy", "alpha_x"},
                                           {"anisotropy", "alpha_y"}, {"sigma", "a"},
                                           {"sigma_deg", "a"}};
    if (a->param == b->param)
        return a->channel < 0 || b->channel < 0 || a->channel == b->channel;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        if ((is(a, pairs[i][0]) && is(b, pairs[i][1])) ||
            (is(b, pairs[i][0]) && is(a, pairs[i][1])))
            return true;
    return false;
}

bool nd_lanes_valid(const ndl_material *m, size_t lanes, const ndl_lanes *lane, ndl_error *error) {
    for (size_t i = 0; i < lanes; i++) {
        size_t lobe, other;
        lane_use use, before;
        const char *key = lane[i].key ? lane[i].key : "";
        if (!lane_of(m, &lane[i], &lobe, &use))
            return nd_fail(error, NDL_E_UNKNOWN_NAME, 0, "'", key,
                           "' is no number of this material", NULL);
        if (!used_by(&m->lobes[lobe], &use))
            return nd_fail(error, NDL_E_CONFLICT, 0, "'", key,
                           "' is not used by this material's formulas", NULL);
        for (size_t k = 0; k < i; k++) {
            lane_of(m, &lane[k], &other, &before);
            if (other == lobe && exclude(&use, &before))
                return nd_fail(error, NDL_E_CONFLICT, 0, "'", key, "' and '", lane[k].key,
                               "' exclude each other", NULL);
        }
    }
    return true;
}

/* ---- streams --------------------------------------------------------------------------------- */

static size_t field_count(const nd_lobe *l) {
    /* Tables, where there are any, stand behind the numbers; their bytes are no streams. */
    size_t count = l->model->schema()->size / sizeof(float);
    return count < ND_MOST_FIELDS ? count : ND_MOST_FIELDS;
}

void nd_lanes_uniform(const nd_lobe *l, nd_lane_tile *t) {
    float fields[ND_MOST_FIELDS];
    size_t count = field_count(l);
    memcpy(fields, l->fields, count * sizeof *fields);
    for (size_t f = 0; f < count; f++) {
        t->stream[f] = t->value[f];
        for (size_t i = 0; i < ND_TILE; i++) t->value[f][i] = fields[f];
    }
}

static float *stream_of(const nd_lobe *l, nd_lane_tile *t, const char *key) {
    bool degrees;
    int at = nd_key(l->model->schema(), key, &degrees);
    return t->value[(size_t)l->model->schema()->offsets[at] / sizeof(float)];
}

/* The nearest value in [low, high]; low for NaN. */
static void cut(size_t n, const float *from, float low, float high, float *to) {
    for (size_t i = 0; i < n; i++) {
        float x = from[i] > low ? from[i] : low;
        to[i] = x < high ? x : high;
    }
}

/* The smallest float of a range whose lower bound is excluded. */
static float low_end(const ndl_param *p) {
    float low = (float)p->low;
    return p->above_low ? nextafterf(low, INFINITY) : low;
}

static const lane_use *find(const lane_use *uses, size_t count, const char *key) {
    for (size_t i = 0; i < count; i++)
        if (is(&uses[i], key)) return &uses[i];
    return NULL;
}

static const nd_arg *written(const nd_lobe *l, const char *key) {
    for (int i = 0; i < l->call.arg_count; i++)
        if (strcmp(l->call.args[i].key, key) == 0) return &l->call.args[i];
    return NULL;
}

static float number_or(const nd_lobe *l, const char *key, float otherwise) {
    const nd_arg *arg = written(l, key);
    return arg ? arg->value.v[0] : otherwise;
}

static int word_or_first(const nd_lobe *l, const char *key, const char *words) {
    const nd_arg *arg = written(l, key);
    return arg ? nd_word_index(words, arg->value.word) : 0;
}

/* The widths of the microfacet models, ward and metal_rough, from whichever keys are lanes. */
static void fill_widths(const nd_lobe *l, const lane_use *uses, size_t count, size_t from, size_t n,
                        float *x, float *y) {
    const lane_use *alpha = find(uses, count, "alpha"), *rough = find(uses, count, "roughness");
    const lane_use *stretch = find(uses, count, "anisotropy");
    const lane_use *ax = find(uses, count, "alpha_x"), *ay = find(uses, count, "alpha_y");
    const float largest = l->facet.ndf == ND_NDF_IS_blinn ? 1.0f : 4.0f;
    if (ax) cut(n, ax->values + from, ALPHA_FLOOR, largest, x);
    if (ay) cut(n, ay->values + from, ALPHA_FLOOR, largest, y);
    if (!alpha && !rough && !stretch) return;
    bool metal = l->model->ndf == ND_NO_FACET && l->kernel == ND_KERNEL_metal_rough;
    bool by_roughness = rough || (!alpha && (metal || written(l, "roughness")));
    float values[ND_TILE], anisotropy[ND_TILE], one = number_or(l, "anisotropy", 0.0f);
    float base = by_roughness ? number_or(l, "roughness", 0.5f) : number_or(l, "alpha", 0.3f);
    for (size_t i = 0; i < n; i++) values[i] = base;
    if (rough) cut(n, rough->values + from, 0.0f, 1.0f, values);
    if (alpha) cut(n, alpha->values + from, 0.0f, 4.0f, values);
    if (stretch) cut(n, stretch->values + from, 0.0f, 1.0f, anisotropy);
    int map = by_roughness ? word_or_first(l, "roughness_map", ROUGHNESS_MAP_WORDS) : -1;
    nd_width_lanes(n, values, map, word_or_first(l, "anisotropy_kind", ANISOTROPY_WORDS),
                   stretch ? anisotropy : &one, stretch != NULL, largest, x, y);
}

/* Document S2's roughness: as given, or the root of alpha. */
static void fill_direct_roughness(const nd_lobe *l, const lane_use *uses, size_t count, size_t from,
                                  size_t n, nd_lane_tile *t) {
    float *direct = t->value[offsetof(microfacet_p, direct_roughness) / sizeof(float)];
    const float *x = t->value[offsetof(microfacet_p, alpha_x) / sizeof(float)];
    const lane_use *rough = find(uses, count, "roughness");
    bool alphas = find(uses, count, "alpha") || find(uses, count, "alpha_x") ||
                  find(uses, count, "alpha_y");
    if (rough) cut(n, rough->values + from, 0.0f, 1.0f, direct);
    else if (alphas || (find(uses, count, "anisotropy") && !written(l, "roughness")))
        for (size_t i = 0; i < n; i++) direct[i] = roughness_from_alpha(x[i]);
}

static bool is_width(const lane_use *use) {
    return is(use, "alpha") || is(use, "roughness") || is(use, "anisotropy") ||
           is(use, "alpha_x") || is(use, "alpha_y");
}

static void fill_plain(const nd_lobe *l, const lane_use *use, size_t from, size_t n,
                       nd_lane_tile *t) {
    const ndl_param *p = &l->model->schema()->params[use->param];
    float low = low_end(p), high = (float)p->high, radians[ND_TILE];
    if (is(use, "a")) { /* Oren and Nayar's A spells sigma */
        float *sigma = stream_of(l, t, "sigma");
        cut(n, use->values + from, low, high, sigma);
        for (size_t i = 0; i < n; i++) sigma[i] = sigma_from_a(sigma[i]);
        return;
    }
    float *stream = stream_of(l, t, p->key);
    const float *values = use->values + from;
    if (use->degrees) {
        for (size_t i = 0; i < n; i++)
            radians[i] = (float)((double)values[i] * (3.14159265358979323846 / 180.0));
        values = radians;
    }
    int first = use->channel < 0 ? 0 : use->channel;
    int last = use->channel < 0 ? (p->kind == NDL_KIND_COLOR ? 2 : 0) : use->channel;
    for (int c = first; c <= last; c++) cut(n, values, low, high, stream + c * ND_TILE);
}

/* Lanes after the last one, up to a whole group, repeat it. */
static void repeat_last(const nd_lobe *l, nd_lane_tile *t, size_t n) {
    for (size_t f = 0; f < field_count(l); f++)
        for (size_t i = n; i < ND_TILE && i % ND_MOST_GROUP; i++)
            t->value[f][i] = t->value[f][n - 1];
}

void nd_lanes_fill(const ndl_material *m, size_t at, size_t lanes, const ndl_lanes *lane,
                   size_t from, size_t n, nd_lane_tile *t) {
    enum { MOST = 32 };
    const nd_lobe *l = &m->lobes[at];
    lane_use uses[MOST];
    size_t count = 0, lobe;
    bool has_widths = false;
    for (size_t i = 0; i < lanes && count < MOST; i++) {
        if (!lane_of(m, &lane[i], &lobe, &uses[count]) || lobe != at) continue;
        if (is_width(&uses[count])) has_widths = true;
        else fill_plain(l, &uses[count], from, n, t);
        count++;
    }
    if (has_widths && l->model->ndf != ND_NO_FACET) {
        fill_widths(l, uses, count, from, n, stream_of(l, t, "alpha_x"),
                    stream_of(l, t, "alpha_y"));
        fill_direct_roughness(l, uses, count, from, n, t);
    } else if (has_widths && l->kernel == ND_KERNEL_metal_rough) {
        fill_widths(l, uses, count, from, n,
                    t->value[offsetof(metal_rough_p, alpha_x) / sizeof(float)],
                    t->value[offsetof(metal_rough_p, alpha_y) / sizeof(float)]);
    } else if (has_widths) {
        fill_widths(l, uses, count, from, n, stream_of(l, t, "alpha_x"),
                    stream_of(l, t, "alpha_y"));
    }
    if (n % ND_MOST_GROUP) repeat_last(l, t, n);
}
