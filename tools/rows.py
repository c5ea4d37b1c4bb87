#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes cli/rows.inc: which functions of src/shade name which rows of the formula inventory.

The rows stand in the comment before a function, as S3.21 or as S4.26 to S4.28. `ndotl models ROW`
prints what this finds. Usage: tools/rows.py [--check]
"""
import pathlib
import re
import sys

TREE = pathlib.Path(__file__).resolve().parents[1]
TARGET = TREE / "cli" / "rows.inc"
COMMENT = re.compile(r"/\*(?:(?!\*/).)*\*/\s*|FN \w+ (\w+)\(", re.S)
ROW = re.compile(r"\bS(\d)\.(\d+)(?: to S\1\.(\d+))?")
HEAD = ("/* SPDX-License-Identifier: Apache-2.0 */\n"
        "/* Written by tools/rows.py from the comments of src/shade: "
        "ROW(row, function, file). */\n")


def rows_of(comment):
    """The rows that a comment names, as (document, number)."""
    for match in ROW.finditer(comment):
        first = int(match.group(2))
        for number in range(first, int(match.group(3) or first) + 1):
            yield int(match.group(1)), number


def functions(text):
    """(function, comment) of every function; one without a comment shares the one before."""
    comment, end = "", -1
    for match in COMMENT.finditer(text):
        if match.group(1):
            if text[end:match.start()].strip() and text[end:match.start()].count("\n\n"):
                comment = ""
            yield match.group(1), comment
        else:
            comment = match.group()
        end = match.end()


def table():
    found = set()
    for path in sorted((TREE / "src" / "shade").glob("*.h")):
        for name, comment in functions(path.read_text()):
            found |= {(row, name, path.name) for row in rows_of(comment)}
    return HEAD + "".join(f'ROW("S{row[0]}.{row[1]}", "{name}", "{file}")\n'
                          for row, name, file in sorted(found))


def main():
    text = table()
    if "--check" in sys.argv[1:]:
        if not TARGET.exists() or TARGET.read_text() != text:
            print("cli/rows.inc:1: does not match src/shade; run tools/rows.py")
            return 1
        return 0
    TARGET.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
