#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The programs that bench/run.py compares with compile and compute the same model: the intrinsics
with the library's operations have its bits, the others its values. Every request is answered."""
import math
import os
import pathlib
import platform
import sys
import tempfile

TREE = pathlib.Path(os.environ["NDOTL_SOURCE"])
BUILD = pathlib.Path(os.environ["NDOTL_BUILD"])
sys.path.insert(0, str(TREE / "bench"))
import contest  # noqa: E402
import page  # noqa: E402
import run  # noqa: E402

# Relative, by the arithmetic of a grazing half vector; they differ from the exact values by more
# than the library does.
CLOSE = 1e-4


def same_model(rates):
    for name in ("ceiling_v3_exact", "ceiling_v4_exact"):
        off = rates.rate(f"error {name} 100000")
        assert math.isnan(off) or off == 0, (name, off)
    for name in ("ceiling_v3_fast", "ceiling_v3_mixed", "ceiling_v4_fast", "ceiling_v4_mixed",
                 "naive_plain", "naive_v3", "naive_v4"):
        off = rates.rate(f"error {name} 100000")
        assert math.isnan(off) or 0 < off <= CLOSE, (name, off)


def every_request(rates):
    material = rates.ask("material")
    for line in (f"brdf scalar 100 0.001 {material}", f"cos scalar 7 0.001 {material}",
                 "pdf scalar 64 0.001 ward", "sample scalar 64 0.001 ward",
                 f"lanes scalar 64 0.001 alpha_x,f0.g {material}",
                 f"threads 2 100000 0.001 {material}", f"call scalar 0.001 {material}",
                 f"one scalar 0.001 {material}", "own naive_plain 64 0.001"):
        assert rates.rate(line) > 0, line
    for line in ("brdf scalar 64 0.001 nosuch", "brdf x87 64 0.001 ward", "own nosuch 64 0.001"):
        assert math.isnan(rates.rate(line)), line


def page_text():
    text = page.table(["a", "b"], [["x", float("nan")], ["y", 1234.5]])
    assert text == "| a | b |\n|---|---|\n| x | - |\n| y | 1234 |\n", text
    svg = page.chart("t", "u (1)", [("g", [("ndotl <", 3.0), ("other", float("nan"))])])
    assert "&lt;" in svg and "<title>t</title>" in svg and "MIT-0" in svg, svg


def main():
    if platform.machine() not in ("x86_64", "AMD64"):
        print("skipped: the rivals are written for x86-64")
        return 77
    page_text()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "libndotl.a").symlink_to(BUILD / "libndotl.a")
        program, _ = run.build_rivals(folder)
        rates = contest.Rates([program])
        same_model(rates)
        every_request(rates)
        rates.close()
    print("rivals: the same model, every request answered")
    return 0


if __name__ == "__main__":
    sys.exit(main())
