/* SPDX-License-Identifier: Apache-2.0 */
/* Memory that is released all at once: what a parse builds is dropped in one call. */
#ifndef ND_BASE_ARENA_H
#define ND_BASE_ARENA_H
#include <stddef.h>

typedef struct nd_chunk nd_chunk;
typedef struct { nd_chunk *top; } nd_arena; /* {0} is an empty arena */

/* size zeroed bytes, aligned for any type; NULL when memory is out. Lives until nd_arena_free. */
void *nd_arena_alloc(nd_arena *a, size_t size);

/* A terminated copy of n bytes of s; NULL when memory is out. */
char *nd_arena_text(nd_arena *a, const char *s, size_t n);

void nd_arena_free(nd_arena *a);

#endif
