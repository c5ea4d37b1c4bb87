/* SPDX-License-Identifier: Apache-2.0 */
/* Conversions as a graph: quantities are nodes, each rule derives one from one or two others by a
   function of shade/convert.h. What follows from the known ones is found by applying the rules
   until nothing new turns up. */
#include "ndotl/convert.h"

#include "base/error.h"
#include "base/nearest.h"
#include "base/number.h"
#include "core/schema.h"
#include "shade/prelude_c.h"

#include "shade/math.h"

#include "shade/convert.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Q(key, low, high, whether low is excluded, what gives it) */
#define WIDTH "alpha, roughness, blinn_exponent, phong_exponent, or alpha_x and alpha_y"
#define STRETCH "alpha_x and alpha_y"
#define INDEX "ior or f0"
#define SLOPE "sigma, sigma_deg, a or a57"
#define QUANTITIES(Q)                                            \
    Q(alpha, 0.0f, 4.0f, false, WIDTH)                           \
    Q(alpha_x, 0.0f, 4.0f, false, WIDTH ", with anisotropy")     \
    Q(alpha_y, 0.0f, 4.0f, false, WIDTH ", with anisotropy")     \
    Q(roughness, 0.0f, 1.0f, false, WIDTH)                       \
    Q(anisotropy, 0.0f, 1.0f, false, STRETCH)                    \
    Q(blinn_exponent, 0.0f, FLT_MAX, false, WIDTH)               \
    Q(phong_exponent, 0.0f, FLT_MAX, false, WIDTH)               \
    Q(ior, 0.0f, FLT_MAX, true, INDEX)                           \
    Q(f0, 0.0f, 1.0f, false, INDEX)                              \
    Q(sigma, 0.0f, FLT_MAX, false, SLOPE)                        \
    Q(sigma_deg, 0.0f, FLT_MAX, false, SLOPE)                    \
    Q(a, 0.5f, 1.0f, true, SLOPE)                                \
    Q(a57, 0.5f, 1.0f, true, SLOPE)

#define Q(key, low, high, above, from) Q_##key,
enum { QUANTITIES(Q) Q_COUNT };
#undef Q

typedef struct { const char *key; float low, high; bool above; const char *from; } quantity;
#define Q(key, low, high, above, from) {#key, low, high, above, from},
static const quantity all[] = {QUANTITIES(Q)};
#undef Q

#define Q(key, low, high, above, from) #key " "
static const char keys[] = QUANTITIES(Q) "roughness_map anisotropy_kind";
#undef Q

enum { SQUARE, DIRECT, SQRT };
enum { BURLEY, KULLA, OPENPBR, GLTF };

typedef struct {
    float value[Q_COUNT];
    bool known[Q_COUNT];
    bool outside[Q_COUNT]; /* derived, but out of its range: no value */
    int map, kind;
    bool no_default; /* an anisotropy that is not given is not 0 but unknown */
} state;

const char *ndl_convert_keys(void) {
    return keys;
}

const char *ndl_convert_words(const char *key) {
    if (strcmp(key, "roughness_map") == 0) return ROUGHNESS_MAP_WORDS;
    if (strcmp(key, "anisotropy_kind") == 0) return ANISOTROPY_WORDS;
    return NULL;
}

static int find(const char *key) {
    for (int i = 0; i < Q_COUNT; i++)
        if (strcmp(all[i].key, key) == 0) return i;
    return -1;
}

/* ---- rules ----------------------------------------------------------------------------------- */

static float alpha_of_roughness(const state *s) {
    float roughness = s->value[Q_roughness];
    return s->map == DIRECT ? alpha_from_roughness_direct(roughness)
           : s->map == SQRT ? alpha_from_roughness_sqrt(roughness)
                            : alpha_from_roughness(roughness);
}

static float roughness_of_alpha(const state *s) {
    float alpha = s->value[Q_alpha];
    return s->map == DIRECT ? roughness_from_alpha_direct(alpha)
           : s->map == SQRT ? roughness_from_alpha_sqrt(alpha)
                            : roughness_from_alpha(alpha);
}

static widths stretched(const state *s) {
    float alpha = s->value[Q_alpha];
    float anisotropy = s->known[Q_anisotropy] ? s->value[Q_anisotropy] : 0.0f;
    switch (s->kind) {
    case KULLA: return widths_kulla(alpha, anisotropy);
    case OPENPBR: return widths_openpbr(alpha, anisotropy);
    case GLTF: return widths_gltf(alpha, anisotropy);
    default: return widths_burley(alpha, anisotropy);
    }
}

static float x_of_alpha(const state *s) {
    return stretched(s).x;
}
static float y_of_alpha(const state *s) {
    return stretched(s).y;
}

