/* SPDX-License-Identifier: Apache-2.0 */
/* Compiled once per instruction set with -DNDL_ISA=<name>; see kernels.h. */
#include "core/kernels.h"

#include "core/microfacet_combinations.h"

#include <string.h>

#ifndef NDL_ISA
#define NDL_ISA scalar
#endif
#define PASTE2(a, b) a##b
#define PASTE(a, b) PASTE2(a, b)

#define LANES _Pragma("omp simd") for (size_t i = 0; i < n; i++)

/* Local names of what a loop reads and writes. */
#define DIRECTIONS(q)                                                                              \
    const size_t n = (q)->n;                                                                       \
    const float *ix = (q)->wi[0], *iy = (q)->wi[1], *iz = (q)->wi[2];                              \
    const float *ox = (q)->wo[0], *oy = (q)->wo[1], *oz = (q)->wo[2];
#define OUTPUTS(q) float *r = (q)->out[0], *g = (q)->out[1], *b = (q)->out[2];
#define WI v3(ix[i], iy[i], iz[i])
#define WO v3(ox[i], oy[i], oz[i])

/* A kernel that stores a colour, and one that stores a number in all three channels. */
#define COLOR_KERNEL(name, type, function)                                                         \
    static void name(const void *fields, const nd_batch *q) {                                      \
        DIRECTIONS(q)                                                                              \
        OUTPUTS(q)                                                                                 \
        type p;                                                                                    \
        memcpy(&p, fields, sizeof p);                                                              \
        LANES {                                                                                    \
            vec3 f = function(p, WI, WO);                                                          \
            r[i] = f.x;                                                                            \
            g[i] = f.y;                                                                            \
            b[i] = f.z;                                                                            \
        }                                                                                          \
    }
#define NUMBER_KERNEL(name, type, function)                                                        \
    static void name(const void *fields, const nd_batch *q) {                                      \
        DIRECTIONS(q)                                                                              \
        OUTPUTS(q)                                                                                 \
        type p;                                                                                    \
        memcpy(&p, fields, sizeof p);                                                              \
        LANES {                                                                                    \
            num x = function(p, WI, WO);                                                           \
            r[i] = x;                                                                              \
            g[i] = x;                                                                              \
            b[i] = x;                                                                              \
        }                                                                                          \
    }

/* ---- models with kernels of their own -------------------------------------------------------- */

