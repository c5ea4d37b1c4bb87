#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`ndotl bench` from outside: arguments, exit codes, the shape of its JSON and chart. Rates are
only looked at for being numbers above 0."""

import json
import os
import pathlib
import sys
import xml.etree.ElementTree as ET

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from cli import Folder, main, ok, refused, run  # noqa: E402

ROW = [
    "material",
    "op",
    "isa",
    "table",
    "n",
    "threads",
    "level",
    "params",
    "meval_per_s",
    "ns",
    "vs_scalar",
]
SHORT = ["--time", "0.002"]


def rows(*words, **more):
    report = json.loads(ok("bench", *words, *SHORT, "--json", **more).text)
    assert list(report) == ["machine", "rows"], report
    for row in report["rows"]:
        assert list(row) == ROW, row
        assert row["meval_per_s"] > 0 and row["ns"] > 0 and row["vs_scalar"] > 0, row
        assert abs(row["meval_per_s"] * row["ns"] / 1000 - 1) < 1e-4, row
        assert row["level"] in ("L1", "L2", "DRAM") and row["params"] in ("uniform", "lanes"), row
    return report["rows"]


def test_one_row_for_each_n_in_the_order_given():
    got = rows("ggx", "--n", "4096", "--n", "1", "--n", "100", "--isa", "scalar")
    assert [row["n"] for row in got] == [4096, 1, 100], got
    for row in got:
        assert (row["op"], row["isa"], row["table"], row["threads"]) == (
            "brdf",
            "scalar",
            "exact",
            1,
        )
        assert row["params"] == "uniform" and row["material"] == "ggx", row
    assert got[1]["level"] == "L1", got


def test_without_n_three_levels_and_both_kinds_of_parameters():
    got = rows("lambert(color=0.5)")
    assert [(row["level"], row["params"]) for row in got] == [
        (level, params) for level in ("L1", "L2", "DRAM") for params in ("uniform", "lanes")
    ], got
    assert got[0]["n"] < got[2]["n"] < got[4]["n"], got
    assert {row["material"] for row in got} == {
        ok("eval", "lambert(color=0.5)", "--print").text[:-1]
    }


def test_every_model_is_measured_where_none_is_named():
    models = [line.split()[0] for line in ok("models").text.splitlines() if line[0] != " "]
    assert [row["material"].split("(")[0] for row in rows("--n", "64")] == models


def test_materials_keep_their_order_and_sums_are_taken():
    got = rows("ward", "0.3*lambert + 0.7*ggx(alpha=0.2)", "ggx(preset=gold)", "--n", "300")
    assert [row["material"].split("(")[0] for row in got] == [
        "ward",
        "0.3*lambert + 0.7*ggx",
        "ggx",
    ]


def test_all_takes_every_instruction_set_of_the_machine():
    got = [row["isa"] for row in rows("ggx", "--n", "512", "--isa", "all")]
    assert got[0] == "scalar" and len(got) == len(set(got)) and len(got) >= 2, got
    for isa in got:
        assert [row["isa"] for row in rows("ggx", "--n", "64", "--isa", isa)] == [isa]


def test_the_environment_chooses_the_instruction_set_and_isa_overrides_it():
    env = {"NDOTL_ISA": "scalar"}
    assert rows("ggx", "--n", "64", env=env)[0]["isa"] == "scalar"
    best = rows("ggx", "--n", "64")[0]["isa"]
    assert rows("ggx", "--n", "64", "--isa", best, env=env)[0]["isa"] == best


def test_threads_are_counted():
    for n in "512", "70000":
        got = rows("ggx", "--n", n, "--threads", "2")
        assert [(row["threads"], row["n"]) for row in got] == [(2, int(n))], got


def test_sampling_and_its_density_are_operations():
    for op in "pdf", "sample":
        got = rows("ggx", "--op", op, "--n", "100")
        assert [(row["op"], row["params"]) for row in got] == [(op, "uniform")], got
        levels = [row["level"] for row in rows("ggx", "--op", op)]
        assert levels == ["L1", "L2", "DRAM"], levels


def test_the_machine_is_described():
    machine = json.loads(ok("bench", "lambert", "--n", "64", *SHORT, "--json").text)["machine"]
    assert machine["cpu"] and machine["processors"] >= 1 and machine["compiler"], machine
    for key in "fma_gflop_per_s", "triad_gb_per_s", "l1_kib", "l2_kib", "l3_kib":
        assert machine[key] > 0, machine
    assert list(machine["stream_m_per_s"]) == ["L1", "L2", "DRAM"], machine


def test_the_table_shows_limits_and_shares():
    text = ok("bench", "ggx", "--n", "512", *SHORT).text
    for part in "FMA", "triad", "GB/s", "vs scalar", "stream", "uniform", "L1":
        assert part in text, (part, text)


def test_the_chart_is_svg_with_labels_that_stay_apart():
    with Folder() as folder:
        path = os.path.join(folder.path, "chart.svg")
        ok(
            "bench",
            "ggx(f0=[0.9,0.5,0.1], alpha_x=0.123456, alpha_y=0.654321)",
            "ward",
            "--n",
            "64",
            "--n",
            "128",
            *SHORT,
            "-o",
            path,
        )
        text = open(path, encoding="utf-8").read()
        root = ET.fromstring(text)
        assert "MIT-0" in text and root.get("width") and root.get("height")
        name = "{http://www.w3.org/2000/svg}"
        assert root.find(f"{name}title") is not None
        labels = list(root.iter(f"{name}text"))
        assert sum("ggx" in (t.text or "") for t in labels) == 2, text
        assert any((t.text or "").endswith("(1e6/s)") for t in labels), text
        seen = set()
        for t in labels:
            assert 0 <= float(t.get("y")) <= float(root.get("height")), text
            assert (t.get("x"), t.get("y")) not in seen, text
            seen.add((t.get("x"), t.get("y")))
        assert os.listdir(folder.path) == ["chart.svg"]


def test_wrong_words_end_with_2_and_are_repeated():
    for words, says, place in [
        (["nosuch"], "nosuch", None),
        (["ggx", "--isa", "x87"], "x87", "--isa"),
        (["ggx", "--isa", ""], "unknown", "--isa"),
        (["ggx", "--table", "fats"], "fats", "--table"),
        (["ggx", "--op", "eval"], "eval", "--op"),
        (["ggx", "--n", "0"], "0", "--n"),
        (["ggx", "--n", "1.5"], "1.5", "--n"),
        (["ggx", "--n", "-3"], "-3", "--n"),
        (["ggx", "--threads", "0"], "0", "--threads"),
        (["ggx", "--time", "0"], "0", "--time"),
        (["ggx", "-o", "chart.png"], "chart.png", "-o"),
        (["ggx", "--jsn"], "--json", None),
    ]:
        refused(2, "bench", *words, says=says, place=place)
    refused(2, "bench", "ggx", "--n", "64", env={"NDOTL_ISA": "x87"}, says="x87")


def test_a_chart_that_cannot_be_written_ends_with_1():
    path = "/nonexistent/folder/chart.svg"
    done = run("bench", "ggx", "--n", "64", *SHORT, "-o", path)
    assert done.code == 1 and path in done.err, done


if __name__ == "__main__":
    main(globals())
