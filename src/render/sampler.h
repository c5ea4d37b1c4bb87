/* SPDX-License-Identifier: Apache-2.0 */
/* Places of the samples in a pixel. */
#ifndef ND_RENDER_SAMPLER_H
#define ND_RENDER_SAMPLER_H
#include <stdint.h>

/* The finaliser of SplitMix64: a bijection whose every output bit depends on every input bit.
   Source: [Steele14] fig. 16. */
static inline uint64_t nd_mix(uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/* Sample `index` of `count` in the pixel, in [0, 1)^2: the centre where there is one; otherwise a
   point of the (0, 2)-sequence of Sobol', so that 2^m samples put one into each of 2^m elementary
   boxes of equal area, with a random digital shift for each pixel and seed.
   Source: [Sobol67]; shift: [Kollig02]. */
static inline void nd_place_sample(uint64_t seed, uint32_t pixel, uint32_t index, uint32_t count,
                                   double *x, double *y) {
    uint32_t first = 0, second = 0, column = 1u << 31;
    if (count == 1) {
        *x = *y = 0.5;
        return;
    }
    for (uint32_t bit = 1u << 31; index; index >>= 1, bit >>= 1, column ^= column >> 1) {
        if (!(index & 1)) continue;
        first ^= bit;
        second ^= column;
    }
    uint64_t shift = nd_mix(nd_mix(seed + 0x9e3779b97f4a7c15u) ^ pixel);
    first ^= (uint32_t)shift;
    second ^= (uint32_t)(shift >> 32);
    *x = (double)first * 0x1p-32;
    *y = (double)second * 0x1p-32;
}

#endif
