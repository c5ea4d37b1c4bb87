/* SPDX-License-Identifier: Apache-2.0 */
/* The shading text of every model, as C, and the numbers of its kernels. */
#ifndef ND_CORE_MODELS_H
#define ND_CORE_MODELS_H
#include "core/schema.h"
#include "shade/prelude_c.h"

#include "shade/math.h"

#define ND_CLAIM_RECIPROCITY NDL_CLAIM_RECIPROCITY
#define ND_CLAIM_ENERGY NDL_CLAIM_ENERGY
#define ND_CLAIM_CONTINUITY NDL_CLAIM_CONTINUITY
#define ND_CLAIM_ALL (NDL_CLAIM_RECIPROCITY | NDL_CLAIM_ENERGY | NDL_CLAIM_CONTINUITY)
/* The lecture prints this model without 1/pi: its scan-line quantity is pi brdf_cos. */
#define ND_TRAIT_LECTURE_PI 256u

/* Once for the headers that it includes. */
#define MODEL(name, NAME)
#define COMPOSED(name, NAME, ndf)
#include "core/models.def"
#undef MODEL
#undef COMPOSED

enum {
#define K(model, name, traits) ND_KERNEL_##name,
#define MODEL(name, NAME) NAME##_KERNELS(K)
#define COMPOSED(name, NAME, ndf)
#include "core/models.def"
#undef K
#undef MODEL
#undef COMPOSED
    ND_KERNELS
};

/* Term families of the composed models; the numbers are those of the words of their choices. */
#define T(name) ND_NDF_IS_##name,
enum { NDF_LIST(T) ND_NDFS };
#undef T
#define T(name) ND_MASKING_IS_##name,
enum { MASKING_LIST(T) ND_MASKINGS };
#undef T
#define T(name) ND_FRESNEL_IS_##name,
enum { FRESNEL_LIST(T) ND_FRESNELS };
#undef T

/* The distinct masking functions, T(ndf, masking): all with GGX's Lambda, which only the two Smith
   forms look at, then those two with Beckmann's. ndf=blinn takes Beckmann's too. */
#define ND_WITH_GGX(masking) T(ggx, masking)
#define VISIBILITY_LIST                                                                            \
    MASKING_LIST(ND_WITH_GGX) T(beckmann, smith) T(beckmann, smith_correlated)
#define FUSED(ndf, masking, fresnel) ND_FUSED_##ndf##_##masking##_##fresnel,
enum {
#include "core/fused.def"
    ND_FUSED
};
#undef FUSED

#define T(ndf, masking) ND_VISIBILITY_##ndf##_##masking,
enum { VISIBILITY_LIST ND_VISIBILITIES };
#undef T

#endif
