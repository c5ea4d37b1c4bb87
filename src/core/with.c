/* SPDX-License-Identifier: Apache-2.0 */
/* ndl_material_with: a changed copy of a material, without going through text. */
#include "base/error.h"
#include "core/material.h"
#include "core/models.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool copy_floats(nd_arena *a, float **list, int n) {
    float *copy = nd_arena_alloc(a, (size_t)n * sizeof *copy);
    if (!copy) return false;
    memcpy(copy, *list, (size_t)n * sizeof *copy);
    *list = copy;
    return true;
}

static bool copy_value(nd_arena *a, nd_value *v) {
    if (v->kind == ND_WORD) return (v->word = nd_arena_text(a, v->word, strlen(v->word))) != NULL;
    if (v->kind != ND_RAMP) return true;
    return copy_floats(a, &v->x, v->stops) && copy_floats(a, &v->r, v->stops) &&
           copy_floats(a, &v->g, v->stops) && copy_floats(a, &v->b, v->stops);
}

/* A deep copy of a call into another arena, with room for `more` arguments. */
static bool copy_call(nd_arena *a, nd_call *c, int more) {
    nd_arg *args = nd_arena_alloc(a, (size_t)(c->arg_count + more) * sizeof *args);
    c->name = nd_arena_text(a, c->name, strlen(c->name));
    if (!args || !c->name) return false;
    for (int i = 0; i < c->arg_count; i++) {
        args[i] = c->args[i];
        args[i].key = nd_arena_text(a, args[i].key, strlen(args[i].key));
        if (!args[i].key || !copy_value(a, &args[i].value)) return false;
    }
    c->args = args;
    return true;
}

static void drop(nd_call *c, const char *key) {
    for (int i = 0; i < c->arg_count; i++) {
        if (strcmp(c->args[i].key, key) != 0) continue;
        memmove(&c->args[i], &c->args[i + 1], (size_t)(c->arg_count - i - 1) * sizeof *c->args);
        c->arg_count--;
        return;
    }
}

/* Drops the argument of a parameter, in whichever unit it was given. */
static void drop_parameter(nd_call *c, const nd_schema *s, int param) {
    bool degrees;
    for (int i = c->arg_count; i-- > 0;)
        if (nd_key(s, c->args[i].key, &degrees) == param) drop(c, c->args[i].key);
}

bool nd_parameter_path(const char *path, size_t *lobe, char *key, size_t room, int *channel) {
    *lobe = 0;
    if (path[0] >= '0' && path[0] <= '9') {
        char *end;
        unsigned long long n = strtoull(path, &end, 10);
        if (*end != '.') return false;
        *lobe = (size_t)n;
        path = end + 1;
    }
    size_t n = strlen(path);
    *channel = -1;
    if (n > 2 && path[n - 2] == '.' && strchr("rgb", path[n - 1])) {
        *channel = (int)(strchr("rgb", path[n - 1]) - "rgb");
        n -= 2;
    }
    if (n == 0 || n >= room) return false;
    memcpy(key, path, n);
    key[n] = '\0';
    return true;
}

static const float *field_of(const nd_lobe *l, int param) {
    short offset = l->model->schema()->offsets[param];
    return offset < 0 ? NULL : (const float *)(const void *)((const char *)l->fields + offset);
}

/* An argument that gives field `param` the value it has in l. */
static nd_arg present_value(const nd_lobe *l, int param) {
    const ndl_param *p = &l->model->schema()->params[param];
    nd_arg arg = {p->key, 0, {.kind = p->kind == NDL_KIND_NUMBER ? ND_NUMBER : ND_TRIPLE}};
    const float *v = field_of(l, param);
    memcpy(arg.value.v, v, (p->kind == NDL_KIND_NUMBER ? 1 : 3) * sizeof *v);
    return arg;
}

