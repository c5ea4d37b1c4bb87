#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`ndotl models`: the list, manuals, terms, rows, presets."""
import json

from cli import main, models, ok, refused


def test_the_list_has_every_model_with_what_it_is():
    text = ok("models").text
    rows = json.loads(ok("models", "--json").text)["models"]
    assert [row["name"] for row in rows] == models()
    assert {"lambert", "microfacet", "ggx", "metal_rough"} <= set(models())
    assert all(len(row["what"]) > 10 for row in rows) and "Lambert" not in text[:7]


def test_every_manual_has_its_sections_and_parameters():
    for name in models():
        text = ok("models", name).text
        assert text.startswith(name + "\n")
        for heading in ["\nwhat\n", "\nwhen\n", "\nlaws\n", "\nparameters\n"]:
            assert heading in text, (name, heading, text)
        assert max(map(len, text.splitlines())) < 80, name


def test_the_json_of_a_manual_has_ranges_defaults_and_words():
    ggx = json.loads(ok("models", "ggx", "--json").text)
    params = {p["key"]: p for p in ggx["params"]}
    assert ggx["name"] == "ggx" and "what" in ggx["manual"] and "reciprocity" in ggx["claims"]
    assert (params["alpha_x"]["low"], params["alpha_x"]["high"]) == (0, 4)
    assert abs(params["alpha_x"]["default"] - 0.3) < 1e-7
    assert "smith_correlated" in params["masking"]["words"].split()
    assert params["masking"]["default"] == "smith_correlated"
    assert params["roughness"]["spells"] == "width" and params["alpha_x"]["spells"] is None
    assert params["ior"]["above_low"] is True
    for name in models():
        json.loads(ok("models", name, "--json").text)


def test_angles_are_offered_in_degrees():
    assert "sigma_deg" in ok("models", "oren_nayar").text


def test_a_term_finds_words_keys_and_manuals():
    text = ok("models", "smith").text
    assert "masking=smith\n" in text and "ggx" in text and "beckmann" in text
    assert "masking=schlick_ggx" in ok("models", "schlick_ggx").text
    assert "key roughness" in ok("models", "roughness").text
    assert ok("models", "SMITH").text == text
    found = json.loads(ok("models", "smith", "--json").text)
    assert found["term"] == "smith" and {"word", "manual"} <= {h["kind"] for h in found["found"]}


def test_a_preset_is_found():
    assert "preset gold" in ok("models", "gold").text


def test_a_row_of_the_inventory_is_found_alone_and_in_ranges():
    assert "src/shade/masking.h" in ok("models", "S3.21").text
    text = ok("models", "S4.36").text
    assert "ward" in text and "function" in text
    assert "ggx" in ok("models", "S1.9").text  # S1.6 to S1.12
    kinds = {h["kind"] for h in json.loads(ok("models", "S4.22", "--json").text)["found"]}
    assert kinds == {"function", "manual"}


def test_what_is_nowhere_is_refused_with_the_nearest_name():
    refused(2, "models", "smth", says="did you mean 'smith'?", place="smth")
    refused(2, "models", "lamber_", says="did you mean 'lambert'?")
    refused(2, "models", "S9.99", says="no model, term or row")
    refused(2, "models", "S3.999")
    refused(2, "models", "")
    refused(2, "models", "qqqqqqqqqqq", "--json", says="'ndotl models' lists")


def test_presets_say_where_they_come_from():
    text = ok("models", "--presets").text
    assert "gold: metal" in text and "glass" in text and "ior 1.5" in text
    rows = {p["name"]: p for p in json.loads(ok("models", "--presets", "--json").text)["presets"]}
    assert len(rows["gold"]["eta"]) == 3 and len(rows["gold"]["k"]) == 3
    assert rows["gold"]["kind"] == "metal" and rows["gold"]["source"]
    assert all(("ior" in p) == (p["kind"] == "dielectric") for p in rows.values())
    refused(2, "models", "--presets", "gold", says="takes no name")


if __name__ == "__main__":
    main(globals())
