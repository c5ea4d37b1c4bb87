/* SPDX-License-Identifier: Apache-2.0 */
/* Tone maps: from linear radiance in [0, inf) to linear display values in [0, 1], per channel. */
#ifndef ND_RENDER_TONEMAP_H
#define ND_RENDER_TONEMAP_H
#include "ndotl/ndotl.h"

#include <stdbool.h>

/* HIDDEN fields keep the structs of those without a parameter from being empty. */
#define CLAMP_PARAMS(P) P(HIDDEN, unused, 0, "")
#define REINHARD_PARAMS(P) P(HIDDEN, unused, 0, "")
#define REINHARD_EXTENDED_PARAMS(P) \
    P(NUM_ABOVE, white, 0, 3.4e38, 4, "1", "the smallest value that becomes white")
#define EXPONENTIAL_PARAMS(P) P(NUM_ABOVE, k, 0, 3.4e38, 1, "1", "slope at black")
#define ACES_PARAMS(P) P(HIDDEN, unused, 0, "")

typedef struct nd_tonemap {
    double (*apply)(double x, double parameter); /* x >= 0; the result in [0, 1] */
    double parameter;
} nd_tonemap;

/* A tone map from its expression, such as "exponential(k=2)". Errors: false, with the column. */
bool nd_tonemap_parse(const char *text, nd_tonemap *map, ndl_error *error);

#endif
