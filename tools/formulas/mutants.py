# SPDX-License-Identifier: Apache-2.0
"""A copy of the sources in which each function of the map can be made wrong at run time.

Every `return` of such a function is multiplied by nd_wrong[i], which is 1 (exact, so nothing
changes) unless the environment variable NDOTL_WRONG is i: then it is 1.01. A condition becomes true
instead."""
import pathlib
import re
import shutil
import subprocess

import rows

# What 1.01 times a value of each type is.
PARTS = {"num": [""], "float": [""], "vec3": [".x", ".y", ".z"], "ratio": [".n"],
         "visibility": [".n", ".n_cos"], "ndl_rgb": [".r", ".g", ".b"],
         "ndl_vec3": [".x", ".y", ".z"], "widths": [".x", ".y"]}
FLAGS = ["-std=c11", "-O1", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math",
         "-D_POSIX_C_SOURCE=200809L", "-DNDL_PLAIN_LOOPS", "-w", "-pthread"]
SWITCH = """#include <stdlib.h>
float nd_wrong[{count}];
__attribute__((constructor)) static void choose(void) {{
    const char *which = getenv("NDOTL_WRONG");
    for (int i = 0; i < {count}; i++) nd_wrong[i] = 1.0f;
    if (which) nd_wrong[atoi(which)] = 1.01f;
}}
"""


def body_end(text, start):
    """The index after the brace that closes the one at start."""
    depth = 0
    for i in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return i + 1
    raise ValueError("unbalanced braces")


def wrong_return(kind, index):
    def replaced(match):
        if kind == "cond":
            return f"return nd_wrong[{index}] == 1.0f ? ({match.group(1)}) : 1;"
        scaled = "".join(f" wrong_{part} *= nd_wrong[{index}];" for part in PARTS[kind])
        return f"{{ {kind} wrong_ = {match.group(1)};{scaled} return wrong_; }}"
    return replaced


def made_wrong(text, function, index):
    """The text with the function's returns rewritten, or None where it is not defined."""
    head = re.search(rf"^(?:FN |static |inline )*(\w+) {function}\([^;{{}}]*\)\s*\{{", text,
                     re.M | re.S)
    if not head:
        return None
    end = body_end(text, head.end() - 1)
    body, count = re.subn(r"\breturn\b\s*([^;]*);", wrong_return(head.group(1), index),
                          text[head.end():end])
    if not count:
        raise ValueError(f"{function} returns nothing")
    return text[:head.end()] + body + text[end:]


def copy_sources(tree):
    for folder in ("src", "include", "tests/support", "tests/formulas", "tests/golden"):
        shutil.copytree(rows.TREE / folder, tree / folder)
    dispatch = tree / "src/core/dispatch.c"  # the scalar kernels only
    dispatch.write_text(re.sub(r"defined\(__(x86_64|aarch64)__\)", "0", dispatch.read_text()))
    prelude = tree / "src/shade/prelude_c.h"
    prelude.write_text("extern float nd_wrong[];\n" + prelude.read_text())


def spoil(tree, functions):
    for index, function in enumerate(functions):
        found = 0
        for pattern in rows.SOURCES:
            for path in sorted(tree.glob(pattern)):
                text = made_wrong(path.read_text(), function, index)
                if text is not None:
                    found += 1
                    declared = "" if path.suffix == ".h" else "extern float nd_wrong[];\n"
                    path.write_text(declared + text)
        if not found:
            raise ValueError(f"{function} is not defined")
    (tree / "switch.c").write_text(SWITCH.format(count=len(functions)))


def build(tree, functions, compiler):
    """Builds the test programs of the map in `tree`; they take NDOTL_WRONG."""
    tree = pathlib.Path(tree)
    copy_sources(tree)
    spoil(tree, functions)
    include = [f"-I{tree}/{folder}" for folder in ("src", "include", "tests/support")]
    sources = [str(tree / "switch.c")]
    sources += sorted(str(path) for folder in ("base", "core")
                      for path in (tree / "src" / folder).glob("*.c"))
    objects = tree / "objects"
    objects.mkdir()
    subprocess.run([compiler, *FLAGS, *include, "-c", *sources], cwd=objects, check=True)
    library = sorted(str(path) for path in objects.glob("*.o"))
    tests = {*rows.READERS.values(), *(f"formulas/{name}" for name in rows.PROGRAMS)}
    for test in sorted(tests):
        subprocess.run([compiler, *FLAGS, *include, str(tree / f"tests/{test}.c"), *library,
                        "-o", str(tree / pathlib.Path(test).name), "-lcmocka", "-lm"], check=True)
