/* SPDX-License-Identifier: Apache-2.0 */
#include "report.h"

#include "base/error.h"
#include "base/stream.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

cli_quoted cli_quote(const char *s) {
    cli_quoted q;
    nd_quote(s, strlen(s), q.s, sizeof q.s);
    return q;
}

static void message(const char *verb, const char *place, const char *kind, const char *format,
                    va_list values) {
    char text[1024];
    vsnprintf(text, sizeof text, format, values);
    fprintf(stderr, "ndotl%s%s: %s%s%s%s\n", *verb ? " " : "", verb, place ? place : "",
            place ? ": " : "", kind, text);
}

int cli_error(const char *verb, int code, const char *place, const char *format, ...) {
    va_list values;
    va_start(values, format);
    message(verb, place, "", format, values);
    va_end(values);
    return code;
}

void cli_warning(const char *verb, const char *place, const char *format, ...) {
    va_list values;
    va_start(values, format);
    message(verb, place, "warning: ", format, values);
    va_end(values);
}

int cli_expression_error(const char *verb, const char *what, const ndl_error *error) {
    bool own = error->code != NDL_E_MEMORY && error->code != NDL_E_FILE;
    char place[120];
    snprintf(place, sizeof place, "%s%s%s", what ? what : "", what && error->column ? ": " : "",
             error->column ? "column " : "");
    if (error->column) {
        size_t n = strlen(place);
        snprintf(place + n, sizeof place - n, "%d", error->column);
    }
    return cli_error(verb, own ? CLI_USAGE : CLI_FAILED, *place ? place : NULL, "%s",
                     error->text);
}

int cli_put(const char *verb, const char *s, size_t n) {
    if (nd_stream_write(ND_STDOUT, s, n)) return CLI_OK;
    return cli_error(verb, CLI_FAILED, "stdout", "cannot write: %s", strerror(errno));
}

int cli_put_text(const char *verb, nd_text *t) {
    int code = t->failed ? cli_error(verb, CLI_FAILED, NULL, "out of memory")
                         : cli_put(verb, t->s, t->n);
    nd_text_free(t);
    return code;
}

int cli_use_environment(const char *verb) {
    const char *isa = getenv("NDOTL_ISA"), *table = getenv("NDOTL_TABLE");
    if (ndl_use_isa(isa) != NDL_OK)
        return cli_error(verb, CLI_USAGE, "NDOTL_ISA",
                         "'%s' is unknown or this machine lacks it; unset it for the best, or use "
                         "one of: scalar x86-64 x86-64-v3 x86-64-v4 neon",
                         cli_quote(isa).s);
    if (!table || !*table || strcmp(table, "exact") == 0) return CLI_OK;
    if (strcmp(table, "fast") == 0)
        return cli_error(verb, CLI_USAGE, "NDOTL_TABLE",
                         "'fast' is not in this version; unset it or use 'exact'");
    return cli_error(verb, CLI_USAGE, "NDOTL_TABLE", "'%s' is unknown; unset it or use 'exact'",
                     cli_quote(table).s);
}
