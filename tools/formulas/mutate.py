#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Shows that the evidence of docs/formulas.md bites: each function, made to return 1.01 times its
value, must fail the golden values or the tests of each row that names it.

    tools/formulas/mutate.py              all rows; prints what caught each, as a table
    tools/formulas/mutate.py S1.4 S3.21   those rows
    tools/formulas/mutate.py --record     all rows, into docs/formulas-mutation.md

The compiler is $NDOTL_CC or cc. It takes about a minute; the tree itself is left alone.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import mutants
import rows

PAGE = "docs/formulas-mutation.md"
HEAD = """# Formulas: what catches an error of one percent

Written by `tools/formulas/mutate.py --record`. For each row of [formulas.md](formulas.md) and each
function that it names: the first evidence of that row that fails when the function returns 1.01
times its value (a condition: true instead of false). Only golden values tagged with the row and
tests named after it were run; all of them pass when nothing is wrong.

| row | function | caught by |
|---|---|---|
"""


class Evidence:
    """The golden lines and the tests of one row, in a folder of their own."""

    def __init__(self, tree, row):
        self.tree, self.row = tree, row
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix=row, dir=tree))
        (self.folder / "tests/golden").mkdir(parents=True)
        self.tables = []
        for name, head, lines in rows.golden_tables():
            mine = [line for line in lines if row in rows.tags(line)]
            if mine:
                self.tables.append(name)
                path = self.folder / f"tests/golden/{name}.csv"
                path.write_text("\n".join(head + mine) + "\n")
        self.tests = []
        for program in rows.PROGRAMS:
            source = (rows.TREE / f"tests/formulas/{program}.c").read_text()
            self.tests += [(program, test) for test, ids in rows.row_tests(source) if row in ids]

    def run(self, words, wrong):
        environment = {**os.environ, "NDOTL_SOURCE": str(self.folder), "NDOTL_ISA": "scalar"}
        environment.pop("NDOTL_WRONG", None)
        if wrong is not None:
            environment["NDOTL_WRONG"] = str(wrong)
        done = subprocess.run(words, env=environment, capture_output=True, text=True, timeout=300)
        return done.returncode, done.stdout

    def failed_values(self, table, wrong):
        """Values of the row's lines in a table that are wrong. The exit status also counts how
        many ill-conditioned values a whole table has, which says nothing of a part of it."""
        program = pathlib.Path(rows.READERS.get(table, "golden/test_values")).name
        _, out = self.run([str(self.tree / program), table], wrong)
        counts = re.findall(r"(\d+) failed$", out, re.M)
        return sum(map(int, counts)) if counts else 1

    def caught_by(self, wrong):
        """The first evidence that fails, in words, or None."""
        for table in self.tables:
            if self.failed_values(table, wrong):
                return f"{table}.csv"
        for program, test in self.tests:
            if self.run([str(self.tree / program), test], wrong)[0]:
                return f"{program}: {test}"
        return None


def judge(tree, row, functions):
    """Lines of the table of one row, and what is wrong with its evidence."""
    evidence, lines, findings = Evidence(tree, row.id), [], []
    before = evidence.caught_by(None)
    if before:
        findings.append(f"{row.id}: {before} fails although nothing is wrong")
    for function in row.functions:
        caught = evidence.caught_by(functions.index(function))
        lines.append(f"| {row.id} | `{function}` | {caught or 'nothing'} |")
        if not caught:
            findings.append(f"{row.id}: nothing notices that {function} is 1 % off")
    return lines, findings


def main():
    wanted = [word for word in sys.argv[1:] if word != "--record"]
    page = (rows.TREE / "docs/formulas.md").read_text()
    table = [row for row in rows.table(page) if row.functions and row.id in (wanted or rows.ROWS)]
    functions = sorted({function for row in table for function in row.functions})
    lines, findings = [], []
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        mutants.build(tree, functions, os.environ.get("NDOTL_CC", "cc"))
        for row in table:
            new, wrong = judge(tree, row, functions)
            lines += new
            findings += wrong
    if "--record" in sys.argv[1:]:
        (rows.TREE / PAGE).write_text(HEAD + "\n".join(lines) + "\n")
    else:
        print("\n".join(lines))
    print("\n".join(findings + [f"{len(lines)} mutants of {len(functions)} functions in "
                                f"{len(table)} rows, {len(findings)} findings"]), file=sys.stderr)
    return 1 if findings or not table else 0


if __name__ == "__main__":
    sys.exit(main())
