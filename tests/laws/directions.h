/* SPDX-License-Identifier: Apache-2.0 */
/* Pairs of directions on which the laws are tried, and the report of one that breaks a law. */
#ifndef LAW_DIRECTIONS_H
#define LAW_DIRECTIONS_H
#include "materials.h"

enum { BATCH = 4096 };

typedef struct { float wi[3][BATCH], wo[3][BATCH], rgb[3][BATCH]; } pairs;

static inline ndl_vec3_n wi_of(const pairs *p) {
    return (ndl_vec3_n){p->wi[0], p->wi[1], p->wi[2]};
}
static inline ndl_vec3_n wo_of(const pairs *p) {
    return (ndl_vec3_n){p->wo[0], p->wo[1], p->wo[2]};
}
static inline ndl_rgb_n rgb_of(pairs *p) {
    return (ndl_rgb_n){p->rgb[0], p->rgb[1], p->rgb[2]};
}

static const double TURN = 6.28318530717958647693;

/* The unit vector of height z at azimuth phi. */
static inline void direction_at(double z, double phi, float w[3]) {
    double s = sqrt(fmax(1.0 - z * z, 0.0));
    w[0] = (float)(s * cos(phi));
    w[1] = (float)(s * sin(phi));
    w[2] = (float)z;
}

static inline void anywhere(draws *d, float w[3]) {
    direction_at(2.0 * draw(d) - 1.0, TURN * draw(d), w);
}

static inline void above(draws *d, float w[3]) {
    direction_at(draw(d), TURN * draw(d), w);
}

/* w turned by about `angle`; may end below the horizon. */
static inline void near_to(draws *d, const float w[3], double angle, float to[3]) {
    double v[3], n = 0.0;
    for (int k = 0; k < 3; k++) {
        v[k] = (double)w[k] + angle * (2.0 * draw(d) - 1.0);
        n += v[k] * v[k];
    }
    for (int k = 0; k < 3; k++) to[k] = (float)(v[k] / sqrt(n));
}

static inline void set3(float w[3], float x, float y, float z) {
    w[0] = x;
    w[1] = y;
    w[2] = z;
}

/* Kinds of pairs; those before UNIT_KINDS are unit vectors, those before FINITE_KINDS finite. */
enum {
    SPHERE, HEMISPHERE, MIRROR, NEAR_MIRROR, EQUAL, LIGHT_AT_NORMAL, VIEW_AT_NORMAL, LOW, LOWEST,
    BOTH_LOW, OPPOSITE, NEAR_OPPOSITE, ON_HORIZON, UNIT_KINDS,
    LONGER = UNIT_KINDS, SUBNORMAL, ZERO, FINITE_KINDS,
    NOT_FINITE = FINITE_KINDS, HUGE_LENGTH, ALL_KINDS
};

static inline void mirrored(const float w[3], float to[3]) {
    set3(to, -w[0], -w[1], w[2]);
}

static inline float odd_number(draws *d) {
    static const float odd[] = {NAN, INFINITY, -INFINITY, 0.0f, -0.0f, 1.0f, -1.0f, 0.5f};
    return odd[draw_bits(d) % 8];
}

static inline void special_pair(draws *d, int kind, float wi[3], float wo[3]) {
    float tiny = 1e-38f * (float)draw(d);
    double phi = TURN * draw(d);
    switch (kind) {
    case LONGER:
        for (int k = 0; k < 3; k++) wi[k] *= (float)(4.0 * draw(d));
        for (int k = 0; k < 3; k++) wo[k] *= (float)(4.0 * draw(d));
        break;
    case SUBNORMAL: /* a component, or all of them, subnormal */
        wi[draw_bits(d) % 3] = tiny;
        if (draw_bits(d) & 1) wo[draw_bits(d) % 3] = 1e-41f;
        if (draw_bits(d) % 4 == 0) set3(wi, tiny, 1e-42f, 1e-45f);
        break;
    case NOT_FINITE:
        for (int k = 0; k < 3; k++) wi[k] = draw_bits(d) & 1 ? odd_number(d) : wi[k];
        for (int k = 0; k < 3; k++) wo[k] = draw_bits(d) & 1 ? odd_number(d) : wo[k];
        break;
    case ZERO:
        set3(wi, 0.0f, 0.0f, 0.0f);
        if (draw_bits(d) & 1) set3(wo, 0.0f, 0.0f, FLT_MIN);
        break;
    case HUGE_LENGTH:
        for (int k = 0; k < 3; k++) wi[k] *= 1e30f;
        for (int k = 0; k < 3; k++) wo[k] *= draw_bits(d) & 1 ? 1e30f : 1e-20f;
        break;
    default: direction_at(0.0, phi, wi);
    }
}

static inline void one_pair(draws *d, int kind, float wi[3], float wo[3]) {
    double phi = TURN * draw(d), height = draw_bits(d) & 1 ? 1e-6 : 1e-9;
    above(d, wi);
    above(d, wo);
    switch (kind) {
    case SPHERE: anywhere(d, wi); anywhere(d, wo); break;
    case HEMISPHERE: break;
    case MIRROR: mirrored(wi, wo); break;
    case NEAR_MIRROR:
        mirrored(wi, wo);
        near_to(d, wo, pow(10.0, -6.0 * draw(d)), wo);
        break;
    case EQUAL: memcpy(wo, wi, 3 * sizeof *wi); break;
    case LIGHT_AT_NORMAL: set3(wi, 0.0f, 0.0f, 1.0f); break;
    case VIEW_AT_NORMAL: set3(wo, 0.0f, 0.0f, 1.0f); break;
    case LOW: direction_at(1e-6, phi, wi); break;
    case LOWEST: direction_at(1e-9, phi, draw_bits(d) & 1 ? wi : wo); break;
    case BOTH_LOW:
        direction_at(height, phi, wi);
        direction_at(height * draw(d), TURN * draw(d), wo);
        break;
    case OPPOSITE: /* wi = -wo but for the height */
        direction_at(height, phi, wi);
        set3(wo, -wi[0], -wi[1], wi[2]);
        break;
    case NEAR_OPPOSITE:
        direction_at(height, phi, wi);
        direction_at(pow(10.0, -9.0 * draw(d)), phi + 0.5 * TURN + 1e-3 * draw(d), wo);
        break;
    case ON_HORIZON: /* +0 or -0, of the light or of the viewer */
        direction_at(draw_bits(d) & 1 ? 0.0 : -0.0, phi, draw_bits(d) & 1 ? wi : wo);
        break;
    default: special_pair(d, kind, wi, wo);
    }
}

/* n pairs, the kinds in turn. */
static inline void fill_pairs(draws *d, pairs *p, size_t n, int kinds) {
    for (size_t i = 0; i < n; i++) {
        float wi[3], wo[3];
        one_pair(d, (int)(i % (size_t)kinds), wi, wo);
        for (int k = 0; k < 3; k++) {
            p->wi[k][i] = wi[k];
            p->wo[k][i] = wo[k];
        }
    }
}

/* Prints what broke a law, with the command that shows it, and fails the test. */
static inline void broken(const ndl_material *m, const char *option, const pairs *p, size_t i,
                          const char *what, double value) {
    print_error("%s: %s, %.9g\n"
                "  reproduce: echo %.9g %.9g %.9g %.9g %.9g %.9g | ndotl eval '%s'%s\n",
                ndl_isa(), what, value, (double)p->wi[0][i], (double)p->wi[1][i],
                (double)p->wi[2][i], (double)p->wo[0][i], (double)p->wo[1][i],
                (double)p->wo[2][i], ndl_material_text(m), option);
    fail();
}

#endif
