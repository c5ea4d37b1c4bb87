# SPDX-License-Identifier: Apache-2.0
"""Readers of PNG and EXR that share nothing with the program, and runs of `ndotl`."""
import os
import struct
import subprocess
import sys
import tempfile
import zlib

try:
    import numpy as np
except ImportError:
    print("skipped: this Python has no numpy (Debian: python3-numpy)")
    sys.exit(77)

NDOTL = os.environ["NDOTL_BIN"]


def attributes(data):
    """The attributes of an EXR header, and where it ends."""
    magic, version = struct.unpack("<II", data[:8])
    assert magic == 20000630 and version & 0x1e00 == 0, "a single-part scan-line EXR"
    found, at = {}, 8
    while data[at]:
        name_end = data.index(0, at)
        type_end = data.index(0, name_end + 1)
        size = struct.unpack("<i", data[type_end + 1:type_end + 5])[0]
        found[data[at:name_end].decode()] = data[type_end + 5:type_end + 5 + size]
        at = type_end + 5 + size
    return found, at + 1


def unzip(block, size):
    """One ZIP block of EXR: deflate, then differences, then even and odd bytes apart."""
    if len(block) == size:
        return block
    raw = np.frombuffer(zlib.decompress(block), np.uint8).astype(np.int64)
    raw[1:] -= 128
    summed = (np.cumsum(raw) & 255).astype(np.uint8)
    out = np.empty(size, np.uint8)
    half = (size + 1) // 2
    out[0::2], out[1::2] = summed[:half], summed[half:]
    return out.tobytes()


def read_exr(path):
    """An EXR of `ndotl` as an array of height x width x 3 float32."""
    data = open(path, "rb").read()
    head, at = attributes(data)
    x0, y0, x1, y1 = struct.unpack("<4i", head["dataWindow"])
    width, height, lines = x1 - x0 + 1, y1 - y0 + 1, {0: 1, 3: 16}[head["compression"][0]]
    names = [entry[:1] for entry in head["channels"].replace(b"\0\0\0\0", b"\0").split(b"\0")]
    assert [name for name in names if name in (b"B", b"G", b"R")] == [b"B", b"G", b"R"]
    picture = np.empty((height, 3, width), np.float32)
    blocks = (height + lines - 1) // lines
    for offset in struct.unpack(f"<{blocks}Q", data[at:at + 8 * blocks]):
        y, size = struct.unpack("<ii", data[offset:offset + 8])
        rows = min(lines, y1 + 1 - y)
        raw = unzip(data[offset + 8:offset + 8 + size], rows * 3 * width * 4)
        picture[y - y0:y - y0 + rows] = np.frombuffer(raw, "<f4").reshape(rows, 3, width)
    return np.ascontiguousarray(picture[:, ::-1].transpose(0, 2, 1))


def read_png(path):
    """(height x width x 3 bytes, the names of its chunks) of an 8-bit RGB PNG."""
    data = open(path, "rb").read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "a PNG"
    at, chunks = 8, []
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        assert zlib.crc32(kind + body) == struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0]
        chunks.append((kind, body))
        at += 12 + size
    assert chunks[-1][0] == b"IEND", "whole"
    width, height, depth, kind, _, _, lace = struct.unpack(">IIBBBBB", chunks[0][1])
    assert (depth, kind, lace) == (8, 2, 0)
    raw = zlib.decompress(b"".join(body for name, body in chunks if name == b"IDAT"))
    rows = np.frombuffer(raw, np.uint8).reshape(height, 3 * width + 1).astype(np.int64)
    picture = np.zeros((height, 3 * width), np.int64)
    above = np.zeros(3 * width, np.int64)
    for y in range(height):
        picture[y] = above = unfilter(rows[y, 0], rows[y, 1:], above)
    return picture.astype(np.uint8).reshape(height, width, 3), [name for name, _ in chunks]


def unfilter(kind, row, above):
    if kind == 0:
        return row
    if kind == 2:
        return (row + above) & 255
    out = [0, 0, 0]
    corner = [0, 0, 0] + list(above)
    for i, value in enumerate(row):
        a, b, c = out[i], corner[i + 3], corner[i]
        if kind == 1:
            guess = a
        elif kind == 3:
            guess = (a + b) // 2
        else:
            p, q, r = abs(b - c), abs(a - c), abs(a + b - 2 * c)
            guess = a if p <= q and p <= r else b if q <= r else c
        out.append((value + guess) & 255)
    return np.array(out[3:], np.int64)


def run(*words, **options):
    """Runs ndotl; the finished process with its text."""
    return subprocess.run([NDOTL, *map(str, words)], capture_output=True, text=True, timeout=120,
                          **options)


def render(*words, kind="exr"):
    """The picture that `ndotl render WORDS` makes."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "picture." + kind)
        done = run("render", *words, "-o", path)
        assert done.returncode == 0, f"ndotl render {' '.join(map(str, words))}\n{done.stderr}"
        assert done.stdout == "" and os.listdir(folder) == ["picture." + kind], "one file only"
        return read_exr(path) if kind == "exr" else read_png(path)


def evaluate(material, wi, wo, *words):
    """`ndotl eval --cos` of rows of directions."""
    rows = np.concatenate([wi, wo], axis=1).astype(np.float32)
    text = "\n".join(" ".join("%.9g" % value for value in row) for row in rows)
    done = run("eval", material, *(words or ["--cos"]), input=text)
    assert done.returncode == 0, done.stderr
    return np.array([line.split() for line in done.stdout.splitlines()], float)


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def report(name, error, bound):
    """Prints the largest error and stops when it is beyond the bound or not a number."""
    worst = float(np.max(error))
    print(f"{name}: largest error {worst:.3g}, allowed {bound:.3g}")
    if not worst <= bound:
        sys.exit(f"{name}: {worst} is beyond {bound}")
