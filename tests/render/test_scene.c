/* SPDX-License-Identifier: Apache-2.0 */
/* The public rendering API as a user meets it. */
#include "ndl_test.h"

#include "ndotl/render.h"

static ndl_scene *ball(void) {
    ndl_error error = {0};
    ndl_scene *scene = ndl_scene_load("shaderball", &error);
    if (!scene) {
        print_error("%s\n", error.text);
        fail();
    }
    return scene;
}

static void every_builtin_loads(void **state) {
    (void)state;
    char names[200];
    strcpy(names, ndl_scene_builtins());
    for (char *name = strtok(names, " "); name; name = strtok(NULL, " ")) {
        ndl_scene *scene = ndl_scene_load(name, NULL);
        assert_non_null(scene);
        assert_true(ndl_scene_parts(scene) >= 1);
        assert_true(strlen(ndl_scene_part(scene, 0).mesh) > 0);
        ndl_scene_free(scene);
    }
    ndl_error error = {0};
    assert_null(ndl_scene_load("spere", &error));
    assert_int_equal(error.code, NDL_E_FILE);
    ndl_scene_free(NULL);
}

static void failures_leave_the_scene_as_it_was(void **state) {
    (void)state;
    ndl_error error = {0};
    ndl_scene *scene = ball();
    ndl_image *before = ndl_image_new(20, 20), *after = ndl_image_new(20, 20);
    assert_int_equal(ndl_render(scene, &(ndl_render_desc){0}, before, NULL, &error), NDL_OK);
    assert_int_equal(ndl_scene_add_light(scene, "point(position=[0,0", &error), NDL_E_SYNTAX);
    assert_int_equal(error.column, 20);
    assert_int_equal(ndl_scene_add_light(scene, "lamp", NULL), NDL_E_UNKNOWN_NAME);
    assert_int_equal(ndl_scene_set_camera(scene, "perspective(fov=3)", NULL), NDL_E_UNKNOWN_NAME);
    assert_int_equal(ndl_scene_set_material(scene, "bal", NULL, &error), NDL_E_UNKNOWN_NAME);
    assert_non_null(strstr(error.text, "ball, stand"));
    assert_int_equal(ndl_render(scene, &(ndl_render_desc){0}, after, NULL, &error), NDL_OK);
    assert_memory_equal(before->rgb, after->rgb, 3 * 20 * 20 * sizeof(float));
    ndl_image_free(before);
    ndl_image_free(after);
    ndl_scene_free(scene);
}

static int stop_at_half(void *user, double done) {
    int *calls = user;
    ++*calls;
    return done >= 0.5;
}

static void progress_can_stop_a_render(void **state) {
    (void)state;
    ndl_error error = {0};
    ndl_scene *scene = ball();
    ndl_image *image = ndl_image_new(320, 320); /* 100 tiles */
    int calls = 0;
    ndl_render_desc desc = {.progress = stop_at_half, .user = &calls, .threads = 2};
    assert_int_equal(ndl_render(scene, &desc, image, NULL, &error), NDL_E_CANCELLED);
    assert_in_range(calls, 50, 52);
    ndl_image_free(image);
    ndl_scene_free(scene);
}

static void impossible_requests_are_errors(void **state) {
    (void)state;
    ndl_error error = {0};
    ndl_scene *scene = ball();
    ndl_image *image = ndl_image_new(4, 4);
    ndl_render_desc desc = {.show = NDL_SHOW_D};
    assert_int_equal(ndl_render(scene, &desc, image, NULL, &error), NDL_E_UNSUPPORTED);
    desc = (ndl_render_desc){.samples = 65537};
    assert_int_equal(ndl_render(scene, &desc, image, NULL, &error), NDL_E_RANGE);
    desc = (ndl_render_desc){.samples = -1};
    assert_int_equal(ndl_render(scene, &desc, image, NULL, &error), NDL_E_RANGE);
    assert_int_equal(ndl_scene_set_camera(scene, "parallel(eye=[1,1,1], target=[1,1,1])", NULL), 0);
    assert_int_equal(ndl_render(scene, &(ndl_render_desc){0}, image, NULL, &error), NDL_E_RANGE);
    ndl_image_free(image);
    ndl_scene_free(scene);
}

static void statistics_count_what_was_done(void **state) {
    (void)state;
    ndl_render_stats stats;
    ndl_scene *scene = ndl_scene_load("sphere", NULL);
    ndl_image *image = ndl_image_new(33, 31);
    ndl_render_desc desc = {.samples = 3, .shadows = 1, .threads = 64};
    assert_int_equal(ndl_render(scene, &desc, image, &stats, NULL), NDL_OK);
    assert_int_equal(stats.rays, 33 * 31 * 3);
    assert_true(stats.hits > 1500 && stats.hits < stats.rays);
    assert_int_equal(stats.shaded, 2 * stats.hits); /* key and fill */
    assert_true(stats.shadow_rays > 0 && stats.shadow_rays < stats.shaded);
    assert_int_equal(stats.threads, 2); /* no more than tiles */
    ndl_image_free(image);
    ndl_scene_free(scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_builtin_loads),
        cmocka_unit_test(failures_leave_the_scene_as_it_was),
        cmocka_unit_test(progress_can_stop_a_render),
        cmocka_unit_test(impossible_requests_are_errors),
        cmocka_unit_test(statistics_count_what_was_done),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
