#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""No kernel went scalar unnoticed: in the object files of every instruction set, the loops of every
kernel store vectors of the full width and hold almost no scalar float operation.

Prints a table of what was found. With --bites, the test is shown to refuse the scalar kernels.
"""

import os
import pathlib
import platform
import re
import sys

TREE = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
BUILD = pathlib.Path(os.environ.get("NDOTL_BUILD", TREE / "build/release"))
sys.path.insert(0, str(TREE / "tools"))
import kernel_code  # noqa: E402

# Instruction set: lanes of its widest register.
ISAS = {"x86_64": 4, "v3": 8, "v4": 16}
PATTERN = r"(brdf|fused|ndf|masking|fresnel|sample|pdf|brdf_cos_pdf)_"
# clang takes several vectors at once where the formula is short, and what is left of a batch by a
# scalar loop, beside the wide one; gcc has no such loop here.
IS_CLANG = "clang" in os.environ.get("NDOTL_CC", "gcc")
# Compilers put what does not change from lane to lane in front of a loop,
# sometimes of an outer one.
MOST_SCALAR = 4


def objects(isa):
    """The object files compiled with NDL_ISA=<isa>."""
    found = sorted((BUILD / f"CMakeFiles/ndotl_kernels_{isa}.dir").glob("**/*.o"))
    if not found:
        sys.exit(f"no object files of {isa} in {BUILD}")
    return found


def wanted_names():
    """What kernels.c must contain: a kernel for each K(...) row and each FUSED(...) row."""
    fused = re.findall(
        r"^FUSED\((\w+), (\w+), (\w+)\)", (TREE / "src/core/fused.def").read_text(), re.M
    )
    names = {f"fused_{'_'.join(row)}" for row in fused}
    for header in (TREE / "src/shade").glob("*.h"):
        for macro in re.findall(r"#define \w+_KERNELS\(K\)((?:.*\\\n)*.*)", header.read_text()):
            names |= {f"brdf_of_{name}" for name in re.findall(r"K\(\w+, (\w+)", macro)}
    return names


def findings(isa, lanes):
    """(kernels, complaints) of one instruction set."""
    kernels = [k for path in objects(isa) for k in kernel_code.kernels(path, PATTERN)]
    rest = 1000 if IS_CLANG else MOST_SCALAR
    wrong = [
        f"{isa}: {k.name}: {k.lanes} of {lanes} lanes, {k.scalar} scalar operations beside them, "
        f"{k.rest} in loops of their own"
        for k in kernels
        if not k.alias and (k.lanes < lanes or k.scalar > MOST_SCALAR or k.rest > rest)
    ]
    # Two that compile to the same code are one function; the name of the other may be gone.
    missing = sorted(wanted_names() - {k.name for k in kernels})
    if len(missing) > 4:
        wrong.append(f"{isa}: kernels not found: {' '.join(missing)}")
    return kernels, wrong


def main():
    if platform.machine() not in ("x86_64", "AMD64"):
        print("skipped: reads x86-64 code")
        return 77
    if "--bites" in sys.argv:
        _, wrong = findings("scalar", 16)
        print(f"{len(wrong)} scalar kernels refused")
        return 0 if len(wrong) > 100 else 1
    table, complaints = {}, []
    for isa, lanes in ISAS.items():
        kernels, wrong = findings(isa, lanes)
        complaints += wrong
        for k in kernels:
            table.setdefault(k.name, {})[isa] = k
    print(f"{'kernel':56} " + " ".join(f"{isa + ': wide, scalar':>20}" for isa in ISAS))
    for name, row in sorted(table.items()):
        cells = [
            f"{k.wide:14}, {k.scalar:4}" if k and not k.alias else f"{'':12}(shared)"
            for k in map(row.get, ISAS)
        ]
        print(f"{name:56} " + " ".join(cells))
    print("\n".join(complaints))
    print(f"{len(table)} kernels, {len(complaints)} complaints")
    return 1 if complaints or len(table) < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
