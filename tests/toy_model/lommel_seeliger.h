/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
#ifndef ND_SHADE_LOMMEL_SEELIGER_H
#define ND_SHADE_LOMMEL_SEELIGER_H
#include "shade/sampling.h"

#define LOMMEL_SEELIGER_PARAMS(P)                                                                  \
    P(RGB, color, 0.0, 1.0, 0.5, "1", "share of the light that one grain scatters again")

#define LOMMEL_SEELIGER_KERNELS(K) K(lommel_seeliger, lommel_seeliger, ND_CLAIM_ALL)

#define LOMMEL_SEELIGER_MANUAL(M)                                                                  \
    M(WHAT, "Single scattering of a deep layer of dark grains, such as the Moon's ground: "        \
            "f = color / (4 pi (NoL + NoV)).")                                                     \
    M(SAMPLING, "Directions by the cosine.")

STRUCT(lommel_seeliger_p) {
    LOMMEL_SEELIGER_PARAMS(FIELD)
};

FN vec3 lommel_seeliger_brdf(lommel_seeliger_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), v3_scale(p.color, 0.25f * INV_PI / (wi.z + wo.z)));
}

FN vec3 lommel_seeliger_brdf_cos(lommel_seeliger_p p, vec3 wi, vec3 wo) {
    return gated(lit(wi, wo), v3_scale(p.color, 0.25f * INV_PI * wi.z / (wi.z + wo.z)));
}

FN vec3 lommel_seeliger_sample(lommel_seeliger_p p, vec3 wo, vec3 u) {
    return cosine_sample(wo, u);
}

FN num lommel_seeliger_pdf(lommel_seeliger_p p, vec3 wi, vec3 wo) {
    return cosine_pdf(wi, wo);
}

#endif
