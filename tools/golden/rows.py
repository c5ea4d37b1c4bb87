# SPDX-License-Identifier: Apache-2.0
"""Collects the rows of one CSV file, refuses ill-conditioned ones, and writes them."""
from condition import depends_on_length, reference
from material import material_text, number_text
from points import Points
from tags import case_tags

HEADER = "tag,material,quantity,wx,wy,wz,ox,oy,oz,r,g,b,kr,kg,kb"
TINY = 1e-20                        # what the contract allows to be 0 proves nothing
MAX_K, MAX_SHARE = 1000, 0.02


class Rows:
    def __init__(self, name):
        self.name, self.lines, self.k, self.points = name, [], [], Points(name)
        self.covered = set()

    def add(self, lobes, quantity, wi, wo, limit=None):
        """Adds the case and returns True; False where a value is too small, k above limit, or the
        value hangs on the rounded length of a direction."""
        value, k = reference(lobes, quantity, wi, wo)
        if any(0 < v < TINY for v in value) or (limit and max(k) > limit):
            return False
        if any(value) and depends_on_length(lobes, quantity, wi, wo, value, k):
            return False
        gated = wi[2] <= 0 or wo[2] <= 0
        tags = case_tags(lobes, quantity, gated)
        fields = [" ".join(tags), '"%s"' % material_text(lobes), quantity]
        fields += [number_text(x) for x in (*wi, *wo)]
        fields += ["%.17g" % v for v in value] + ["%.6g" % x for x in k]
        self.lines.append(",".join(fields))
        self.k.append(max(k))
        self.covered.update(tags)
        return True

    def draw(self, make, limit=MAX_K, tries=400):
        """make() returns (lobes, quantity, wi, wo); drawn again until add accepts it."""
        for _ in range(tries):
            if self.add(*make(), limit=limit):
                return
        raise RuntimeError("%s: no acceptable case in %d draws" % (self.name, tries))

    def share(self):
        return sum(k > MAX_K for k in self.k) / len(self.k)

    def text(self, what):
        if self.share() > MAX_SHARE:
            raise RuntimeError("%s: %.1f %% of the rows have k > 1000" % (self.name,
                                                                         100 * self.share()))
        head = ["# SPDX-License-Identifier: Apache-2.0",
                "# %s: reference values in 50 digits (mpmath), rounded to double." % what,
                "# Made by: tools/golden/generate.py %s" % self.name,
                "# k: condition number of each channel (docs/golden.md). "
                "D, G and V repeat in r g b."]
        return "\n".join(head + [HEADER] + self.lines) + "\n"
