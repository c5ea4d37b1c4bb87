/* SPDX-License-Identifier: Apache-2.0 */
#ifndef ND_RENDER_CAMERA_H
#define ND_RENDER_CAMERA_H
#include "render/vec.h"

#include <stdbool.h>

#define PERSPECTIVE_PARAMS(P)                                                                      \
    P(VECTOR, eye, 0, 0, 0, "1", "default: so far along +z that the bounding sphere fits")        \
    P(VECTOR, target, 0, 0, 0, "1", "default: the centre of the bounding sphere")                 \
    P(VECTOR, up, 0, 1, 0, "1", "what is up in the picture")                                       \
    P(ANGLE, fov_y, 0.0017453292519943296, 3.1066860685499069, 0.61086523819801535,               \
      "vertical field of view; default 35 degrees")

#define PARALLEL_PARAMS(P)                                                                         \
    P(VECTOR, eye, 0, 0, 0, "1", "default: in front of the bounding sphere, along +z")            \
    P(VECTOR, target, 0, 0, 0, "1", "default: the centre of the bounding sphere")                 \
    P(VECTOR, up, 0, 1, 0, "1", "what is up in the picture")                                       \
    P(NUM_ABOVE, height, 0, 3e38, 1, "1", "of the picture; default: the bounding sphere fits")

/* A camera as it was described; what was left out is found from the scene. */
typedef struct {
    bool is_parallel, has_eye, has_target, has_up, has_height;
    dvec eye, target, up;
    double fov_y, height;
} nd_camera;

/* A camera placed: pixel coordinates to rays. */
typedef struct {
    bool is_parallel;
    dvec eye, right, up, forward; /* right and up scaled to half the picture (at distance 1) */
    double width, height;         /* pixels */
} nd_view;

typedef struct { dvec origin, direction; } nd_ray; /* direction: unit */

/* A camera from its expression. Errors: false, with the column. */
bool nd_camera_parse(const char *text, nd_camera *camera, ndl_error *error);

/* The camera of a scene that names none: along -z, the bounding sphere framed, 35 degrees. */
nd_camera nd_camera_default(void);

/* Places the camera before a bounding sphere, for a picture of width x height pixels. Where no `up`
   was given and the view is vertical, -z is up.
   Errors:   false with NDL_E_RANGE: eye and target are one point, or `up` is along the view. */
bool nd_camera_place(const nd_camera *camera, dvec centre, double radius, int width, int height,
                     nd_view *view, ndl_error *error);

/* The ray through pixel coordinates (x, y): (0, 0) is the upper left corner of the picture, the
   centre of the first pixel is (0.5, 0.5). */
nd_ray nd_view_ray(const nd_view *view, double x, double y);

#endif
