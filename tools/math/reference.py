#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes tests/shade/math_reference.csv: elementary functions at floats, in 50 digits by mpmath,
rounded to double. Independent of libm and of src/shade. Usage: reference.py > math_reference.csv"""
import struct
import sys
from mpmath import (mp, mpf, exp, expm1, log, log1p, acos, atan2, sin, cos, sinpi, cospi, pi,
                    erf, erfc, sqrt)

mp.dps = 50
COUNT = 400


def to_float(value):
    """value rounded to float, as a Python number."""
    return struct.unpack("f", struct.pack("f", float(value)))[0]


def erfinv(x):
    """Newton on erfc in full precision; mpmath's own erfinv is not used next to 1."""
    a = abs(x)
    if a == 0:
        return mpf(0)
    y = sqrt(-log((1 - a) * (1 + a)))
    for _ in range(200):
        step = (erfc(y) - (1 - a)) * exp(y * y) * sqrt(pi) / 2
        y += step
        if abs(step) < mpf(10) ** -45 * y:
            break
    return y if x > 0 else -y


def spread(lo, hi):
    """COUNT numbers that fill [lo, hi] evenly, the ends first."""
    golden = 0.6180339887498949
    return [lo, hi] + [lo + (hi - lo) * ((k * golden) % 1.0) for k in range(1, COUNT - 1)]


def decades(lo, hi, signs=(1,)):
    """Numbers whose logarithms fill [log lo, log hi], with alternating signs."""
    return [signs[k % len(signs)] * 10.0 ** e
            for k, e in enumerate(spread(mp.log10(lo), mp.log10(hi)))]


def halves(first, second):
    """Every other number of two lists."""
    return first[0::2] + second[1::2]


BOTH = (1, -1)
ONE = {
    "exp": (exp, halves(spread(-69, 88.7), decades(1e-9, 1, BOTH))),
    "expm1": (expm1, halves(spread(-30, 88.7), decades(1e-12, 1, BOTH))),
    "log": (log, halves(decades(1e-37, 1e38), spread(0.5, 1.5))),
    "log1p": (log1p, halves(decades(1e-12, 1e30), spread(-0.9999, 1))),
    "acos": (acos, halves(spread(-1, 1), [1 - float(d) for d in decades(1e-7, 1)])),
    "sin": (sin, halves(spread(-1000, 1000), spread(-3.2, 3.2))),
    "cos": (cos, halves(spread(-1000, 1000), spread(-3.2, 3.2))),
    "sin2pi": (lambda u: sinpi(2 * u), halves(spread(-1, 1), decades(1e-9, 1e4, BOTH))),
    "cos2pi": (lambda u: cospi(2 * u), halves(spread(-1, 1), decades(1e-9, 1e4, BOTH))),
    "erf": (erf, halves(spread(-4, 4), decades(1e-12, 1, BOTH))),
    "erfc": (erfc, halves(spread(-4, 8), decades(1e-9, 1, BOTH))),
    "erfinv": (erfinv, halves(spread(-0.999, 0.999), [1 - float(d) for d in decades(1e-7, 1)])),
}
TWO = {
    "pow": (lambda x, y: x ** y, halves(spread(1e-6, 1), [1 - float(d) for d in decades(1e-6, 1)]),
            decades(1e-3, 1e6)),
    "atan2": (atan2, spread(-1, 1), decades(1e-6, 1e6, BOTH)),
}


def main():
    print("# Elementary functions at floats, by mpmath in 50 digits, rounded to double.")
    print("# Made by tools/math/reference.py")
    print("function,x,y,value")
    for name, (function, xs) in ONE.items():
        for x in sorted({to_float(x) for x in xs}):
            print(f"{name},{x!r},0,{float(function(mpf(x))):.17g}")
    for name, (function, xs, ys) in TWO.items():
        for x, y in zip(xs, reversed(ys)):
            x, y = to_float(x), to_float(y)
            value = function(mpf(x), mpf(y))
            if value == 0 or abs(value) > mpf(2) ** -99:
                print(f"{name},{x!r},{y!r},{float(value):.17g}")


if __name__ == "__main__":
    sys.exit(main())
