/* SPDX-License-Identifier: Apache-2.0 */
/* Printing: what a material prints parses to a material with the same text and the same bits, for
   random materials of every model in every spelling, and white space means nothing. */
#include "../laws/directions.h"

enum { VECTORS = 40, PAIRS = 56 };

static void expect_same_bits(const ndl_material *a, const ndl_material *b) {
    static pairs p, q;
    draws d = draws_of(11);
    fill_pairs(&d, &p, PAIRS, FINITE_KINDS);
    q = p;
    ndl_brdf_cos_n(a, PAIRS, wi_of(&p), wo_of(&p), rgb_of(&p));
    ndl_brdf_cos_n(b, PAIRS, wi_of(&q), wo_of(&q), rgb_of(&q));
    for (int c = 0; c < 3; c++)
        if (memcmp(p.rgb[c], q.rgb[c], PAIRS * sizeof(float)) != 0)
            fail_msg("%s: other bits when parsed again", ndl_material_text(a));
}

static void expect_fixed_point(const ndl_material *m) {
    ndl_error err;
    ndl_material *again = ndl_material_parse(ndl_material_text(m), &err);
    if (!again) fail_msg("%s: column %d: %s", ndl_material_text(m), err.column, err.text);
    assert_string_equal(ndl_material_text(again), ndl_material_text(m));
    assert_string_equal(ndl_material_json(again), ndl_material_json(m));
    assert_int_equal(ndl_material_claims(again), ndl_material_claims(m));
    expect_same_bits(m, again);
    ndl_material_free(again);
}

/* Blanks around every sign that separates tokens. */
static void spread_out(draws *d, const char *text, char *to) {
    static const char *const blanks[] = {"", " ", "\t", "\n", "  \r\n "};
    for (; *text; text++) {
        bool sign = strchr("()[]=,:*", *text) || *text == ' ';
        if (sign) to += sprintf(to, "%s", blanks[draw_bits(d) % 5]);
        if (*text != ' ') *to++ = *text;
        if (sign) to += sprintf(to, "%s", blanks[draw_bits(d) % 5]);
    }
    *to = '\0';
}

static void printed_materials_parse_to_the_same_bits(void **state) {
    size_t model = model_of(state);
    int axes, all = combinations(model, &axes);
    draws d = draws_of(model + 500);
    for (int c = 0; c < all; c++) {
        for (unsigned v = 0; v < thinned(VECTORS); v++) {
            char text[8 * TEXT_ROOM];
            ndl_material *m = vector_material(model, c, v, false);
            expect_fixed_point(m);
            spread_out(&d, ndl_material_text(m), text);
            ndl_material *wide = ndl_material_parse(text, NULL);
            if (!wide) fail_msg("'%s' does not parse", text);
            assert_string_equal(ndl_material_text(wide), ndl_material_text(m));
            ndl_material_free(wide);
            snprintf(text, sizeof text, "%.9g * %s + [%.9g,%.9g,%.9g]*%s", draw(&d) * 1e-3,
                     ndl_material_text(m), draw(&d), 1e30 * draw(&d), 1e-30 * draw(&d),
                     ndl_model_name(draw_bits(&d) % ndl_model_count()));
            ndl_material *sum = ndl_material_parse(text, NULL);
            if (!sum) fail_msg("'%s' does not parse", text);
            expect_fixed_point(sum);
            ndl_material_free(sum);
            ndl_material_free(m);
        }
    }
}

static void the_json_form_is_the_long_one(void **state) {
    (void)state;
    static const struct { const char *text, *json; } rows[] = {
        {"ggx(alpha=0.3, f0=[1,0.71,0.29])",
         "{\"lobes\":[{\"weight\":[1,1,1],\"model\":\"ggx\",\"params\":{\"alpha\":0.3,"
         "\"f0\":[1,0.71,0.29]}}]}"},
        {"0.5*lambert+[1,0,2]*toon_diffuse(ramp=[0:0.1,0.5:[1,2,3]])",
         "{\"lobes\":[{\"weight\":[0.5,0.5,0.5],\"model\":\"lambert\",\"params\":{}},"
         "{\"weight\":[1,0,2],\"model\":\"toon_diffuse\",\"params\":{\"ramp\":[[0,0.1],"
         "[0.5,[1,2,3]]]}}]}"},
        {"ggx(preset=gold,masking=smith)",
         "{\"lobes\":[{\"weight\":[1,1,1],\"model\":\"ggx\",\"params\":{\"masking\":\"smith\","
         "\"preset\":\"gold\"}}]}"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        ndl_material *m = ndl_material_parse(rows[i].text, NULL);
        assert_non_null(m);
        assert_string_equal(ndl_material_json(m), rows[i].json);
        ndl_material_free(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_json_form_is_the_long_one)};
    int failed = cmocka_run_group_tests_name("json", tests, NULL, NULL);
    return failed + run_over_models("printing", printed_materials_parse_to_the_same_bits);
}
