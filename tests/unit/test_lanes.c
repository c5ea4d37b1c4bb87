/* SPDX-License-Identifier: Apache-2.0 */
/* Parameters per lane: pair i has, bit for bit, the value of ndl_material_with(m, key, values[i]),
   for every number key of every model and for tails of all lengths. */
#include "ndl_test.h"

#include <ndotl/ndotl.h>

enum { MOST = 600 };
static float wi[3][MOST], wo[3][MOST], out[3][MOST], values[2][MOST];
static uint32_t state = 12345;

static float uniform(float low, float high) {
    state = state * 1664525u + 1013904223u;
    return low + (high - low) * (float)(state >> 8) / 16777216.0f;
}

static void random_directions(void) {
    for (int i = 0; i < MOST; i++)
        for (int k = 0; k < 2; k++) {
            float z = uniform(-0.1f, 1.0f), phi = uniform(0.0f, 6.2831853f);
            float s = sqrtf(fmaxf(1.0f - z * z, 0.0f));
            float (*w)[MOST] = k ? wo : wi;
            w[0][i] = s * cosf(phi);
            w[1][i] = s * sinf(phi);
            w[2][i] = z;
        }
}

static void evaluate(const ndl_material *m, size_t lanes, const ndl_lanes *lane, size_t n,
                     int cosine) {
    ndl_vec3_n i = {wi[0], wi[1], wi[2]}, o = {wo[0], wo[1], wo[2]};
    ndl_rgb_n rgb = {out[0], out[1], out[2]};
    if (cosine) ndl_brdf_cos_lanes_n(m, lanes, lane, n, i, o, rgb);
    else ndl_brdf_lanes_n(m, lanes, lane, n, i, o, rgb);
}

static void expect_with(const ndl_material *m, size_t lanes, const ndl_lanes *lane, size_t n,
                        int cosine) {
    evaluate(m, lanes, lane, n, cosine);
    for (size_t i = 0; i < n; i++) {
        ndl_error err;
        const ndl_material *one = m;
        ndl_material *made[2] = {NULL, NULL};
        for (size_t k = 0; k < lanes; k++) {
            one = made[k] = ndl_material_with(one, lane[k].key, (double)lane[k].values[i], &err);
            if (!one) fail_msg("%s = %g: %s", lane[k].key, (double)lane[k].values[i], err.text);
        }
        ndl_vec3 a = {wi[0][i], wi[1][i], wi[2][i]}, b = {wo[0][i], wo[1][i], wo[2][i]};
        ndl_rgb f = cosine ? ndl_brdf_cos(one, a, b) : ndl_brdf(one, a, b);
        if (f.r != out[0][i] || f.g != out[1][i] || f.b != out[2][i])
            fail_msg("%s, lane %zu of %zu, %s = %g: %.9g %.9g %.9g, alone %.9g %.9g %.9g",
                     ndl_material_text(m), i, n, lane[0].key, (double)lane[0].values[i],
                     (double)out[0][i], (double)out[1][i], (double)out[2][i], (double)f.r,
                     (double)f.g, (double)f.b);
        for (size_t k = 0; k < lanes; k++) ndl_material_free(made[k]);
    }
}

static ndl_material *parse(const char *text) {
    ndl_error err;
    ndl_material *m = ndl_material_parse(text, &err);
    if (!m) fail_msg("%s: %s", text, err.text);
    return m;
}

static void every_number_of_every_model(void **unused) {
    (void)unused;
    for (size_t i = 0; i < ndl_model_count(); i++) {
        size_t count;
        const ndl_param *p = ndl_model_params(i, &count);
        ndl_material *m = parse(ndl_model_name(i));
        for (size_t k = 0; k < count; k++) {
            if (p[k].kind != NDL_KIND_NUMBER && p[k].kind != NDL_KIND_COLOR) continue;
            ndl_lanes lane = {p[k].key, values[0]};
            if (ndl_lanes_check(m, 1, &lane, NULL) != NDL_OK) continue;
            float high = (float)fmin(p[k].high, 50.0), low = (float)p[k].low;
            for (int l = 0; l < 100; l++) values[0][l] = uniform(low, high) + (high - low) * 1e-4f;
            for (int l = 0; l < 100; l++) values[0][l] = fminf(values[0][l], high);
            expect_with(m, 1, &lane, 100, (int)(k & 1));
        }
        ndl_material_free(m);
    }
}

