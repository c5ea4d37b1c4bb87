# SPDX-License-Identifier: Apache-2.0
"""Cases of microfacet, its short names ggx and beckmann, and metal_rough."""
import math

from mpmath import mp

from material import Lobe, lift_material
from points import GATE, UP, mirror, polar, rounded_unit
from rows import Rows
from terms import width_of

NDFS = ("ggx", "beckmann", "blinn")
MASKINGS = ("none", "implicit", "neumann", "cook_torrance", "kelemen", "smith", "smith_correlated",
            "smith_walter", "schlick_beckmann", "schlick_ggx", "schlick_direct")
FRESNELS = ("none", "schlick", "cook_torrance", "dielectric", "conductor")
KINDS = ("burley", "kulla", "openpbr", "gltf")
MAPS = ("square", "direct", "sqrt")
EDGES = ("f_low", "floor", "wo_n", "f_high", "retro", "below_floor", "mirror", "low_wi", "h_low",
         "wide", "gate", "low_mirror", "wi_n", "both_n", "low_wo", "floor", "low_retro", "f_low",
         "gate")


def isotropic_width(q, wide=1.0):
    """A width given by alpha or by roughness in one of its mappings."""
    how = q.pick(("alpha", "alpha", "roughness", "mapped"))
    if how == "alpha":
        return {"alpha": q.log_uniform(0.02, wide)}
    if how == "roughness":
        return {"roughness": q.uniform(0.15, 1)}
    return {"roughness": q.uniform(0.05, 1), "roughness_map": q.pick(MAPS)}


def any_width(q, ndf):
    if ndf == "blinn":
        return isotropic_width(q)
    how = q.pick(("isotropic", "pair", "kind", "kind"))
    if how == "isotropic":
        return isotropic_width(q, 2.0)
    if how == "pair":
        return {"alpha_x": q.log_uniform(0.03, 2), "alpha_y": q.log_uniform(0.03, 2)}
    w = isotropic_width(q)
    w["anisotropy"] = q.uniform(0, 1)
    if q.random.random() < 0.7:
        w["anisotropy_kind"] = q.pick(KINDS)
    return w


def fresnel_keys(q, kind, level="middle"):
    """Parameters of F: random, or its low or high edge."""
    if kind in ("none", "schlick", "cook_torrance"):
        if level != "middle":
            f0 = 0.0 if level == "low" else 1.0
            mixed = kind != "none" and q.random.random() < 0.5
            return {"f0": (f0, q.uniform(0.02, 0.98), f0) if mixed else f0}
        return {"f0": q.colour(0.01) if q.random.random() < 0.6 else q.uniform(0.01, 0.95)}
    if kind == "dielectric":
        if level == "low":
            return {"ior": 1.0} if q.random.random() < 0.5 else {"eta": q.uniform(1.05, 1.2)}
        if level == "high":
            return {"ior": q.uniform(0.3, 0.7)}
        return {q.pick(("ior", "ior", "eta")): q.pick((q.uniform(1.1, 3), q.uniform(0.4, 0.9)))}
    if level == "low":
        return {"eta": q.uniform(1.2, 2.5), "k": 0.0}
    if level == "high":
        return {"eta": (0.05, q.uniform(0.1, 0.5), q.uniform(0.3, 0.8)), "k": (0.0, 0.0, 8.0)}
    return {"eta": tuple(q.uniform(0.1, 3) for _ in range(3)),
            "k": tuple(q.uniform(0.5, 7) for _ in range(3))}


def named(kind, keys):
    """The fresnel word, left out now and then where the keys imply it."""
    return {"fresnel": kind, **keys}


def lobe_width(lobe):
    p = lift_material([lobe])[0][2]
    w = width_of(mp, p, 1 if lobe.model == "blinn" or p.get("ndf") == "blinn" else 4)
    return float(w.ax), float(w.ay)


def random_case(rows, lobe, quantity):
    """Two of three pairs inside the lobe, else uniform (one in ten of those below)."""
    q = rows.points
    if q.random.random() < 2 / 3:
        wi, wo = q.lobe_pair(*lobe_width(lobe))
    else:
        wi, wo = q.pair()
    return [lobe], quantity, wi, wo


def narrow_pair(q, alpha):
    """Exact mirror, near the normal, or a tenth of the width off: k stays below 1000."""
    how = q.pick(("mirror", "normal", "normal", "off"))
    if how == "mirror":
        return q.edge("mirror")
    if how == "normal":
        return q.near_normal(alpha)
    wo = q.up(0.5)
    return mirror(wo, rounded_unit((0.05 * alpha, 0.05 * alpha, 1))), wo


