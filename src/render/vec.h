/* SPDX-License-Identifier: Apache-2.0 */
/* Vectors of doubles: geometry is computed wide, and rounded once where shading begins. */
#ifndef ND_RENDER_VEC_H
#define ND_RENDER_VEC_H
#include "ndotl/ndotl.h"

#include <math.h>

typedef struct { double x, y, z; } dvec;

static inline dvec dv(double x, double y, double z) {
    return (dvec){x, y, z};
}
static inline dvec dv_from(const float *v) {
    return dv((double)v[0], (double)v[1], (double)v[2]);
}
static inline dvec dv_add(dvec a, dvec b) {
    return dv(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline dvec dv_sub(dvec a, dvec b) {
    return dv(a.x - b.x, a.y - b.y, a.z - b.z);
}
static inline dvec dv_scale(dvec a, double s) {
    return dv(a.x * s, a.y * s, a.z * s);
}
static inline double dv_dot(dvec a, dvec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline dvec dv_cross(dvec a, dvec b) {
    return dv(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline double dv_length(dvec a) {
    return sqrt(dv_dot(a, a));
}
/* a / |a|; zero where a is zero. */
static inline dvec dv_unit(dvec a) {
    double length = dv_length(a);
    return length > 0.0 ? dv_scale(a, 1.0 / length) : dv(0.0, 0.0, 0.0);
}
static inline ndl_vec3 dv_round(dvec a) {
    return (ndl_vec3){(float)a.x, (float)a.y, (float)a.z};
}

#endif
