/* SPDX-License-Identifier: Apache-2.0 */
/* Short ways to values of the public API, for the assertions of the formula inventory. */
#ifndef FORMULAS_VALUES_H
#define FORMULAS_VALUES_H
#include "ndl_test.h"

#include <ndotl/convert.h>
#include <ndotl/ndotl.h>

#define F1 ", fresnel=none, f0=1)"
static const double PI64 = 3.14159265358979323846;
static const ndl_vec3 NORMAL = {0.0f, 0.0f, 1.0f};

static inline ndl_vec3 unit(double x, double y, double z) {
    ndl_vec3 w;
    ndl_direction(x, y, z, &w);
    return w;
}

/* In the plane of t and n, or of b and n: the angle from n, positive towards t or b. */
static inline ndl_vec3 along_t(double degrees) {
    ndl_vec3 w;
    ndl_direction_deg(degrees, 0.0, &w);
    return w;
}
static inline ndl_vec3 along_b(double degrees) {
    ndl_vec3 w;
    ndl_direction_deg(degrees, 90.0, &w);
    return w;
}

/* With this cosine to n, towards +t or -t. */
static inline ndl_vec3 at_cosine(double cosine, int side) {
    return unit(side * sqrt(1.0 - cosine * cosine), 0.0, cosine);
}

static inline ndl_material *material(const char *text) {
    ndl_error err;
    ndl_material *m = ndl_material_parse(text, &err);
    if (!m) fail_msg("%s: column %d: %s", text, err.column, err.text);
    return m;
}

static inline double brdf(const char *text, ndl_vec3 wi, ndl_vec3 wo) {
    ndl_material *m = material(text);
    ndl_rgb f = ndl_brdf(m, wi, wo);
    ndl_material_free(m);
    return (double)f.g;
}

static inline double brdf_cos(const char *text, ndl_vec3 wi, ndl_vec3 wo) {
    ndl_material *m = material(text);
    ndl_rgb f = ndl_brdf_cos(m, wi, wo);
    ndl_material_free(m);
    return (double)f.g;
}

static inline double scanline(const char *text, ndl_vec3 wi, ndl_vec3 wo) {
    ndl_material *m = material(text);
    ndl_rgb f = ndl_scanline(m, wi, wo);
    ndl_material_free(m);
    return (double)f.g;
}

static inline double term(const char *text, ndl_term_kind kind, ndl_vec3 wi, ndl_vec3 wo) {
    ndl_material *m = material(text);
    ndl_rgb f = ndl_term(m, kind, wi, wo);
    ndl_material_free(m);
    return (double)f.g;
}

static inline double albedo(const char *text, double cosine) {
    ndl_material *m = material(text);
    ndl_rgb e = ndl_albedo(m, at_cosine(cosine, 1), 1e-5f, NULL);
    ndl_material_free(m);
    return (double)e.g;
}

/* G1 of a separable masking: G with one of the directions at the normal. */
static inline double g1(const char *text, double cosine) {
    return term(text, NDL_TERM_G, NORMAL, at_cosine(cosine, 1));
}

/* F at the cosine c between h and either direction. */
static inline double fresnel(const char *text, double c) {
    return term(text, NDL_TERM_F, at_cosine(c, -1), at_cosine(c, 1));
}

static inline double convert(const char *key, double value, const char *to) {
    ndl_known known = {key, (float)value, NULL};
    ndl_error err;
    float result = 0.0f;
    if (ndl_convert(&known, 1, to, &result, &err) != NDL_OK) fail_msg("%s: %s", key, err.text);
    return (double)result;
}

/* got is `want` as printed with `digits` decimals. */
#define assert_printed(got, want, digits) assert_absolute(got, want, 0.56 * pow(10.0, -(digits)))

#endif
