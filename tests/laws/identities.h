/* SPDX-License-Identifier: Apache-2.0 */
/* What the tests of identities share: materials by text and values by random pairs. */
#ifndef LAW_IDENTITIES_H
#define LAW_IDENTITIES_H
#include "directions.h"

enum { PAIRS = 2000 };

static inline ndl_material *parsed(const char *format, ...) __attribute__((format(printf, 1, 2)));
static inline ndl_material *parsed(const char *format, ...) {
    char text[512];
    ndl_error err;
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    ndl_material *m = ndl_material_parse(text, &err);
    if (!m) fail_msg("%s: column %d: %s", text, err.column, err.text);
    return m;
}

/* A pair above the horizon, both cosines at least .02, so that values are not all in the tails. */
static inline void lit_pair(draws *d, ndl_vec3 *wi, ndl_vec3 *wo) {
    float a[3], b[3];
    direction_at(0.02 + 0.98 * draw(d), TURN * draw(d), a);
    direction_at(0.02 + 0.98 * draw(d), TURN * draw(d), b);
    if (draw_bits(d) & 1) { /* in the highlight */
        mirrored(a, b);
        near_to(d, b, 0.2 * draw(d), b);
        b[2] = fabsf(b[2]);
    }
    *wi = (ndl_vec3){a[0], a[1], a[2]};
    *wo = (ndl_vec3){b[0], b[1], b[2]};
}

static inline double cosine_half(ndl_vec3 wi, ndl_vec3 wo) { /* VoH */
    double x = (double)wi.x + (double)wo.x, y = (double)wi.y + (double)wo.y,
           z = (double)wi.z + (double)wo.z;
    return 0.5 * sqrt(x * x + y * y + z * z);
}

static inline double normal_half(ndl_vec3 wi, ndl_vec3 wo) { /* NoH */
    return 0.5 * ((double)wi.z + (double)wo.z) / cosine_half(wi, wo);
}

/* got and want agree to `relative`, or the pair and both materials are printed. */
static inline void same_value(const char *what, float got, double want, double relative,
                              ndl_vec3 wi, ndl_vec3 wo, const ndl_material *m) {
    if (is_close((double)got, want, relative, 1e-30)) return;
    print_error("%s: %s: %.9g, want %.9g, off by %.3g of it\n"
                "  reproduce: echo %.9g %.9g %.9g %.9g %.9g %.9g | ndotl eval '%s'\n",
                what, ndl_material_text(m), (double)got, want, (double)got / want - 1.0,
                (double)wi.x, (double)wi.y, (double)wi.z, (double)wo.x, (double)wo.y, (double)wo.z,
                ndl_material_text(m));
    fail();
}

/* The brdf of a and b agree to `relative` over random pairs; both are released. */
static inline void same_brdf(const char *what, ndl_material *a, ndl_material *b, double relative) {
    draws d = draws_of(7);
    for (int i = 0; i < PAIRS; i++) {
        ndl_vec3 wi, wo;
        lit_pair(&d, &wi, &wo);
        ndl_rgb f = ndl_brdf(a, wi, wo), g = ndl_brdf(b, wi, wo);
        same_value(what, f.r, (double)g.r, relative, wi, wo, a);
        same_value(what, f.g, (double)g.g, relative, wi, wo, a);
        same_value(what, f.b, (double)g.b, relative, wi, wo, a);
    }
    ndl_material_free(a);
    ndl_material_free(b);
}

#endif
