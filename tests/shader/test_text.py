#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every header of src/shade, by itself, is C float, C double (ND_WIDE) and, through cpp with the
GLSL prelude, a GLSL 4.50 and a GLSL ES 3.00 shader whose main calls every function."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TREE = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
COMPILER = os.environ.get("NDOTL_CC", "cc")
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wdouble-promotion", "-Werror"]
NO_TEXT = {"prelude_c.h", "prelude_glsl.h"}

# Version line, stage, entry head and the statement that makes the results count.
TARGETS = {
    "GLSL 4.50": ("#version 450\nlayout(location = 0) in vec3 varied;\n"
                  "layout(location = 0) out vec4 result;\n", "frag"),
    "GLSL ES 3.00": ("#version 300 es\nprecision highp float;\nprecision highp int;\n"
                     "in vec3 varied;\nout vec4 result;\n", "frag"),
}
TABLES = ("vec3 lut1(int t, float x) { return vec3(float(t) * x); }\n"
          "float lut2(int t, float x, float y) { return float(t) * x * y; }\n")
FUNCTION = re.compile(r"^[ \t]*(\w+)[ \t]+(\w+)\(([^()]*)\)\s*\{", re.M)


def field_macros():
    """FIELD and its kinds, as the C build defines them: they turn a parameter list into fields."""
    schema = (TREE / "src/core/schema.h").read_text()
    return "".join(line + "\n" for line in schema.splitlines()
                   if re.match(r"#define FIELD[_(]", line))


def headers():
    return sorted(path for path in (TREE / "src/shade").glob("*.h") if path.name not in NO_TEXT)


def compile_c(header, wide, folder):
    """Warnings and errors of the header as C, or an empty text."""
    unit = pathlib.Path(folder) / "unit.c"
    unit.write_text(("#define ND_WIDE\n" if wide else "") + '#include "shade/math.h"\n'
                    + field_macros() + f'#include "shade/{header.name}"\n'
                    "int main(void) { return 0; }\n")
    run = subprocess.run([COMPILER, "-std=c11", "-ffp-contract=off", "-fsyntax-only", *WARNINGS,
                          f"-I{TREE}/src", unit], capture_output=True, text=True)
    return run.stderr if run.returncode else ""


def glsl_body(header, folder):
    """The header's text, expanded for GLSL."""
    unit = pathlib.Path(folder) / "unit.h"
    unit.write_text(field_macros() + f'#include "shade/math.h"\n#include "shade/{header.name}"\n')
    run = subprocess.run(["cpp", "-P", "-undef", "-nostdinc", f"-I{TREE}/src", "-imacros",
                          TREE / "src/shade/prelude_glsl.h", unit],
                         capture_output=True, text=True, check=True)
    return run.stdout


def calls_of(body):
    """Statements that call every function of the text with values the compiler cannot know."""
    values = {"float": "varied.x", "vec3": "varied", "bool": "(varied.x > varied.y)",
              "int": "int(varied.z)"}
    declared, statements = [], []
    for kind, name, parameters in FUNCTION.findall(body):
        arguments = []
        for parameter in filter(None, (p.strip() for p in parameters.split(","))):
            of = parameter.split()[0]
            if of not in values:
                declared.append(of)
                arguments.append(f"the_{of}")
            else:
                arguments.append(values[of])
        call = f"{name}({', '.join(arguments)})"
        use = {"float": f"sum += {call};", "vec3": f"sum += dot({call}, varied);",
               "bool": f"sum += {call} ? 1.0 : 0.0;", "int": f"sum += float({call});"}
        statements.append(use.get(kind, f"{kind} from_{name} = {call};"))
    structs = [f"{of} the_{of};" for of in sorted(set(declared))]
    return structs, statements


def compile_glsl(body, target, folder):
    """The validator's complaints, or an empty text."""
    head, stage = TARGETS[target]
    structs, statements = calls_of(body)
    text = (head + TABLES + body + "void main() {\nfloat sum = 0.0;\n" + "\n".join(structs)
            + "\n" + "\n".join(statements) + "\nresult = vec4(sum);\n}\n")
    unit = pathlib.Path(folder) / f"unit.{stage}"
    unit.write_text(text)
    run = subprocess.run(["glslangValidator", unit], capture_output=True, text=True)
    if run.returncode == 0:
        return ""
    lines = text.splitlines()
    where = re.search(r"ERROR: \d*:?(?:[^:]*:)?(\d+):", run.stdout)
    near = lines[int(where.group(1)) - 1] if where and int(where.group(1)) <= len(lines) else ""
    return run.stdout + near


def bites(folder):
    """Texts that must be refused, so that the check is known to see."""
    good = "float twice(float x) { return x + x; }\n"
    bad = "float twice(float sample_) { int x = sample_; return x; }\n"
    return (not compile_glsl(good, "GLSL 4.50", folder) and
            all(compile_glsl(bad, target, folder) for target in TARGETS))


def main():
    failures = 0
    has_glslang = shutil.which("glslangValidator") is not None
    with tempfile.TemporaryDirectory() as folder:
        if has_glslang and not bites(folder):
            print("the validator does not refuse a wrong shader")
            failures += 1
        for header in headers():
            wrong = {f"C {'double' if wide else 'float'}": compile_c(header, wide, folder)
                     for wide in (False, True)}
            if has_glslang:
                body = glsl_body(header, folder)
                wrong.update({target: compile_glsl(body, target, folder) for target in TARGETS})
            for target, complaint in wrong.items():
                if complaint:
                    failures += 1
                    print(f"src/shade/{header.name} as {target}:\n{complaint}")
            count = len(FUNCTION.findall(body)) if has_glslang else 0
            print(f"{header.name}: {count} functions, {'failed' if any(wrong.values()) else 'ok'}")
    if failures or not headers():
        return 1
    if not has_glslang:
        print("skipped: glslangValidator (package glslang-tools) is missing")
        return 77
    return 0


if __name__ == "__main__":
    sys.exit(main())
