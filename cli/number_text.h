/* SPDX-License-Identifier: Apache-2.0 */
/* Quick decimal text for streams of millions of numbers, with the results of the slow ways: each
   function has an exact fast path for nearly every number and falls back for the rest. */
#ifndef NDOTL_CLI_NUMBER_TEXT_H
#define NDOTL_CLI_NUMBER_TEXT_H
#include <stddef.h>

/* What nd_parse_double gives for the same bytes: bytes used, 0 where no number begins. */
size_t cli_scan_double(const char *s, const char *end, double *x);

/* What printf("%.9g") writes, without a terminator; bytes written, at most CLI_PRINT_ROOM. */
enum { CLI_PRINT_ROOM = 24 };
size_t cli_print_float(float x, char *to);

#endif
