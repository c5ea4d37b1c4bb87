/* SPDX-License-Identifier: Apache-2.0 */
#include "render/lights.h"

#include "base/error.h"
#include "render/call.h"
#include "shade/prelude_c.h"

const char *const nd_default_lights[ND_DEFAULT_LIGHTS] = {
    "directional(direction=[-2, 3, 3], irradiance=[2.9, 2.8, 2.7])",
    "directional(direction=[3, 1, 1], irradiance=[0.5, 0.55, 0.6])",
};

#define LIGHT(name, PARAMS)                    \
    typedef struct { PARAMS(FIELD) } name##_p; \
    ND_DEFINE_SCHEMA(name##_schema, #name, PARAMS, name##_p)
#include "render/lights.def"
#undef LIGHT

typedef union {
#define LIGHT(name, PARAMS) name##_p name;
#include "render/lights.def"
#undef LIGHT
} any_light;

static bool make_directional(nd_binding *b, const any_light *from, nd_light *to) {
    vec3 d = from->directional.direction, e = from->directional.irradiance;
    if (!nd_call_needs(b, "direction")) return false;
    if (d.x == 0.0f && d.y == 0.0f && d.z == 0.0f)
        return nd_fail(b->error, NDL_E_RANGE, nd_given(b, "direction")->value.column,
                       "'direction' may not be zero", NULL);
    *to = (nd_light){.v = dv_unit(dv((double)d.x, (double)d.y, (double)d.z)),
                     .rgb = {(double)e.x, (double)e.y, (double)e.z}};
    return true;
}

static bool make_point(nd_binding *b, const any_light *from, nd_light *to) {
    vec3 p = from->point.position, i = from->point.intensity;
    if (!nd_call_needs(b, "position")) return false;
    *to = (nd_light){.is_point = true,
                     .decays = nd_choice(b, "decay") == 0,
                     .v = dv((double)p.x, (double)p.y, (double)p.z),
                     .rgb = {(double)i.x, (double)i.y, (double)i.z}};
    return true;
}

bool nd_light_parse(const char *text, nd_light *light, ndl_error *error) {
#define LIGHT(name, PARAMS) name##_schema(),
    const nd_schema *const schemas[] = {
#include "render/lights.def"
        NULL};
#undef LIGHT
#define LIGHT(name, PARAMS) make_##name,
    static bool (*const make[])(nd_binding *, const any_light *, nd_light *) = {
#include "render/lights.def"
    };
#undef LIGHT
    nd_arena arena = {0};
    nd_binding b;
    any_light fields;
    int kind = nd_call_parse(text, "light", schemas, &arena, &b, &fields, error);
    bool made = kind >= 0 && make[kind](&b, &fields, light);
    nd_arena_free(&arena);
    return made;
}

bool nd_light_arrives(const nd_light *light, dvec p, dvec *direction, double *distance,
                      double irradiance[3]) {
    double attenuation = 1.0;
    *direction = light->v;
    *distance = (double)INFINITY;
    if (light->is_point) {
        dvec to = dv_sub(light->v, p);
        double square = dv_dot(to, to);
        if (!(square > 0.0)) return false;
        *distance = sqrt(square);
        *direction = dv_scale(to, 1.0 / *distance);
        if (light->decays) attenuation = 1.0 / square;
    }
    for (int c = 0; c < 3; c++) irradiance[c] = light->rgb[c] * attenuation;
    return true;
}
