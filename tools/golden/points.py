# SPDX-License-Identifier: Apache-2.0
"""Directions for the cases: random ones from a fixed seed, and named edge points.

Every direction is a unit vector rounded to float32, as `ndotl eval` makes them.
"""
import math
import random

from material import f32

UP = (0.0, 0.0, 1.0)


def rounded_unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(f32(x / length) + 0.0 for x in v)


def polar(theta, phi):
    return rounded_unit((math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi),
                         math.cos(theta)))


def graze(z, phi):
    """A direction whose z is exactly f32(z)."""
    s = math.sqrt(1 - z * z)
    return (f32(s * math.cos(phi)), f32(s * math.sin(phi)), f32(z))


def mirror(wo, h):
    d = 2 * sum(a * b for a, b in zip(wo, h))
    return rounded_unit([d * b - a for a, b in zip(wo, h)])


class Points:
    def __init__(self, name):
        self.random = random.Random("ndotl golden " + name)

    def uniform(self, lo, hi):
        return lo + (hi - lo) * self.random.random()

    def log_uniform(self, lo, hi):
        return math.exp(self.uniform(math.log(lo), math.log(hi)))

    def pick(self, items):
        return items[int(self.random.random() * len(items))]

    def phi(self):
        return self.uniform(0, 2 * math.pi)

    def colour(self, lo=0.05):
        return tuple(self.uniform(lo, 1) for _ in range(3))

    def up(self, z0=0.0):
        """Uniform over the upper hemisphere, z above z0."""
        return polar(math.acos(self.uniform(z0, 1)), self.phi())

    def pair(self):
        """Uniform pair; one time in ten one of the two is below the horizon."""
        wi, wo = self.up(), self.up()
        if self.random.random() < 0.1:
            if self.random.random() < 0.5:
                wi = wi[:2] + (-wi[2],)
            else:
                wo = wo[:2] + (-wo[2],)
        return wi, wo

    def lobe_pair(self, ax, ay, wo=None):
        """wo as given or uniform, h with slopes of the widths ax, ay (Gaussian)."""
        while True:
            out = wo or self.up(0.02)
            r, phi = math.sqrt(-math.log(1 - self.random.random())), self.phi()
            h = rounded_unit((ax * r * math.cos(phi), ay * r * math.sin(phi), 1))
            wi = mirror(out, h)
            if wi[2] > 0:
                return wi, out

    def near_normal(self, alpha):
        """A pair inside a lobe of width alpha around n: few ulp of h, so a small k."""
        wo = polar(alpha * self.uniform(0.2, 2), self.phi())
        return self.lobe_pair(alpha, alpha, wo)

    def edge(self, name):
        phi = self.phi()
        if name == "mirror":
            wo = self.up(0.05)
            return (-wo[0], -wo[1], wo[2]), wo
        wo = self.up(0.1)
        if name == "wo_n":
            return self.up(0.1), UP
        if name == "wi_n":
            return UP, wo
        if name == "both_n":
            return UP, UP
        if name == "retro":
            return wo, wo
        if name == "low_wi":
            return graze(1e-6, phi), wo
        if name == "low_wo":
            return wo, graze(1e-6, phi)
        if name == "low_mirror":
            return graze(1e-6, phi), graze(1e-6, phi + math.pi)
        if name == "low_retro":
            return graze(1e-3, phi), graze(1e-3, phi)
        if name == "below_wi":
            return wo[:2] + (-wo[2],), self.up(0.1)
        if name == "below_wo":
            return self.up(0.1), wo[:2] + (-wo[2],)
        if name == "zero_wi":
            return graze(0.0, phi), wo
        if name == "zero_wo":
            return wo, graze(0.0, phi)
        raise ValueError(name)

    def h_low(self, tangent):
        """A pair whose h has about this slope, at about one azimuth."""
        theta, phi = math.atan(tangent), self.phi()
        spread = min(0.3, 0.5 * (math.pi / 2 - theta))
        return polar(theta + spread, phi), polar(theta - spread, phi + 0.05)


GATE = ("below_wi", "below_wo", "zero_wi", "zero_wo")
LEVEL = ("mirror", "wo_n", "wi_n", "both_n", "retro", "low_wi", "low_wo", "low_mirror", "low_retro")
