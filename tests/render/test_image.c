/* SPDX-License-Identifier: Apache-2.0 */
/* EXR keeps every bit of a float; damaged files are refused. */
#include "ndl_test.h"

#include "base/file.h"
#include "io/exr.h"
#include "ndotl/render.h"

static const char path[] = "round_trip.exr";

static void fill(float *rgb, size_t n) {
    uint32_t x = 1;
    for (size_t i = 0; i < n; i++) {
        x = x * 1664525u + 1013904223u;
        memcpy(&rgb[i], &x, sizeof x);
        if (isnan(rgb[i])) rgb[i] = (float)i; /* payloads of NaN are nobody's */
    }
}

static void exr_keeps_every_bit(void **state) {
    (void)state;
    static const int sizes[][2] = {{1, 1}, {3, 16}, {17, 33}, {200, 31}};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        ndl_image *image = ndl_image_new(sizes[k][0], sizes[k][1]);
        size_t n = 3 * (size_t)image->width * (size_t)image->height;
        ndl_error error = {0};
        int width, height;
        float *read;
        fill(image->rgb, n);
        assert_int_equal(ndl_image_write(image, path, &(ndl_write_desc){0}, &error), NDL_OK);
        assert_true(nd_exr_read(path, &width, &height, &read, &error));
        assert_int_equal(width, image->width);
        assert_int_equal(height, image->height);
        assert_memory_equal(read, image->rgb, n * sizeof *read);
        free(read);
        ndl_image_free(image);
    }
    remove(path);
}

static void a_cut_exr_is_refused(void **state) {
    (void)state;
    nd_text whole = {0};
    float rgb[3 * 20 * 20];
    ndl_error error = {0};
    int width, height;
    float *read;
    fill(rgb, 3 * 20 * 20);
    assert_true(nd_exr_encode(20, 20, rgb, &whole, &error));
    for (size_t cut = 0; cut < whole.n; cut += 61) {
        assert_true(nd_file_replace(path, whole.s, cut, &error));
        assert_false(nd_exr_read(path, &width, &height, &read, &error));
        assert_int_equal(error.code, NDL_E_FILE);
        assert_null(read);
    }
    nd_text_free(&whole);
    remove(path);
    assert_false(nd_exr_read(path, &width, &height, &read, &error));
    assert_non_null(strstr(error.text, "No such file"));
}

static void the_kind_of_picture_is_known_or_an_error(void **state) {
    (void)state;
    ndl_image *image = ndl_image_new(2, 2);
    ndl_error error = {0};
    static const char *const names[] = {"a.jpg", "png", ".png", "a.png.bak", "", "a.PNG"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        assert_int_equal(ndl_image_write(image, names[i], &(ndl_write_desc){0}, &error),
                         NDL_E_UNKNOWN_NAME);
        assert_int_equal(error.code, NDL_E_UNKNOWN_NAME);
    }
    assert_int_equal(ndl_image_write(image, "a.png", &(ndl_write_desc){.tonemap = "film"}, NULL),
                     NDL_E_UNKNOWN_NAME);
    assert_int_equal(ndl_image_write(image, "no/folder/a.png", &(ndl_write_desc){0}, NULL),
                     NDL_E_FILE);
    ndl_image_free(image);
    assert_null(ndl_image_new(0, 1));
    assert_null(ndl_image_new(1, 32769));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exr_keeps_every_bit),
        cmocka_unit_test(a_cut_exr_is_refused),
        cmocka_unit_test(the_kind_of_picture_is_known_or_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
