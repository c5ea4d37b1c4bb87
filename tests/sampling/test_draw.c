/* SPDX-License-Identifier: Apache-2.0 */
/* Draws bit by bit: scalar and batch, every instruction set, ndl_pdf, the weight; and the edges. */
#include "sampling.h"

#include <float.h>

static const char *const ISAS[] = {"scalar", "x86-64", "x86-64-v3", "x86-64-v4", "neon"};
static const float BELOW_ONE = 0x1.fffffep-1f;

static size_t materials(void) {
    return NARROW_COUNT + wide_count();
}

static const char *text_of(size_t i) {
    return i < NARROW_COUNT ? NARROW[i] : wide_text(i - NARROW_COUNT);
}

/* Viewers from the zenith to 1e-6 above the horizon, a few below; u with both ends. */
static void fill_edges(draws *d) {
    static const double cosines[] = {1.0, 0.9999, 0.7, 0.2, 1e-2, 1e-4, 1e-6, 0.0, -0.3};
    static const float ends[] = {0.0f, 0x1p-24f, 0.5f, BELOW_ONE};
    uint64_t state = 17;
    for (size_t i = 0; i < DRAWS; i++) {
        ndl_vec3 wo = viewer(cosines[i % 9], (double)uniform(&state));
        d->wo[0][i] = wo.x;
        d->wo[1][i] = wo.y;
        d->wo[2][i] = wo.z;
        for (int c = 0; c < 3; c++) {
            float u = uniform(&state);
            d->u[c][i] = uniform(&state) < 0.25f ? ends[(int)(4.0f * u)] : u;
        }
    }
}

static void assert_same_bits(const char *text, const char *what, const float *a, const float *b,
                             size_t n) {
    if (memcmp(a, b, n * sizeof *a) == 0) return;
    for (size_t i = 0; i < n; i++)
        if (memcmp(&a[i], &b[i], sizeof *a) != 0) {
            print_error("%s: %s of draw %zu is %.9g and %.9g\n", text, what, i, (double)a[i],
                        (double)b[i]);
            fail();
        }
}

static void assert_same_draws(const char *text, const char *what, const draws *a, const draws *b,
                              size_t n) {
    for (int c = 0; c < 3; c++) {
        assert_same_bits(text, what, a->wi[c], b->wi[c], n);
        assert_same_bits(text, what, a->rgb[c], b->rgb[c], n);
    }
    assert_same_bits(text, what, a->pdf, b->pdf, n);
}

static void every_instruction_set_draws_the_same_bits(void **state) {
    static draws a, b;
    (void)state;
    fill_edges(&a);
    b = a;
    for (size_t i = 0; i < materials(); i++) {
        ndl_use_isa("scalar");
        ndl_material *m = material(text_of(i));
        draw_batch(m, DRAWS, &a);
        for (size_t k = 1; k < sizeof ISAS / sizeof *ISAS; k++) {
            if (ndl_use_isa(ISAS[k]) != NDL_OK) continue;
            ndl_material *same = material(text_of(i));
            draw_batch(same, DRAWS, &b);
            assert_same_draws(text_of(i), ISAS[k], &a, &b, DRAWS);
            ndl_material_free(same);
        }
        ndl_material_free(m);
    }
    ndl_use_isa(NULL);
}

static void batches_have_the_bits_of_single_draws(void **state) {
    enum { SOME = 300 };
    static draws a, b;
    (void)state;
    fill_edges(&a);
    for (size_t i = 0; i < materials(); i++) {
        ndl_material *m = material(text_of(i));
        draw_batch(m, SOME, &a);
        b = a;
        for (size_t k = 0; k < SOME; k++) {
            ndl_sample s = ndl_draw(m, (ndl_vec3){a.wo[0][k], a.wo[1][k], a.wo[2][k]},
                                    (ndl_vec3){a.u[0][k], a.u[1][k], a.u[2][k]});
            b.wi[0][k] = s.wi.x;
            b.wi[1][k] = s.wi.y;
            b.wi[2][k] = s.wi.z;
            b.rgb[0][k] = s.weight.r;
            b.rgb[1][k] = s.weight.g;
            b.rgb[2][k] = s.weight.b;
            b.pdf[k] = s.pdf;
        }
        assert_same_draws(text_of(i), "a single draw", &a, &b, SOME);
        ndl_material_free(m);
    }
}

