/* SPDX-License-Identifier: Apache-2.0 */
/* Non-negative integers of up to 7168 bits, for exact decimal conversion. */
#ifndef ND_BASE_BIGNUM_H
#define ND_BASE_BIGNUM_H
#include <stdbool.h>
#include <stdint.h>

/* 224 limbs: 770 digits times 2^(1100 log2 10), the largest shifted numerator of a conversion. */
enum { ND_BIG_LIMBS = 224 };
typedef struct {
    int n; /* limbs in use; the top one is not 0 */
    uint32_t limb[ND_BIG_LIMBS];
} nd_big;

void nd_big_set(nd_big *b, uint64_t x);
/* b = b * factor + carry */
void nd_big_multiply_add(nd_big *b, uint32_t factor, uint32_t carry);
void nd_big_power_of_ten(nd_big *b, int times); /* b *= 10^times */
void nd_big_shift(nd_big *b, int bits);         /* b <<= bits, bits >= 0 */
int nd_big_bits(const nd_big *b);               /* position of the highest set bit + 1; 0 for 0 */
int nd_big_compare(const nd_big *a, const nd_big *b);
void nd_big_subtract(nd_big *a, const nd_big *b); /* a -= b, a >= b */

#endif
