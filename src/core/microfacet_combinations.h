/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* Every ndf x masking x fresnel of microfacet as one fused function each, from the shading text:
   the pasting of names, which shader languages do not have, happens here.
   MICROFACET_COMBINATION(ndf, masking, fresnel) defines
       vec3 microfacet_<ndf>_<masking>_<fresnel>_brdf(microfacet_p p, vec3 wi, vec3 wo)
       vec3 microfacet_<ndf>_<masking>_<fresnel>_brdf_cos(microfacet_p p, vec3 wi, vec3 wo)
   Each spends one division on D V NoL in all (Beckmann's and Blinn's exponents take one more, the
   conductor two per channel). The TERM macros define the terms by themselves. */
#ifndef ND_CORE_MICROFACET_COMBINATIONS_H
#define ND_CORE_MICROFACET_COMBINATIONS_H
#include "shade/microfacet.h"

/* What an ndf, a masking and a fresnel take from p, wi, wo and m = halfway_of(wi, wo). */
#define ND_NDF_ggx ndf_ggx(p.alpha_x, p.alpha_y, m.h, m.hh)
#define ND_NDF_beckmann ndf_beckmann(p.alpha_x, p.alpha_y, m.h, m.hh)
#define ND_NDF_blinn ndf_blinn(p.alpha_x, m.h)

#define ND_MASKING_none(ndf) masking_none(wi, wo)
#define ND_MASKING_implicit(ndf) masking_implicit(wi)
#define ND_MASKING_neumann(ndf) masking_neumann(wi, wo)
#define ND_MASKING_cook_torrance(ndf) masking_cook_torrance(wi, wo, m)
#define ND_MASKING_kelemen(ndf) masking_kelemen(wi, m)
#define ND_MASKING_smith(ndf) ND_SMITH_##ndf(smith)
#define ND_MASKING_smith_correlated(ndf) ND_SMITH_##ndf(smith_correlated)
#define ND_MASKING_smith_walter(ndf) masking_smith_walter(p.alpha_x, p.alpha_y, wi, wo)
#define ND_MASKING_schlick_beckmann(ndf) masking_schlick_beckmann(p.alpha_x, p.alpha_y, wi, wo)
#define ND_MASKING_schlick_ggx(ndf) masking_schlick_ggx(p.alpha_x, p.alpha_y, wi, wo)
#define ND_MASKING_schlick_direct(ndf)                                                             \
    masking_schlick_direct(p.alpha_x, p.alpha_y, p.direct_roughness, wi, wo)

/* The Lambda that an ndf uses; blinn has none of its own and takes Beckmann's. */
#define ND_SMITH_ggx(kind) masking_ggx_##kind(p.alpha_x, p.alpha_y, wi, wo)
#define ND_SMITH_beckmann(kind) masking_beckmann_##kind(p.alpha_x, p.alpha_y, wi, wo)
#define ND_SMITH_blinn(kind) ND_SMITH_beckmann(kind)

#define ND_FRESNEL_none p.f0
#define ND_FRESNEL_schlick fresnel_schlick(p.f0, m.cosine)
#define ND_FRESNEL_cook_torrance fresnel_cook_torrance(p.f0, m.cosine)
#define ND_FRESNEL_dielectric fresnel_dielectric(p.ior, m.cosine)
#define ND_FRESNEL_conductor fresnel_conductor(p.eta, p.k, m.cosine)

#define MICROFACET_COMBINATION(ndf, masking, fresnel)                                              \
    FN vec3 microfacet_##ndf##_##masking##_##fresnel##_brdf(microfacet_p p, vec3 wi, vec3 wo) {    \
        halfway m = halfway_of(wi, wo);                                                            \
        ratio r = ND_NDF_##ndf;                                                                    \
        visibility v = ND_MASKING_##masking(ndf);                                                  \
        vec3 f = ND_FRESNEL_##fresnel;                                                             \
        return microfacet_value(lit(wi, wo), p.color, f, r.n * v.n, r.d * v.d);                    \
    }                                                                                              \
    FN vec3 microfacet_##ndf##_##masking##_##fresnel##_brdf_cos(microfacet_p p, vec3 wi,           \
                                                                vec3 wo) {                         \
        halfway m = halfway_of(wi, wo);                                                            \
        ratio r = ND_NDF_##ndf;                                                                    \
        visibility v = ND_MASKING_##masking(ndf);                                                  \
        vec3 f = ND_FRESNEL_##fresnel;                                                             \
        return microfacet_value(lit(wi, wo), p.color, f, r.n * v.n_cos, r.d * v.d_cos);            \
    }

/* num microfacet_term_d_<ndf>(p, wi, wo): D, 1/sr. */
#define MICROFACET_TERM_D(ndf)                                                                     \
    FN num microfacet_term_d_##ndf(microfacet_p p, vec3 wi, vec3 wo) {                             \
        halfway m = halfway_of(wi, wo);                                                            \
        ratio r = ND_NDF_##ndf;                                                                    \
        return microfacet_term(lit(wi, wo), r.n, r.d);                                             \
    }

/* num microfacet_term_v_<ndf>_<masking>(p, wi, wo): V = G/(4 NoL NoV); ..._g_...: G. */
#define MICROFACET_TERM_MASKING(ndf, masking)                                                      \
    FN num microfacet_term_v_##ndf##_##masking(microfacet_p p, vec3 wi, vec3 wo) {                 \
        halfway m = halfway_of(wi, wo);                                                            \
        visibility v = ND_MASKING_##masking(ndf);                                                  \
        (void)p;                                                                                   \
        (void)m;                                                                                   \
        return microfacet_term(lit(wi, wo), v.n, v.d);                                             \
    }                                                                                              \
    FN num microfacet_term_g_##ndf##_##masking(microfacet_p p, vec3 wi, vec3 wo) {                 \
        halfway m = halfway_of(wi, wo);                                                            \
        visibility v = ND_MASKING_##masking(ndf);                                                  \
        (void)p;                                                                                   \
        (void)m;                                                                                   \
        return masking_term(v, wi, wo);                                                            \
    }

/* vec3 microfacet_term_f_<fresnel>(p, wi, wo): F. */
#define MICROFACET_TERM_F(fresnel)                                                                 \
    FN vec3 microfacet_term_f_##fresnel(microfacet_p p, vec3 wi, vec3 wo) {                        \
        halfway m = halfway_of(wi, wo);                                                            \
        vec3 f = ND_FRESNEL_##fresnel;                                                             \
        (void)m;                                                                                   \
        return gated(lit(wi, wo), f);                                                              \
    }

#endif
