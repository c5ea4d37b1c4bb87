# SPDX-License-Identifier: Apache-2.0
"""conversions.csv: given keys, wanted key, value, condition number of the value."""
from mpmath import mp, mpf

from material import f32, number_text
from terms import anisotropic, roughness_to_alpha

STEP = mpf(10) ** -15


def alpha_of(p):
    if "alpha" in p:
        return p["alpha"]
    if "roughness" in p:
        return roughness_to_alpha(mp, p["roughness"], p.get("roughness_map", "square"))
    blinn = p["blinn_exponent"] if "blinn_exponent" in p else 4 * p["phong_exponent"]
    return mp.sqrt(2 / (blinn + 2))


def blinn_of(p):
    if "phong_exponent" in p:
        return 4 * p["phong_exponent"]
    return p["blinn_exponent"] if "blinn_exponent" in p else 2 / alpha_of(p) ** 2 - 2


def widths_of(p):
    return anisotropic(mp, alpha_of(p), p.get("anisotropy", mpf(0)),
                       p.get("anisotropy_kind", "burley"))


def sigma2_of(p):
    if "a57" in p:
        return mpf("0.57") * (1 - p["a57"]) / (p["a57"] - mpf("0.5"))
    if "a" in p:
        return mpf("0.33") * (1 - p["a"]) / (p["a"] - mpf("0.5"))
    return p["sigma"] ** 2


def burley_inverse(p):
    """(alpha, anisotropy) of two widths: their product is alpha^2, their ratio 1 - 0.9 a."""
    alpha = mp.sqrt(p["alpha_x"] * p["alpha_y"])
    return alpha, (1 - p["alpha_y"] / p["alpha_x"]) / mpf("0.9")


def a_of(p, offset):
    s2 = sigma2_of(p)
    return 1 - s2 / (2 * (s2 + mpf(offset)))


TO = {
    "alpha": lambda p: burley_inverse(p)[0] if "alpha_x" in p else alpha_of(p),
    "roughness": lambda p: mp.sqrt(TO["alpha"](p)),
    "anisotropy": lambda p: burley_inverse(p)[1],
    "alpha_x": lambda p: widths_of(p)[0],
    "alpha_y": lambda p: widths_of(p)[1],
    "blinn_exponent": blinn_of,
    "phong_exponent": lambda p: blinn_of(p) / 4,
    "f0": lambda p: ((p["ior"] - 1) / (p["ior"] + 1)) ** 2,
    "ior": lambda p: (1 + mp.sqrt(p["f0"])) / (1 - mp.sqrt(p["f0"])),
    "sigma": lambda p: mp.sqrt(sigma2_of(p)),
    "a": lambda p: a_of(p, "0.33"),
    "a57": lambda p: a_of(p, "0.57"),
}


def tags_of(given, to):
    keys = set(given) | {to}
    out = []
    if "roughness" in keys:
        out.append("S1.15")
        if given.get("roughness_map", "square") == "square":
            out.append("S3.1")
    if given.get("roughness_map") == "direct":
        out.append("S2.11")
    if keys & {"anisotropy", "alpha_x", "alpha_y"}:
        out.append("S3.7")
    if "phong_exponent" in keys:
        out.append("S4.24")
    if "blinn_exponent" in keys:
        out += ["S3.4", "S4.45"]
    if "ior" in keys:
        out += ["S2.5", "S3.20"]
    if keys & {"sigma", "a", "a57"}:
        out.append("S4.32")
    return out


def row(given, to):
    p = {k: v if isinstance(v, str) else mpf(f32(v)) for k, v in given.items()}
    with mp.workdps(50):
        value, k = TO[to](p), mpf(0)
        for key, x in p.items():
            if not isinstance(x, str) and x != 0 and value != 0:
                up, down = (TO[to](dict(p, **{key: x * (1 + s)})) for s in (STEP, -STEP))
                k += abs((up - down) / (2 * STEP) / value)
        value, k = float(value), float(k)
    text = " ".join(n + "=" + (v if isinstance(v, str) else number_text(f32(v)))
                    for n, v in given.items())
    return "%s,%s,%s,%.17g,%.6g" % (" ".join(tags_of(given, to)), text, to, value, k)


def cases():
    for r in (0.05, 0.1, 0.3, 0.5, 0.75, 1.0):
        for to in ("alpha", "blinn_exponent", "phong_exponent", "alpha_x", "alpha_y"):
            yield {"roughness": r}, to
    for mapping in ("square", "direct", "sqrt"):
        for to in ("alpha", "alpha_x"):
            yield {"roughness": 0.3, "roughness_map": mapping}, to
    for kind in (None, "burley", "kulla", "openpbr", "gltf"):
        for a in (0.0, 0.3, 0.8, 0.95):
            word = {} if kind is None else {"anisotropy_kind": kind}
            for to in ("alpha_x", "alpha_y"):
                yield {"roughness": 0.4, "anisotropy": a, **word}, to
                yield {"alpha": 0.3, "anisotropy": a, **word}, to
    for pair in ((0.3, 0.3), (0.5, 0.2), (0.8, 0.1)):
        for to in ("alpha", "roughness", "anisotropy"):
            yield {"alpha_x": pair[0], "alpha_y": pair[1]}, to
    for alpha in (0.01, 0.1, 0.3, 0.5, 1.0):
        for to in ("roughness", "blinn_exponent", "phong_exponent"):
            yield {"alpha": alpha}, to
    for g in (0.0, 1.0, 10.0, 30.0, 198.0, 1000.0):
        for to in ("alpha", "roughness", "phong_exponent"):
            yield {"blinn_exponent": g}, to
        for to in ("alpha", "roughness", "blinn_exponent"):
            yield {"phong_exponent": g}, to
    for ior in (1.0, 1.33, 1.5, 2.42, 0.75, 10.0):
        yield {"ior": ior}, "f0"
    for f0 in (0.0, 0.02, 0.04, 0.17, 0.5, 0.9):
        yield {"f0": f0}, "ior"
    for sigma in (0.0, 0.1, 0.349065850, 0.5, 1.0, 1.5707):
        yield {"sigma": sigma}, "a"
        yield {"sigma": sigma}, "a57"
    for a in (0.501, 0.55, 0.75, 0.9, 1.0):
        yield {"a": a}, "sigma"
        yield {"a57": a}, "sigma"
        yield {"a": a}, "a57"


def build():
    lines = [row(given, to) for given, to in cases()]
    covered = {t for line in lines for t in line.split(",")[0].split()}
    head = ["# SPDX-License-Identifier: Apache-2.0",
            "# Parameter conversions: reference values in 50 digits (mpmath), rounded to double.",
            "# Made by: tools/golden/generate.py conversions", "tag,given,to,value,k"]
    return "\n".join(head + lines) + "\n", "%d rows" % len(lines), covered
