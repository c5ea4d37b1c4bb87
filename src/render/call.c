/* SPDX-License-Identifier: Apache-2.0 */
#include "render/call.h"

#include "base/error.h"
#include "base/nearest.h"
#include "base/text.h"
#include "shade/prelude_c.h"

#include <stdlib.h>
#include <string.h>

static int unknown(const nd_call *call, const char *what, const nd_schema *const *schemas,
                   ndl_error *error) {
    char quoted[48];
    nd_quote(call->name, strlen(call->name), quoted, sizeof quoted);
    nd_nearest near = {.wanted = call->name};
    nd_text names = {0};
    for (int i = 0; schemas[i]; i++) {
        nd_nearest_offer(&near, schemas[i]->name);
        if (i) nd_text_add(&names, " ");
        nd_text_add(&names, schemas[i]->name);
    }
    if (near.best)
        nd_fail(error, NDL_E_UNKNOWN_NAME, call->column, "unknown ", what, " '", quoted,
                "'; did you mean '", near.best, "'?", NULL);
    else
        nd_fail(error, NDL_E_UNKNOWN_NAME, call->column, "unknown ", what, " '", quoted,
                "'; it is one of: ", names.s ? names.s : "", NULL);
    nd_text_free(&names);
    return -1;
}

int nd_call_parse(const char *text, const char *what, const nd_schema *const *schemas,
                  nd_arena *arena, nd_binding *binding, void *fields, ndl_error *error) {
    nd_expr e;
    if (!nd_expr_parse(text, arena, &e, error)) return -1;
    if (e.count != 1 || e.calls[0].weighted) {
        int column = e.calls[0].weighted ? e.calls[0].weight.column : e.calls[1].column;
        nd_fail(error, NDL_E_SYNTAX, column, "a ", what, " is neither a sum nor weighted", NULL);
        return -1;
    }
    for (int i = 0; schemas[i]; i++) {
        if (strcmp(schemas[i]->name, e.calls[0].name) != 0) continue;
        return nd_bind(binding, schemas[i], &e.calls[0], fields, arena, error) ? i : -1;
    }
    return unknown(&e.calls[0], what, schemas, error);
}

bool nd_call_needs(nd_binding *b, const char *key) {
    if (nd_given(b, key)) return true;
    return nd_fail(b->error, NDL_E_SYNTAX, b->call->column, b->schema->name, " needs '", key,
                   "'; add it", NULL);
}

#define COLOR_PARAMS(P) P(RGB, color, 0, 3.4e38, 0, "1", "linear Rec.709")
typedef struct { COLOR_PARAMS(FIELD) } color_p;
ND_DEFINE_SCHEMA(color_schema, "color", COLOR_PARAMS, color_p)

/* The grammar has colours as values of keys only, so the text is read as that of a call. */
bool nd_color_parse(const char *text, ndl_rgb *color, ndl_error *error) {
    static const char before[] = "color(color=";
    const nd_schema *const schemas[] = {color_schema(), NULL};
    nd_arena arena = {0};
    nd_binding b;
    color_p fields;
    nd_text call = {0};
    nd_text_add(&call, before);
    nd_text_add(&call, text);
    nd_text_add(&call, ")");
    char *s = nd_text_take(&call);
    int kind = -1;
    if (s) kind = nd_call_parse(s, "colour", schemas, &arena, &b, &fields, error);
    else nd_fail(error, NDL_E_MEMORY, 0, "out of memory", NULL);
    if (kind >= 0) *color = (ndl_rgb){fields.color.x, fields.color.y, fields.color.z};
    else if (error && error->column >= (int)sizeof before) error->column -= (int)sizeof before - 1;
    nd_arena_free(&arena);
    free(s);
    return kind >= 0;
}
