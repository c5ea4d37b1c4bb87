# SPDX-License-Identifier: Apache-2.0
"""Self-check: the reference must give the numbers that others computed, before it writes any.

Albedo tables (tables.py), normalisation of D, the Smith identity, reciprocity, closed forms, and
single values quoted for the documents' formulas.
"""
import math

from mpmath import fp, mp, mpf

import tables
from geometry import Geometry
from material import Lobe, lift_material
from models import evaluate
from points import UP, Points, polar
from quadrature import HALF_PI, albedo, integral, oren_nayar_albedo
from terms import Width, fresnel, masking, ndf, schlick_g1, smith_lambda

NODES = 12                          # 8e-8 at worst (quadrature.py); most wanted values: 3 digits


class Check:
    def __init__(self):
        self.failed, self.count = 0, 0

    def near(self, what, got, want, tolerance):
        self.count += 1
        if not abs(got - want) <= tolerance:
            self.failed += 1
            print("check failed: %s: %.9g, expected %.9g within %.1g" % (what, got, want,
                                                                         tolerance))

    def cells(self, what, text, columns, value):
        """0.56 units of the last place: two cells of the tables are rounded twice."""
        for i, line in enumerate(tables.cells(text, columns)):
            for j, (want, unit) in enumerate(line):
                self.near("%s row %d column %d" % (what, i, j), value(i, j), want, 0.56 * unit)


def albedo_tables(check):
    for name, masking_name, mapping, text in tables.MICROFACET:
        def cell(i, j):
            alpha = tables.ALPHAS[i]
            keys = tables.microfacet_keys(name, masking_name, mapping, alpha)
            return albedo([("microfacet", None, keys)], math.acos(tables.NV[j]), alpha, NODES,
                          **tables.quadrature_options(masking_name, alpha))
        check.cells("E of %s %s %s" % (name, masking_name, mapping), text, 4, cell)
    for variant, text in tables.WARD:
        check.cells("E of ward " + variant, text, 5, lambda i, j: albedo(
            [("ward", None, {"alpha": tables.WARD_ALPHAS[i], "variant": variant})],
            math.acos(tables.NV_WARD[j]), tables.WARD_ALPHAS[i], NODES))
    for variant, text in tables.OREN_NAYAR:
        check.cells("E of oren_nayar " + variant, text, 4, lambda i, j: oren_nayar_albedo(
            {"sigma": tables.SIGMAS[i], "variant": variant}, 1.0, math.acos(tables.NV[j])))


def ggx_albedo(r_or_alpha, nv, **keys):
    keys = dict({"ndf": "ggx", "fresnel": "none", "f0": 1.0}, **keys)
    return albedo([("microfacet", None, keys)], math.acos(nv), r_or_alpha, NODES)


def closed_albedos(check):
    for c in (1.0, 0.5, 0.1, 0.01):
        want = 1 - c * math.log(1 + 1 / c)
        for m in ("kelemen", "smith_correlated"):
            check.near("E at alpha 1 " + m, ggx_albedo(1.0, c, alpha=1.0, masking=m), want, 1e-8)
    for sigma in (0.3, 1.2):
        t, s2 = 1.1, sigma * sigma
        a, b = 1 - s2 / (2 * (s2 + 0.33)), 0.45 * s2 / (s2 + 0.09)
        want = a + 2 * b / math.pi * (math.sin(t) * (t - math.sin(t) * math.cos(t)) / 2
                                      + math.tan(t) * (1 - math.sin(t) ** 3) / 3)
        check.near("E of oren_nayar", oren_nayar_albedo({"sigma": sigma}, 1.0, t), want, 1e-10)
    four = (("smith_correlated", ".8573 .9158 .6632 .6269"),
            ("smith", ".8551 .9158 .6474 .6269"),
            ("schlick_direct", ".5853 .8598 .5080 .5756"),
            ("schlick_ggx", ".7471 .8951 .5800 .6036"))
    for name, text in four:
        got = [ggx_albedo(r * r, nv, roughness=r, masking=name)
               for r in (0.5, 0.75) for nv in (0.5, 1.0)]
        for g, w in zip(got, text.split()):
            check.near("E of roughness, " + name, g, float(w), 0.56e-4)
    keys = tables.microfacet_keys("beckmann", "cook_torrance", "", 0.3)
    blend = albedo([("microfacet", None, keys)], math.acos(0.8), 0.3, NODES, kinked=True)
    check.near("literal blend", (math.pi + blend) / 2, 2.057, 5e-4)
    check.near("blend with 1/pi", (1 + blend) / 2, 0.986, 5e-4)
    gain = albedo([("metal_rough", None, {"base_color": 1.0, "roughness": 0.3, "metalness": 0.0,
                                          "dielectric_f0": 0.04, "anisotropy": 0.0})],
                  math.acos(0.1), 0.09, NODES)
    check.near("E of metal_rough", gain, 1.28, 5e-3)