static void the_density_is_that_of_pdf_and_the_weight_its_quotient(void **state) {
    static draws d;
    static float pdf[DRAWS], both_pdf[DRAWS], f[3][DRAWS], g[3][DRAWS], weight[3][DRAWS];
    (void)state;
    fill_edges(&d);
    for (size_t i = 0; i < materials(); i++) {
        ndl_material *m = material(text_of(i));
        draw_batch(m, DRAWS, &d);
        ndl_vec3_n wi = {d.wi[0], d.wi[1], d.wi[2]}, wo = {d.wo[0], d.wo[1], d.wo[2]};
        ndl_pdf_n(m, DRAWS - 1, wi, wo, pdf);
        pdf[DRAWS - 1] = ndl_pdf(m, (ndl_vec3){wi.x[DRAWS - 1], wi.y[DRAWS - 1], wi.z[DRAWS - 1]},
                                 (ndl_vec3){wo.x[DRAWS - 1], wo.y[DRAWS - 1], wo.z[DRAWS - 1]});
        assert_same_bits(text_of(i), "pdf", d.pdf, pdf, DRAWS);
        ndl_brdf_cos_n(m, DRAWS, wi, wo, (ndl_rgb_n){f[0], f[1], f[2]});
        ndl_brdf_cos_pdf_n(m, DRAWS, wi, wo, (ndl_rgb_n){g[0], g[1], g[2]}, both_pdf);
        assert_same_bits(text_of(i), "pdf", pdf, both_pdf, DRAWS);
        for (int c = 0; c < 3; c++) {
            for (size_t k = 0; k < DRAWS; k++)
                weight[c][k] = pdf[k] > 0.0f ? fminf(f[c][k] / pdf[k], FLT_MAX) : 0.0f;
            assert_same_bits(text_of(i), "f cos", f[c], g[c], DRAWS);
            assert_same_bits(text_of(i), "weight", weight[c], d.rgb[c], DRAWS);
        }
        ndl_material_free(m);
    }
}

static void check_draw(const char *text, const draws *d, size_t k, double *longest) {
    double x = (double)d->wi[0][k], y = (double)d->wi[1][k], z = (double)d->wi[2][k];
    double length = sqrt(x * x + y * y + z * z);
    bool seen = d->wo[2][k] > 0.0f, good = d->pdf[k] >= 0.0f && d->pdf[k] <= FLT_MAX;
    for (int c = 0; c < 3; c++)
        good &= d->rgb[c][k] >= 0.0f && d->rgb[c][k] <= FLT_MAX;
    if (d->pdf[k] > 0.0f) {
        good &= seen && z > 0.0 && fabs(length - 1.0) <= 1e-6;
        *longest = fmax(*longest, fabs(length - 1.0));
    } else {
        good &= d->rgb[0][k] == 0.0f && d->rgb[1][k] == 0.0f && d->rgb[2][k] == 0.0f;
        good &= seen ? length <= 1.0 + 1e-6 : length == 0.0;
    }
    if (good) return;
    print_error("%s: wo %.9g %.9g %.9g, u %.9g %.9g %.9g gives wi %.9g %.9g %.9g, weight %.9g %.9g "
                "%.9g, pdf %.9g\n",
                text, (double)d->wo[0][k], (double)d->wo[1][k], (double)d->wo[2][k],
                (double)d->u[0][k], (double)d->u[1][k], (double)d->u[2][k], x, y, z,
                (double)d->rgb[0][k], (double)d->rgb[1][k], (double)d->rgb[2][k],
                (double)d->pdf[k]);
    fail();
}

static void every_draw_is_finite_unit_and_above_the_horizon_or_no_sample(void **state) {
    static draws d;
    double longest = 0.0;
    (void)state;
    fill_edges(&d);
    for (size_t i = 0; i < materials(); i++) {
        ndl_material *m = material(text_of(i));
        draw_batch(m, DRAWS, &d);
        for (size_t k = 0; k < DRAWS; k++)
            check_draw(text_of(i), &d, k, &longest);
        ndl_material_free(m);
    }
    print_message("length of wi within %.2g of 1\n", longest);
}

/* The weight of the bounded Ward is color 2 NoL/(NoL + NoV). */
static void the_weight_of_the_bounded_ward_is_bounded(void **state) {
    static draws d;
    ndl_material *m = material("ward(alpha_x=0.05, alpha_y=2)");
    (void)state;
    fill_edges(&d);
    draw_batch(m, DRAWS, &d);
    for (size_t k = 0; k < DRAWS; k++) {
        double i = (double)d.wi[2][k], o = (double)d.wo[2][k];
        if (!(d.pdf[k] > 0.0f) || d.pdf[k] < 1e-20f || o < 0.01) continue;
        assert_true(fabs((double)d.rgb[0][k] - 2.0 * i / (i + o)) < 1e-4);
    }
    ndl_material_free(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_instruction_set_draws_the_same_bits),
        cmocka_unit_test(batches_have_the_bits_of_single_draws),
        cmocka_unit_test(the_density_is_that_of_pdf_and_the_weight_its_quotient),
        cmocka_unit_test(every_draw_is_finite_unit_and_above_the_horizon_or_no_sample),
        cmocka_unit_test(the_weight_of_the_bounded_ward_is_bounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
