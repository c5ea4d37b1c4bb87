#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs what README.md and docs/ tell the reader to type.

A ```c block is a whole program: it is compiled as C11 without warnings, linked with libndotl and
run. A ```sh block runs in a fresh folder with the built ndotl in PATH. In both, each line that
begins with `#> ` or `//> ` must appear in the output, in that order. A ```console block is for
commands that change the machine or the source tree, and is not run.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
LANGUAGES = {"c", "sh", "console", "text", "json", "cmake", "glsl"}


def blocks(tree):
    """(file:line, language, text) of every fenced block of the documentation."""
    for path in [tree / "README.md", tree / "CONTRIBUTING.md", *sorted(tree.glob("docs/**/*.md"))]:
        if path.exists():
            text = path.read_text()
            for match in FENCE.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                yield f"{path.relative_to(tree)}:{line}", match.group(1), match.group(2)


def run(words, folder, environment):
    done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True,
                          timeout=240)
    return done.returncode, done.stdout, done.stderr


def run_shell(text, folder, environment):
    return run(["bash", "-euo", "pipefail", "-c", text], folder, environment)


def run_c(text, folder, environment):
    (folder / "program.c").write_text(text)
    tree, build = environment["NDOTL_SOURCE"], environment["NDOTL_BUILD"]
    flags = ["-fsanitize=" + environment["NDOTL_SANITIZE"]] if environment["NDOTL_SANITIZE"] else []
    code, out, err = run([environment["NDOTL_CC"], "-std=c11", "-Wall", "-Wextra", "-Wpedantic",
                          "-Werror", f"-I{tree}/include", *flags, "program.c", "-o", "program",
                          f"{build}/libndotl.a", "-lm", "-pthread"], folder, environment)
    return run(["./program"], folder, environment) if code == 0 else (code, out, err)


def missing_line(text, output):
    """The first promised line that the output lacks, or None."""
    at = 0
    for promise in re.findall(r"^\s*(?:#|//)> (.*)$", text, re.M):
        found = output.find(promise, at)
        if found < 0:
            return promise
        at = found + len(promise)
    return None


def check(tree, environment):
    findings, count = [], 0
    for where, language, text in blocks(tree):
        if language not in LANGUAGES:
            findings.append(f"{where}: a block in '{language}'; name its language")
        if language not in ("c", "sh"):
            continue
        count += 1
        with tempfile.TemporaryDirectory() as folder:
            runner = run_c if language == "c" else run_shell
            code, out, err = runner(text, pathlib.Path(folder), environment)
        missing = missing_line(text, out)
        if code:
            findings.append(f"{where}: exit {code}; correct the {language} block\n{out}{err}")
        elif missing is not None:
            findings.append(f"{where}: the output lacks '{missing}'; correct it\n{out}{err}")
    return findings, count


BAD = [("```sh\nfalse\n```\n", "exit 1"), ("```sh\necho 1\n#> 2\n```\n", "lacks '2'"),
       ("```sh\necho 2; echo 1\n#> 1\n#> 2\n```\n", "lacks '2'"),
       ("```c\nint main(void) { return x; }\n```\n", "correct the c block"),
       ("```c\nint main(void) { return 3; }\n```\n", "exit 3"), ("```\nls\n```\n", "name its")]


def bites(environment):
    findings = []
    for text, expected in BAD + [("```sh\necho 1\n#> 1\n```\n", None)]:
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "README.md").write_text(text)
            found, _ = check(pathlib.Path(folder), environment)
        if bool(found) != bool(expected) or (expected and expected not in found[0]):
            findings.append(f"{text!r}: expected {expected}, found {found}")
    return findings, len(BAD)


def main():
    environment = dict(os.environ)
    environment["PATH"] = environment["NDOTL_BUILD"] + ":" + environment["PATH"]
    if "--bites" in sys.argv[1:]:
        findings, count = bites(environment)
    else:
        findings, count = check(pathlib.Path(environment["NDOTL_SOURCE"]), environment)
        if not count:
            findings.append("README.md:1: no block was found to run")
    print("\n".join(findings + [f"{len(findings)} findings in {count} blocks"]))
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
