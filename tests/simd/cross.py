# SPDX-License-Identifier: Apache-2.0
"""Builds libndotl's core and tests/bits/bits.c for another processor, and compares the hashes that
it prints there with those of this machine."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

TREE = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
BUILD = pathlib.Path(os.environ.get("NDOTL_BUILD", TREE / "build/release"))
FLAGS = [
    "-std=c11",
    "-ffp-contract=off",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-fopenmp-simd",
    "-D_POSIX_C_SOURCE=200809L",
    "-DNDOTL_BUILD",
    f"-I{TREE}/include",
    f"-I{TREE}/src",
    "-w",
]
# Inputs per material: enough to meet every branch, few enough for an emulator.
MOST_INPUTS = 4000


def need(tool, package):
    """The path of a tool, or the end of the test as skipped."""
    path = shutil.which(tool)
    if not path:
        print(f"skipped: {tool} is missing; install {package}")
        sys.exit(77)
    return path


def need_file(path, package):
    if not pathlib.Path(path).exists():
        print(f"skipped: {path} is missing; install {package}")
        sys.exit(77)


def run(*words, **more):
    done = subprocess.run(
        [str(word) for word in words], capture_output=True, text=True, check=False, **more
    )
    if done.returncode:
        sys.exit(f"{' '.join(map(str, words))}\nexit {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def core_sources():
    """The sources of a library that evaluates: no processes, files or threads."""
    system = [f"base/{name}.c" for name in ("process", "file", "stream", "threads")]
    system.append("core/parallel.c")
    found = sorted((TREE / "src/core").glob("*.c")) + sorted((TREE / "src/base").glob("*.c"))
    return [path for path in found if path.relative_to(TREE / "src").as_posix() not in system]


def objects(folder, compiler, common, kernels):
    """The object files of core_sources(), those that name NDL_ISA once for each (name, flags) of
    `kernels`."""
    jobs = []
    for path in core_sources():
        stem = f"{path.parent.name}_{path.stem}"
        if "NDL_ISA" in path.read_text():
            jobs += [
                (path, [f"-DNDL_ISA={name}", *flags], f"{stem}_{name}") for name, flags in kernels
            ]
        else:
            jobs.append((path, ["-O1"], stem))
    made = []
    for path, flags, stem in jobs:
        made.append(folder / f"{stem}.o")
        run(*compiler, *FLAGS, *common, *flags, "-c", path, "-o", made[-1])
    return made


def short_list(folder):
    """tests/bits/materials.txt with fewer inputs."""
    lines = (TREE / "tests/bits/materials.txt").read_text().splitlines()
    rows = [line.split(" ", 1) for line in lines if line and line[0] != "#"]
    path = folder / "materials.txt"
    path.write_text("".join(f"{min(int(n), MOST_INPUTS)} {m}\n" for n, m in rows))
    return path


def bits_source(folder):
    """bits.c with fewer inputs for the models with their defaults."""
    text = (TREE / "tests/bits/bits.c").read_text()
    short = text.replace("DEFAULT_INPUTS = 1000000", f"DEFAULT_INPUTS = {MOST_INPUTS}")
    assert short != text
    path = folder / "bits.c"
    path.write_text(short)
    return path


def native_hashes(folder):
    library = BUILD / "libndotl.a"
    program, output = folder / "native", folder / "native.txt"
    run(
        os.environ.get("NDOTL_CC", "cc"),
        *FLAGS,
        "-O1",
        bits_source(folder),
        library,
        "-lm",
        "-lpthread",
        "-o",
        program,
    )
    run(program, short_list(folder), output, "scalar")
    return output.read_text().splitlines()


def compare(name, got, want):
    """Prints the rows that differ and ends the test."""
    wrong = [f"  {a}\n  {b}" for a, b in zip(got, want) if a != b]
    print("\n".join(wrong[:10]))
    print(f"{name}: {len(want)} materials, {len(wrong)} with other bits than this machine")
    sys.exit(1 if wrong or len(got) != len(want) or len(want) < 100 else 0)


def folder():
    return tempfile.TemporaryDirectory()
