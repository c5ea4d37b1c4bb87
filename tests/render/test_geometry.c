/* SPDX-License-Identifier: Apache-2.0 */
/* Built-in shapes and meshes, cameras, the places of samples. */
#include "ndl_test.h"

#include "ndotl/render.h"
#include "render/geometry.h"
#include "render/lights.h"
#include "render/sampler.h"
#include "render/tonemap.h"

static nd_geometry load(const char *name) {
    nd_geometry g;
    ndl_error error = {0};
    if (!nd_geometry_load(name, &g, &error)) {
        print_error("%s: %s\n", name, error.text);
        fail();
    }
    return g;
}

static void check_frame(const nd_surface *s, dvec toward) {
    assert_absolute(dv_length(s->n), 1.0, 1e-12);
    assert_absolute(dv_length(s->t), 1.0, 1e-12);
    assert_absolute(dv_length(s->g), 1.0, 1e-12);
    assert_absolute(dv_dot(s->n, s->t), 0.0, 1e-12);
    assert_true(dv_dot(s->g, toward) <= 0.0); /* turned to the viewer */
}

/* Rays from all around towards points near the centre: hits inside the bounding sphere, with
   orthonormal frames. */
static void every_builtin_has_frames_and_bounds(void **state) {
    (void)state;
    char names[200];
    strcpy(names, ndl_scene_builtins());
    for (char *name = strtok(names, " "); name; name = strtok(NULL, " ")) {
        nd_geometry g = load(name);
        int hits = 0;
        for (uint32_t i = 0; i < 20000; i++) {
            double a, b, c, d;
            nd_place_sample(1, 0, i, 0, &a, &b);
            nd_place_sample(2, 0, i, 0, &c, &d);
            double z = 2.0 * a - 1.0, r = sqrt(1.0 - z * z), phi = 6.283185307179586 * b;
            dvec from = dv_add(g.centre, dv_scale(dv(r * cos(phi), z, r * sin(phi)), 3 * g.radius));
            dvec at = dv_add(g.centre, dv_scale(dv(c - 0.5, d - 0.5, 0.5 - c * d), g.radius));
            nd_ray ray = {from, dv_unit(dv_sub(at, from))};
            nd_surface s;
            if (!nd_geometry_hit(&g, ray, &s)) continue;
            hits++;
            check_frame(&s, ray.direction);
            assert_true(dv_length(dv_sub(s.p, g.centre)) <= g.radius * (1.0 + 1e-6));
            assert_absolute(dv_length(dv_cross(dv_unit(dv_sub(s.p, from)), ray.direction)), 0.0,
                            1e-6);
            assert_true(s.part < g.mesh.parts);
        }
        assert_true(hits > 4000);
        nd_geometry_free(&g);
    }
}

/* The shaderball's normals are those of its surface: they agree with the triangles. */
static void the_normals_of_the_shaderball_point_out(void **state) {
    (void)state;
    nd_geometry g = load("shaderball");
    const nd_mesh *m = &g.mesh;
    for (size_t i = 0; i < m->triangles; i++) {
        const uint32_t *index = m->index + 3 * i;
        dvec a = dv_from(m->position + 3 * (size_t)index[0]);
        dvec normal = dv_cross(dv_sub(dv_from(m->position + 3 * (size_t)index[1]), a),
                               dv_sub(dv_from(m->position + 3 * (size_t)index[2]), a));
        for (int k = 0; k < 3 && dv_length(normal) > 1e-9; k++) {
            dvec given = dv_from(m->normal + 3 * (size_t)index[k]);
            assert_true(fabs(dv_dot(dv_unit(normal), given)) > 0.98);
        }
    }
    nd_surface s;
    nd_ray ray = {dv(0.0, 0.0, 5.0), dv(0.0, 0.0, -1.0)};
    assert_true(nd_geometry_hit(&g, ray, &s));
    assert_absolute(s.p.z, 1.0, 1e-3);
    assert_absolute(s.n.z, 1.0, 1e-9);
    assert_absolute(s.t.x, 1.0, 1e-9);
    assert_absolute(s.u, 0.5, 1e-3);
    nd_geometry_free(&g);
}

static void the_disc_has_its_grooves_around(void **state) {
    (void)state;
    nd_geometry g = load("disc");
    nd_surface s;
    nd_ray ray = {dv(0.5, 0.0, 2.0), dv(0.0, 0.0, -1.0)};
    assert_true(nd_geometry_hit(&g, ray, &s));
    assert_true(s.t.x == 0.0 && s.t.y == 1.0 && s.n.z == 1.0);
    ray.origin.z = -2.0;
    ray.direction.z = 1.0;
    assert_true(nd_geometry_hit(&g, ray, &s));
    assert_true(s.t.y == 1.0 && s.n.z == -1.0);
    ray.origin.x = 1.01;
    assert_false(nd_geometry_hit(&g, ray, &s));
    nd_geometry_free(&g);
}

