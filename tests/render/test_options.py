#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command line of `ndotl render`: mistakes are exit 2 with their place, and leave nothing."""
import os
import tempfile

import numpy as np

from pictures import render, run

# words, what the message must contain
WRONG = [
    (["ggx(rough=0.3)"], "column 5: unknown parameter 'rough' of ggx; did you mean 'roughness'?"),
    (["--light", "sun(direction=[0,0,1])"], "--light: column 1: unknown light 'sun'"),
    (["--light", "directonal(direction=[0,0,1])"], "did you mean 'directional'?"),
    (["--light", "directional(irradiance=2)"], "directional needs 'direction'"),
    (["--light", "directional(direction=[0,0,0])"], "--light: column 23: 'direction' may not be"),
    (["--light", "directional(direction=[0,1])"], "--light: column"),
    (["--light", "directional(direction=[0,0,1], irradiance=-1)"], "column 43: 'irradiance'"),
    (["--light", "point(intensity=2)"], "point needs 'position'"),
    (["--light", "point(position=[0,0,1], decay=linear)"], "unknown decay 'linear'"),
    (["--light", "2*point(position=[0,0,1])"], "neither a sum nor weighted"),
    (["--light", "point(position=[0,0,1]) + point(position=[0,0,2])"], "neither a sum"),
    (["--camera", "fisheye"], "it is one of: perspective parallel"),
    (["--camera", "perspective(fov_y_deg=200)"], "--camera: column 23"),
    (["--camera", "perspective(eye=[0,0,1], target=[0,0,1])"], "are one point"),
    (["--camera", "perspective(eye=[0,5,0], up=[0,1,0])"], "'up' is along the view"),
    (["--camera", "parallel(height=0)"], "--camera: column 17"),
    (["--tonemap", "filmic"], "--tonemap: column 1: unknown tone map 'filmic'"),
    (["--tonemap", "clamp(k=2)"], "unknown parameter 'k' of clamp"),
    (["--tonemap", "exponential(k=0)"], "--tonemap: column 15"),
    (["--background", "[1, 2]"], "--background: column 6"),
    (["--background", "#12345"], "--background: column 1"),
    (["--background", "blue"], "--background: column 1"),
    (["--size", "40"], "--size: '40' is not a size"),
    (["--size", "0x3"], "--size"),
    (["--spp", "0"], "--spp: 0 is out of range"),
    (["--spp", "auto=0.01"], "--spp"),
    (["--threads", "none"], "--threads"),
    (["--show", "wx"], "--show: unknown word 'wx'; use one of: wi wo normal"),
    (["--show", "D", "lambert"], "--show: there is no term D"),
    (["--material", "lambert"], "is not NAME=EXPR"),
    (["--material", "sphere=lambrt"], "--material: column 1: "),
    (["--material", "ball=lambert"], "no mesh or material is called 'ball'; there are: sphere"),
    (["--integrator", "path"], "--integrator: this version has no path tracing"),
    (["--env", "white"], "--env: "),
    (["--max-depth", "3"], "--max-depth: unknown option"),
    (["--shadow"], "--shadow: unknown option; did you mean '--shadows'?"),
    (["lambert", "lambert"], "unexpected"),
]

with tempfile.TemporaryDirectory() as folder:
    for words, text in WRONG:
        done = run("render", *words, "-o", folder + "/x.png")
        assert done.returncode == 2, f"{words}: exit {done.returncode}\n{done.stderr}"
        assert text in done.stderr, f"{words}: {done.stderr} lacks: {text}"
        assert done.stdout == "" and os.listdir(folder) == []
    for words, text in [([], "-o: missing"), (["-o", "x.jpg"], "neither .png nor .exr"),
                        (["-o", ".png"], "neither")]:
        done = run("render", "lambert", *words, cwd=folder)
        assert done.returncode == 2 and text in done.stderr, done.stderr
        assert os.listdir(folder) == []

    done = run("render", "--stats", "--size", "8x8", "-o", folder + "/x.png")
    assert done.returncode == 0 and "64 rays" in done.stderr, done.stderr
    help_text = run("render", "--help").stdout
    assert "--env" not in help_text and "--max-depth" not in help_text, "not in this version"

# Looking straight down works while no `up` is given: -z is up.
down = render("lambert", "--size", "9x9", "--camera", "perspective(eye=[0,5,0])", "--show",
              "position")
assert down[2, 4, 2] < -0.5 < 0.5 < down[6, 4, 2] and down[4, 4, 1] > 0.99

# Parts of the shader ball.
two = render("lambert(color=0)", "--material", "stand=lambert(color=1)", "--mesh", "shaderball",
             "--size", "40x40")
assert two[38 // 2].max() == 0 and two[33:].max() > 0, "only the stand is white"

# Shadows: the groove's lip throws one; without them nothing changes but there.
words = ["lambert", "--mesh", "shaderball", "--size", "120x120", "--light",
         "directional(direction=[0,4,1], irradiance=3)"]
lit, shadowed = render(*words), render(*words, "--shadows")
assert np.all(shadowed <= lit)
dark = (shadowed == 0) & (lit > 0)
share = dark.sum() / (lit > 0).sum()
print(f"{100 * share:.1f} % of the lit pixels are in shadow")
assert 0.02 < share < 0.4 and np.array_equal(shadowed[~dark], lit[~dark])
sphere = ["lambert", "--size", "50x50", "--light", "point(position=[2,2,2], intensity=9)"]
assert np.array_equal(render(*sphere), render(*sphere, "--shadows")), "no acne on a sphere"
