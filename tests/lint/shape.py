#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Shape of the files: at most 800 lines of 100 columns, no tabs, no trailing blanks, SPDX line."""
import re

import lint

SOURCES = [f"{top}/**/*.{kind}" for top in ("src", "include", "cli", "tests", "bench", "examples")
           for kind in ("c", "h", "cpp", "def", "py", "cmake", "sh", "glsl")]
SOURCES += ["tools/**/*.py", "tools/**/*.sh", "cmake/*.cmake", "**/CMakeLists.txt", "run", "test",
            ".ci/run"]
MOST_LINES, MOST_COLUMNS, README_LINES = 800, 100, 250
BANNER = re.compile(r"^\s*(/\*|//|#)\s*[-=*#]{12,}\s*(\*/)?$")
UNFINISHED = re.compile(r"\b(TODO|FIXME|XXX)\b")


def check_lines(path, lines):
    findings = []
    for number, line in enumerate(lines, 1):
        where = f"{path}:{number}"
        if len(line) > MOST_COLUMNS:
            findings.append(f"{where}: {len(line)} columns; break the line at {MOST_COLUMNS}")
        if "\t" in line:
            findings.append(f"{where}: a tab; use 4 spaces")
        if line != line.rstrip():
            findings.append(f"{where}: blanks at the end; remove them")
        if BANNER.match(line):
            findings.append(f"{where}: a banner; remove it")
        if UNFINISHED.search(line) and path.name != "shape.py":
            findings.append(f"{where}: unfinished; finish it or describe the limit")
    return findings


def check(tree):
    findings = []
    for path in lint.files(tree, *SOURCES):
        lines = (tree / path).read_text().split("\n")
        findings += check_lines(path, lines)
        if len(lines) - 1 > MOST_LINES:
            findings.append(f"{path}:{MOST_LINES + 1}: {len(lines) - 1} lines; split the file by "
                            f"what changes together (data tables go into .inc)")
        if not any("SPDX-License-Identifier: Apache-2.0" in line for line in lines[:3]):
            findings.append(f"{path}:1: no SPDX line; begin with SPDX-License-Identifier")
        elif path.parts[:2] == ("src", "shade") and "OR MIT-0" not in "".join(lines[:3]):
            findings.append(f"{path}:1: shading text is Apache-2.0 OR MIT-0; say so in that line")
    readme = tree / "README.md"
    if readme.exists() and len(readme.read_text().splitlines()) > README_LINES:
        findings.append(f"README.md:{README_LINES + 1}: too long; move detail to docs/")
    return findings


SPDX = "/* SPDX-License-Identifier: Apache-2.0 */\n"
GOOD = {"src/core/a.c": SPDX + "int a;\n",
        "src/shade/a.h": "/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */\n"}
BAD = [
    ({"src/core/a.c": "int a;\n"}, "src/core/a.c:1: no SPDX line"),
    ({"src/shade/a.h": SPDX}, "OR MIT-0"),
    ({"cli/a.c": SPDX + "x" * 101 + "\n"}, "cli/a.c:2: 101 columns"),
    ({"cli/a.c": SPDX + "\tint a;\n"}, "a tab"),
    ({"cli/a.c": SPDX + "int a; \n"}, "blanks at the end"),
    ({"cli/a.c": SPDX + "int a;\n" * 800}, "801 lines"),
    ({"cli/a.c": SPDX + "/* " + "TO" + "DO */\n"}, "unfinished"),
    ({"cli/a.c": SPDX + "/* ------------------- */\n"}, "a banner"),
    ({"README.md": "a\n" * 251}, "README.md:251"),
]

if __name__ == "__main__":
    lint.main(check, BAD, GOOD)
