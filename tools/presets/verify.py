#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds src/core/presets.def to the spectra and writes tests/golden/presets.csv.

Usage: verify.py FOLDER     FOLDER holds the refractiveindex.info files *.yml

Shares nothing with derive.py but the tables of the package `colour`: it reads the float-rounded
(eta, k) from the generated text, and computes reflectances in 30 digits from the real form of the
conductor formula. Exit 1 when a channel misses its targets by more than TOLERANCE, or when a target
out of reach is not met by the nearer end of what its normal reflectance allows.
"""
import re
import sys
import warnings
from pathlib import Path

import mpmath as mp
import numpy as np

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    import colour

ROOT = Path(__file__).resolve().parents[2]
TOLERANCE = 1e-6  # float eta and k carry 6e-8 relative: the largest error is about 2e-8
ROW = re.compile(r'PRESET_METAL\((\w+),\s*ETA\(([^)]*)\),\s*K\(([^)]*)\),\s*"([^"]*)"')
CSV_HEAD = """\
# Made by tools/presets/verify.py from the spectra, independently of the generator of presets.def.
# eta, k: floats of src/core/presets.def. f0: linear Rec.709 reflectance of the spectrum (D65,
# CIE 1931 2 degrees), clamped to [0, 0.999]. f82_target: the same at 82 degrees, not clamped.
# f82_attained: exact conductor reflectance of (eta, k) at 82 degrees.
name,channel,eta,k,f0,f82_target,f82_attained
"""


def reflectance(n, k, degrees):
    """Unpolarised conductor reflectance with a^2 + b^2 = |sqrt(n^2 - k^2 - sin^2 + 2ink)|^2."""
    n, k, angle = mp.mpf(n), mp.mpf(k), mp.radians(degrees)
    c, s2 = mp.cos(angle), mp.sin(angle) ** 2
    d = n * n - k * k - s2
    ab = mp.sqrt(d * d + 4 * n * n * k * k)
    a = mp.sqrt(max((ab + d) / 2, mp.mpf(0)))
    s = (ab - 2 * a * c + c * c) / (ab + 2 * a * c + c * c)
    if degrees == 0:
        return s
    p = s * (ab * c * c - 2 * a * c * s2 + s2 * s2) / (ab * c * c + 2 * a * c * s2 + s2 * s2)
    return (s + p) / 2


class Observer:
    """Weights that take a reflectance on a 1 nm grid to linear Rec.709 under D65."""

    def __init__(self):
        bars = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
        light = colour.SDS_ILLUMINANTS["D65"]
        self.nm = np.arange(max(bars.wavelengths[0], light.wavelengths[0]),
                            min(bars.wavelengths[-1], light.wavelengths[-1]) + 1.0)
        bar = np.array([np.interp(self.nm, bars.wavelengths, column) for column in bars.values.T])
        xyz = bar * np.interp(self.nm, light.wavelengths, light.values)
        white = xyz.sum(axis=1)
        to_xyz = colour.models.normalised_primary_matrix(
            colour.RGB_COLOURSPACES["ITU-R BT.709"].primaries, white[:2] / white.sum())
        self.weights = np.linalg.solve(to_xyz, xyz / white[1])

    def rgb(self, spectrum, degrees):
        return self.weights @ np.array([float(reflectance(n, k, degrees)) for n, k in spectrum])


def load(path, nm):
    rows = re.findall(r"^ +(\S+) (\S+) (\S+)$", path.read_text(encoding="utf-8"), re.MULTILINE)
    table = np.array([row for row in rows if re.match(r"[\d.]", row[0])], dtype=float).T
    return list(zip(*(np.interp(nm, table[0] * 1000.0, column) for column in table[1:])))


def reach(f0):
    """Reflectances at 82 degrees of the real indices that reflect f0: the ends of the range."""
    root = mp.sqrt(mp.mpf(float(f0)))
    high = (1 + root) / (1 - root)
    return reflectance(high, 0, 82), reflectance(1 / high, 0, 82)


def main():
    folder = Path(sys.argv[1])
    mp.mp.dps = 30
    observer = Observer()
    rows, worst, bad, cache = [], (0.0, ""), 0, {}
    text = (ROOT / "src" / "core" / "presets.def").read_text(encoding="utf-8")
    for name, etas, ks, file in ROW.findall(text):
        if file not in cache:
            spectrum = load(folder / file, observer.nm)
            cache[file] = observer.rgb(spectrum, 0), observer.rgb(spectrum, 82)
        raw, grazing = cache[file]
        f0 = np.clip(raw, 0.0, 0.999)
        for i, (eta_text, k_text) in enumerate(zip(etas.split(", "), ks.split(", "))):
            eta, k = float(np.float32(eta_text)), float(np.float32(k_text))
            attained = float(reflectance(eta, k, 82))
            low, high = (float(x) for x in reach(f0[i]))
            nearest = min(max(grazing[i], low), high)
            error = max(abs(float(reflectance(eta, k, 0)) - f0[i]), abs(attained - nearest))
            worst = max(worst, (error, f"{name}.{'rgb'[i]}"))
            if f0[i] != raw[i] or nearest != grazing[i]:
                print(f"{name}.{'rgb'[i]}: F0 {raw[i]:.6f}, at 82 degrees {grazing[i]:.6f}, "
                      f"attainable [{low:.6f}, {high:.6f}], attained {attained:.6f}")
            if not error <= TOLERANCE:
                bad += 1
                print(f"{name}.{'rgb'[i]}: off by {error:.3g}", file=sys.stderr)
            rows.append(f"{name},{'rgb'[i]},{eta_text},{k_text},"
                        f"{f0[i]:.9f},{grazing[i]:.9f},{attained:.9f}\n")
    print(f"{len(rows)} channels, largest error {worst[0]:.3g} ({worst[1]})")
    if bad or not rows:
        return 1
    golden = ROOT / "tests" / "golden" / "presets.csv"
    golden.parent.mkdir(parents=True, exist_ok=True)
    golden.write_text(CSV_HEAD + "".join(rows), encoding="utf-8", newline="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
