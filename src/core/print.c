/* SPDX-License-Identifier: Apache-2.0 */
#include "core/print.h"

#include "base/text.h"

#include <string.h>

static bool is_grey(const nd_value *v) {
    return v->kind == ND_NUMBER || (v->v[0] == v->v[1] && v->v[0] == v->v[2]);
}

static void put_rgb(nd_text *t, float r, float g, float b, const char *comma) {
    if (r == g && r == b) {
        nd_text_float(t, r);
        return;
    }
    nd_text_add(t, "[");
    nd_text_float(t, r);
    nd_text_add(t, comma);
    nd_text_float(t, g);
    nd_text_add(t, comma);
    nd_text_float(t, b);
    nd_text_add(t, "]");
}

/* Arguments in the order of the table, whatever the order they were written in. */
static const nd_arg *argument_of(const nd_lobe *l, size_t param) {
    for (int i = 0; i < l->call.arg_count; i++) {
        bool degrees;
        if (nd_key(l->model->schema(), l->call.args[i].key, &degrees) == (int)param)
            return &l->call.args[i];
    }
    return NULL;
}

/* A vector is three numbers even where they are equal. */
static void put_vector(nd_text *t, const nd_value *v, const char *comma) {
    for (int i = 0; i < 3; i++) {
        nd_text_add(t, i ? comma : "[");
        nd_text_float(t, v->v[i]);
    }
    nd_text_add(t, "]");
}

static void put_value(nd_text *t, const nd_value *v, ndl_kind kind) {
    if (v->kind == ND_WORD) {
        nd_text_add(t, v->word);
    } else if (v->kind == ND_RAMP) {
        for (int i = 0; i < v->stops; i++) {
            nd_text_add(t, i ? ", " : "[");
            nd_text_float(t, v->x[i]);
            nd_text_add(t, ": ");
            put_rgb(t, v->r[i], v->g[i], v->b[i], ", ");
        }
        nd_text_add(t, "]");
    } else if (kind == NDL_KIND_VECTOR) {
        put_vector(t, v, ", ");
    } else {
        bool number = v->kind == ND_NUMBER;
        put_rgb(t, v->v[0], v->v[number ? 0 : 1], v->v[number ? 0 : 2], ", ");
    }
}

static void put_lobe(nd_text *t, const nd_lobe *l) {
    const nd_schema *s = l->model->schema();
    const float *w = l->weight;
    if (!(w[0] == 1.0f && w[1] == 1.0f && w[2] == 1.0f)) {
        put_rgb(t, w[0], w[1], w[2], ", ");
        nd_text_add(t, "*");
    }
    nd_text_add(t, l->model->name);
    const char *before = "(";
    for (size_t i = 0; i < s->count; i++) {
        const nd_arg *arg = argument_of(l, i);
        if (!arg) continue;
        nd_text_add(t, before);
        before = ", ";
        nd_text_add(t, arg->key);
        nd_text_add(t, "=");
        put_value(t, &arg->value, s->params[i].kind);
    }
    if (before[0] == ',') nd_text_add(t, ")");
}

char *nd_print_text(const ndl_material *m) {
    nd_text t = {0};
    for (size_t i = 0; i < m->count; i++) {
        if (i) nd_text_add(&t, " + ");
        put_lobe(&t, &m->lobes[i]);
    }
    return nd_text_take(&t);
}

/* A ramp becomes [[x, color], ...]. */
static void put_json_value(nd_text *t, const nd_value *v, ndl_kind kind) {
    if (v->kind == ND_WORD) {
        nd_text_json(t, v->word);
    } else if (v->kind == ND_RAMP) {
        for (int i = 0; i < v->stops; i++) {
            nd_text_add(t, i ? ",[" : "[[");
            nd_text_float(t, v->x[i]);
            nd_text_add(t, ",");
            put_rgb(t, v->r[i], v->g[i], v->b[i], ",");
            nd_text_add(t, "]");
        }
        nd_text_add(t, "]");
    } else if (is_grey(v) && kind != NDL_KIND_VECTOR) {
        nd_text_float(t, v->v[0]);
    } else {
        put_vector(t, v, ",");
    }
}

static void put_json_lobe(nd_text *t, const nd_lobe *l) {
    const nd_schema *s = l->model->schema();
    nd_text_add(t, "{\"weight\":");
    for (int i = 0; i < 3; i++) {
        nd_text_add(t, i ? "," : "[");
        nd_text_float(t, l->weight[i]);
    }
    nd_text_add(t, "],\"model\":");
    nd_text_json(t, l->model->name);
    nd_text_add(t, ",\"params\":{");
    const char *before = "";
    for (size_t i = 0; i < s->count; i++) {
        const nd_arg *arg = argument_of(l, i);
        if (!arg) continue;
        nd_text_add(t, before);
        before = ",";
        nd_text_json(t, arg->key);
        nd_text_add(t, ":");
        put_json_value(t, &arg->value, s->params[i].kind);
    }
    nd_text_add(t, "}}");
}

char *nd_print_json(const ndl_material *m) {
    nd_text t = {0};
    nd_text_add(&t, "{\"lobes\":[");
    for (size_t i = 0; i < m->count; i++) {
        if (i) nd_text_add(&t, ",");
        put_json_lobe(&t, &m->lobes[i]);
    }
    nd_text_add(&t, "]}");
    return nd_text_take(&t);
}
