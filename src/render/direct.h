/* SPDX-License-Identifier: Apache-2.0 */
/* The `direct` integrator on one tile of the picture. */
#ifndef ND_RENDER_DIRECT_H
#define ND_RENDER_DIRECT_H
#include "render/scene.h"

enum { ND_TILE_SIDE = 32, ND_BATCH = ND_TILE_SIDE * ND_TILE_SIDE };

typedef struct { float x[ND_BATCH], y[ND_BATCH], z[ND_BATCH]; } nd_lanes;

/* What one thread needs: a batch of hits, gathered for one sample a pixel of the tile, sorted by
   material and shaded with the batch kernels. */
typedef struct {
    nd_surface hit[ND_BATCH], sorted[ND_BATCH];
    int pixel[ND_BATCH], sorted_pixel[ND_BATCH], order[ND_BATCH];
    nd_ray ray[ND_BATCH];
    nd_lanes wi, wo, value;      /* local frame; what the kernels give */
    double light[ND_BATCH][3];   /* irradiance, 0 where nothing arrives */
    double result[ND_BATCH][3];  /* of each sorted hit */
    double sum[ND_BATCH][3];     /* of each pixel of the tile */
    ndl_render_stats stats;
} nd_tile_room;

typedef struct {
    const ndl_scene *scene;
    const ndl_render_desc *desc; /* defaults filled in */
    nd_view view;
    ndl_image *image;
} nd_direct;

/* Renders the tile whose upper left pixel is (x, y) into the picture. */
void nd_direct_tile(const nd_direct *d, nd_tile_room *room, int x, int y);

#endif