def exponent_albedos(check):
    wanted = (("phong", "lecture", "3.1416 1.047 .571 .0622", (1, 5, 10, 100)),
              ("phong", "normalized", "1.000", (10,)),
              ("blinn_phong", "lecture", "5.416 2.062 .246", (1, 10, 100)),
              ("blinn_phong", "normalized", "1.024 1.075 1.018 1.002", (1, 10, 100, 1000)),
              ("blinn_phong", "normalized_exact", "1.000 1.000", (10, 100)))
    for model, variant, text, exponents in wanted:
        for g, ((want, unit),) in zip(exponents, tables.cells(text, 1)):
            got = albedo([(model, None, {"exponent": float(g), "variant": variant, "color": 1.0})],
                         0.0, math.sqrt(2 / (g + 2)), NODES)
            check.near("integral of %s %s %d" % (model, variant, g), got, want, 0.56 * unit)


def distribution_laws(check):
    """int D cos = 1 and the Smith identity cos(to)/int (v.h)+ D = G1(to)."""
    def over_sphere(name, w, to, weight):
        def line(ph):
            def value(th):
                g = Geometry.of_half(fp, th, ph, to)
                return ndf(name, g, w) * weight(g) * math.sin(th)
            scale = math.sqrt(1 / ((math.cos(ph) / w.ax) ** 2 + (math.sin(ph) / w.ay) ** 2))
            marks = [math.atan(scale * 2.0 ** j) for j in range(-2, 7)] + [0.0, HALF_PI]
            edge = HALF_PI - math.atan2(math.sin(to) * abs(math.cos(ph)), math.cos(to))
            return integral(value, marks + [edge], 16)
        steps = [math.atan(w.ay / w.ax * 3.0 ** j) for j in range(-2, 3)] + [0.0, HALF_PI]
        return 2 * integral(line, steps + [math.pi - x for x in steps], 10)

    for name in ("ggx", "beckmann", "blinn"):
        for pair in ((0.3, 0.3), (1.0, 1.0), (0.1, 0.5))[:2 if name == "blinn" else 3]:
            w = Width(*pair)
            total = over_sphere(name, w, 0.0, lambda g: g.ch)
            check.near("int D cos, %s %s" % (name, pair), total, 1, 1e-7)
            if name != "blinn":
                to = 1.2
                visible = over_sphere(name, w, to, lambda g: max(0.0, (
                    math.sin(to) * math.sin(g.th) * math.cos(g.ph) + math.cos(to) * g.ch)))
                g1 = 1 / (1 + smith_lambda(name, fp, w, to, 0.0))
                check.near("Smith identity, " + name, math.cos(to) / visible, g1, 1e-6)


def at_cosines(ci, co):
    """A geometry with these cosines, wi and wo in one plane on opposite sides."""
    ti, to = mp.acos(mpf(ci)), mp.acos(mpf(co))
    return Geometry.of_directions(mp, (-mp.sin(ti), mpf(0), mp.cos(ti)),
                                  (mp.sin(to), mpf(0), mp.cos(to)))