static void spellings_follow_the_material(void **unused) {
    (void)unused;
    static const struct { const char *material, *key; float low, high; } cases[] = {
        {"ggx(roughness=0.5, anisotropy=0.6)", "roughness", 0.0f, 1.0f},
        {"ggx(roughness=0.5, anisotropy=0.6)", "anisotropy", 0.0f, 1.0f},
        {"ggx(alpha=0.2, anisotropy=0.5, anisotropy_kind=kulla)", "alpha", 0.0f, 4.0f},
        {"ggx(roughness=0.3, roughness_map=sqrt)", "roughness", 0.0f, 1.0f},
        {"ggx(roughness=0.3, roughness_map=direct, masking=schlick_direct)", "roughness", 0.0f,
         1.0f},
        {"ggx(alpha=0.3, masking=schlick_direct)", "alpha_x", 0.0f, 4.0f},
        {"ggx(preset=gold)", "eta.g", 0.1f, 4.0f},
        {"ggx(ior=1.5)", "ior", 1.0f, 3.0f},
        {"ggx(f0=[0.9, 0.6, 0.3])", "f0.b", 0.0f, 1.0f},
        {"microfacet(ndf=blinn, alpha=0.5)", "alpha", 0.0f, 1.0f},
        {"oren_nayar(a=0.7, variant=full)", "a", 0.51f, 1.0f},
        {"oren_nayar(sigma_deg=20)", "sigma_deg", 0.0f, 90.0f},
        {"oren_nayar(sigma=0.4, variant=table)", "sigma", 0.0f, 1.5f},
        {"ward(alpha_x=0.1, alpha_y=0.4, variant=duer)", "alpha_y", 0.0f, 4.0f},
        {"metal_rough(metalness=0.5)", "anisotropy", 0.0f, 1.0f},
        {"0.3*lambert + 0.7*ggx(roughness=0.4)", "1.roughness", 0.0f, 1.0f},
        {"0.3*lambert + 0.7*ggx(roughness=0.4)", "0.color.r", 0.0f, 1.0f},
        {"toon_specular(by=half, ramp=[0: 0, 0.9: [1, 0.5, 0], 0.9: 1])", NULL, 0.0f, 0.0f},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        ndl_material *m = parse(cases[c].material);
        ndl_lanes lane = {cases[c].key, values[0]};
        for (int l = 0; l < 100; l++) values[0][l] = uniform(cases[c].low, cases[c].high);
        expect_with(m, cases[c].key ? 1 : 0, &lane, 100, (int)(c & 1));
        ndl_material_free(m);
    }
}

static void two_lanes_and_every_tail(void **unused) {
    (void)unused;
    ndl_material *m = parse("ggx(preset=gold)");
    ndl_lanes lane[2] = {{"alpha_x", values[0]}, {"alpha_y", values[1]}};
    for (int l = 0; l < MOST; l++) values[0][l] = uniform(0.0f, 1.0f);
    for (int l = 0; l < MOST; l++) values[1][l] = uniform(0.0f, 1.0f);
    for (size_t n = 0; n < 40; n++) expect_with(m, 2, lane, n, 0);
    for (size_t n = 250; n < 260; n++) expect_with(m, 2, lane, n, 1);
    expect_with(m, 2, lane, MOST, 1);
    ndl_material_free(m);
}

static void values_outside_are_cut(void **unused) {
    (void)unused;
    ndl_material *m = parse("ggx");
    ndl_lanes lane = {"roughness", values[0]};
    static const float given[] = {-1.0f, NAN, 2.0f, INFINITY, -INFINITY};
    static const float meant[] = {0.0f, 0.0f, 1.0f, 1.0f, 0.0f};
    memcpy(values[0], given, sizeof given);
    evaluate(m, 1, &lane, 5, 0);
    float first[3][5];
    for (int c = 0; c < 3; c++) memcpy(first[c], out[c], sizeof first[c]);
    memcpy(values[0], meant, sizeof meant);
    evaluate(m, 1, &lane, 5, 0);
    for (int c = 0; c < 3; c++) assert_memory_equal(first[c], out[c], sizeof first[c]);
    ndl_material_free(m);
}

static void wrong_lanes_are_refused(void **unused) {
    (void)unused;
    ndl_material *m = parse("ggx(preset=gold)");
    ndl_error err;
    const ndl_lanes unknown = {"rough", values[0]}, unused_key = {"f0", values[0]};
    const ndl_lanes both[2] = {{"alpha", values[0]}, {"roughness", values[1]}};
    assert_int_equal(ndl_lanes_check(m, 1, &unknown, &err), NDL_E_UNKNOWN_NAME);
    assert_non_null(strstr(err.text, "rough"));
    assert_int_equal(ndl_lanes_check(m, 1, &unused_key, &err), NDL_E_CONFLICT);
    assert_int_equal(ndl_lanes_check(m, 2, both, &err), NDL_E_CONFLICT);
    out[0][0] = 7.0f;
    evaluate(m, 1, &unknown, 5, 0);
    assert_true(out[0][0] == 0.0f);
    ndl_material_free(m);
}

int main(void) {
    random_directions();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_of_every_model),
        cmocka_unit_test(spellings_follow_the_material),
        cmocka_unit_test(two_lanes_and_every_tail),
        cmocka_unit_test(values_outside_are_cut),
        cmocka_unit_test(wrong_lanes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
