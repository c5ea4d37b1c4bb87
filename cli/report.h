/* SPDX-License-Identifier: Apache-2.0 */
/* Messages, results and exit codes: `ndotl VERB: PLACE: what is wrong; what to do` on stderr, and
   results on stdout written whole, so that nothing is there before an exit of 2. */
#ifndef NDOTL_CLI_REPORT_H
#define NDOTL_CLI_REPORT_H
#include "base/text.h"
#include "ndotl/ndotl.h"

#include <stddef.h>

enum {
    CLI_OK = 0,
    CLI_FAILED = 1, /* a file or stream: missing, unreadable, malformed, unwritable */
    CLI_USAGE = 2   /* the command line or an expression */
};

#if defined(__GNUC__)
#define CLI_FORMAT(at, first) __attribute__((format(printf, at, first)))
#else
#define CLI_FORMAT(at, first)
#endif

/* Prints the message and returns code. verb "" is the program itself; place may be NULL. */
int cli_error(const char *verb, int code, const char *place, const char *format, ...)
    CLI_FORMAT(4, 5);
void cli_warning(const char *verb, const char *place, const char *format, ...) CLI_FORMAT(3, 4);

/* The message of an error of the library about an expression: "column 17: ..."; returns 2, or 1
   where memory, a file or the machine is to blame. `what` names the expression where there are
   several ("--light"), else NULL. */
int cli_expression_error(const char *verb, const char *what, const ndl_error *error);

/* Writes bytes to stdout; 0, or 1 after a message. */
int cli_put(const char *verb, const char *s, size_t n);
/* The same for a text, which is emptied; running out of memory is an error too. */
int cli_put_text(const char *verb, nd_text *t);

/* A user's word, quoted for a message: unprintable bytes as \xNN, cut where it is long. */
typedef struct { char s[80]; } cli_quoted;
cli_quoted cli_quote(const char *s);

/* Applies NDOTL_ISA and NDOTL_TABLE. Every command that evaluates calls it first.
   0, or 2 after a message. */
int cli_use_environment(const char *verb);

#endif
