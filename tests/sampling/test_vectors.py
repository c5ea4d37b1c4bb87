#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every loop of src/core/draw_kernels.c vectorises: by gcc and by clang, at 16, 32 and 64 bytes,
from the compilers' own reports. gcc's folding of equal functions is off, so that it reports all."""
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys

TREE = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
FLAGS = ["-std=c11", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math",
         "-fopenmp-simd", f"-I{TREE}/src", f"-I{TREE}/include", "-DNDL_ISA=test"]
REPORT = {"gcc": ["-fopt-info-vec-optimized", "-fno-ipa-icf"], "clang": ["-Rpass=loop-vectorize"]}
WIDTHS = {16: ["-march=x86-64"], 32: ["-march=x86-64-v3"],
          64: ["-march=x86-64-v4", "-mprefer-vector-width=512"]}
FOUND = {"gcc": (r"loop vectorized using (\d+) byte", 1),
         "clang": (r"vectorized loop \(vectorization width: (\d+),", 4)}


def samplers():
    """How many samplers there are: the models of their own, and the ndfs."""
    rows = re.findall(r"^MODEL\(", (TREE / "src/core/models.def").read_text(), re.M)
    words = re.search(r'#define NDF_WORDS "([^"]*)"', (TREE / "src/shade/ndf.h").read_text())
    return len(rows) + len(words.group(1).split())


def widths_of_loops(compiler, width):
    run = subprocess.run([compiler, *FLAGS, *REPORT[compiler], *WIDTHS[width], "-c",
                          TREE / "src/core/draw_kernels.c", "-o", os.devnull],
                         check=True, capture_output=True, text=True)
    pattern, scale = FOUND[compiler]
    return [scale * int(many) for many in re.findall(pattern, run.stderr)]


def main():
    if platform.machine() not in ("x86_64", "AMD64"):
        print("skipped: the widths are those of x86-64")
        return 77
    missing = [c for c in REPORT if not shutil.which(c)]
    expected, failed = 2 * samplers() + 1, False  # and the quotient of the weight
    for compiler in (c for c in REPORT if c not in missing):
        for width in WIDTHS:
            wide = widths_of_loops(compiler, width).count(width)
            failed |= wide != expected
            print(f"{compiler}, {width} bytes: {wide} of {expected} loops")
    if failed or len(missing) == len(REPORT):
        return 1
    if missing:
        print(f"skipped: {' '.join(missing)} missing, so its reports were not read")
        return 77
    return 0


if __name__ == "__main__":
    sys.exit(main())
