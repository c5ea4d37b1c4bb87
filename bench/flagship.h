/* SPDX-License-Identifier: Apache-2.0 */
/* The flagship, anisotropic GGX with correlated Smith masking and Schlick's Fresnel in RGB, written
   by hand: what the library's compiled kernel is measured against. Bench only. */
#ifndef NDOTL_BENCH_FLAGSHIP_H
#define NDOTL_BENCH_FLAGSHIP_H
#include <ndotl/ndotl.h>

typedef struct { float alpha_x, alpha_y, f0[3]; } flagship;

/* f_r of n pairs; the kernels in intrinsics want n to be a multiple of 16. */
typedef void flagship_kernel(const flagship *p, size_t n, ndl_vec3_n wi, ndl_vec3_n wo,
                             ndl_rgb_n rgb);

/* The operations of the library's text, in its order: the same bits. */
flagship_kernel ceiling_v4_exact, ceiling_v3_exact;
/* The fewest cycles at full accuracy: fused multiply-adds, estimates of 1/x and 1/sqrt(x) with one
   Newton step; in mixed one of the three roots is left to the square root unit. */
flagship_kernel ceiling_v4_fast, ceiling_v4_mixed, ceiling_v3_fast, ceiling_v3_mixed;
/* naive.c, compiled for the plain x86-64 and for x86-64-v4. */
flagship_kernel naive_plain, naive_v3, naive_v4;

#endif
