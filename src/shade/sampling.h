/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* Warps of random numbers into directions, and their densities. A model's
       vec3 <model>_sample(<model>_p p, vec3 wo, vec3 u)   u in [0, 1)^3
   gives wi for a viewer wo; zero, or a wi that does not leave the surface (z <= 0), means that
   there is no sample.
       num <model>_pdf(<model>_p p, vec3 wi, vec3 wo)
   is the density of wi, 1/sr, exactly 0 outside the lit gate: over the upper hemisphere it adds up
   to 1 less the share of `no sample`. u.x and u.y place the direction, u.z chooses between parts of
   a model. The small end of u gives the middle of a lobe, so that no logarithm meets 0. */
#ifndef ND_SHADE_SAMPLING_H
#define ND_SHADE_SAMPLING_H
#include "shade/halfway.h"

/* The samplers of a family have one signature, whether or not they look at the parameters. */
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

/* wi for a viewer above the horizon, else zero: no sample. */
FN vec3 if_seen(vec3 wo, vec3 wi) {
    return v3_sel(wo.z > 0.0f, wi, v3_splat(0.0f));
}

/* A direction of the upper hemisphere with density cos/pi: a point of the unit disc, raised.
   z > 0 for every u.x in [0, 1). */
FN vec3 cosine_sample(vec3 wo, vec3 u) {
    num r = sqrt_(u.x);
    return if_seen(wo, v3(r * cos2pi_(u.y), r * sin2pi_(u.y), sqrt_(1.0f - u.x)));
}

/* wi.z/pi, 1/sr. */
FN num cosine_pdf(vec3 wi, vec3 wo) {
    return sel(lit(wi, wo), INV_PI * wi.z, 0.0f);
}

/* The vector (x, y, z) of a frame whose third axis is `axis`.
   Domain: a unit vector above the horizon, where the frame needs no branch.
   Source: [Duff17]. */
FN vec3 about(vec3 axis, num x, num y, num z) {
    num along = axis.x * x + axis.y * y;
    num shift = z - along / (1.0f + axis.z);
    return v3(x + axis.x * shift, y + axis.y * shift, axis.z * z - along);
}

/* The unit normal whose slopes are -x, -y. */
FN vec3 normal_of_slopes(num x, num y) {
    return v3_unit(v3(x, y, 1.0f));
}

/* wo mirrored at the unit normal h: 2 (wo.h) h - wo. */
FN vec3 mirrored_at(vec3 wo, vec3 h) {
    return v3_sub(v3_scale(h, 2.0f * v3_dot(wo, h)), wo);
}

/* Density of wi, 1/sr, where unit normals h are drawn with density D(h) NoH and mirror wo into wi:
   D NoH/(4 VoH), with NoH/VoH = 2 h.z scale/h.h of the unnormalised h.
   Source: [Walter07] eq. 14. */
FN num half_vector_pdf(halfway m, ratio d, vec3 wi, vec3 wo) {
    num p = d.n * (m.h.z * m.scale) / max_(2.0f * d.d * m.hh, SMALLEST);
    return sel(lit(wi, wo), storable(p), 0.0f);
}

/* tan^2 of the angle whose cosine is (1 - u)^power: e^(-2 power ln(1 - u)) - 1, which keeps its
   digits where the cosine rounds to 1. */
FN num tangent2_of_power(num u, num power) {
    return expm1_(-2.0f * power * log1p_(-u));
}

/* A normal turned about n by the angle whose tan^2 is t2, towards the azimuth of u.y turns. */
FN vec3 normal_at(num t2, vec3 u) {
    num t = sqrt_(t2);
    return normal_of_slopes(t * cos2pi_(u.y), t * sin2pi_(u.y));
}

#endif
