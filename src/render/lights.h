/* SPDX-License-Identifier: Apache-2.0 */
#ifndef ND_RENDER_LIGHTS_H
#define ND_RENDER_LIGHTS_H
#include "render/vec.h"

#include <stdbool.h>

#define DIRECTIONAL_PARAMS(P)                                                                      \
    P(VECTOR, direction, 0, 0, 0, "1", "from the surface to the light; of any length")            \
    P(RGB, irradiance, 0, 3.4e38, 1, "W/m^2", "what arrives on a surface that faces the light")

#define POINT_PARAMS(P)                                                                            \
    P(VECTOR, position, 0, 0, 0, "1", "in the world")                                              \
    P(RGB, intensity, 0, 3.4e38, 1, "W/sr", "irradiance at distance 1")                            \
    P(CHOICE, decay, "inverse_square none", inverse_square,                                        \
      "none: the intensity is the irradiance at any distance")

typedef struct {
    bool is_point;  /* v is its position; otherwise the unit direction to the light */
    bool decays;    /* by the square of the distance */
    dvec v;
    double rgb[3];  /* irradiance, or intensity */
} nd_light;

/* A light from its expression, such as "point(position=[0, 2, 0], intensity=5)".
   Errors:   false, with the column. */
bool nd_light_parse(const char *text, nd_light *light, ndl_error *error);

/* What a light sends to a point p: the unit direction to it, its distance (infinite for a
   directional light) and the irradiance on a surface that faces it. False where nothing arrives:
   at the light itself. */
bool nd_light_arrives(const nd_light *light, dvec p, dvec *direction, double *distance,
                      double irradiance[3]);

/* The lights of a scene that names none: a key light from the upper left and a fill light. */
enum { ND_DEFAULT_LIGHTS = 2 };
extern const char *const nd_default_lights[ND_DEFAULT_LIGHTS];

#endif
