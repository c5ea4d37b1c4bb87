/* SPDX-License-Identifier: Apache-2.0 */
/* The numbers that the formula inventory, the manuals and docs/models quote, to the digits in
   which they are printed. The albedo tables are in tests/golden/albedo.csv. */
#include "values.h"

/* "name(masking=..., alpha=a, F = 1)"; the text is good until the next call. */
static const char *rough(const char *name, const char *keys, double alpha) {
    static char text[160];
    snprintf(text, sizeof text, "%s(%s, alpha=%.9g" F1, name, keys, alpha);
    return text;
}

/* ---- distributions --------------------------------------------------------------------------- */

static void S2_11_S3_1_a_roughness_of_one_half_has_two_peaks(void **state) {
    (void)state;
    const char *direct = "ggx(roughness=0.5, roughness_map=direct)";
    assert_printed(term(direct, NDL_TERM_D, NORMAL, NORMAL), 1.273, 3);
    assert_printed(term("ggx(roughness=0.5)", NDL_TERM_D, NORMAL, NORMAL), 5.093, 3);
}

static double density(const char *text, double tangent) {
    ndl_vec3 h = unit(tangent, 0.0, 1.0);
    return term(text, NDL_TERM_D, h, h);
}

static void S2_12_ggx_is_narrower_than_beckmann_and_has_the_longer_tail(void **state) {
    (void)state;
    const char *ggx = "ggx(alpha=0.01)", *beckmann = "beckmann(alpha=0.01)";
    double peak = density(ggx, 0.0);
    assert_printed(density("ggx(alpha=0.3)", 0.0), 3.5368, 4);
    assert_printed(density("beckmann(alpha=0.3)", 0.0), 3.5368, 4);
    assert_absolute(density(ggx, 0.006436) / peak, 0.5, 2e-4);
    assert_absolute(density(beckmann, 0.008326) / peak, 0.5, 2e-4);
    assert_true(density(ggx, 0.01584) < density(beckmann, 0.01584));
    assert_true(density(ggx, 0.01586) > density(beckmann, 0.01586));
}

static void S4_46_alpha_is_the_rms_slope_and_the_mean_is_less(void **state) {
    (void)state;
    enum { STEPS = 20000 };
    double mean = 0.0, square = 0.0, step = PI64 / 2.0 / STEPS;
    for (int i = 0; i < STEPS; i++) {
        double theta = (i + 0.5) * step, tangent = tan(theta);
        double share = density("beckmann(alpha=0.5)", tangent) * cos(theta) * sin(theta);
        mean += 2.0 * PI64 * share * tangent * step;
        square += 2.0 * PI64 * share * tangent * tangent * step;
    }
    assert_printed(mean / 0.5, 0.886, 3);
    assert_absolute(sqrt(square), 0.5, 1e-4);
}

/* ---- masking --------------------------------------------------------------------------------- */

static double largest_gap(const char *one, const char *other, ndl_vec3 wo) {
    ndl_material *a = material(one), *b = material(other);
    double largest = 0.0;
    for (int i = 1; i <= 500; i++) {
        ndl_vec3 wi = at_cosine(i / 500.0, -1), to = wo.z > 0.0f ? wo : wi;
        double g = (double)ndl_term(a, NDL_TERM_G, wi, to).r;
        largest = fmax(largest, fabs(g - (double)ndl_term(b, NDL_TERM_G, wi, to).r));
    }
    ndl_material_free(a);
    ndl_material_free(b);
    return largest;
}

static void S1_9_S3_12_correlated_and_separable_smith_differ(void **state) {
    (void)state;
    double largest = 0.0;
    for (double alpha = 0.05; alpha <= 1.0; alpha += 0.05) {
        char one[80], other[80];
        snprintf(one, sizeof one, "ggx(masking=smith, alpha=%g)", alpha);
        snprintf(other, sizeof other, "ggx(alpha=%g)", alpha);
        for (int i = 1; i <= 50; i++)
            largest = fmax(largest, largest_gap(one, other, at_cosine(i / 50.0, 1)));
    }
    assert_printed(largest, 0.090, 3);
    ndl_vec3 w = at_cosine(0.01, 1);
    double ratio = term("ggx(alpha=0.5)", NDL_TERM_V, w, w) /
                   term("ggx(masking=smith, alpha=0.5)", NDL_TERM_V, w, w);
    assert_printed(ratio, 13.0, 0);
}

