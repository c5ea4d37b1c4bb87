# SPDX-License-Identifier: Apache-2.0
"""The golden files by name: each entry returns (text, one-line summary, covered row ids)."""
import cases_albedo
import cases_conversions
import cases_microfacet as m
import cases_pdf
import cases_small as s
from tags import REQUIRED


def of_rows(make, what):
    def build():
        rows = make()
        summary = "%d rows, largest k %.3g, %.2f %% above 1000" % (
            len(rows.k), max(rows.k), 100 * rows.share())
        return rows.text(what), summary, rows.covered
    return build


FILES = {
    "lambert": of_rows(s.lambert, "lambert"),
    "oren_nayar": of_rows(s.oren_nayar, "oren_nayar (variant=table: the qualitative closed form)"),
    "toon_diffuse": of_rows(s.toon_diffuse, "toon_diffuse"),
    "toon_specular": of_rows(s.toon_specular, "toon_specular"),
    "phong": of_rows(s.phong, "phong"),
    "blinn_phong": of_rows(s.blinn_phong, "blinn_phong"),
    "ward": of_rows(s.ward, "ward"),
    "microfacet": of_rows(m.microfacet, "microfacet and its terms"),
    "ggx": of_rows(lambda: m.short_name("ggx"), "ggx, short for microfacet(ndf=ggx)"),
    "beckmann": of_rows(lambda: m.short_name("beckmann"),
                        "beckmann, short for microfacet(ndf=beckmann)"),
    "metal_rough": of_rows(m.metal_rough, "metal_rough"),
    "sums": of_rows(s.sums, "weighted sums"),
    "pdf": of_rows(cases_pdf.pdf, "densities of the samplers"),
    "albedo": cases_albedo.build,
    "conversions": cases_conversions.build,
}


def uncovered(covered):
    return [row for row in REQUIRED if row not in covered]
