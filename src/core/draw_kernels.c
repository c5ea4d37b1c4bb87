/* SPDX-License-Identifier: Apache-2.0 */
/* Compiled once per instruction set with -DNDL_ISA=<name>; see draw.h. */
#include "core/draw.h"

#include "core/loops.h"

#ifndef NDL_ISA
#define NDL_ISA scalar
#endif
#define PASTE2(a, b) a##b
#define PASTE(a, b) PASTE2(a, b)

/* prefix_sample(p, wo, u) and prefix_pdf(p, wi, wo) of the shading text, as loops. */
#define DRAW_KERNELS(model, prefix)                                                                \
    static void sample_of_##prefix(nd_inputs in, const nd_batch *q) {                              \
        DIRECTIONS(q)                                                                              \
        OUTPUTS(q)                                                                                 \
        UNIFORM_FIELDS(model)                                                                      \
        LANES {                                                                                    \
            vec3 w = prefix##_sample(p, WO, WI);                                                   \
            r[i] = w.x;                                                                            \
            g[i] = w.y;                                                                            \
            b[i] = w.z;                                                                            \
        }                                                                                          \
    }                                                                                              \
    static void pdf_of_##prefix(nd_inputs in, const nd_batch *q) {                                 \
        DIRECTIONS(q)                                                                              \
        float *pdf = q->out[0];                                                                    \
        UNIFORM_FIELDS(model)                                                                      \
        LANES {                                                                                    \
            pdf[i] = prefix##_pdf(p, WI, WO);                                                      \
        }                                                                                          \
    }

#define MODEL(name, NAME) DRAW_KERNELS(name, name)
#define COMPOSED(name, NAME, ndf)
#include "core/models.def"
#undef MODEL
#define T(ndf) DRAW_KERNELS(microfacet, microfacet_##ndf)
NDF_LIST(T)
#undef T

FN num weight_of(num f, num pdf) {
    return sel(pdf > 0.0f, storable(f / sel(pdf > 0.0f, pdf, 1.0f)), 0.0f);
}

static void weigh(nd_inputs in, const nd_batch *q) {
    const size_t n = q->n & ~(size_t)(ND_GROUP - 1);
    const float *pdf = q->wi[0];
    OUTPUTS(q)
    (void)in;
    LANES {
        r[i] = weight_of(r[i], pdf[i]);
        g[i] = weight_of(g[i], pdf[i]);
        b[i] = weight_of(b[i], pdf[i]);
    }
}

#define TABLE PASTE(nd_draws_, NDL_ISA)
extern const nd_draw_table TABLE;
const nd_draw_table TABLE = {
    .weigh = weigh,
#define MODEL(name, NAME) [ND_SAMPLER_##name] = sample_of_##name,
#define T(ndf) [ND_SAMPLER_microfacet_##ndf] = sample_of_microfacet_##ndf,
    .sample = {
#include "core/models.def"
        NDF_LIST(T)
    },
#undef MODEL
#undef T
#define MODEL(name, NAME) [ND_SAMPLER_##name] = pdf_of_##name,
#define T(ndf) [ND_SAMPLER_microfacet_##ndf] = pdf_of_microfacet_##ndf,
    .pdf = {
#include "core/models.def"
        NDF_LIST(T)
    },
#undef MODEL
#undef T
};
