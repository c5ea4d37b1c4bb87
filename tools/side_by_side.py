#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts 8-bit RGB PNG pictures of one height side by side: side_by_side.py -o OUT.png A.png B.png

Standard library only; written for the pictures of `ndotl render`, so neither palettes, alpha nor
interlacing. The sRGB chunk is kept.
"""
import argparse
import os
import struct
import sys
import zlib


def chunks(data, name):
    """The (type, body) pairs of a PNG file."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        sys.exit(f"side_by_side.py: {name}: not a PNG file")
    at = 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + size]
        at += 12 + size


def unfilter(kind, row, above):
    """Undoes one row's PNG filter, in place; 3 bytes a pixel."""
    for i in range(len(row) if kind else 0):
        a = row[i - 3] if i >= 3 else 0
        b = above[i]
        c = above[i - 3] if i >= 3 else 0
        if kind == 1:
            guess = a
        elif kind == 2:
            guess = b
        elif kind == 3:
            guess = (a + b) // 2
        else:
            p, q, r = abs(b - c), abs(a - c), abs(a + b - 2 * c)
            guess = a if p <= q and p <= r else b if q <= r else c
        row[i] = (row[i] + guess) & 255


def read_rows(name):
    """The rows of a picture as byte arrays."""
    with open(name, "rb") as file:
        parts = list(chunks(file.read(), name))
    width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", parts[0][1])
    if (depth, colour, interlace) != (8, 2, 0):
        sys.exit(f"side_by_side.py: {name}: 8-bit RGB without interlacing is needed")
    raw = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
    rows, above, stride = [], bytearray(3 * width), 3 * width + 1
    for y in range(height):
        row = bytearray(raw[y * stride + 1:(y + 1) * stride])
        unfilter(raw[y * stride], row, above)
        rows.append(row)
        above = row
    return rows


def write(name, rows):
    """Writes the picture whole or not at all."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(
            ">I", zlib.crc32(kind + body))

    head = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    with open(name + ".part", "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"sRGB", b"\0")
                   + chunk(b"IDAT", data) + chunk(b"IEND", b""))
    os.replace(name + ".part", name)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("-o", required=True, metavar="OUT.png")
    parser.add_argument("pictures", nargs="+")
    options = parser.parse_args()
    pictures = [read_rows(name) for name in options.pictures]
    if len({len(rows) for rows in pictures}) != 1:
        sys.exit("side_by_side.py: the pictures differ in height")
    write(options.o, [bytearray().join(row) for row in zip(*pictures)])


if __name__ == "__main__":
    main()