static bool new_argument(const nd_lobe *l, const char *key, int channel, double value, nd_arg *arg,
                         ndl_error *error) {
    bool degrees;
    int at = nd_key(l->model->schema(), key, &degrees);
    if (at < 0)
        return nd_fail(error, NDL_E_UNKNOWN_NAME, 0, "unknown parameter '", key, "' of ",
                       l->model->name, NULL);
    const ndl_param *p = &l->model->schema()->params[at];
    bool color = p->kind == NDL_KIND_COLOR;
    if ((p->kind != NDL_KIND_NUMBER && !color) || (channel >= 0 && !color))
        return nd_fail(error, NDL_E_TYPE, 0, "'", key, "' does not take a single number", NULL);
    if (!isfinite(value) || !isfinite((float)value))
        return nd_fail(error, NDL_E_RANGE, 0, "'", key, "' must be a finite number", NULL);
    *arg = (nd_arg){p->key, 0, {.kind = ND_NUMBER, .v = {(float)value}}};
    if (degrees) arg->key = key;
    if (channel >= 0) {
        *arg = present_value(l, at);
        arg->value.v[channel] = (float)value;
    }
    return true;
}

/* Whether `word` stands in a blank-separated list. */
static bool listed(const char *words, const char *word) {
    return nd_word_index(words, word) >= 0;
}

/* Where a spelling is dropped for one of the fields it set, the other fields keep their value. Of
   the Fresnel keys only eta and k belong together: f0 and ior each give the whole. */
static void keep_siblings(nd_call *c, const nd_lobe *l, const char *key) {
    const nd_schema *s = l->model->schema();
    for (int g = 0; s->groups[g]; g++) {
        const char *fields = s->groups[g]->fields;
        if (strcmp(s->groups[g]->name, "fresnel") == 0) fields = "eta k";
        if (!listed(fields, key)) continue;
        for (size_t i = 0; i < s->count; i++) {
            const char *other = s->params[i].key;
            bool given = false;
            for (int k = 0; k < c->arg_count; k++) given |= strcmp(c->args[k].key, other) == 0;
            if (listed(fields, other) && !given && field_of(l, (int)i))
                c->args[c->arg_count++] = present_value(l, (int)i);
        }
    }
}

/* Drops what excludes the new key until the call binds, or fails for another reason. */
static bool settle(nd_call *c, const nd_lobe *l, const char *key, nd_arena *a, ndl_error *error) {
    const nd_schema *s = l->model->schema();
    void *fields = nd_arena_alloc(a, s->size);
    if (!fields) return nd_fail(error, NDL_E_MEMORY, 0, "out of memory", NULL);
    nd_binding b;
    ndl_error why = {0};
    for (;;) {
        if (nd_bind(&b, s, c, fields, a, &why)) return true;
        bool mine = b.clash[0] && (strcmp(b.clash[0], key) == 0 || strcmp(b.clash[1], key) == 0);
        if (!mine) break;
        drop(c, strcmp(b.clash[0], key) == 0 ? b.clash[1] : b.clash[0]);
        keep_siblings(c, l, key);
    }
    if (error) *error = why;
    if (error) error->column = 0;
    return false;
}

ndl_material *ndl_material_with(const ndl_material *m, const char *key, double value,
                                ndl_error *error) {
    enum { MORE = 16 };
    char name[64];
    size_t at;
    int channel;
    nd_arg arg;
    if (error) *error = (ndl_error){0};
    if (!nd_parameter_path(key, &at, name, sizeof name, &channel) || at >= m->count) {
        nd_fail(error, NDL_E_UNKNOWN_NAME, 0, "no parameter of that name in this material", NULL);
        return NULL;
    }
    if (!new_argument(&m->lobes[at], name, channel, value, &arg, error)) return NULL;
    ndl_material *copy = nd_material_new(m->count, error);
    if (!copy) return NULL;
    bool good = true;
    for (size_t i = 0; good && i < m->count; i++) {
        copy->lobes[i].call = m->lobes[i].call;
        good = copy_call(&copy->arena, &copy->lobes[i].call, MORE);
    }
    arg.key = good ? nd_arena_text(&copy->arena, arg.key, strlen(arg.key)) : NULL;
    if (!arg.key) {
        nd_fail(error, NDL_E_MEMORY, 0, "out of memory", NULL);
        ndl_material_free(copy);
        return NULL;
    }
    nd_call *c = &copy->lobes[at].call;
    bool degrees;
    const nd_schema *s = m->lobes[at].model->schema();
    drop_parameter(c, s, nd_key(s, name, &degrees));
    c->args[c->arg_count++] = arg;
    if (!settle(c, &m->lobes[at], arg.key, &copy->arena, error)) {
        ndl_material_free(copy);
        return NULL;
    }
    return nd_material_finish(copy, error);
}
