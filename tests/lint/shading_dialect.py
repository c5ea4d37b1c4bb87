#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The shading text keeps to the dialect of src/shade/RULES.md, which all targets share: checked by
words and shapes, not by a compiler. The preludes, which are C and GLSL, are left out."""
import re
import struct

import lint
from reserved_words import BUILTINS, RESERVED

PRELUDES = ("src/shade/prelude_c.h", "src/shade/prelude_glsl.h")
BASE_TYPES = {"num", "vec3", "cond", "table1", "table2"}
FORBIDDEN = {
    "?": "use sel(c, a, b)", "&&": "use both(a, b)", "||": "use either(a, b)",
    "->": "no pointers", "[": "no arrays: data comes through lut1 and lut2",
    "++": "no loops", "--": "no loops", "%": "use floor_", "<<": "no bits", ">>": "no bits",
    "~": "no bits", "^": "no bits", "&": "no pointers and no bits", "|": "no bits",
}
KEYWORDS = {
    "for": "no loops", "while": "no loops", "do": "no loops", "goto": "no jumps",
    "if": "use sel(c, a, b)", "else": "use sel(c, a, b)", "switch": "use sel(c, a, b)",
    "float": "the type is num", "double": "the type is num", "bool": "the type is cond",
    "int": "numbers are num", "unsigned": "numbers are num", "static": "functions begin with FN",
    "const": "no qualifiers", "inline": "functions begin with FN", "typedef": "use STRUCT",
    "struct": "use STRUCT", "void": "functions return a value",
}
NUMBER = re.compile(r"(?<![\w.])((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)([fFuUlL]*)(?!\w)")
FUNCTION = re.compile(r"\bFN\s+(\w+)\s+(\w+)\s*\(([^()]*)\)\s*\{([^{}]*)\}")
STRUCTURE = re.compile(r"\bSTRUCT\s*\(\s*(\w+)\s*\)\s*\{([^{}]*)\}\s*;")


def is_float(text):
    """True when the decimal number is a float without rounding."""
    value = float(text)
    try:
        return struct.unpack("f", struct.pack("f", value))[0] == value
    except OverflowError:
        return False


def blank_directives(code):
    """The code without its preprocessor lines."""
    return re.sub(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", lambda m: lint.blank_except_newlines(m.group()),
                  code, flags=re.M)


def known_names(tree, texts):
    """(types, functions) that the text may use: of the preludes and of all shading headers."""
    types, functions = set(BASE_TYPES), {"NUM"}
    for name in PRELUDES:
        path = tree / name
        if path.exists():
            text = path.read_text()
            functions |= set(re.findall(r"^#define (\w+)\(", text, re.M))
            functions |= set(re.findall(r"\bFN \w+ (\w+)\(", text))
    for code in texts.values():
        types |= set(re.findall(r"\bSTRUCT\s*\(\s*(\w+)", code))
        functions |= set(re.findall(r"\bFN\s+\w+\s+(\w+)\s*\(", code))
    return types, functions


def number_findings(code):
    """(position, complaint) of the literals outside NUM(...)."""
    for wrapped in re.finditer(r"\bNUM\(([^()]*)\)", code):
        if not re.fullmatch(r"-?\d+(?:\.\d*(?:[eE][-+]?\d+)?|[eE][-+]?\d+)", wrapped.group(1)):
            yield wrapped.start(), (f"NUM({wrapped.group(1)}); NUM takes one decimal number with a "
                                    "point or an exponent and no suffix")
    outside = re.sub(r"\bNUM\([^()]*\)", lambda m: lint.blank_except_newlines(m.group()), code)
    for match in NUMBER.finditer(outside):
        digits, suffix = match.groups()
        if suffix != "f" or not re.search(r"[.eE]", digits):
            yield match.start(), f"{match.group()}; a number is written 0.5f or NUM(0.5)"
        elif not is_float(digits):
            yield match.start(), f"{match.group()} is no exact float; write NUM({digits})"


def function_findings(code, types):
    """(position, complaint) of the functions' shapes."""
    for match in FUNCTION.finditer(code):
        kind, name, parameters, body = match.groups()
        start = match.start(4)
        if name in BUILTINS:
            yield match.start(2), f"function {name} is built into a target; choose another name"
        for declared in [kind] + [p.split()[0] for p in parameters.split(",") if p.split()]:
            if declared not in types:
                yield match.start(1), f"unknown type {declared}"
        names = [p.split()[-1] for p in parameters.split(",") if p.split()]
        for parameter in names:
            for hit in re.finditer(rf"(?<![\w.]){parameter}(?:\s*\.\s*\w+)?\s*[-+*/]?=(?!=)", body):
                yield start + hit.start(), f"assigns to parameter {parameter}; declare another name"
        if len(re.findall(r"\breturn\b", body)) != 1:
            yield match.start(2), f"{name} has not exactly one return; use sel(c, a, b)"
        at = 0
        for statement in body.split(";"):
            words = statement.split()
            before, flat = None, statement
            while flat != before:
                before, flat = flat, re.sub(r"\([^()]*\)", "", flat)
            if words and words[0] in types and "," in flat:
                yield start + at, "two names in one declaration; write two statements"
            at += len(statement) + 1


def pointer_findings(code, types):
    for match in re.finditer(rf"\b(?:{'|'.join(sorted(types))})\s*\*", code):
        yield match.start(), "no pointers: structs go by value"


