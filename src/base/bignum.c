/* SPDX-License-Identifier: Apache-2.0 */
#include "base/bignum.h"

#include <string.h>

static void trim(nd_big *b) {
    while (b->n && !b->limb[b->n - 1]) b->n--;
}

void nd_big_set(nd_big *b, uint64_t x) {
    b->limb[0] = (uint32_t)x;
    b->limb[1] = (uint32_t)(x >> 32);
    b->n = 2;
    trim(b);
}

void nd_big_multiply_add(nd_big *b, uint32_t factor, uint32_t carry) {
    uint64_t c = carry;
    for (int i = 0; i < b->n; i++) {
        c += (uint64_t)b->limb[i] * factor;
        b->limb[i] = (uint32_t)c;
        c >>= 32;
    }
    if (c && b->n < ND_BIG_LIMBS) b->limb[b->n++] = (uint32_t)c;
}

void nd_big_power_of_ten(nd_big *b, int times) {
    for (; times >= 9; times -= 9) nd_big_multiply_add(b, 1000000000u, 0);
    for (; times > 0; times--) nd_big_multiply_add(b, 10, 0);
}

void nd_big_shift(nd_big *b, int bits) {
    int limbs = bits / 32, rest = bits % 32;
    if (!b->n || !bits) return;
    memmove(b->limb + limbs, b->limb, (size_t)b->n * sizeof b->limb[0]);
    memset(b->limb, 0, (size_t)limbs * sizeof b->limb[0]);
    b->n += limbs;
    if (!rest) return;
    uint32_t carry = 0;
    for (int i = limbs; i < b->n; i++) {
        uint32_t x = b->limb[i];
        b->limb[i] = x << rest | carry;
        carry = x >> (32 - rest);
    }
    if (carry) b->limb[b->n++] = carry;
}

int nd_big_bits(const nd_big *b) {
    if (!b->n) return 0;
    int bits = 32 * (b->n - 1);
    for (uint32_t top = b->limb[b->n - 1]; top; top >>= 1) bits++;
    return bits;
}

int nd_big_compare(const nd_big *a, const nd_big *b) {
    if (a->n != b->n) return a->n < b->n ? -1 : 1;
    for (int i = a->n - 1; i >= 0; i--)
        if (a->limb[i] != b->limb[i]) return a->limb[i] < b->limb[i] ? -1 : 1;
    return 0;
}

void nd_big_subtract(nd_big *a, const nd_big *b) {
    uint64_t borrow = 0;
    for (int i = 0; i < a->n; i++) {
        uint64_t take = (i < b->n ? b->limb[i] : 0) + borrow;
        borrow = a->limb[i] < take;
        a->limb[i] = (uint32_t)(a->limb[i] - take);
    }
    trim(a);
}
