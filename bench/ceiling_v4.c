/* SPDX-License-Identifier: Apache-2.0 */
#include "flagship.h"

#include <float.h>
#include <immintrin.h>

enum { LANES = 16 };
#define NAME(kind) ceiling_v4_##kind
#define V __m512
#define M __mmask16
#define LOAD _mm512_loadu_ps
#define STORE _mm512_storeu_ps
#define SET _mm512_set1_ps
#define ADD _mm512_add_ps
#define SUB _mm512_sub_ps
#define MUL _mm512_mul_ps
#define DIV _mm512_div_ps
#define SQRT _mm512_sqrt_ps
#define MIN _mm512_min_ps
#define MAX _mm512_max_ps
#define LESS(a, b) _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ)
#define AT_LEAST(a, b) _mm512_cmp_ps_mask(a, b, _CMP_GE_OQ)
#define ABOVE(a) _mm512_cmp_ps_mask(a, _mm512_setzero_ps(), _CMP_GT_OQ)
#define AND_M(a, b) ((M)((a) & (b)))
#define SELECT(mask, yes, no) _mm512_mask_blend_ps(mask, no, yes)
#define FMA _mm512_fmadd_ps
#define FNMA _mm512_fnmadd_ps
#define RCP _mm512_rcp14_ps
#define RSQRT _mm512_rsqrt14_ps
#include "ceiling.inc"
