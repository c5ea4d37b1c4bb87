#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The kernels as WebAssembly with 128-bit SIMD, run in node, have the bits of this machine's.

The vector loops are the only table here, under the name that every build has: scalar.
"""

import pathlib
import re

import cross

TARGET = ["--target=wasm32-wasi", "-mbulk-memory", "-mnontrapping-fptoint"]
SIMD = ["-O3", "-msimd128"]
HOST = """
import { WASI } from 'node:wasi';
import { readFileSync } from 'node:fs';
const [folder] = process.argv.slice(2);
const wasi = new WASI({ version: 'preview1', preopens: { '/x': folder },
                        args: ['bits', '/x/materials.txt', '/x/wasm.txt', 'scalar'] });
const code = new WebAssembly.Module(readFileSync(folder + '/bits.wasm'));
process.exitCode = wasi.start(new WebAssembly.Instance(code, wasi.getImportObject()));
"""


def builtins():
    """compiler-rt's library for wasm32, wherever the installed clang keeps it."""
    found = sorted(pathlib.Path("/usr/lib").glob("**/libclang_rt.builtins-wasm32.a"))
    if not found:
        cross.need_file(
            "/usr/lib/clang/14/lib/wasi/libclang_rt.builtins-wasm32.a", "libclang-rt-14-dev-wasm32"
        )
    return found[0]


def main():
    compiler = cross.need("clang", "clang")
    linker = cross.need("wasm-ld-14", "lld-14")
    node = cross.need("node", "nodejs")
    libc = pathlib.Path("/usr/lib/wasm32-wasi")
    cross.need_file(libc / "libc.a", "wasi-libc")
    runtime = builtins()
    with cross.folder() as name:
        folder = pathlib.Path(name)
        objects = cross.objects(folder, [compiler], TARGET, [("scalar", SIMD)])
        cross.run(
            compiler,
            *cross.FLAGS,
            *TARGET,
            "-O1",
            "-c",
            cross.bits_source(folder),
            "-o",
            folder / "bits.o",
        )
        # Not through the clang driver, which calls binaryen where that is installed.
        cross.run(
            linker,
            libc / "crt1.o",
            folder / "bits.o",
            *objects,
            f"-L{libc}",
            "-lc",
            "-lm",
            runtime,
            "-o",
            folder / "bits.wasm",
        )
        text = cross.run(
            compiler,
            *cross.FLAGS,
            *TARGET,
            *SIMD,
            "-S",
            "-o",
            "-",
            cross.TREE / "src/core/kernels.c",
        )
        wide = len(re.findall(r"\bf32x4\.(?:add|sub|mul|div|sqrt)\b", text))
        assert wide > 1000, f"only {wide} SIMD operations: the kernels are not vectorised"
        want = cross.native_hashes(folder)
        (folder / "host.mjs").write_text(HOST)
        print(cross.run(node, "--no-warnings", folder / "host.mjs", folder), end="")
        cross.compare("WebAssembly", (folder / "wasm.txt").read_text().splitlines(), want)


if __name__ == "__main__":
    main()
