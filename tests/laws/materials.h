/* SPDX-License-Identifier: Apache-2.0 */
/* Materials of a registered model, found by its parameter table alone: every combination of its
   choices (a ramp is one more choice: absent or present), times the corners of the box of its
   numbers and colours, times a low-discrepancy sequence of vectors that also uses the other
   spellings. A new model gets all of this without a line here. */
#ifndef LAW_MATERIALS_H
#define LAW_MATERIALS_H
#include "ndl_test.h"

#include <float.h>
#include <ndotl/ndotl.h>
#include <stdbool.h>

/* Uniform random numbers, xorshift64*. */
typedef struct { uint64_t state; } draws;

static inline uint64_t draw_bits(draws *d) {
    d->state ^= d->state >> 12;
    d->state ^= d->state << 25;
    d->state ^= d->state >> 27;
    return d->state * 0x2545F4914F6CDD1DULL;
}

/* In [0, 1), 53 bits. */
static inline double draw(draws *d) {
    return (double)(draw_bits(d) >> 11) * 0x1p-53;
}

static inline draws draws_of(uint64_t seed) {
    draws d = {(seed + 1) * 0x9E3779B97F4A7C15ULL};
    draw_bits(&d);
    return d;
}

enum { MOST_ARGS = 48, ARG_ROOM = 400, TEXT_ROOM = 4096, MOST_AXES = 8 };

typedef struct {
    const char *model;
    char arg[MOST_ARGS][ARG_ROOM]; /* "key=value" */
    int count, choices;            /* the first `choices` are choices and ramps */
} recipe;

__attribute__((format(printf, 2, 3)))
static inline void add_arg(recipe *r, const char *format, ...) {
    va_list list;
    assert_true(r->count < MOST_ARGS);
    va_start(list, format);
    vsnprintf(r->arg[r->count++], ARG_ROOM, format, list);
    va_end(list);
}

static inline int word_count(const char *words) {
    int n = 1;
    for (; *words; words++) n += *words == ' ';
    return n;
}

/* Word `at` of a blank-separated list. */
static inline const char *word_at(const char *words, int at, char room[64]) {
    for (; at > 0; at--) words = strchr(words, ' ') + 1;
    snprintf(room, 64, "%.*s", (int)strcspn(words, " "), words);
    return room;
}

static inline bool is_choice(const ndl_param *p) {
    return (p->kind == NDL_KIND_CHOICE && !p->is_spelling) || p->kind == NDL_KIND_RAMP;
}

static inline bool is_axis(const ndl_param *p) {
    return !p->is_spelling && (p->kind == NDL_KIND_NUMBER || p->kind == NDL_KIND_COLOR);
}

/* Number of combinations of the choices of model i; its number of axes in *axes. */
static inline int combinations(size_t i, int *axes) {
    size_t count;
    const ndl_param *p = ndl_model_params(i, &count);
    int n = 1;
    *axes = 0;
    for (size_t k = 0; k < count; k++) {
        if (is_choice(&p[k])) n *= p[k].kind == NDL_KIND_RAMP ? 2 : word_count(p[k].words);
        *axes += is_axis(&p[k]);
    }
    return n;
}

static inline float low_end(const ndl_param *p) {
    return p->above_low ? nextafterf((float)p->low, FLT_MAX) : (float)p->low;
}

/* A value of a number for u in [0, 1): an end for the outer sixteenths; else uniform, or, for
   every other one, in powers of ten below the upper end (`most`, if that is less), so that small
   values occur. */
static inline float spread(const ndl_param *p, double u, bool by_powers, double most) {
    double low = (double)low_end(p), high = fmin(p->high, most), range = high - low;
    if (u < 0.0625) return (float)low;
    if (u > 0.9375) return (float)high;
    double t = (u - 0.0625) / 0.875;
    double powers = most < (double)FLT_MAX ? 3.0 : high > 1e6 ? 36.0 : 6.0;
    float x = (float)(low + range * (by_powers ? pow(10.0, -powers * t) : t));
    return x < (float)low ? (float)low : x > (float)high ? (float)high : x;
}

static inline void add_ramp(recipe *r, const char *key, draws *d) {
    char text[ARG_ROOM];
    int stops = 1 + (int)(draw_bits(d) % 5), n = 0;
    double x = -1.2;
    for (int i = 0; i < stops; i++) {
        x += draw_bits(d) % 4 ? 0.6 * draw(d) : 0.0; /* one in four shares its place: a step */
        n += snprintf(text + n, sizeof text - (size_t)n, "%s%.9g:[%.6g,%.6g,%.6g]", i ? "," : "", x,
                      draw(d), draw(d), draw(d));
    }
    add_arg(r, "%s=[%s]", key, text);
}

/* Combination c of the choices, the last one counting fastest. */
static inline void add_choices(recipe *r, size_t model, int c, draws *d) {
    size_t count;
    const ndl_param *p = ndl_model_params(model, &count);
    char word[64];
    for (size_t k = count; k-- > 0;) {
        if (!is_choice(&p[k])) continue;
        int n = p[k].kind == NDL_KIND_RAMP ? 2 : word_count(p[k].words);
        if (p[k].kind == NDL_KIND_CHOICE)
            add_arg(r, "%s=%s", p[k].key, word_at(p[k].words, c % n, word));
        else if (c % n) add_ramp(r, p[k].key, d);
        c /= n;
    }
    r->choices = r->count;
}

/* Turns the arguments after the choices by `by`: of two that exclude each other the first stays. */
static inline void rotate(recipe *r, int by) {
    recipe old = *r;
    int n = r->count - r->choices;
    for (int i = 0; i < n; i++)
        memcpy(r->arg[r->choices + i], old.arg[r->choices + (i + by) % n], ARG_ROOM);
}

