#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fills the column "evidence" of docs/formulas.md from the golden tables and the tests.

    tools/formulas/evidence.py           after rows, tags or tests have changed
"""
import rows


def updated(text):
    golden, tests = rows.golden_evidence(), rows.test_evidence()
    lines = []
    for line in text.splitlines():
        match = rows.LINE.match(line)
        if match:
            cells = list(match.groups())
            cells[4] = rows.evidence(cells[0], golden, tests)
            line = "| " + " | ".join(cells) + " |"
        lines.append(line)
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    path = rows.TREE / "docs/formulas.md"
    path.write_text(updated(path.read_text()))
