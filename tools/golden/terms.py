# SPDX-License-Identifier: Apache-2.0
"""D, G and F of the microfacet models in their textbook angle forms. Cosine of the surface: none.

Sources: D and Lambda [Walter07] [Heitz14]; V-cavity G [CookTorrance82]; Kelemen [Kelemen01];
Neumann [Neumann99]; Schlick's F and G1 [Schlick94] with the k of [Karis13]; anisotropy mappings
[Burley12] [Kulla17] [OpenPBR24] [KHRAniso]; F from f0 [CookTorrance82].
"""
from mpmath import mpf

from material import f32

FLOOR = mpf(f32("0.001"))          # alpha below acts as this
DEFAULT_ALPHA, DEFAULT_F0 = mpf(f32("0.3")), mpf(f32("0.04"))


class Width:
    """alpha_x, alpha_y and the roughness that masking=schlick_direct takes (None: from alpha)."""

    def __init__(self, ax, ay, roughness=None):
        self.ax, self.ay, self.roughness = ax, ay, roughness

    def along(self, c, phi):
        """alpha projected on the azimuth phi."""
        if self.ax == self.ay:
            return self.ax
        return c.sqrt((self.ax * c.cos(phi)) ** 2 + (self.ay * c.sin(phi)) ** 2)


def roughness_to_alpha(c, r, mapping):
    return {"square": lambda: r * r, "direct": lambda: r, "sqrt": lambda: c.sqrt(r)}[mapping]()


def anisotropic(c, alpha, a, kind):
    """(alpha_x, alpha_y) of one width and an anisotropy a in [0, 1]."""
    if kind == "burley":
        aspect = c.sqrt(1 - c.mpf(9) / 10 * a)
        return alpha / aspect, alpha * aspect
    if kind == "kulla":
        return alpha * (1 + a), alpha * (1 - a)
    if kind == "openpbr":
        ax = alpha * c.sqrt(2 / (1 + (1 - a) ** 2))
        return ax, (1 - a) * ax
    if kind == "gltf":
        return alpha + (1 - alpha) * a * a, alpha
    raise ValueError(kind)


def width_of(c, p, top):
    """Width from the keys of a material; [FLOOR, top] applies after the conversion."""
    if "alpha_x" in p:
        ax, ay, given = p["alpha_x"], p["alpha_y"], None
    else:
        given = p.get("roughness")
        alpha = (p.get("alpha", DEFAULT_ALPHA) if given is None else
                 roughness_to_alpha(c, given, p.get("roughness_map", "square")))
        ax, ay = anisotropic(c, alpha, p.get("anisotropy", 0),
                             p.get("anisotropy_kind", "burley"))
    ax, ay = (min(max(a, FLOOR), top + 0 * a) for a in (ax, ay))
    return Width(ax, ay, given if ax == ay else None)


def slope_term(g, w):
    """tan^2(th) (cos^2 ph/ax^2 + sin^2 ph/ay^2): the squared slope of h in units of the width."""
    c = g.c
    return c.tan(g.th) ** 2 * ((c.cos(g.ph) / w.ax) ** 2 + (c.sin(g.ph) / w.ay) ** 2)


def ndf(name, g, w):
    c = g.c
    if name == "ggx":
        return 1 / (c.pi * w.ax * w.ay * g.ch ** 4 * (1 + slope_term(g, w)) ** 2)
    if name == "beckmann":
        return c.exp(-slope_term(g, w)) / (c.pi * w.ax * w.ay * g.ch ** 4)
    if name == "blinn":
        return g.ch ** (2 / w.ax ** 2 - 2) / (c.pi * w.ax ** 2)
    raise ValueError(name)


def smith_lambda(name, c, w, theta, phi):
    tangent = w.along(c, phi) * c.tan(theta)
    if tangent == 0:
        return tangent
    if name == "ggx":
        return (c.sqrt(1 + tangent ** 2) - 1) / 2
    a = 1 / tangent
    return (c.erf(a) - 1) / 2 + c.exp(-a * a) / (2 * a * c.sqrt(c.pi))


def walter_g1(c, w, theta, phi):
    tangent = w.along(c, phi) * c.tan(theta)
    if tangent * c.mpf("1.6") <= 1:
        return 1 + 0 * tangent
    a = 1 / tangent
    above = c.mpf("3.535") * a + c.mpf("2.181") * a * a
    fit = above / (1 + c.mpf("2.276") * a + c.mpf("2.577") * a * a)
    return min(fit, 1 + 0 * fit)


