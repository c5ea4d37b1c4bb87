/* SPDX-License-Identifier: Apache-2.0 */
#include "base/text.h"

#include "base/number.h"

#include <stdlib.h>
#include <string.h>

static bool reserve(nd_text *t, size_t more) {
    if (t->failed) return false;
    if (t->room - t->n > more) return true;
    size_t room = t->room ? t->room : 128;
    while (room - t->n <= more) room *= 2;
    char *s = realloc(t->s, room);
    if (!s) {
        t->failed = true;
        return false;
    }
    t->s = s;
    t->room = room;
    return true;
}

void nd_text_bytes(nd_text *t, const char *s, size_t n) {
    if (!reserve(t, n)) return;
    memcpy(t->s + t->n, s, n);
    t->n += n;
    t->s[t->n] = '\0';
}

void nd_text_add(nd_text *t, const char *s) {
    nd_text_bytes(t, s, strlen(s));
}

void nd_text_float(nd_text *t, float x) {
    char digits[ND_NUMBER_ROOM];
    nd_text_bytes(t, digits, nd_format_float(x, digits));
}

void nd_text_int(nd_text *t, long long x) {
    char digits[24];
    size_t at = sizeof digits;
    unsigned long long rest = x < 0 ? 0ull - (unsigned long long)x : (unsigned long long)x;
    do digits[--at] = (char)('0' + rest % 10);
    while (rest /= 10);
    if (x < 0) digits[--at] = '-';
    nd_text_bytes(t, digits + at, sizeof digits - at);
}

void nd_text_json(nd_text *t, const char *s) {
    static const char hex[] = "0123456789abcdef";
    nd_text_add(t, "\"");
    for (; *s; s++) {
        unsigned char c = (unsigned char)*s;
        if (c == '"' || c == '\\') {
            nd_text_bytes(t, (const char[]){'\\', *s}, 2);
        } else if (c < 0x20) {
            nd_text_bytes(t, (const char[]){'\\', 'u', '0', '0', hex[c >> 4], hex[c & 15]}, 6);
        } else {
            nd_text_bytes(t, s, 1);
        }
    }
    nd_text_add(t, "\"");
}

char *nd_text_take(nd_text *t) {
    nd_text_add(t, "");
    char *s = t->failed ? NULL : t->s;
    if (!s) free(t->s);
    *t = (nd_text){0};
    return s;
}

void nd_text_free(nd_text *t) {
    free(t->s);
    *t = (nd_text){0};
}