def edge_case(rows, name, head, ndf, kind):
    """head: the keys that fix the combination. Returns lobes, wi, wo."""
    q = rows.points
    if name == "low_retro" and ndf == "beckmann":
        name = "h_low"              # its tail is 0 in float at such a slope
    level = {"f_low": "low", "f_high": "high"}.get(name, "middle")
    keys = fresnel_keys(q, kind, level)
    width = any_width(q, ndf)
    if name in ("floor", "below_floor"):
        width = q.pick(({"alpha": 1e-3}, {"alpha": 1e-3}) if name == "floor" else
                       ({"alpha": 0.0}, {"roughness": 0.0}, {"alpha": 1e-5},
                        {"alpha": 0.0}))
        pair = narrow_pair(q, 1e-3)
    elif name == "wide":
        width = ({"alpha": 1.0} if ndf == "blinn" else
                 q.pick(({"alpha": 4.0}, {"alpha_x": 4.0, "alpha_y": q.uniform(0.1, 1)},
                         {"alpha": 4.0, "anisotropy": q.uniform(0.3, 0.9)})))
        pair = q.up(), q.up()
    elif name == "h_low":
        tangent = {"ggx": 30.0, "beckmann": 8.0, "blinn": 20.0}[ndf]
        width = {"alpha": q.uniform(0.6, 1) if ndf == "blinn" else q.uniform(2, 4)}
        pair = q.h_low(tangent)
    elif name in ("f_low", "f_high"):
        pair = q.lobe_pair(*lobe_width(Lobe("microfacet", ndf=ndf, **width)))
    elif name == "gate":
        pair = q.edge(q.pick(GATE))
    else:
        wide = name.startswith("low") or name in ("retro", "wo_n", "wi_n")
        if wide and ndf == "beckmann":
            width = {"alpha": q.uniform(0.5, 2)}
        elif wide:
            width = {"alpha": q.uniform(0.7, 1)}
        pair = q.edge(name)
    return [Lobe(**head, **named(kind, keys), **width)], *pair


def combination(rows, ndf, masking, kind, number):
    q = rows.points
    head = {"model": "microfacet", "ndf": ndf, "masking": masking}
    quantities = ["brdf"] * 4 + ["cos"] * 2 + [("D", "G", "V", "F")[number % 4],
                                               ("V", "F", "G", "D")[number % 4]]

    def random_one(quantity):
        keys = named(kind, fresnel_keys(q, kind))
        if q.random.random() < 0.25:
            keys["color"] = q.colour()
        return random_case(rows, Lobe(**head, **keys, **any_width(q, ndf)), quantity)

    for quantity in quantities:
        rows.draw(lambda: random_one(quantity))
    for i in range(4):
        name = EDGES[(4 * number + i) % len(EDGES)]

        def edge_one():
            lobes, wi, wo = edge_case(rows, name, head, ndf, kind)
            return lobes, q.pick(("brdf", "brdf", "cos")), wi, wo
        rows.draw(edge_one)


def term_rows(rows):
    """D, G, V and F alone, with their edges."""
    q = rows.points
    for ndf in NDFS:
        for _ in range(12):
            rows.draw(lambda: random_case(rows, Lobe("microfacet", ndf=ndf, **any_width(q, ndf)),
                                          "D"))
        for alpha in (0.0, 1e-3, 0.01, 0.1, 0.3, 0.5, 1.0):
            rows.add([Lobe("microfacet", ndf=ndf, alpha=alpha)], "D", *q.edge("mirror"))
            rows.draw(lambda: ([Lobe("microfacet", ndf=ndf, alpha=alpha)], "D",
                               *q.near_normal(max(alpha, 1e-3))))
        for masking in MASKINGS:
            def one(quantity, name):
                width = any_width(q, ndf)
                pair = q.edge(name) if name else (q.up(), q.up())
                return [Lobe("microfacet", ndf=ndf, masking=masking, **width)], quantity, *pair
            for quantity in ("G", "V"):
                for name in (None, None, q.pick(("wo_n", "wi_n", "both_n")),
                             q.pick(("low_wi", "low_wo", "low_mirror", "retro"))):
                    rows.draw(lambda: one(quantity, name))
    for kind in FRESNELS:
        for level in ("middle",) * 6 + ("low",) * 3 + ("high",) * 3:
            rows.draw(lambda: ([Lobe("microfacet", **named(kind, fresnel_keys(q, kind, level)))],
                               "F", q.up(), q.up()))
        for name in ("both_n", "retro", "low_mirror"):
            keys = fresnel_keys(q, kind)
            rows.draw(lambda: ([Lobe("microfacet", **named(kind, keys))], "F", *q.edge(name)))
    special_rows(rows)


