/* SPDX-License-Identifier: Apache-2.0 */
/* The rival: the textbook's formulas as a C loop that one would write first, well compiled. NAIVE
   is the function's name. */
#include "flagship.h"

#include <math.h>

typedef struct {
    float x, y, z;
} vec3;

static vec3 halfway(vec3 a, vec3 b) {
    vec3 h = {a.x + b.x, a.y + b.y, a.z + b.z};
    float length = sqrtf(h.x * h.x + h.y * h.y + h.z * h.z);
    return (vec3){h.x / length, h.y / length, h.z / length};
}

static float distribution(const flagship *p, vec3 h) {
    float x = h.x / p->alpha_x, y = h.y / p->alpha_y;
    float d = x * x + y * y + h.z * h.z;
    return 1.0f / (3.14159265f * p->alpha_x * p->alpha_y * d * d);
}

static float lambda(const flagship *p, vec3 w) {
    float x = p->alpha_x * w.x, y = p->alpha_y * w.y;
    return 0.5f * (sqrtf(1.0f + (x * x + y * y) / (w.z * w.z)) - 1.0f);
}

static float masking(const flagship *p, vec3 wi, vec3 wo) {
    return 1.0f / (1.0f + lambda(p, wi) + lambda(p, wo));
}

static float schlick(float f0, float cosine) {
    float m = 1.0f - cosine;
    return f0 + (1.0f - f0) * m * m * m * m * m;
}

void NAIVE(const flagship *p, size_t n, ndl_vec3_n wi, ndl_vec3_n wo, ndl_rgb_n rgb) {
    for (size_t i = 0; i < n; i++) {
        vec3 l = {wi.x[i], wi.y[i], wi.z[i]}, v = {wo.x[i], wo.y[i], wo.z[i]};
        if (l.z <= 0.0f || v.z <= 0.0f) {
            rgb.r[i] = rgb.g[i] = rgb.b[i] = 0.0f;
            continue;
        }
        vec3 h = halfway(l, v);
        float cosine = v.x * h.x + v.y * h.y + v.z * h.z;
        float value = distribution(p, h) * masking(p, l, v) / (4.0f * l.z * v.z);
        rgb.r[i] = value * schlick(p->f0[0], cosine);
        rgb.g[i] = value * schlick(p->f0[1], cosine);
        rgb.b[i] = value * schlick(p->f0[2], cosine);
    }
}
