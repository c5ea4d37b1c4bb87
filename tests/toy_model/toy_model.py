#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Adding a model takes three places: adds one to a copy of the tree, builds, and runs the golden
and law tests over all models there, lints and commands. With wrong golden values they fail."""
import math
import os
import pathlib
import random
import shutil
import struct
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(os.environ["NDOTL_SOURCE"])
MODEL = "lommel_seeliger"
ROWS = f'#include "shade/{MODEL}.h"\nMODEL({MODEL}, {MODEL.upper()})\n'
LINTS = ["models", "includes", "shading_dialect"]


def run(words, must_fail=False, **more):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, text=True,
                          stderr=subprocess.STDOUT, **more)
    if (done.returncode != 0) != must_fail:
        sys.exit(f"exit {done.returncode}: {' '.join(map(str, words))}\n{done.stdout[-6000:]}")
    return done.stdout


def single(x):
    """x rounded to float."""
    return struct.unpack("f", struct.pack("f", x))[0]


def direction(draw):
    """A unit vector rounded to float; one in eight close to the horizon or below it."""
    z = draw.uniform(-0.2, 0.01) if draw.random() < 0.125 else draw.uniform(0.0, 1.0)
    phi = draw.uniform(0.0, 2.0 * math.pi)
    r = math.sqrt(1.0 - z * z)
    return [single(r * math.cos(phi)), single(r * math.sin(phi)), single(z)]


def golden(factor):
    """The file of golden values: the formula in double, times `factor`; k by hand."""
    lines = ["# SPDX-License-Identifier: Apache-2.0",
             f"# {MODEL}: f = color / (4 pi (cos i + cos o)), computed in double by toy_model.py.",
             "tag,material,quantity,wx,wy,wz,ox,oy,oz,r,g,b,kr,kg,kb"]
    draw = random.Random(1)
    for _ in range(200):
        color, wi, wo = single(draw.random()), direction(draw), direction(draw)
        quantity = draw.choice(["brdf", "cos"])
        value, k = 0.0, 0.0
        if wi[2] > 0.0 and wo[2] > 0.0:
            value = factor * color / (4.0 * math.pi * (wi[2] + wo[2]))
            k = 2.0
            if quantity == "cos":
                value *= wi[2]
                k = 1.0 + 2.0 * wo[2] / (wi[2] + wo[2])
        numbers = [f"{x:.9g}" for x in wi + wo] + [f"{value:.17g}"] * 3 + [f"{k:.6g}"] * 3
        lines.append(f'toy,"{MODEL}(color={color:.9g})",{quantity},' + ",".join(numbers))
    return "\n".join(lines) + "\n"


def add_model(tree):
    shutil.copy(SOURCE / "tests" / "toy_model" / f"{MODEL}.h", tree / "src" / "shade")
    with open(tree / "src" / "core" / "models.def", "a") as file:
        file.write(ROWS)
    (tree / "tests" / "golden" / f"{MODEL}.csv").write_text(golden(1.0))


def build(tree):
    """Only what the tests need, at an optimisation that compiles quickly."""
    folder = tree / "build"
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    run(["cmake", *generator, "-S", tree, "-B", folder, "-DNDOTL_WORKBENCH=OFF",
         "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_C_FLAGS_RELEASE=-O1", "-DNDOTL_KERNEL_OPT=-O1"])
    run(["cmake", "--build", folder, "--parallel", str(os.cpu_count()),
         "--target", "ndotl", "tests_golden", "tests_laws"])
    return folder


def check_commands(program):
    if MODEL not in run([program, "models"]) or "Moon" not in run([program, "models", MODEL]):
        sys.exit(f"ndotl models does not tell of {MODEL}")
    got = run([program, "eval", f"{MODEL}(color=0.5)"], input="0 0 1 0 0 1\n").split()
    want = 0.5 / (8.0 * math.pi)
    if len(got) != 3 or any(abs(float(x) - want) > 1e-7 for x in got):
        sys.exit(f"ndotl eval gives {got}, not {want:.9g}")


def main():
    with tempfile.TemporaryDirectory() as name:
        tree = pathlib.Path(name) / "ndotl"
        shutil.copytree(SOURCE, tree, ignore=shutil.ignore_patterns("build", ".git", "__pycache__"))
        add_model(tree)
        environment = dict(os.environ, NDOTL_SOURCE=str(tree))
        for lint in LINTS:
            run([sys.executable, tree / "tests" / "lint" / f"{lint}.py"], env=environment)
        folder = build(tree)
        check_commands(folder / "ndotl")
        ctest = ["ctest", "--test-dir", folder, "--no-tests=error", "--output-on-failure"]
        print(run([*ctest, "-L", "quick", "-L", "^(golden|laws)$"])[-1500:])
        (tree / "tests" / "golden" / f"{MODEL}.csv").write_text(golden(1.01))
        text = run([*ctest, "-L", "quick", "-L", "^golden$"], must_fail=True)
        if MODEL not in text:
            sys.exit(f"wrong golden values fail, but without naming {MODEL}\n{text[-3000:]}")
        print("golden values that are 1 % off are refused")


if __name__ == "__main__":
    main()
