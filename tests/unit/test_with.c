/* SPDX-License-Identifier: Apache-2.0 */
/* ndl_material_with: changed copies, as canonical text. */
#include "ndl_test.h"

#include <ndotl/ndotl.h>

static ndl_material *parsed(const char *text) {
    ndl_error err;
    ndl_material *m = ndl_material_parse(text, &err);
    if (!m) fail_msg("%s: column %d: %s", text, err.column, err.text);
    return m;
}

static void a_changed_copy_prints_what_was_meant(void **state) {
    (void)state;
    static const struct { const char *text, *key; double value; const char *want; } rows[] = {
        {"lambert", "color", 0.25, "lambert(color=0.25)"},
        {"lambert(color=0.5)", "color.g", 0.25, "lambert(color=[0.5, 0.25, 0.5])"},
        {"lambert", "color.b", 0, "lambert(color=[0.8, 0.8, 0])"},
        {"lambert(color=[0.1,0.2,0.3])", "color", 0.5, "lambert(color=0.5)"},
        {"ggx(alpha=0.3)", "alpha", 0.1, "ggx(alpha=0.1)"},
        {"ggx(alpha=0.3)", "roughness", 0.5, "ggx(roughness=0.5)"},
        {"ggx(roughness=0.3)", "alpha", 0.5, "ggx(alpha=0.5)"},
        {"ggx(alpha=0.2)", "alpha_x", 0.5, "ggx(alpha_x=0.5, alpha_y=0.2)"},
        {"ggx(roughness=0.5)", "alpha_y", 0.5, "ggx(alpha_x=0.25, alpha_y=0.5)"},
        {"ggx(alpha_x=0.1,alpha_y=0.2)", "alpha", 0.5, "ggx(alpha=0.5)"},
        {"ggx(alpha_x=0.1,alpha_y=0.2)", "roughness", 0.5, "ggx(roughness=0.5)"},
        {"ggx(preset=gold)", "f0", 0.5, "ggx(f0=0.5)"},
        {"ggx(preset=gold,roughness=0.3)", "roughness", 0.5, "ggx(roughness=0.5, preset=gold)"},
        {"ggx(ior=1.5)", "ior", 2, "ggx(ior=2)"},
        {"ggx(f0=0.5)", "ior", 2, "ggx(ior=2)"},
        {"ggx(eta=0.2,k=3)", "k", 2, "ggx(eta=0.2, k=2)"},
        {"ggx(eta=0.2,k=3)", "k.g", 2, "ggx(eta=0.2, k=[3, 2, 3])"},
        {"oren_nayar(sigma=0.3)", "sigma_deg", 10, "oren_nayar(sigma_deg=10)"},
        {"oren_nayar(sigma_deg=10)", "sigma", 0.5, "oren_nayar(sigma=0.5)"},
        {"oren_nayar(sigma=0.3)", "a", 0.75, "oren_nayar(a=0.75)"},
        {"oren_nayar(a=0.75,variant=full)", "sigma", 0.5, "oren_nayar(sigma=0.5, variant=full)"},
        {"toon_diffuse(ramp=[0:0.1,1:1])", "threshold", 0.25,
         "toon_diffuse(color1=0.8, color2=0.2, threshold=0.25)"}, /* the fields that the ramp hid */
        {"0.5*lambert + 0.5*ggx(alpha=0.3)", "1.roughness", 0.5,
         "0.5*lambert + 0.5*ggx(roughness=0.5)"},
        {"0.5*lambert + 0.5*ggx(alpha=0.3)", "0.color.r", 0.5,
         "0.5*lambert(color=[0.5, 0.8, 0.8]) + 0.5*ggx(alpha=0.3)"},
        {"ward(alpha=0.2)", "alpha_y", 0.4, "ward(alpha_x=0.2, alpha_y=0.4)"},
    };
    int wrong = 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        ndl_error err;
        ndl_material *m = parsed(rows[i].text);
        ndl_material *changed = ndl_material_with(m, rows[i].key, rows[i].value, &err);
        const char *got = changed ? ndl_material_text(changed) : err.text;
        if (!changed || strcmp(got, rows[i].want) != 0) {
            wrong++;
            print_error("%s, %s = %g: %s, want %s\n", rows[i].text, rows[i].key, rows[i].value, got,
                        rows[i].want);
        }
        ndl_material *again = ndl_material_parse(rows[i].text, NULL); /* m is untouched */
        assert_string_equal(ndl_material_text(m), ndl_material_text(again));
        ndl_material_free(again);
        ndl_material_free(m);
        ndl_material_free(changed);
    }
    assert_int_equal(wrong, 0);
}

