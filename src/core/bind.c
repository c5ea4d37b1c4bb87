/* SPDX-License-Identifier: Apache-2.0 */
#include "base/error.h"
#include "base/nearest.h"
#include "base/text.h"
#include "core/schema.h"
#include "shade/prelude_c.h"

#include <string.h>

static const double DEGREE = 3.14159265358979323846 / 180.0;

int nd_key(const nd_schema *s, const char *key, bool *degrees) {
    size_t n = strlen(key);
    size_t stem = n > 4 && strcmp(key + n - 4, "_deg") == 0 ? n - 4 : 0;
    for (size_t i = 0; i < s->count; i++) {
        const ndl_param *p = &s->params[i];
        *degrees = stem && strcmp(p->unit, "rad") == 0 && strlen(p->key) == stem &&
                   strncmp(p->key, key, stem) == 0;
        if (*degrees || strcmp(p->key, key) == 0) return (int)i;
    }
    return -1;
}

int nd_word_index(const char *words, const char *word) {
    size_t n = strlen(word);
    for (int i = 0; *words; i++) {
        size_t length = strcspn(words, " ");
        if (length == n && strncmp(words, word, n) == 0) return i;
        words += length + (words[length] == ' ');
    }
    return -1;
}

static int index_of(const nd_binding *b, const char *key) {
    bool degrees;
    return nd_key(b->schema, key, &degrees);
}

const nd_arg *nd_given(const nd_binding *b, const char *key) {
    int i = index_of(b, key);
    return i < 0 ? NULL : b->given[i];
}

int nd_choice(const nd_binding *b, const char *key) {
    int i = index_of(b, key);
    return i < 0 ? -1 : b->choice[i];
}

void nd_choose(nd_binding *b, const char *key, int value) {
    int i = index_of(b, key);
    if (i >= 0) b->choice[i] = value;
}

void nd_set(nd_binding *b, const char *field_key, const float *values, int count) {
    int i = index_of(b, field_key);
    if (i >= 0 && b->schema->offsets[i] >= 0)
        memcpy(b->fields + b->schema->offsets[i], values, (size_t)count * sizeof *values);
}

/* A number as its key means it: degrees become radians, in double, then one rounding. */
static float number_of(const nd_arg *arg, bool degrees) {
    return degrees ? (float)((double)arg->value.v[0] * DEGREE) : arg->value.v[0];
}

float nd_number(const nd_binding *b, const char *key) {
    int i = index_of(b, key);
    if (i < 0) return 0.0f;
    if (!b->given[i]) return (float)b->schema->params[i].initial[0];
    return number_of(b->given[i], strcmp(b->given[i]->key, b->schema->params[i].key) != 0);
}

bool nd_exclusive(nd_binding *b, const char *a, const char *other, const char *why) {
    const nd_arg *first = nd_given(b, a), *second = nd_given(b, other);
    if (!first || !second) return true;
    if (second->column < first->column) {
        const nd_arg *swap = first;
        first = second;
        second = swap;
    }
    b->clash[0] = first->key;
    b->clash[1] = second->key;
    return nd_fail(b->error, NDL_E_CONFLICT, second->column, "'", second->key, "' and '",
                   first->key, "' exclude each other: ", why, NULL);
}

/* ---- checks of single values ----------------------------------------------------------------- */

static const char *bound(double x, char *room, size_t size) {
    nd_text t = {0};
    nd_text_float(&t, (float)x);
    size_t n = t.n < size - 1 ? t.n : size - 1;
    if (t.s) memcpy(room, t.s, n);
    room[n] = '\0';
    nd_text_free(&t);
    return room;
}

static bool unbounded(double x) {
    return x <= -1e38 || x >= 1e38;
}

