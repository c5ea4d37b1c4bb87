#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`ndotl sample` and `ndotl eval --pdf`: lines, seeds, binary, refusals."""
import math
import os
import struct
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "cli"))
from cli import Folder, main, models, ok, refused, run  # noqa: E402

ROW = "0 0.6 0.8  0.3 0.7 0.5\n"
MATERIALS = ["ggx(preset=gold, roughness=0.3)", "ggx(alpha=0.001)", "beckmann(alpha=0.002)",
             "ward", "phong(exponent=1e4)", "metal_rough", "0.5*lambert + 0.5*ggx(alpha=0.01)"]


def viewers(n):
    """Lines wo u; u from a Kronecker sequence."""
    lines = []
    for i in range(n):
        z, phi = (i + 0.5) / n, 2.4 * i
        s = math.sqrt(1 - z * z)
        u = [(i * a) % 1.0 for a in (0.8191725134, 0.6710436067, 0.5497004779)]
        numbers = [s * math.cos(phi), s * math.sin(phi), z] + u
        lines.append(" ".join("%.9g" % x for x in numbers))
    return lines


def raw_of(lines):
    return b"".join(struct.pack("<6f", *map(float, line.split())) for line in lines)


def test_a_line_gives_direction_weight_and_density():
    for model in models():
        (row,) = ok("sample", model, stdin=ROW).rows()
        assert len(row) == 7 and all(math.isfinite(x) and (i < 3 or x >= 0)
                                     for i, x in enumerate(row)), (model, row)
        assert row[6] == 0 or abs(math.hypot(*row[:3]) - 1) < 1e-6, (model, row)


def test_lambert_weighs_its_colour():
    (row,) = ok("sample", "lambert(color=[0.8,0.5,0.2])", stdin=ROW).rows()
    assert [round(x, 6) for x in row[3:6]] == [0.8, 0.5, 0.2]
    assert abs(row[6] - row[2] / math.pi) < 1e-6


def test_eval_gives_the_printed_density_and_weight():
    lines = viewers(400)
    for material in MATERIALS:
        drawn = ok("sample", material, stdin="\n".join(lines)).text.splitlines()
        pairs = "\n".join(" ".join(d.split()[:3] + w.split()[:3]) for d, w in zip(drawn, lines))
        again = ok("eval", material, "--pdf", stdin=pairs).text.splitlines()
        assert [d.split()[6] for d in drawn] == again, material
        values = ok("eval", material, "--cos", stdin=pairs).rows()
        for d, f in zip(drawn, values):
            row = [float(x) for x in d.split()]
            for w, v in zip(row[3:6], f):
                assert row[6] == 0 and w == 0 or abs(w * row[6] - v) <= 1e-6 * v, (material, d)


def test_below_the_horizon_is_a_line_of_zeros():
    text = ok("sample", "ggx", stdin="0 0.6 -0.8 0.1 0.2 0.3\n1 0 0 0.1 0.2 0.3\n").text
    assert text == "0 0 0 0 0 0 0\n" * 2


def test_no_sample_has_density_and_weight_0():
    rows = ok("sample", "beckmann(alpha=1)", stdin="\n".join(viewers(2000))).rows()
    lost = [row for row in rows if row[6] == 0]
    assert lost and len(lost) < 600
    assert all(row[3:6] == [0, 0, 0] for row in lost)


def test_three_numbers_take_u_from_the_seed():
    stdin = "0 0.6 0.8\n" * 500
    first = ok("sample", "ggx", stdin=stdin).text
    assert first == ok("sample", "ggx", "--seed", "0", stdin=stdin).text
    assert first != ok("sample", "ggx", "--seed", "1", stdin=stdin).text
    assert len(set(first.splitlines())) == 500
    mean = [sum(x) / 500 for x in zip(*ok("sample", "lambert", stdin=stdin).rows())]
    assert abs(mean[2] - 2 / 3) < 0.05 and abs(mean[0]) < 0.1 and abs(mean[1]) < 0.1


def mix(x):
    mask = (1 << 64) - 1
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9 & mask
    x = (x ^ x >> 27) * 0x94d049bb133111eb & mask
    return x ^ x >> 31


def test_the_numbers_of_a_seed_are_those_of_the_manual():
    step, mask = 0x9e3779b97f4a7c15, (1 << 64) - 1
    start = mix(7 + step & mask)
    lines = []
    for row in range(40):
        u = [(mix(start + (3 * row + k + 1) * step & mask) >> 40) / 2 ** 24 for k in range(3)]
        lines.append("0 0.6 0.8 " + " ".join("%.9g" % x for x in u))
    mixed = "\n# a comment\n".join(["0 0.6 0.8", *lines[1:20], *["0 0.6 0.8"] * 20])
    wanted = ok("sample", "metal_rough", stdin="\n".join(lines)).text
    assert ok("sample", "metal_rough", "--seed", "7", stdin=mixed).text == wanted


