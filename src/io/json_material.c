/* SPDX-License-Identifier: Apache-2.0 */
/* The long form is turned into the short form, so that all meaning stays with the one parser of
   expressions. Where that one refuses the text, the text is built again to find the member that its
   column belongs to. */
#include "io/json_material.h"

#include "base/error.h"
#include "base/nearest.h"
#include "base/text.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

typedef struct {
    nd_text text;
    ndl_error *error;
    char place[96]; /* the member that is being written */
    int wanted;     /* column whose member is looked for; 0: none */
    char found[96]; /* that member */
} writer;

static bool fail(writer *w, int code, const char *what) {
    return nd_fail(w->error, code, 0, w->place, *w->place ? ": " : "", what, NULL);
}

/* From here on the text comes from this member of a lobe. */
static void enter(writer *w, size_t lobe, const char *member, const char *key) {
    char quoted[48];
    nd_quote(key, strlen(key), quoted, sizeof quoted);
    snprintf(w->place, sizeof w->place, "lobes[%zu]%s%s", lobe, member, quoted);
    if ((long long)w->text.n < w->wanted) memcpy(w->found, w->place, sizeof w->found);
}

static bool is_name_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/* Adds a name or a #rrggbb: nothing that could be taken for other syntax. */
static bool add_word(writer *w, const char *s, const char *what) {
    const char *p = s + (*s == '#');
    while (is_name_character(*p))
        p++;
    if (*p || p == s) return fail(w, NDL_E_TYPE, what);
    nd_text_add(&w->text, s);
    return true;
}

static void add_number(writer *w, const json_t *v) {
    char digits[40];
    snprintf(digits, sizeof digits, "%.17g", json_real_value(v));
    nd_text_add(&w->text, digits);
}

/* A number, three of them or "#rrggbb". */
static bool add_color(writer *w, const json_t *v, const char *what) {
    if (json_is_real(v)) {
        add_number(w, v);
        return true;
    }
    if (json_is_string(v) && json_string_value(v)[0] == '#')
        return add_word(w, json_string_value(v), what);
    if (!json_is_array(v) || json_array_size(v) != 3) return fail(w, NDL_E_TYPE, what);
    for (size_t i = 0; i < 3; i++) {
        const json_t *c = json_array_get(v, i);
        if (!json_is_real(c)) return fail(w, NDL_E_TYPE, what);
        nd_text_add(&w->text, i ? ", " : "[");
        add_number(w, c);
    }
    nd_text_add(&w->text, "]");
    return true;
}

static bool add_ramp(writer *w, const json_t *v) {
    static const char what[] = "a ramp is [[x, color], ...]";
    for (size_t i = 0; i < json_array_size(v); i++) {
        const json_t *stop = json_array_get(v, i);
        if (!json_is_array(stop) || json_array_size(stop) != 2 ||
            !json_is_real(json_array_get(stop, 0)))
            return fail(w, NDL_E_TYPE, what);
        nd_text_add(&w->text, i ? ", " : "[");
        add_number(w, json_array_get(stop, 0));
        nd_text_add(&w->text, ": ");
        if (!add_color(w, json_array_get(stop, 1), what)) return false;
    }
    nd_text_add(&w->text, "]");
    return true;
}

static bool add_value(writer *w, const json_t *v) {
    if (json_is_string(v))
        return add_word(w, json_string_value(v), "the text is neither a word nor #rrggbb");
    if (json_is_array(v) && json_is_array(json_array_get(v, 0))) return add_ramp(w, v);
    return add_color(w, v, "expected a number, [r, g, b], [[x, color], ...] or a text");
}

static bool add_params(writer *w, size_t lobe, json_t *params) {
    const char *key, *before = "(";
    json_t *v;
    json_object_foreach(params, key, v) {
        enter(w, lobe, ".params.", key);
        nd_text_add(&w->text, before);
        before = ", ";
        if (!add_word(w, key, "is no key")) return false;
        nd_text_add(&w->text, "=");
        if (!add_value(w, v)) return false;
    }
    if (before[0] == ',') nd_text_add(&w->text, ")");
    return true;
}

