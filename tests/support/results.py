#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sums up the JUnit files of several ctest runs; the last line is `N passed, N failed, N skipped`.

Exit status 1 when a test failed, or, with --strict, when a skip is not allowed.
"""
import argparse
import fnmatch
import pathlib
import sys
import xml.etree.ElementTree as ET


def read_allowed(path):
    """The (test name pattern, missing package or input) pairs of an allowed_skips file."""
    pairs = []
    for line in path.read_text().splitlines():
        words = line.split("#")[0].split()
        if words:
            pairs.append((words[0], " ".join(words[1:])))
    return pairs


def is_allowed(name, reason, allowed):
    return any(fnmatch.fnmatch(name, pattern) and missing and missing in reason
               for pattern, missing in allowed)


def is_skipped(case):
    """Whether the test itself said so; one whose program is missing also has status notrun."""
    skipped = case.find("skipped")
    return skipped is not None and "SKIP_RETURN_CODE" in skipped.get("message", "")


def skip_reason(case):
    """What the skipped test printed, on one line."""
    lines = [line.strip() for line in (case.findtext("system-out") or "").splitlines()]
    told = [line for line in lines if "skip" in line.lower()] or [line for line in lines if line]
    return told[-1] if told else "no reason printed"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--strict", action="store_true")
    parser.add_argument("--failed", action="append", default=[], help="a step that failed")
    parser.add_argument("--allowed", type=pathlib.Path, required=True)
    parser.add_argument("results", type=pathlib.Path, help="the folder of the JUnit files")
    options = parser.parse_args()

    allowed = read_allowed(options.allowed)
    passed, failures, skips, refused = 0, list(options.failed), 0, 0
    for file in sorted(options.results.glob("*.xml")):
        for case in ET.parse(file).getroot().iter("testcase"):
            name = case.get("name")
            if case.get("status") == "run":
                passed += 1
            elif is_skipped(case):
                skips += 1
                reason = skip_reason(case)
                fine = is_allowed(name, reason, allowed)
                refused += not fine
                print(f"skipped {file.stem} {name}: {reason}"
                      + ("" if fine else f" (not in {options.allowed})"))
            else:
                failures.append(f"{file.stem} {name}")
    for failure in failures:
        print(f"FAILED {failure}")
    if options.strict and refused:
        print(f"{refused} skips are not allowed: install what they miss, or name it in "
              f"{options.allowed}")
    print(f"{passed} passed, {len(failures)} failed, {skips} skipped")
    return 1 if failures or (options.strict and refused) or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
