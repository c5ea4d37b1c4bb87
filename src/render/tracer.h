/* SPDX-License-Identifier: Apache-2.0 */
/* Rays against triangles. */
#ifndef ND_RENDER_TRACER_H
#define ND_RENDER_TRACER_H
#include "io/mesh.h"
#include "render/camera.h"

typedef struct nd_tracer nd_tracer;

/* An acceleration structure over the mesh, which must outlive it. It is built by one thread, so
   that it, and with it every tie at a shared edge, is the same on every run. NULL on failure. */
nd_tracer *nd_tracer_new(const nd_mesh *mesh, ndl_error *error);
void nd_tracer_free(nd_tracer *tracer);

/* The nearest triangle along the ray, if any. */
bool nd_tracer_hit(const nd_tracer *tracer, nd_ray ray, uint32_t *triangle);

/* Whether a triangle lies on the ray before `distance` (may be infinite). */
bool nd_tracer_blocked(const nd_tracer *tracer, nd_ray ray, double distance);

#endif
