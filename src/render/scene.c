/* SPDX-License-Identifier: Apache-2.0 */
#include "render/scene.h"

#include "base/error.h"
#include "base/text.h"

#include <stdlib.h>
#include <string.h>


static bool out_of_memory(ndl_error *error) {
    return nd_fail(error, NDL_E_MEMORY, 0, "out of memory", NULL);
}

static void add_factor(nd_text *t, const char *key, float x) {
    nd_text_add(t, key);
    nd_text_float(t, x);
}

/* The material of a part's glTF factors. */
static ndl_material *from_factors(const nd_part *part, ndl_error *error) {
    nd_text t = {0};
    add_factor(&t, "metal_rough(base_color=[", part->base_color[0]);
    add_factor(&t, ", ", part->base_color[1]);
    add_factor(&t, ", ", part->base_color[2]);
    add_factor(&t, "], metalness=", part->metalness);
    add_factor(&t, ", roughness=", part->roughness);
    nd_text_add(&t, ")");
    char *text = nd_text_take(&t);
    ndl_material *m = text ? ndl_material_parse(text, error) : NULL;
    if (!text) out_of_memory(error);
    free(text);
    return m;
}

static bool give_own_materials(ndl_scene *s, ndl_error *error) {
    size_t parts = s->geometry.mesh.parts;
    s->material = calloc(parts, sizeof *s->material);
    s->own = calloc(parts, sizeof *s->own);
    if (!s->material || !s->own) return out_of_memory(error);
    s->plain = ndl_material_parse("lambert", error);
    if (!s->plain) return false;
    for (size_t i = 0; i < parts; i++) {
        const nd_part *part = &s->geometry.mesh.part[i];
        if (part->has_factors && !(s->own[i] = from_factors(part, error))) return false;
        s->material[i] = s->own[i] ? s->own[i] : s->plain;
    }
    return true;
}

static bool give_default_lights(ndl_scene *s, ndl_error *error) {
    s->light = calloc(ND_DEFAULT_LIGHTS, sizeof *s->light);
    if (!s->light) return out_of_memory(error);
    for (s->lights = 0; s->lights < ND_DEFAULT_LIGHTS; s->lights++)
        if (!nd_light_parse(nd_default_lights[s->lights], &s->light[s->lights], error))
            return false;
    return true;
}

ndl_scene *ndl_scene_load(const char *mesh, ndl_error *err) {
    ndl_scene *s = calloc(1, sizeof *s);
    if (!s) out_of_memory(err);
    else if (nd_geometry_load(mesh, &s->geometry, err) && give_own_materials(s, err) &&
             give_default_lights(s, err)) {
        s->camera = nd_camera_default();
        return s;
    }
    ndl_scene_free(s);
    return NULL;
}

void ndl_scene_free(ndl_scene *s) {
    if (!s) return;
    for (size_t i = 0; s->own && i < s->geometry.mesh.parts; i++) ndl_material_free(s->own[i]);
    ndl_material_free(s->plain);
    free(s->own);
    free(s->material);
    free(s->light);
    nd_geometry_free(&s->geometry);
    free(s);
}

const char *ndl_scene_builtins(void) {
    return "sphere shaderball plane disc";
}

size_t ndl_scene_parts(const ndl_scene *s) {
    return s->geometry.mesh.parts;
}

ndl_part_names ndl_scene_part(const ndl_scene *s, size_t i) {
    const nd_part *part = &s->geometry.mesh.part[i];
    return (ndl_part_names){part->mesh, part->node, part->material};
}

static bool is_called(const nd_part *part, const char *name) {
    return *name && (strcmp(part->mesh, name) == 0 || strcmp(part->node, name) == 0 ||
                     strcmp(part->material, name) == 0);
}

static void list_name(nd_text *list, const char *name) {
    char quoted[ND_NAME];
    if (!*name) return;
    nd_text_add(list, list->n ? ", " : "");
    nd_text_add(list, nd_quote(name, strlen(name), quoted, sizeof quoted));
}

static bool no_such_part(const ndl_scene *s, const char *name, ndl_error *error) {
    char quoted[48];
    nd_text names = {0};
    const nd_part *part = s->geometry.mesh.part;
    for (size_t i = 0; i < s->geometry.mesh.parts && names.n < 200; i++) {
        list_name(&names, part[i].mesh);
        if (strcmp(part[i].node, part[i].mesh) != 0) list_name(&names, part[i].node);
        if (!i || strcmp(part[i].material, part[i - 1].material) != 0)
            list_name(&names, part[i].material);
    }
    nd_quote(name, strlen(name), quoted, sizeof quoted);
    nd_fail(error, NDL_E_UNKNOWN_NAME, 0, "no mesh or material is called '", quoted,
            names.n ? "'; there are: " : "'; none has a name", names.n ? names.s : NULL, NULL);
    nd_text_free(&names);
    return false;
}

int ndl_scene_set_material(ndl_scene *s, const char *name, const ndl_material *m, ndl_error *err) {
    bool found = false;
    for (size_t i = 0; i < s->geometry.mesh.parts; i++) {
        if (name && !is_called(&s->geometry.mesh.part[i], name)) continue;
        s->material[i] = m;
        found = true;
    }
    if (found) return NDL_OK;
    no_such_part(s, name, err);
    return NDL_E_UNKNOWN_NAME;
}

int ndl_scene_add_light(ndl_scene *s, const char *text, ndl_error *err) {
    ndl_error own = {0};
    nd_light light;
    size_t kept = s->has_own_lights ? s->lights : 0;
    if (!nd_light_parse(text, &light, &own)) {
        if (err) *err = own;
        return own.code;
    }
    nd_light *grown = realloc(s->light, (kept + 1) * sizeof *grown);
    if (!grown) {
        out_of_memory(err);
        return NDL_E_MEMORY;
    }
    s->light = grown;
    s->light[kept] = light;
    s->lights = kept + 1;
    s->has_own_lights = true;
    return NDL_OK;
}

int ndl_scene_set_camera(ndl_scene *s, const char *text, ndl_error *err) {
    ndl_error own = {0};
    if (nd_camera_parse(text, &s->camera, &own)) return NDL_OK;
    if (err) *err = own;
    return own.code;
}
