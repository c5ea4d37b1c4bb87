/* SPDX-License-Identifier: Apache-2.0 */
/* "did you mean": the known name that a mistyped one is closest to. */
#ifndef ND_BASE_NEAREST_H
#define ND_BASE_NEAREST_H
#include <stddef.h>

/* Collects candidates one by one; start from {0} with `wanted` set. */
typedef struct {
    const char *wanted;
    const char *best; /* NULL until a candidate is near enough to be worth naming */
    int distance;
} nd_nearest;

/* Offers one known name. Distance: insertions, deletions, substitutions and swaps of neighbours
   (optimal string alignment); a name that begins with the wanted one counts as near. */
void nd_nearest_offer(nd_nearest *n, const char *name);

/* Offers each word of a blank-separated list; `room` (size bytes) receives the best word. */
void nd_nearest_words(nd_nearest *n, const char *words, char *room, size_t size);

#endif
