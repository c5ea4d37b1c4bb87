/* SPDX-License-Identifier: Apache-2.0 */
/* Compiled once per instruction set with -DNDL_ISA=<name>; see kernels.h. */
#include "core/kernels.h"

#include "core/loops.h"
#include "core/microfacet_combinations.h"

#ifndef NDL_ISA
#define NDL_ISA scalar
#endif
#define PASTE2(a, b) a##b
#define PASTE(a, b) PASTE2(a, b)

#define COMPOSED(name, NAME, ndf)

/* ---- models with kernels of their own -------------------------------------------------------- */

#define K(model, name, traits)                                                                     \
    COLOR_KERNEL(UNIFORM, brdf_of_##name, model, name##_brdf)                                      \
    COLOR_KERNEL(UNIFORM, brdf_cos_of_##name, model, name##_brdf_cos)                              \
    COLOR_KERNEL(LANES, brdf_lanes_of_##name, model, name##_brdf)                                  \
    COLOR_KERNEL(LANES, brdf_cos_lanes_of_##name, model, name##_brdf_cos)
#define MODEL(name, NAME)                                                                          \
    DEFINE_STREAMS(name, NAME##_PARAMS)                                                            \
    NAME##_KERNELS(K)
#include "core/models.def"
#undef MODEL
#undef K
#define MODEL(name, NAME) NAME##_KERNELS(K)

/* ---- composed models, as one loop ------------------------------------------------------------ */

DEFINE_STREAMS(microfacet, MICROFACET_PARAMS)

#define FUSED(ndf, masking, fresnel)                                                               \
    MICROFACET_COMBINATION(ndf, masking, fresnel)                                                  \
    COLOR_KERNEL(UNIFORM, fused_##ndf##_##masking##_##fresnel, microfacet,                         \
                 microfacet_##ndf##_##masking##_##fresnel##_brdf)                                  \
    COLOR_KERNEL(UNIFORM, fused_cos_##ndf##_##masking##_##fresnel, microfacet,                     \
                 microfacet_##ndf##_##masking##_##fresnel##_brdf_cos)                              \
    COLOR_KERNEL(LANES, fused_lanes_##ndf##_##masking##_##fresnel, microfacet,                     \
                 microfacet_##ndf##_##masking##_##fresnel##_brdf)                                  \
    COLOR_KERNEL(LANES, fused_cos_lanes_##ndf##_##masking##_##fresnel, microfacet,                 \
                 microfacet_##ndf##_##masking##_##fresnel##_brdf_cos)
#include "core/fused.def"
#undef FUSED

/* ---- composed models, in steps ----------------------------------------------------------------

   The same operations in the same order as MICROFACET_COMBINATION: the steps give its bits, at the
   price of storing the quotient between them (tests/laws holds them together). */

#define NDF_STEP(MODE, name, ndf)                                                                  \
    static void name(nd_inputs in, const nd_batch *q) {                                            \
        DIRECTIONS(q)                                                                              \
        float *over = q->out[0], *under = q->out[1];                                               \
        MODE##_FIELDS(microfacet)                                                                  \
        LANES {                                                                                    \
            MODE##_LANE(microfacet)                                                                \
            halfway m = halfway_of(WI, WO);                                                        \
            ratio d = ND_NDF_##ndf;                                                                \
            over[i] = d.n;                                                                         \
            under[i] = d.d;                                                                        \
        }                                                                                          \
    }
#define T(ndf)                                                                                     \
    NDF_STEP(UNIFORM, ndf_of_##ndf, ndf)                                                           \
    NDF_STEP(LANES, ndf_lanes_of_##ndf, ndf)
NDF_LIST(T)
#undef T

#define MASKING_STEP(MODE, name, ndf, masking, part_over, part_under)                              \
    static void name(nd_inputs in, const nd_batch *q) {                                            \
        DIRECTIONS(q)                                                                              \
        float *over = q->out[0], *under = q->out[1];                                               \
        MODE##_FIELDS(microfacet)                                                                  \
        LANES {                                                                                    \
            MODE##_LANE(microfacet)                                                                \
            vec3 wi = WI, wo = WO;                                                                 \
            halfway m = halfway_of(wi, wo);                                                        \
            visibility v = ND_MASKING_##masking(ndf);                                              \
            over[i] = over[i] * v.part_over;                                                       \
            under[i] = under[i] * v.part_under;                                                    \
            (void)m;                                                                               \
            (void)p;                                                                               \
        }                                                                                          \
    }
#define T(ndf, masking)                                                                            \
    MASKING_STEP(UNIFORM, masking_of_##ndf##_##masking, ndf, masking, n, d)                        \
    MASKING_STEP(UNIFORM, masking_cos_of_##ndf##_##masking, ndf, masking, n_cos, d_cos)            \
    MASKING_STEP(LANES, masking_lanes_of_##ndf##_##masking, ndf, masking, n, d)                    \
    MASKING_STEP(LANES, masking_cos_lanes_of_##ndf##_##masking, ndf, masking, n_cos, d_cos)
VISIBILITY_LIST
#undef T

#define FRESNEL_STEP(MODE, name, fresnel)                                                          \
    static void name(nd_inputs in, const nd_batch *q, const float *over, const float *under) {     \
        DIRECTIONS(q)                                                                              \
        OUTPUTS(q)                                                                                 \
        MODE##_FIELDS(microfacet)                                                                  \
        LANES {                                                                                    \
            MODE##_LANE(microfacet)                                                                \
            vec3 wi = WI, wo = WO;                                                                 \
            halfway m = halfway_of(wi, wo);                                                        \
            vec3 fr = ND_FRESNEL_##fresnel;                                                        \
            vec3 f = microfacet_value(lit(wi, wo), p.color, fr, over[i], under[i]);                \
            r[i] = f.x;                                                                            \
            g[i] = f.y;                                                                            \
            b[i] = f.z;                                                                            \
            (void)m;                                                                               \
        }                                                                                          \
    }
#define T(fresnel)                                                                                 \
    FRESNEL_STEP(UNIFORM, fresnel_of_##fresnel, fresnel)                                           \
    FRESNEL_STEP(LANES, fresnel_lanes_of_##fresnel, fresnel)
FRESNEL_LIST(T)
#undef T

/* ---- the table ------------------------------------------------------------------------------- */

#define TABLE PASTE(nd_kernels_, NDL_ISA)
extern const nd_kernel_table TABLE;
const nd_kernel_table TABLE = {
    .group = ND_GROUP,
#define K(model, name, traits) [ND_KERNEL_##name] = brdf_of_##name,
    .uniform.brdf = {
#include "core/models.def"
    },
#undef K
#define K(model, name, traits) [ND_KERNEL_##name] = brdf_cos_of_##name,
    .uniform.brdf_cos = {
#include "core/models.def"
    },
#undef K
#define K(model, name, traits) [ND_KERNEL_##name] = brdf_lanes_of_##name,
    .lanes.brdf = {
#include "core/models.def"
    },
#undef K
#define K(model, name, traits) [ND_KERNEL_##name] = brdf_cos_lanes_of_##name,
    .lanes.brdf_cos = {
#include "core/models.def"
    },
#undef K
#define FUSED(ndf, masking, fresnel) fused_##ndf##_##masking##_##fresnel,
    .uniform.fused = {
#include "core/fused.def"
    },
#undef FUSED
#define FUSED(ndf, masking, fresnel) fused_cos_##ndf##_##masking##_##fresnel,
    .uniform.fused_cos = {
#include "core/fused.def"
    },
#undef FUSED
#define FUSED(ndf, masking, fresnel) fused_lanes_##ndf##_##masking##_##fresnel,
    .lanes.fused = {
#include "core/fused.def"
    },
#undef FUSED
#define FUSED(ndf, masking, fresnel) fused_cos_lanes_##ndf##_##masking##_##fresnel,
    .lanes.fused_cos = {
#include "core/fused.def"
    },
#undef FUSED
#define T(ndf) ndf_of_##ndf,
    .uniform.ndf = {NDF_LIST(T)},
#undef T
#define T(ndf) ndf_lanes_of_##ndf,
    .lanes.ndf = {NDF_LIST(T)},
#undef T
#define T(ndf, masking) masking_of_##ndf##_##masking,
    .uniform.masking = {VISIBILITY_LIST},
#undef T
#define T(ndf, masking) masking_cos_of_##ndf##_##masking,
    .uniform.masking_cos = {VISIBILITY_LIST},
#undef T
#define T(ndf, masking) masking_lanes_of_##ndf##_##masking,
    .lanes.masking = {VISIBILITY_LIST},
#undef T
#define T(ndf, masking) masking_cos_lanes_of_##ndf##_##masking,
    .lanes.masking_cos = {VISIBILITY_LIST},
#undef T
#define T(fresnel) fresnel_of_##fresnel,
    .uniform.fresnel = {FRESNEL_LIST(T)},
#undef T
#define T(fresnel) fresnel_lanes_of_##fresnel,
    .lanes.fresnel = {FRESNEL_LIST(T)},
#undef T
};