static void what_cannot_be_changed_is_refused(void **state) {
    (void)state;
    static const struct { const char *text, *key; double value; int code; } rows[] = {
        {"lambert", "colour", 0.5, NDL_E_UNKNOWN_NAME},
        {"lambert", "1.color", 0.5, NDL_E_UNKNOWN_NAME},
        {"lambert", "", 0.5, NDL_E_UNKNOWN_NAME},
        {"lambert", "0.", 0.5, NDL_E_UNKNOWN_NAME},
        {"lambert", "99999999999999999999999.color", 0.5, NDL_E_UNKNOWN_NAME},
        {"lambert", "color", 1.5, NDL_E_RANGE},
        {"lambert", "color.r", -0.5, NDL_E_RANGE},
        {"lambert", "color", (double)NAN, NDL_E_RANGE},
        {"phong", "exponent", (double)INFINITY, NDL_E_RANGE},
        {"phong", "exponent", 1e39, NDL_E_RANGE},
        {"phong", "exponent.r", 3, NDL_E_TYPE},
        {"phong", "variant", 1, NDL_E_TYPE},
        {"ggx", "preset", 1, NDL_E_TYPE},
        {"toon_diffuse", "ramp", 1, NDL_E_TYPE},
        {"ggx", "alpha", 5, NDL_E_RANGE},
        {"ggx(fresnel=conductor,k=3)", "f0", 0.5, NDL_E_CONFLICT},
        {"microfacet(ndf=blinn)", "alpha", 2, NDL_E_RANGE},
        {"microfacet(ndf=blinn)", "alpha_x", 0.5, NDL_E_CONFLICT},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        ndl_error err;
        ndl_material *m = parsed(rows[i].text);
        ndl_material *changed = ndl_material_with(m, rows[i].key, rows[i].value, &err);
        if (changed || err.code != rows[i].code)
            fail_msg("%s, %s = %g: status %d, want %d (%s)", rows[i].text, rows[i].key,
                     rows[i].value, err.code, rows[i].code, err.text);
        assert_int_equal(err.column, 0);
        assert_true(strlen(err.text) > 0);
        assert_null(ndl_material_with(m, rows[i].key, rows[i].value, NULL));
        ndl_material_free(m);
    }
}

/* A copy by number equals the text with that number, bit for bit. */
static void a_copy_is_the_material_of_its_text(void **state) {
    (void)state;
    const ndl_vec3 wi = {0, 0.6f, 0.8f}, wo = {0.1f, -0.5f, 0.86f};
    ndl_material *m = parsed("0.3*lambert + ggx(preset=gold,roughness=0.3,anisotropy=0.5)");
    for (int i = 0; i <= 50; i++) {
        ndl_material *changed = ndl_material_with(m, "1.roughness", i / 50.0, NULL);
        ndl_material *again = parsed(ndl_material_text(changed));
        ndl_rgb f = ndl_brdf(changed, wi, wo);
        ndl_rgb g = ndl_brdf(again, wi, wo);
        assert_memory_equal(&f, &g, sizeof f);
        ndl_material_free(changed);
        ndl_material_free(again);
    }
    ndl_material_free(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_changed_copy_prints_what_was_meant),
        cmocka_unit_test(what_cannot_be_changed_is_refused),
        cmocka_unit_test(a_copy_is_the_material_of_its_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
