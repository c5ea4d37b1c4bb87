#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The program itself: help, version, unknown words, environment, manual page, completions."""
import re
import subprocess

from cli import PAIR, main, models, ok, refused, run

LIST = ok("--help").text.split("commands:")[1].split("\noptions:")[0]
VERBS = re.findall(r"^  (\w+) ", LIST, re.M)


def test_alone_it_prints_three_commands_to_try():
    lines = ok().text.splitlines()
    assert len(lines) == 4 and all(line.strip().startswith(("ndotl", "echo")) for line in lines[1:])


def test_the_three_commands_have_known_verbs():
    for line in ok().text.splitlines()[1:]:
        assert re.search(r"ndotl (\w+)", line).group(1) in VERBS, line


def test_every_verb_has_help_with_an_example():
    assert {"models", "eval", "param"} <= set(VERBS)
    for verb in VERBS:
        text = ok(verb, "--help").text
        assert f"usage: ndotl {verb}" in text and "example" in text and f"ndotl {verb}" in text
        prose = text.split("\nexample:")[0].splitlines()
        assert max(map(len, prose)) <= 100, text


def test_version_tells_what_is_built():
    text = ok("--version").text
    assert re.match(r"ndotl \d+\.\d+\.\d+\n", text)
    for part in ["commit: ", "instruction set: ", "table: exact", "optional parts: "]:
        assert part in text, text


def test_an_unknown_verb_names_the_nearest():
    refused(2, "evl", says="did you mean 'eval'?", place="evl")
    refused(2, "--versoin", says="did you mean '--version'?")
    refused(2, "zzzzzz", says="see 'ndotl --help'")


def test_an_unknown_option_names_the_nearest():
    for verb in VERBS:
        refused(2, verb, "--hepl", says="did you mean '--help'?", place="--hepl")
    refused(2, "eval", "lambert", "--tem", says="did you mean '--term'?", place="--tem")
    refused(2, "eval", "lambert", "--bogusbogus", says="see 'ndotl eval --help'")


def test_options_are_checked_before_anything_runs():
    refused(2, "eval", "lambert", "--term", says="needs a value", place="--term")
    refused(2, "eval", "lambert", "--term", "X", says="use one of: D G V F", place="--term")
    refused(2, "eval", "lambert", "--convention", "scanlin", says="did you mean 'scanline'?")
    refused(2, "eval", "lambert", "--cos", "--cos", says="given twice", place="--cos")
    refused(2, "eval", "lambert", "--cos=1", says="takes no value", place="--cos")
    refused(2, "eval", says="missing", place="MATERIAL")
    refused(2, "eval", "lambert", "a", "b", says="unexpected", place="b")


def test_both_spellings_of_a_value_work():
    assert ok("eval", "ggx", "--term=D", stdin=PAIR).out == ok("eval", "ggx", "--term", "D",
                                                               stdin=PAIR).out


def test_options_may_stand_anywhere_and_two_dashes_end_them():
    wanted = ok("eval", "lambert", "--cos", stdin=PAIR).out
    assert ok("eval", "--cos", "lambert", "-", stdin=PAIR).out == wanted
    refused(1, "eval", "lambert", "--", "--cos", says="--cos: cannot be opened")


def test_instruction_sets_can_be_chosen():
    wanted = ok("eval", "ggx", stdin=PAIR).out
    assert ok("eval", "ggx", stdin=PAIR, env={"NDOTL_ISA": "scalar"}).out == wanted
    assert ok("eval", "ggx", stdin=PAIR, env={"NDOTL_TABLE": "exact"}).out == wanted
    assert "instruction set: scalar" in ok("--version", env={"NDOTL_ISA": "scalar"}).text


def test_an_unknown_instruction_set_or_table_is_refused():
    for name in ["sse9", "wasm", "scalar "]:
        refused(2, "eval", "ggx", stdin=PAIR, env={"NDOTL_ISA": name}, says=f"'{name}'",
                place="NDOTL_ISA")
    refused(2, "eval", "ggx", "--print", env={"NDOTL_ISA": "sse9"}, says="sse9")
    for name in ["fast", "quick"]:
        refused(2, "eval", "ggx", stdin=PAIR, env={"NDOTL_TABLE": name}, says=f"'{name}'",
                place="NDOTL_TABLE")


def test_the_manual_page_has_every_verb_and_option():
    page = ok("--man").text
    assert page.startswith(".TH NDOTL 1")
    for verb in VERBS:
        assert f".SS {verb}\n" in page
        for option in re.findall(r"^  (--?[\w-]+)", ok(verb, "--help").text, re.M):
            assert option.replace("-", "\\-") in page, option
    assert not re.search(r"^\.(?!TH|SH|SS|PP|TP|RS|RE|nf|fi|B|I)", page, re.M)


def test_completions_offer_verbs_options_and_words():
    script = ok("--completion", "bash").text

    def offers(*words):
        line = " ".join(f"'{word}'" for word in words)
        text = f"{script}\nCOMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _ndotl\n" \
               'echo "${COMPREPLY[@]}"'
        done = subprocess.run(["bash", "-c", text], capture_output=True, text=True, check=True)
        assert done.stderr == "", done
        return done.stdout.split()

    assert set(VERBS) <= set(offers("ndotl", ""))
    assert offers("ndotl", "eval", "--te") == ["--term"]
    assert offers("ndotl", "eval", "ggx", "--term", "") == ["D", "G", "V", "F"]
    assert offers("ndotl", "eval", "lamb") == ["lambert"]
    zsh = ok("--completion", "zsh").text
    assert zsh.startswith("#compdef ndotl") and all(f"{verb})" in zsh for verb in VERBS)
    refused(2, "--completion", "fish", says="bash or zsh")
    refused(2, "--completion", says="bash or zsh")


def test_results_that_cannot_be_written_are_an_error():
    with open("/dev/full", "wb") as full:
        for words in [["models"], ["--help"], ["eval", "--help"], ["models", "ggx"],
                      ["param", "alpha=1", "--to", "roughness"], ["--man"], ["--version"], []]:
            done = run(*words, stdout=full)
            assert done.code == 1 and "stdout: cannot write" in done.err, done


if __name__ == "__main__":
    assert models()
    main(globals())
