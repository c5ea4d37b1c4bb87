/* SPDX-License-Identifier: Apache-2.0 */
/* Rows of the formula inventory (docs/formulas.md) that say more than a golden value can. The name
   of a test begins with the rows that it is evidence for. An argument selects tests by pattern. */
#include "values.h"

#include "shade/prelude_c.h"

#include "shade/math.h"

#include "core/schema.h"

#include "shade/blinn_phong.h"
#include "shade/metal_rough.h"
#include "shade/oren_nayar.h"
#include "shade/phong.h"
#include "shade/toon_specular.h"
#include "shade/ward.h"

static vec3 shading(ndl_vec3 w) {
    return v3(w.x, w.y, w.z);
}

/* ---- the microfacet documents ---------------------------------------------------------------- */

static void S1_1_the_squared_sine_keeps_its_digits_near_the_normal(void **state) {
    (void)state;
    for (double degrees = 0.001; degrees < 90.0; degrees *= 1.5) {
        double sine = sin(degrees * PI64 / 180.0);
        assert_relative(sin2_theta(shading(along_t(degrees))), sine * sine, 1e-6);
        assert_relative(sin2_theta(shading(along_b(degrees))), sine * sine, 1e-6);
    }
}

static void S1_15_S3_1_S4_44_alpha_is_the_width_itself_unless_roughness_is_given(void **state) {
    (void)state;
    assert_relative(brdf("ggx(alpha=0.25)", NORMAL, NORMAL),
                    brdf("ggx(roughness=0.5)", NORMAL, NORMAL), 1e-6);
    assert_relative(brdf("ggx(alpha=0.5)", NORMAL, NORMAL),
                    brdf("ggx(roughness=0.5, roughness_map=direct)", NORMAL, NORMAL), 1e-6);
    assert_relative(term("ggx", NDL_TERM_F, NORMAL, NORMAL), 0.04, 1e-6);
}

static void S2_7_S2_8_f0_is_mixed_by_metalness_not_by_roughness(void **state) {
    (void)state;
    const char *rough = "metal_rough(base_color=0.8, metalness=0, roughness=0.9)";
    assert_relative(term(rough, NDL_TERM_F, NORMAL, NORMAL), 0.04, 1e-6);
    const char *half = "metal_rough(base_color=0.8, metalness=0.5, roughness=0.9)";
    assert_relative(term(half, NDL_TERM_F, NORMAL, NORMAL), 0.42, 1e-6);
}

/* The integral of D(h) h.z over the hemisphere of h; weight 1, or 4 VoH up to 45 degrees: over the
   light's solid angle, for wo = n. */
static double normalisation(const char *text, int over_light) {
    enum { STEPS = 20000 };
    ndl_material *m = material(text);
    double last = over_light ? PI64 / 4.0 : PI64 / 2.0, sum = 0.0;
    for (int i = 0; i < STEPS; i++) {
        double theta = (i + 0.5) / STEPS;
        double step = 3.0 * last * theta * theta / STEPS; /* dense at the peak */
        theta = last * theta * theta * theta;
        ndl_vec3 h = unit(sin(theta), 0.0, cos(theta));
        double weight = over_light ? 4.0 * cos(theta) : 1.0;
        sum += (double)ndl_term(m, NDL_TERM_D, h, h).r * cos(theta) * sin(theta) * weight * step;
    }
    ndl_material_free(m);
    return 2.0 * PI64 * sum;
}

static void S3_2_S2_10_D_is_normalised_over_the_solid_angle_of_the_microfacets(void **state) {
    (void)state;
    const char *const text[] = {"ggx(alpha=0.1)",
                                "ggx(alpha=0.3)",
                                "ggx(alpha=0.6)",
                                "ggx(alpha=1)",
                                "beckmann(alpha=0.1)",
                                "beckmann(alpha=0.6)",
                                "beckmann(alpha=1)",
                                "microfacet(ndf=blinn, alpha=0.1)",
                                "microfacet(ndf=blinn, alpha=1)"};
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        assert_absolute(normalisation(text[i], 0), 1.0, 2e-5);
    assert_printed(normalisation("ggx(alpha=0.1)", 1), 3.898, 3);
    assert_printed(normalisation("ggx(alpha=0.3)", 1), 3.445, 3);
    assert_printed(normalisation("ggx(alpha=0.6)", 1), 2.624, 3);
}

