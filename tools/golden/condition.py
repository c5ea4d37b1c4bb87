# SPDX-License-Identifier: Apache-2.0
"""Reference value and condition number of one case.

k = sum of |x df/dx| / |f| over the six direction components and every number that the material
gives, by central differences; plus |c df/dc| / |f| for the cosine c under a power (phong,
blinn_phong) and for the Fresnel cosine where f0 = 0. Blinn's ndf counts without its cosine: its
accuracy comes from the tangent of h.
"""
from mpmath import mp, mpf

from densities import density
from material import leaves, lift_material, with_leaf
from models import FLT_MAX, evaluate

VALUE_DIGITS, SLOPE_DIGITS = 50, 40
STEP = mpf(10) ** -12              # relative; truncation about 1e-24, rounding about 1e-28


def value_of(real, quantity, wi, wo, nudge=0, keep_length=False):
    """Any quantity of a lifted material, per channel."""
    if quantity == "pdf":
        return density(mp, real, wi, wo, nudge, keep_length)
    return evaluate(mp, real, quantity, wi, wo, nudge, keep_length)


def jumps(a, b):
    """A step function crossed exactly at its step: no slope, and x is exact there."""
    return abs(a - b) > mpf("1e-5") * (abs(a) + abs(b))


def slopes(real, quantity, wi, wo):
    """x df/dx of every input x, per channel: yields triples."""
    def difference(f):
        up, down = f(1 + STEP), f(1 - STEP)
        return tuple(0 if jumps(a, b) else (a - b) / (2 * STEP) for a, b in zip(up, down))

    for vector, other in ((wi, True), (wo, False)):
        for i in range(3):
            if vector[i] == 0:
                continue

            def moved(s):
                v = list(vector)
                v[i] = v[i] * s
                pair = (v, wo) if other else (wi, v)
                return value_of(real, quantity, *pair)
            yield difference(moved)
    for path, x in list(leaves(real)):
        if x != 0:
            yield difference(lambda s: value_of(with_leaf(real, path, x * s), quantity, wi, wo))
    yield difference(lambda s: value_of(real, quantity, wi, wo, s - 1))


def reference(lobes, quantity, wi, wo):
    """(three doubles, three k) of a material at float-rounded directions."""
    real = lift_material(lobes)
    wi, wo = [mpf(x) for x in wi], [mpf(x) for x in wo]
    with mp.workdps(VALUE_DIGITS):
        value = value_of(real, quantity, wi, wo)
    if all(v == 0 for v in value):
        return (0.0,) * 3, (0.0,) * 3
    total = [mpf(0)] * 3
    with mp.workdps(SLOPE_DIGITS):
        for s in slopes(real, quantity, wi, wo):
            total = [t + abs(x) for t, x in zip(total, s)]
    k = []
    for t, v in zip(total, value):
        k.append(0.0 if v == 0 or v > FLT_MAX else float(t / abs(v)))
    return tuple(float(min(v, FLT_MAX)) for v in value), tuple(k)


def depends_on_length(lobes, quantity, wi, wo, value, k):
    """True where leaving the rounded lengths of wi and wo in h takes over 1/8 of the error bound:
    such a case would test a convention, not a formula."""
    real = lift_material(lobes)
    with mp.workdps(SLOPE_DIGITS):
        kept = value_of(real, quantity, [mpf(x) for x in wi], [mpf(x) for x in wo], 0, True)
        return any(abs(min(u, FLT_MAX) - v) > (16 + 4 * n) * mpf(2) ** -26 * abs(v)
                   for u, v, n in zip(kept, value, k))