static void shapes_block_what_is_behind_them(void **state) {
    (void)state;
    nd_geometry g = load("sphere");
    nd_surface s;
    nd_ray ray = {dv(0.0, 0.0, 5.0), dv(0.0, 0.0, -1.0)};
    assert_true(nd_geometry_hit(&g, ray, &s));
    assert_false(nd_geometry_blocks(&g, &s, dv(0.0, 0.0, 1.0), (double)INFINITY));
    assert_false(nd_geometry_blocks(&g, &s, dv_unit(dv(1.0, 0.0, 1e-6)), (double)INFINITY));
    assert_true(nd_geometry_blocks(&g, &s, dv(0.0, 0.0, -1.0), (double)INFINITY));
    assert_true(nd_geometry_blocks(&g, &s, dv(0.0, 0.0, -1.0), 2.5));
    assert_false(nd_geometry_blocks(&g, &s, dv(0.0, 0.0, -1.0), 1.5));
    nd_geometry_free(&g);
}

/* 2^m samples: one in each of the 2^m boxes of every shape 2^-a x 2^-(m-a). */
static void samples_are_stratified(void **state) {
    (void)state;
    enum { M = 6, COUNT = 1 << M };
    for (uint32_t pixel = 0; pixel < 50; pixel++)
        for (int a = 0; a <= M; a++) {
            int boxes[COUNT] = {0};
            for (uint32_t i = 0; i < COUNT; i++) {
                double x, y;
                nd_place_sample(3, pixel, i, COUNT, &x, &y);
                assert_true(x >= 0.0 && x < 1.0 && y >= 0.0 && y < 1.0);
                boxes[((int)(x * (1 << a)) << (M - a)) + (int)(y * (1 << (M - a)))]++;
            }
            for (int i = 0; i < COUNT; i++) assert_int_equal(boxes[i], 1);
        }
    double x, y;
    nd_place_sample(9, 9, 0, 1, &x, &y);
    assert_true(x == 0.5 && y == 0.5);
}

static void the_default_camera_frames_the_sphere(void **state) {
    (void)state;
    static const int sizes[][2] = {{300, 300}, {600, 300}, {300, 600}};
    static const char *const cameras[] = {"perspective", "parallel", "perspective(fov_y_deg=90)"};
    for (size_t k = 0; k < 3; k++)
        for (size_t c = 0; c < 3; c++) {
            nd_camera camera;
            nd_view view;
            ndl_error error = {0};
            dvec centre = dv(5.0, 6.0, 7.0);
            int w = sizes[k][0], h = sizes[k][1];
            assert_true(nd_camera_parse(cameras[c], &camera, &error));
            assert_true(nd_camera_place(&camera, centre, 2.0, w, h, &view, &error));
            bool wide = w > h; /* the edge of the shorter side touches the sphere */
            nd_ray ray = nd_view_ray(&view, wide ? 0.5 * w : 0.0, wide ? 0.0 : 0.5 * h);
            dvec aside = dv_cross(dv_sub(centre, ray.origin), ray.direction);
            assert_absolute(dv_length(aside), 2.0, 1e-12);
            ray = nd_view_ray(&view, 0.5 * w, 0.5 * h);
            assert_true(ray.direction.z == -1.0);
        }
}

static void lights_obey_their_units(void **state) {
    (void)state;
    nd_light light;
    ndl_error error = {0};
    dvec direction;
    double distance, e[3];
    assert_true(nd_light_parse("directional(direction=[0,0,5], irradiance=[1,2,3])", &light, NULL));
    assert_true(nd_light_arrives(&light, dv(9.0, 9.0, 9.0), &direction, &distance, e));
    assert_true(direction.z == 1.0 && isinf(distance) && e[0] == 1.0 && e[2] == 3.0);
    assert_true(nd_light_parse("point(position=[0,0,4], intensity=32)", &light, &error));
    assert_true(nd_light_arrives(&light, dv(0.0, 0.0, 0.0), &direction, &distance, e));
    assert_true(direction.z == 1.0 && distance == 4.0 && e[1] == 2.0);
    assert_false(nd_light_arrives(&light, dv(0.0, 0.0, 4.0), &direction, &distance, e));
    assert_true(nd_light_parse("point(position=[0,0,4], intensity=32, decay=none)", &light, NULL));
    assert_true(nd_light_arrives(&light, dv(0.0, 0.0, 0.0), &direction, &distance, e));
    assert_true(e[1] == 32.0);
    assert_false(nd_light_arrives(&light, dv(0.0, 0.0, 4.0), &direction, &distance, e));
}

static void tone_maps_stay_in_range(void **state) {
    (void)state;
    static const char *const maps[] = {"clamp", "reinhard", "reinhard_extended",
                                       "reinhard_extended(white=1e-3)", "exponential",
                                       "exponential(k=1e30)", "aces"};
    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++) {
        nd_tonemap map;
        ndl_error error = {0};
        assert_true(nd_tonemap_parse(maps[i], &map, &error));
        double before = 0.0;
        for (double x = 1e-6; x < 1e40; x *= 1.3) {
            double y = map.apply(x, map.parameter);
            assert_true(y >= before - 1e-15 && y <= 1.0); /* roundings of x / (1 + x) */
            before = y;
        }
        assert_true(map.apply(0.0, map.parameter) == 0.0);
        assert_true(map.apply((double)INFINITY, map.parameter) == 1.0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_builtin_has_frames_and_bounds),
        cmocka_unit_test(the_normals_of_the_shaderball_point_out),
        cmocka_unit_test(the_disc_has_its_grooves_around),
        cmocka_unit_test(shapes_block_what_is_behind_them),
        cmocka_unit_test(samples_are_stratified),
        cmocka_unit_test(the_default_camera_frames_the_sphere),
        cmocka_unit_test(lights_obey_their_units),
        cmocka_unit_test(tone_maps_stay_in_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
