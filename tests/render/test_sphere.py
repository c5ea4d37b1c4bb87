#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The sphere against its geometry computed here: --show normal, tangent, position, uv, wo, wi."""
import numpy as np

from pictures import render, report, unit

SIZE = (60, 40)  # width, height
# A ray may fall on either side of a silhouette that it passes this close (1 minus the squared
# distance from the centre), and up to there a rounding of the ray moves the point 30 times as far.
EDGE = 1e-3


def cross(a, b):
    return np.cross(np.broadcast_to(a, b.shape), b)


def single(values):
    """Numbers as the program reads them: rounded to float."""
    return np.array(values, np.float32).astype(float)


def rays(camera, eye, target, up, extent):
    """Origins and unit directions through the pixel centres."""
    width, height = SIZE
    eye, target, up, extent = single(eye), single(target), single(up), single(extent)
    if camera == "perspective":
        extent = single(np.radians(extent))
    forward = unit(np.subtract(target, eye))
    right = unit(np.cross(forward, up))
    above = np.cross(right, forward)
    x = (2 * (np.arange(width) + 0.5) / width - 1)[None, :, None] * width / height
    y = (1 - 2 * (np.arange(height) + 0.5) / height)[:, None, None]
    half = np.tan(extent / 2) if camera == "perspective" else extent / 2
    aside = half * (x * right + y * above)
    if camera == "perspective":
        direction = unit(forward + aside)
        return np.broadcast_to(eye, direction.shape), direction
    return eye + aside, np.broadcast_to(forward, aside.shape)


def hit(origin, direction):
    """(mask, clear of the silhouette, position, seen from outside) on the unit sphere."""
    along = -np.sum(origin * direction, -1)
    nearest = origin + along[..., None] * direction
    square = 1 - np.sum(nearest * nearest, -1)
    half = np.sqrt(np.maximum(square, 0))
    near = along - half
    t = np.where(near > 0, near, along + half)
    mask = (square > 0) & (t > 0)
    return mask, abs(square) > EDGE, origin + t[..., None] * direction, near > 0


def check(name, camera, eye, target, up, extent, lights):
    key = "fov_y_deg" if camera == "perspective" else "height"
    text = "{}(eye=[{},{},{}], target=[{},{},{}], up=[{},{},{}], {}={})".format(
        camera, *eye, *target, *up, key, extent)
    origin, direction = rays(camera, eye, target, up, extent)
    mask, clear, p, outside = hit(origin, direction)
    n = np.where(outside[..., None], p, -p)
    t = unit(cross([0.0, 1.0, 0.0], p))  # d(position)/d(phi) about y
    frame = np.stack([t, np.cross(n, t), n], -1)

    def local(w):
        return np.einsum("...i,...ij->...j", w, frame)

    expected = {
        "position": p, "normal": n, "tangent": t, "wo": local(-direction),
        "uv": np.stack([0.5 + np.arctan2(p[..., 0], p[..., 2]) / (2 * np.pi),
                        0.5 + np.arcsin(np.clip(p[..., 1], -1, 1)) / np.pi, 0 * mask], -1)}
    use = mask & clear
    assert use.sum() > 200, "the sphere fills enough of the picture"
    for what, value in expected.items():
        got = render("lambert", "--size", "{}x{}".format(*SIZE), "--camera", text, "--show", what)
        report(f"{name} {what}", abs(got - value)[use], 4e-7 * max(1, abs(value[use]).max()))
        assert np.all(got[~mask & clear] == 0), "0 where nothing is hit"
    for light, toward in lights.items():
        got = render("lambert", "--size", "{}x{}".format(*SIZE), "--camera", text, "--show", "wi",
                     "--light", light)
        report(f"{name} wi of {light}", abs(got - local(toward(p)))[use], 4e-7)


LIGHTS = {
    "directional(direction=[1, 2, 3], irradiance=2)":
        lambda p: np.broadcast_to(unit(np.array([1.0, 2.0, 3.0])), p.shape),
    "point(position=[2, -1, 3], intensity=[1, 2, 3])":
        lambda p: unit(np.array([2.0, -1.0, 3.0]) - p),
}

check("perspective", "perspective", (1.5, 2, 3), (0.1, 0, -0.2), (0, 1, 0), 40, LIGHTS)
check("rolled", "perspective", (0, -4, 1), (0, 0, 0), (1, 0.2, 1), 35, LIGHTS)
check("parallel", "parallel", (-2, 1, 3), (0, 0, 0), (0, 1, 0), 2.5, LIGHTS)
check("inside", "perspective", (0.2, 0.1, 0.3), (0, 0, -1), (0, 1, 0), 60, {})

# The default camera looks along -z and frames the bounding sphere: sin(half the angle) = 1/d.
distance = 1 / np.sin(np.radians(35) / 2)
default = render("lambert", "--size", "{}x{}".format(*SIZE), "--show", "position")
explicit = render("lambert", "--size", "{}x{}".format(*SIZE), "--show", "position", "--camera",
                  f"perspective(eye=[0,0,{distance:.9g}], target=[0,0,0])")
report("default camera", abs(default - explicit), 1e-5)
