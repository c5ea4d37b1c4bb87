/* SPDX-License-Identifier: Apache-2.0 */
#ifndef ND_IO_EXR_H
#define ND_IO_EXR_H
#include "base/text.h"
#include "ndotl/ndotl.h"

#include <stdbool.h>

/* Appends an OpenEXR file with 32-bit float channels R, G, B (ZIP, 16 lines a block, lossless) to
   *out. rgb: 3 floats a pixel, rows from the top.
   Errors:   false with NDL_E_MEMORY; what was appended is of no use. */
bool nd_exr_encode(int width, int height, const float *rgb, nd_text *out, ndl_error *error);

/* Reads the channels R, G, B of a scan-line file as floats; *rgb belongs to the caller (free).
   Errors:   false with NDL_E_FILE (missing, malformed, truncated, without these channels),
             NDL_E_LIMIT (more than 2^28 pixels) or NDL_E_MEMORY. */
bool nd_exr_read(const char *path, int *width, int *height, float **rgb, ndl_error *error);

#endif