static inline void text_of(const recipe *r, char text[TEXT_ROOM], int start[MOST_ARGS]) {
    int n = snprintf(text, TEXT_ROOM, "%s(", r->model);
    for (int i = 0; i < r->count; i++) {
        if (i) text[n++] = ',';
        start[i] = n + 1; /* its column */
        n += snprintf(text + n, (size_t)(TEXT_ROOM - n), "%s", r->arg[i]);
    }
    snprintf(text + n, (size_t)(TEXT_ROOM - n), ")");
}

/* The material of a recipe. Arguments that others exclude, or that leave the range of the choices
   (alpha > 1 of ndf=blinn), are dropped by the column of the error until it parses. */
static inline ndl_material *material_of(recipe *r) {
    char text[TEXT_ROOM];
    int start[MOST_ARGS];
    ndl_error err;
    for (;;) {
        text_of(r, text, start);
        ndl_material *m = ndl_material_parse(text, &err);
        if (m) return m;
        int at = r->count - 1;
        while (at >= 0 && start[at] > err.column) at--;
        if ((err.code != NDL_E_CONFLICT && err.code != NDL_E_RANGE) || at < r->choices) {
            print_error("%s: column %d: %s\n", text, err.column, err.text);
            fail();
        }
        r->count--;
        memmove(r->arg[at], r->arg[at + 1], (size_t)(r->count - at) * ARG_ROOM);
    }
}

/* Corner `bits` of the box: every number and colour at its lower or upper end. */
static inline ndl_material *corner_material(size_t model, int c, unsigned bits) {
    recipe r = {.model = ndl_model_name(model)};
    size_t count;
    draws d = draws_of(bits);
    const ndl_param *p = ndl_model_params(model, &count);
    add_choices(&r, model, c, &d);
    for (size_t k = 0, axis = 0; k < count; k++) {
        if (!is_axis(&p[k])) continue;
        bool high = bits >> axis++ % MOST_AXES & 1;
        add_arg(&r, "%s=%.9g", p[k].key, high ? p[k].high : (double)low_end(&p[k]));
    }
    rotate(&r, (int)(bits % 7));
    return material_of(&r);
}

/* Vector i of the sequence. `bright`: colours at their upper ends, and no number above 1e4: float
   cosines next to 1 have steps of 6e-8, which a larger exponent turns into steps of the value that
   are neither continuous nor integrated well. Nor numbers within 1e-3 of that range above the lower
   end: a power of .01 rises from 0 within less than a float can resolve. */
static inline ndl_material *vector_material(size_t model, int c, unsigned i, bool bright) {
    static const double root[] = {1.41421356, 1.73205081, 2.23606798, 2.64575131, 3.31662479,
                                  3.60555128, 4.12310563, 4.35889894, 4.79583152, 5.38516481,
                                  5.56776436, 6.08276253, 6.40312424, 6.55743852, 6.85565460};
    recipe r = {.model = ndl_model_name(model)};
    size_t count;
    draws d = draws_of((uint64_t)i * 1000 + (uint64_t)c);
    const ndl_param *p = ndl_model_params(model, &count);
    const double most = bright ? 1e4 : (double)FLT_MAX;
    add_choices(&r, model, c, &d);
    for (size_t k = 0; k < count; k++) {
        double whole, u = modf((i + 0.5) * root[k % 15], &whole);
        bool used = !p[k].is_spelling || draw_bits(&d) >> 62 == 0;
        char word[64];
        int at;
        if (!used || is_choice(&p[k])) continue;
        switch (p[k].kind) {
        case NDL_KIND_NUMBER:
            add_arg(&r, "%s=%.9g", p[k].key, (double)spread(&p[k], u, draw_bits(&d) >> 63, most));
            break;
        case NDL_KIND_COLOR:
            if (bright) add_arg(&r, "%s=%.9g", p[k].key, p[k].high);
            else
                add_arg(&r, "%s=[%.9g,%.9g,%.9g]", p[k].key,
                        (double)spread(&p[k], u, draw_bits(&d) >> 63, most),
                        (double)spread(&p[k], draw(&d), false, most),
                        (double)spread(&p[k], draw(&d), true, most));
            break;
        case NDL_KIND_CHOICE:
            at = (int)(draw_bits(&d) % (unsigned)word_count(p[k].words));
            add_arg(&r, "%s=%s", p[k].key, word_at(p[k].words, at, word));
            break;
        case NDL_KIND_WORD: /* of the models only preset */
            add_arg(&r, "%s=%s", p[k].key, ndl_preset_at(draw_bits(&d) % ndl_preset_count())->name);
            break;
        default: break;
        }
    }
    if (r.count > r.choices) rotate(&r, (int)(draw_bits(&d) % 16));
    return material_of(&r);
}

/* n, or an eighth of it in a build with sanitizers, which is some ten times slower. */
static inline unsigned thinned(unsigned n) {
    const char *sanitizers = getenv("NDOTL_SANITIZE");
    return sanitizers && *sanitizers ? (n + 7) / 8 : n;
}

/* ---- one test per model ---------------------------------------------------------------------- */

static inline size_t model_of(void **state) {
    return (size_t)(uintptr_t)*state;
}

/* Runs a cmocka test once for every registered model, with its number as the state. */
static inline int run_over_models(const char *law, void (*test)(void **)) {
    enum { MOST = 64 };
    struct CMUnitTest tests[MOST];
    size_t n = ndl_model_count();
    assert_true(n > 0 && n <= MOST);
    for (size_t i = 0; i < n; i++)
        tests[i] = (struct CMUnitTest){ndl_model_name(i), test, NULL, NULL, (void *)(uintptr_t)i};
    return _cmocka_run_group_tests(law, tests, n, NULL, NULL);
}

#endif