def schlick_g1(name, c, w, theta, phi):
    alpha, cosine = w.along(c, phi), c.cos(theta)
    if name == "schlick_beckmann":
        k = alpha * c.sqrt(2 / c.pi)
    elif name == "schlick_ggx":
        k = alpha / 2
    else:
        r = c.sqrt(alpha) if w.roughness is None else w.roughness
        k = (r + 1) ** 2 / 8
    return cosine / (cosine * (1 - k) + k)


def masking(name, ndf_name, g, w):
    """G(wi, wo, h), unitless."""
    c, one = g.c, 1 + 0 * g.ci
    if name == "none":
        return one
    if name == "implicit":
        return g.ci * g.co
    if name == "neumann":
        return g.ci * g.co / max(g.ci, g.co)
    if name == "cook_torrance":
        return min(one, 2 * g.ch * g.co / g.cd, 2 * g.ch * g.ci / g.cd)
    if name == "kelemen":
        return g.ci * g.co / g.cd ** 2
    if name in ("smith", "smith_correlated"):
        i = smith_lambda(ndf_name, c, w, g.ti, g.pi)
        o = smith_lambda(ndf_name, c, w, g.to, g.po)
        return 1 / ((1 + i) * (1 + o)) if name == "smith" else 1 / (1 + i + o)
    if name == "smith_walter":
        return walter_g1(c, w, g.ti, g.pi) * walter_g1(c, w, g.to, g.po)
    if name.startswith("schlick_"):
        return schlick_g1(name, c, w, g.ti, g.pi) * schlick_g1(name, c, w, g.to, g.po)
    raise ValueError(name)


def fresnel_kind(p):
    if "fresnel" in p:
        return p["fresnel"]
    return "conductor" if "k" in p else "dielectric" if "ior" in p else "schlick"


def three(value):
    return value if isinstance(value, tuple) else (value, value, value)


def schlick(f0, cosine, nudge):
    """nudge moves the cosine by a relative amount where f0 = 0 (see condition.py)."""
    if f0 == 0:
        cosine = cosine * (1 + nudge)
    return f0 + (1 - f0) * (1 - cosine) ** 5


def from_f0(c, f0, cosine):
    if f0 == 0 or f0 == 1:
        return f0
    eta = (1 + c.sqrt(f0)) / (1 - c.sqrt(f0))
    g = c.sqrt(eta ** 2 + cosine ** 2 - 1)
    second = ((g + cosine) * cosine - 1) / ((g - cosine) * cosine + 1)
    return ((g - cosine) / (g + cosine)) ** 2 * (1 + second ** 2) / 2


def dielectric(c, ior, td):
    """Mean of the two polarisations; sin(td) >= ior is total internal reflection."""
    sine = c.sin(td) / ior
    if sine >= 1:
        return 1 + 0 * sine
    ci, ct = c.cos(td), c.cos(c.asin(sine))
    return (((ci - ior * ct) / (ci + ior * ct)) ** 2
            + ((ior * ci - ct) / (ior * ci + ct)) ** 2) / 2


def conductor(c, eta, k, td):
    """The same with the complex index eta + i k and Snell's law in complex numbers."""
    n = c.mpc(eta, k)
    ci, ct = c.cos(td), c.sqrt(1 - (c.sin(td) / n) ** 2)
    s = abs((ci - n * ct) / (ci + n * ct)) ** 2
    p = abs((n * ci - ct) / (n * ci + ct)) ** 2
    return (s + p) / 2


def fresnel(g, p, nudge=0):
    """F(wi, h) per channel."""
    c, kind = g.c, fresnel_kind(p)
    if kind == "dielectric":
        return three(dielectric(c, p["ior"] if "ior" in p else p["eta"], g.td))
    if kind == "conductor":
        pairs = zip(three(p["eta"]), three(p["k"]))
        return tuple(conductor(c, eta, k, g.td) for eta, k in pairs)
    f0 = three(p.get("f0", DEFAULT_F0))
    if kind == "none":
        return f0
    if kind == "schlick":
        return tuple(schlick(f, g.cd, nudge) for f in f0)
    return tuple(from_f0(c, f, g.cd) for f in f0)