static void S1_8_S1_11_the_worked_example_of_lambda(void **state) {
    (void)state;
    const char *smith = "ggx(masking=smith, alpha=0.3)";
    assert_printed(1.0 / g1(smith, 0.5) - 1.0, 0.0635, 4);
    assert_printed(1.0 / g1(smith, 0.8) - 1.0, 0.0125, 4);
    assert_printed(term("ggx(alpha=0.3)", NDL_TERM_G, at_cosine(0.5, -1), at_cosine(0.8, 1)), 0.929,
                   3);
}

static void S3_21_the_largest_values_of_the_hlsl_product(void **state) {
    (void)state;
    ndl_vec3 wi = at_cosine(1e-7, -1), wo = at_cosine(0.5, 1);
    assert_printed(term("ggx(masking=smith, alpha=0.1)", NDL_TERM_V, wi, wo), 9.9, 1);
    assert_printed(term("ggx(masking=smith, alpha=0.01)", NDL_TERM_V, wi, wo), 100.0, 0);
}

static void S3_13_walters_fit_is_within_a_third_of_a_percent(void **state) {
    (void)state;
    double largest = 0.0;
    for (double c = 0.01; c < 4.0; c += 0.01) {
        double cosine = c / sqrt(1.0 + c * c); /* alpha 1 */
        double exact = g1("beckmann(masking=smith, alpha=1)", cosine);
        double fit = g1("beckmann(masking=smith_walter, alpha=1)", cosine);
        largest = fmax(largest, fabs(fit / exact - 1.0));
        assert_true(fit <= 1.0);
    }
    assert_printed(100.0 * largest, 0.313, 3);
    assert_printed(g1("beckmann(masking=smith, alpha=1)", 1.6 / sqrt(1.0 + 2.56)), 0.9982, 4);
}

/* Smith's G1 of the distribution itself: NoV over the projected area of what faces the viewer. */
static double smith_of_ndf(const ndl_material *m, double nov) {
    enum { STEPS = 4000 };
    double sum = 0.0, s = sqrt(1.0 - nov * nov);
    for (int i = 0; i < STEPS; i++) {
        double t = (i + 0.5) / STEPS, theta = PI64 / 2.0 * t * t;
        double a = cos(theta) * nov, b = sin(theta) * s;
        double turn = a >= b ? PI64 : acos(-a / b);
        ndl_vec3 h = unit(sin(theta), 0.0, cos(theta));
        double facing = 2.0 * (a * turn + (a >= b ? 0.0 : b * sin(turn)));
        sum += (double)ndl_term(m, NDL_TERM_D, h, h).r * facing * sin(theta) * PI64 * t / STEPS;
    }
    return nov / sum;
}

static void S3_14_beckmanns_masking_is_not_blinns(void **state) {
    (void)state;
    static const struct {
        double alpha, error;
        int digits;
    } rows[] = {
        {0.1, 0.0015, 4}, {0.3, 0.014, 3}, {0.5, 0.040, 3}, {0.8, 0.119, 3}, {1.0, 0.219, 3},
    };
    for (int i = 0; i < 5; i++) {
        ndl_material *m = material(rough("microfacet", "ndf=blinn, masking=smith", rows[i].alpha));
        double largest = 0.0;
        for (int k = 1; k < 100; k++) {
            ndl_vec3 wo = at_cosine(k / 100.0, 1);
            double taken = (double)ndl_term(m, NDL_TERM_G, NORMAL, wo).r;
            largest = fmax(largest, fabs(taken - smith_of_ndf(m, k / 100.0)));
        }
        ndl_material_free(m);
        assert_printed(largest, rows[i].error, rows[i].digits);
    }
}

