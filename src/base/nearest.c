/* SPDX-License-Identifier: Apache-2.0 */
#include "base/nearest.h"

#include <string.h>

enum { LONGEST = 63 }; /* longer names are never near */

static int least(int a, int b, int c) {
    int m = a < b ? a : b;
    return m < c ? m : c;
}

static char lower(char c) {
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static int edit_distance(const char *a, const char *b) {
    int na = (int)strlen(a), nb = (int)strlen(b);
    int rows[3][LONGEST + 1];
    int *before = rows[0], *last = rows[1], *row = rows[2];
    for (int j = 0; j <= nb; j++) last[j] = j;
    for (int i = 1; i <= na; i++) {
        row[0] = i;
        for (int j = 1; j <= nb; j++) {
            int change = last[j - 1] + (lower(a[i - 1]) != b[j - 1]);
            row[j] = least(change, last[j] + 1, row[j - 1] + 1);
            if (i > 1 && j > 1 && lower(a[i - 1]) == b[j - 2] && lower(a[i - 2]) == b[j - 1] &&
                before[j - 2] + 1 < row[j])
                row[j] = before[j - 2] + 1;
        }
        int *spare = before;
        before = last;
        last = row;
        row = spare;
    }
    return last[nb];
}

void nd_nearest_offer(nd_nearest *n, const char *name) {
    size_t length = strlen(n->wanted), other = strlen(name);
    if (!length || length > LONGEST || other > LONGEST) return;
    int distance = edit_distance(n->wanted, name);
    /* Half of a word may be wrong, not more: 'rough' is near 'roughness' only as its beginning. */
    int limit = (int)(length > 3 ? length / 2 : 1);
    if (length > 1 && strncmp(name, n->wanted, length) == 0) distance = 1;
    if (distance <= limit && (!n->best || distance < n->distance)) {
        n->best = name;
        n->distance = distance;
    }
}

void nd_nearest_words(nd_nearest *n, const char *words, char *room, size_t size) {
    char word[LONGEST + 1];
    while (*words) {
        size_t length = strcspn(words, " ");
        if (length && length < sizeof word && length < size) {
            memcpy(word, words, length);
            word[length] = '\0';
            nd_nearest_offer(n, word);
            if (n->best == word) {
                memcpy(room, word, length + 1);
                n->best = room;
            }
        }
        words += length + (words[length] == ' ');
    }
}
