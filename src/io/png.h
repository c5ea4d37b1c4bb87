/* SPDX-License-Identifier: Apache-2.0 */
#ifndef ND_IO_PNG_H
#define ND_IO_PNG_H
#include "base/text.h"
#include "ndotl/ndotl.h"

#include <stdbool.h>

/* Appends an 8-bit RGB PNG with an sRGB chunk to *out. rgb: 3 bytes a pixel, rows from the top.
   Errors:   false with NDL_E_MEMORY or NDL_E_LIMIT; what was appended is of no use. */
bool nd_png_encode(int width, int height, const unsigned char *rgb, nd_text *out,
                   ndl_error *error);

#endif
