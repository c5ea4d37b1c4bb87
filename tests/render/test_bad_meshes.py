#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bad mesh files: exit 1, one line that names the file, no output file; and good ones."""
import json
import os
import random
import struct
import tempfile

import numpy as np

from pictures import render, report, run

TRIANGLE = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n"


def glb(document, binary=b""):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    body = struct.pack("<II", len(text), 0x4e4f534a) + text
    if binary:
        body += struct.pack("<II", len(binary), 0x004e4942) + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def quad_glb(node, materials=(), **primitive):
    """A unit square in the plane z = 0 as GLB, without texture coordinates."""
    position = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], "<f4")
    normal = np.array([[0, 0, 1]] * 4, "<f4")
    index = np.array([0, 1, 2, 0, 2, 3], "<u2")
    binary = position.tobytes() + normal.tobytes() + index.tobytes()
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [dict(mesh=0, name="node", **node)], "buffers": [{"byteLength": len(binary)}],
        "meshes": [{"name": "square", "primitives": [dict(
            attributes={"POSITION": 0, "NORMAL": 1}, indices=2, **primitive)]}],
        "materials": list(materials) or [{"name": "plain"}],
        "bufferViews": [{"buffer": 0, "byteOffset": a, "byteLength": n}
                        for a, n in [(0, 48), (48, 48), (96, 12)]],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
             "min": [-1, -1, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}]}
    return glb(document, binary)


def degenerate(count):
    """An OBJ of `count` vertices whose triangles have no area."""
    yield from (f"v {i % 1000} 0 0\n" for i in range(count))
    yield from (f"f {i} {i + 1} {i + 2}\n" for i in range(1, count - 2, 3))


random.seed(7)
GARBAGE = bytes(random.randrange(256) for _ in range(20000))
BAD = {
    "empty.obj": b"",
    "no_faces.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\n",
    "garbage.obj": GARBAGE,
    "garbage.glb": GARBAGE,
    "garbage.ply": GARBAGE,
    "garbage.xyz": GARBAGE,
    "head.glb": b"glTF" + GARBAGE,
    "truncated.glb": quad_glb({})[:-60],
    "text.glb": b"this is no mesh\n",
    "missing_buffer.gltf": json.dumps({"asset": {"version": "2.0"}, "buffers": [
        {"uri": "nowhere.bin", "byteLength": 9}]}).encode(),
    "nan.obj": b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "huge.obj": b"v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "line.obj": b"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n",
    "index.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n",
    "million.obj": "".join(degenerate(1000000)).encode(),
}


def check_bad(folder, name):
    output = os.path.join(folder, "out", "picture.png")
    path = os.path.join(folder, name)
    done = run("render", "lambert", "--mesh", path, "-o", output)
    assert done.returncode == 1, f"{name}: exit {done.returncode}\n{done.stderr}"
    lines = done.stderr.splitlines()
    assert len(lines) == 1 and lines[0].startswith("ndotl render: "), done.stderr
    assert name in lines[0], f"{lines[0]} does not name {name}"
    assert done.stdout == "" and os.listdir(os.path.join(folder, "out")) == []
    print(lines[0].replace(folder, ""))


with tempfile.TemporaryDirectory() as folder:
    os.mkdir(os.path.join(folder, "out"))
    os.mkdir(os.path.join(folder, "folder.obj"))
    for name, data in BAD.items():
        with open(os.path.join(folder, name), "wb") as file:
            file.write(data)
        check_bad(folder, name)
    for name in ["missing.obj", "folder.obj"]:
        check_bad(folder, name)

    # What is odd but whole renders: nothing but a triangle; degenerate ones beside a good one.
    for name, text in [("bare.obj", TRIANGLE), ("some.obj", TRIANGLE + "f 1 1 2\nf 2 2 2\n")]:
        path = os.path.join(folder, name)
        with open(path, "w") as file:
            file.write(text)
        normal = render("lambert", "--mesh", path, "--size", "16x16", "--show", "normal")
        tangent = render("lambert", "--mesh", path, "--size", "16x16", "--show", "tangent")
        assert np.all(normal[8, 8] == [0, 0, 1]), "a facet normal where the file has none"
        assert np.all(tangent[8, 8] == [1, 0, 0]), "y x n without texture coordinates"

    # Node transforms: scaled, turned 90 degrees about y, moved; positions are the scene's.
    turn = {"translation": [1, 2, 3], "rotation": [0, 0.5 ** 0.5, 0, 0.5 ** 0.5],
            "scale": [2, 1, 1]}
    path = os.path.join(folder, "square.glb")
    with open(path, "wb") as file:
        file.write(quad_glb(turn))
    view = ["--mesh", path, "--size", "20x20", "--camera",
            "parallel(eye=[9,2,3], target=[1,2,3], height=5)"]
    position = render(*view, "--show", "position")
    report("node transform", abs(position[10, 10] - [1, 2 - 0.125, 3 - 0.125]), 1e-6)
    report("normal matrix", abs(render(*view, "--show", "normal")[10, 10] - [1, 0, 0]), 1e-6)
    assert np.sum(np.any(position != 0, -1)) == 8 * 16, "2 wide, 4 long after the scale"

    # A file's own glTF factors; the names of its mesh, node and material.
    material = {"name": "paint", "pbrMetallicRoughness": {
        "baseColorFactor": [0.5, 0.25, 0.125, 1], "metallicFactor": 0.5, "roughnessFactor": 0.75}}
    with open(path, "wb") as file:
        file.write(quad_glb({}, [material], material=0))
    view = ["--mesh", path, "--size", "9x9"]
    own = render(*view)
    same = render("metal_rough(base_color=[0.5,0.25,0.125], metalness=0.5, roughness=0.75)", *view)
    assert np.array_equal(own, same), "metal_rough with the file's factors"
    red = render("lambert(color=[1,0,0])", *view)
    for name in ["square", "node", "paint"]:
        assert np.array_equal(render(*view, "--material", name + "=lambert(color=[1,0,0])"), red)
    done = run("render", *view, "--material", "pant=lambert", "-o", os.path.join(folder, "x.png"))
    assert done.returncode == 2 and "square, node, paint" in done.stderr, done.stderr

    # Seen from behind a surface is turned to the viewer.
    back = render("lambert", *view, "--camera", "perspective(eye=[0,0,-4])", "--show", "normal")
    assert np.all(back[4, 4] == [0, 0, -1])
