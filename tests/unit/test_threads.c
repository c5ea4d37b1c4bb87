/* SPDX-License-Identifier: Apache-2.0 */
/* Many threads share one material, parse their own and make changed copies at once; every one gets
   the values that one thread gets. ThreadSanitizer sees any race (preset tsan). */
#include "ndl_test.h"

#include "base/threads.h"

#include <ndotl/ndotl.h>
#include <stdatomic.h>

static const char SHARED[] = "0.4*oren_nayar(variant=table) + 0.6*ggx(preset=gold)";
enum { ITEMS = 400, THREADS = 8, PAIRS = 300 };

typedef struct {
    const ndl_material *shared;
    float want[3][PAIRS];
    atomic_int wrong, done;
} common;

static void fill(float w[6][PAIRS]) {
    for (int i = 0; i < PAIRS; i++) {
        double a = 0.1 * i, b = 0.17 * i + 1.0, z = 0.05 + 0.9 * (i % 17) / 17.0;
        w[0][i] = (float)(sqrt(1.0 - z * z) * cos(a));
        w[1][i] = (float)(sqrt(1.0 - z * z) * sin(a));
        w[2][i] = (float)z;
        w[3][i] = (float)(0.6 * cos(b));
        w[4][i] = (float)(0.6 * sin(b));
        w[5][i] = 0.8f;
    }
}

static void evaluate(const ndl_material *m, float out[3][PAIRS]) {
    float w[6][PAIRS];
    fill(w);
    ndl_brdf_n(m, PAIRS, (ndl_vec3_n){w[0], w[1], w[2]}, (ndl_vec3_n){w[3], w[4], w[5]},
               (ndl_rgb_n){out[0], out[1], out[2]});
}

static void work(void *context, int thread, size_t item) {
    common *c = context;
    float got[3][PAIRS];
    ndl_error err;
    (void)thread;
    evaluate(c->shared, got);
    if (memcmp(got, c->want, sizeof got) != 0) atomic_fetch_add(&c->wrong, 1);
    ndl_material *own = ndl_material_parse(ndl_material_text(c->shared), &err);
    ndl_material *copy = ndl_material_with(c->shared, "1.alpha", 0.001 * (double)(item + 1), &err);
    if (!own || !copy || ndl_material_parse("nonsense", &err)) atomic_fetch_add(&c->wrong, 1);
    if (own) evaluate(own, got);
    if (memcmp(got, c->want, sizeof got) != 0) atomic_fetch_add(&c->wrong, 1);
    ndl_material_free(own);
    ndl_material_free(copy);
    atomic_fetch_add(&c->done, 1);
}

static void threads_share_a_material(void **state) {
    (void)state;
    static common c;
    ndl_material *m = ndl_material_parse(SHARED, NULL);
    assert_non_null(m);
    c.shared = m;
    nd_jobs jobs = {.count = ITEMS, .work = work, .context = &c};
    evaluate(m, c.want);
    assert_true(nd_jobs_run(&jobs, THREADS));
    assert_int_equal(atomic_load(&c.done), ITEMS);
    assert_int_equal(atomic_load(&c.wrong), 0);
    ndl_material_free(m);
}

static void pick(void *context, int thread, size_t item) {
    (void)thread;
    ((const char **)context)[item] = ndl_isa();
}

static void threads_agree_on_the_instruction_set(void **state) {
    (void)state;
    const char *seen[64] = {0};
    nd_jobs jobs = {.count = 64, .work = pick, .context = seen};
    assert_true(nd_jobs_run(&jobs, THREADS));
    for (int i = 0; i < 64; i++) assert_string_equal(seen[i], ndl_isa());
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_agree_on_the_instruction_set), /* before anything is chosen */
        cmocka_unit_test(threads_share_a_material),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