static bool unknown_member(writer *w, const char *key, const char *known) {
    char room[32], quoted[48];
    nd_nearest near = {.wanted = key};
    nd_nearest_words(&near, known, room, sizeof room);
    nd_quote(key, strlen(key), quoted, sizeof quoted);
    const char *place = *w->place ? w->place : "the top level";
    if (near.best)
        return nd_fail(w->error, NDL_E_UNKNOWN_NAME, 0, place, ": unknown member '", quoted,
                       "'; did you mean '", near.best, "'?", NULL);
    return nd_fail(w->error, NDL_E_UNKNOWN_NAME, 0, place, ": unknown member '", quoted,
                   "'; expected ", known, NULL);
}

static bool check_members(writer *w, json_t *object, const char *known) {
    const char *key;
    json_t *v;
    json_object_foreach(object, key, v) {
        size_t n = strlen(key);
        const char *at = n ? strstr(known, key) : NULL;
        if (!at || (at[n] != ' ' && at[n] != '\0') || (at > known && at[-1] != ' '))
            return unknown_member(w, key, known);
    }
    return true;
}

static bool add_lobe(writer *w, size_t i, json_t *lobe) {
    enter(w, i, "", "");
    if (!json_is_object(lobe)) return fail(w, NDL_E_TYPE, "a lobe is an object with a model");
    if (!check_members(w, lobe, "weight model params")) return false;
    const json_t *weight = json_object_get(lobe, "weight");
    const json_t *model = json_object_get(lobe, "model");
    json_t *params = json_object_get(lobe, "params");
    if (!json_is_string(model)) return fail(w, NDL_E_TYPE, "a lobe needs \"model\", a text");
    if (params && !json_is_object(params)) return fail(w, NDL_E_TYPE, "params is an object");
    if (i) nd_text_add(&w->text, " + ");
    if (weight) {
        enter(w, i, ".weight", "");
        if (!add_color(w, weight, "expected a number or [r, g, b]")) return false;
        nd_text_add(&w->text, "*");
    }
    enter(w, i, ".model", "");
    return add_word(w, json_string_value(model), "is no name of a model") &&
           (!params || add_params(w, i, params));
}

static bool add_material(writer *w, json_t *root) {
    w->place[0] = '\0';
    if (json_is_object(root) && !check_members(w, root, "lobes")) return false;
    if (!json_is_array(json_object_get(root, "lobes")))
        return fail(w, NDL_E_TYPE, "expected an object with \"lobes\", an array of objects");
    json_t *lobes = json_object_get(root, "lobes");
    if (json_array_size(lobes) == 0) return fail(w, NDL_E_TYPE, "\"lobes\" is empty");
    for (size_t i = 0; i < json_array_size(lobes); i++)
        if (!add_lobe(w, i, json_array_get(lobes, i))) return false;
    if (!w->text.failed) return true;
    return nd_fail(w->error, NDL_E_MEMORY, 0, "out of memory", NULL);
}

/* The column of an error of the short form becomes the member that wrote it. */
static void place_error(writer *w, json_t *root, ndl_error *error) {
    ndl_error first = *error;
    if (!first.column) return;
    w->wanted = first.column;
    w->text.n = 0;
    add_material(w, root);
    nd_fail(error, first.code, 0, w->found, *w->found ? ": " : "", first.text, NULL);
}

static ndl_material *make(json_t *root, ndl_error *error) {
    writer w = {.error = error};
    ndl_material *m = NULL;
    if (add_material(&w, root)) {
        m = ndl_material_parse(w.text.s, error);
        if (!m) place_error(&w, root, error);
    }
    nd_text_free(&w.text);
    return m;
}

/* jansson's message ends with "near 'token'", its position is behind the token. */
static void broken_json(const json_error_t *e, ndl_error *error) {
    const char *near = strstr(e->text, " near '");
    int length = near ? (int)strlen(near + 7) - 1 : 0;
    int column = e->position - length + 1;
    nd_fail(error, NDL_E_SYNTAX, column > 0 ? column : 1, "the JSON is broken: ", e->text, NULL);
}

ndl_material *nd_json_material(const char *text, ndl_error *error) {
    ndl_error own;
    json_error_t e;
    if (!error) error = &own;
    json_t *root = json_loads(text, JSON_REJECT_DUPLICATES | JSON_DECODE_INT_AS_REAL, &e);
    if (!root) {
        broken_json(&e, error);
        return NULL;
    }
    ndl_material *m = make(root, error);
    json_decref(root);
    return m;
}