def term_values(check):
    top = Geometry.of_directions(mp, [mpf(x) for x in UP], [mpf(x) for x in UP])
    for alpha, want in ((0.5, 1.273), (0.25, 5.093)):
        check.near("D(n)", ndf("ggx", top, Width(mpf(alpha), mpf(alpha))), want, 6e-4)
    w, g = Width(mpf("0.3"), mpf("0.3")), at_cosines("0.5", "0.8")
    check.near("Lambda(.5)", smith_lambda("ggx", mp, w, g.ti, g.pi), 0.0635, 6e-5)
    check.near("Lambda(.8)", smith_lambda("ggx", mp, w, g.to, g.po), 0.0125, 6e-5)
    check.near("G", masking("smith_correlated", "ggx", g, w), 0.929, 6e-4)
    low, wide = at_cosines("0.01", "0.01"), Width(mpf("0.5"), mpf("0.5"))
    ratio = masking("smith_correlated", "ggx", low, wide) / masking("smith", "ggx", low, wide)
    check.near("correlated over separable", ratio, 13, 0.5)
    grazing = mp.acos(mpf("0.1"))
    check.near("G1 of r = 0", schlick_g1("schlick_direct", mp, Width(w.ax, w.ay, mpf(0)), grazing,
                                         mpf(0)), 0.4706, 1e-4)
    one = Width(mpf(1), mpf(1))
    steep = mp.atan(1 / mpf("1.6"))
    check.near("exact G1 at c = 1.6", 1 / (1 + smith_lambda("beckmann", mp, one, steep, mpf(0))),
               0.9981995, 6e-8)
    tiny = mp.acos(mpf("1e-6"))
    for name, slope in (("schlick_beckmann", 1.2533), ("smith", 3.5449)):
        value = (schlick_g1(name, mp, one, tiny, mpf(0)) if name != "smith" else
                 1 / (1 + smith_lambda("beckmann", mp, one, tiny, mpf(0))))
        check.near("grazing slope " + name, value * 10 ** 6, slope, 1e-4)
    check.near("f0 of 1.5", fresnel(top, {"ior": mpf("1.5")})[0], 0.04, 1e-15)
    check.near("reflectance of k", fresnel(top, {"eta": mpf(2), "k": mpf(3)})[0], 10 / 18, 1e-12)


def whole_values(check):
    def f(wi, wo, model, quantity="brdf", **keys):
        lobe = lift_material([Lobe(model, **keys)])
        return evaluate(mp, lobe, quantity, [mpf(x) for x in wi], [mpf(x) for x in wo])[0]

    check.near("f at the mirror", f(UP, UP, "ggx", alpha=0.01, f0=0.04), 31.8, 0.06)
    ten = math.radians(10)
    for phi, want in ((0, 0.15), (HALF_PI, 3.11)):
        check.near("across and along grooves",
                   f(polar(ten, phi), UP, "ward", alpha_x=0.05, alpha_y=0.5, variant="ward92"),
                   want, 6e-3)
    tilt = polar(math.radians(20), 0)
    for model, g, want in (("phong", 10, 0.537), ("blinn_phong", 40, 0.542),
                           ("blinn_phong", 10, 0.858)):
        check.near("20 degrees off", f(tilt, UP, model, "cos", exponent=g), want, 6e-4)
    wi, wo = polar(0.7, 0.4), polar(1.1, 2.9)
    keys = {"alpha_x": 0.2, "alpha_y": 0.6}
    g = Geometry.of_directions(mp, [mpf(x) for x in wi], [mpf(x) for x in wo])
    eq3 = f(wi, wo, "ward", variant="eq3", **keys)
    kelemen = masking("kelemen", "beckmann", g, None)
    check.near("GM is eq. 3 with Kelemen", f(wi, wo, "ward", **keys) / (eq3 * kelemen), 1, 1e-14)
    flat = f(wi, wo, "ward", variant="ward92", **keys)
    check.near("Ward 1992", eq3 * g.ch ** 4 * mp.sqrt(g.ci * g.co) / flat, 1, 1e-14)
    retro = f(*[(math.sqrt(1 - 1e-6), 0, 1e-3)] * 2, "oren_nayar", color=1.0, sigma=0.5)
    check.near("f(1e-3, 1e-3)", retro * mp.pi - (1 - 0.125 / 0.58), 331, 0.6)
    for variant in ("qualitative", "qualitative57", "full"):
        pair = [f(*p, "oren_nayar", variant=variant) for p in ((wi, wo), (wo, wi))]
        check.near("reciprocity of oren_nayar", pair[0] / pair[1], 1, 1e-14)
    q = Points("check")
    for name in ("ggx", "beckmann"):
        a, b = q.up(0.1), q.up(0.1)
        keys = {"alpha_x": 0.3, "alpha_y": 0.6, "masking": "schlick_ggx"}
        check.near("reciprocity", f(a, b, name, **keys) / f(b, a, name, **keys), 1, 1e-14)


def run():
    """Number of failures; prints each."""
    check = Check()
    for part in (term_values, whole_values, distribution_laws, closed_albedos, exponent_albedos,
                 albedo_tables):
        part(check)
    print("self-check: %d of %d numbers agree" % (check.count - check.failed, check.count))
    return check.failed
