#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Real mesh files in gold under a directional and a point light, pixel by pixel against eval."""
import os
import sys

import numpy as np

from pictures import evaluate, render, report

FOLDER = os.environ.get("NDOTL_TEST_DATA")
if not FOLDER:
    print("skipped: NDOTL_TEST_DATA is not set")
    sys.exit(77)

GOLD = "ggx(preset=gold, roughness=0.3)"
SUN = "directional(direction=[-1, 2, 3], irradiance=[3, 2, 1])"


def check(name):
    mesh = ["--mesh", os.path.join(FOLDER, "mesh", name), "--size", "64x48"]

    def shown(what, *words):
        return render(GOLD, *mesh, "--show", what, *words)

    position = shown("position").astype(float)
    hit = np.any(shown("wo") != 0, -1)
    assert hit.sum() > 300, f"{name} fills enough of the picture"
    centre = (position[hit].min(0) + position[hit].max(0)) / 2
    size = np.ptp(position[hit], axis=0).max()
    at = np.float32(centre + size * np.array([1.5, 2, 2.5])).astype(float)
    lamp = "point(position=[{:.9g},{:.9g},{:.9g}], intensity=[9,8,7])".format(*at)
    wo, total = shown("wo")[hit], 0
    for light, power in [(SUN, np.array([3.0, 2.0, 1.0])), (lamp, np.array([9.0, 8.0, 7.0]))]:
        wi = shown("wi", "--light", light)[hit]
        if light == lamp:
            power = power / np.sum((at - position[hit]) ** 2, -1, keepdims=True)
        total = total + evaluate(GOLD, wi, wo) * power
    got = render(GOLD, *mesh, "--light", SUN, "--light", lamp)
    assert np.all(got[~hit] == 0)
    report(name, abs(got[hit] - total) / np.maximum(abs(total), 1e-3), 1e-5)

    normal, tangent = shown("normal")[hit], shown("tangent")[hit]
    report(f"{name}: n is unit", abs(np.linalg.norm(normal, axis=-1) - 1), 1e-6)
    report(f"{name}: t is unit", abs(np.linalg.norm(tangent, axis=-1) - 1), 1e-6)
    report(f"{name}: t is perpendicular to n", abs(np.sum(normal * tangent, -1)), 1e-6)
    assert np.mean(wo[:, 2] > 0) > 0.97, "nearly all of what is seen faces the viewer"


for one in ["teapot.obj", "shaderball.glb", "boombox.glb"]:
    check(one)