static void S2_16_S3_16_S3_17_schlicks_forms_are_far_off(void **state) {
    (void)state;
    assert_printed(g1("ggx(masking=schlick_direct, roughness=0)", 0.1), 0.47, 2);
    assert_printed(g1("ggx(masking=schlick_beckmann, alpha=1)", 1e-5) / 1e-5, 1.2533, 4);
    assert_printed(g1("beckmann(masking=smith, alpha=1)", 1e-5) / 1e-5, 3.5449, 3);
    static const struct {
        const char *one, *other;
        double gap;
        int digits;
    } rows[] = {
        {"beckmann(masking=schlick_beckmann, alpha=0.1)", "beckmann(masking=smith, alpha=0.1)", .44,
         2},
        {"beckmann(masking=schlick_beckmann, alpha=1)", "beckmann(masking=smith, alpha=1)", .34, 2},
        {"ggx(masking=schlick_ggx, alpha=0.01)", "ggx(masking=smith, alpha=0.01)", .161, 3},
        {"ggx(masking=schlick_ggx, alpha=0.25)", "ggx(masking=smith, alpha=0.25)", .109, 3},
        {"ggx(masking=schlick_ggx, alpha=0.5)", "ggx(masking=smith, alpha=0.5)", .066, 3},
        {"ggx(masking=schlick_ggx, alpha=1)", "ggx(masking=smith, alpha=1)", 0.0, 6},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_absolute(largest_gap(rows[i].one, rows[i].other, NORMAL), rows[i].gap,
                        1.1 * pow(10.0, -rows[i].digits));
}

/* ---- Fresnel --------------------------------------------------------------------------------- */

static double largest_difference(const char *one, const char *other) {
    double largest = 0.0;
    for (int i = 1; i <= 500; i++)
        largest = fmax(largest, fabs(fresnel(one, i / 500.0) - fresnel(other, i / 500.0)));
    return largest;
}

static void S2_5_S3_20_indices_and_reflectances(void **state) {
    (void)state;
    assert_relative(convert("ior", 1.5, "f0"), 0.04, 1e-6);
    assert_relative(convert("f0", 0.04, "ior"), 1.5, 1e-6);
    assert_printed(largest_difference("ggx(fresnel=cook_torrance, f0=0.04)", "ggx(f0=0.04)"), 0.036,
                   3);
    double off =
        fresnel("ggx(fresnel=cook_torrance, f0=0.04)", 0.09) - fresnel("ggx(f0=0.04)", 0.09);
    assert_printed(fabs(off), 0.036, 3);
    assert_printed(largest_difference("ggx(fresnel=cook_torrance, f0=0.95)", "ggx(f0=0.95)"), 0.50,
                   2);
}

static void S2_6_S4_50_real_metals_dip_before_they_rise(void **state) {
    (void)state;
    const char *aluminium = "ggx(eta=1.49, k=7.82)"; /* at 650 nm */
    assert_printed(fresnel(aluminium, 1.0), 0.9115, 4);
    double least = 1.0, where = 0.0;
    for (int i = 1; i <= 500; i++) {
        double f = fresnel(aluminium, i / 500.0);
        where = f < least ? i / 500.0 : where;
        least = fmin(least, f);
    }
    assert_absolute(least, 0.834, 1e-3);
    assert_printed(where, 0.13, 2);
    assert_absolute(largest_difference(aluminium, "ggx(f0=0.9115)"), 0.124, 1e-3);
    /* chromium and copper at 650 nm, interpolated in their spectra */
    assert_absolute(largest_difference("ggx(eta=3.107, k=3.331)", "ggx(f0=0.5556)"), 0.194, 1e-3);
    assert_absolute(largest_difference("ggx(eta=0.2378, k=3.626)", "ggx(f0=0.9352)"), 0.0245, 1e-3);
}

/* ---- the lecture's models -------------------------------------------------------------------- */

static void S4_22_S4_25_phong_and_blinn_reflect_what_they_like(void **state) {
    (void)state;
    assert_printed(albedo("phong(exponent=1)", 1.0), 3.1416, 4);
    assert_printed(albedo("phong(exponent=5)", 1.0), 1.047, 3);
    assert_printed(albedo("phong(exponent=10)", 1.0), 0.571, 3);
    assert_printed(albedo("phong(exponent=100)", 1.0), 0.0622, 4);
    assert_true(albedo("phong(exponent=5.28)", 1.0) > 1.0 &&
                albedo("phong(exponent=5.29)", 1.0) < 1.0);
    assert_printed(albedo("blinn_phong(exponent=1)", 1.0), 5.416, 3);
    assert_printed(albedo("blinn_phong(exponent=10)", 1.0), 2.062, 3);
    assert_printed(albedo("blinn_phong(exponent=100)", 1.0), 0.246, 3);
    ndl_vec3 low = at_cosine(0.2, -1), high = at_cosine(0.8, 1);
    assert_printed(brdf("phong(exponent=5)", low, high), 1.170, 3);
    assert_printed(brdf("phong(exponent=5)", high, low), 0.292, 3);
}

static void S4_29_a_sigma_of_20_is_in_degrees(void **state) {
    (void)state;
    assert_printed(convert("sigma", 20.0, "a"), 0.5004, 4);
    assert_printed(convert("sigma_deg", 20.0, "a"), 0.8652, 4);
    const char *text = "oren_nayar(color=1, sigma_deg=20)";
    double flat = brdf(text, along_t(-45.0), along_t(45.0)); /* A/pi */
    double back = brdf(text, along_t(45.0), along_t(45.0));  /* (A + B sin tan)/pi */
    assert_printed((back - flat) * PI64 / sqrt(0.5), 0.2588, 4);
}

static void S4_29_oren_nayar_gains_a_little_at_the_horizon(void **state) {
    (void)state;
    double s2 = 0.09, a = 1.0 - 0.5 * s2 / (s2 + 0.33), b = 0.45 * s2 / (s2 + 0.09);
    for (double c = 0.1; c < 1.0; c += 0.2) {
        double t = acos(c), s = sin(t), third = tan(t) * (1.0 - s * s * s) / 3.0;
        double exact = a + 2.0 * b / PI64 * (s * (t - s * c) / 2.0 + third);
        assert_absolute(albedo("oren_nayar(color=1, sigma=0.3)", c), exact, 2e-5);
    }
    assert_absolute(albedo("oren_nayar(color=1, sigma=0.199)", 1e-5), 1.0152, 2e-4);
    assert_absolute(albedo("oren_nayar(color=1, sigma=0.289, variant=qualitative57)", 1e-5), 1.0444,
                    2e-4);
    double largest = 0.0;
    for (double sigma = 0.1; sigma < 0.5; sigma += 0.02) {
        char text[80];
        snprintf(text, sizeof text, "oren_nayar(color=1, sigma=%g, variant=full)", sigma);
        largest = fmax(largest, albedo(text, 1e-4));
    }
    assert_printed(largest, 1.051, 3);
}

static void S4_32_the_lectures_table_is_unbounded(void **state) {
    (void)state;
    ndl_vec3 w = at_cosine(0.001, 1);
    double f = PI64 * brdf("oren_nayar(color=1, sigma=0.5)", w, w) - convert("sigma", 0.5, "a");
    assert_printed(f, 331.0, 0);
}

static void S4_34_S4_38_ward_across_and_along_the_grooves(void **state) {
    (void)state;
    const char *brushed = "ward(variant=ward92, alpha_x=0.05, alpha_y=0.5)";
    assert_printed(brdf(brushed, along_t(10.0), NORMAL), 0.15, 2);
    assert_printed(brdf(brushed, along_b(10.0), NORMAL), 3.11, 2);
}

static void S4_42_a_blend_without_pi_is_too_bright(void **state) {
    (void)state;
    const char *text = "0.5*lambert(color=1) + 0.5*beckmann(masking=cook_torrance, alpha=0.3" F1;
    double e = albedo(text, 0.8);
    assert_printed(e, 0.986, 3);
    assert_printed(e + 0.5 * (PI64 - 1.0), 2.057, 3);
}

/* ---- energy ---------------------------------------------------------------------------------- */

static void S2_14_S2_19_albedos_in_closed_form_and_of_the_documents(void **state) {
    (void)state;
    for (double c = 0.01; c <= 1.0; c += 0.33) {
        assert_absolute(albedo("ggx(alpha=1" F1, c), 1.0 - c * log(1.0 + 1.0 / c), 2e-5);
        assert_relative(albedo("ggx(alpha=1, masking=none" F1, c), 0.5 / c, 2e-5);
    }
    static const double want[3][3] = {{.652, .582, .620}, {.860, .585, .360}, {.916, .857, .892}};
    const char *const models[] = {
        "ggx(roughness=0.5, roughness_map=direct, masking=schlick_direct" F1,
        "ggx(roughness=0.5, masking=schlick_direct" F1, "ggx(roughness=0.5" F1};
    for (int i = 0; i < 3; i++) {
        assert_printed(albedo(models[i], 1.0), want[i][0], 3);
        assert_printed(albedo(models[i], 0.5), want[i][1], 3);
        assert_printed(albedo(models[i], 0.1), want[i][2], 3);
    }
}

static void S3_9_neumann_gains_energy_on_very_wide_lobes(void **state) {
    (void)state;
    assert_printed(albedo(rough("ggx", "masking=neumann", 4.0), 1e-5), 2.00, 2);
    assert_printed(albedo(rough("ggx", "masking=neumann", 3.0), 1e-5), 1.50, 2);
    assert_printed(albedo(rough("beckmann", "masking=neumann", 4.0), 0.03), 1.14, 2);
    assert_true(albedo(rough("beckmann", "masking=neumann", 3.5), 0.03) <= 1.0);
}

static void S3_13_walters_masking_gains_energy_with_ggx(void **state) {
    (void)state;
    assert_printed(albedo(rough("ggx", "masking=smith_walter", 0.03), 1e-5), 1.74, 2);
    assert_printed(albedo(rough("ggx", "masking=smith_walter", 1.0), 1e-4), 1.34, 2);
}

static void S3_14_beckmanns_masking_gains_energy_with_blinn(void **state) {
    (void)state;
    const char *const masking[] = {"ndf=blinn, masking=smith",
                                   "ndf=blinn, masking=smith_correlated",
                                   "ndf=blinn, masking=smith_walter"};
    static const double low[] = {1.32, 1.69, 1.32}, horizon[] = {1.34, 1.77, 1.34};
    for (int i = 0; i < 3; i++) {
        assert_printed(albedo(rough("microfacet", masking[i], 1.0), 0.01), low[i], 2);
        assert_printed(albedo(rough("microfacet", masking[i], 1.0), 1e-5), horizon[i], 2);
    }
}

static void S4_40_ward_1992_gains_energy_in_the_last_degree(void **state) {
    (void)state;
    assert_printed(albedo("ward(variant=ward92, alpha=0.5)", 0.003), 1.14, 2);
    assert_printed(albedo("ward(variant=ward92, alpha=0.5)", 0.001), 1.95, 2);
    assert_printed(albedo("ward(variant=ward92, alpha=0.5)", 1e-4), 6.16, 2);
}

static void S2_1_metal_rough_gains_energy(void **state) {
    (void)state;
    static const double rows[][3] = {{0.3, 0.1, 1.28},  {0.1, 1e-4, 1.78}, {0.3, 1e-4, 1.38},
                                     {0.5, 1e-4, 1.16}, {1.0, 1e-4, 1.02}, {0.0, 1e-5, 1.90}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[80];
        snprintf(text, sizeof text, "metal_rough(base_color=1, roughness=%g)", rows[i][0]);
        assert_printed(albedo(text, rows[i][1]), rows[i][2], 2);
    }
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S2_11_S3_1_a_roughness_of_one_half_has_two_peaks),
        cmocka_unit_test(S2_12_ggx_is_narrower_than_beckmann_and_has_the_longer_tail),
        cmocka_unit_test(S4_46_alpha_is_the_rms_slope_and_the_mean_is_less),
        cmocka_unit_test(S1_9_S3_12_correlated_and_separable_smith_differ),
        cmocka_unit_test(S1_8_S1_11_the_worked_example_of_lambda),
        cmocka_unit_test(S3_21_the_largest_values_of_the_hlsl_product),
        cmocka_unit_test(S3_13_walters_fit_is_within_a_third_of_a_percent),
        cmocka_unit_test(S3_14_beckmanns_masking_is_not_blinns),
        cmocka_unit_test(S2_16_S3_16_S3_17_schlicks_forms_are_far_off),
        cmocka_unit_test(S2_5_S3_20_indices_and_reflectances),
        cmocka_unit_test(S2_6_S4_50_real_metals_dip_before_they_rise),
        cmocka_unit_test(S4_22_S4_25_phong_and_blinn_reflect_what_they_like),
        cmocka_unit_test(S4_29_a_sigma_of_20_is_in_degrees),
        cmocka_unit_test(S4_29_oren_nayar_gains_a_little_at_the_horizon),
        cmocka_unit_test(S4_32_the_lectures_table_is_unbounded),
        cmocka_unit_test(S4_34_S4_38_ward_across_and_along_the_grooves),
        cmocka_unit_test(S4_42_a_blend_without_pi_is_too_bright),
        cmocka_unit_test(S2_14_S2_19_albedos_in_closed_form_and_of_the_documents),
        cmocka_unit_test(S3_9_neumann_gains_energy_on_very_wide_lobes),
        cmocka_unit_test(S3_13_walters_masking_gains_energy_with_ggx),
        cmocka_unit_test(S3_14_beckmanns_masking_gains_energy_with_blinn),
        cmocka_unit_test(S4_40_ward_1992_gains_energy_in_the_last_degree),
        cmocka_unit_test(S2_1_metal_rough_gains_energy),
    };
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
