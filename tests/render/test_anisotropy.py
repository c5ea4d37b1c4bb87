#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Highlights of grooved surfaces stretch across the grooves, and turn with the texture coordinates.

alpha_x = 0.05 along t, alpha_y = 0.5 across: grooves run along t."""
import os
import tempfile

import numpy as np

from pictures import render, report

MATERIAL = "ggx(alpha_x=0.05, alpha_y=0.5, f0=1)"
VIEW = ["--size", "64x64", "--light", "directional(direction=[0,0,1], irradiance=1)"]


def spread(picture):
    """Standard deviations of the highlight along x and y of the picture, in pixels."""
    weight = picture[:, :, 1].astype(float)
    y, x = np.mgrid[0:weight.shape[0], 0:weight.shape[1]]
    total = weight.sum()
    mx, my = (weight * x).sum() / total, (weight * y).sum() / total
    return (np.sqrt((weight * (x - mx) ** 2).sum() / total),
            np.sqrt((weight * (y - my) ** 2).sum() / total))


def bowl(uv):
    """The text of an OBJ: a shallow dome over [-1,1]^2 with smooth normals and the given uv."""
    n, lines = 32, []
    grid = [(2 * i / n - 1, 2 * j / n - 1) for j in range(n + 1) for i in range(n + 1)]
    for x, y in grid:
        z = 0.3 * (2 - x * x - y * y) / 2
        lines += [f"v {x} {y} {z}", f"vn {0.3 * x} {0.3 * y} 1", "vt {} {}".format(*uv(x, y))]
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i + 1
            quad = [a, a + 1, a + n + 2, a + n + 1]
            lines.append("f " + " ".join(f"{v}/{v}/{v}" for v in quad))
    return "\n".join(lines) + "\n"


def picture_of(uv, folder, *words):
    path = os.path.join(folder, "bowl.obj")
    with open(path, "w") as file:
        file.write(bowl(uv))
    return render(MATERIAL, "--mesh", path, *VIEW, *words)


with tempfile.TemporaryDirectory() as folder:
    straight = picture_of(lambda x, y: (x, y), folder)
    turned = picture_of(lambda x, y: (y, -x), folder)
    x, y = spread(straight)
    print(f"u along x: the highlight is {x:.2f} by {y:.2f} pixels")
    assert y > 2 * x, "grooves along x: it stretches along y"
    x, y = spread(turned)
    print(f"u along y: the highlight is {x:.2f} by {y:.2f} pixels")
    assert x > 2 * y, "turning the texture coordinates by 90 degrees turns it"
    # The dome is the same after a quarter turn, so the pictures are each other's.
    quarter = np.rot90(straight)
    report("a quarter turn", abs(quarter - turned), 1e-3 * quarter.max())
    # Scaling or mirroring v, or mirroring both, changes no direction of grooves.
    for uv in [lambda x, y: (3 * x, 0.1 * y), lambda x, y: (x, -y), lambda x, y: (-x, -y)]:
        report("same grooves", abs(picture_of(uv, folder) - straight), 1e-3 * straight.max())
    tangent = picture_of(lambda x, y: (y, -x), folder, "--show", "tangent")
    normal = picture_of(lambda x, y: (y, -x), folder, "--show", "normal")
    hit = np.any(normal != 0, -1)
    report("t is unit", abs(np.linalg.norm(tangent, axis=-1) - 1)[hit], 1e-6)
    report("t is perpendicular to n", abs(np.sum(tangent * normal, -1)), 1e-6)
    assert np.all(tangent[20:44, 20:44, 1] > 0.9), "t is along +y, the direction of u"

# The built-in sphere has its grooves along the parallels: the highlight is tall.
x, y = spread(render(MATERIAL, *VIEW))
print(f"sphere: the highlight is {x:.2f} by {y:.2f} pixels")
assert y > 2 * x
# Those of the disc are circles: two sectors shine, in the plane of the light and the viewer.
disc = render(MATERIAL, "--mesh", "disc", "--size", "65x65", "--camera",
              "perspective(eye=[0,-3,3])", "--light", "directional(direction=[0,1,1.6])")
across, along = disc[32, 8:57, 1].sum(), disc[20:45, 32, 1].sum()
print(f"disc: {along:.3f} in the plane of incidence, {across:.3f} beside it")
assert along > 3 * across
