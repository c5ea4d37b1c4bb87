# SPDX-License-Identifier: Apache-2.0
"""The density of every model's sampler as a function of angles: 1/sr, over wi, inside the lit gate.

Sources: half-vector Jacobian 1/(4 VoH) and D NoH [Walter07]; visible normals D G1 VoH/NoV
[HeitzDEon14]; the bounded cap of GGX [Tokuyoshi23]; powers of a cosine [LafortuneWillems94].
"""
from geometry import Geometry
from models import (ONE, POINT8, colour, expanded, microfacet_width, mirror_cosine)
from terms import ndf, schlick, smith_lambda, three, width_of
from material import f32


def cosine(g, p, nudge):
    return g.ci / g.c.pi


def power(g, e):
    """Normalisation of cos^e over a hemisphere."""
    return (e + 1) / (2 * g.c.pi)


def phong(g, p, nudge):
    e = p.get("exponent", 30)
    return power(g, e) * max(0, mirror_cosine(g) * (1 + nudge)) ** e


def blinn_phong(g, p, nudge):
    e = p.get("exponent", 30)
    return power(g, e) * (g.ch * (1 + nudge)) ** e / (4 * g.cd)


def half_vector(g, density):
    return density * g.ch / (4 * g.cd)


def ward(g, p, nudge):
    return half_vector(g, ndf("beckmann", g, width_of(g.c, p, 4)))


def visible(name, g, w):
    """D G1(wo)/(4 NoV)."""
    return ndf(name, g, w) / (4 * g.co * (1 + smith_lambda(name, g.c, w, g.to, g.po)))


def bounded(g, w):
    """Visible normals of GGX from a cap of height 1 + k z instead of 1 + z, z the cosine of the
    stretched wo."""
    c, a = g.c, min(w.ax, w.ay, ONE)
    z = c.cos(c.atan(w.along(c, g.po) * c.tan(g.to)))
    s = (1 + c.sin(g.to)) ** 2
    k = (1 - a * a) * s / (s + (a * g.co) ** 2)
    return visible("ggx", g, w) * (1 + z) / (1 + k * z)


def microfacet(g, p, nudge):
    w, name = microfacet_width(g, p), p.get("ndf", "ggx")
    if name == "blinn":
        return half_vector(g, ndf(name, g, w))
    return bounded(g, w) if name == "ggx" else visible(name, g, w)


def metal_rough(g, p, nudge):
    m, f0 = p.get("metalness", 0), p.get("dielectric_f0", f32("0.04"))
    base = sum(colour(p, "base_color", POINT8)) / g.c.mpf(3)
    keys = {"roughness": p.get("roughness", 0.5), "anisotropy": p.get("anisotropy", 0)}
    straight = f0 + (base - f0) * m
    highlight = schlick(straight, g.co, nudge) + g.c.mpf(2) ** -10
    diffuse = (1 - straight) * (1 - m) * base
    both = highlight * bounded(g, width_of(g.c, keys, 4)) + diffuse * g.ci / g.c.pi
    return both / (highlight + diffuse)


DENSITIES = {"lambert": cosine, "oren_nayar": cosine, "toon_diffuse": cosine,
             "toon_specular": cosine, "phong": phong, "blinn_phong": blinn_phong, "ward": ward,
             "microfacet": microfacet, "metal_rough": metal_rough}


def density(c, real, wi, wo, nudge=0, keep_length=False):
    """The density of a material of one lobe, three times; exactly 0 outside the lit gate."""
    if wi[2] <= 0 or wo[2] <= 0:
        return (0,) * 3
    (model, _, params), = real
    name, p = expanded(model, params)
    return three(DENSITIES[name](Geometry.of_directions(c, wi, wo, keep_length), p, nudge))
