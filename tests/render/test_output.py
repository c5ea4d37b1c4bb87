#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures as files: encoding and tone maps of PNG, what --show becomes; whole or not at all."""
import os
import resource
import signal
import subprocess
import tempfile
import time

import numpy as np

from pictures import NDOTL, read_png, render, report, run

MATERIAL = "ggx(preset=gold, roughness=0.4)"
VIEW = [MATERIAL, "--size", "40x30", "--light",
        "directional(direction=[1,1,2], irradiance=9)", "--background", "[0.18, 0, 0.5]"]


def encode(x):
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.maximum(x, 1e-9) ** (1 / 2.4) - 0.055)


def aces(x):
    return np.minimum(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1)


MAPS = {
    "clamp": lambda x: np.minimum(x, 1),
    "reinhard": lambda x: x / (1 + x),
    "reinhard_extended": lambda x: np.minimum(x * (1 + x / 16) / (1 + x), 1),
    "reinhard_extended(white=2)": lambda x: np.minimum(x * (1 + x / 4) / (1 + x), 1),
    "exponential": lambda x: 1 - np.exp(-x),
    "exponential(k=3)": lambda x: 1 - np.exp(-3 * x),
    "aces": aces,
}


def check_png(name, got, want):
    """Bytes rounded to nearest: half a step, and what single precision adds to it."""
    report(name, abs(got.astype(float) - 255 * want), 0.5 + 1e-4)


linear = render(*VIEW).astype(float)
assert linear.max() > 2, "the highlight is beyond white"
for name, curve in MAPS.items():
    for ev in [0, -1.5]:
        png, chunks = render(*VIEW, "--tonemap", name, "--exposure", ev, kind="png")
        check_png(f"{name} at {ev} EV", png, encode(curve(linear * 2.0 ** ev)))
assert chunks.index(b"sRGB") < chunks.index(b"IDAT")

scan = VIEW + ["--convention", "scanline"]
png, _ = render(*scan, "--tonemap", "exponential", kind="png")
check_png("scanline is clamped first", png,
          encode(1 - np.exp(-np.minimum(render(*scan).astype(float), 1))))

for what in ["wi", "wo", "normal", "tangent"]:
    png, _ = render(*VIEW, "--show", what, kind="png")
    check_png(what, png, 0.5 + 0.5 * render(*VIEW, "--show", what).astype(float))
for what in ["uv", "F", "G", "albedo"]:
    png, _ = render(*VIEW, "--show", what, kind="png")
    check_png(what, png, np.clip(render(*VIEW, "--show", what).astype(float), 0, 1))
for what in ["D", "V"]:
    values = render(*VIEW, "--show", what).astype(float)
    check_png(what, render(*VIEW, "--show", what, kind="png")[0], values / values.max())
values = render(*VIEW, "--show", "position").astype(float)
low, high = values.min((0, 1)), values.max((0, 1))
check_png("position", render(*VIEW, "--show", "position", kind="png")[0],
          (values - low) / (high - low))


def expect_failure(folder, path, **options):
    before = sorted(os.listdir(folder))
    done = run("render", *VIEW, "-o", path, **options)
    assert done.returncode == 1 and done.stdout == "", (done.returncode, done.stderr)
    assert os.path.basename(path) in done.stderr, done.stderr
    assert sorted(os.listdir(folder)) == before, "nothing is left"
    print(done.stderr.strip().replace(folder, ""))


def limit_files():
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))


with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "picture.png")
    for out in ["picture.png", "picture.exr"]:
        expect_failure(folder, os.path.join(folder, "missing", out))
        expect_failure(folder, os.path.join(folder, out), preexec_fn=limit_files)
    # An old picture survives what fails, and gives way to what succeeds.
    with open(path, "wb") as file:
        file.write(b"old")
    expect_failure(folder, path, preexec_fn=limit_files)
    assert open(path, "rb").read() == b"old"
    assert run("render", *VIEW, "-o", path).returncode == 0 and read_png(path)
    os.mkdir(os.path.join(folder, "folder.png"))
    expect_failure(folder, os.path.join(folder, "folder.png"))
    if os.path.exists("/dev/full"):
        os.symlink("/dev/full", os.path.join(folder, "full.png"))
        expect_failure(folder, os.path.join(folder, "full.png"))
        assert os.path.islink(os.path.join(folder, "full.png"))

with tempfile.TemporaryDirectory() as folder:
    for delay, how in [(0.3, signal.SIGINT), (0.5, signal.SIGTERM)]:
        process = subprocess.Popen([NDOTL, "render", MATERIAL, "--mesh", "shaderball", "--size",
                                    "800x800", "--spp", "20000", "-o", folder + "/x.png"],
                                   stderr=subprocess.PIPE, text=True)
        time.sleep(delay)
        process.send_signal(how)
        started = time.monotonic()
        _, text = process.communicate(timeout=60)
        assert process.returncode == 1 and "interrupted" in text, (process.returncode, text)
        assert "\r" not in text, "no progress bar without a terminal"
        assert os.listdir(folder) == [], "an interrupted run leaves nothing"
        print(f"stopped {time.monotonic() - started:.2f} s after the signal")
