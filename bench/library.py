# SPDX-License-Identifier: Apache-2.0
"""Chapters of RESULTS.md: the library against itself and the machine's limits."""

import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from contest import Contest, geomean
from page import number, table
from setting import BARS, NAN, TREE, bar

sys.path.insert(0, str(TREE / "tools"))
import kernel_code  # noqa: E402


def all_materials():
    """tests/bits/materials.txt: every variant, and all combinations of microfacet."""
    rows = [
        line.split(" ", 1)[1]
        for line in (TREE / "tests/bits/materials.txt").read_text().splitlines()
        if line and line[0] != "#"
    ]
    composed = [m for m in rows if m.startswith("microfacet(")]
    return [m for m in rows if m not in composed], composed


def models(s):
    """Every model, and every combination of microfacet, over scalar."""
    isas, n, slice_ = s.isas(), 4096, max(0.01, s.seconds / 5)
    single, composed = all_materials()
    rows, ratios, names = [], {isa: [] for isa in isas}, {}
    for material in single + composed:
        got = Contest(
            {isa: s.ours("brdf", isa, n, material, slice_) for isa in ["scalar", *isas]},
            max(3, s.rounds // 2),
        )
        for isa in isas:
            (ratios if material in single else names).setdefault(isa, []).append(
                got.ratio(isa, "scalar")
            )
        if material in single:
            rows.append(
                [f"`{material}`", got["scalar"]]
                + [cell for isa in isas for cell in (got[isa], got.ratio(isa, "scalar"))]
            )
    best = isas[-1]
    order = sorted(range(len(composed)), key=lambda i: names[best][i])
    slow = [[f"`{composed[i]}`", *(names[isa][i] for isa in isas)] for i in order[:8]]
    means = [
        [what, *(geomean(rates[isa]) for isa in isas), min(rates[best])]
        for what, rates in (("models", ratios), (f"{len(composed)} combinations", names))
    ]
    bars = [
        bar(f"geometric mean over the models, {isa}", geomean(ratios[isa]), least)
        for isa, least in (("x86-64-v4", 10), ("x86-64-v3", 6.5))
        if isa in isas
    ]
    if "x86-64-v4" in isas:
        bars.append(bar("slowest combination, x86-64-v4", min(names["x86-64-v4"]), 4))
    head = [c for isa in isas for c in (isa, "over scalar")]
    text = (
        f"## Every model\n\n{n} pairs.\n\n"
        + table(["material", "scalar", *head], rows)
        + "\nOver scalar, geometric means, and the smallest:\n\n"
        + table(["", *isas, f"least, {best}"], means)
        + "\nThe slowest combinations of microfacet, over scalar:\n\n"
        + table(["", *isas], slow)
        + "\n"
        + table(BARS, bars)
    )
    return text, []


def costs(s):
    """Parameters per lane, sums, single pairs, threads."""
    best, flag = s.isas()[-1], s.rates.ask("material")
    lanes = "lanes {} {} {} alpha_x,alpha_y,f0.r,f0.g,f0.b " + flag
    rows, bars = [], []
    for n in (1024, 4096, 16384, 1000000):
        got = Contest(
            {
                "uniform": s.ours("brdf", best, n, flag),
                "lanes": lambda: 1e-6 * s.rates.rate(lanes.format(best, n, s.seconds)),
            },
            s.rounds,
        )
        rows.append([str(n), got["uniform"], got["lanes"], got.ratio("uniform", "lanes")])
        if n <= 4096:
            bars.append(
                bar(
                    f"five parameters per lane, time over uniform, {n} pairs",
                    got.ratio("uniform", "lanes"),
                    1.25,
                    True,
                )
            )
    lobes = ["lambert(color=0.8)", flag]
    got = Contest(
        {m: s.ours("brdf", best, 4096, m) for m in [*lobes, f"0.3*{lobes[0]} + 0.7*{flag}"]},
        s.rounds,
    )
    alone = sum(1 / got[m] for m in lobes)
    bars.append(
        bar(
            "two lobes, time over one after the other",
            1 / got[f"0.3*{lobes[0]} + 0.7*{flag}"] / alone,
            1.15,
            True,
        )
    )
    got = Contest(
        {
            "batch": s.single("one", best, flag),
            "call": s.single("call", best, flag),
        },
        s.rounds,
    )
    bars.append(
        bar(
            "a batch of one pair, ns more than a single call",
            1e3 / got["batch"] - 1e3 / got["call"],
            20,
            True,
        )
    )
    bars += threads(s, flag)
    head = ["pairs", "uniform", "lanes", "time over uniform"]
    return COSTS + table(head, rows) + "\n" + table(BARS, bars), []


COSTS = """## What else costs

The flagship with uniform parameters, and with alpha_x, alpha_y and f0 per lane:

"""
MEMORY = """## From memory

Limits of this core, measured by `ndotl bench`: {fma} Gflop/s of fused multiply-adds ({isa}); triad
{triad} GB/s; six streams read and three written at {streams} M/s. The limit of a row is the smaller
of that from DRAM and the kernel's own rate from the first cache.

"""
ARITHMETIC = """Float operations of an evaluation, counted in the AVX-512 object file with minima
and maxima, and the share of the multiply-add peak that they are. Without contraction an operation
takes the place of a multiply-add, so that 0.5 is the most.

"""


def ndotl_bench(s, *words):
    out = subprocess.run(
        [
            s.folder / "ndotl",
            "bench",
            *map(str, words),
            "--json",
            "--time",
            str(max(0.1, 2 * s.seconds)),
        ],
        check=True,
        capture_output=True,
        text=True,
        preexec_fn=lambda: os.sched_setaffinity(0, s.all_cores) if "--threads" in words else None,
    ).stdout
    return json.loads(out)


def threads(s, material):
    if len(s.all_cores) < 2:
        return [bar("two threads over one", NAN, 1.8)]
    rows = []
    for n, what in (
        (16384, "batches of their own, from the second cache"),
        (262144, "one batch shared by ndl_brdf_threads_n"),
    ):
        ratios = []
        for _ in range(max(3, s.rounds // 2)):
            one, two = (
                ndotl_bench(s, material, "--n", n, "--threads", t)["rows"][0]["meval_per_s"]
                for t in (1, 2)
            )
            ratios.append(two / one)
        rows.append(bar(f"two threads over one, {n} pairs: {what}", statistics.median(ratios), 1.8))
    return rows


def limits(s):
    """From memory, against the machine's own limits."""
    single, _ = all_materials()
    best = s.isas()[-1]
    report = ndotl_bench(s, *single, "--n", 512, "--n", 3728270, "--isa", best)
    machine, rows, shares = report["machine"], [], []
    stream = machine["stream_m_per_s"]["DRAM"]
    pairs = report["rows"]
    kernels = code_of_flagships(s)
    for near, far in zip(pairs[::2], pairs[1::2]):
        limit = min(stream, near["meval_per_s"])
        shares.append(far["meval_per_s"] / limit)
        rows.append(
            [f"`{near['material']}`", near["meval_per_s"], far["meval_per_s"], limit, shares[-1]]
        )
    text = MEMORY.format(
        fma=number(machine["fma_gflop_per_s"]),
        isa=machine["limits_isa"],
        triad=number(machine["triad_gb_per_s"]),
        streams=", ".join(f"{number(v)} ({k})" for k, v in machine["stream_m_per_s"].items()),
    )
    text += table(["material", "M/s from L1", "M/s from DRAM", "limit", "share"], rows) + "\n"
    text += table(BARS, [bar("smallest share of the limit from DRAM", min(shares), 0.85)]) + "\n"
    text += arithmetic(machine, kernels, pairs)
    return text, []


FLAGSHIPS = {
    "fused_ggx_smith_correlated_schlick": "ggx(alpha_x=0.05, alpha_y=0.5)",
    "fused_ggx_smith_correlated_conductor": "ggx(roughness=0.3, preset=gold)",
    "brdf_of_ward_duer": "ward(alpha_x=0.05, alpha_y=0.5, variant=duer)",
}


def code_of_flagships(s):
    files = s.folder.glob("CMakeFiles/ndotl_kernels_v4.dir/**/kernels.c.o")
    found = [k for path in files for k in kernel_code.kernels(path, "|".join(FLAGSHIPS) + "$")]
    return {k.name: k for k in found}


def arithmetic(machine, kernels, rows):
    """The share of the multiply-add peak, with the operations counted in the object file."""
    lines = []
    for name, material in FLAGSHIPS.items():
        rate = next(
            (
                r["meval_per_s"]
                for r in rows
                if same_material(r["material"], material) and r["level"] == "L1"
            ),
            NAN,
        )
        k = kernels.get(name)
        if k:
            flops = (
                3 * k.flops
            )  # flops are counted per value stored, and an evaluation stores three
            lines.append(
                [
                    f"`{name}`",
                    flops,
                    3 * k.roots,
                    rate,
                    1e-3 * rate * flops / machine["fma_gflop_per_s"],
                ]
            )
    if not lines:
        return ""
    head = ["kernel", "operations", "divisions and roots", "M/s from L1", "share of the peak"]
    return ARITHMETIC + table(head, lines)


def same_material(a, b):
    return "".join(a.split()) == "".join(b.split())


def streaming(s):
    """Text through `ndotl eval`."""
    lines = 1000000
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "pairs.txt"
        with open(path, "w", encoding="ascii") as file:
            for i in range(lines):
                a, b = (0.1 + i % 997 / 1250, 0.05 + i % 1009 / 1300)
                file.write(
                    f"{a:.6f} 0 {math.sqrt(1 - a * a):.6f} {-b:.6f} 0.1 "
                    f"{math.sqrt(0.99 - b * b):.6f}\n"
                )
        rates = []
        for _ in range(s.rounds):
            start = time.monotonic()
            subprocess.run(
                [s.folder / "ndotl", "eval", "ggx(preset=gold)", path],
                check=True,
                stdout=subprocess.DEVNULL,
            )
            rates.append(1e-6 * lines / (time.monotonic() - start))
    size = (
        subprocess.run(
            ["size", s.folder / "libndotl.so"], check=True, capture_output=True, text=True
        )
        .stdout.splitlines()[1]
        .split()[0]
    )
    bars = [
        bar("`ndotl eval`, million lines a second, text in and out", statistics.median(rates), 3),
        bar("text of libndotl.so, MB", int(size) / 1e6, 2, True),
    ]
    return "## Text and size\n\n" + table(BARS, bars), []
