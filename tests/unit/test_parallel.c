/* SPDX-License-Identifier: Apache-2.0 */
/* Batches by several threads have the bits of the batch by one, for any number of threads and any
   length, and write nothing past their end. */
#include "ndl_test.h"

#include <ndotl/ndotl.h>

enum { MOST = 5 * NDL_THREADS_LEAST + 77, CANARY = 16 };
static float in[6][MOST], want[3][MOST], got[3][MOST + CANARY];

static float uniform(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return (float)(*state >> 8) * 0x1p-24f;
}

static void random_directions(void) {
    uint32_t state = 7;
    for (int i = 0; i < MOST; i++)
        for (int k = 0; k < 2; k++) {
            float x = 2.0f * uniform(&state) - 1.0f, y = 2.0f * uniform(&state) - 1.0f;
            float z = uniform(&state) - 0.1f, l = sqrtf(x * x + y * y + z * z + 1e-9f);
            in[3 * k][i] = x / l;
            in[3 * k + 1][i] = y / l;
            in[3 * k + 2][i] = z / l;
        }
}

static void compare(const ndl_material *m, int threads, size_t n, int cosine) {
    ndl_vec3_n wi = {in[0], in[1], in[2]}, wo = {in[3], in[4], in[5]};
    ndl_rgb_n a = {want[0], want[1], want[2]}, b = {got[0], got[1], got[2]};
    for (int c = 0; c < 3; c++)
        for (size_t i = 0; i < CANARY; i++)
            got[c][n + i] = -7.0f;
    (cosine ? ndl_brdf_cos_n : ndl_brdf_n)(m, n, wi, wo, a);
    (cosine ? ndl_brdf_cos_threads_n : ndl_brdf_threads_n)(m, threads, n, wi, wo, b);
    for (int c = 0; c < 3; c++) {
        if (memcmp(want[c], got[c], n * sizeof(float)) != 0)
            fail_msg("%d threads, %zu pairs: other bits in channel %d", threads, n, c);
        for (size_t i = 0; i < CANARY; i++)
            if (got[c][n + i] != -7.0f) fail_msg("%d threads: wrote past %zu pairs", threads, n);
    }
}

static void any_number_of_threads_gives_the_same_bits(void **unused) {
    static const int threads[] = {-1, 0, 1, 2, 3, 8, 5000};
    static const size_t lengths[] = {
        0, 1, 31, NDL_THREADS_LEAST - 1, NDL_THREADS_LEAST, NDL_THREADS_LEAST + 1, MOST};
    (void)unused;
    ndl_material *m = ndl_material_parse("0.3*lambert + 0.7*ggx(alpha_x=0.1, alpha_y=0.4)", NULL);
    assert_non_null(m);
    for (size_t t = 0; t < sizeof threads / sizeof *threads; t++)
        for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++)
            compare(m, threads[t], lengths[i], (int)(i & 1));
    ndl_material_free(m);
}

static void outputs_may_be_the_inputs(void **unused) {
    (void)unused;
    ndl_material *m = ndl_material_parse("ggx(preset=gold)", NULL);
    assert_non_null(m);
    ndl_vec3_n wi = {got[0], got[1], got[2]}, wo = {in[3], in[4], in[5]};
    for (int c = 0; c < 3; c++)
        memcpy(got[c], in[c], sizeof in[c]);
    ndl_brdf_n(m, MOST, (ndl_vec3_n){in[0], in[1], in[2]}, wo,
               (ndl_rgb_n){want[0], want[1], want[2]});
    ndl_brdf_threads_n(m, 2, MOST, wi, wo, (ndl_rgb_n){got[0], got[1], got[2]});
    for (int c = 0; c < 3; c++)
        assert_memory_equal(got[c], want[c], sizeof want[c]);
    ndl_material_free(m);
}

int main(void) {
    random_directions();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(outputs_may_be_the_inputs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
