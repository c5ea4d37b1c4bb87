/* SPDX-License-Identifier: Apache-2.0 */
#include "core/stream.h"

#include <stdint.h>
#include <string.h>

#if defined(__SSE2__)
#include <emmintrin.h>

bool nd_can_stream(const float *to) {
    return (uintptr_t)to % 16 == 0;
}

/* Whole cache lines in order, so that no line is read before it is written. */
void nd_stream(float *to, const float *from, size_t n) {
    size_t i = 0;
    for (; i + 4 <= n; i += 4) _mm_stream_ps(to + i, _mm_loadu_ps(from + i));
    memcpy(to + i, from + i, (n - i) * sizeof *to);
}

void nd_stream_end(void) {
    _mm_sfence();
}
#else

bool nd_can_stream(const float *to) {
    (void)to;
    return false;
}

void nd_stream(float *to, const float *from, size_t n) {
    memcpy(to, from, n * sizeof *to);
}

void nd_stream_end(void) {}
#endif