static bool out_of_range(const nd_binding *b, const nd_arg *arg, const ndl_param *p, float x) {
    char low[32], high[32], value[32];
    bound(p->low, low, sizeof low);
    bound(p->high, high, sizeof high);
    bound((double)x, value, sizeof value);
    const char *unit = strcmp(p->unit, "rad") == 0 ? " radians" : "";
    if (unbounded(p->high))
        return nd_fail(b->error, NDL_E_RANGE, arg->value.column, "'", p->key, "' must be ",
                       p->above_low ? "above " : "at least ", low, unit, ", not ", value, NULL);
    return nd_fail(b->error, NDL_E_RANGE, arg->value.column, "'", p->key, "' must be ",
                   p->above_low ? "above " : "from ", low, p->above_low ? " and at most " : " to ",
                   high, unit, ", not ", value, NULL);
}

/* Bounds are compared as floats: pi/2 as a float is allowed where pi/2 is the end. */
static bool in_range(const ndl_param *p, float x) {
    float low = (float)p->low, high = (float)p->high;
    return (p->above_low ? x > low : x >= low) && x <= high;
}

static bool wrong_type(const nd_binding *b, const nd_arg *arg, const char *wanted) {
    return nd_fail(b->error, NDL_E_TYPE, arg->value.column, "'", arg->key, "' takes ", wanted,
                   NULL);
}

static bool check_number(const nd_binding *b, const nd_arg *arg, const ndl_param *p, bool degrees) {
    if (arg->value.kind != ND_NUMBER) return wrong_type(b, arg, "a number");
    float x = number_of(arg, degrees);
    return in_range(p, x) ? true : out_of_range(b, arg, p, x);
}

static bool check_color(const nd_binding *b, const nd_arg *arg, const ndl_param *p) {
    const nd_value *v = &arg->value;
    if (v->kind == ND_WORD || v->kind == ND_RAMP)
        return wrong_type(b, arg, "a colour: a number, [r, g, b] or #rrggbb");
    int channels = v->kind == ND_NUMBER ? 1 : 3;
    for (int i = 0; i < channels; i++)
        if (!in_range(p, v->v[i])) return out_of_range(b, arg, p, v->v[i]);
    return true;
}

static bool check_choice(nd_binding *b, const nd_arg *arg, int at) {
    const ndl_param *p = &b->schema->params[at];
    if (arg->value.kind != ND_WORD) return wrong_type(b, arg, "a word");
    b->choice[at] = nd_word_index(p->words, arg->value.word);
    if (b->choice[at] >= 0) return true;
    char quoted[48], room[64];
    nd_quote(arg->value.word, strlen(arg->value.word), quoted, sizeof quoted);
    nd_nearest near = {arg->value.word, NULL, 0};
    nd_nearest_words(&near, p->words, room, sizeof room);
    if (near.best)
        return nd_fail(b->error, NDL_E_UNKNOWN_NAME, arg->value.column, "unknown ", p->key, " '",
                       quoted, "'; did you mean '", near.best, "'?", NULL);
    return nd_fail(b->error, NDL_E_UNKNOWN_NAME, arg->value.column, "unknown ", p->key, " '",
                   quoted, "'; it is one of: ", p->words, NULL);
}

static bool check_ramp(const nd_binding *b, const nd_arg *arg) {
    if (arg->value.kind != ND_RAMP) return wrong_type(b, arg, "a ramp, as in [0: 0.2, 1: 0.8]");
    if (arg->value.stops <= TABLE1_STOPS) return true;
    return nd_fail(b->error, NDL_E_RANGE, arg->value.column, "'", arg->key,
                   "' may have 4096 stops at most; drop some", NULL);
}

static bool check(nd_binding *b, const nd_arg *arg, int at, bool degrees) {
    const ndl_param *p = &b->schema->params[at];
    switch (p->kind) {
    case NDL_KIND_NUMBER: return check_number(b, arg, p, degrees);
    case NDL_KIND_COLOR: return check_color(b, arg, p);
    case NDL_KIND_CHOICE: return check_choice(b, arg, at);
    case NDL_KIND_RAMP: return check_ramp(b, arg);
    case NDL_KIND_WORD: return arg->value.kind == ND_WORD ? true : wrong_type(b, arg, "a name");
    case NDL_KIND_VECTOR:
        return arg->value.kind == ND_TRIPLE ? true : wrong_type(b, arg, "three numbers [x, y, z]");
    }
    return false;
}

