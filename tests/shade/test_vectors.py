#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every function of src/shade/math.h, and both tables, vectorise inside an `omp simd` loop: by gcc
and by clang, at 16, 32 and 64 bytes, from the compilers' own reports."""
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile

TREE = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
FLAGS = ["-std=c11", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math",
         "-fopenmp-simd", f"-I{TREE}/src"]
REPORT = {"gcc": ["-fopt-info-vec-optimized"], "clang": ["-Rpass=loop-vectorize"]}
WIDTHS = {16: ["-march=x86-64"], 32: ["-march=x86-64-v3"],
          64: ["-march=x86-64-v4", "-mprefer-vector-width=512"]}
ONE = ("exp_ expm1_ log_ log1p_ acos_ sin_ cos_ sin2pi_ cos2pi_ erf_ erfc_ erfinv_ floor_ round_ "
       "sqrt_")
TWO = "pow_ atan2_ min_ max_"


def loops():
    """(name, body of a loop over i) of everything that must vectorise."""
    for name in ONE.split():
        yield name, f"r[i] = {name}(x[i]);"
    for name in TWO.split():
        yield name, f"r[i] = {name}(x[i], y[i]);"
    yield "lut2", "r[i] = lut2(grid, x[i], y[i]);"
    yield "lut1", "vec3 c = lut1(ramp, x[i]); r[i] = c.x; g[i] = c.y; b[i] = c.z;"
    yield "v3_unit", "vec3 c = v3_unit(v3(x[i], y[i], 1.0f)); r[i] = c.x; g[i] = c.y; b[i] = c.z;"
    # libm's expf has no vector form under these flags: gcc must not list it (clang does, as a
    # loop with scalar calls).
    yield "libm", "r[i] = expf(x[i]);"


def source():
    """One loop per line, so that a report's line number names its loop."""
    lines = ['#include <math.h>', '#include <stddef.h>', '#include "shade/math.h"']
    for name, body in loops():
        lines.append(f"void loop_{name}(size_t n, const float *x, const float *y, float *r, "
                     "float *g, float *b, table1 ramp, table2 grid) { _Pragma(\"omp simd\") "
                     f"for (size_t i = 0; i < n; i++) {{ {body} }} }}")
    return "\n".join(lines) + "\n"


def vectorised(compiler, width, folder):
    """Names of the loops that the compiler made `width` bytes wide."""
    unit = pathlib.Path(folder) / "unit.c"
    unit.write_text(source())
    run = subprocess.run([compiler, *FLAGS, *REPORT[compiler], *WIDTHS[width], "-c", unit, "-o",
                          unit.with_suffix(".o")], check=True, capture_output=True, text=True)
    names = [name for name, _ in loops()]
    text, scale = {"gcc": (r"unit\.c:(\d+):.*using (\d+) byte", 1),
                   "clang": (r"unit\.c:(\d+):.*width: (\d+),", 4)}[compiler]
    found = {(names[int(line) - 4], scale * int(many))
             for line, many in re.findall(text, run.stderr)}
    # Gathers may be cheaper at half the width.
    return {name for name, got in found if got == width or (name.startswith("lut") and got >= 16)}


def main():
    if platform.machine() not in ("x86_64", "AMD64"):
        print("skipped: the widths are those of x86-64")
        return 77
    missing = [c for c in REPORT if not shutil.which(c)]
    expected = {name for name, _ in loops()} - {"libm"}
    failed = False
    for compiler in (c for c in REPORT if c not in missing):
        for width in WIDTHS:
            with tempfile.TemporaryDirectory() as folder:
                got = vectorised(compiler, width, folder)
            scalar = sorted(expected - got)
            failed |= bool(scalar) or (compiler == "gcc" and "libm" in got)
            print(f"{compiler}, {width} bytes: {len(got)} loops, "
                  + (f"not {' '.join(scalar)}" if scalar else "all"))
    if failed or len(missing) == len(REPORT):
        return 1
    if missing:
        print(f"skipped: {' '.join(missing)} missing, so its reports were not read")
        return 77
    return 0


if __name__ == "__main__":
    sys.exit(main())
