#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""docs/formulas.md: every row of the inventory is there, names functions that exist, and has
evidence that runs: tagged golden values or tests."""
import os
import pathlib
import re
import subprocess
import sys

TREE = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
sys.path.insert(0, str(TREE / "tools/formulas"))
import evidence  # noqa: E402
import rows  # noqa: E402

PAGE, RECORD = "docs/formulas.md", "docs/formulas-mutation.md"


def check_rows(table):
    ids = [row.id for row in table]
    if ids != rows.ROWS:
        missing = [row for row in rows.ROWS if row not in ids]
        yield f"{PAGE}:1: rows missing {missing}, unknown {[i for i in ids if i not in rows.ROWS]}"
    for row in table:
        if not row.functions and row.is_here():
            yield f"{PAGE}: {row.id} names no function; say why, as 'explanation: ...'"
        if row.is_here() and row.evidence == "-":
            yield f"{PAGE}: {row.id} has no evidence; tag a golden case or write a test for it"
        for function in row.functions:
            if not rows.defines(function):
                yield f"{PAGE}: {row.id} names {function}, which nothing defines"


def check_tags():
    for name, reader in rows.READERS.items():
        if f'"{name}"' not in (TREE / f"tests/{reader}.c").read_text():
            yield f"tests/golden/{name}.csv: {reader}.c does not read it"
    for name, _, lines in rows.golden_tables():
        unknown = {tag for line in lines for tag in rows.tags(line)} - set(rows.ROWS)
        if unknown:
            yield f"tests/golden/{name}.csv: unknown rows {sorted(unknown)}"
        if any(not rows.tags(line) for line in lines):
            yield f"tests/golden/{name}.csv: a line without a row"
    for program in rows.PROGRAMS:
        source = (TREE / f"tests/formulas/{program}.c").read_text()
        for test, ids in rows.row_tests(source):
            if set(ids) - set(rows.ROWS):
                yield f"tests/formulas/{program}.c: {test} is for an unknown row"
        if source.count("(void **state)") != len(list(rows.row_tests(source))):
            yield f"tests/formulas/{program}.c: a test is not listed in main, or lacks a row"


def check_record(table):
    """docs/formulas-mutation.md is about the rows and functions of the map."""
    recorded = re.findall(r"^\| (\S+) \| `(\w+)` \| (.*) \|$", (TREE / RECORD).read_text(), re.M)
    pairs = [(row.id, function) for row in table for function in row.functions]
    if [(row, function) for row, function, _ in recorded] != pairs:
        yield f"{RECORD}:1: out of date; run tools/formulas/mutate.py --record"
    for row, function, caught in recorded:
        if caught == "nothing":
            yield f"{RECORD}: {row}: nothing notices that {function} is 1 % off"


def check_search(table):
    """`ndotl models ROW` finds every row that is here."""
    for row in table:
        if row.is_here():
            done = subprocess.run([os.environ["NDOTL_BIN"], "models", row.id], capture_output=True)
            if done.returncode:
                yield f"{PAGE}: 'ndotl models {row.id}' finds nothing"


def main():
    text = (TREE / PAGE).read_text()
    table = rows.table(text)
    findings = [*check_rows(table), *check_tags(), *check_search(table),
                *check_record(table)]
    if evidence.updated(text) != text:
        findings.append(f"{PAGE}:1: the evidence is out of date; run tools/formulas/evidence.py")
    print("\n".join(findings + [f"{len(table)} rows, {len(findings)} findings"]))
    return 1 if findings or not table else 0


if __name__ == "__main__":
    sys.exit(main())
