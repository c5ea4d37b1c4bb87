/* SPDX-License-Identifier: Apache-2.0 */
/* What the spellings of a width mean: alpha_x and alpha_y as the kernels get them. */
#include "ndl_test.h"

#include "core/material.h"
#include "core/models.h"

static microfacet_p fields_of(const char *text) {
    ndl_error err;
    ndl_material *m = ndl_material_parse(text, &err);
    if (!m) fail_msg("%s: column %d: %s", text, err.column, err.text);
    microfacet_p p;
    memcpy(&p, m->lobes[0].fields, sizeof p);
    ndl_material_free(m);
    return p;
}

static void expect_widths(const char *text, double x, double y) {
    microfacet_p p = fields_of(text);
    if (!is_close((double)p.alpha_x, x, 2e-7, 0.0) || !is_close((double)p.alpha_y, y, 2e-7, 0.0))
        fail_msg("%s: %.9g %.9g, want %.9g %.9g", text, (double)p.alpha_x, (double)p.alpha_y, x, y);
}

static void widths_without_stretch(void **state) {
    (void)state;
    expect_widths("ggx", 0.3, 0.3);
    expect_widths("ggx(alpha=0.2)", 0.2, 0.2);
    expect_widths("ggx(alpha_x=0.2)", 0.2, 0.3); /* the other keeps its default */
    expect_widths("ggx(alpha_y=0.2)", 0.3, 0.2);
    expect_widths("ggx(alpha_x=0.1,alpha_y=4)", 0.1, 4.0);
    expect_widths("ggx(roughness=0.5)", 0.25, 0.25);
    expect_widths("ggx(roughness=0.5,roughness_map=square)", 0.25, 0.25);
    expect_widths("ggx(roughness=0.5,roughness_map=direct)", 0.5, 0.5);
    expect_widths("ggx(roughness=0.5,roughness_map=sqrt)", sqrt(0.5), sqrt(0.5));
    expect_widths("microfacet(ndf=blinn,alpha=1)", 1.0, 1.0);
}

static void kinds_of_anisotropy(void **state) {
    (void)state;
    double s = sqrt(1.0 - 0.9 * 0.5), o = sqrt(2.0 / (1.0 + 0.25));
    expect_widths("ggx(alpha=0.2,anisotropy=0.5)", 0.2 / s, 0.2 * s);
    expect_widths("ggx(alpha=0.2,anisotropy=0.5,anisotropy_kind=burley)", 0.2 / s, 0.2 * s);
    expect_widths("ggx(alpha=0.2,anisotropy=0.5,anisotropy_kind=kulla)", 0.3, 0.1);
    expect_widths("ggx(alpha=0.2,anisotropy=0.5,anisotropy_kind=openpbr)", 0.2 * o, 0.1 * o);
    expect_widths("ggx(alpha=0.2,anisotropy=0.5,anisotropy_kind=gltf)", 0.4, 0.2);
    expect_widths("ggx(roughness=0.4,anisotropy=0.5)", 0.16 / s, 0.16 * s);
    expect_widths("ggx(anisotropy=0.5)", 0.3 / s, 0.3 * s);
    static const char *const kinds[] = {"burley", "kulla", "openpbr", "gltf"};
    for (int i = 0; i < 4; i++) { /* no stretch: exactly round */
        char text[100];
        snprintf(text, sizeof text, "ggx(alpha=0.2,anisotropy=0,anisotropy_kind=%s)", kinds[i]);
        microfacet_p p = fields_of(text);
        assert_same_float(p.alpha_x, 0.2f);
        assert_same_float(p.alpha_y, 0.2f);
    }
}

static void widths_stay_in_their_range(void **state) {
    (void)state;
    expect_widths("ggx(alpha=0)", 1e-3, 1e-3);
    expect_widths("ggx(alpha=0.0005)", 1e-3, 1e-3);
    expect_widths("ggx(roughness=0)", 1e-3, 1e-3);
    expect_widths("ggx(roughness=0.01,roughness_map=square)", 1e-3, 1e-3);
    expect_widths("ggx(alpha_x=0,alpha_y=1)", 1e-3, 1.0);
    expect_widths("ggx(alpha=4,anisotropy=1)", 4.0, 4.0 * sqrt(0.1));
    expect_widths("ggx(alpha=4,anisotropy=1,anisotropy_kind=kulla)", 4.0, 1e-3);
    expect_widths("beckmann(alpha=4,anisotropy=1,anisotropy_kind=openpbr)", 4.0, 1e-3);
}

static void direct_masking_gets_the_roughness(void **state) {
    (void)state;
    assert_relative(fields_of("ggx(roughness=0.5)").direct_roughness, 0.5, 2e-7);
    microfacet_p direct = fields_of("ggx(roughness=0.5,roughness_map=direct)");
    assert_relative(direct.direct_roughness, 0.5, 2e-7);
    assert_relative(fields_of("ggx(roughness=0.01)").direct_roughness, 0.01, 2e-7);
    assert_relative(fields_of("ggx(alpha=0.25)").direct_roughness, 0.5, 2e-7);
    assert_relative(fields_of("ggx").direct_roughness, sqrt(0.3), 2e-7);
}

static void other_models(void **state) {
    (void)state;
    ndl_material *m = ndl_material_parse("ward(alpha=0.2)", NULL);
    const ward_p *w = m->lobes[0].fields;
    assert_same_float(w->alpha_x, 0.2f);
    assert_same_float(w->alpha_y, 0.2f);
    ndl_material_free(m);
    m = ndl_material_parse("ward(alpha_y=0)", NULL);
    w = m->lobes[0].fields;
    assert_same_float(w->alpha_x, 0.3f);
    assert_same_float(w->alpha_y, 0.001f);
    ndl_material_free(m);
    m = ndl_material_parse("metal_rough(roughness=0.4,anisotropy=0.5)", NULL);
    const metal_rough_p *r = m->lobes[0].fields;
    double s = sqrt(1.0 - 0.9 * 0.5);
    assert_relative(r->alpha_x, 0.16 / s, 2e-7);
    assert_relative(r->alpha_y, 0.16 * s, 2e-7);
    ndl_material_free(m);
}

static void spellings_of_sigma(void **state) {
    (void)state;
    static const struct { const char *text; double sigma; } rows[] = {
        {"oren_nayar", 0.35},
        {"oren_nayar(sigma=0.5)", 0.5},
        {"oren_nayar(sigma_deg=20)", 20.0 * 3.14159265358979323846 / 180.0},
        {"oren_nayar(sigma_deg=90)", 1.57079632679489661923},
        {"oren_nayar(a=1)", 0.0},
        {"oren_nayar(a=0.75)", 0.57445626465380286599},                       /* sqrt .33 */
        {"oren_nayar(a=0.75,variant=qualitative57)", 0.57445626465380286599}, /* the same A */
        {"oren_nayar(a=0.51)", 4.0211939520298050},                           /* above pi/2 */
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        ndl_material *m = ndl_material_parse(rows[i].text, NULL);
        assert_non_null(m);
        /* a is a float: .51 has an error of 3e-8 in a - 1/2 = .01 */
        assert_relative(((const oren_nayar_p *)m->lobes[0].fields)->sigma, rows[i].sigma, 2e-6);
        ndl_material_free(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(widths_without_stretch),
        cmocka_unit_test(kinds_of_anisotropy),
        cmocka_unit_test(widths_stay_in_their_range),
        cmocka_unit_test(direct_masking_gets_the_roughness),
        cmocka_unit_test(other_models),
        cmocka_unit_test(spellings_of_sigma),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
