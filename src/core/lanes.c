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

/* ---- the plan of a call ---------------------------------------------------------------------- */

static int field_of(const nd_lobe *l, const char *key) {
    bool degrees;
    int at = nd_key(l->model->schema(), key, &degrees);
    return at < 0 || l->model->schema()->offsets[at] < 0
               ? -1
               : (int)((size_t)l->model->schema()->offsets[at] / sizeof(float));
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

/* The array of the plan that a width key fills, or NULL. */
static const float **width_lane(nd_lane_plan *plan, const lane_use *use) {
    if (is(use, "alpha")) return &plan->alpha;
    if (is(use, "roughness")) return &plan->roughness;
    if (is(use, "anisotropy")) return &plan->anisotropy;
    if (is(use, "alpha_x")) return &plan->alpha_x;
    if (is(use, "alpha_y")) return &plan->alpha_y;
    return NULL;
}

/* The smallest float of a range whose lower bound is excluded. */
static float low_end(const ndl_param *p) {
    float low = (float)p->low;
    return p->above_low ? nextafterf(low, INFINITY) : low;
}

static void plan_plain(nd_lane_plan *plan, const nd_lobe *l, const lane_use *use) {
    const ndl_param *p = &l->model->schema()->params[use->param];
    bool spells_sigma = is(use, "a");
    int field = field_of(l, spells_sigma ? "sigma" : p->key);
    int channels = p->kind == NDL_KIND_COLOR && use->channel < 0 ? 3 : 1;
    int first = field + (use->channel > 0 ? use->channel : 0);
    plan->plain[plan->plain_count++] = (nd_plain_lane){
        use->values, low_end(p), (float)p->high,
        use->degrees ? 3.14159265358979323846 / 180.0 : 1.0, first, first + channels - 1,
        spells_sigma};
}

/* The number of a struct's field that has no key. */
#define FIELD_NUMBER(type, field) ((int)(offsetof(type, field) / sizeof(float)))

/* What m gives where a width is no lane; see nd_group_width. */
static void plan_widths(nd_lane_plan *plan, const nd_lobe *l) {
    bool composed = l->model->ndf != ND_NO_FACET;
    bool metal = !composed && l->kernel == ND_KERNEL_metal_rough;
    bool by_roughness = plan->roughness || (!plan->alpha && (metal || written(l, "roughness")));
    plan->base = by_roughness ? number_or(l, "roughness", 0.5f) : number_or(l, "alpha", 0.3f);
    plan->stretch = number_or(l, "anisotropy", 0.0f);
    plan->map = by_roughness ? word_or_first(l, "roughness_map", ROUGHNESS_MAP_WORDS) : -1;
    plan->kind = word_or_first(l, "anisotropy_kind", ANISOTROPY_WORDS);
    plan->largest = composed && l->facet.ndf == ND_NDF_IS_blinn ? 1.0f : 4.0f;
    plan->x = metal ? FIELD_NUMBER(metal_rough_p, alpha_x) : field_of(l, "alpha_x");
    plan->y = metal ? FIELD_NUMBER(metal_rough_p, alpha_y) : field_of(l, "alpha_y");
    bool direct = composed && l->facet.masking == ND_MASKING_IS_schlick_direct;
    plan->direct = direct ? FIELD_NUMBER(microfacet_p, direct_roughness) : -1;
    plan->direct_is_root = plan->alpha || plan->alpha_x || plan->alpha_y ||
                           (plan->anisotropy && !written(l, "roughness"));
}

void nd_lanes_plan(const ndl_material *m, size_t at, size_t lanes, const ndl_lanes *lane,
                   nd_lane_plan *plan) {
    const nd_lobe *l = &m->lobes[at];
    memset(plan, 0, sizeof *plan);
    for (size_t i = 0; i < lanes; i++) {
        size_t lobe;
        lane_use use;
        if (!lane_of(m, &lane[i], &lobe, &use) || lobe != at) continue;
        const float **width = width_lane(plan, &use);
        if (width) *width = use.values;
        else if (plan->plain_count < ND_MOST_LANES) plan_plain(plan, l, &use);
    }
    plan_widths(plan, l);
    /* Tables, where there are any, stand behind the numbers; their bytes are no streams. */
    plan->field_count = l->model->schema()->size / sizeof(float);
    if (plan->field_count > ND_MOST_FIELDS) plan->field_count = ND_MOST_FIELDS;
}

/* ---- streams --------------------------------------------------------------------------------- */

static size_t whole(size_t n) {
    return (n + ND_MOST_GROUP - 1) / ND_MOST_GROUP * ND_MOST_GROUP;
}

void nd_lanes_uniform(const nd_lobe *l, size_t n, nd_lane_tile *t) {
    float fields[ND_MOST_FIELDS];
    size_t count = l->model->schema()->size / sizeof(float);
    if (count > ND_MOST_FIELDS) count = ND_MOST_FIELDS;
    memcpy(fields, l->fields, count * sizeof *fields);
    for (size_t f = 0; f < count; f++) {
        t->stream[f] = t->value[f];
        for (size_t i = 0; i < whole(n < ND_TILE ? n : ND_TILE); i++) t->value[f][i] = fields[f];
    }
}

/* The nearest value in [low, high]; low for NaN. */
static void cut(size_t n, const float *from, float low, float high, float *to) {
    for (size_t i = 0; i < n; i++) {
        float x = from[i] > low ? from[i] : low;
        to[i] = x < high ? x : high;
    }
}

static void fill_widths(const nd_lane_plan *plan, size_t from, size_t n, float *x, float *y) {
    float values[ND_TILE], anisotropy[ND_TILE];
    if (plan->alpha_x) cut(n, plan->alpha_x + from, ALPHA_FLOOR, plan->largest, x);
    if (plan->alpha_y) cut(n, plan->alpha_y + from, ALPHA_FLOOR, plan->largest, y);
    if (!plan->alpha && !plan->roughness && !plan->anisotropy) return;
    if (plan->roughness) cut(n, plan->roughness + from, 0.0f, 1.0f, values);
    else if (plan->alpha) cut(n, plan->alpha + from, 0.0f, 4.0f, values);
    else for (size_t i = 0; i < n; i++) values[i] = plan->base;
    if (plan->anisotropy) cut(n, plan->anisotropy + from, 0.0f, 1.0f, anisotropy);
    nd_width_lanes(n, values, plan->map, plan->kind,
                   plan->anisotropy ? anisotropy : &plan->stretch, plan->anisotropy != NULL,
                   plan->largest, x, y);
}

/* Document S2's roughness: as given, or the root of alpha. */
static void fill_direct_roughness(const nd_lane_plan *plan, size_t from, size_t n,
                                  nd_lane_tile *t) {
    float *direct = t->value[plan->direct];
    const float *x = t->value[plan->x];
    if (plan->roughness) cut(n, plan->roughness + from, 0.0f, 1.0f, direct);
    else if (plan->direct_is_root)
        for (size_t i = 0; i < n; i++) direct[i] = roughness_from_alpha(x[i]);
}

static void fill_plain(const nd_plain_lane *lane, size_t from, size_t n, nd_lane_tile *t) {
    float radians[ND_TILE];
    const float *values = lane->values + from;
    if (lane->scale != 1.0) {
        for (size_t i = 0; i < n; i++) radians[i] = (float)((double)values[i] * lane->scale);
        values = radians;
    }
    for (int f = lane->first; f <= lane->last; f++)
        cut(n, values, lane->low, lane->high, t->value[f]);
    float *sigma = t->value[lane->first];
    for (size_t i = 0; lane->spells_sigma && i < n; i++) sigma[i] = sigma_from_a(sigma[i]);
}

void nd_lanes_fill(const nd_lane_plan *plan, size_t from, size_t n, nd_lane_tile *t) {
    for (size_t i = 0; i < plan->plain_count; i++) fill_plain(&plan->plain[i], from, n, t);
    if (plan->x >= 0) fill_widths(plan, from, n, t->value[plan->x], t->value[plan->y]);
    if (plan->direct >= 0) fill_direct_roughness(plan, from, n, t);
    for (size_t f = 0; n < whole(n) && f < plan->field_count; f++)
        for (size_t i = n; i < whole(n); i++) t->value[f][i] = t->value[f][n - 1];
}
