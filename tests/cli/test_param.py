#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`ndotl param`: conversions, chains of them, and what cannot be derived."""
import json
import math

from cli import main, ok, refused


def convert(given, to):
    done = ok("param", *given.split(), "--to", to, "--json")
    return json.loads(done.text)[to]


def near(got, wanted):
    return abs(got - wanted) <= 2e-6 * abs(wanted) + 1e-30


def test_the_documented_example():
    assert ok("param", "roughness=0.5", "--to", "alpha,blinn_exponent").text == \
        "alpha=0.25\nblinn_exponent=30\n"
    assert ok("param", "roughness=0.5", "--to", "alpha,blinn_exponent", "--json").text == \
        '{"alpha":0.25,"blinn_exponent":30}\n'


def test_every_conversion_and_its_inverse():
    s2 = 0.35 ** 2
    cases = [
        ("roughness=0.5", "alpha", 0.25), ("alpha=0.25", "roughness", 0.5),
        ("roughness=0.5 roughness_map=direct", "alpha", 0.5),
        ("roughness=0.25 roughness_map=sqrt", "alpha", 0.5),
        ("alpha=0.5 roughness_map=sqrt", "roughness", 0.25),
        ("alpha=0.25", "alpha_x", 0.25), ("alpha=0.25", "alpha_y", 0.25),
        ("alpha=0.3 anisotropy=0.8", "alpha_x", 0.3 / math.sqrt(1 - 0.72)),
        ("alpha=0.3 anisotropy=0.8", "alpha_y", 0.3 * math.sqrt(1 - 0.72)),
        ("alpha=0.3 anisotropy=0.5 anisotropy_kind=kulla", "alpha_x", 0.45),
        ("alpha=0.3 anisotropy=0.5 anisotropy_kind=kulla", "alpha_y", 0.15),
        ("alpha=0.3 anisotropy=0.5 anisotropy_kind=openpbr", "alpha_x", 0.3 * math.sqrt(1.6)),
        ("alpha=0.3 anisotropy=0.5 anisotropy_kind=openpbr", "alpha_y", 0.15 * math.sqrt(1.6)),
        ("alpha=0.3 anisotropy=0.5 anisotropy_kind=gltf", "alpha_x", 0.3 + 0.7 * 0.25),
        ("alpha=0.3 anisotropy=0.5 anisotropy_kind=gltf", "alpha_y", 0.3),
        ("blinn_exponent=30", "alpha", 0.25), ("alpha=0.25", "blinn_exponent", 30),
        ("blinn_exponent=30", "phong_exponent", 7.5), ("phong_exponent=7.5", "blinn_exponent", 30),
        ("ior=1.5", "f0", 0.04), ("f0=0.04", "ior", 1.5),
        ("sigma=0.35", "a", 1 - 0.5 * s2 / (s2 + 0.33)),
        ("sigma=0.35", "a57", 1 - 0.5 * s2 / (s2 + 0.57)),
        ("sigma_deg=20", "sigma", math.radians(20)),
        ("sigma=0.35", "sigma_deg", math.degrees(0.35)),
        ("a=0.8", "sigma", math.sqrt(0.33 * 0.2 / 0.3)),
        ("a57=0.8", "sigma", math.sqrt(0.57 * 0.2 / 0.3)),
        ("phong_exponent=7.5", "roughness", 0.5), ("roughness=1", "blinn_exponent", 0),
    ]
    for given, to, wanted in cases:
        got = convert(given, to)
        assert near(got, wanted), (given, to, got, wanted)


def test_anisotropy_comes_back_from_two_widths():
    for kind in ["burley", "kulla", "openpbr", "gltf"]:
        there = f"alpha=0.3 anisotropy=0.6 anisotropy_kind={kind}"
        x, y = convert(there, "alpha_x"), convert(there, "alpha_y")
        back = f"alpha_x={x} alpha_y={y} anisotropy_kind={kind}"
        assert near(convert(back, "alpha"), 0.3) and near(convert(back, "anisotropy"), 0.6), kind


def test_what_is_given_comes_back():
    assert near(convert("alpha=0.1", "alpha"), 0.1) and near(convert("sigma_deg=20", "sigma_deg"),
                                                          20)


def test_what_does_not_follow_says_what_is_needed():
    refused(2, "param", "ior=1.5", "--to", "alpha", says=["'alpha'", "give alpha, roughness"])
    refused(2, "param", "alpha_x=0.5", "--to", "roughness", says="alpha_x and alpha_y")
    refused(2, "param", "roughness=0.5", "--to", "ior", says="ior or f0")


def test_what_has_no_value_is_refused():
    refused(2, "param", "alpha=0", "--to", "blinn_exponent", says="would be infinite")
    refused(2, "param", "alpha=2", "--to", "blinn_exponent", says="would be -1.5")
    refused(2, "param", "f0=1", "--to", "ior", says="would be infinite")
    refused(2, "param", "alpha_x=0.1", "alpha_y=0.5", "--to", "anisotropy", says="would be")


def test_values_out_of_range_or_no_numbers_are_refused():
    for word in ["alpha=5", "alpha=-1", "roughness=1.5", "ior=0", "f0=2", "a=0.5", "a57=1.1",
                 "anisotropy=-0.1", "blinn_exponent=-1", "sigma=-1"]:
        refused(2, "param", word, "--to", word.split("=")[0], says="outside its range")
    for word in ["alpha=x", "alpha=", "alpha=nan", "alpha=1e999", "alpha=0.1x", "alpha", "=1"]:
        refused(2, "param", word, "--to", "roughness")


def test_names_are_checked():
    refused(2, "param", "rougness=0.5", "--to", "alpha", says="did you mean 'roughness'?")
    refused(2, "param", "roughness=0.5", "--to", "alfa", says="did you mean 'alpha'?")
    refused(2, "param", "roughness=0.5", "roughness_map=cube", "--to", "alpha",
            says="square direct sqrt")
    refused(2, "param", "roughness=0.5", "--to", ",", says="not a list")
    refused(2, "param", "roughness=0.5", "--to", "alpha,", says="not a list")
    refused(2, "param", "roughness=0.5", place="--to")
    refused(2, "param", "--to", "alpha", place="KEY=VALUE")


def test_a_quantity_given_twice_is_refused():
    refused(2, "param", "alpha=0.5", "alpha=0.5", "--to", "roughness", says="twice")
    refused(2, "param", "alpha=0.5", "roughness=0.5", "--to", "blinn_exponent", says="already")
    refused(2, "param", "alpha=0.3", "alpha_x=0.3", "--to", "roughness", says="already")
    refused(2, "param", "sigma=0.3", "a=0.9", "--to", "a57", says="already")
    ok("param", "alpha=0.3", "anisotropy=0.5", "ior=1.5", "--to", "alpha_x,f0")


if __name__ == "__main__":
    main(globals())
