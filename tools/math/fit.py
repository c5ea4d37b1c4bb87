#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the polynomial coefficients of src/shade/math.h: relative minimax fits by Remez's
exchange in 50 digits, rounded to float. Needs mpmath. Run without arguments."""
import struct
import sys
from mpmath import (mp, mpf, mpmathify, exp, expm1, log, log1p, asin, atan, sin, cos, erf, erfc,
                    erfinv, sqrt, pi, matrix, lu_solve)

mp.dps = 50


def to_float(value):
    """The float nearest to an mpf (coefficients are far from any double rounding trouble)."""
    return struct.unpack("f", struct.pack("f", float(value)))[0]


def remez(target, degree, lo, hi, weight=lambda x: mpf(1), rounds=12, grid=1200):
    """Coefficients c (constant first) that minimise max |weight (target - sum c_k x^k)|, and
    that maximum."""
    lo, hi = mpf(lo), mpf(hi)
    count = degree + 2
    middle, radius = (lo + hi) / 2, (hi - lo) / 2
    xs = [middle - radius * cos(pi * i / grid) for i in range(grid + 1)]
    fs = [target(x) for x in xs]
    ws = [weight(x) for x in xs]
    reference = [round(i * grid / (count - 1)) for i in range(count)]
    for _ in range(rounds):
        a = matrix(count, count)
        b = matrix(count, 1)
        for row, i in enumerate(reference):
            for k in range(degree + 1):
                a[row, k] = xs[i] ** k
            a[row, degree + 1] = (-1) ** row / ws[i]
            b[row] = fs[i]
        solution = lu_solve(a, b)
        c = [solution[k] for k in range(degree + 1)]
        error = []
        for x, f, w in zip(xs, fs, ws):
            p = mpf(0)
            for k in reversed(c):
                p = p * x + k
            error.append(w * (f - p))
        # One extremum per run of equal sign; keep the `count` neighbours with the largest ends.
        runs = []
        for i, e in enumerate(error):
            if runs and (error[runs[-1]] > 0) == (e > 0):
                if abs(e) > abs(error[runs[-1]]):
                    runs[-1] = i
            else:
                runs.append(i)
        while len(runs) > count:
            runs.pop(0 if abs(error[runs[0]]) < abs(error[runs[-1]]) else -1)
        if len(runs) < count or runs == reference:
            break
        reference = runs
    return c, max(abs(e) for e in error)


def at_zero(function, limit):
    """function, with its limit where it is 0/0."""
    return lambda x: limit if x == 0 else function(x)


def log1p_rest(f):
    return (log1p(f) - f + f * f / 2) / f ** 3 if abs(f) > mpf(10) ** -9 else mpf(1) / 3


def expm1_rest(x):
    return (expm1(x) - x) / x ** 2 if abs(x) > mpf(10) ** -9 else mpf(1) / 2


def asin_rest(z):
    s = sqrt(z)
    return (asin(s) - s) / (s * z) if z > mpf(10) ** -12 else mpf(1) / 6


def atan_rest(z):
    s = sqrt(z)
    return (atan(s) - s) / (s * z) if z > mpf(10) ** -12 else -mpf(1) / 3


def sin_rest(z):
    s = sqrt(z)
    return (sin(s) - s) / (s * z) if z > mpf(10) ** -12 else -mpf(1) / 6


def cos_rest(z):
    return (cos(sqrt(z)) - 1 + z / 2) / z ** 2 if z > mpf(10) ** -9 else mpf(1) / 24


def erf_ratio(z):
    s = sqrt(z)
    return erf(s) / s - 1 if z > mpf(10) ** -20 else 2 / sqrt(pi) - 1


def scaled_erfc(t):
    """exp(x^2) erfc(x) / t as a function of t = 1/(1 + x/2)."""
    x = 2 * (1 / t - 1)
    return exp(x * x) * erfc(x) / t


def erfinv_by_log(w):
    x = sqrt(-expm1(-w)) if w > 0 else mpf(0)
    return erfinv(x) / x if w > mpf(10) ** -12 else sqrt(pi) / 2


def far_erfinv(w):
    """erfinv/x by log erfc inversion: Newton on erfc, since 1 - x is tiny."""
    x = sqrt(-expm1(-w))
    y = 1 - x if w < 20 else exp(-w) / 2
    z = sqrt(w)
    for _ in range(30):
        step = (erfc(z) - y) / (-2 / sqrt(pi) * exp(-z * z))
        z -= step
        if abs(step) < mpf(10) ** -40:
            break
    return z / x


R = sqrt(mpf(2))
FITS = {
    "exp (e^r - 1 - r)/r^2": (expm1_rest, 4, -0.3467, 0.3467, lambda x: x * x + mpf(10) ** -12),
    "expm1 (e^x - 1 - x)/x^2": (expm1_rest, 5, -0.5, 0.5,
                                lambda x: abs(x) + mpf(10) ** -12),
    "log1p (log(1+f) - f + f^2/2)/f^3": (log1p_rest, 7, 1 / R - 1, R - 1,
                                          lambda f: f * f + mpf(10) ** -12),
    "asin": (asin_rest, 5, 0, 0.25, lambda z: z + mpf(10) ** -12),
    "atan": (atan_rest, 7, 0, 1, lambda z: z + mpf(10) ** -12),
    "sin": (sin_rest, 2, 0, (pi / 4 * 1.001) ** 2, lambda z: z + mpf(10) ** -12),
    "cos": (cos_rest, 2, 0, (pi / 4 * 1.001) ** 2, lambda z: z * z + mpf(10) ** -12),
    "erf/x - 1, in x^2": (erf_ratio, 6, 0, 1, lambda z: 1 / (1 + erf_ratio(z))),
    "exp(x^2) erfc(x)/t, in t = 1/(1 + x/2)": (scaled_erfc, 7, 1 / mpf("5.3"), mpf(2) / 3,
                                               lambda t: 1 / scaled_erfc(t)),
    "erfinv/x near, in w - 2.5": (lambda u: erfinv_by_log(u + 2.5), 9, -2.5, 2.5,
                                  lambda u: 1 / erfinv_by_log(u + 2.5)),
    "erfinv/x far, in sqrt(w) - 3": (lambda s: far_erfinv((s + 3) ** 2), 9,
                                     sqrt(mpf(5)) - 3, 1,
                                     lambda s: 1 / far_erfinv((s + 3) ** 2)),
}

if __name__ == "__main__":
    names = [n for n in FITS if len(sys.argv) < 2 or n.startswith(sys.argv[1])]
    for name in names:
        coefficients, worst = remez(*FITS[name])
        print(f"{name}: error {float(worst):.2e}")
        for c in coefficients:
            print(f"    {to_float(c):.9g}")
