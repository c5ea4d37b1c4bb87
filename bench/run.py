#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures everything that bench/RESULTS.md says, and writes it, with the chart bench/results.svg.

    python3 bench/run.py [--rounds 7] [--seconds 0.15] [--core N] [--no-mitsuba] [--build DIR]

Builds a release, compiles the rivals beside it, and runs all in turns on one core. Mitsuba needs
the network once (bench/peers/requirements.txt into a virtual environment in the build folder) and
LLVM 15 or later, Debian's libllvm19. A busy machine gives numbers that mean nothing.
"""

import argparse
import os
import pathlib
import platform
import subprocess
import sys
import time

import contest
import library
import page
import rivals
import setting

TREE = pathlib.Path(__file__).resolve().parents[1]
HERE = TREE / "bench"
INTRODUCTION = """# How fast ndotl is

Written by `python3 bench/run.py`; nothing here is typed in by hand.

{machine}

Rates are millions of evaluations per second (M/s) of one core, medians of {rounds} rounds of
{seconds} s in which all that a table compares took turns. Timed is the whole public call on random
directions, 90 % of the pairs with both above the horizon; results are used. "scalar" is the
library's own text as one loop at -O2 without vectors. Other programs on the machine spoil every
number here.

![chart](results.svg)
"""
CHAPTERS = [
    rivals.flagship,
    rivals.peers,
    library.models,
    library.costs,
    library.limits,
    library.streaming,
]
WARNINGS = ["-std=c11", "-D_POSIX_C_SOURCE=200809L", "-Wall", "-Wextra", f"-I{TREE}/include"]
V3, V4 = ["-march=x86-64-v3"], ["-march=x86-64-v4", "-mprefer-vector-width=512"]
CEILING = ["-O3", "-ffp-contract=off", "-fno-math-errno"]
NAIVE = ["-O3", "-fno-math-errno"]
OBJECTS = [
    ("ceiling_v4", CEILING + V4),
    ("ceiling_v3", CEILING + V3),
    ("naive", NAIVE + ["-DNAIVE=naive_plain"]),
    ("naive", NAIVE + V3 + ["-DNAIVE=naive_v3"]),
    ("naive", NAIVE + V4 + ["-DNAIVE=naive_v4"]),
    ("rates", ["-O2"]),
]


def sh(*words, **more):
    return subprocess.run(
        [str(w) for w in words], check=True, capture_output=True, text=True, **more
    ).stdout


def build_library(folder):
    """Builds a release; returns the seconds that it took, or None where there was one already."""
    fresh = not (folder / "libndotl.a").exists()
    sh("cmake", "-S", TREE, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DNDOTL_TESTS=OFF")
    start = time.monotonic()
    sh("cmake", "--build", folder, "--parallel", os.cpu_count())
    return time.monotonic() - start if fresh else None


def build_rivals(folder):
    compiler = os.environ.get("CC", "gcc")
    (folder / "rivals").mkdir(exist_ok=True)
    objects = []
    for number, (name, flags) in enumerate(OBJECTS):
        objects.append(folder / "rivals" / f"{number}_{name}.o")
        sh(compiler, *WARNINGS, *flags, "-c", HERE / f"{name}.c", "-o", objects[-1])
    program = folder / "rivals" / "rates"
    sh(compiler, *objects, folder / "libndotl.a", "-lm", "-lpthread", "-o", program)
    return program, sh(compiler, "--version").splitlines()[0]


def start_mitsuba(folder):
    """The server, or the reason why there is none."""
    python = folder / "peers" / "bin" / "python"
    try:
        if not python.exists():
            sh(sys.executable, "-m", "venv", folder / "peers")
            sh(python, "-m", "pip", "install", "-q", "-r", HERE / "peers/requirements.txt")
        server = contest.Mitsuba([python, HERE / "peers/mitsuba.py", folder / "libndotl.so"])
        server.call("names")
        return server, ""
    except (OSError, RuntimeError, subprocess.CalledProcessError) as error:
        return None, str(error)


def machine_text(compiler, core, seconds_to_build):
    model = next(
        (
            line.split(":")[1].strip()
            for line in open("/proc/cpuinfo", encoding="utf-8")
            if line.startswith("model name")
        ),
        platform.processor(),
    )
    flags = next(
        (line for line in open("/proc/cpuinfo", encoding="utf-8") if line.startswith("flags")), ""
    )
    text = (
        f"{model}, {os.cpu_count()} processors, {'' if 'avx512f' in flags else 'no '}AVX-512; "
        f"{platform.system()} {platform.machine()}; {compiler}; pinned to core {core}; load "
        f"{os.getloadavg()[0]:.2f} when it began."
    )
    if seconds_to_build:
        text += f" The release build took {seconds_to_build:.0f} s."
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--seconds", type=float, default=0.15, help="of one measurement")
    parser.add_argument("--core", type=int)
    parser.add_argument("--no-mitsuba", action="store_true")
    parser.add_argument("--build", type=pathlib.Path, default=TREE / "build/bench-release")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=HERE / "RESULTS.md")
    options = parser.parse_args()

    folder = options.build.resolve()
    seconds_to_build = build_library(folder)
    program, compiler = build_rivals(folder)
    all_cores = os.sched_getaffinity(0)
    core = contest.pin(options.core)
    mitsuba, why_not = (None, "not asked for") if options.no_mitsuba else start_mitsuba(folder)
    subject = setting.Setting(
        contest.Rates([program]),
        mitsuba,
        why_not,
        folder,
        options.rounds,
        options.seconds,
        all_cores,
    )
    text = [
        INTRODUCTION.format(
            machine=machine_text(compiler, core, seconds_to_build),
            rounds=options.rounds,
            seconds=options.seconds,
        )
    ]
    bars = []
    for chapter in CHAPTERS:
        print(chapter.__name__, file=sys.stderr, flush=True)
        part, groups = chapter(subject)
        text.append(part)
        bars += groups
    options.output.write_text("\n".join(text))
    svg = page.chart("ndotl on one core", "evaluations (1e6/s)", bars)
    options.output.with_name("results.svg").write_text(svg)
    subject.rates.close()
    if mitsuba:
        mitsuba.close()


if __name__ == "__main__":
    main()
