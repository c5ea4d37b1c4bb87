/* SPDX-License-Identifier: Apache-2.0 */
#include "io/png.h"

#include "base/error.h"

#include <png.h>

static void append(png_structp png, png_bytep bytes, png_size_t n) {
    nd_text *out = png_get_io_ptr(png);
    nd_text_bytes(out, (const char *)bytes, n);
    if (out->failed) png_error(png, "out of memory");
}

static void flush(png_structp png) {
    (void)png;
}

static void stay_silent(png_structp png, png_const_charp text) {
    (void)png;
    (void)text;
}

/* libpng leaves a function that failed by longjmp: everything between here and there is plain. */
static bool write_rows(png_structp png, png_infop info, int width, int height,
                       const unsigned char *rgb) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    for (int y = 0; y < height; y++)
        png_write_row(png, rgb + 3 * (size_t)width * (size_t)y);
    png_write_end(png, info);
    return true;
}

bool nd_png_encode(int width, int height, const unsigned char *rgb, nd_text *out,
                   ndl_error *error) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, stay_silent);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    bool written = false;
    if (info) {
        png_set_write_fn(png, out, append, flush);
        png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        written = write_rows(png, info, width, height, rgb);
    }
    png_destroy_write_struct(png ? &png : NULL, info ? &info : NULL);
    if (written && !out->failed) return true;
    return nd_fail(error, NDL_E_MEMORY, 0, "out of memory while the PNG was encoded", NULL);
}
