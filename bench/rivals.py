# SPDX-License-Identifier: Apache-2.0
"""Chapters of RESULTS.md: the library against others. Each returns Markdown and groups of bars."""

import math

from contest import Contest
from page import number, table
from setting import BARS, bar

SIZES = {"512": "from the first cache", "16384": "from the second", "1000000": "1 M pairs"}


FLAGSHIP = """## The flagship

`{material}`: correlated Smith, Schlick in RGB.
`ceiling_*` are written in intrinsics (bench/ceiling.inc): `exact` with the operations of the
library, `fast` and `mixed` with estimates, one Newton step and fused multiply-adds. `naive_*` is a
textbook loop (bench/naive.c) at -O3 -fno-math-errno. The last column compares with the exact table,
relative, over 100000 pairs, grazing ones included.

"""
MITSUBA = """## Mitsuba 3

Mitsuba {version}, variant llvm_ad_rgb, one thread, warm, synchronised, inputs resident; the faster
of a plain call and one recorded with dr.freeze. Its roughconductor has separable Smith masking and,
for Beckmann, Walter's fit, whose excess over 1 (6e-5 for each direction) ndotl cuts off. Both
compute f cos.

"""


def flagship(s):
    """Anisotropic GGX against intrinsics, a naive loop and scalar."""
    material, best = s.rates.ask("material"), s.isas()[-1]
    level = "v4" if best == "x86-64-v4" else "v3"
    rivals = [
        "ceiling_v4_exact",
        "ceiling_v4_fast",
        "ceiling_v4_mixed",
        "ceiling_v3_exact",
        "ceiling_v3_fast",
        "ceiling_v3_mixed",
        "naive_plain",
        "naive_v3",
        "naive_v4",
    ]
    results = {}
    for n in SIZES:
        entrants = {
            f"ndotl {isa}": s.ours("brdf", isa, n, material) for isa in ["scalar", *s.isas()]
        }
        entrants |= {name: s.own(name, n) for name in rivals}
        results[n] = Contest(entrants, s.rounds)
    rows = [[name] + [results[n][name] for n in SIZES] for name in results["512"].rates]
    errors = {name: s.rates.rate(f"error {name} 100000") for name in rivals}
    for row in rows:
        row.append(
            "same bits"
            if errors.get(row[0]) == 0
            else f"{errors[row[0]]:.1e}" if row[0] in errors else ""
        )
    small, ours = results["512"], f"ndotl {best}"
    naive = max(
        small[name]
        for name in ("naive_plain", "naive_v3", "naive_v4")
        if not math.isnan(small[name])
    )
    ceiling = max(small[f"ceiling_{level}_fast"], small[f"ceiling_{level}_mixed"])
    bars = [
        bar(
            f"exact over intrinsics with the same arithmetic ({level}), 512 pairs",
            small.ratio(ours, f"ceiling_{level}_exact"),
            0.9,
        ),
        bar("the same, 16384 pairs", results["16384"].ratio(ours, f"ceiling_{level}_exact"), 0.9),
        bar("exact over the scalar loop", small.ratio(ours, "ndotl scalar"), 8),
        bar("exact over the fastest naive loop", small[ours] / naive, 2.5),
    ]
    head = ["M/s", *(f"{n} pairs, {what}" for n, what in SIZES.items()), "largest difference"]
    text = FLAGSHIP.format(material=material) + table(head, rows) + "\n" + table(BARS, bars)
    text += f"\nThe exact table reaches {number(small[ours] / ceiling)} of the best of them.\n"
    shown = [ours, "ndotl scalar", f"ceiling_{level}_exact", f"ceiling_{level}_fast", "naive_plain"]
    return text, [("GGX anisotropic, 512 pairs", [(name, small[name]) for name in shown])]


def peers(s):
    """The same batch through Mitsuba 3's LLVM backend."""
    if not s.mitsuba:
        return f"## Mitsuba 3\n\nNot measured: {s.why_not}\n", []
    about, best = s.mitsuba.call("names"), s.isas()[-1]
    needed = {
        "GGX anisotropic, F constant": (3, 1.5),
        "GGX gold": (2, 1.4),
        "Beckmann gold": (2, 1.4),
        "principled, metallic 1": (2, 1.4),
        "diffuse": (1, 1),
    }
    rows, bars, groups = [], [], []
    for name in about["names"]:
        agree = s.mitsuba.call(f"agree {name}")
        line, chart = [f"{name}<br>`{agree['material']}`"], []
        for n, least in zip((16384, 1000000), needed[name]):
            got = Contest(
                {
                    "ndotl": s.ours("cos", best, n, agree["material"]),
                    "Mitsuba": lambda: 1e-6
                    * s.mitsuba.call(f"time {name} {n} {2 * s.seconds}")["rate"],
                },
                s.rounds,
            )
            line += [got["ndotl"], got["Mitsuba"], got.ratio("ndotl", "Mitsuba")]
            bars.append(bar(f"{name}, {n} pairs", got.ratio("ndotl", "Mitsuba"), least))
            chart += [(f"ndotl, {n} pairs", got["ndotl"]), (f"Mitsuba, {n} pairs", got["Mitsuba"])]
        rows.append(line + [f"{agree['difference']:.1e}" if agree["same"] else "other model"])
        groups.append((name, chart))
    head = ["model", "ndotl, 16384", "Mitsuba", "ratio", "ndotl, 1 M", "Mitsuba", "ratio"]
    text = MITSUBA.format(version=about["version"])
    text += table([*head, "largest relative difference"], rows) + "\n" + table(BARS, bars)
    return text, groups
