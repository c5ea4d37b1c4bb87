#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""results.py counts right: a test whose program is missing has failed, a skip needs its reason."""
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
OK = '<testcase name="ok" status="run"><system-out/></testcase>'
BAD = '<testcase name="bad" status="fail"><failure message=""/></testcase>'
GONE = ('<testcase name="gone" status="notrun"><skipped message="Unable to find executable"/>'
        '</testcase>')
SKIP = ('<testcase name="skip" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/>'
        '<system-out>skipped: clang is missing\n</system-out></testcase>')

# (test cases, allowed skips, more arguments, exit status, last line)
CASES = [
    (OK + OK, "", [], 0, "2 passed, 0 failed, 0 skipped"),
    (OK + BAD, "", [], 1, "1 passed, 1 failed, 0 skipped"),
    (OK + GONE, "* clang", ["--strict"], 1, "1 passed, 1 failed, 0 skipped"),
    (OK + SKIP, "", [], 0, "1 passed, 0 failed, 1 skipped"),
    (OK + SKIP, "", ["--strict"], 1, "1 passed, 0 failed, 1 skipped"),
    (OK + SKIP, "sk* clang # why", ["--strict"], 0, "1 passed, 0 failed, 1 skipped"),
    (OK + SKIP, "other clang", ["--strict"], 1, "1 passed, 0 failed, 1 skipped"),
    (OK + SKIP, "skip gcc", ["--strict"], 1, "1 passed, 0 failed, 1 skipped"),
    (OK + SKIP, "skip", ["--strict"], 1, "1 passed, 0 failed, 1 skipped"),
    (OK, "", ["--failed", "build of dev"], 1, "1 passed, 1 failed, 0 skipped"),
    ("", "", [], 1, "0 passed, 0 failed, 0 skipped"),
]


def main():
    wrong = 0
    for cases, allowed, more, status, last in CASES:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "a.xml").write_text(f"<testsuite>{cases}</testsuite>")
            (folder / "allowed").write_text(allowed)
            done = subprocess.run([sys.executable, HERE / "results.py", *more, "--allowed",
                                   folder / "allowed", folder], capture_output=True, text=True)
        got = done.returncode, (done.stdout.splitlines() or [""])[-1]
        if got != (status, last):
            print(f"{allowed!r} {more}: got {got}, want {(status, last)}\n{done.stderr}")
            wrong += 1
    print(f"{wrong} of {len(CASES)} cases are wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
