/* SPDX-License-Identifier: Apache-2.0 */
/* Files that appear whole or not at all. */
#ifndef ND_BASE_FILE_H
#define ND_BASE_FILE_H
#include "ndotl/ndotl.h"

#include <stdbool.h>
#include <stddef.h>

/* Writes n bytes as the file `path`: under a temporary name beside it, then renamed, so that an old
   file stays as it was until the new one is complete. A device or pipe is written in place.
   Errors:   false with NDL_E_FILE and the system's reason, or NDL_E_CANCELLED after an interruption
             (base/process.h); no temporary file is left. */
bool nd_file_replace(const char *path, const void *bytes, size_t n, ndl_error *error);

/* Whether `path` is a regular file that can be opened; otherwise NDL_E_FILE and the reason. */
bool nd_file_readable(const char *path, ndl_error *error);

#endif
