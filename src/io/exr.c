/* SPDX-License-Identifier: Apache-2.0 */
#include "io/exr.h"

#include "base/error.h"
#include "base/file.h"

#include <openexr.h>
#include <stdlib.h>
#include <string.h>

enum { CHANNELS = 3 };

/* Files list channels by name: the colour channel of each place in the file. */
static const char *const NAMES[CHANNELS] = {"B", "G", "R"};
static const int PLACE[CHANNELS] = {2, 1, 0};

static void stay_silent(exr_const_context_t file, exr_result_t code, const char *text) {
    (void)file;
    (void)code;
    (void)text;
}

/* OpenEXR writes the table of block offsets last, over the room that it left for it. */
static int64_t write_at(exr_const_context_t file, void *user, const void *bytes, uint64_t size,
                        uint64_t offset, exr_stream_error_func_ptr_t report) {
    nd_text *out = user;
    (void)file;
    (void)report;
    while (!out->failed && out->n < offset) nd_text_bytes(out, "", 1);
    size_t over = offset < out->n ? out->n - (size_t)offset : 0;
    if (over > size) over = (size_t)size;
    if (over) memcpy(out->s + offset, bytes, over);
    nd_text_bytes(out, (const char *)bytes + over, (size_t)size - over);
    return out->failed ? -1 : (int64_t)size;
}

