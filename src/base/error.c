/* SPDX-License-Identifier: Apache-2.0 */
#include "base/error.h"

#include <stdarg.h>
#include <string.h>

const char *ndl_status_text(int code) {
    switch (code) {
    case NDL_OK: return "success";
#define NDL_ERROR(name, text) \
    case NDL_E_##name: return text;
#include "ndotl/errors.def"
#undef NDL_ERROR
    default: return "unknown status";
    }
}

bool nd_fail(ndl_error *error, int code, int column, ...) {
    if (!error) return false;
    error->code = code;
    error->column = column;
    size_t n = 0, most = sizeof error->text - 1;
    va_list parts;
    va_start(parts, column);
    for (const char *s; (s = va_arg(parts, const char *)) != NULL;) {
        size_t more = strlen(s);
        if (more > most - n) more = most - n;
        memcpy(error->text + n, s, more);
        n += more;
    }
    va_end(parts);
    error->text[n] = '\0';
    return false;
}

const char *nd_quote(const char *s, size_t n, char *room, size_t size) {
    static const char hex[] = "0123456789abcdef";
    size_t at = 0;
    for (size_t i = 0; i < n; i++) {
        if (at + 8 > size) {
            memcpy(room + at, "...", 3);
            at += 3;
            break;
        }
        unsigned char c = (unsigned char)s[i];
        if (c >= 0x20 && c < 0x7f) {
            room[at++] = s[i];
        } else {
            memcpy(room + at, (const char[]){'\\', 'x', hex[c >> 4], hex[c & 15]}, 4);
            at += 4;
        }
    }
    room[at] = '\0';
    return room;
}
