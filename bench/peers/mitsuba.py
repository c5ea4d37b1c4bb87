#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Mitsuba 3's LLVM backend on the same kind of batch, as a server that bench/run.py asks in turns.

    python3 bench/peers/mitsuba.py NDOTL_LIBRARY

Each line of stdin is one request, answered by one line of JSON:
    names                 the comparisons
    agree NAME            largest relative difference from ndotl, and ndotl's material
    time NAME N SECONDS   evaluations per second of Mitsuba

Timed is what a caller would do: eval() of the BSDF, made to compute (dr.eval) and waited for
(dr.sync_thread), in one thread, warm, with inputs that are evaluated and resident. Of the plain
call and of one recorded with dr.freeze, which saves tracing it again, the faster counts.
Mitsuba's wi is the viewer, its value includes the cosine. DRJIT_LIBLLVM_PATH names LLVM's library:
14 is refused.
"""

import json
import os
import pathlib
import sys
import time

import numpy as np

os.environ.setdefault("DRJIT_LIBLLVM_PATH", "/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1")
# This file has the name of the package that it imports.
HERE = pathlib.Path(__file__).resolve().parent
sys.path = [path for path in sys.path if pathlib.Path(path or ".").resolve() != HERE]
sys.path.insert(0, str(HERE.parents[1] / "examples"))
import drjit as dr  # noqa: E402
import mitsuba as mi  # noqa: E402

ETA, K = [0.2, 0.92, 1.1], [3.91, 2.45, 2.14]


def rgb(values):
    return {"type": "rgb", "value": [float(v) for v in values]}


def rough(distribution, alpha, **more):
    return {
        "type": "roughconductor",
        "distribution": distribution,
        "alpha_u": alpha[0],
        "alpha_v": alpha[1],
        **more,
    }


GOLD = {"eta": rgb(ETA), "k": rgb(K)}
NDOTL_GOLD = f"eta={ETA}, k={K}".replace(" ", "")
# name: (Mitsuba's BSDF, ndotl's material, whether both are the same model)
MODELS = {
    "GGX anisotropic, F constant": (
        rough("ggx", (0.15, 0.35), material="none", specular_reflectance=rgb([0.95, 0.64, 0.54])),
        "ggx(alpha_x=0.15, alpha_y=0.35, masking=smith, fresnel=none, f0=[0.95,0.64,0.54])",
        True,
    ),
    "GGX gold": (
        rough("ggx", (0.2, 0.2), **GOLD),
        f"ggx(alpha=0.2, masking=smith, {NDOTL_GOLD})",
        True,
    ),
    "Beckmann gold": (
        rough("beckmann", (0.2, 0.2), **GOLD),
        f"beckmann(alpha=0.2, masking=smith_walter, {NDOTL_GOLD})",
        True,
    ),
    "diffuse": (
        {"type": "diffuse", "reflectance": rgb([0.8, 0.5, 0.2])},
        "lambert(color=[0.8,0.5,0.2])",
        True,
    ),
    "principled, metallic 1": (
        {
            "type": "principled",
            "base_color": rgb([0.95, 0.64, 0.54]),
            "metallic": 1.0,
            "roughness": 0.45,
            "specular": 0.5,
        },
        "metal_rough(base_color=[0.95,0.64,0.54], metalness=1, roughness=0.45)",
        False,
    ),
}


def directions(n):
    """wi, wo of shape (3, n): 90 % of the pairs have both above the horizon."""
    draw = np.random.default_rng(5)
    w = draw.normal(size=(2, 3, n))
    w /= np.linalg.norm(w, axis=1, keepdims=True)
    w[:, 2] = np.abs(w[:, 2])
    kind = draw.random(n)
    w[0, 2, kind > 0.934] *= -1
    w[1, 2, (kind > 0.9) & (kind < 0.967)] *= -1
    return w.astype(np.float32)


class Subject:
    def __init__(self, bsdf):
        self.bsdf, self.context = mi.load_dict(bsdf), mi.BSDFContext()
        self.inputs, self.frozen = {}, None

    def arrays(self, n):
        if n not in self.inputs:
            light, view = (mi.Vector3f(*(mi.Float(row) for row in w)) for w in directions(n))
            dr.eval(light, view)
            dr.sync_thread()
            self.inputs = {n: (light, view)}
        return self.inputs[n]

    def evaluate(self, light, view):
        si = dr.zeros(mi.SurfaceInteraction3f)
        si.wi = view
        return self.bsdf.eval(self.context, si, light)

    def plain(self, n):
        value = self.evaluate(*self.arrays(n))
        dr.eval(value)
        dr.sync_thread()
        return value

    def recorded(self, n):
        if self.frozen is None:

            def evaluate(bsdf, light, view):
                si = dr.zeros(mi.SurfaceInteraction3f, dr.width(view))
                si.wi = view
                return bsdf.eval(mi.BSDFContext(), si, light)

            self.frozen = dr.freeze(evaluate)
        value = self.frozen(self.bsdf, *self.arrays(n))
        dr.eval(value)
        dr.sync_thread()
        return value

    def rate(self, call, n, seconds):
        for _ in range(5):
            call(n)
        start, calls = time.perf_counter(), 0
        while time.perf_counter() - start < seconds or not calls:
            call(n)
            calls += 1
        return n * calls / (time.perf_counter() - start)

    def best_rate(self, n, seconds):
        rates = [self.rate(self.plain, n, seconds / 2)]
        try:
            rates.append(self.rate(self.recorded, n, seconds / 2))
        except Exception as error:  # a BSDF that cannot be recorded still has its plain rate
            print(f"mitsuba.py: not recorded: {error}", file=sys.stderr)
        return max(rates)


def agreement(subject, material):
    """Largest |mitsuba - ndotl| / ndotl over values above a thousandth of the median."""
    import numpy_ctypes

    light, view = directions(100000)
    want = numpy_ctypes.Material(material).brdf_soa(
        np.ascontiguousarray(light), np.ascontiguousarray(view), np.empty_like(light), cosine=True
    )
    got = np.array(subject.plain(100000))
    got = got if got.shape == want.shape else got.T
    counted = want > 1e-3 * np.median(want[want > 0])
    return float((np.abs(got - want) / np.where(counted, want, 1))[counted].max())


def main():
    os.environ["NDOTL_LIBRARY"] = sys.argv[1]
    mi.set_variant("llvm_ad_rgb")
    dr.set_thread_count(1)
    subjects = {}
    for line in sys.stdin:
        op, _, rest = line.strip().partition(" ")
        answer = None
        if op == "names":
            answer = {"names": list(MODELS), "version": mi.__version__}
        else:
            name, n, seconds = rest.rsplit(" ", 2) if op == "time" else [rest, 0, 0]
            if name not in subjects:
                subjects[name] = Subject(MODELS[name][0])
            if op == "agree":
                answer = {
                    "difference": agreement(subjects[name], MODELS[name][1]),
                    "material": MODELS[name][1],
                    "same": MODELS[name][2],
                }
            else:
                answer = {"rate": subjects[name].best_rate(int(n), float(seconds))}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
