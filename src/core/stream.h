/* SPDX-License-Identifier: Apache-2.0 */
/* Results that are larger than the caches go past them. */
#ifndef ND_CORE_STREAM_H
#define ND_CORE_STREAM_H
#include <stdbool.h>
#include <stddef.h>

/* Pairs from which on a batch streams: 36 bytes each, 9 MB, beyond the caches of a core. */
enum { ND_STREAMING_PAIRS = 1 << 18 };

/* Whether nd_stream can write there: the machine has such stores, and the place is aligned. */
bool nd_can_stream(const float *to);

/* Copies n floats to a place that will not be read soon. Call nd_stream_end() after the last. */
void nd_stream(float *to, const float *from, size_t n);

/* Makes streamed values visible to other threads. */
void nd_stream_end(void);

#endif
