#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The evidence of a few rows fails when their functions are 1 % off, and only then."""
import os
import pathlib
import sys
import tempfile

TREE = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
sys.path.insert(0, str(TREE / "tools/formulas"))
import mutants  # noqa: E402
import mutate  # noqa: E402
import rows  # noqa: E402

SAMPLE = ["S1.4", "S2.5", "S3.21", "S4.15", "S4.18", "S4.22"]
# A row and a function that has nothing to do with it.
UNRELATED = [("S3.8", "phong_lobe"), ("S3.9", "ward_lobe"), ("S2.16", "f0_from_indices")]


def main():
    page = (TREE / "docs/formulas.md").read_text()
    table = [row for row in rows.table(page) if row.id in SAMPLE]
    functions = sorted({f for row in table for f in row.functions} | {f for _, f in UNRELATED})
    findings = []
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        mutants.build(tree, functions, os.environ.get("NDOTL_CC", "cc"))
        for row in table:
            findings += mutate.judge(tree, row, functions)[1]
        for row, function in UNRELATED:
            if mutate.Evidence(tree, row).caught_by(functions.index(function)):
                findings.append(f"{row}: fails with {function}, which it does not depend on")
    print("\n".join(findings + [f"{len(table)} rows, {len(findings)} findings"]))
    return 1 if findings or len(table) != len(SAMPLE) else 0


if __name__ == "__main__":
    sys.exit(main())
