# SPDX-License-Identifier: Apache-2.0
"""The table of docs/formulas.md and the evidence for its rows: tagged lines of tests/golden/*.csv
and tests of tests/formulas whose names begin with row ids."""
import csv
import os
import pathlib
import re

TREE = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
COUNTS = {1: 15, 2: 20, 3: 23, 4: 56}
ROWS = [f"S{document}.{n}" for document, last in COUNTS.items() for n in range(1, last + 1)]
NOT_HERE = re.compile(r"^(explanation|out of scope|part \d): \S")
PROGRAMS = ("test_rows", "test_numbers")
# Golden tables that are not a model's, and the test that reads each.
READERS = {"sums": "golden/test_values", "albedo": "golden/test_albedo",
           "conversions": "formulas/test_conversions"}
LINE = re.compile(r"^\| (S\d\.\d+) \| (.*) \| (.*) \| (.*) \| (.*) \| (.*) \|$")
NAME = re.compile(r"`(\w+)`")
TEST = re.compile(r"cmocka_unit_test\(((?:S\d_\d+_)+)(\w+)\)")
DEFINED = r"\b{}\([^;{{}}]*\)\s*\{{"
SOURCES = ("src/shade/*.h", "src/core/*.c")


class Row:
    """One line of the table: `functions` are the names in its third column."""

    def __init__(self, cells):
        self.id, self.content, functions, self.call, self.evidence, self.note = cells
        self.elsewhere = functions if NOT_HERE.match(functions) else ""
        self.functions = [] if self.elsewhere else NAME.findall(functions)

    def is_here(self):
        return not self.elsewhere


def table(text):
    return [Row(match.groups()) for match in map(LINE.match, text.splitlines()) if match]


def models():
    text = (TREE / "src/core/models.def").read_text()
    return re.findall(r"^(?:MODEL|COMPOSED)\((\w+)", text, re.M)


def golden_tables():
    """Each table of brdf values, albedos and conversions as (name, comment lines and header, data
    lines). Tables of later parts (densities) have tests of their own."""
    for path in sorted((TREE / "tests/golden").glob("*.csv")):
        if path.stem not in READERS and path.stem not in models():
            continue
        head, lines = [], []
        for line in path.read_text().splitlines():
            (head if line.startswith("#") or "tag" in line.split(",")[:1] else lines).append(line)
        if any(line.startswith("tag,") for line in head):
            yield path.stem, head, lines


def tags(line):
    return next(csv.reader([line]))[0].split()


def golden_evidence():
    """Row id -> names of the tables with a line of that tag."""
    found = {}
    for name, _, lines in golden_tables():
        for row in {tag for line in lines for tag in tags(line)}:
            found.setdefault(row, []).append(name)
    return found


def row_tests(source):
    """(full name of a test, its row ids) of a C file."""
    for prefix, rest in TEST.findall(source):
        yield prefix + rest, re.sub(r"S(\d)_(\d+)_", r"S\1.\2 ", prefix).split()


def test_evidence():
    """Row id -> names of the programs with a test for it."""
    found = {}
    for program in PROGRAMS:
        source = (TREE / f"tests/formulas/{program}.c").read_text()
        for row in {row for _, rows in row_tests(source) for row in rows}:
            found.setdefault(row, []).append(program)
    return found


def evidence(row, golden, tests):
    return " ".join(golden.get(row, []) + tests.get(row, [])) or "-"


def defines(function):
    """The files that define a function."""
    pattern = re.compile(DEFINED.format(function), re.S)
    return [path for glob in SOURCES for path in sorted(TREE.glob(glob))
            if pattern.search(path.read_text())]
