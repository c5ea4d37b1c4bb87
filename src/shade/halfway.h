/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* The half vector that every specular model looks at, without normalising it, and the mirror. */
#ifndef ND_SHADE_HALFWAY_H
#define ND_SHADE_HALFWAY_H
#include "shade/common.h"

/* The half vector of a pair of directions, unnormalised: what uses it is homogeneous in h, so
   no root and no division is spent on its length. */
STRUCT(halfway) {
    vec3 h;     /* scale * (wi + wo) */
    num hh;     /* h . h */
    num scale;  /* 1, or 2^22 where wi and wo nearly oppose each other */
    num cosine; /* VoH = LoH = |wi + wo| / 2, in [0, 1] */
};

/* wi/|wi| + wo/|wo|, up to a common factor, for vectors whose rounding makes them a little longer
   or shorter than 1. With d = wi - wo, d . h = |wi|^2 - |wo|^2, and both factors together are
   h - d (d . h)/4. Opposite grazing directions need it: h's tangent part is what their large
   components leave over, and half an ulp of length is a thousandth of a polished lobe. */
FN vec3 even_sum(vec3 wi, vec3 wo) {
    vec3 h = v3_add(wi, wo);
    vec3 d = v3_sub(wi, wo);
    return v3_sub(h, v3_scale(d, 0.25f * v3_dot(d, h)));
}

/* The half vector of wi and wo. A sum shorter than 1/64 is scaled up by a power of two (exact):
   its fourth power times two cosines would leave the range of float from 1e-6 above the horizon
   on; with it, values hold down to 1e-9.
   Domain: vectors of length 1 within 1e-3; others give some finite value. */
FN halfway halfway_of(vec3 wi, vec3 wo) {
    vec3 sum = even_sum(wi, wo);
    num ss = v3_dot(sum, sum);
    halfway m;
    m.scale = sel(ss < 0.000244140625f, 4194304.0f, 1.0f); /* 2^-12, 2^22 */
    m.h = v3_scale(sum, m.scale);
    m.hh = ss * m.scale * m.scale;
    m.cosine = min_(0.5f * sqrt_(ss), 1.0f);
    return m;
}

/* 1 / h.z^2, at most 1e36: finite where the half vector lies in the horizon, small enough that
   a product with h.h stays finite. */
FN num inverse_square_z(vec3 h) {
    return 1.0f / max_(h.z * h.z, NUM(1e-36));
}

/* w mirrored at the normal: 2 (n.w) n - w, which points away from the surface as w does.
   In GLSL that is -reflect(w, n) for w towards the light.
   Source: formulas S4.19, S4.20; the order printed in S4's text (S4.18) gives 3 w - 2 n'. */
FN vec3 reflect_about_normal(vec3 w) {
    return v3(-w.x, -w.y, w.z);
}

/* Cosine between the viewer and the mirrored light, wo . reflect_about_normal(wi), in [-1, 1];
   wo leaves the surface (S4.17). */
FN num mirror_cosine(vec3 wi, vec3 wo) {
    return wi.z * wo.z - wi.x * wo.x - wi.y * wo.y;
}

#endif
