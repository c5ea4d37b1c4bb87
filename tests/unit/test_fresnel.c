/* SPDX-License-Identifier: Apache-2.0 */
/* Which Fresnel term a microfacet lobe takes, and with which f0, ior, eta and k. */
#include "ndl_test.h"

#include "core/material.h"
#include "core/models.h"

typedef struct {
    int fresnel;
    microfacet_p p;
} lobe;

static lobe lobe_of(const char *text) {
    ndl_error err;
    ndl_material *m = ndl_material_parse(text, &err);
    if (!m) fail_msg("%s: column %d: %s", text, err.column, err.text);
    lobe l = {.fresnel = m->lobes[0].facet.fresnel};
    memcpy(&l.p, m->lobes[0].fields, sizeof l.p);
    ndl_material_free(m);
    return l;
}

static void the_term_follows_from_the_keys(void **state) {
    (void)state;
    static const struct { const char *text; int fresnel; } rows[] = {
        {"ggx", ND_FRESNEL_IS_schlick},
        {"ggx(f0=0.5)", ND_FRESNEL_IS_schlick},
        {"ggx(fresnel=none,f0=0.5)", ND_FRESNEL_IS_none},
        {"ggx(fresnel=cook_torrance,f0=0.5)", ND_FRESNEL_IS_cook_torrance},
        {"ggx(ior=1.5)", ND_FRESNEL_IS_dielectric},
        {"ggx(ior=0.7)", ND_FRESNEL_IS_dielectric},
        {"ggx(eta=1.5)", ND_FRESNEL_IS_dielectric}, /* eta without k is the ior */
        {"ggx(eta=[1.5,1.6,1.7])", ND_FRESNEL_IS_conductor}, /* per channel: k = 0 */
        {"ggx(k=2)", ND_FRESNEL_IS_conductor},
        {"ggx(eta=0.2,k=3)", ND_FRESNEL_IS_conductor},
        {"ggx(eta=1.5,k=0)", ND_FRESNEL_IS_conductor},
        {"ggx(preset=gold)", ND_FRESNEL_IS_conductor},
        {"ggx(preset=water)", ND_FRESNEL_IS_dielectric},
        {"ggx(fresnel=dielectric)", ND_FRESNEL_IS_dielectric},
        {"ggx(fresnel=conductor)", ND_FRESNEL_IS_conductor},
        {"ggx(fresnel=dielectric,eta=[1.5,1.6,1.7])", ND_FRESNEL_IS_conductor},
        {"ggx(fresnel=conductor,ior=1.5)", ND_FRESNEL_IS_conductor},
        {"ggx(fresnel=schlick,preset=gold)", ND_FRESNEL_IS_schlick},
        {"microfacet(ndf=blinn,fresnel=none,ior=1.5)", ND_FRESNEL_IS_none},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (lobe_of(rows[i].text).fresnel != rows[i].fresnel)
            fail_msg("%s: term %d, want %d", rows[i].text, lobe_of(rows[i].text).fresnel,
                     rows[i].fresnel);
}

static void expect(vec3 got, double r, double g, double b) {
    assert_close(got.x, r, 3e-7, 1e-30);
    assert_close(got.y, g, 3e-7, 1e-30);
    assert_close(got.z, b, 3e-7, 1e-30);
}

static void indices_reach_the_kernel(void **state) {
    (void)state;
    expect(lobe_of("ggx").p.f0, 0.04, 0.04, 0.04);
    expect(lobe_of("ggx(f0=[0.1,0.2,0.3])").p.f0, 0.1, 0.2, 0.3);
    assert_same_float(lobe_of("ggx(fresnel=dielectric)").p.ior, 1.5f);
    assert_same_float(lobe_of("ggx(eta=1.7)").p.ior, 1.7f);
    assert_same_float(lobe_of("ggx(preset=water)").p.ior, 1.333f);
    expect(lobe_of("ggx(k=[1,2,3])").p.k, 1, 2, 3);
    expect(lobe_of("ggx(k=[1,2,3])").p.eta, 1, 1, 1);
    expect(lobe_of("ggx(fresnel=conductor,ior=1.5)").p.eta, 1.5, 1.5, 1.5);
    expect(lobe_of("ggx(fresnel=conductor,ior=1.5)").p.k, 0, 0, 0);
    expect(lobe_of("ggx(fresnel=dielectric,eta=[1.5,1.6,1.7])").p.k, 0, 0, 0);
}

/* An approximate term takes the reflectance straight on, ((n - 1)^2 + k^2)/((n + 1)^2 + k^2). */
static void an_index_gives_f0_to_the_approximations(void **state) {
    (void)state;
    expect(lobe_of("ggx(fresnel=schlick,ior=1.5)").p.f0, 0.04, 0.04, 0.04);
    expect(lobe_of("ggx(fresnel=none,eta=[1,2,3],k=[2,0,1])").p.f0, 1.0 / 2.0, 1.0 / 9.0,
           5.0 / 17.0);
    double diamond = (1.417 * 1.417) / (3.417 * 3.417); /* n = 2.417 */
    expect(lobe_of("ggx(fresnel=cook_torrance,preset=diamond)").p.f0, diamond, diamond, diamond);
}

static void every_preset_sets_its_own_index(void **state) {
    (void)state;
    assert_true(ndl_preset_count() > 20);
    for (size_t i = 0; i < ndl_preset_count(); i++) {
        const ndl_preset *s = ndl_preset_at(i);
        char text[100];
        snprintf(text, sizeof text, "ggx(preset=%s)", s->name);
        lobe l = lobe_of(text);
        if (s->is_metal) {
            assert_int_equal(l.fresnel, ND_FRESNEL_IS_conductor);
            expect(l.p.eta, (double)s->eta[0], (double)s->eta[1], (double)s->eta[2]);
            expect(l.p.k, (double)s->k[0], (double)s->k[1], (double)s->k[2]);
            assert_true(strlen(s->file) > 0);
        } else {
            assert_int_equal(l.fresnel, ND_FRESNEL_IS_dielectric);
            assert_same_float(l.p.ior, s->eta[0]);
        }
        assert_true(strlen(s->source) > 5);
    }
    assert_null(ndl_preset_at(ndl_preset_count()));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_term_follows_from_the_keys),
        cmocka_unit_test(indices_reach_the_kernel),
        cmocka_unit_test(an_index_gives_f0_to_the_approximations),
        cmocka_unit_test(every_preset_sets_its_own_index),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
