#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Materials on the command line: short form, JSON long form, and what is wrong with them."""
import json
import random
import sys

from cli import PAIR, has_workbench, main, ok, refused, run


def lobe(**members):
    return json.dumps({"lobes": [members]})


def test_errors_name_the_column_and_the_nearest_name():
    done = refused(2, "eval", "ggx(preset=gold, rough=0.3)", stdin=PAIR)
    assert done.err == "ndotl eval: column 18: unknown parameter 'rough' of ggx; did you mean " \
                       "'roughness'?\n", done
    for text, column in [("gxx", 1), ("ggx(", 5), ("ggx(alpha=)", 11), ("ggx(alpha=9)", 11),
                         ("ggx(alpha=0.1,alpha=0.1)", 15), ("lambert + ", 11), ("", 1),
                         ("-1*lambert", 1), ("ggx(preset=gald)", 12), ("lambert(color=#12)", 15),
                         ("ggx)", 4)]:
        refused(2, "eval", text, stdin=PAIR, place=f"column {column}")
    refused(2, "eval", "ggx(\x01\xff)", stdin=PAIR, says="\\x01")


def test_errors_of_the_expression_come_before_those_of_the_file():
    refused(2, "eval", "gxx", "/no/such/file", place="column 1")


def test_the_long_form_equals_the_short_form():
    cases = [('{"lobes":[{"weight":[1,1,1],"model":"ggx",'
              '"params":{"alpha":0.3,"f0":[1,0.71,0.29]}}]}',
              "ggx(alpha=0.3, f0=[1, 0.71, 0.29])"),
             (' {"lobes":[{"model":"lambert","params":{"color":"#336699"}},'
              '{"weight":0.5,"model":"ggx","params":{"preset":"gold"}}]}',
              "lambert(color=#336699) + 0.5*ggx(preset=gold)"),
             ('{"lobes":[{"weight":[0.1,0.2,0.3],"model":"toon_diffuse",'
              '"params":{"ramp":[[0,0.1],[0.5,[1,0.5,0.2]],[0.5,"#ff8800"]]}}]}',
              "[0.1,0.2,0.3]*toon_diffuse(ramp=[0:0.1, 0.5:[1,0.5,0.2], 0.5:#ff8800])")]
    for long_form, short in cases:
        assert ok("eval", long_form, "--print").out == ok("eval", short, "--print").out
        assert ok("eval", long_form, stdin=PAIR).out == ok("eval", short, stdin=PAIR).out
        printed = ok("eval", short, "--print", "--json").text
        assert ok("eval", printed, "--print").out == ok("eval", short, "--print").out


def test_numbers_of_the_long_form_keep_their_bits():
    draw = random.Random(6)
    for _ in range(40):
        x = repr(draw.uniform(0, 4))
        assert ok("eval", lobe(model="ggx", params={"alpha": float(x)}), "--print").out == \
            ok("eval", f"ggx(alpha={x})", "--print").out


def test_broken_json_is_refused_with_its_column():
    for text, column in [('{"lobes":[{"model":"ggx",}]}', 26), ('{"lobes"', 9), ('{', 2),
                         ('{"lobes":[{"model":"ggx"}]} x', 29), ("{'lobes':[]}", 2)]:
        refused(2, "eval", text, stdin=PAIR, place=f"column {column}", says="the JSON is broken")
    refused(2, "eval", '{"lobes":[{"model":"ggx","params":{"alpha":1,"alpha":1}}]}', stdin=PAIR,
            says="duplicate")
    refused(2, "eval", '{"lobes":' + "[" * 5000, stdin=PAIR)


def test_wrong_members_are_named_by_their_path():
    alpha = "lobes[0].params.alpha"
    for text, place in [
            (lobe(model="ggx", params={"rough": 0.3}), "lobes[0].params.rough"),
            (lobe(model="gxx"), "lobes[0].model"), (lobe(model=3), "lobes[0]"),
            (lobe(model="ggx + ggx"), "lobes[0].model"), (lobe(), "lobes[0]"),
            (lobe(model="ggx", params=[]), "lobes[0]"), (lobe(model="ggx", parms={}), "lobes[0]"),
            (lobe(model="ggx", weight=-1), "lobes[0].weight"),
            (lobe(model="ggx", weight=[1, 2]), "lobes[0].weight"),
            (lobe(model="ggx", params={"alpha": 9}), alpha),
            (lobe(model="ggx", params={"alpha": True}), alpha),
            (lobe(model="ggx", params={"alpha": None}), alpha),
            (lobe(model="ggx", params={"alpha": {}}), alpha),
            (lobe(model="ggx", params={"alpha": "0.1, f0=1"}), alpha),
            (lobe(model="ggx", params={"alpha": []}), alpha),
            (lobe(model="ggx", params={"alpha": [[1]]}), alpha),
            (lobe(model="ggx", params={"alpha": [1, 1, "x"]}), alpha)]:
        refused(2, "eval", text, stdin=PAIR, says=place + ": ")
    for text in ['{}', '{"lobes":{}}', '{"lobes":[]}', '{"lobes":[1]}', '{"lobes":[[]]}']:
        refused(2, "eval", text, stdin=PAIR)
    refused(2, "eval", '{"lobe":[]}', stdin=PAIR, says="did you mean 'lobes'?")


def test_changed_json_never_crashes():
    draw = random.Random(7)
    good = '{"lobes":[{"weight":[1,0.5,0],"model":"ggx","params":{"alpha":0.3,"preset":"gold"}}]}'
    for _ in range(150):
        text = list(good)
        for _ in range(draw.randrange(1, 4)):
            text[draw.randrange(len(text))] = draw.choice('{}[]",:0a-.e ')
        done = run("eval", "".join(text), "--print")
        assert done.code in (0, 2), done


if __name__ == "__main__":
    if not has_workbench():
        test_errors_name_the_column_and_the_nearest_name()
        test_errors_of_the_expression_come_before_those_of_the_file()
        refused(2, "eval", '{"lobes":[]}', "--print", says="reads no JSON")
        print("skipped: JSON materials need the workbench (libjansson-dev)")
        sys.exit(77)
    main(globals())
