/* SPDX-License-Identifier: Apache-2.0 */
#include "wrap.h"

#include <stdbool.h>
#include <string.h>

void cli_spaces(nd_text *t, size_t n) {
    while (n--) nd_text_bytes(t, " ", 1);
}

void cli_wrap(nd_text *t, const char *s, size_t at, size_t indent) {
    bool first = true;
    while (*s) {
        size_t n = strcspn(s, " ");
        if (!first && at + 1 + n > 79) {
            nd_text_add(t, "\n");
            cli_spaces(t, indent);
            at = indent;
        } else if (!first) {
            nd_text_add(t, " ");
            at++;
        }
        nd_text_bytes(t, s, n);
        at += n;
        first = false;
        s += n + strspn(s + n, " ");
    }
    nd_text_add(t, "\n");
}
