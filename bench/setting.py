# SPDX-License-Identifier: Apache-2.0
"""What the chapters of RESULTS.md share: the programs to ask, and rows of tables."""

import dataclasses
import math
import pathlib

from contest import Mitsuba, Rates

TREE = pathlib.Path(__file__).resolve().parents[1]
ISAS = ["x86-64", "x86-64-v3", "x86-64-v4", "neon"]
NAN = float("nan")
BARS = ["ratio", "measured", "bar", "met"]


@dataclasses.dataclass
class Setting:
    rates: Rates
    mitsuba: Mitsuba | None
    why_not: str
    folder: pathlib.Path
    rounds: int
    seconds: float
    all_cores: set

    def isas(self):
        """The vector instruction sets that this machine has, the best one last."""
        return [
            isa for isa in ISAS if not math.isnan(self.rates.rate(f"brdf {isa} 64 0.001 lambert"))
        ]

    def ours(self, op, isa, n, material, seconds=None):
        return lambda: 1e-6 * self.rates.rate(
            f"{op} {isa} {n} {seconds or self.seconds} {material}"
        )

    def single(self, op, isa, material):
        """Pairs one by one: op is call, ndl_brdf(), or one, ndl_brdf_n() with n = 1."""
        return lambda: 1e-6 * self.rates.rate(f"{op} {isa} {self.seconds} {material}")

    def own(self, name, n):
        return lambda: 1e-6 * self.rates.rate(f"own {name} {n} {self.seconds}")


def verdict(ok):
    return "-" if ok is None else "yes" if ok else "NO"


def bar(what, got, bar_value, at_most=False):
    """One row of a table of bars to meet."""
    if math.isnan(got):
        return [what, "-", f"{'<=' if at_most else '>='} {bar_value:g}", "not measured"]
    return [
        what,
        got,
        f"{'<=' if at_most else '>='} {bar_value:g}",
        verdict(got <= bar_value if at_most else got >= bar_value),
    ]