def global_findings(code):
    """(position, complaint) of what is neither a function nor a struct."""
    rest = code
    for pattern in (FUNCTION, STRUCTURE):
        rest = pattern.sub(lambda m: lint.blank_except_newlines(m.group()), rest)
    match = re.search(r"\S", rest)
    if match:
        line = rest[match.start():].split("\n")[0].strip()
        yield match.start(), f"'{line}' is neither FN nor STRUCT; no globals, no prototypes"


def word_findings(code, functions):
    for match in re.finditer(r"\b[A-Za-z_]\w*\b", code):
        word = match.group()
        if word in KEYWORDS:
            yield match.start(), f"{word}; {KEYWORDS[word]}"
        elif word in RESERVED:
            yield match.start(), f"{word} is reserved in {RESERVED[word]}; choose another name"
        elif "__" in word:
            yield match.start(), f"{word}; two underscores are reserved"
        elif (re.match(r"\s*\(", code[match.end():]) and word not in functions
              and word not in ("STRUCT", "return") and not word.isupper()):
            yield match.start(), f"calls {word}, which is in no prelude and no shading header"


def symbol_findings(code):
    for match in re.finditer(r"\+\+|--|&&|\|\||->|<<|>>|!(?!=)|[?\[%~^&|]", code):
        cure = FORBIDDEN.get(match.group(), "use not_(a)")
        yield match.start(), f"'{match.group()}'; {cure}"


def check(tree):
    paths = [p for p in lint.files(tree, "src/shade/*.h") if str(p) not in PRELUDES]
    raw = {p: lint.split_comments((tree / p).read_text())[0] for p in paths}
    texts = {p: blank_directives(code) for p, code in raw.items()}
    types, functions = known_names(tree, texts)
    findings = []
    for path in paths:
        code, found = texts[path], []
        for hit in re.finditer(r"##", raw[path]):
            found.append((hit.start(), "'##'; GLSL's preprocessor has no pasting"))
        constants = re.sub(r"^(?!#define [A-Z_0-9]+ NUM\().*$", lambda m: " " * len(m.group()),
                           raw[path], flags=re.M)
        found += number_findings(re.sub(r"^#define [A-Z_0-9]+ ", lambda m: " " * len(m.group()),
                                        constants, flags=re.M))
        found += number_findings(code)
        found += function_findings(code, types)
        found += pointer_findings(code, types)
        found += global_findings(code)
        found += word_findings(code, functions)
        found += symbol_findings(code)
        findings += [f"{path}:{lint.line_of(raw[path], at)}: {what} (src/shade/RULES.md)"
                     for at, what in sorted(found)]
    return findings


PRELUDE = "FN num sel(cond c, num a, num b) { return c ? a : b; }\n#define exp_(x) exp(x)\n"


def model(text):
    return {PRELUDES[0]: PRELUDE, "src/shade/a.h": text}


GOOD = model('#ifndef A\n#define A\n#include "shade/common.h"\n#define PI NUM(3.14159265358979)\n'
             '#define A_MANUAL(M) M(WHAT, "half && 0.3 for ?")\n'
             "STRUCT(a_p) {\n    num n;\n    vec3 color;\n};\n"
             "/* half of it, x * 0.1 */\n"
             "FN num a_value(a_p p, num x) {\n    num y = sel(x > 0.5f, p.n, -NUM(0.1));\n"
             "    y = y * PI;\n    a_p q;\n    q.n = exp_(y);\n    return q.n == x;\n}\n#endif\n")
BODY = "FN num f(num x) {{\n    {0}\n    return x;\n}}\n"
BAD = [
    (model(BODY.format("num y = x > 1.0f ? x : x;")), "src/shade/a.h:2: '?'"),
    (model(BODY.format("cond y = x > 1.0f && x < 2.0f;")), "'&&'"),
    (model(BODY.format("cond y = x > 1.0f || x < 2.0f;")), "'||'"),
    (model(BODY.format("cond y = !(x > 1.0f);")), "'!'"),
    (model(BODY.format("num y = t[0];")), "'['"),
    (model(BODY.format("num *y = x;")), "no pointers"),
    (model(BODY.format("while (x > 1.0f) {}")), "while"),
    (model(BODY.format("num y = 0.1f;")), "0.1f is no exact float"),
    (model(BODY.format("num y = 0.5;")), "written 0.5f"),
    (model(BODY.format("num y = 2 * x;")), "2; a number"),
    (model(BODY.format("num y = NUM(2.0f);")), "NUM(2.0f)"),
    (model("#define A NUM(1 / 3)\n"), "NUM(1 / 3)"),
    (model(BODY.format("num y = NUM(2);")), "NUM(2)"),
    (model(BODY.format("x = x + 1.0f;")), "assigns to parameter x"),
    (model("FN num f(vec3 w) {\n    w.x = 1.0f;\n    return w.x;\n}\n"), "assigns to parameter w"),
    (model(BODY.format("num y = x, z = x;")), "two names"),
    (model(BODY.format("num half = x;")), "half is reserved"),
    (model(BODY.format("num sample = x;")), "sample is reserved"),
    (model(BODY.format("num a__b = x;")), "two underscores"),
    (model(BODY.format("num y = expf(x);")), "calls expf"),
    (model(BODY.format("float y = x;")), "the type is num"),
    (model(BODY.format("return x;")), "exactly one return"),
    (model("FN num reflect(num x) {\n    return x;\n}\n"), "built into a target"),
    (model("num g = 1.0f;\n"), "neither FN nor STRUCT"),
    (model("#define P(a) a##_b\n"), "'##'"),
    (model("STRUCT(input) {\n    num a;\n};\n"), "input is reserved"),
]

if __name__ == "__main__":
    lint.main(check, BAD, GOOD)
