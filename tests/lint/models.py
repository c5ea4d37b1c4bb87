#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A model is three places: src/shade/<model>.h, two adjacent lines of src/core/models.def, and
tests/golden/<model>.csv, whose first lines say how the values were made."""
import re

import lint

DEF = "src/core/models.def"
ROW = re.compile(r"^(?:MODEL|COMPOSED)\((\w+)\s*,\s*(\w+)", re.M)
TABLES = re.compile(r"^#define (\w+_(?:PARAMS|MANUAL))\b", re.M)
PARTS = ("PARAMS", "MANUAL")
FEWEST_ROWS = 20


def check_golden(tree, where, model):
    """What is wrong with a model's golden values."""
    path = f"tests/golden/{model}.csv"
    if not (tree / path).exists():
        return [f"{where}: model {model} has no {path}; make it with a generator in tools/golden"]
    lines = (tree / path).read_text().splitlines()
    findings = []
    if not lines or not lines[0].startswith("#"):
        findings.append(f"{path}:1: does not say how it was made; begin with # and the way")
    if sum(1 for line in lines if line and line[0] != "#") <= FEWEST_ROWS:
        findings.append(f"{path}:1: fewer than {FEWEST_ROWS} values; add random and edge points")
    return findings


def check_header(tree, where, model, upper):
    """What is wrong with a model's shading header."""
    path = f"src/shade/{model}.h"
    if upper != model.upper():
        return [f"{where}: {upper} is not {model} in capitals; its tables are named so"]
    if not (tree / path).exists():
        return [f"{where}: there is no {path}; a model is named like its file"]
    defined = TABLES.findall((tree / path).read_text())
    return [f"{path}:1: does not define {upper}_{part}; it belongs here"
            for part in PARTS if f"{upper}_{part}" not in defined]


def check(tree):
    if not (tree / DEF).exists():
        return [f"{DEF}:1: missing; it lists the models"]
    code, _ = lint.split_comments((tree / DEF).read_text())
    lines = code.split("\n")
    findings, models = [], set()
    for match in ROW.finditer(code):
        model, upper = match.groups()
        models.add(model)
        number = lint.line_of(code, match.start())
        where = f"{DEF}:{number}"
        include = f'#include "shade/{model}.h"'
        if number < 2 or lines[number - 2].strip() != include:
            findings.append(f"{where}: the line above is not {include}; put it there")
        findings += check_header(tree, where, model, upper)
        findings += check_golden(tree, where, model)
    for path in lint.files(tree, "src/shade/*.h"):
        is_model = f"STRUCT({path.stem}_p)" in (tree / path).read_text()
        if is_model and path.stem not in models:
            findings.append(f"{path}:1: {path.stem} has no row in {DEF}; add its two lines")
    if not models:
        findings.append(f"{DEF}:1: no row was understood; rows are MODEL(name, NAME)")
    return findings


HEADER = "#define TOY_PARAMS(P) P(NUM)\n#define TOY_MANUAL(M)\nSTRUCT(toy_p) {};\n"
ROWS = '#include "shade/toy.h"\nMODEL(toy, TOY)\n'
CSV = "# made by hand\n" + "1,2,3\n" * 30
GOOD = {"src/shade/toy.h": HEADER, DEF: ROWS, "tests/golden/toy.csv": CSV}
BAD = [
    ({**GOOD, DEF: "MODEL(toy, TOY)\n"}, f"{DEF}:1: the line above"),
    ({**GOOD, DEF: '#include "shade/toy.h"\n\nMODEL(toy, TOY)\n'}, "the line above"),
    ({**GOOD, DEF: '#include "shade/toy.h"\nCOMPOSED(toy, TOYS, ANY)\n'}, "in capitals"),
    ({DEF: ROWS, "tests/golden/toy.csv": CSV}, "there is no src/shade/toy.h"),
    ({**GOOD, "src/shade/toy.h": "\n"}, "does not define TOY_PARAMS"),
    ({DEF: ROWS, "src/shade/toy.h": HEADER}, "has no tests/golden/toy.csv"),
    ({**GOOD, "tests/golden/toy.csv": "1,2\n" * 30}, "how it was made"),
    ({**GOOD, "tests/golden/toy.csv": "# by hand\n1,2\n"}, "fewer than"),
    ({**GOOD, DEF: "/* " + ROWS + " */\n"}, "add its two lines"),
]

if __name__ == "__main__":
    lint.main(check, BAD, GOOD)
