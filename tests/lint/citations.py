#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Citation keys such as [Heitz14] in comments and docs resolve in docs/references.bib."""
import re

import lint

KEY = re.compile(r"\[([A-Z][A-Za-z]*[a-z][A-Za-z]*\d{2}(?:\d{2})?[a-z]?|OpenPBR|glTF)\](?!\()")
ENTRY = re.compile(r"^@(\w+)\{([^,\s]+),(.*?)^\}", re.M | re.S)
BIB = "docs/references.bib"


def check_entries(text):
    """The keys of the bibliography, and what is wrong with its entries."""
    keys, findings = set(), []
    for match in ENTRY.finditer(text):
        where = f"{BIB}:{lint.line_of(text, match.start())}"
        kind, key, body = match.groups()
        if key in keys:
            findings.append(f"{where}: {key} stands twice; remove one")
        keys.add(key)
        for field in ["title", "year", "author" if kind != "online" else "title"]:
            if not re.search(rf"^\s*{field}\s*=", body, re.M):
                findings.append(f"{where}: {key} has no {field}; add it")
    return keys, findings


def check(tree):
    bib = tree / BIB
    keys, findings = check_entries(bib.read_text() if bib.exists() else "")
    for path in lint.files(tree, "src/**/*.[ch]", "src/**/*.def", "src/**/*.inc", "include/**/*.h",
                           "cli/*.[ch]", "cli/*.def", "tests/**/*.[ch]", "tools/**/*.py",
                           "docs/**/*.md", "README.md"):
        # Strings count too: the manuals of the models are strings, and an index is no [Name14].
        text = (tree / path).read_text()
        for match in KEY.finditer(text):
            if match.group(1) not in keys:
                where = f"{path}:{lint.line_of(text, match.start())}"
                findings.append(f"{where}: [{match.group(1)}] is not in {BIB}; add the entry or "
                                "correct the key")
    return findings


ENTRY_A = "@article{Heitz14,\n  author = {A},\n  title = {T},\n  year = {2014},\n}\n"
GOOD = {BIB: ENTRY_A, "src/shade/a.h": "/* [Heitz14] eq. 99 */\nint a[N];\n"}
BAD = [
    ({BIB: ENTRY_A, "src/shade/a.h": "\n/* [Walter07] eq. 3 */\n"}, "src/shade/a.h:2: [Walter07]"),
    ({BIB: ENTRY_A, "src/core/m.def": 'TEXT("by [Smith1967].")\n'}, "[Smith1967]"),
    ({BIB: ENTRY_A, "include/ndotl/a.h": "/* [glTF] */\n"}, "[glTF]"),
    ({BIB: ENTRY_A + ENTRY_A}, "stands twice"),
    ({BIB: "@article{Heitz14,\n  author = {A},\n  title = {T},\n}\n"}, "has no year"),
]

if __name__ == "__main__":
    lint.main(check, BAD, GOOD)
