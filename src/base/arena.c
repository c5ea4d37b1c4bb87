/* SPDX-License-Identifier: Apache-2.0 */
#include "base/arena.h"

#include <stdalign.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { CHUNK = 4096 };

struct nd_chunk {
    nd_chunk *below;
    size_t used, size;
    alignas(max_align_t) unsigned char bytes[];
};

static nd_chunk *grow(nd_arena *a, size_t size) {
    size_t room = size > CHUNK ? size : CHUNK;
    if (room > SIZE_MAX - sizeof(nd_chunk)) return NULL;
    nd_chunk *c = calloc(1, sizeof *c + room);
    if (!c) return NULL;
    c->below = a->top;
    c->size = room;
    return a->top = c;
}

void *nd_arena_alloc(nd_arena *a, size_t size) {
    const size_t step = alignof(max_align_t);
    if (size > SIZE_MAX - step) return NULL;
    size = (size + step - 1) / step * step;
    nd_chunk *c = a->top;
    if (!c || c->size - c->used < size) c = grow(a, size);
    if (!c) return NULL;
    void *p = c->bytes + c->used;
    c->used += size;
    return p;
}

char *nd_arena_text(nd_arena *a, const char *s, size_t n) {
    char *p = nd_arena_alloc(a, n + 1);
    if (p) memcpy(p, s, n);
    return p;
}

void nd_arena_free(nd_arena *a) {
    while (a->top) {
        nd_chunk *below = a->top->below;
        free(a->top);
        a->top = below;
    }
}