#define K(model, name, traits)                                                                             \
    COLOR_KERNEL(brdf_of_##name, model##_p, name##_brdf)                                           \
    COLOR_KERNEL(brdf_cos_of_##name, model##_p, name##_brdf_cos)
#define MODEL(name, NAME) NAME##_KERNELS(K)
#define COMPOSED(name, NAME, ndf)
#include "core/models.def"
#undef MODEL
#undef COMPOSED
#undef K

/* ---- composed models, in steps ----------------------------------------------------------------

   The same operations in the same order as the fused MICROFACET_COMBINATION: the steps give its
   bits, at the price of storing the quotient between them (tests/unit holds them together). */

#define T(ndf)                                                                                     \
    static void ndf_of_##ndf(const void *fields, const nd_batch *q) {                              \
        DIRECTIONS(q)                                                                              \
        float *num_out = q->out[0], *den_out = q->out[1];                                          \
        microfacet_p p;                                                                            \
        memcpy(&p, fields, sizeof p);                                                              \
        LANES {                                                                                    \
            halfway m = halfway_of(WI, WO);                                                        \
            ratio d = ND_NDF_##ndf;                                                                \
            num_out[i] = d.n;                                                                      \
            den_out[i] = d.d;                                                                      \
        }                                                                                          \
    }
NDF_LIST(T)
#undef T

#define MASKING_STEP(name, ndf, masking, over, under)                                              \
    static void name(const void *fields, const nd_batch *q) {                                      \
        DIRECTIONS(q)                                                                              \
        float *num_out = q->out[0], *den_out = q->out[1];                                          \
        microfacet_p p;                                                                            \
        memcpy(&p, fields, sizeof p);                                                              \
        LANES {                                                                                    \
            vec3 wi = WI, wo = WO;                                                                 \
            halfway m = halfway_of(wi, wo);                                                        \
            visibility v = ND_MASKING_##masking(ndf);                                              \
            num_out[i] = num_out[i] * v.over;                                                      \
            den_out[i] = den_out[i] * v.under;                                                     \
            (void)m;                                                                               \
        }                                                                                          \
    }
#define BOTH_MASKING_STEPS(ndf, masking)                                                           \
    MASKING_STEP(masking_of_##ndf##_##masking, ndf, masking, n, d)                                 \
    MASKING_STEP(masking_cos_of_##ndf##_##masking, ndf, masking, n_cos, d_cos)                     \
    MICROFACET_TERM_MASKING(ndf, masking)                                                          \
    NUMBER_KERNEL(term_v_of_##ndf##_##masking, microfacet_p, microfacet_term_v_##ndf##_##masking)  \
    NUMBER_KERNEL(term_g_of_##ndf##_##masking, microfacet_p, microfacet_term_g_##ndf##_##masking)
#define T(ndf, masking) BOTH_MASKING_STEPS(ndf, masking)
VISIBILITY_LIST
#undef T

#define T(fresnel)                                                                                 \
    static void fresnel_of_##fresnel(const void *fields, const nd_batch *q, const float *over,     \
                                     const float *under) {                                         \
        DIRECTIONS(q)                                                                              \
        OUTPUTS(q)                                                                                 \
        microfacet_p p;                                                                            \
        memcpy(&p, fields, sizeof p);                                                              \
        LANES {                                                                                    \
            vec3 wi = WI, wo = WO;                                                                 \
            halfway m = halfway_of(wi, wo);                                                        \
            vec3 fr = ND_FRESNEL_##fresnel;                                                        \
            vec3 f = microfacet_value(lit(wi, wo), p.color, fr, over[i], under[i]);                \
            r[i] = f.x;                                                                            \
            g[i] = f.y;                                                                            \
            b[i] = f.z;                                                                            \
            (void)m;                                                                               \
        }                                                                                          \
    }                                                                                              \
    MICROFACET_TERM_F(fresnel)                                                                     \
    COLOR_KERNEL(term_f_of_##fresnel, microfacet_p, microfacet_term_f_##fresnel)
FRESNEL_LIST(T)
#undef T

#define T(ndf)                                                                                     \
    MICROFACET_TERM_D(ndf)                                                                         \
    NUMBER_KERNEL(term_d_of_##ndf, microfacet_p, microfacet_term_d_##ndf)
NDF_LIST(T)
#undef T

NUMBER_KERNEL(metal_rough_d, metal_rough_p, metal_rough_term_d)
NUMBER_KERNEL(metal_rough_g, metal_rough_p, metal_rough_term_g)
NUMBER_KERNEL(metal_rough_v, metal_rough_p, metal_rough_term_v)
COLOR_KERNEL(metal_rough_f, metal_rough_p, metal_rough_term_f)

/* ---- the table ------------------------------------------------------------------------------- */

#define ND_STRING2(x) #x
#define ND_STRING(x) ND_STRING2(x)

#define TABLE PASTE(nd_kernels_, NDL_ISA)
extern const nd_kernel_table TABLE;
const nd_kernel_table TABLE = {
    .isa = ND_STRING(NDL_ISA),
#define COMPOSED(name, NAME, ndf)
#define MODEL(name, NAME) NAME##_KERNELS(K)
#define K(model, name, traits) [ND_KERNEL_##name] = brdf_of_##name,
    .brdf = {
#include "core/models.def"
    },
#undef K
#define K(model, name, traits) [ND_KERNEL_##name] = brdf_cos_of_##name,
    .brdf_cos = {
#include "core/models.def"
    },
#undef K
#undef MODEL
#undef COMPOSED
#define T(ndf) ndf_of_##ndf,
    .ndf = {NDF_LIST(T)},
#undef T
#define T(ndf) term_d_of_##ndf,
    .term_d = {NDF_LIST(T)},
#undef T
#define T(ndf, masking) masking_of_##ndf##_##masking,
    .masking = {VISIBILITY_LIST},
#undef T
#define T(ndf, masking) masking_cos_of_##ndf##_##masking,
    .masking_cos = {VISIBILITY_LIST},
#undef T
#define T(ndf, masking) term_v_of_##ndf##_##masking,
    .term_v = {VISIBILITY_LIST},
#undef T
#define T(ndf, masking) term_g_of_##ndf##_##masking,
    .term_g = {VISIBILITY_LIST},
#undef T
#define T(fresnel) fresnel_of_##fresnel,
    .fresnel = {FRESNEL_LIST(T)},
#undef T
#define T(fresnel) term_f_of_##fresnel,
    .term_f = {FRESNEL_LIST(T)},
#undef T
    .metal_rough_term = {metal_rough_d, metal_rough_g, metal_rough_v, metal_rough_f},
};