static void S3_3_S2_12_the_peaks_of_all_distributions_are_equal(void **state) {
    (void)state;
    const char *const text[] = {"ggx(alpha=0.3)", "beckmann(alpha=0.3)",
                                "microfacet(ndf=blinn, alpha=0.3)"};
    for (int i = 0; i < 3; i++)
        assert_relative(term(text[i], NDL_TERM_D, NORMAL, NORMAL), 1.0 / (PI64 * 0.09), 1e-6);
}

static void S3_12_S1_8_masking_lets_through_what_the_viewer_sees(void **state) {
    (void)state;
    /* The Smith identity: the projected area of the visible microsurface is that of the surface. */
    enum { THETAS = 400, PHIS = 200 };
    const char *const text[] = {"ggx(masking=smith, alpha=0.5)",
                                "beckmann(masking=smith, alpha=0.5)"};
    for (int k = 0; k < 2; k++) {
        ndl_material *m = material(text[k]);
        double nov = 0.3, sum = 0.0, s = sqrt(1.0 - nov * nov);
        for (int i = 0; i < THETAS; i++) {
            double theta = PI64 / 2.0 * (i + 0.5) / THETAS, area = 0.0;
            ndl_vec3 h = unit(sin(theta), 0.0, cos(theta));
            for (int j = 0; j < PHIS; j++)
                area += fmax(0.0, cos(theta) * nov + sin(theta) * s * cos(2.0 * PI64 * j / PHIS));
            sum += (double)ndl_term(m, NDL_TERM_D, h, h).r * sin(theta) * area / PHIS;
        }
        ndl_material_free(m);
        assert_relative(nov / (sum * 2.0 * PI64 * PI64 / 2.0 / THETAS), g1(text[k], nov), 1e-4);
    }
}

/* ---- the lecture: light, view, mirror -------------------------------------------------------- */

static void S4_2_values_above_one_are_not_clamped(void **state) {
    (void)state;
    assert_printed(term("ggx(alpha=0.1)", NDL_TERM_D, NORMAL, NORMAL), 31.8, 1);
    assert_printed(brdf("ggx(alpha=0.01, f0=0.04)", NORMAL, NORMAL), 31.8, 1);
}

static void S4_7_every_model_of_the_list_is_registered(void **state) {
    (void)state;
    const char *const list[] = {"lambert",     "oren_nayar", "toon_diffuse", "phong",
                                "blinn_phong", "ward",       "microfacet",   "toon_specular"};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        assert_true(ndl_model_find(list[i]) >= 0);
        assert_true(brdf(list[i], along_t(-40.0), along_t(41.0)) > 0.0);
    }
}

static void S4_11_S4_15_S4_39_light_or_viewer_at_the_horizon_or_below_give_nothing(void **state) {
    (void)state;
    const ndl_vec3 up = along_t(30.0), side = {1.0f, 0.0f, 0.0f}, down = along_t(100.0);
    for (size_t i = 0; i < ndl_model_count(); i++) {
        const char *name = ndl_model_name(i);
        assert_true(brdf(name, up, up) > 0.0);
        double dark = brdf(name, down, up) + brdf(name, up, down) + brdf(name, down, down) +
                      brdf(name, side, up) + brdf(name, up, side) + scanline(name, down, up) +
                      brdf_cos(name, down, up) + brdf_cos(name, up, down);
        assert_true(dark == 0.0);
    }
}

static void S4_10_S4_12_S4_13_S4_14_the_lecture_has_the_cosine_inside_and_no_pi(void **state) {
    (void)state;
    assert_relative(scanline("lambert(color=0.7)", NORMAL, along_t(50.0)), 0.7, 1e-6);
    assert_relative(scanline("lambert(color=0.7)", along_t(60.0), NORMAL), 0.35, 1e-6);
    assert_relative(brdf_cos("lambert(color=0.7)", along_t(60.0), NORMAL), 0.35 / PI64, 1e-6);
}

