#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/models: a page per model and per family of microfacet terms, from their manuals.

    tools/docs/model_pages.py [--check] BUILD     BUILD: a build folder with ndotl and libndotl.a

--check changes nothing and exits with 1 when a page is out of date. $NDOTL_CC is the compiler.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

import energy

ROOT = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
PAGES = ROOT / "docs/models"
FAMILIES = {
    "ndf": "Normal distributions D", "masking": "Masking-shadowing G", "fresnel": "Fresnel term F",
}
ORDER = ["what", "formula", "when", "limits", "energy", "departures", "sampling"]
TITLES = {"when": "When to use it", "departures": "Departures and errata of the documents",
          "energy": "Energy", "limits": "Limits", "sampling": "Sampling"}
LAWS = {"energy": "energy (directional albedo at most 1)", "continuity": "continuity of f cos",
        "lit_gate": "0 unless light and viewer are above the surface"}
CITATION = re.compile(r"\[([A-Z][A-Za-z]+\d\d(?:\d\d)?[a-z]?|glTF|KHRAniso)\]")
PAIR = "30 0 45 180"


def ask(program, *words):
    done = subprocess.run([program, *words], check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def facts(build, folder, expressions):
    """Manuals of the terms and albedos of the expressions, by tools/docs/facts.c."""
    program, sanitizers = pathlib.Path(folder) / "facts", os.environ.get("NDOTL_SANITIZE")
    flags = ["-std=c11", "-O1", "-w", *([f"-fsanitize={sanitizers}"] if sanitizers else [])]
    subprocess.run([os.environ.get("NDOTL_CC", "cc"), *flags, f"-I{ROOT}/include", f"-I{ROOT}/src",
                    str(ROOT / "tools/docs/facts.c"), str(build / "libndotl.a"),
                    "-o", str(program), "-lm", "-pthread"], check=True)
    done = subprocess.run([str(program)], input="\n".join(expressions) + "\n", check=True,
                          capture_output=True, text=True)
    found = json.loads(done.stdout)
    found = {key: [entry for entry in found[key] if entry is not None] for key in found}
    found["albedo"] = dict(zip(expressions, found["albedo"]))
    return found


def bibliography():
    """Citation key -> 'authors: title, year', from docs/references.bib."""
    text, found = (ROOT / "docs/references.bib").read_text(), {}
    for key, body in re.findall(r"^@\w+\{(\w+),\n(.*?)^\}", text, re.M | re.S):
        fields = dict(re.findall(r"(\w+)\s*=\s*\{(.*?)\},?\s*$", body, re.M | re.S))
        plain = {name: re.sub(r"[{}\\]|\s+(?=\s)", "", value.replace("\n", " "))
                 for name, value in fields.items()}
        found[key] = f"{plain.get('author', '')}: {plain.get('title', '')}, {plain.get('year', '')}"
    return found


def prose(text):
    return textwrap.fill(text.replace("*", r"\*"), 100, break_long_words=False,
                         break_on_hyphens=False)


def block(text):
    """A formula as a code block; each variant and each 'name: ' on a line of its own."""
    lines = []
    for part in re.split(r"(?<=[.;]) (?=[a-z_\d]+: )", text):
        lines += textwrap.wrap(part, 96, subsequent_indent="    ", break_long_words=False,
                               break_on_hyphens=False)
    return "```text\n" + "\n".join(lines) + "\n```"


def cell(text):
    return str(text).replace("|", r"\|").replace("*", r"\*")


def number(x):
    return f"{x:.6g}"


def span(param):
    """The range and the default of a parameter, as two cells."""
    if param["kind"] == "choice":
        return " ".join(f"`{word}`" for word in param["words"].split()), f"`{param['default']}`"
    default = param["default"]
    default = "-" if default is None else (number(default) if not isinstance(default, list) else
                                           " ".join(map(number, default)))
    if "low" not in param:
        return param["kind"], default
    low, high = param["low"], param["high"]
    below = "(" if param["above_low"] or low is None else "["
    text = f"{below}{'-inf' if low is None else number(low)}, "
    return text + ("inf)" if high is None else number(high) + "]"), default


def value(program, material):
    done = subprocess.run([program, "eval", material, "--angles"], input=PAIR + "\n", check=True,
                          capture_output=True, text=True)
    return done.stdout.strip()


def is_default(program, name, param):
    """Whether the default of another way to give a quantity is what holds without it: roughness 0.5
    is only where a slider starts when the model's own default is alpha 0.3."""
    if not param["spells"] or param["kind"] != "number":
        return True
    return value(program, f"{name}({param['key']}={param['default']})") == value(program, name)


def parameters(program, name, params):
    rows = ["| key | values | default | unit | feel |", "|---|---|---|---|---|"]
    for param in params:
        values, default = span(param)
        default = default if is_default(program, name, param) else "-"
        key = f"`{param['key']}`"
        if param["unit"] == "rad":
            key += f" `{param['key']}_deg`"
        feel = param["feel"]
        if param["spells"]:
            feel += f" (another way to give the {param['spells'].replace('_', ' ')})"
        if param["kind"] == "color":
            values += " per channel"
        cells = [key, values, default, param["unit"] or "-", cell(feel)]
        rows.append("| " + " | ".join(cells) + " |")
    return "\n".join(rows)


def listed_books(keys, books):
    return [f"- [{key}] {books.get(key, 'unknown')}" for key in dict.fromkeys(keys)]


def sources(text, books):
    return "\n".join([prose(text), "", *listed_books(CITATION.findall(text), books)])


def example(program, name):
    return ("```sh\n# light 30 degrees from the normal, viewer 45 degrees on the other side: 1/sr\n"
            f"echo '{PAIR}' | ndotl eval '{name}' --angles\n#> {value(program, name)}\n```")


def laws(model):
    claims = [LAWS.get(claim, claim).replace("_", "-") for claim in model["claims"]]
    return "Claimed with the default parameters: " + ", ".join(claims) + "."


def model_page(program, name, found, books):
    model = ask(program, "models", name, "--json")
    manual = model["manual"]
    keys = {param["key"] for param in model["params"]}
    parts = [f"# {name}", prose(manual["what"]), "## Formula", block(manual["formula"])]
    links = [f"[{family}]({family}.md)" for family in FAMILIES if family in keys]
    if links:
        parts.append("The terms, each on its own page: " + ", ".join(links) + ".")
    parts.append(example(program, name))
    parts += ["## Parameters", parameters(program, name, model["params"])]
    if "preset" in keys:
        parts.append("The names of `preset` and where they come from: [presets.md](../presets.md).")
    others = [key for key in manual if key not in ORDER + ["source"] and "=" not in key]
    for heading in others + ORDER[2:]:
        if heading in manual:
            parts += [f"## {TITLES.get(heading, heading.capitalize())}", prose(manual[heading])]
        if heading == "energy":
            parts += energy.tables(name, found["albedo"])
    parts += ["## Laws", prose(laws(model)), "## Sources", sources(manual["source"], books)]
    parts.append("Rows S1.1 ... S4.56 are those of [formulas.md](../formulas.md).")
    return "\n\n".join(parts) + "\n"


def family_page(family, found, books):
    parts = [f"# {FAMILIES[family]}", prose(energy.INTRODUCTIONS[family])]
    for term in found[family]:
        parts += [f"## {family}={term['word']}", prose(term["what"]), block(term["formula"])]
        if term["notes"]:
            parts.append(prose(term["notes"]))
        parts.append("Source: " + prose(term["source"]))
    parts += energy.tables(family, found["albedo"])
    cited = CITATION.findall(" ".join(term["source"] for term in found[family]))
    parts += ["## Sources", "\n".join(listed_books(cited, books))]
    parts.append("Rows S1.1 ... S4.56 are those of [formulas.md](../formulas.md).")
    return "\n\n".join(parts) + "\n"


def index(listed):
    rows = [f"- [{model['name']}]({model['name']}.md): {cell(model['what'])}" for model in listed]
    terms = [f"- [{family}]({family}.md): {title}" for family, title in FAMILIES.items()]
    return ("# Models\n\n" + prose("Written by `tools/docs/model_pages.py` from the manuals in "
            "`src/shade`; `ndotl models NAME` prints the same. Directions, units and the lit gate: "
            "the head of `include/ndotl/ndotl.h`.") + "\n\n" + "\n".join(rows) +
            "\n\nThe terms of `microfacet`, `ggx` and `beckmann`:\n\n" + "\n".join(terms) + "\n")


def pages(build):
    program, books = str(build / "ndotl"), bibliography()
    listed = ask(program, "models", "--json")["models"]
    with tempfile.TemporaryDirectory() as folder:
        found = facts(build, folder, energy.expressions())
    made = {f"{model['name']}.md": model_page(program, model["name"], found, books)
            for model in listed}
    made |= {f"{family}.md": family_page(family, found, books) for family in FAMILIES}
    return made | {"README.md": index(listed)}


def main():
    words = [word for word in sys.argv[1:] if word != "--check"]
    made = pages(pathlib.Path(words[0] if words else os.environ["NDOTL_BUILD"]).resolve())
    there = {path.name: path.read_text() for path in PAGES.glob("*.md")}
    if "--check" not in sys.argv[1:]:
        PAGES.mkdir(exist_ok=True)
        for name in there.keys() - made.keys():
            (PAGES / name).unlink()
        for name, text in made.items():
            (PAGES / name).write_text(text)
        return 0
    stale = sorted(name for name in made.keys() | there.keys() if made.get(name) != there.get(name))
    for name in stale:
        print(f"docs/models/{name}:1: out of date; run tools/docs/model_pages.py build/release")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
