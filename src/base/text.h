/* SPDX-License-Identifier: Apache-2.0 */
/* Growing text, without stdio and without a locale. */
#ifndef ND_BASE_TEXT_H
#define ND_BASE_TEXT_H
#include <stdbool.h>
#include <stddef.h>

/* {0} is empty. After a failed allocation `failed` is set and nothing more is added. */
typedef struct {
    char *s;
    size_t n, room;
    bool failed;
} nd_text;

void nd_text_bytes(nd_text *t, const char *s, size_t n);
void nd_text_add(nd_text *t, const char *s);
/* Shortest decimal that reads back as the same float. */
void nd_text_float(nd_text *t, float x);
void nd_text_int(nd_text *t, long long x);
/* s as a JSON string with its quotes. */
void nd_text_json(nd_text *t, const char *s);

/* The terminated text, owned by the caller (free); NULL when memory was out. Empties t. */
char *nd_text_take(nd_text *t);
void nd_text_free(nd_text *t);

#endif
