# SPDX-License-Identifier: Apache-2.0
"""What the lints share: reading the tree, stripping C comments, and proving that a lint bites.

A lint is a script with `check(tree)`, which returns findings `file:line: what is wrong; cure`, and
`BAD`, a list of (files, expected text) where `files` maps paths to text of a small tree that the
lint must refuse with a finding that contains the expected text. `script.py` checks the tree,
`script.py --bites` runs the bad inputs, and the good one `GOOD`, which must pass.
"""
import os
import pathlib
import re
import sys
import tempfile

SKIPPED_FOLDERS = {"build", ".git", "__pycache__", "node_modules"}


def files(tree, *patterns):
    """The files below the tree that match a glob pattern, as paths relative to it, sorted."""
    found = set()
    for pattern in patterns:
        for path in tree.glob(pattern):
            relative = path.relative_to(tree)
            if path.is_file() and not SKIPPED_FOLDERS & set(relative.parts):
                found.add(relative)
    return sorted(found)


def blank_except_newlines(text):
    return re.sub(r"[^\n]", " ", text)


def split_comments(text):
    """(code, comments): the same text twice, with the comments, or all else, turned to blanks."""
    pattern = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|/\*.*?\*/|//[^\n]*', re.S)
    code, comments, at = [], [], 0
    for match in pattern.finditer(text):
        code.append(text[at:match.start()])
        comments.append(blank_except_newlines(text[at:match.start()]))
        piece = match.group()
        is_comment = piece[0] == "/"
        code.append(blank_except_newlines(piece) if is_comment else piece)
        comments.append(piece if is_comment else blank_except_newlines(piece))
        at = match.end()
    code.append(text[at:])
    comments.append(blank_except_newlines(text[at:]))
    return "".join(code), "".join(comments)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def write_tree(tree, contents):
    for name, text in contents.items():
        path = tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def bites(check, bad, good):
    """Failures of the lint's own test: bad trees that pass, and the good one when it does not."""
    failures = []
    for contents, expected in [(good, None)] + list(bad):
        with tempfile.TemporaryDirectory() as folder:
            tree = pathlib.Path(folder)
            write_tree(tree, contents)
            findings = check(tree)
        if expected is None and findings:
            failures.append(f"the good input is refused: {findings}")
        if expected is not None and not any(expected in finding for finding in findings):
            failures.append(f"no finding contains '{expected}': {findings}")
    return failures


def main(check, bad, good):
    """The command line of every lint; exits 1 with the findings on stdout."""
    if "--bites" in sys.argv[1:]:
        findings = bites(check, bad, good)
        count = f"{len(bad)} bad inputs and a good one"
    else:
        here = pathlib.Path(__file__).resolve().parents[2]
        findings = check(pathlib.Path(os.environ.get("NDOTL_SOURCE", here)))
        count = "the tree"
    for finding in findings:
        print(finding)
    print(f"{len(findings)} findings in {count}")
    sys.exit(1 if findings else 0)
