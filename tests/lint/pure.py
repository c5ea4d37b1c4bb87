#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""No stdio, no locale and no global effects in libndotl below its verbs: shade, base, core."""
import re

import lint

HEADERS = {"stdio.h", "locale.h", "wchar.h", "assert.h", "iostream"}
CALLS = re.compile(
    r"\b(v?[fsd]?n?w?printf|v?[fs]?scanf|strto(?:d|f|ld)|atof|setlocale|localeconv"
    r"|fopen|fputs|puts|putchar|fwrite|exit|abort|assert|rand|srand|strerror|getenv)\s*\(")
ALLOWED = {  # (file, word): reason
    ("src/base/process.c", "abort"): "a child process has no caller to report to",
    ("src/base/process.c", "exit"): "a child process has no caller to report to",
}
CURE = "libndotl prints nothing, never exits, knows no locale: use src/base (text, number, error)"


def check(tree):
    findings = []
    for path in lint.files(tree, "src/shade/**/*.[ch]", "src/base/**/*.[ch]", "src/core/**/*.[ch]",
                           "src/shade/*.def", "src/core/*.def"):
        code, _ = lint.split_comments((tree / path).read_text())
        code = re.sub(r'(?<!include )"(?:\\.|[^"\\\n])*"',
                      lambda match: lint.blank_except_newlines(match.group()), code)
        for match in re.finditer(r"#\s*include\s*[<\"]([^>\"]+)[>\"]", code):
            if match.group(1) in HEADERS:
                findings.append(f"{path}:{lint.line_of(code, match.start())}: "
                                f"includes {match.group(1)}; {CURE}")
        for match in CALLS.finditer(code):
            if (str(path), match.group(1)) not in ALLOWED:
                findings.append(f"{path}:{lint.line_of(code, match.start())}: "
                                f"calls {match.group(1)}; {CURE}")
    return findings


GOOD = {"src/core/a.c": '#include <string.h>\n/* printf( */\nconst char *s = "printf(";\n'
                        "void nd_put(int x);\nvoid f(void) { nd_put(1); }\n",
        "src/check/a.c": "#include <stdio.h>\n"}
BAD = [
    ({"src/core/a.c": "#include <stdio.h>\n"}, "includes stdio.h"),
    ({"src/base/a.c": "\nint f(void) { return printf(s); }\n"}, "src/base/a.c:2: calls printf"),
    ({"src/core/a.c": "double f(const char *s) { return strtod(s, 0); }\n"}, "calls strtod"),
    ({"src/core/a.c": "void f(void) { snprintf(a, 3, b); }\n"}, "calls snprintf"),
    ({"src/shade/a.h": "#include <locale.h>\n"}, "includes locale.h"),
]

if __name__ == "__main__":
    lint.main(check, BAD, GOOD)