/* ---- the whole call -------------------------------------------------------------------------- */

static bool unknown_key(const nd_binding *b, const nd_arg *arg) {
    char quoted[48];
    nd_quote(arg->key, strlen(arg->key), quoted, sizeof quoted);
    nd_nearest near = {arg->key, NULL, 0};
    for (size_t i = 0; i < b->schema->count; i++)
        nd_nearest_offer(&near, b->schema->params[i].key);
    if (near.best)
        return nd_fail(b->error, NDL_E_UNKNOWN_NAME, arg->column, "unknown parameter '", quoted,
                       "' of ", b->schema->name, "; did you mean '", near.best, "'?", NULL);
    return nd_fail(b->error, NDL_E_UNKNOWN_NAME, arg->column, "unknown parameter '", quoted,
                   "' of ", b->schema->name, "; `ndotl models ", b->schema->name, "` lists them",
                   NULL);
}

static void set_initial(nd_binding *b, int at) {
    const ndl_param *p = &b->schema->params[at];
    if (p->kind == NDL_KIND_CHOICE) b->choice[at] = nd_word_index(p->words, p->initial_word);
    if (b->schema->offsets[at] < 0 || p->kind == NDL_KIND_RAMP) return;
    float v[3] = {(float)p->initial[0], (float)p->initial[1], (float)p->initial[2]};
    nd_set(b, p->key, v, p->kind == NDL_KIND_NUMBER ? 1 : 3);
}

static void set_given(nd_binding *b, int at, bool degrees) {
    const ndl_param *p = &b->schema->params[at];
    const nd_value *v = &b->given[at]->value;
    float triple[3] = {v->v[0], v->v[1], v->v[2]};
    if (p->kind == NDL_KIND_NUMBER) {
        float x = number_of(b->given[at], degrees);
        nd_set(b, p->key, &x, 1);
    } else if (p->kind == NDL_KIND_COLOR && v->kind == ND_NUMBER) {
        nd_set(b, p->key, (float[]){v->v[0], v->v[0], v->v[0]}, 3);
    } else if (p->kind == NDL_KIND_COLOR || p->kind == NDL_KIND_VECTOR) {
        nd_set(b, p->key, triple, 3);
    } else if (p->kind == NDL_KIND_RAMP) {
        table1 ramp = {v->x, v->r, v->g, v->b, v->stops};
        memcpy(b->fields + b->schema->offsets[at], &ramp, sizeof ramp);
    }
}

static bool take_argument(nd_binding *b, const nd_arg *arg) {
    bool degrees;
    int at = nd_key(b->schema, arg->key, &degrees);
    if (at < 0) return unknown_key(b, arg);
    if (b->given[at])
        return nd_fail(b->error, NDL_E_CONFLICT, arg->column, "'", arg->key, "' and '",
                       b->given[at]->key, "' give the same quantity; keep one", NULL);
    if (!check(b, arg, at, degrees)) return false;
    b->given[at] = arg;
    set_given(b, at, degrees);
    return true;
}

bool nd_bind(nd_binding *b, const nd_schema *schema, const nd_call *call, void *fields,
             nd_arena *arena, ndl_error *error) {
    *b = (nd_binding){
        .schema = schema, .call = call, .fields = fields, .arena = arena, .error = error};
    memset(fields, 0, schema->size);
    for (size_t i = 0; i < schema->count; i++) set_initial(b, (int)i);
    for (int i = 0; i < call->arg_count; i++)
        if (!take_argument(b, &call->args[i])) return false;
    for (int i = 0; schema->groups[i]; i++)
        if (!schema->groups[i]->resolve(b)) return false;
    return true;
}
