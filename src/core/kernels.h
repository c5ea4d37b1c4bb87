/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels: loops over batches of directions, the only place where the models' shading text is
   compiled. kernels.c is built once per instruction set; every build fills one table. All tables
   give the same bits: the text uses correctly rounded operations only. */
#ifndef ND_CORE_KERNELS_H
#define ND_CORE_KERNELS_H
#include "core/models.h"

typedef struct {
    size_t n;
    const float *wi[3], *wo[3];
    float *out[3]; /* r g b; may be an input array itself, not one shifted against it */
} nd_batch;

enum { ND_TILE = 256, ND_MOST_GROUP = 16 }; /* a tile's scratch stays in the first cache */

/* Parameters of a loop. Uniform kernels read `fields`, the struct <model>_p of the lobe. Kernels
   with parameters per lane read every number from its stream, streams[offset of the field in the
   struct / sizeof(float)], and tables from `fields`. */
typedef struct {
    const void *fields;
    const float *const *streams;
} nd_inputs;

typedef void nd_kernel(nd_inputs in, const nd_batch *q);
/* The last step of a composed model: the quotient D V in, the value out. */
typedef void nd_fresnel_step(nd_inputs in, const nd_batch *q, const float *n, const float *d);

/* One set of loops: with uniform parameters, or with parameters per lane. */
typedef struct {
    nd_kernel *brdf[ND_KERNELS], *brdf_cos[ND_KERNELS];
    /* Combinations of a composed model that are one loop each. */
    nd_kernel *fused[ND_FUSED], *fused_cos[ND_FUSED];
    /* Any combination, in three steps: the distribution writes D as the quotient out[0]/out[1],
       the masking multiplies V (or V NoL) into it, the Fresnel step divides, once. */
    nd_kernel *ndf[ND_NDFS], *masking[ND_VISIBILITIES], *masking_cos[ND_VISIBILITIES];
    nd_fresnel_step *fresnel[ND_FRESNELS];
} nd_loops;

typedef struct {
    nd_loops uniform, lanes;
    size_t group; /* loops run n - n % group lanes */
} nd_kernel_table;

/* The terms by themselves, the same number in all channels for D, V and G (terms.c). Compiled for
   the plainest instruction set only: they are looked at, not rendered with. */
typedef struct {
    nd_kernel *d[ND_NDFS], *v[ND_VISIBILITIES], *g[ND_VISIBILITIES], *f[ND_FRESNELS];
    nd_kernel *metal_rough[4]; /* by ndl_term_kind */
} nd_term_table;
extern const nd_term_table nd_terms;

/* The table in use (dispatch.c). */
const nd_kernel_table *nd_kernels(void);

#endif
