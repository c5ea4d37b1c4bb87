# SPDX-License-Identifier: Apache-2.0
"""Materials as plain data: lobes with float-rounded parameters, their printed form, their leaves.

A value is a float (a number), a tuple of three floats (a colour), a str (a word or "#rrggbb") or a
Ramp. Every number is rounded to IEEE single precision when the material is made, so that what is
printed with nine digits is exactly what the reference is evaluated at.
"""
import struct

from mpmath import mpf


def f32(x):
    """The nearest float32 of x, as a Python float."""
    return struct.unpack("<f", struct.pack("<f", float(x)))[0]


def number_text(x):
    """Nine significant digits identify every float32."""
    return "%.9g" % x


class Ramp:
    """Stops (place, number or colour) in rising order of place."""

    def __init__(self, *stops):
        self.stops = [(f32(p), rounded(c)) for p, c in stops]


def rounded(value):
    """The value with every number in it rounded to float32."""
    if isinstance(value, (str, Ramp)):
        return value
    if isinstance(value, tuple):
        return tuple(f32(v) for v in value)
    return f32(value)


def value_text(value):
    if isinstance(value, str):
        return value
    if isinstance(value, tuple):
        return "[" + ",".join(number_text(v) for v in value) + "]"
    if isinstance(value, Ramp):
        return "[" + ", ".join(number_text(p) + ":" + value_text(c) for p, c in value.stops) + "]"
    return number_text(value)


class Lobe:
    """weight * model(params); weight None prints no weight and means 1."""

    def __init__(self, model, weight=None, **params):
        self.model = model
        self.weight = None if weight is None else rounded(weight)
        self.params = {k: rounded(v) for k, v in params.items()}

    def text(self):
        args = ", ".join(k + "=" + value_text(v) for k, v in self.params.items())
        head = "" if self.weight is None else value_text(self.weight) + "*"
        return head + self.model + ("(" + args + ")" if args else "")


def material_text(lobes):
    return " + ".join(lobe.text() for lobe in lobes)


def lift(value):
    """The same value with numbers as mpf (exact) and ramps as lists of pairs."""
    if isinstance(value, str) or value is None:
        return value
    if isinstance(value, tuple):
        return tuple(mpf(v) for v in value)
    if isinstance(value, Ramp):
        return [(mpf(p), lift(c)) for p, c in value.stops]
    return mpf(value)


def lift_material(lobes):
    """[(model, weight, params)] with exact real numbers: what the models take."""
    return [(b.model, lift(b.weight), {k: lift(v) for k, v in b.params.items()}) for b in lobes]


def _leaves(value, path):
    if isinstance(value, mpf):
        yield path, value
    elif isinstance(value, (tuple, list)):
        for i, v in enumerate(value):
            yield from _leaves(v, path + (i,))


def leaves(real):
    """(path, number) of every given parameter and weight of a lifted material."""
    for i, (_, weight, params) in enumerate(real):
        yield from _leaves(weight, (i, "weight"))
        for key, value in params.items():
            yield from _leaves(value, (i, key))


def _replaced(value, path, x):
    if not path:
        return x
    parts = list(value)
    parts[path[0]] = _replaced(parts[path[0]], path[1:], x)
    return type(value)(parts)


def with_leaf(real, path, x):
    """A copy of the lifted material in which the number at path is x."""
    out = list(real)
    model, weight, params = out[path[0]]
    if path[1] == "weight":
        weight = _replaced(weight, path[2:], x)
    else:
        params = dict(params)
        params[path[1]] = _replaced(params[path[1]], path[2:], x)
    out[path[0]] = (model, weight, params)
    return out
