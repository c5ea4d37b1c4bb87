#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every public header compiles alone, twice in a row, as C11 and as C++17 without a warning."""
import os
import shlex
import shutil
import subprocess
import sys
import tempfile

import lint

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror", "-fsyntax-only"]


def compilers():
    """(words, suffix) for C and C++: the compiler of the build and the C++ one of its kind."""
    cc = os.environ.get("NDOTL_CC") or shutil.which("cc") or "gcc"
    cxx = "clang++" if "clang" in os.path.basename(cc) else "g++"
    if not shutil.which(cxx):
        print(f"skipped: {cxx} is missing")
        sys.exit(77)
    return [(shlex.split(cc) + ["-std=c11"], "c"), ([cxx, "-std=c++17"], "cpp")]


def check(tree):
    findings = []
    for path in lint.files(tree, "include/ndotl/*.h"):
        name = path.relative_to("include")
        for command, suffix in compilers():
            with tempfile.NamedTemporaryFile("w", suffix="." + suffix) as source:
                source.write(f"#include <{name}>\n#include <{name}>\n")
                source.flush()
                done = subprocess.run(command + WARNINGS + [f"-I{tree}/include", source.name],
                                      capture_output=True, text=True)
            if done.returncode:
                findings.append(f"{path}:1: does not compile alone as {command[-1][5:]}; include "
                                f"what it uses, in words of both languages\n{done.stderr}")
    return findings


GOOD = {"include/ndotl/a.h": "#ifndef A\n#define A\n#include <stddef.h>\nsize_t a(void);\n#endif\n"}
BAD = [
    ({"include/ndotl/a.h": "size_t a(void);\n"}, "a.h:1: does not compile alone as c11"),
    ({"include/ndotl/a.h": "int class;\n"}, "alone as c++17"),
    ({"include/ndotl/a.h": "typedef struct { int a; } b; struct c { int a; };\n"}, "alone as"),
]

if __name__ == "__main__":
    lint.main(check, BAD, GOOD)
