#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The NEON kernels, cross compiled and run under qemu-user, have the bits of this machine's."""

import pathlib

import cross

PREFIX = "/usr/aarch64-linux-gnu"


def main():
    compiler = cross.need("aarch64-linux-gnu-gcc", "gcc-aarch64-linux-gnu")
    emulator = cross.need("qemu-aarch64", "qemu-user")
    cross.need_file(f"{PREFIX}/include/stdio.h", "libc6-dev-arm64-cross")
    with cross.folder() as name:
        folder = pathlib.Path(name)
        objects = cross.objects(
            folder,
            [compiler],
            [],
            [("scalar", ["-O2", "-fno-tree-vectorize", "-DNDL_PLAIN_LOOPS"]), ("neon", ["-O3"])],
        )
        program, output = folder / "bits", folder / "neon.txt"
        cross.run(
            compiler,
            *cross.FLAGS,
            "-O1",
            cross.bits_source(folder),
            *objects,
            "-lm",
            "-static",
            "-o",
            program,
        )
        # bits.c compares the NEON kernels with the scalar ones, and prints hashes of these.
        print(cross.run(emulator, program, cross.short_list(folder), output), end="")
        cross.compare("AArch64", output.read_text().splitlines(), cross.native_hashes(folder))


if __name__ == "__main__":
    main()
