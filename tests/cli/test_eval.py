#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`ndotl eval`: quantities and formats."""
import json
import math
import random
import struct

from cli import PAIR, Folder, has_workbench, main, models, ok, refused

GGX = "ggx(preset=gold, roughness=0.3)"


def pairs(n, seed=1):
    """n random pairs of unit vectors, some below the horizon, as rows of six numbers."""
    draw = random.Random(seed)
    rows = []
    for _ in range(n):
        row = []
        for _ in range(2):
            v = [draw.gauss(0, 1), draw.gauss(0, 1), draw.gauss(0.7, 1)]
            length = math.sqrt(sum(x * x for x in v))
            row += [x / length for x in v]
        rows.append(row)
    return rows


def lines(rows):
    return "".join(" ".join(repr(x) for x in row) + "\n" for row in rows)


def f32(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


def near(got, wanted, bound=3e-7):
    return abs(got - wanted) <= bound * abs(wanted) + 1e-37


def test_lambert_is_color_over_pi_inside_the_gate():
    rows = pairs(500)
    got = ok("eval", "lambert(color=[0.2, 0.5, 1])", stdin=lines(rows)).rows()
    assert len(got) == 500
    for row, rgb in zip(rows, got):
        lit = row[2] > 0 and row[5] > 0
        for value, color in zip(rgb, [0.2, 0.5, 1]):
            assert near(value, f32(color) / math.pi if lit else 0), (row, rgb)


def test_cos_multiplies_by_the_cosine_of_wi():
    rows = pairs(300)
    plain = ok("eval", GGX, stdin=lines(rows)).rows()
    cosine = ok("eval", GGX, "--cos", stdin=lines(rows)).rows()
    for row, f, fc in zip(rows, plain, cosine):
        assert all(near(b, a * max(row[2], 0), 1e-6) for a, b in zip(f, fc))


def test_the_pdf_of_lambert_is_its_cosine_over_pi():
    rows = pairs(200)
    for row, got in zip(rows, ok("eval", "lambert", "--pdf", stdin=lines(rows)).rows()):
        lit = row[2] > 0 and row[5] > 0
        assert len(got) == 1 and near(got[0], row[2] / math.pi if lit else 0, 1e-6), (row, got)


def test_scanline_is_pi_times_the_cosine_form_for_diffuse_lobes_only():
    rows = pairs(200)
    for material, factor in [("lambert", math.pi), ("oren_nayar", math.pi), ("phong", 1),
                             (GGX, 1)]:
        cosine = ok("eval", material, "--cos", stdin=lines(rows)).rows()
        scan = ok("eval", material, "--convention", "scanline", stdin=lines(rows))
        both = ok("eval", material, "--cos", "--convention", "scanline", stdin=lines(rows))
        assert scan.out == both.out
        for a, b in zip(cosine, scan.rows()):
            assert all(near(y, factor * x) for x, y in zip(a, b)), material
    radiometric = ok("eval", "lambert", "--convention", "radiometric", stdin=lines(rows)).out
    assert radiometric == ok("eval", "lambert", stdin=lines(rows)).out


def test_the_terms_multiply_to_the_value():
    rows = pairs(300)
    f = ok("eval", GGX, stdin=lines(rows)).rows()
    term = {t: ok("eval", GGX, "--term", t, stdin=lines(rows)).rows() for t in "DGVF"}
    for i, row in enumerate(rows):
        d, g, v, fresnel = (term[t][i] for t in "DGVF")
        assert len(d) == len(g) == len(v) == 1 and len(fresnel) == 3
        if row[2] > 0 and row[5] > 0:
            assert near(v[0], g[0] / (4 * row[2] * row[5]), 2e-6)
            assert all(near(a, b * d[0] * v[0], 3e-6) for a, b in zip(f[i], fresnel))
        else:
            assert d == g == v == [0] and fresnel == [0, 0, 0]


def test_a_term_of_a_sum_or_of_a_model_without_it_is_refused():
    refused(2, "eval", "lambert", "--term", "D", stdin=PAIR, place="--term",
            says="lambert has no D")
    refused(2, "eval", "0.5*ggx + 0.5*ggx", "--term", "F", stdin=PAIR, says="a sum has no F")


def test_angles_are_theta_and_phi_in_degrees():
    draw = random.Random(3)
    angles, rows = [], []
    for _ in range(200):
        a = [draw.uniform(0, 89), draw.uniform(-360, 360), draw.uniform(0, 89),
             draw.uniform(-360, 360)]
        ti, pi, to, po = map(math.radians, a)
        angles.append(a)
        rows.append([math.sin(ti) * math.cos(pi), math.sin(ti) * math.sin(pi), math.cos(ti),
                     math.sin(to) * math.cos(po), math.sin(to) * math.sin(po), math.cos(to)])
    got = ok("eval", GGX, "--angles", stdin=lines(angles)).rows()
    wanted = ok("eval", GGX, stdin=lines(rows)).rows()
    for a, b in zip(got, wanted):
        assert all(near(x, y, 1e-5) for x, y in zip(a, b))


def test_right_angles_are_exact():
    assert ok("eval", "lambert", "--angles", stdin="90 0 0 0\n270 0 0 0\n0 0 90 45\n").rows() == \
        [[0, 0, 0]] * 3
    text = ok("eval", "lambert", "--angles", "--csv", stdin="90 90 0 0\n180 0 360 720\n").text
    assert text.splitlines()[1].startswith("0,1,0,0,0,1,"), text
    assert text.splitlines()[2].startswith("0,0,-1,0,0,1,"), text


def test_two_directions_by_angle_need_no_input():
    with open("/dev/zero", "rb") as endless:
        got = ok("eval", GGX, "--wi-deg", "30,0", "--wo-deg=45,180", stdin=endless).text
    assert got == ok("eval", GGX, "--angles", stdin="30 0 45 180").text
    ok("eval", GGX, "--wi-deg", "-30,0", "--wo-deg", "45,180")
    refused(2, "eval", GGX, "--wi-deg", "30,0", place="--wo-deg", says="missing")
    refused(2, "eval", GGX, "--wo-deg", "30,0", place="--wi-deg", says="missing")
    for bad in ["30", "30,", "30,0,0", "a,b", "nan,0", "", "30 0"]:
        refused(2, "eval", GGX, "--wi-deg", bad, "--wo-deg", "0,0", place="--wi-deg")
    refused(2, "eval", GGX, "--wi-deg", "30,0", "--wo-deg", "0,0", "file", says="no input is read")


def test_options_that_exclude_each_other_are_refused():
    for a, b in [("--term=D", "--cos"), ("--term=D", "--convention=scanline"), ("--csv", "--json"),
                 ("--csv", "--binary=f32"), ("--json", "--binary=f32"), ("--print", "--csv"),
                 ("--angles", "--wi-deg=0,0"), ("--print", "--cos")]:
        refused(2, "eval", "ggx", a, b, stdin=PAIR, says="excludes")


def test_numbers_have_nine_digits_as_printf_gives_them():
    for row in ok("eval", GGX, stdin=lines(pairs(500))).text.splitlines():
        for word in row.split(" "):
            assert word == "%.9g" % f32(float(word)), word


def test_csv_has_a_header_the_directions_and_the_values():
    rows = pairs(20)
    text = ok("eval", GGX, "--csv", stdin=lines(rows)).text.splitlines()
    assert text[0] == "wi.x,wi.y,wi.z,wo.x,wo.y,wo.z,r,g,b"
    plain = ok("eval", GGX, stdin=lines(rows)).text.splitlines()
    for row, line, values in zip(rows, text[1:], plain):
        fields = line.split(",")
        assert all(near(float(a), b) for a, b in zip(fields, row)) and len(fields) == 9
        assert " ".join(fields[6:]) == values
    assert ok("eval", GGX, "--csv", "--term", "D", stdin=PAIR).text.startswith(
        "wi.x,wi.y,wi.z,wo.x,wo.y,wo.z,D\n")


def test_json_has_material_quantity_unit_and_rows():
    rows = pairs(30)
    for words, quantity, unit in [([], "brdf", "1/sr"), (["--cos"], "brdf_cos", "1/sr"),
                                  (["--term", "D"], "D", "1/sr"), (["--term", "G"], "G", "1"),
                                  (["--term", "V"], "V", "1"), (["--term", "F"], "F", "1"),
                                  (["--convention", "scanline"], "scanline", "1/sr")]:
        got = json.loads(ok("eval", GGX, "--json", *words, stdin=lines(rows)).text)
        assert list(got) == ["material", "quantity", "unit", "rows"]
        assert (got["quantity"], got["unit"]) == (quantity, unit)
        assert got["material"] == ok("eval", GGX, "--print").text.strip()
        assert got["rows"] == ok("eval", GGX, *words, stdin=lines(rows)).rows()


def test_binary_gives_the_same_numbers():
    rows = [[f32(x) for x in row] for row in pairs(5000)]
    data = b"".join(struct.pack("<6f", *row) for row in rows)
    wanted = [x for row in ok("eval", GGX, stdin=lines(rows)).rows() for x in row]
    out = ok("eval", GGX, "--binary", "f32", stdin=data).out
    assert list(struct.unpack(f"<{len(out) // 4}f", out)) == [f32(x) for x in wanted]
    angles = struct.pack("<4f", 30, 0, 45, 180)
    assert len(ok("eval", GGX, "--binary", "f32", "--angles", "--term", "D", stdin=angles).out) == 4


def npy(rows, kind="<f4", shape=None, by_columns=False, version=1):
    columns = list(zip(*rows)) if by_columns else rows
    code = {"<f4": "f", "<f8": "d", "<i8": "q"}[kind]
    data = b"".join(struct.pack(f"<{len(row)}{code}", *row) for row in columns)
    shape = shape or (len(rows), len(rows[0]))
    head = str({"descr": kind, "fortran_order": by_columns, "shape": shape}).encode() + b"\n"
    size = struct.pack("<H" if version == 1 else "<I", len(head))
    return b"\x93NUMPY" + bytes([version, 0]) + size + head + data


def npy_rows(data):
    assert data[:8] == b"\x93NUMPY\x01\x00", data[:20]
    size = struct.unpack("<H", data[8:10])[0]
    assert (10 + size) % 64 == 0 and data[9 + size] == 10
    head = eval(data[10:10 + size])  # a literal that this program has written
    assert head["descr"] == "<f4" and head["fortran_order"] is False
    return head["shape"], list(struct.unpack(f"<{(len(data) - 10 - size) // 4}f", data[10 + size:]))


def test_npy_arrays_go_in_and_out():
    rows = [[f32(x) for x in row] for row in pairs(5000)]
    wanted = [f32(x) for row in ok("eval", GGX, stdin=lines(rows)).rows() for x in row]
    with Folder() as folder:
        for data in [npy(rows), npy(rows, "<f8"), npy(rows, by_columns=True),
                     npy(rows, "<f8", by_columns=True), npy(rows, version=2),
                     npy(rows, shape=(5000, 2, 3))]:
            for words, feed in [([folder.file("d.npy", data)], b""), ([], data), (["-"], data)]:
                shape, got = npy_rows(ok("eval", GGX, *words, stdin=feed).out)
                assert shape == (5000, 3) and got == wanted
    shape, got = npy_rows(ok("eval", GGX, "--term", "D", stdin=npy(rows)).out)
    assert shape == (5000,) and len(got) == 5000
    shape, got = npy_rows(ok("eval", GGX, stdin=npy([rows[0]], shape=(6,))).out)
    assert shape == (1, 3) and got == wanted[:3]


def test_formats_can_be_mixed():
    rows = [[f32(x) for x in row] for row in pairs(50)]
    wanted = [f32(x) for row in ok("eval", GGX, stdin=lines(rows)).rows() for x in row]
    assert npy_rows(ok("eval", GGX, "--binary", "npy", stdin=lines(rows)).out)[1] == wanted
    out = ok("eval", GGX, "--binary", "f32", stdin=npy(rows)).out
    assert list(struct.unpack("<150f", out)) == wanted
    assert ok("eval", GGX, "--csv", stdin=npy(rows)).out == \
        ok("eval", GGX, "--csv", stdin=lines(rows)).out
    assert npy_rows(ok("eval", GGX, "--binary", "npy", "--wi-deg=0,0", "--wo-deg=0,0").out)[0] == \
        (1, 3)


def test_bad_npy_arrays_are_refused():
    rows = pairs(10)
    good = npy(rows)
    for data, says in [(good[:-1], "cut off"), (good[:40], "cut off"), (good[:9], "cut off"),
                       (npy([[0, 0, 1, 0, 0, 1]], "<i8"), "float32 or float64"),
                       (npy(rows, shape=(10, 5)), "shape must be (rows, 6)"),
                       (npy(rows, shape=(2, 5, 6, 1)), "shape"), (npy(rows, shape=(60,)), "shape"),
                       (npy(rows, shape=(10 ** 14, 6)), "cut off"),
                       (good.replace(b"'descr'", b"'descx'"), "malformed"),
                       (good.replace(b"'shape': (10, 6)", b"'shape': (1O, 6)"), "shape")]:
        refused(1, "eval", GGX, stdin=data, says=says, place="stdin")
    refused(1, "eval", GGX, "--angles", stdin=good, says="(rows, 4)")
    with Folder() as folder:
        path = folder.file("d.npy", lines(rows))
        refused(1, "eval", GGX, path, says="is not a .npy file", place=path)
    rows[3][0] = math.nan
    refused(1, "eval", GGX, stdin=npy(rows), place="stdin: row 4")


def test_print_gives_text_that_parses_to_itself():
    for name in models():
        text = ok("eval", name, "--print").text
        assert ok("eval", text.strip(), "--print").text == text
    refused(2, "eval", GGX, "--print", "file", says="no input is read")
    sum_text = "[0.3, 0.2, 0.1]*lambert(color=#336699) + 0.7*ggx(alpha=0.1)"
    printed = ok("eval", sum_text, "--print").text.strip()
    assert ok("eval", sum_text, stdin=PAIR).out == ok("eval", printed, stdin=PAIR).out


def random_value(draw, param):
    if param["kind"] == "choice":
        return draw.choice(param["words"].split())
    if param["kind"] == "number":
        low, high = param["low"] or 0, min(param["high"] or 50, 50)
        return repr(low + (high - low) * draw.uniform(0.01, 1))
    if param["kind"] == "color":
        high = min(param["high"] or 1, 5)
        return draw.choice([repr(high * draw.uniform(0.01, 1)),
                            "[" + ", ".join(repr(high * draw.random()) for _ in range(3)) + "]"])
    if param["kind"] == "ramp":
        return f"[-0.5: {draw.random()!r}, 0.25: [1, 0.5, {draw.random()!r}]]"
    return "gold"


def test_random_materials_of_every_model_round_trip():
    draw = random.Random(8)
    checked = 0
    for name in models():
        params = json.loads(ok("models", name, "--json").text)["params"]
        for _ in range(6):
            chosen = draw.sample(params, min(2, len(params)))
            text = f"{name}({', '.join(p['key'] + '=' + random_value(draw, p) for p in chosen)})"
            done = refused_or_printed(text)
            if done is None:
                continue
            checked += 1
            printed = done.text.strip()
            assert ok("eval", printed, "--print").text.strip() == printed
            stdin = lines(pairs(20))
            assert ok("eval", text, stdin=stdin).out == ok("eval", printed, stdin=stdin).out, text
            long_form = ok("eval", text, "--print", "--json").text
            json.loads(long_form)
            if has_workbench():
                assert ok("eval", long_form, "--print").text.strip() == printed
    assert checked > 40


def refused_or_printed(text):
    """The run of --print, or None where the keys exclude each other."""
    from cli import run
    done = run("eval", text, "--print")
    assert done.code == 0 or (done.code == 2 and "column" in done.err), done
    return done if done.code == 0 else None


if __name__ == "__main__":
    main(globals())
