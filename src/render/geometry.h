/* SPDX-License-Identifier: Apache-2.0 */
/* What a ray meets: analytic shapes and triangle meshes. World: right-handed, y up. */
#ifndef ND_RENDER_GEOMETRY_H
#define ND_RENDER_GEOMETRY_H
#include "io/mesh.h"
#include "render/camera.h"
#include "render/tracer.h"

/* A point of a surface. n and g are turned to the viewer. */
typedef struct {
    dvec p, n, t; /* position; unit shading normal; unit tangent, perpendicular to n */
    dvec g;       /* unit normal of the true surface */
    double u, v;  /* texture coordinates */
    uint32_t part;
} nd_surface;

/* One analytic shape. hit() gives the surface without regard to the viewer, g = n. */
typedef struct {
    const char *name;
    double radius; /* of the bounding sphere at the origin */
    bool (*hit)(nd_ray ray, nd_surface *s);
    bool (*blocks)(nd_ray ray, double distance);
} nd_shape;

typedef struct {
    const nd_shape *shape; /* NULL: mesh and tracer */
    nd_mesh mesh;          /* its parts name the shape too */
    nd_tracer *tracer;
    dvec centre; /* bounding sphere */
    double radius;
} nd_geometry;

/* A built-in (nd_geometry_names) or a mesh file.
   Errors:   false: those of nd_mesh_import. */
bool nd_geometry_load(const char *name, nd_geometry *g, ndl_error *error);
void nd_geometry_free(nd_geometry *g);

/* The first surface along a ray; false where there is none. */
bool nd_geometry_hit(const nd_geometry *g, nd_ray ray, nd_surface *s);

/* Whether something lies between the surface and a light at a distance in a direction. */
bool nd_geometry_blocks(const nd_geometry *g, const nd_surface *s, dvec direction, double distance);

/* The analytic shape of that name, or NULL (shapes.c). */
const nd_shape *nd_shape_find(const char *name);

/* The horizontal direction y x n, unit; +x where n is vertical: the tangent of a surface without
   texture coordinates, and of the sphere. */
dvec nd_horizontal(dvec n);

#endif
