/* SPDX-License-Identifier: Apache-2.0 */
#include "render/camera.h"

#include "base/error.h"
#include "render/call.h"
#include "shade/prelude_c.h"

#define CAMERA(name, PARAMS)                   \
    typedef struct { PARAMS(FIELD) } name##_p; \
    ND_DEFINE_SCHEMA(name##_schema, #name, PARAMS, name##_p)
#include "render/cameras.def"
#undef CAMERA

typedef union {
#define CAMERA(name, PARAMS) name##_p name;
#include "render/cameras.def"
#undef CAMERA
} any_camera;

static dvec widen(vec3 v) {
    return dv((double)v.x, (double)v.y, (double)v.z);
}

static nd_camera common(const nd_binding *b, vec3 eye, vec3 target, vec3 up) {
    return (nd_camera){.has_eye = nd_given(b, "eye") != NULL,
                       .has_target = nd_given(b, "target") != NULL,
                       .has_up = nd_given(b, "up") != NULL,
                       .eye = widen(eye),
                       .target = widen(target),
                       .up = widen(up)};
}

static nd_camera make_perspective(const nd_binding *b, const any_camera *from) {
    const perspective_p *p = &from->perspective;
    nd_camera c = common(b, p->eye, p->target, p->up);
    c.fov_y = (double)p->fov_y;
    return c;
}

static nd_camera make_parallel(const nd_binding *b, const any_camera *from) {
    const parallel_p *p = &from->parallel;
    nd_camera c = common(b, p->eye, p->target, p->up);
    c.is_parallel = true;
    c.has_height = nd_given(b, "height") != NULL;
    c.height = (double)p->height;
    return c;
}

bool nd_camera_parse(const char *text, nd_camera *camera, ndl_error *error) {
#define CAMERA(name, PARAMS) name##_schema(),
    const nd_schema *const schemas[] = {
#include "render/cameras.def"
        NULL};
#undef CAMERA
#define CAMERA(name, PARAMS) make_##name,
    static nd_camera (*const make[])(const nd_binding *, const any_camera *) = {
#include "render/cameras.def"
    };
#undef CAMERA
    nd_arena arena = {0};
    nd_binding b;
    any_camera fields;
    int kind = nd_call_parse(text, "camera", schemas, &arena, &b, &fields, error);
    if (kind >= 0) *camera = make[kind](&b, &fields);
    nd_arena_free(&arena);
    return kind >= 0;
}

nd_camera nd_camera_default(void) {
    nd_camera c = {0};
    nd_camera_parse("perspective", &c, NULL);
    return c;
}

/* Right, up and forward of a camera, orthonormal. */
static bool orient(const nd_camera *c, dvec eye, dvec target, nd_view *view, ndl_error *error) {
    dvec forward = dv_unit(dv_sub(target, eye));
    if (!(dv_dot(forward, forward) > 0.0))
        return nd_fail(error, NDL_E_RANGE, 0, "'eye' and 'target' are one point; move one", NULL);
    dvec up = dv_unit(c->up);
    dvec right = dv_cross(forward, up);
    const double parallel = 1e-6; /* sine of the angle below which a direction has no meaning */
    if (dv_length(right) < parallel && !c->has_up) right = dv_cross(forward, dv(0.0, 0.0, -1.0));
    if (dv_length(right) < parallel)
        return nd_fail(error, NDL_E_RANGE, 0,
                       "'up' is along the view from 'eye' to 'target'; give another", NULL);
    view->forward = forward;
    view->right = dv_unit(right);
    view->up = dv_cross(view->right, forward);
    return true;
}

bool nd_camera_place(const nd_camera *c, dvec centre, double radius, int width, int height,
                     nd_view *view, ndl_error *error) {
    double aspect = (double)width / (double)height;
    double narrow = aspect < 1.0 ? aspect : 1.0; /* the smaller side relative to the height */
    double half = tan(0.5 * c->fov_y), distance = 2.0 * radius;
    if (c->is_parallel) half = c->has_height ? 0.5 * c->height : radius / narrow;
    else distance = radius / sin(atan(narrow * half));
    dvec target = c->has_target ? c->target : centre;
    dvec eye = c->has_eye ? c->eye : dv_add(target, dv(0.0, 0.0, distance));
    *view = (nd_view){.is_parallel = c->is_parallel,
                      .eye = eye,
                      .width = (double)width,
                      .height = (double)height};
    if (!orient(c, eye, target, view, error)) return false;
    view->right = dv_scale(view->right, half * aspect);
    view->up = dv_scale(view->up, half);
    return true;
}

nd_ray nd_view_ray(const nd_view *view, double x, double y) {
    dvec aside = dv_add(dv_scale(view->right, 2.0 * x / view->width - 1.0),
                        dv_scale(view->up, 1.0 - 2.0 * y / view->height));
    if (view->is_parallel) return (nd_ray){dv_add(view->eye, aside), view->forward};
    return (nd_ray){view->eye, dv_unit(dv_add(view->forward, aside))};
}
