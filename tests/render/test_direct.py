#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every pixel of `direct` is `ndotl eval --cos` of the directions that --show prints, times the
light; with several lights the sum; with several samples the mean."""
import os
import tempfile

import numpy as np

from pictures import evaluate, read_exr, render, report, run

SIZE = ["--size", "48x36"]
MATERIALS = [
    "lambert(color=[0.8, 0.5, 0.2])",
    "ggx(preset=gold, roughness=0.3)",
    "ggx(alpha_x=0.05, alpha_y=0.5, f0=[1, 0.7, 0.3])",
    "metal_rough(base_color=[0.2, 0.4, 0.9], metalness=0.3, roughness=0.4)",
]
SUN = "directional(direction=[1, 2, 3], irradiance=[2, 3, 4])"
LAMP = "point(position=[1.5, 2, 2.5], intensity=[5, 6, 7])"
FLAT = "point(position=[1.5, 2, 2.5], intensity=[5, 6, 7], decay=none)"


def irradiance(light, position):
    if light == SUN:
        return np.broadcast_to(np.array([2.0, 3.0, 4.0]), position.shape)
    square = np.sum((np.array([1.5, 2.0, 2.5]) - position) ** 2, -1, keepdims=True)
    return np.array([5.0, 6.0, 7.0]) / (square if light == LAMP else 1.0)


def shown(what, *words):
    return render(*words, *SIZE, "--show", what).reshape(-1, 3)


def expected(material, lights, words, *convention):
    """The sum over the lights, from eval; and which pixels are hit."""
    wo = shown("wo", material, *words)
    position = shown("position", material, *words).astype(float)
    hit = np.any(wo != 0, 1)
    total = np.zeros((len(wo), 3))
    for light in lights:
        wi = shown("wi", material, *words, "--light", light)
        total[hit] += (evaluate(material, wi[hit], wo[hit], *convention)
                       * irradiance(light, position[hit]))
    return total, hit


def check(material, lights, *words):
    total, hit = expected(material, lights, words)
    lit = [word for light in lights for word in ("--light", light)]
    got = render(material, *words, *SIZE, *lit).reshape(-1, 3)
    assert hit.sum() > 100
    report(f"{material} under {len(lights)} lights {words}",
           abs(got - total) / np.maximum(abs(total), 1e-3), 1e-5)
    return got, total


for one in MATERIALS:
    check(one, [SUN])
check(MATERIALS[1], [LAMP])
check(MATERIALS[1], [FLAT])
check(MATERIALS[2], [SUN, LAMP], "--mesh", "disc")
check(MATERIALS[2], [SUN, LAMP], "--mesh", "plane", "--camera",
      "perspective(eye=[1,-2,2], target=[0,0,0])")
got, total = check(MATERIALS[1], [SUN, LAMP], "--mesh", "shaderball")
assert np.max(abs(1.01 * got - total) / np.maximum(abs(total), 1e-3)) > 1e-5, \
    "a picture that is 1 % brighter is noticed"

# The lecture's convention.
sum_of, hit = expected(MATERIALS[0], [SUN, LAMP], [], "--convention", "scanline")
got = render(MATERIALS[0], *SIZE, "--light", SUN, "--light", LAMP, "--convention", "scanline")
report("scanline", abs(got.reshape(-1, 3) - sum_of) / np.maximum(sum_of, 1e-3), 1e-5)
plain, _ = expected(MATERIALS[0], [SUN, LAMP], [])
assert np.allclose(sum_of, np.pi * plain, rtol=1e-5), "pi times brdf_cos for lambert"

# A term at wi of the first light.
wo, wi = shown("wo", MATERIALS[1]), shown("wi", MATERIALS[1], "--light", SUN)
hit = np.any(wo != 0, 1)
for term in "DGVF":
    got = shown(term, MATERIALS[1], "--light", SUN)
    want = np.broadcast_to(evaluate(MATERIALS[1], wi[hit], wo[hit], "--term", term),
                           (hit.sum(), 3))
    report(f"--show {term}", abs(got[hit] - want) / np.maximum(abs(want), 1e-3), 1e-5)

# At the light itself nothing arrives; it sits in the middle of the plane.
got = render("lambert", "--mesh", "plane", "--size", "3x3", "--light",
             "point(position=[0,0,0], intensity=1)")
assert np.all(got[1, 1] == 0) and np.all(np.isfinite(got)), got

# A light behind the surface gives exactly 0, and the background is where nothing is hit.
got = render("lambert", *SIZE, "--light", "directional(direction=[0,0,-1])", "--background",
             "[0.25, 0.5, 1]")
assert np.all(got[0, 0] == [0.25, 0.5, 1]) and np.all(got[18, 24] == 0)

# Many samples: the mean over the pixel, near one sample where the picture is smooth.
one, many = render("lambert", *SIZE), render("lambert", *SIZE, "--spp", "64")
again = render("lambert", *SIZE, "--spp", "64", "--seed", "1")
report("64 samples in the middle", abs(one - many)[14:22, 18:30] / one[14:22, 18:30], 0.03)
assert np.any(many != again), "the seed places the samples"

# The bits do not depend on the threads.
with tempfile.TemporaryDirectory() as folder:
    files = []
    for threads in ["1", "2", "3", "16"]:
        path = os.path.join(folder, threads + ".exr")
        done = run("render", MATERIALS[1], "--mesh", "shaderball", "--size", "150x130", "--spp",
                   "3", "--shadows", "--threads", threads, "-o", path)
        assert done.returncode == 0, done.stderr
        files.append(open(path, "rb").read())
    assert files.count(files[0]) == 4, "the same bytes for any number of threads"
    assert np.all(np.isfinite(read_exr(path)))
