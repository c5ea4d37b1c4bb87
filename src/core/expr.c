/* SPDX-License-Identifier: Apache-2.0 */
#include "core/expr.h"

#include "base/error.h"
#include "base/number.h"
#include "core/tone.h"

#include <math.h>
#include <string.h>

typedef struct {
    const char *text;
    size_t at, end;
    nd_arena *arena;
    ndl_error *error;
} parser;

static bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

static void skip_space(parser *p) {
    while (p->at < p->end && is_space(p->text[p->at])) p->at++;
}

static char peek(parser *p) {
    skip_space(p);
    return p->at < p->end ? p->text[p->at] : '\0';
}

static int column(const parser *p) {
    return (int)p->at + 1;
}

static bool take(parser *p, char c) {
    if (peek(p) != c || p->at >= p->end) return false;
    p->at++;
    return true;
}

/* "expected WHAT, found TOKEN" at the present place. */
static bool expected(parser *p, const char *what) {
    char room[48];
    skip_space(p);
    if (p->at >= p->end)
        return nd_fail(p->error, NDL_E_SYNTAX, column(p), "expected ", what,
                       ", found the end of the text", NULL);
    size_t n = 1;
    if (is_letter(p->text[p->at]) || is_digit(p->text[p->at]))
        while (p->at + n < p->end &&
               (is_letter(p->text[p->at + n]) || is_digit(p->text[p->at + n])))
            n++;
    return nd_fail(p->error, NDL_E_SYNTAX, column(p), "expected ", what, ", found '",
                   nd_quote(p->text + p->at, n, room, sizeof room), "'", NULL);
}

static bool out_of_memory(parser *p) {
    return nd_fail(p->error, NDL_E_MEMORY, 0, "out of memory", NULL);
}

static bool word(parser *p, const char *what, const char **to) {
    if (!is_letter(peek(p))) return expected(p, what);
    size_t start = p->at;
    while (p->at < p->end && (is_letter(p->text[p->at]) || is_digit(p->text[p->at]))) p->at++;
    *to = nd_arena_text(p->arena, p->text + start, p->at - start);
    return *to ? true : out_of_memory(p);
}

static bool starts_number(char c) {
    return is_digit(c) || c == '.' || c == '-' || c == '+';
}

static bool number(parser *p, const char *what, float *to) {
    if (!starts_number(peek(p))) return expected(p, what);
    size_t used = nd_parse_float(p->text + p->at, p->end - p->at, to);
    if (!used) return expected(p, what);
    if (!isfinite(*to))
        return nd_fail(p->error, NDL_E_RANGE, column(p), "the number is too large for a float",
                       NULL);
    p->at += used;
    return true;
}

