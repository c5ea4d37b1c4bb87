/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* The short name of microfacet(ndf=ggx). */
#ifndef ND_SHADE_GGX_H
#define ND_SHADE_GGX_H
#include "shade/microfacet.h"

#define GGX_PARAMS(P) MICROFACET_SHORT_PARAMS(P)

#define GGX_MANUAL(M)                                                                              \
    M(WHAT, "microfacet with the GGX (Trowbridge-Reitz) distribution: a sharp peak with a long "   \
            "tail, the standard of rendering.")                                                    \
    M(FORMULA, "f = color F D V, D = 1 / (pi alpha_x alpha_y (hx^2/alpha_x^2 + hy^2/alpha_y^2 + "  \
               "hz^2)^2), V = G/(4 NoL NoV) by masking, F by fresnel")                             \
    M(WHEN, "Metals, plastics, varnish: any highlight that glows around its core.")                \
    M(LIMITS, "Single scattering: at alpha 1, F = 1, NoV 1 it keeps 1 - ln 2 = .307 of the light. "\
              "More, and every term, in `ndotl models microfacet`.")                               \
    M(ENERGY, "E <= 1 with every masking but three: none gains without bound (2.90 at alpha .5, "  \
              "NoV .1; 25.4 at .01), smith_walter up to 1.74 (alpha .03, at the horizon), and "    \
              "neumann beyond alpha 2 (alpha/2 at the horizon, 2 at alpha 4).")                    \
    M(SAMPLING,                                                                                    \
      "Visible normals in the bounded cap, pdf = D/(2 (k NoV + l(wo))); more in `ndotl models "    \
      "microfacet`.")                                                                              \
    M(SOURCE, "[Walter07] eq. 33, [TrowbridgeReitz75], [Heitz14]; formulas S1.6 to S1.12, S2.10, " \
              "S3.6, S3.7, S3.15, S4.48")

#endif
