#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes tests/golden/*.csv: reference values that share nothing with the C code.

Usage: tools/golden/generate.py [--check] [name...]
  name     lambert, microfacet, ..., sums, albedo, conversions (default: all)
  --check  only compares the reference with published and separately computed numbers
Needs Debian's python3-mpmath. The same command writes the same bytes.
"""
import os
import sys
import time

import check
import files

OUT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "golden")


def write(name, text):
    path = os.path.join(OUT, name + ".csv")
    with open(path + ".part", "w", encoding="ascii", newline="\n") as f:
        f.write(text)
    os.replace(path + ".part", path)


def main(args):
    only_check = "--check" in args
    names = [a for a in args if not a.startswith("-")] or list(files.FILES)
    unknown = [n for n in names if n not in files.FILES]
    if unknown or any(a.startswith("-") and a != "--check" for a in args):
        sys.exit("generate.py: unknown argument: " + " ".join(unknown or args))
    failures = check.run()
    if failures:
        sys.exit("generate.py: %d self-checks failed; nothing written" % failures)
    if only_check:
        return
    covered = set()
    for name in names:
        start = time.time()
        text, summary, tags = files.FILES[name]()
        covered |= tags
        write(name, text)
        print("%-14s %7d bytes %5.1f s  %s" % (name, len(text), time.time() - start, summary))
    if len(names) == len(files.FILES):
        missing = files.uncovered(covered)
        if missing:
            sys.exit("generate.py: rows of the inventory without a case: " + " ".join(missing))


if __name__ == "__main__":
    main(sys.argv[1:])
