/* SPDX-License-Identifier: Apache-2.0 */
/* The factors D, G, V and F by themselves; see kernels.h. */
/* One lane after the other: a term is looked at, not rendered with. */
#define NDL_PLAIN_LOOPS
#include "core/kernels.h"
#include "core/loops.h"
#include "core/microfacet_combinations.h"

/* A kernel that stores a number in all three channels. */
#define NUMBER_KERNEL(name, model, function)                                                       \
    static void name(nd_inputs in, const nd_batch *q) {                                            \
        DIRECTIONS(q)                                                                              \
        OUTPUTS(q)                                                                                 \
        UNIFORM_FIELDS(model)                                                                      \
        LANES {                                                                                    \
            num x = function(p, WI, WO);                                                           \
            r[i] = x;                                                                              \
            g[i] = x;                                                                              \
            b[i] = x;                                                                              \
        }                                                                                          \
    }

#define T(ndf)                                                                                     \
    MICROFACET_TERM_D(ndf)                                                                         \
    NUMBER_KERNEL(d_of_##ndf, microfacet, microfacet_term_d_##ndf)
NDF_LIST(T)
#undef T

#define T(ndf, masking)                                                                            \
    MICROFACET_TERM_MASKING(ndf, masking)                                                          \
    NUMBER_KERNEL(v_of_##ndf##_##masking, microfacet, microfacet_term_v_##ndf##_##masking)         \
    NUMBER_KERNEL(g_of_##ndf##_##masking, microfacet, microfacet_term_g_##ndf##_##masking)
VISIBILITY_LIST
#undef T

#define T(fresnel)                                                                                 \
    MICROFACET_TERM_F(fresnel)                                                                     \
    COLOR_KERNEL(UNIFORM, f_of_##fresnel, microfacet, microfacet_term_f_##fresnel)
FRESNEL_LIST(T)
#undef T

NUMBER_KERNEL(metal_rough_d, metal_rough, metal_rough_term_d)
NUMBER_KERNEL(metal_rough_g, metal_rough, metal_rough_term_g)
NUMBER_KERNEL(metal_rough_v, metal_rough, metal_rough_term_v)
COLOR_KERNEL(UNIFORM, metal_rough_f, metal_rough, metal_rough_term_f)

const nd_term_table nd_terms = {
#define T(ndf) d_of_##ndf,
    .d = {NDF_LIST(T)},
#undef T
#define T(ndf, masking) v_of_##ndf##_##masking,
    .v = {VISIBILITY_LIST},
#undef T
#define T(ndf, masking) g_of_##ndf##_##masking,
    .g = {VISIBILITY_LIST},
#undef T
#define T(fresnel) f_of_##fresnel,
    .f = {FRESNEL_LIST(T)},
#undef T
    .metal_rough = {[NDL_TERM_D] = metal_rough_d,
                    [NDL_TERM_G] = metal_rough_g,
                    [NDL_TERM_V] = metal_rough_v,
                    [NDL_TERM_F] = metal_rough_f},
};
