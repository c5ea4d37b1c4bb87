#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The functions of src/shade/math.h give the same bits from every compiler, optimisation level and
instruction set of this machine (tests/shade/bits.c, a million inputs each)."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

TREE = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
FLAGS = ["-std=c11", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math",
         "-fopenmp-simd", f"-I{TREE}/src"]
VARIANTS = {
    "-O0": [],
    "-O3": [],
    "-O3 -mavx2 -mfma": ["avx2", "fma"],
    "-O3 -march=x86-64-v4 -mprefer-vector-width=512": ["avx512f", "avx512dq", "avx512bw",
                                                       "avx512cd", "avx512vl"],
}


def cpu_features():
    try:
        lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return set()
    return set(next((line for line in lines if line.startswith("flags")), "").split())


def hashes(compiler, options, folder):
    """{function: hash} of one build."""
    program = pathlib.Path(folder) / "bits"
    subprocess.run([compiler, *FLAGS, *options.split(), TREE / "tests/shade/bits.c",
                    "-o", program, "-lm"], check=True)
    text = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    return dict(line.split() for line in text.splitlines())


def main():
    features = cpu_features()
    missing = [c for c in ("gcc", "clang") if not shutil.which(c)]
    first, first_name, failed = None, "", False
    for compiler in ("gcc", "clang"):
        for options, needed in VARIANTS.items():
            name = f"{compiler} {options}"
            if compiler in missing or not set(needed) <= features:
                print(f"not run: {name}")
                continue
            with tempfile.TemporaryDirectory() as folder:
                got = hashes(compiler, options, folder)
            first, first_name = first or got, first_name or name
            differ = [f for f in first if got.get(f) != first[f]]
            failed |= bool(differ) or len(got) != len(first)
            print(f"{name}: {len(got)} functions, "
                  + (f"differs from {first_name} in {' '.join(differ)}" if differ else "same bits"))
    if "gcc" not in missing and {"avx2", "fma"} <= features:
        with tempfile.TemporaryDirectory() as folder:
            contracted = hashes("gcc", "-O3 -mavx2 -mfma -ffp-contract=fast", folder)
        if contracted == first:
            print("contraction changes no bit: the comparison is blind")
            failed = True
    if failed or first is None:
        return 1
    if missing:
        print(f"skipped: {' '.join(missing)} missing, so its builds were not compared")
        return 77
    return 0


if __name__ == "__main__":
    sys.exit(main())
