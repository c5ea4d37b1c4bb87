/* SPDX-License-Identifier: Apache-2.0 */
/* lut1 and lut2 of the C prelude, and the small vector helpers. */
#include "ndl_test.h"

#include "shade/math.h"

static vec3 grey(float v) {
    return v3(v, v, v);
}

static void expect(vec3 got, vec3 want) {
    assert_same_float(got.x, want.x);
    assert_same_float(got.y, want.y);
    assert_same_float(got.z, want.z);
}

static void a_ramp_is_linear_between_stops_and_constant_outside(void **state) {
    (void)state;
    const float x[] = {-0.5f, 0.25f, 1.0f};
    const float r[] = {0.0f, 1.0f, 0.5f}, g[] = {1.0f, 0.0f, 0.0f}, b[] = {2.0f, 2.0f, 2.0f};
    table1 t = {x, r, g, b, 3};
    expect(lut1(t, -2.0f), v3(0.0f, 1.0f, 2.0f));
    expect(lut1(t, -0.5f), v3(0.0f, 1.0f, 2.0f));
    expect(lut1(t, -0.125f), v3(0.5f, 0.5f, 2.0f));
    expect(lut1(t, 0.25f), v3(1.0f, 0.0f, 2.0f));
    expect(lut1(t, 0.625f), v3(0.75f, 0.0f, 2.0f));
    expect(lut1(t, 1.0f), v3(0.5f, 0.0f, 2.0f));
    expect(lut1(t, INFINITY), v3(0.5f, 0.0f, 2.0f));
}

static void two_stops_at_one_place_are_a_step_to_the_later(void **state) {
    (void)state;
    const float x[] = {0.0f, 0.5f, 0.5f, 0.5f, 1.0f}, c[] = {0.0f, 1.0f, 9.0f, 4.0f, 6.0f};
    table1 t = {x, c, c, c, 5};
    assert_close(lut1(t, 0.49999997f).x, 0.99999994, 1e-7, 0.0);
    expect(lut1(t, 0.5f), grey(4.0f));
    expect(lut1(t, 0.75f), grey(5.0f));
    const float edge[] = {0.5f, 0.5f};
    table1 step = {edge, c, c, c, 2};
    expect(lut1(step, 0.49f), grey(0.0f));
    expect(lut1(step, 0.5f), grey(1.0f));
    expect(lut1(step, 0.51f), grey(1.0f));
}

static void one_stop_is_a_constant(void **state) {
    (void)state;
    const float x[] = {0.5f}, c[] = {0.3f};
    table1 t = {x, c, c, c, 1};
    expect(lut1(t, -1.0f), grey(0.3f));
    expect(lut1(t, 0.5f), grey(0.3f));
    expect(lut1(t, 2.0f), grey(0.3f));
    expect(lut1(t, NAN), grey(0.3f));
}

static void colours_next_to_black_keep_their_digits(void **state) {
    (void)state;
    const float x[] = {0.0f, 1.0f}, c[] = {1.0f, 0.0f};
    table1 t = {x, c, c, c, 2};
    assert_relative(lut1(t, 0.99999988f).x, 1.0 - 0.99999988079071045, 1e-7);
}

static void every_number_of_stops_finds_the_right_pair(void **state) {
    (void)state;
    static float x[TABLE1_STOPS], c[TABLE1_STOPS];
    for (int n = 2; n <= TABLE1_STOPS; n += n < 64 ? 1 : n / 3) {
        for (int k = 0; k < n; k++) {
            x[k] = (float)k;
            c[k] = (float)(k * k % 17);
        }
        table1 t = {x, c, c, c, n};
        for (int k = 0; k + 1 < n; k++) {
            expect(lut1(t, (float)k), grey(c[k]));
            expect(lut1(t, (float)k + 0.5f), grey(0.5f * (c[k] + c[k + 1])));
        }
        expect(lut1(t, (float)n), grey(c[n - 1]));
    }
}

static void a_grid_is_bilinear_between_its_edge_texels(void **state) {
    (void)state;
    const float v[] = {0.0f, 1.0f, 4.0f, 2.0f, 3.0f, 6.0f}; /* 3 wide, 2 high */
    table2 t = {v, 3, 2};
    assert_same_float(lut2(t, 0.0f, 0.0f), 0.0f);
    assert_same_float(lut2(t, 1.0f, 0.0f), 4.0f);
    assert_same_float(lut2(t, 0.0f, 1.0f), 2.0f);
    assert_same_float(lut2(t, 1.0f, 1.0f), 6.0f);
    assert_same_float(lut2(t, 0.5f, 0.0f), 1.0f);
    assert_same_float(lut2(t, 0.25f, 0.5f), 1.5f);
    assert_same_float(lut2(t, -3.0f, 2.0f), 2.0f);
    assert_same_float(lut2(t, 7.0f, -1.0f), 4.0f);
    assert_same_float(lut2(t, NAN, NAN), 0.0f);
    table2 single = {v + 1, 1, 1};
    assert_same_float(lut2(single, 0.3f, 0.9f), 1.0f);
}

static void vector_helpers(void **state) {
    (void)state;
    vec3 u = v3_unit(v3(3.0f, 0.0f, 4.0f));
    assert_close(u.x, 0.6, 1e-7, 0.0);
    assert_close(u.z, 0.8, 1e-7, 0.0);
    expect(v3_cross(v3(1.0f, 0.0f, 0.0f), v3(0.0f, 1.0f, 0.0f)), v3(0.0f, 0.0f, 1.0f));
    expect(v3_lerp(grey(0.1f), grey(0.7f), 0.0f), grey(0.1f));
    expect(v3_lerp(grey(0.1f), grey(0.7f), 1.0f), grey(0.7f));
    expect(v3_sel(1 > 0, grey(1.0f), grey(2.0f)), grey(1.0f));
    assert_same_float(clamp_(NAN, 0.0f, 1.0f), 0.0f);
    assert_same_float(clamp_(2.0f, 0.0f, 1.0f), 1.0f);
    assert_same_float(round_(2.5f), 2.0f);
    assert_same_float(round_(-3.7f), -4.0f);
    assert_true(both(1, 1) && !both(1, 0) && either(1, 0) && !either(0, 0) && not_(0));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ramp_is_linear_between_stops_and_constant_outside),
        cmocka_unit_test(two_stops_at_one_place_are_a_step_to_the_later),
        cmocka_unit_test(one_stop_is_a_constant),
        cmocka_unit_test(colours_next_to_black_keep_their_digits),
        cmocka_unit_test(every_number_of_stops_finds_the_right_pair),
        cmocka_unit_test(a_grid_is_bilinear_between_its_edge_texels),
        cmocka_unit_test(vector_helpers),
    };
    return cmocka_run_group_tests_name("tables", tests, NULL, NULL);
}