/* The inverses of the four stretches. */
static float alpha_of_xy(const state *s) {
    float x = s->value[Q_alpha_x], y = s->value[Q_alpha_y];
    switch (s->kind) {
    case KULLA: return 0.5f * (x + y);
    case OPENPBR: return sqrtf(0.5f * (x * x + y * y));
    case GLTF: return y;
    default: return x == y ? x : sqrtf(x * y);
    }
}

static float anisotropy_of_xy(const state *s) {
    float x = s->value[Q_alpha_x], y = s->value[Q_alpha_y];
    if (x == y) return 0.0f;
    switch (s->kind) {
    case KULLA: return (x - y) / (x + y);
    case OPENPBR: return (x - y) / x;
    case GLTF: return sqrtf((x - y) / (1.0f - y));
    default: return (float)((double)((x - y) / x) / 0.9);
    }
}

static float blinn_of_alpha(const state *s) {
    float alpha = s->value[Q_alpha];
    return alpha > 0.0f ? blinn_exponent_from_alpha(alpha) : (float)INFINITY;
}

static float f0_of_ior(const state *s) {
    return f0_from_ior(s->value[Q_ior]);
}
static float ior_of_f0(const state *s) {
    return s->value[Q_f0] < 1.0f ? ior_from_f0(s->value[Q_f0]) : (float)INFINITY;
}

static const double DEGREE = 3.14159265358979323846 / 180.0;
static float sigma_of_degrees(const state *s) {
    return (float)((double)s->value[Q_sigma_deg] * DEGREE);
}
static float degrees_of_sigma(const state *s) {
    return (float)((double)s->value[Q_sigma] / DEGREE);
}