static void S4_16_a_metal_has_no_diffuse_part_and_takes_its_colour(void **state) {
    (void)state;
    ndl_vec3 wi = along_t(-30.0), wo = along_t(45.0);
    assert_relative(brdf("metal_rough(base_color=0.6, metalness=1, roughness=0.4)", wi, wo),
                    brdf("ggx(f0=0.6, roughness=0.4)", wi, wo), 1e-6);
    assert_relative(brdf("ggx(f0=0.78, color=0.78, fresnel=none)", NORMAL, NORMAL),
                    0.78 * 0.78 * brdf("ggx(f0=1)", NORMAL, NORMAL), 1e-6); /* tints twice */
}

static void S4_17_S4_18_S4_19_S4_20_the_mirror_leaves_the_surface_as_the_light_does(void **state) {
    (void)state;
    ndl_vec3 r =
        ndl_reflect((ndl_vec3){0.6f, 0.0f, 0.8f}, NORMAL); /* printed order: (1.8, 0, .8) */
    assert_same_float(r.x, -0.6f);
    assert_same_float(r.y, 0.0f);
    assert_same_float(r.z, 0.8f);
    r = ndl_reflect((ndl_vec3){0.6f, 0.0f, -0.8f}, NORMAL);
    assert_same_float(r.z, -0.8f);
    for (int i = 0; i < 1000; i++) {
        ndl_vec3 w = unit(sin(3.0 * i), cos(7.0 * i), 0.01 + fabs(sin(1.0 * i)));
        ndl_vec3 n = unit(cos(5.0 * i), sin(11.0 * i), cos(13.0 * i));
        double nw =
            (double)n.x * (double)w.x + (double)n.y * (double)w.y + (double)n.z * (double)w.z;
        r = ndl_reflect(w, n);
        assert_absolute(r.x, 2.0 * nw * (double)n.x - (double)w.x, 1e-7);
        assert_absolute(r.y, 2.0 * nw * (double)n.y - (double)w.y, 1e-7);
        assert_absolute(r.z, 2.0 * nw * (double)n.z - (double)w.z, 1e-7);
        r = ndl_reflect(w, NORMAL);
        vec3 local = reflect_about_normal(shading(w));
        assert_same_float(local.x, r.x);
        assert_same_float(local.y, r.y);
        assert_same_float(local.z, r.z);
        assert_absolute(mirror_cosine(shading(w), shading(n)), v3_dot(local, shading(n)), 3e-7);
        /* the viewer in the mirror direction is in the middle of the highlight */
        assert_relative(brdf_cos("phong(exponent=200)", w, r), 1.0, 1e-4);
    }
}

static void S4_21_a_power_of_zero_is_one_even_of_zero(void **state) {
    (void)state;
    assert_same_float(phong_lobe(0.0f, v3(0.8f, 0.0f, 0.6f), v3(0.6f, 0.0f, 0.8f)), 1.0f);
    assert_relative(phong_lobe(2.0f, v3(0.0f, 0.0f, 1.0f), v3(0.6f, 0.0f, 0.8f)), 0.64, 1e-6);
}

static void S4_24_the_half_vector_is_half_as_far_off(void **state) {
    (void)state;
    assert_relative(convert("phong_exponent", 10.0, "blinn_exponent"), 40.0, 1e-6);
    assert_relative(convert("blinn_exponent", 40.0, "phong_exponent"), 10.0, 1e-6);
    ndl_vec3 wi = along_t(-30.0), wo = along_t(50.0); /* 20 degrees off the mirror */
    assert_printed(brdf_cos("phong(exponent=10)", wi, wo), 0.537, 3);
    assert_printed(brdf_cos("blinn_phong(exponent=40)", wi, wo), 0.542, 3);
    assert_printed(brdf_cos("blinn_phong(exponent=10)", wi, wo), 0.858, 3);
}

/* ---- the lecture: toon, Oren-Nayar, Ward, Cook-Torrance -------------------------------------- */

