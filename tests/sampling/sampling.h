/* SPDX-License-Identifier: Apache-2.0 */
/* What the sampling tests share: materials, viewers, and seeded random numbers. */
#ifndef SAMPLING_H
#define SAMPLING_H
#include "ndl_test.h"

#include <ndotl/ndotl.h>
#include <stdbool.h>

/* Lobes of width .05 and more, which a grid of directions resolves; wide_text() has every model
   with its defaults, too. */
static const char *const WIDE[] = {
    "lambert(color=[0.9,0.5,0.1])",
    "oren_nayar(sigma=0.8)",
    "oren_nayar(sigma=0.5, variant=full)",
    "toon_diffuse(ramp=[0:0.1, 0.3:[1,0.5,0.2], 0.3:0.6, 1:1])",
    "toon_specular(threshold=0.8)",
    "phong(exponent=0)",
    "phong(exponent=7.5)",
    "phong(exponent=100, variant=normalized)",
    "blinn_phong(exponent=0)",
    "blinn_phong(exponent=12, variant=normalized)",
    "blinn_phong(exponent=300, variant=normalized_exact)",
    "ward(alpha=0.3)",
    "ward(alpha_x=0.1, alpha_y=0.6, variant=duer)",
    "ward(alpha=0.15, variant=ward92)",
    "microfacet(ndf=blinn, alpha=0.2, masking=cook_torrance, f0=1)",
    "microfacet(ndf=blinn, alpha=1, masking=kelemen, f0=1)",
    "ggx(alpha=0.1, f0=1)",
    "ggx(alpha=0.5, preset=gold)",
    "ggx(alpha=1, f0=1)",
    "ggx(alpha=2.5, f0=0.5, masking=smith)",
    "ggx(alpha_x=0.08, alpha_y=0.7, f0=0.9)",
    "ggx(alpha_x=3, alpha_y=0.4, f0=0.9)",
    "beckmann(alpha=0.1, f0=1)",
    "beckmann(alpha=0.5, preset=copper)",
    "beckmann(alpha=1.5, f0=1)",
    "beckmann(alpha_x=0.08, alpha_y=0.7, f0=0.9)",
    "metal_rough",
    "metal_rough(base_color=[1,0.7,0.3], metalness=0.6, roughness=0.4, anisotropy=0.7)",
    "metal_rough(base_color=[1,0.7,0.3], metalness=1, roughness=0.6)",
    "0.3*lambert(color=0.8) + 0.7*ggx(alpha=0.15) + [0.1,0.2,0.3]*ward",
    "0.5*beckmann(alpha=0.4, f0=1) + 2*lambert(color=0.01) + 0*phong",
};
enum { WIDE_COUNT = sizeof WIDE / sizeof *WIDE };

/* And narrower ones, and the ends of the ranges. */
static const char *const NARROW[] = {
    "ggx(alpha=0, f0=1)",
    "ggx(alpha=4, f0=1)",
    "ggx(alpha_x=0, alpha_y=4)",
    "beckmann(alpha=0, f0=1)",
    "beckmann(alpha=4, f0=1)",
    "beckmann(alpha_x=4, alpha_y=0)",
    "ward(alpha=0)",
    "ward(alpha=4, variant=eq3)",
    "phong(exponent=1e5)",
    "blinn_phong(exponent=1e5, variant=normalized)",
    "microfacet(ndf=blinn, alpha=0, f0=1)",
    "metal_rough(roughness=0, base_color=0, dielectric_f0=0)",
    "0.5*ggx(alpha=0.02, f0=1) + 0.5*ggx(alpha=0.4, f0=0.04) + 1e-30*lambert",
    "phong(exponent=3.4e38)",
    "blinn_phong(exponent=3.4e38, variant=normalized_exact)",
    "0*lambert + 0*ggx",
    "3e38*lambert(color=1) + 1e-30*beckmann + 3e38*ward",
};
enum { NARROW_COUNT = sizeof NARROW / sizeof *NARROW };

static inline size_t wide_count(void) {
    return WIDE_COUNT + ndl_model_count();
}

static inline const char *wide_text(size_t i) {
    return i < WIDE_COUNT ? WIDE[i] : ndl_model_name(i - WIDE_COUNT);
}

static inline ndl_material *material(const char *text) {
    ndl_error err;
    ndl_material *m = ndl_material_parse(text, &err);
    if (!m) {
        print_error("%s: column %d: %s\n", text, err.column, err.text);
        fail();
    }
    return m;
}

/* A unit vector at cosine z and so many turns around n. */
static inline ndl_vec3 viewer(double z, double turns) {
    double s = sqrt(1.0 - z * z), phi = 6.283185307179586477 * turns;
    ndl_vec3 w = {(float)(s * cos(phi)), (float)(s * sin(phi)), (float)z};
    return w;
}

/* xorshift64*. */
static inline float uniform(uint64_t *state) {
    uint64_t x = *state;
    x ^= x >> 12;
    x ^= x << 25;
    x ^= x >> 27;
    *state = x;
    return (float)(x * 0x2545F4914F6CDD1DULL >> 40) * 0x1p-24f;
}

/* A batch of draws for one viewer or many. */
enum { DRAWS = 4096 };
typedef struct {
    float wo[3][DRAWS], u[3][DRAWS], wi[3][DRAWS], rgb[3][DRAWS], pdf[DRAWS];
} draws;

static inline void draw_batch(const ndl_material *m, size_t n, draws *d) {
    ndl_draw_n(m, n, (ndl_vec3_n){d->wo[0], d->wo[1], d->wo[2]},
               (ndl_vec3_n){d->u[0], d->u[1], d->u[2]},
               (ndl_vec3_out){d->wi[0], d->wi[1], d->wi[2]},
               (ndl_rgb_n){d->rgb[0], d->rgb[1], d->rgb[2]}, d->pdf);
}

static inline void fill_draws(draws *d, ndl_vec3 wo, uint64_t *state) {
    for (size_t i = 0; i < DRAWS; i++) {
        d->wo[0][i] = wo.x;
        d->wo[1][i] = wo.y;
        d->wo[2][i] = wo.z;
        for (int c = 0; c < 3; c++)
            d->u[c][i] = uniform(state);
    }
}

#endif