static int hex_digit(char c) {
    if (is_digit(c)) return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

static bool hex_color(parser *p, nd_value *v) {
    int digits[6];
    for (size_t i = 0; i < 6; i++) {
        char c = p->at + 1 + i < p->end ? p->text[p->at + 1 + i] : '\0';
        digits[i] = hex_digit(c);
        if (digits[i] < 0)
            return nd_fail(p->error, NDL_E_SYNTAX, column(p),
                           "expected six hexadecimal digits after '#', as in #ff8800", NULL);
    }
    v->kind = ND_HEX;
    for (int i = 0; i < 3; i++)
        v->v[i] = nd_srgb_decode((float)(16 * digits[2 * i] + digits[2 * i + 1]) / 255.0f);
    p->at += 7;
    return true;
}

/* The rest of "[a, b, c]" after a. */
static bool triple(parser *p, nd_value *v) {
    v->kind = ND_TRIPLE;
    for (int i = 1; i < 3; i++) {
        if (!take(p, ',')) return expected(p, "',' and three numbers in all");
        if (!number(p, "a number", &v->v[i])) return false;
    }
    return take(p, ']') ? true : expected(p, "']' after three numbers");
}

static bool rgb(parser *p, const char *what, nd_value *v) {
    char c = peek(p);
    v->column = column(p);
    if (c == '#') return hex_color(p, v);
    if (take(p, '[')) return number(p, "a number", &v->v[0]) && triple(p, v);
    v->kind = ND_NUMBER;
    return number(p, what, &v->v[0]);
}

static bool room_for_stops(parser *p, nd_value *v, int room) {
    float *all = nd_arena_alloc(p->arena, 4 * (size_t)room * sizeof *all);
    if (!all) return out_of_memory(p);
    float **lists[] = {&v->x, &v->r, &v->g, &v->b};
    for (int i = 0; i < 4; i++) {
        float *list = all + i * room;
        if (v->stops) memcpy(list, *lists[i], (size_t)v->stops * sizeof *list);
        *lists[i] = list;
    }
    return true;
}

static bool stop(parser *p, nd_value *v, int at, float x) {
    nd_value c = {0};
    if (!take(p, ':')) return expected(p, "':' between the place and the colour of a ramp's stop");
    if (!rgb(p, "a colour", &c)) return false;
    for (int i = 0; i < 3; i++)
        if (c.v[i] < 0.0f)
            return nd_fail(p->error, NDL_E_RANGE, c.column, "a colour may not be negative", NULL);
    bool grey = c.kind == ND_NUMBER;
    v->x[at] = x;
    v->r[at] = c.v[0];
    v->g[at] = c.v[grey ? 0 : 1];
    v->b[at] = c.v[grey ? 0 : 2];
    return true;
}

/* The rest of "[x: color, x: color, ...]" after the first x. */
static bool ramp(parser *p, nd_value *v) {
    float x = v->v[0];
    int room = 0;
    v->kind = ND_RAMP;
    v->stops = 0;
    do {
        int place = v->stops ? (skip_space(p), column(p)) : v->column;
        if (v->stops && !number(p, "the place of a ramp's stop", &x)) return false;
        if (v->stops == room) {
            room = room ? 2 * room : 8;
            if (!room_for_stops(p, v, room)) return false;
        }
        if (v->stops && x < v->x[v->stops - 1])
            return nd_fail(p->error, NDL_E_RANGE, place,
                           "the places of a ramp's stops may not decrease; sort them", NULL);
        if (!stop(p, v, v->stops, x)) return false;
        v->stops++;
    } while (take(p, ','));
    return take(p, ']') ? true : expected(p, "',' or ']'");
}

static bool value(parser *p, nd_value *v) {
    char c = peek(p);
    v->column = column(p);
    if (is_letter(c)) {
        v->kind = ND_WORD;
        return word(p, "a word", &v->word);
    }
    if (c == '[') {
        p->at++;
        if (!number(p, "a number", &v->v[0])) return false;
        return peek(p) == ':' ? ramp(p, v) : triple(p, v);
    }
    return rgb(p, "a number, a colour, a word or a ramp", v);
}

static bool already_given(const nd_call *c, const char *key) {
    for (int i = 0; i < c->arg_count; i++)
        if (strcmp(c->args[i].key, key) == 0) return true;
    return false;
}

static bool argument(parser *p, nd_call *c, int *room) {
    nd_arg arg = {0};
    skip_space(p);
    arg.column = column(p);
    if (!word(p, "a key", &arg.key)) return false;
    if (already_given(c, arg.key)) {
        char quoted[48];
        return nd_fail(p->error, NDL_E_DUPLICATE, arg.column, "'",
                       nd_quote(arg.key, strlen(arg.key), quoted, sizeof quoted),
                       "' is given twice; keep one", NULL);
    }
    if (!take(p, '=')) return expected(p, "'=' after the key");
    if (!value(p, &arg.value)) return false;
    if (c->arg_count == *room) {
        *room = *room ? 2 * *room : 8;
        nd_arg *args = nd_arena_alloc(p->arena, (size_t)*room * sizeof *args);
        if (!args) return out_of_memory(p);
        if (c->arg_count) memcpy(args, c->args, (size_t)c->arg_count * sizeof *args);
        c->args = args;
    }
    c->args[c->arg_count++] = arg;
    return true;
}

static bool call(parser *p, nd_call *c) {
    int room = 0;
    skip_space(p);
    c->column = column(p);
    if (!word(p, "a name", &c->name)) return false;
    if (!take(p, '(') || take(p, ')')) return true;
    do
        if (!argument(p, c, &room)) return false;
    while (take(p, ','));
    return take(p, ')') ? true : expected(p, "',' or ')'");
}

static bool lobe(parser *p, nd_call *c) {
    char first = peek(p);
    if (starts_number(first) || first == '[' || first == '#') {
        if (!rgb(p, "a weight or a name", &c->weight)) return false;
        for (int i = 0; i < 3; i++)
            if (c->weight.v[i] < 0.0f)
                return nd_fail(p->error, NDL_E_RANGE, c->weight.column,
                               "a weight may not be negative", NULL);
        c->weighted = true;
        if (!take(p, '*')) return expected(p, "'*' after the weight");
    }
    return call(p, c);
}

bool nd_expr_parse(const char *text, nd_arena *a, nd_expr *e, ndl_error *error) {
    parser p = {text, 0, strlen(text), a, error};
    int room = 0;
    *e = (nd_expr){0};
    do {
        if (e->count == room) {
            room = room ? 2 * room : 4;
            nd_call *calls = nd_arena_alloc(a, (size_t)room * sizeof *calls);
            if (!calls) return out_of_memory(&p);
            if (e->count) memcpy(calls, e->calls, (size_t)e->count * sizeof *calls);
            e->calls = calls;
        }
        if (!lobe(&p, &e->calls[e->count])) return false;
        e->count++;
    } while (take(&p, '+'));
    return peek(&p) == '\0' && p.at >= p.end ? true : expected(&p, "'+' or the end of the text");
}
