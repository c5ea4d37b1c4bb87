#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the model table of README.md from what `ndotl models --json` says.

    tools/readme_models.py [--check] NDOTL     --check: exits 1 when the table is out of date
"""
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(os.environ.get("NDOTL_SOURCE", pathlib.Path(__file__).resolve().parents[1]))
TABLE = re.compile(r"(<!-- models:.*?-->\n).*?(<!-- end -->)", re.S)


def ask(program, *words):
    return json.loads(subprocess.run([program, "models", *words, "--json"], check=True,
                                     capture_output=True, text=True).stdout)


def table(program):
    rows = ["| model | what | keys |", "|---|---|---|"]
    for model in ask(program)["models"]:
        keys = [f"`{row['key']}`" for row in ask(program, model["name"])["params"]]
        what = model["what"].rstrip(".")
        rows.append(f"| `{model['name']}` | {what} | {' '.join(keys)} |")
    return "\n".join(rows) + "\n"


def main():
    words = [word for word in sys.argv[1:] if word != "--check"]
    program = words[0] if words else os.environ["NDOTL_BIN"]
    readme = ROOT / "README.md"
    text = readme.read_text()
    rows = table(program)
    updated = TABLE.sub(lambda match: match.group(1) + rows + match.group(2), text)
    if rows not in updated:
        sys.exit("README.md:1: no <!-- models: ... --> table")
    if "--check" not in sys.argv[1:]:
        readme.write_text(updated)
    elif updated != text:
        sys.exit("README.md:1: the model table is out of date; run tools/readme_models.py "
                 "build/release/ndotl")


if __name__ == "__main__":
    main()
