/* SPDX-License-Identifier: Apache-2.0 */
#include "flagship.h"

#include <float.h>
#include <immintrin.h>

enum { LANES = 8 };
#define NAME(kind) ceiling_v3_##kind
#define V __m256
#define M __m256
#define LOAD _mm256_loadu_ps
#define STORE _mm256_storeu_ps
#define SET _mm256_set1_ps
#define ADD _mm256_add_ps
#define SUB _mm256_sub_ps
#define MUL _mm256_mul_ps
#define DIV _mm256_div_ps
#define SQRT _mm256_sqrt_ps
#define MIN _mm256_min_ps
#define MAX _mm256_max_ps
#define LESS(a, b) _mm256_cmp_ps(a, b, _CMP_LT_OQ)
#define AT_LEAST(a, b) _mm256_cmp_ps(a, b, _CMP_GE_OQ)
#define ABOVE(a) _mm256_cmp_ps(a, _mm256_setzero_ps(), _CMP_GT_OQ)
#define AND_M(a, b) _mm256_and_ps(a, b)
#define SELECT(mask, yes, no) _mm256_blendv_ps(no, yes, mask)
#define FMA _mm256_fmadd_ps
#define FNMA _mm256_fnmadd_ps
#define RCP _mm256_rcp_ps
#define RSQRT _mm256_rsqrt_ps
#include "ceiling.inc"
