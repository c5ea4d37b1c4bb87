/* SPDX-License-Identifier: Apache-2.0 */
#include "base/error.h"
#include "base/file.h"
#include "core/tone.h"
#include "io/exr.h"
#include "io/png.h"
#include "ndotl/render.h"
#include "render/tonemap.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_SIDE = 32768 };

ndl_image *ndl_image_new(int width, int height) {
    if (width < 1 || height < 1 || width > LONGEST_SIDE || height > LONGEST_SIDE) return NULL;
    ndl_image *image = malloc(sizeof *image);
    float *rgb = calloc((size_t)width * (size_t)height, 3 * sizeof *rgb);
    if (image && rgb) {
        *image = (ndl_image){width, height, rgb};
        return image;
    }
    free(image);
    free(rgb);
    return NULL;
}

void ndl_image_free(ndl_image *image) {
    if (!image) return;
    free(image->rgb);
    free(image);
}

static size_t value_count(const ndl_image *image) {
    return 3 * (size_t)image->width * (size_t)image->height;
}

static double cut(double x) {
    return x > 0.0 ? (x < 1.0 ? x : 1.0) : 0.0;
}

/* x in [0, 1] to a byte, to the nearest. */
static unsigned char to_byte(double x) {
    return (unsigned char)(255.0 * x + 0.5);
}

static void tone_bytes(const ndl_image *image, const ndl_write_desc *desc, const nd_tonemap *map,
                       unsigned char *bytes) {
    double exposure = exp2((double)desc->exposure);
    for (size_t i = 0; i < value_count(image); i++) {
        double x = (double)image->rgb[i];
        x = x > 0.0 ? x : 0.0;
        if (desc->scanline) x = cut(x);
        bytes[i] = to_byte((double)nd_srgb_encode((float)cut(map->apply(x * exposure,
                                                                        map->parameter))));
    }
}

/* ---- shown quantities ------------------------------------------------------------------------ */

/* x to byte by (x - low) * scale, one of each a channel. */
typedef struct { double low[3], scale[3]; } range;

static range same_range(double low, double scale) {
    return (range){{low, low, low}, {scale, scale, scale}};
}

static range each_channel_filled(const ndl_image *image) {
    range r;
    for (size_t c = 0; c < 3; c++) {
        double low = (double)INFINITY, high = -(double)INFINITY;
        for (size_t i = c; i < value_count(image); i += 3) {
            low = fmin(low, (double)image->rgb[i]);
            high = fmax(high, (double)image->rgb[i]);
        }
        r.low[c] = low;
        r.scale[c] = high > low ? 1.0 / (high - low) : 0.0;
    }
    return r;
}

static range up_to_largest(const ndl_image *image) {
    double high = 0.0;
    for (size_t i = 0; i < value_count(image); i++) high = fmax(high, (double)image->rgb[i]);
    return same_range(0.0, high > 0.0 ? 1.0 / high : 0.0);
}

static range range_of(const ndl_image *image, ndl_show show) {
    switch (show) {
    case NDL_SHOW_WI:
    case NDL_SHOW_WO:
    case NDL_SHOW_NORMAL:
    case NDL_SHOW_TANGENT: return same_range(-1.0, 0.5);
    case NDL_SHOW_POSITION: return each_channel_filled(image);
    case NDL_SHOW_D:
    case NDL_SHOW_V: return up_to_largest(image);
    default: return same_range(0.0, 1.0);
    }
}

static void show_bytes(const ndl_image *image, ndl_show show, unsigned char *bytes) {
    range r = range_of(image, show);
    for (size_t i = 0; i < value_count(image); i++)
        bytes[i] = to_byte(cut(((double)image->rgb[i] - r.low[i % 3]) * r.scale[i % 3]));
}

/* ---- files ----------------------------------------------------------------------------------- */

static bool encode_png(const ndl_image *image, const ndl_write_desc *desc, nd_text *out,
                       ndl_error *error) {
    nd_tonemap map;
    if (!nd_tonemap_parse(desc->tonemap ? desc->tonemap : "clamp", &map, error)) return false;
    unsigned char *bytes = malloc(value_count(image));
    if (!bytes) return nd_fail(error, NDL_E_MEMORY, 0, "out of memory", NULL);
    if (desc->show == NDL_SHOW_RADIANCE) tone_bytes(image, desc, &map, bytes);
    else show_bytes(image, desc->show, bytes);
    bool encoded = nd_png_encode(image->width, image->height, bytes, out, error);
    free(bytes);
    return encoded;
}

static bool ends_in(const char *path, const char *suffix) {
    size_t n = strlen(path), m = strlen(suffix);
    return n > m && strcmp(path + n - m, suffix) == 0;
}

int ndl_image_write(const ndl_image *image, const char *path, const ndl_write_desc *desc,
                    ndl_error *err) {
    ndl_error own = {0};
    nd_text file = {0};
    bool encoded = false;
    if (ends_in(path, ".png"))
        encoded = encode_png(image, desc, &file, &own);
    else if (ends_in(path, ".exr"))
        encoded = nd_exr_encode(image->width, image->height, image->rgb, &file, &own);
    else
        nd_fail(&own, NDL_E_UNKNOWN_NAME, 0,
                "unknown kind of picture; end the name in .png or .exr", NULL);
    if (encoded) nd_file_replace(path, file.s, file.n, &own);
    nd_text_free(&file);
    if (own.code && err) *err = own;
    return own.code;
}
