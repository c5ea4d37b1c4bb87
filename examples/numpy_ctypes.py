#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Evaluates materials on NumPy arrays through the C interface of libndotl, by ctypes alone.

    NDOTL_LIBRARY=build/release/libndotl.so python3 examples/numpy_ctypes.py

Directions are arrays of shape (N, 3) or (3,), values of shape (N, 3); n = (0, 0, 1) is the normal.
The C functions take one array per component, so (N, 3) arrays are copied once into that form;
arrays of shape (3, N) that the caller keeps (`Material.brdf_soa`) are used as they are.
"""

import ctypes
import ctypes.util
import os

import numpy as np

FLOATS = ctypes.POINTER(ctypes.c_float)


class Error(ctypes.Structure):
    """ndl_error"""

    _fields_ = [("code", ctypes.c_int), ("column", ctypes.c_int), ("text", ctypes.c_char * 256)]


class Vectors(ctypes.Structure):
    """ndl_vec3_n and ndl_rgb_n: a pointer to n floats for each component."""

    _fields_ = [("x", FLOATS), ("y", FLOATS), ("z", FLOATS)]


class Lane(ctypes.Structure):
    """ndl_lanes: one parameter for each pair."""

    _fields_ = [("key", ctypes.c_char_p), ("values", FLOATS)]


def load():
    """libndotl, from NDOTL_LIBRARY or where the system keeps its libraries."""
    path = os.environ.get("NDOTL_LIBRARY") or ctypes.util.find_library("ndotl")
    if not path:
        raise OSError("libndotl is not installed; name it in NDOTL_LIBRARY")
    library = ctypes.CDLL(path)
    batch = [ctypes.c_void_p, ctypes.c_size_t, Vectors, Vectors, Vectors]
    lanes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.POINTER(Lane)] + batch[1:]
    for name, result, arguments in [
        ("ndl_material_parse", ctypes.c_void_p, [ctypes.c_char_p, ctypes.POINTER(Error)]),
        ("ndl_material_free", None, [ctypes.c_void_p]),
        ("ndl_material_text", ctypes.c_char_p, [ctypes.c_void_p]),
        ("ndl_lanes_check", ctypes.c_int, lanes[:3] + [ctypes.POINTER(Error)]),
        ("ndl_brdf_n", None, batch),
        ("ndl_brdf_cos_n", None, batch),
        ("ndl_brdf_lanes_n", None, lanes),
        ("ndl_brdf_cos_lanes_n", None, lanes),
    ]:
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


def pointer(array):
    return array.ctypes.data_as(FLOATS)


def soa(array):
    """The Vectors of a contiguous float32 array of shape (3, N); the array must outlive them."""
    if (
        array.dtype != np.float32
        or array.ndim != 2
        or len(array) != 3
        or not array.flags.c_contiguous
    ):
        raise ValueError("expected a C-contiguous float32 array of shape (3, N)")
    return Vectors(*(pointer(row) for row in array))


class Material:
    """A material made from text, such as "ggx(preset=gold, roughness=0.3)"."""

    library = None

    def __init__(self, text):
        if Material.library is None:
            Material.library = load()
        error = Error()
        self.handle = self.library.ndl_material_parse(text.encode(), ctypes.byref(error))
        if not self.handle:
            raise ValueError(f"column {error.column}: {error.text.decode()}")

    def __del__(self):
        if getattr(self, "handle", None):
            self.library.ndl_material_free(self.handle)

    def __str__(self):
        return self.library.ndl_material_text(self.handle).decode()

    def brdf_soa(self, wi, wo, out, cosine=False, **lanes):
        """f_r in 1/sr, times wi.z with `cosine`, of arrays of shape (3, N), written to `out`.
        lanes: parameters by their keys, one value for each pair, as in roughness=array."""
        n = wi.shape[1]
        if not n == wo.shape[1] == out.shape[1]:
            raise ValueError("arrays of different lengths")
        kept = {
            key: np.ascontiguousarray(np.broadcast_to(value, n), dtype=np.float32)
            for key, value in lanes.items()
        }
        table = (Lane * len(kept))(*(Lane(key.encode(), pointer(v)) for key, v in kept.items()))
        error = Error()
        if self.library.ndl_lanes_check(self.handle, len(kept), table, ctypes.byref(error)):
            raise ValueError(error.text.decode())
        batch = (n, soa(wi), soa(wo), soa(out))
        if kept:
            call = self.library.ndl_brdf_cos_lanes_n if cosine else self.library.ndl_brdf_lanes_n
            call(self.handle, len(kept), table, *batch)
        else:
            call = self.library.ndl_brdf_cos_n if cosine else self.library.ndl_brdf_n
            call(self.handle, *batch)
        return out

    def brdf(self, wi, wo, cosine=False, **lanes):
        """The same for unit vectors of shape (N, 3) or (3,), broadcast; returns (N, 3)."""
        wi, wo = np.broadcast_arrays(np.atleast_2d(wi), np.atleast_2d(wo))
        wi, wo = (np.ascontiguousarray(w.T, dtype=np.float32) for w in (wi, wo))
        return self.brdf_soa(wi, wo, np.empty_like(wi), cosine, **lanes).T


def main():
    theta = np.radians(np.linspace(-80, 80, 9))
    wi = np.stack([np.sin(theta), 0 * theta, np.cos(theta)], axis=1)
    wo = np.array([np.sin(np.radians(-30)), 0, np.cos(np.radians(-30))])
    gold = Material("ggx(preset=gold, roughness=0.4)")
    print(gold)
    for degrees, rgb in zip(np.degrees(theta), gold.brdf(wi, wo)):
        print(f"theta_i {degrees:6.1f}  " + "  ".join(f"{x:.6f}" for x in rgb))
    rough = gold.brdf(wi, wo, roughness=np.linspace(0.2, 0.8, len(wi)))
    print("with a roughness from 0.2 to 0.8:", rough[:, 0])


if __name__ == "__main__":
    main()
