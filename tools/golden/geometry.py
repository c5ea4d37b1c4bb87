# SPDX-License-Identifier: Apache-2.0
"""The angles of a pair of directions, in the frame n = (0,0,1), t = (1,0,0), b = (0,1,0).

c is an mpmath context: mp for reference values, fp (double) inside the albedo quadrature.
"""


class Geometry:
    """theta and phi of wi (ti, pi), wo (to, po) and h (th, ph), td = angle between wi and h,
    x = the six direction components after normalisation (None when made from h)."""

    def __init__(self, c, ti, pi, to, po, th, ph, td, x=None):
        self.c, self.x = c, x
        self.ti, self.pi, self.to, self.po = ti, pi, to, po
        self.th, self.ph, self.td = th, ph, td
        self.ci, self.co, self.ch, self.cd = c.cos(ti), c.cos(to), c.cos(th), c.cos(td)

    @staticmethod
    def of_directions(c, wi, wo, keep_length=False):
        """wi, wo above the horizon; their length is divided out unless keep_length."""
        if not keep_length:
            wi, wo = unit(c, wi), unit(c, wo)
        total = [a + b for a, b in zip(wi, wo)]
        cd = below_one(c.sqrt(sum(x * x for x in total)) / 2)
        return Geometry(c, polar_angle(c, wi), azimuth(c, wi), polar_angle(c, wo),
                        azimuth(c, wo), polar_angle(c, total), azimuth(c, total), c.acos(cd),
                        (wi, wo))

    @staticmethod
    def of_half(c, th, ph, to):
        """wo at polar angle to and azimuth 0, h at (th, ph); wi is wo mirrored at h."""
        h = (c.sin(th) * c.cos(ph), c.sin(th) * c.sin(ph), c.cos(th))
        wo = (c.sin(to), 0 * to, c.cos(to))
        cd = sum(a * b for a, b in zip(wo, h))
        wi = [2 * cd * a - b for a, b in zip(h, wo)]
        return Geometry(c, c.acos(clamped(wi[2])), azimuth(c, wi), to, 0 * to, th, ph,
                        c.acos(clamped(cd)), (wi, wo))


def unit(c, v):
    length = c.sqrt(sum(a * a for a in v))
    return [a / length for a in v]


def polar_angle(c, v):
    """The angle to n of a vector of any length."""
    return c.atan2(c.hypot(v[0], v[1]), v[2])


def azimuth(c, v):
    """atan2(y, x); 0 at the pole, where every formula is independent of it."""
    return c.atan2(v[1], v[0]) if v[0] != 0 or v[1] != 0 else 0 * v[2]


def below_one(x):
    """The last digit of a normalisation may exceed 1, where acos would turn complex."""
    return x if x <= 1 else x / x


def clamped(x):
    return min(1.0, max(-1.0, x))
