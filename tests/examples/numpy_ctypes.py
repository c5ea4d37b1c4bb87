#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""examples/numpy_ctypes.py gives the numbers of `ndotl eval`, for all its shapes of arrays."""

import os
import pathlib
import subprocess
import sys

TREE = pathlib.Path(os.environ["NDOTL_SOURCE"])
LIBRARY = pathlib.Path(os.environ["NDOTL_BUILD"]) / "libndotl.so"
os.environ["NDOTL_LIBRARY"] = str(LIBRARY)
sys.path[:0] = [str(TREE / "examples"), str(TREE / "tests/cli")]
try:
    import numpy as np
except ImportError:
    print("skipped: numpy is missing; install python3-numpy")
    sys.exit(77)
# This test has the example's name, which must not be found twice.
sys.path = [
    path
    for path in sys.path
    if pathlib.Path(path or ".").resolve() != pathlib.Path(__file__).parent
]
from cli import main, ok  # noqa: E402
import numpy_ctypes as example  # noqa: E402

GOLD = "ggx(preset=gold, alpha_x=0.1, alpha_y=0.4)"


def directions(n, seed):
    w = np.random.default_rng(seed).normal(size=(n, 3))
    return (w / np.linalg.norm(w, axis=1, keepdims=True)).astype(np.float32)


def by_command(material, wi, wo, *options):
    pairs = np.concatenate([wi, wo], axis=1, dtype="<f4").tobytes()
    out = ok("eval", material, "--binary", "f32", *options, stdin=pairs).out
    return np.frombuffer(out, "<f4").reshape(-1, 3)


def test_a_batch_has_the_values_of_the_command():
    wi, wo = directions(5000, 1), directions(5000, 2)
    for cosine, options in (False, []), (True, ["--cos"]):
        got = example.Material(GOLD).brdf(wi, wo, cosine=cosine)
        want = by_command(GOLD, wi, wo, *options)
        assert got.shape == (5000, 3) and got.dtype == np.float32
        # The command normalises again, which moves a direction by half an ulp.
        assert np.allclose(got, want, rtol=2e-4, atol=1e-7), np.abs(got - want).max()
        assert (want > 0).sum() > 3000


def test_one_direction_is_broadcast():
    wi, wo = directions(100, 3), np.array([0.0, 0.6, 0.8])
    gold = example.Material(GOLD)
    assert np.array_equal(gold.brdf(wi, wo), gold.brdf(wi, np.tile(wo, (100, 1))))
    assert gold.brdf([0, 0, 1], wo).shape == (1, 3)


def test_parameters_may_differ_from_pair_to_pair():
    wi, wo = directions(64, 4), directions(64, 5)
    alpha = np.linspace(0.05, 1, 64, dtype=np.float32)
    got = example.Material("ggx").brdf(wi, wo, alpha=alpha)
    for i in 0, 31, 63:
        alone = example.Material(f"ggx(alpha={alpha[i]:.9g})").brdf(wi[i], wo[i])
        assert np.array_equal(got[i : i + 1], alone), (i, got[i], alone)


def test_soa_arrays_are_used_as_they_are():
    wi, wo = (np.ascontiguousarray(directions(33, seed).T) for seed in (6, 7))
    out = np.zeros_like(wi)
    gold = example.Material(GOLD)
    assert gold.brdf_soa(wi, wo, out) is out
    assert np.array_equal(out.T, gold.brdf(wi.T, wo.T))


def test_mistakes_become_exceptions():
    for call, says in [
        (lambda: example.Material("ggx(rough=1)"), "column 5"),
        (lambda: example.Material(GOLD).brdf([0, 0, 1], [0, 0, 1], f0=1), "f0"),
        (lambda: example.Material(GOLD).brdf_soa(*[np.zeros((3, 4))] * 3), "float32"),
    ]:
        try:
            call()
            raise AssertionError(f"accepted; expected {says}")
        except ValueError as error:
            assert says in str(error), error


def test_the_example_runs_as_a_program():
    text = subprocess.run(
        [sys.executable, TREE / "examples/numpy_ctypes.py"],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    assert text.startswith("ggx(") and "theta_i    0.0" in text and "roughness" in text, text


if __name__ == "__main__":
    main(globals())