static void S4_26_S4_27_S4_28_toon_changes_colour_at_the_threshold_itself(void **state) {
    (void)state;
    ndl_vec3 wi = {0.8f, 0.0f, 0.6f};
    const char *cut = "toon_diffuse(color1=0.9, color2=0.1, threshold=0.6)";
    assert_relative(brdf_cos(cut, wi, NORMAL), 0.9, 1e-6);
    assert_relative(brdf(cut, wi, NORMAL), 1.5, 1e-6);
    wi.z = nextafterf(0.6f, 0.0f);
    assert_relative(brdf_cos(cut, wi, NORMAL), 0.1, 1e-6);
    assert_relative(brdf_cos("toon_diffuse(ramp=[0: 0, 1: 1])", along_t(60.0), NORMAL), 0.5, 1e-6);
    assert_relative(brdf_cos("toon_specular(color1=0.9, by=half, threshold=0.99)", along_t(30.0),
                             along_t(-30.0)),
                    0.9, 1e-6);
    assert_relative(brdf_cos("toon_specular(by=half, ramp=[0: 0, 1: 1])", NORMAL, along_t(60.0)),
                    sqrt(0.75), 1e-6);
    /* the cosine is not clamped: a threshold below 0 is reached beyond 90 degrees off the mirror */
    assert_relative(
        brdf_cos("toon_specular(color1=0.9, threshold=-0.3)", along_t(50.0), along_t(50.0)), 0.9,
        1e-6);
}

static void S4_31_sigma_zero_is_lambert(void **state) {
    (void)state;
    const char *const variants[] = {"oren_nayar(color=0.6, sigma=0)", "oren_nayar(color=0.6, a=1)",
                                    "oren_nayar(color=0.6, sigma=0, variant=full)"};
    for (int i = 0; i < 3; i++)
        assert_relative(brdf(variants[i], along_t(-70.0), along_t(60.0)), 0.6 / PI64, 1e-6);
}

static void S4_29_S4_32_the_table_holds_what_the_formula_says(void **state) {
    (void)state;
    double worst = 0.0, a = convert("sigma", 0.5, "a");
    assert_relative(a, 1.0 - 0.5 * 0.25 / 0.58, 1e-6);
    assert_relative(convert("a", a, "sigma"), 0.5, 1e-5);
    for (int i = 1; i < 90; i++)
        for (int j = 1; j < 90; j++) {
            ndl_vec3 wi = along_t(i), wo = along_t(j);
            double table = brdf_cos("oren_nayar(color=1, a=0.6, variant=table)", wi, wo);
            double exact = brdf_cos("oren_nayar(color=1, a=0.6)", wi, wo);
            worst = fmax(worst, fabs(table - exact));
        }
    assert_in_range(worst * 1e6, 0, 200);
    assert_relative(oren_nayar_sines(sqrtf(0.5f), sqrtf(0.2f)), sqrt(0.75) * 0.6, 1e-6);
}

static void S4_33_S4_30_oren_nayar_has_no_highlight(void **state) {
    (void)state;
    const char *rough = "oren_nayar(color=1, sigma=0.5)";
    double mirror = brdf(rough, along_t(-50.0), along_t(50.0));
    double aside = brdf(rough, along_t(-50.0), along_b(50.0));
    assert_relative(mirror, (1.0 - 0.5 * 0.25 / 0.58) / PI64, 1e-6);
    assert_relative(aside, mirror, 1e-6);
    assert_true(brdf(rough, along_t(50.0), along_t(50.0)) > 1.2 * mirror); /* towards the light */
}

static void S4_34_S4_35_highlights_stretch_across_the_grooves(void **state) {
    (void)state;
    /* grooves along t: alpha_x, of the tangent, is the smaller width */
    const char *d = "beckmann(alpha_x=0.05, alpha_y=0.5)";
    ndl_vec3 x = along_t(5.0), y = along_b(5.0);
    assert_true(term(d, NDL_TERM_D, y, y) > 10.0 * term(d, NDL_TERM_D, x, x));
    double tan2 = pow(tan(5.0 * PI64 / 180.0), 2.0), cos4 = pow(cos(5.0 * PI64 / 180.0), 4.0);
    double peak = 1.0 / (PI64 * 0.025 * cos4);
    assert_relative(term(d, NDL_TERM_D, x, x), peak * exp(-tan2 / 0.0025), 1e-5);
    assert_relative(term(d, NDL_TERM_D, y, y), peak * exp(-tan2 / 0.25), 1e-5);
}

static void S4_36_S4_37_S4_38_the_exponent_of_ward_is_negative(void **state) {
    (void)state;
    ndl_vec3 w = along_t(45.0);
    assert_relative(brdf_cos("ward(variant=ward92, alpha=0.3)", w, w),
                    exp(-1.0 / 0.09) / (4.0 * PI64 * 0.09), 1e-5);
}