def test_binary_agrees_with_text_and_with_eval():
    lines = viewers(5000)
    out = ok("sample", "beckmann", "--binary", "f32", stdin=raw_of(lines)).out
    text = ok("sample", "beckmann", stdin="\n".join(lines)).rows()
    rows = list(struct.iter_unpack("<7f", out))
    assert len(rows) == len(text) == 5000
    for row, got in zip(text, rows):
        assert all(abs(x - y) <= 1e-5 * max(1, abs(y)) for x, y in zip(row, got)), (row, got)
    pairs = [struct.pack("<3f", *row[:3]) + raw_of([line])[:12] for row, line in zip(rows, lines)]
    again = ok("eval", "beckmann", "--pdf", "--binary", "f32", stdin=b"".join(pairs)).out
    assert [row[6] for row in rows] == [x for x, in struct.iter_unpack("<f", again)]


def test_files_commas_and_comments_are_read():
    with Folder() as folder:
        path = folder.file("w.txt", "# viewers\n\n0,0.6,0.8, 0.3,0.7,0.5 # one\r\n")
        assert ok("sample", "ggx", path).text == ok("sample", "ggx", "-", stdin=ROW).text
    assert ok("sample", "ggx", stdin="").text == ""


def test_a_byte_order_mark_is_no_part_of_the_first_line():
    assert ok("sample", "ggx", stdin="\ufeff" + ROW).text == ok("sample", "ggx", stdin=ROW).text


def test_every_instruction_set_prints_the_same():
    stdin = "\n".join(viewers(100))
    for material in MATERIALS:
        assert (ok("sample", material, stdin=stdin).text
                == ok("sample", material, stdin=stdin, env={"NDOTL_ISA": "scalar"}).text)
    refused(2, "sample", "ggx", env={"NDOTL_ISA": "sse9"}, says="sse9")


def test_malformed_input_names_file_and_line():
    for text, says in [("0 0 1 0.5\n", "found 4"), ("0 0 1 0.5 1 0\n", "u1 is 1"),
                       ("0 0 1 0.5 -0.1 0\n", "[0, 1)"), ("0 0 0\n", "wo is zero"),
                       ("0 0 x\n", "'x' is no number"), ("1 2 3 4 5 6 7\n", "found 7")]:
        refused(1, "sample", "ggx", stdin=ROW + text, says=says, place="stdin:2")
    done = run("sample", "ggx", stdin=ROW + "0 0\n")
    assert done.code == 1 and len(done.text.splitlines()) == 1, done
    refused(1, "sample", "ggx", "--binary", "f32", stdin=b"\0" * 23, says="23 of 24")
    refused(1, "sample", "ggx", "no/such/file", says="cannot be opened", place="no/such/file")


def test_u_just_below_1_is_taken():
    assert len(ok("sample", "ggx", stdin="0 0.6 0.8 0.9999999999 0 0\n").rows()) == 1


def test_wo_is_normalised_with_a_warning():
    done = run("sample", "ggx", stdin="0 6 8 0.3 0.7 0.5\n" * 2)
    assert done.code == 0 and "stdin:1" in done.err and "2 rows" in done.err, done
    assert done.text == ok("sample", "ggx", stdin=ROW * 2).text


def test_the_command_line_is_checked():
    refused(2, "sample", says="missing", place="MATERIAL")
    refused(2, "sample", "gxx", says="did you mean 'ggx'")
    refused(2, "sample", "ggx", "--seed", "1", "--binary", "f32", says="--binary")
    refused(2, "sample", "ggx", "--seed", "-1", place="--seed")
    refused(2, "sample", "ggx", "--seed", "1.5", place="--seed")
    refused(2, "sample", "ggx", "--binary", "f64", place="--binary")
    for other in [["--cos"], ["--term", "D"], ["--convention", "scanline"], ["--print"]]:
        refused(2, "eval", "ggx", "--pdf", *other, says="--pdf")


def test_eval_pdf_has_one_column_in_every_format():
    pair = "0 0.6 0.8  0 -0.6 0.8\n"
    (row,) = ok("eval", "lambert", "--pdf", stdin=pair).rows()
    assert len(row) == 1 and abs(row[0] - 0.8 / math.pi) < 1e-7
    assert ok("eval", "lambert", "--pdf", "--csv", stdin=pair).text.splitlines()[0].endswith(",pdf")
    assert '"quantity":"pdf","unit":"1/sr"' in ok("eval", "lambert", "--pdf", "--json",
                                                  stdin=pair).text
    assert ok("eval", "lambert", "--pdf", stdin="0 0.6 -0.8 0 0 1\n").text == "0\n"


def test_the_manual_says_how_a_model_is_drawn():
    for model in models():
        assert "\nsampling\n" in ok("models", model).text, model


if __name__ == "__main__":
    main(globals())
