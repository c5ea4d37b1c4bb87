/* SPDX-License-Identifier: Apache-2.0 */
/* Drawing directions: one sampler and one density for each model, and for each ndf of the composed
   ones. draw_kernels.c is compiled once per instruction set, as kernels.c is. */
#ifndef ND_CORE_DRAW_H
#define ND_CORE_DRAW_H
#include "core/kernels.h"
#include "core/material.h"

enum {
#define MODEL(name, NAME) ND_SAMPLER_##name,
#define COMPOSED(name, NAME, ndf)
#include "core/models.def"
#undef MODEL
#undef COMPOSED
#define T(ndf) ND_SAMPLER_microfacet_##ndf,
    NDF_LIST(T)
#undef T
        ND_SAMPLERS
};

typedef struct {
    nd_kernel *sample[ND_SAMPLERS]; /* the batch's wi is u, out the direction */
    nd_kernel *pdf[ND_SAMPLERS];    /* out[0] is the density, 1/sr */
    nd_kernel *weigh;               /* out, f cos, over the density wi[0]; 0 where that is 0 */
} nd_draw_table;

/* The table in use (dispatch.c). */
const nd_draw_table *nd_draws(void);

/* Fills in the share of every lobe. A lobe whose weight is not 0 is drawn, however dark it is. */
void nd_share_draws(ndl_material *m);

/* How often lobe l of m is drawn for a viewer at wo.z: share(l)/(sum of all shares). */
float nd_lobe_share(const nd_lobe *l, float wo_z);

#endif
