# SPDX-License-Identifier: Apache-2.0
"""albedo.csv: directional albedos (quantity albedo, wi unused) with an error below 1e-10."""
import math

from material import Lobe, f32, lift_material, material_text, number_text
from points import rounded_unit
from quadrature import albedo, angle, floats, oren_nayar_albedo
from rows import HEADER
import tables

NODES = 28


def view(nv):
    return rounded_unit((math.sqrt(1 - nv * nv), 0.0, nv))


class Albedos:
    def __init__(self):
        self.lines, self.covered = [], set()

    def add(self, lobe, tags, nv, value_at):
        """value_at(lifted floats, angle of wo) is computed at the float-rounded wo."""
        wo = view(nv)
        value = value_at(floats(lift_material([lobe])), angle(wo))
        fields = [tags, '"%s"' % material_text([lobe]), "albedo", "0", "0", "0"]
        fields += [number_text(x) for x in wo] + ["%.12g" % value] * 3 + ["0"] * 3
        self.lines.append(",".join(fields))
        self.covered.update(tags.split())


def microfacets(out):
    tags = {"none": "S2.14 S4.1", "schlick_direct": "S2.19", "schlick_ggx": "S2.19 S3.17",
            "smith_correlated": "S2.19"}
    for ndf, masking, mapping, _ in tables.MICROFACET:
        for alpha in tables.ALPHAS:
            lobe = Lobe("microfacet", **tables.microfacet_keys(ndf, masking, mapping, alpha))
            options = tables.quadrature_options(masking, f32(alpha))
            for nv in tables.NV:
                out.add(lobe, tags.get(masking, "S4.1"), nv,
                        lambda real, to: albedo(real, to, alpha, NODES, **options))
    for r in (0.5, 0.75):
        lobe = Lobe("microfacet", fresnel="none", f0=1.0, roughness=r)
        for nv in (1.0, 0.5):
            out.add(lobe, "S2.19 S3.1", nv, lambda real, to: albedo(real, to, r * r, NODES))


def others(out):
    for variant, _ in tables.WARD:
        for alpha in tables.WARD_ALPHAS:
            lobe = Lobe("ward", color=1.0, alpha=alpha, variant=variant)
            for nv in tables.NV_WARD:
                out.add(lobe, "S1.13" if variant == "eq3" else "S4.40", nv,
                        lambda real, to: albedo(real, to, alpha, NODES))
    for variant, _ in tables.OREN_NAYAR:
        for sigma in tables.SIGMAS:
            lobe = Lobe("oren_nayar", color=1.0, sigma=min(sigma, 1.57079625), variant=variant)
            for nv in tables.NV:
                out.add(lobe, "S4.29", nv,
                        lambda real, to: oren_nayar_albedo(real[0][2], 1.0, to))
    for exponent in (1.0, 10.0, 100.0, 1000.0):
        scale = math.sqrt(2 / (exponent + 2))
        for model, variant, views in (
                ("phong", "lecture", (1.0,)), ("phong", "normalized", (1.0,)),
                ("blinn_phong", "lecture", (1.0, 0.5)), ("blinn_phong", "normalized", (1.0, 0.5)),
                ("blinn_phong", "normalized_exact", (1.0, 0.5))):
            lobe = Lobe(model, color=1.0, exponent=exponent, variant=variant)
            for nv in views:
                out.add(lobe, "S4.22" if model == "phong" else "S4.25", nv,
                        lambda real, to: albedo(real, to, scale, NODES))
    for roughness, nv in ((0.3, 0.1), (0.3, 1.0), (0.7, 0.5)):
        lobe = Lobe("metal_rough", base_color=1.0, roughness=roughness)
        out.add(lobe, "S2.1", nv, lambda real, to: albedo(real, to, roughness ** 2, NODES))
    out.add(Lobe("lambert", color=0.5), "S2.3", 0.5, lambda real, to: 0.5)


def build():
    out = Albedos()
    microfacets(out)
    others(out)
    head = ["# SPDX-License-Identifier: Apache-2.0",
            "# Directional albedo of wo (ox oy oz); wx wy wz unused; error below 1e-10.",
            "# Made by: tools/golden/generate.py albedo", HEADER]
    return ("\n".join(head + out.lines) + "\n", "%d rows" % len(out.lines), out.covered)