static exr_result_t write_header(exr_context_t file, int width, int height) {
    int part = 0;
    exr_result_t code = exr_add_part(file, "rgb", EXR_STORAGE_SCANLINE, &part);
    if (!code)
        code = exr_initialize_required_attr_simple(file, part, width, height, EXR_COMPRESSION_ZIP);
    for (int c = 0; !code && c < CHANNELS; c++)
        code = exr_add_channel(file, part, NAMES[c], EXR_PIXEL_FLOAT,
                               EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    return code ? code : exr_write_header(file);
}

/* Encodes the block of lines that begins with line y. */
static exr_result_t write_block(exr_context_t file, exr_encode_pipeline_t *pipe, int width, int y,
                                const float *rgb) {
    exr_chunk_info_t block;
    exr_result_t code = exr_write_scanline_chunk_info(file, 0, y, &block);
    if (!code)
        code = y ? exr_encoding_update(file, 0, &block, pipe)
                 : exr_encoding_initialize(file, 0, &block, pipe);
    for (int c = 0; !code && c < CHANNELS; c++) {
        exr_coding_channel_info_t *to = &pipe->channels[c];
        const float *first = rgb + 3 * (size_t)width * (size_t)y + PLACE[c];
        to->encode_from_ptr = (const uint8_t *)first;
        to->user_bytes_per_element = sizeof(float);
        to->user_data_type = EXR_PIXEL_FLOAT;
        to->user_pixel_stride = 3 * sizeof(float);
        to->user_line_stride = 3 * width * (int)sizeof(float);
    }
    if (!code && !y) code = exr_encoding_choose_default_routines(file, 0, pipe);
    return code ? code : exr_encoding_run(file, 0, pipe);
}

bool nd_exr_encode(int width, int height, const float *rgb, nd_text *out, ndl_error *error) {
    exr_context_initializer_t with = EXR_DEFAULT_CONTEXT_INITIALIZER;
    exr_context_t file = NULL;
    exr_encode_pipeline_t pipe = EXR_ENCODE_PIPELINE_INITIALIZER;
    with.user_data = out;
    with.write_fn = write_at;
    with.error_handler_fn = stay_silent;
    exr_result_t code = exr_start_write(&file, "memory", EXR_WRITE_FILE_DIRECTLY, &with);
    if (!code) code = write_header(file, width, height);
    int lines = 1;
    if (!code) code = exr_get_scanlines_per_chunk(file, 0, &lines);
    for (int y = 0; !code && y < height; y += lines) code = write_block(file, &pipe, width, y, rgb);
    if (file) {
        exr_encoding_destroy(file, &pipe);
        exr_result_t last = exr_finish(&file);
        if (!code) code = last;
    }
    if (!code && !out->failed) return true;
    return nd_fail(error, NDL_E_MEMORY, 0, "out of memory while the EXR was encoded", NULL);
}

/* Decodes the block of lines that begins with line y of the file into the picture. */
static exr_result_t read_block(exr_context_t file, exr_decode_pipeline_t *pipe,
                               const exr_attr_box2i_t *window, int y, float *rgb) {
    exr_chunk_info_t block;
    bool first = y == window->min.y;
    size_t width = (size_t)(window->max.x - window->min.x + 1);
    exr_result_t code = exr_read_scanline_chunk_info(file, 0, y, &block);
    if (!code)
        code = first ? exr_decoding_initialize(file, 0, &block, pipe)
                     : exr_decoding_update(file, 0, &block, pipe);
    int found = 0;
    for (int c = 0; !code && c < pipe->channel_count; c++) {
        exr_coding_channel_info_t *from = &pipe->channels[c];
        from->decode_to_ptr = NULL;
        for (int i = 0; i < CHANNELS; i++) {
            if (strcmp(from->channel_name, NAMES[i]) != 0) continue;
            if (from->x_samples != 1 || from->y_samples != 1) return EXR_ERR_INVALID_ATTR;
            float *to = rgb + 3 * width * (size_t)(y - window->min.y) + PLACE[i];
            from->decode_to_ptr = (uint8_t *)to;
            from->user_bytes_per_element = sizeof(float);
            from->user_data_type = EXR_PIXEL_FLOAT;
            from->user_pixel_stride = 3 * sizeof(float);
            from->user_line_stride = (int32_t)(3 * width * sizeof(float));
            found++;
        }
    }
    if (!code && found != CHANNELS) code = EXR_ERR_MISSING_REQ_ATTR;
    if (!code && first) code = exr_decoding_choose_default_routines(file, 0, pipe);
    return code ? code : exr_decoding_run(file, 0, pipe);
}

static exr_result_t read_picture(exr_context_t file, exr_attr_box2i_t *window, float **rgb,
                                 ndl_error *error) {
    exr_storage_t storage = EXR_STORAGE_LAST_TYPE;
    int lines = 1;
    exr_result_t code = exr_get_storage(file, 0, &storage);
    if (!code && storage != EXR_STORAGE_SCANLINE) code = EXR_ERR_USE_TILE_NONDEEP_WRITE;
    if (!code) code = exr_get_data_window(file, 0, window);
    if (!code) code = exr_get_scanlines_per_chunk(file, 0, &lines);
    if (code) return code;
    int64_t width = (int64_t)window->max.x - window->min.x + 1;
    int64_t height = (int64_t)window->max.y - window->min.y + 1;
    if (width < 1 || height < 1) return EXR_ERR_INVALID_ATTR;
    if (width > (1 << 24) || height > (1 << 28) / width) {
        nd_fail(error, NDL_E_LIMIT, 0, "has more than 2^28 pixels", NULL);
        return EXR_ERR_OUT_OF_MEMORY;
    }
    *rgb = malloc(3 * (size_t)width * (size_t)height * sizeof **rgb);
    if (!*rgb) return EXR_ERR_OUT_OF_MEMORY;
    exr_decode_pipeline_t pipe = EXR_DECODE_PIPELINE_INITIALIZER;
    for (int y = window->min.y; !code && y <= window->max.y; y += lines)
        code = read_block(file, &pipe, window, y, *rgb);
    exr_decoding_destroy(file, &pipe);
    return code;
}

bool nd_exr_read(const char *path, int *width, int *height, float **rgb, ndl_error *error) {
    exr_context_initializer_t with = EXR_DEFAULT_CONTEXT_INITIALIZER;
    exr_context_t file = NULL;
    exr_attr_box2i_t window = {0};
    *rgb = NULL;
    if (!nd_file_readable(path, error)) return false;
    with.error_handler_fn = stay_silent;
    ndl_error limit = {0};
    exr_result_t code = exr_start_read(&file, path, &with);
    if (!code) code = read_picture(file, &window, rgb, &limit);
    if (file) exr_finish(&file);
    *width = window.max.x - window.min.x + 1;
    *height = window.max.y - window.min.y + 1;
    if (!code) return true;
    free(*rgb);
    *rgb = NULL;
    if (limit.code) return nd_fail(error, limit.code, 0, limit.text, NULL);
    if (code == EXR_ERR_OUT_OF_MEMORY)
        return nd_fail(error, NDL_E_MEMORY, 0, "out of memory", NULL);
    return nd_fail(error, NDL_E_FILE, 0, "is not a whole scan-line EXR with channels R, G, B: ",
                   exr_get_default_error_message(code), NULL);
}
