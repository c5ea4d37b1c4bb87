/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* The short name of microfacet(ndf=beckmann). */
#ifndef ND_SHADE_BECKMANN_H
#define ND_SHADE_BECKMANN_H
#include "shade/microfacet.h"

#define BECKMANN_PARAMS(P) MICROFACET_SHORT_PARAMS(P)

#define BECKMANN_MANUAL(M)                                                                         \
    M(WHAT, "microfacet with the Beckmann distribution: a surface whose slopes are Gaussian, a "   \
            "highlight that ends.")                                                                \
    M(FORMULA, "f = color F D V, D = exp(-(hx^2/alpha_x^2 + hy^2/alpha_y^2) / hz^2) / "            \
               "(pi alpha_x alpha_y hz^4), V = G/(4 NoL NoV) by masking, F by fresnel")            \
    M(WHEN, "Rough metals and rough glass; comparisons with measured surfaces and with optics, "   \
            "where alpha is the root mean square slope times sqrt(2) per axis.")                   \
    M(LIMITS, "Single scattering; no tail. More, and every term, in `ndotl models microfacet`.")   \
    M(ENERGY, "E <= 1 with every masking but none, which gains without bound, and neumann beyond " \
              "alpha 3.5 (1.14 at alpha 4, NoV .03).")                                             \
    M(SAMPLING, "Visible normals, pdf = D G1(wo)/(4 NoV).")                                        \
    M(SOURCE, "[CookTorrance82], [Walter07] eq. 25, [Heitz14]; formulas S1.4, S1.5, S3.5, "        \
              "S3.13, S4.46, S4.47")

#endif
