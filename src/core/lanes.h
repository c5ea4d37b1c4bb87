/* SPDX-License-Identifier: Apache-2.0 */
/* Parameters per lane: which streams a lobe's fields read. */
#ifndef ND_CORE_LANES_H
#define ND_CORE_LANES_H
#include "core/eval.h"

enum { ND_MOST_FIELDS = 24, ND_MOST_LANES = 32 }; /* numbers of the largest struct, with room */

/* A tile of streams, one for each number of a lobe's struct. */
typedef struct {
    float value[ND_MOST_FIELDS][ND_TILE];
    const float *stream[ND_MOST_FIELDS];
} nd_lane_tile;

/* One lane that is a number of the struct, or a colour: cut to [low, high], times `scale`. */
typedef struct {
    const float *values;
    float low, high;
    double scale; /* pi/180 for degrees, else 1 */
    int first, last; /* fields that it fills */
    bool spells_sigma; /* Oren and Nayar's A */
} nd_plain_lane;

/* What the lanes of a call mean for one lobe: keys are looked up once, not for every tile. */
typedef struct {
    nd_plain_lane plain[ND_MOST_LANES];
    size_t plain_count;
    /* Lanes of the width, or NULL, and what m gives where there is none. */
    const float *alpha, *roughness, *anisotropy, *alpha_x, *alpha_y;
    float base, stretch, largest;
    int map, kind;         /* words of roughness_map (-1: the base is an alpha), anisotropy_kind */
    int x, y, direct;      /* fields of the widths and of direct_roughness, -1 for none */
    bool direct_is_root;   /* it follows alpha_x */
    size_t field_count;
} nd_lane_plan;

/* Checks that every lane key names a number of the material and that none excludes another. */
bool nd_lanes_valid(const ndl_material *m, size_t lanes, const ndl_lanes *lane, ndl_error *error);

/* The plan of lobe `at`. Lanes must be valid. */
void nd_lanes_plan(const ndl_material *m, size_t at, size_t lanes, const ndl_lanes *lane,
                   nd_lane_plan *plan);

/* Fills the first n entries (up to the next whole group) of the streams of a lobe with its uniform
   fields: once for a call. */
void nd_lanes_uniform(const nd_lobe *l, size_t n, nd_lane_tile *t);

/* Fills in what the lanes [from, from + n) give; entries up to the next whole group repeat the
   last one. */
void nd_lanes_fill(const nd_lane_plan *plan, size_t from, size_t n, nd_lane_tile *t);

#endif
