/* SPDX-License-Identifier: Apache-2.0 */
/* Parameters per lane: which streams a lobe's fields read. */
#ifndef ND_CORE_LANES_H
#define ND_CORE_LANES_H
#include "core/eval.h"

enum { ND_MOST_FIELDS = 24 }; /* numbers in the largest struct of fields, with room */

/* A tile of streams, one for each number of a lobe's struct. */
typedef struct {
    float value[ND_MOST_FIELDS][ND_TILE];
    const float *stream[ND_MOST_FIELDS];
} nd_lane_tile;

/* Checks that every lane key names a number of the material and that none excludes another. */
bool nd_lanes_valid(const ndl_material *m, size_t lanes, const ndl_lanes *lane, ndl_error *error);

/* Fills the streams of lobe `at` with its uniform fields: once for a call. */
void nd_lanes_uniform(const nd_lobe *l, nd_lane_tile *t);

/* Fills in what the lanes [from, from + n) give; entries up to the next whole group repeat the
   last one. */
void nd_lanes_fill(const ndl_material *m, size_t at, size_t lanes, const ndl_lanes *lane,
                   size_t from, size_t n, nd_lane_tile *t);

#endif