def special_rows(rows):
    """Named points: no interface at all, normal incidence at f0 = 0, grooves, the S2 model."""
    q = rows.points
    for keys in ({"ior": 1.0}, {"fresnel": "conductor", "eta": 1.0, "k": 0.0}, {"f0": 0.0},
                 {"fresnel": "cook_torrance", "f0": 0.0}):
        for quantity in ("F", "brdf"):
            rows.add([Lobe("microfacet", **keys)], quantity, UP, UP)
    rows.add([Lobe("microfacet", ior=1.0)], "F", *q.edge("mirror"))
    ten = math.radians(10)
    for phi in (0.0, math.pi / 2):
        rows.add([Lobe("microfacet", alpha_x=0.05, alpha_y=0.5, f0=1.0)], "brdf",
                 polar(ten, phi), UP)
    for r in (0.1, 0.3, 0.5, 0.8, 1.0):
        lobe = Lobe("microfacet", roughness=r, roughness_map="direct", masking="schlick_direct")
        for quantity in ("brdf", "V"):
            rows.draw(lambda: random_case(rows, lobe, quantity))


def microfacet():
    rows, number = Rows("microfacet"), 0
    for ndf in NDFS:
        for masking in MASKINGS:
            for kind in FRESNELS:
                combination(rows, ndf, masking, kind, number)
                number += 1
    term_rows(rows)
    return rows


def short_name(model):
    """The defaults, every masking and fresnel by default rules, and the edges."""
    rows = Rows(model)
    q = rows.points

    def random_one():
        lobe = Lobe(model, **some_keys(), **any_width(q, model))
        return random_case(rows, lobe, q.pick(("brdf", "brdf", "cos", "D", "G", "V", "F")))

    def some_keys():
        keys = {} if q.random.random() < 0.4 else {"masking": q.pick(MASKINGS)}
        kind = q.pick(FRESNELS)
        f = fresnel_keys(q, kind)
        implied = "ior" in f or "k" in f or kind == "schlick"
        keys.update(f if implied and q.random.random() < 0.6 else named(kind, f))
        if q.random.random() < 0.3:
            keys["color"] = q.colour()
        return keys

    for quantity in ("brdf", "cos", "scanline", "D", "G", "V", "F"):
        rows.draw(lambda: ([Lobe(model)], quantity, *q.lobe_pair(0.3, 0.3)))
    for _ in range(60):
        rows.draw(random_one)
    for i in range(45):
        name = EDGES[i % len(EDGES)]

        def edge_one():
            lobes, wi, wo = edge_case(rows, name, {"model": model}, model,
                                      FRESNELS[(i // 3) % 5])
            return lobes, q.pick(("brdf", "cos")), wi, wo
        rows.draw(edge_one)
    return rows


def metal_rough():
    rows = Rows("metal_rough")
    q = rows.points

    def keys(**fixed):
        out = {"base_color": q.colour() if q.random.random() < 0.7 else q.uniform(0.05, 1),
               "metalness": q.pick((0.0, 1.0, q.uniform(0, 1))), "roughness": q.uniform(0.15, 1)}
        if q.random.random() < 0.4:
            out["anisotropy"] = q.uniform(0, 1)
        if q.random.random() < 0.3:
            out["dielectric_f0"] = q.uniform(0.02, 0.2)
        out.update(fixed)
        return out

    for quantity in ("brdf", "cos", "scanline"):
        rows.draw(lambda: ([Lobe("metal_rough")], quantity, q.up(), q.up()))
    for _ in range(60):
        def random_one():
            lobe = Lobe("metal_rough", **keys())
            a = max(lobe.params["roughness"] ** 2, 1e-3)
            wi, wo = q.pair() if q.random.random() < 0.5 else q.lobe_pair(a, a)
            return [lobe], q.pick(("brdf", "brdf", "cos", "scanline")), wi, wo
        rows.draw(random_one)
    for name in ("mirror", "wo_n", "wi_n", "both_n", "retro", "low_wi", "low_wo", "low_mirror",
                 "low_retro") * 3 + GATE:
        rows.draw(lambda: ([Lobe("metal_rough", **keys())], q.pick(("brdf", "cos")),
                           *q.edge(name)))
    for fixed in ({"roughness": 0.0}, {"roughness": 0.031622775}, {"roughness": 0.01}):
        for _ in range(3):
            rows.draw(lambda: ([Lobe("metal_rough", **dict(keys(**fixed), anisotropy=0.0))],
                               "brdf", *narrow_pair(q, 1e-3)))
    for fixed in ({"dielectric_f0": 0.0, "metalness": 0.0}, {"dielectric_f0": 1.0},
                  {"base_color": 1.0, "metalness": 1.0}, {"base_color": 0.0},
                  {"base_color": 0.0, "metalness": 1.0}, {"anisotropy": 1.0}):
        for _ in range(2):
            rows.draw(lambda: ([Lobe("metal_rough", **keys(**fixed))], "cos", q.up(), q.up()))
    return rows