static void S4_1_S4_42_S4_43_a_blend_is_a_weighted_sum(void **state) {
    (void)state;
    ndl_vec3 wi = along_t(-20.0), wo = along_t(50.0);
    const char *lobe = "beckmann(masking=cook_torrance, f0=0.9, alpha=0.2)";
    const char *sum =
        "0.3*lambert(color=0.8) + 0.7*beckmann(masking=cook_torrance, f0=0.9, alpha=0.2)";
    assert_relative(brdf(sum, wi, wo), 0.3 * 0.8 / PI64 + 0.7 * brdf(lobe, wi, wo), 1e-6);
    assert_relative(brdf_cos(sum, wi, wo),
                    0.3 * brdf_cos("lambert(color=0.8)", wi, wo) + 0.7 * brdf_cos(lobe, wi, wo),
                    1e-6);
    assert_relative(scanline(sum, wi, wo), 0.3 * 0.8 * (double)wi.z + 0.7 * brdf_cos(lobe, wi, wo),
                    1e-6);
}

static void S4_44_alpha_zero_acts_as_a_thousandth(void **state) {
    (void)state;
    const char *const zero[] = {"ggx(alpha=0)", "beckmann(alpha=0)", "ward(alpha=0)",
                                "ggx(roughness=0)", "microfacet(ndf=blinn, alpha=0)"};
    const char *const least[] = {"ggx(alpha=0.001)", "beckmann(alpha=0.001)", "ward(alpha=0.001)",
                                 "ggx(alpha=0.001)", "microfacet(ndf=blinn, alpha=0.001)"};
    ndl_vec3 w = along_t(0.02);
    for (int i = 0; i < 5; i++) {
        double f = brdf(zero[i], NORMAL, w);
        assert_true(f > 0.0 && f == brdf(least[i], NORMAL, w));
    }
    assert_relative(term("ggx(alpha=0)", NDL_TERM_D, NORMAL, NORMAL), 1e6 / PI64, 1e-6);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S1_1_the_squared_sine_keeps_its_digits_near_the_normal),
        cmocka_unit_test(S1_15_S3_1_S4_44_alpha_is_the_width_itself_unless_roughness_is_given),
        cmocka_unit_test(S2_7_S2_8_f0_is_mixed_by_metalness_not_by_roughness),
        cmocka_unit_test(S3_2_S2_10_D_is_normalised_over_the_solid_angle_of_the_microfacets),
        cmocka_unit_test(S3_3_S2_12_the_peaks_of_all_distributions_are_equal),
        cmocka_unit_test(S3_12_S1_8_masking_lets_through_what_the_viewer_sees),
        cmocka_unit_test(S4_2_values_above_one_are_not_clamped),
        cmocka_unit_test(S4_7_every_model_of_the_list_is_registered),
        cmocka_unit_test(S4_11_S4_15_S4_39_light_or_viewer_at_the_horizon_or_below_give_nothing),
        cmocka_unit_test(S4_10_S4_12_S4_13_S4_14_the_lecture_has_the_cosine_inside_and_no_pi),
        cmocka_unit_test(S4_16_a_metal_has_no_diffuse_part_and_takes_its_colour),
        cmocka_unit_test(S4_17_S4_18_S4_19_S4_20_the_mirror_leaves_the_surface_as_the_light_does),
        cmocka_unit_test(S4_21_a_power_of_zero_is_one_even_of_zero),
        cmocka_unit_test(S4_24_the_half_vector_is_half_as_far_off),
        cmocka_unit_test(S4_26_S4_27_S4_28_toon_changes_colour_at_the_threshold_itself),
        cmocka_unit_test(S4_31_sigma_zero_is_lambert),
        cmocka_unit_test(S4_29_S4_32_the_table_holds_what_the_formula_says),
        cmocka_unit_test(S4_33_S4_30_oren_nayar_has_no_highlight),
        cmocka_unit_test(S4_34_S4_35_highlights_stretch_across_the_grooves),
        cmocka_unit_test(S4_36_S4_37_S4_38_the_exponent_of_ward_is_negative),
        cmocka_unit_test(S4_1_S4_42_S4_43_a_blend_is_a_weighted_sum),
        cmocka_unit_test(S4_44_alpha_zero_acts_as_a_thousandth),
    };
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
