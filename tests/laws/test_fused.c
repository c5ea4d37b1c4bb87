/* SPDX-License-Identifier: Apache-2.0 */
/* The batch kernels compose a microfacet value in three steps; the fused text of every combination,
   compiled here, gives the same bits, on every instruction set. */
#include "identities.h"

#include "core/material.h"
#include "core/models.h"

#include "core/microfacet_combinations.h"

#define ALL_FRESNEL(C, ndf, masking)                                                               \
    C(ndf, masking, none) C(ndf, masking, schlick) C(ndf, masking, cook_torrance)                  \
    C(ndf, masking, dielectric) C(ndf, masking, conductor)
#define ALL_MASKING(C, ndf)                                                                        \
    ALL_FRESNEL(C, ndf, none) ALL_FRESNEL(C, ndf, implicit) ALL_FRESNEL(C, ndf, neumann)           \
    ALL_FRESNEL(C, ndf, cook_torrance) ALL_FRESNEL(C, ndf, kelemen) ALL_FRESNEL(C, ndf, smith)     \
    ALL_FRESNEL(C, ndf, smith_correlated) ALL_FRESNEL(C, ndf, smith_walter)                        \
    ALL_FRESNEL(C, ndf, schlick_beckmann) ALL_FRESNEL(C, ndf, schlick_ggx)                         \
    ALL_FRESNEL(C, ndf, schlick_direct)
#define ALL(C) ALL_MASKING(C, ggx) ALL_MASKING(C, beckmann) ALL_MASKING(C, blinn)

ALL(MICROFACET_COMBINATION)

typedef vec3 fused(microfacet_p, vec3, vec3);
typedef struct {
    const char *ndf, *masking, *fresnel;
    fused *brdf, *brdf_cos;
} combination;

#define ROW(ndf, masking, fresnel)                                                                 \
    {#ndf, #masking, #fresnel, microfacet_##ndf##_##masking##_##fresnel##_brdf,                    \
     microfacet_##ndf##_##masking##_##fresnel##_brdf_cos},
static const combination COMBINATIONS[] = {ALL(ROW)};
enum { COMBINATION_COUNT = sizeof COMBINATIONS / sizeof *COMBINATIONS };
_Static_assert(COMBINATION_COUNT == ND_NDFS * ND_MASKINGS * ND_FRESNELS, "a new word is missing");

/* Isotropic and stretched, polished and rough; the colours differ per channel. */
static const char *const WIDTHS[] = {"alpha=0.002", "alpha=0.35", "alpha_x=0.04,alpha_y=0.7",
                                     "roughness=1"};

static const char *reflectance(const char *fresnel) {
    if (strcmp(fresnel, "dielectric") == 0) return "ior=0.8";
    if (strcmp(fresnel, "conductor") == 0) return "eta=[0.2,1,2.4],k=[3.6,2.1,0]";
    return "f0=[0.04,0.5,1]";
}

static void expect_bits(const ndl_material *m, const char *option, fused *f, const pairs *p) {
    microfacet_p fields;
    memcpy(&fields, m->lobes[0].fields, sizeof fields);
    for (size_t i = 0; i < BATCH; i++) {
        vec3 want = f(fields, v3(p->wi[0][i], p->wi[1][i], p->wi[2][i]),
                      v3(p->wo[0][i], p->wo[1][i], p->wo[2][i]));
        const float got[3] = {p->rgb[0][i], p->rgb[1][i], p->rgb[2][i]};
        if (memcmp(got, &want, sizeof got) != 0)
            broken(m, option, p, i, "other bits than the fused text", (double)want.x);
    }
}

static void the_steps_give_the_bits_of_the_fused_text(void **state) {
    static const char *const isas[] = {"scalar", "x86-64", "x86-64-v3", "x86-64-v4", "neon"};
    static pairs p;
    const combination *c = *state;
    draws d = draws_of(8);
    fill_pairs(&d, &p, BATCH, FINITE_KINDS);
    for (size_t w = 0; w < sizeof WIDTHS / sizeof *WIDTHS; w++) {
        if (strcmp(c->ndf, "blinn") == 0 && strstr(WIDTHS[w], "alpha_x")) continue;
        ndl_material *m = parsed("microfacet(ndf=%s,masking=%s,fresnel=%s,%s,%s,color=[1,.5,.1])",
                                 c->ndf, c->masking, c->fresnel, WIDTHS[w],
                                 reflectance(c->fresnel));
        for (size_t k = 0; k < sizeof isas / sizeof *isas; k++) {
            if (ndl_use_isa(isas[k]) != NDL_OK) continue;
            ndl_brdf_n(m, BATCH, wi_of(&p), wo_of(&p), rgb_of(&p));
            expect_bits(m, "", c->brdf, &p);
            ndl_brdf_cos_n(m, BATCH, wi_of(&p), wo_of(&p), rgb_of(&p));
            expect_bits(m, " --cos", c->brdf_cos, &p);
        }
        ndl_use_isa(NULL);
        ndl_material_free(m);
    }
}

int main(void) {
    struct CMUnitTest tests[COMBINATION_COUNT];
    for (int i = 0; i < COMBINATION_COUNT; i++)
        tests[i] = (struct CMUnitTest){COMBINATIONS[i].masking,
                                       the_steps_give_the_bits_of_the_fused_text, NULL, NULL,
                                       (void *)(uintptr_t)&COMBINATIONS[i]};
    return _cmocka_run_group_tests("fused text", tests, COMBINATION_COUNT, NULL, NULL);
}
