/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels: loops over batches of directions, the only place where shading text is compiled.
   kernels.c is built once per instruction set; every build fills one table. All tables give the
   same bits: the text uses correctly rounded operations only. */
#ifndef ND_CORE_KERNELS_H
#define ND_CORE_KERNELS_H
#include "core/models.h"

typedef struct {
    size_t n;
    const float *wi[3], *wo[3];
    float *out[3]; /* r g b; may be an input array itself, not one shifted against it */
} nd_batch;

/* fields: the struct <model>_p of the lobe. */
typedef void nd_kernel(const void *fields, const nd_batch *q);

typedef struct {
    const char *isa;
    nd_kernel *brdf[ND_KERNELS], *brdf_cos[ND_KERNELS];
    /* A composed model in three steps: the distribution writes D as the quotient out[0]/out[1],
       the masking multiplies V (or V NoL) into it, the Fresnel step divides, once, and writes the
       value. The Fresnel step reads the quotient from `term` and writes to q->out. */
    nd_kernel *ndf[ND_NDFS];
    nd_kernel *masking[ND_VISIBILITIES], *masking_cos[ND_VISIBILITIES];
    void (*fresnel[ND_FRESNELS])(const void *fields, const nd_batch *q, const float *n,
                                 const float *d);
    /* The terms by themselves, the same number in all channels for D, V and G. */
    nd_kernel *term_d[ND_NDFS], *term_f[ND_FRESNELS];
    nd_kernel *term_v[ND_VISIBILITIES], *term_g[ND_VISIBILITIES];
    /* The factors of metal_rough's highlight, by ndl_term_kind. */
    nd_kernel *metal_rough_term[4];
} nd_kernel_table;

/* The table in use, and the choice of another one (dispatch.c). */
const nd_kernel_table *nd_kernels(void);

#endif