#define ONE(name, function, from)                \
    static float name(const state *s) {          \
        return function(s->value[Q_##from]);     \
    }
ONE(alpha_of_blinn, alpha_from_blinn_exponent, blinn_exponent)
ONE(blinn_of_phong, blinn_exponent_from_phong, phong_exponent)
ONE(phong_of_blinn, phong_exponent_from_blinn, blinn_exponent)
ONE(a_of_sigma, a_from_sigma, sigma)
ONE(sigma_of_a, sigma_from_a, a)
ONE(a57_of_sigma, a57_from_sigma, sigma)
ONE(sigma_of_a57, sigma_from_a57, a57)

typedef struct { int to, from, and; float (*rule)(const state *s); } rule;
static const rule rules[] = {
    {Q_alpha, Q_roughness, Q_roughness, alpha_of_roughness},
    {Q_roughness, Q_alpha, Q_alpha, roughness_of_alpha},
    {Q_alpha, Q_alpha_x, Q_alpha_y, alpha_of_xy},
    {Q_anisotropy, Q_alpha_x, Q_alpha_y, anisotropy_of_xy},
    {Q_alpha_x, Q_alpha, Q_alpha, x_of_alpha},
    {Q_alpha_y, Q_alpha, Q_alpha, y_of_alpha},
    {Q_alpha, Q_blinn_exponent, Q_blinn_exponent, alpha_of_blinn},
    {Q_blinn_exponent, Q_alpha, Q_alpha, blinn_of_alpha},
    {Q_blinn_exponent, Q_phong_exponent, Q_phong_exponent, blinn_of_phong},
    {Q_phong_exponent, Q_blinn_exponent, Q_blinn_exponent, phong_of_blinn},
    {Q_f0, Q_ior, Q_ior, f0_of_ior},
    {Q_ior, Q_f0, Q_f0, ior_of_f0},
    {Q_sigma, Q_sigma_deg, Q_sigma_deg, sigma_of_degrees},
    {Q_sigma_deg, Q_sigma, Q_sigma, degrees_of_sigma},
    {Q_a, Q_sigma, Q_sigma, a_of_sigma},
    {Q_sigma, Q_a, Q_a, sigma_of_a},
    {Q_a57, Q_sigma, Q_sigma, a57_of_sigma},
    {Q_sigma, Q_a57, Q_a57, sigma_of_a57},
};

/* Derived values may leave the range of the given ones only at the far end of a width. */
static bool has_value(int q, float x) {
    bool width = q == Q_alpha || q == Q_alpha_x || q == Q_alpha_y;
    float high = width || q == Q_roughness ? FLT_MAX : all[q].high;
    return x >= all[q].low && x <= high && x < FLT_MAX;
}

static void solve(state *s) {
    for (bool more = true; more;) {
        more = false;
        for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
            const rule *r = &rules[i];
            if (s->known[r->to] || s->outside[r->to] || !s->known[r->from] || !s->known[r->and])
                continue;
            bool stretches = r->rule == x_of_alpha || r->rule == y_of_alpha;
            if (stretches && s->no_default && !s->known[Q_anisotropy]) continue;
            s->value[r->to] = r->rule(s);
            s->known[r->to] = has_value(r->to, s->value[r->to]);
            s->outside[r->to] = !s->known[r->to];
            more = true;
        }
    }
}

/* ---- what is given --------------------------------------------------------------------------- */

static int unknown_key(const char *key, ndl_error *error) {
    char quoted[48], room[32];
    nd_nearest near = {key, NULL, 0};
    nd_nearest_words(&near, keys, room, sizeof room);
    nd_quote(key, strlen(key), quoted, sizeof quoted);
    if (near.best)
        nd_fail(error, NDL_E_UNKNOWN_NAME, 0, "unknown key '", quoted, "'; did you mean '",
                near.best, "'?", NULL);
    else
        nd_fail(error, NDL_E_UNKNOWN_NAME, 0, "unknown key '", quoted, "'; use one of: ", keys,
                NULL);
    return NDL_E_UNKNOWN_NAME;
}

static int take_word(state *s, const ndl_known *k, const char *words, ndl_error *error) {
    int word = k->word ? nd_word_index(words, k->word) : -1;
    if (word < 0) {
        nd_fail(error, NDL_E_UNKNOWN_NAME, 0, "'", k->key, "' takes one of: ", words, NULL);
        return NDL_E_UNKNOWN_NAME;
    }
    if (strcmp(k->key, "roughness_map") == 0) s->map = word;
    else s->kind = word;
    return NDL_OK;
}

static int out_of_range(int q, float x, const char *verb, ndl_error *error) {
    char number[ND_NUMBER_ROOM], low[ND_NUMBER_ROOM], high[ND_NUMBER_ROOM];
    nd_format_float(x, number);
    nd_format_float(all[q].low, low);
    nd_format_float(all[q].high, high);
    const char *end = all[q].high == FLT_MAX ? "any finite number" : high;
    nd_fail(error, NDL_E_RANGE, 0, "'", all[q].key, "' ", verb, " ",
            x >= FLT_MAX ? "infinite" : number, ", outside its range: ",
            all[q].above ? "above " : "", low, " to ", end, NULL);
    return NDL_E_RANGE;
}

static int take(state *s, const ndl_known *k, ndl_error *error) {
    const char *words = ndl_convert_words(k->key);
    if (words) return take_word(s, k, words, error);
    int q = find(k->key);
    if (q < 0) return unknown_key(k->key, error);
    if (k->word) {
        nd_fail(error, NDL_E_TYPE, 0, "'", k->key, "' takes a number", NULL);
        return NDL_E_TYPE;
    }
    if (s->known[q]) {
        nd_fail(error, NDL_E_DUPLICATE, 0, "'", k->key, "' is given twice; keep one", NULL);
        return NDL_E_DUPLICATE;
    }
    float x = k->value;
    bool low_enough = all[q].above ? x > all[q].low : x >= all[q].low;
    if (!low_enough || !(x <= all[q].high)) return out_of_range(q, x, "is", error);
    s->known[q] = true;
    s->value[q] = x;
    return NDL_OK;
}

/* A given quantity that follows from the other ones contradicts or repeats them. */
static int check_conflict(const state *given, ndl_error *error) {
    for (int q = 0; q < Q_COUNT; q++) {
        if (!given->known[q]) continue;
        state others = *given;
        others.known[q] = false;
        others.no_default = q == Q_anisotropy;
        solve(&others);
        if (!others.known[q] && !others.outside[q]) continue;
        nd_fail(error, NDL_E_CONFLICT, 0, "'", all[q].key,
                "' follows from the other values already; drop it or them", NULL);
        return NDL_E_CONFLICT;
    }
    return NDL_OK;
}

int ndl_convert(const ndl_known *known, size_t count, const char *key, float *to,
                ndl_error *error) {
    state s = {.map = SQUARE, .kind = BURLEY};
    int wanted = find(key);
    if (wanted < 0) return unknown_key(key, error);
    for (size_t i = 0; i < count; i++) {
        int code = take(&s, &known[i], error);
        if (code) return code;
    }
    int code = check_conflict(&s, error);
    if (code) return code;
    solve(&s);
    if (s.outside[wanted]) return out_of_range(wanted, s.value[wanted], "would be", error);
    if (!s.known[wanted]) {
        nd_fail(error, NDL_E_UNSUPPORTED, 0, "'", key,
                "' does not follow from what is given; give ", all[wanted].from, NULL);
        return NDL_E_UNSUPPORTED;
    }
    *to = s.value[wanted];
    return NDL_OK;
}
