/* SPDX-License-Identifier: Apache-2.0 */
#ifndef ND_BASE_ERROR_H
#define ND_BASE_ERROR_H
#include "ndotl/ndotl.h"

#include <stdbool.h>

/* Fills *error (may be NULL) with code, column and the joined parts, the last one NULL; returns
   false, so that `return nd_fail(...)` reads well. */
bool nd_fail(ndl_error *error, int code, int column, ...);

/* Quotes a token for a message into room (size bytes): printable bytes as they are, others as
   \xNN, cut with ... where it is long. Returns room. */
const char *nd_quote(const char *s, size_t n, char *room, size_t size);

#endif
