#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Installs into a temporary prefix, moves it, and builds a C11 and a C++17 program against it, by
pkg-config and by find_package, shared and static; each program runs and prints the same value."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

PROGRAMS = {
    "ndotl": """#include <ndotl/ndotl.h>
#include <stdio.h>
int main(void) {
    ndl_material *m = ndl_material_parse("lambert(color=0.5)", NULL);
    ndl_vec3 n = {0, 0, 1};
    printf("%.6f\\n", (double)ndl_brdf(m, n, n).g);
    ndl_material_free(m);
    return 0;
}
""",
    "ndotl-workbench": """#include <ndotl/render.h>
#include <stdio.h>
int main(void) {
    ndl_material *m = ndl_material_parse("lambert(color=0.5)", NULL);
    ndl_scene *scene = ndl_scene_load("plane", NULL);
    ndl_image *image = ndl_image_new(1, 1);
    static ndl_render_desc desc; /* zero means the default */
    ndl_scene_set_material(scene, NULL, m, NULL);
    ndl_scene_add_light(scene, "directional(direction=[0,0,1], irradiance=1)", NULL);
    ndl_render(scene, &desc, image, NULL, NULL);
    printf("%.6f\\n", (double)image->rgb[1]);
    ndl_image_free(image);
    ndl_scene_free(scene);
    ndl_material_free(m);
    return 0;
}
""",
}
WANT = "0.159155\n"  # 0.5 / pi
PROJECT = """cmake_minimum_required(VERSION 3.22)
project(user C CXX)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_C_STANDARD 11)
find_package(ndotl 0.1 REQUIRED)
foreach(language c cpp)
    foreach(kind "" _static)
        add_executable(ndotl${kind}_${language} ndotl.${language})
        target_link_libraries(ndotl${kind}_${language} ndotl::ndotl${kind})
        if(ndotl_workbench_FOUND)
            add_executable(ndotl-workbench${kind}_${language} ndotl-workbench.${language})
            target_link_libraries(ndotl-workbench${kind}_${language} ndotl::ndotl_workbench${kind})
        endif()
    endforeach()
endforeach()
"""


def run(words, **more):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, **more)
    if done.returncode:
        sys.exit(f"failed: {' '.join(map(str, words))}\n{done.stdout}{done.stderr}")
    return done.stdout


def expect(program):
    got = run([program])
    if got != WANT:
        sys.exit(f"{program} printed {got!r}, not {WANT!r}")
    print(f"ok: {program.name}")


def by_pkg_config(folder, prefix, names):
    """The programs with `pkg-config --cflags --libs`, as the manual of any library says."""
    environment = dict(os.environ, PKG_CONFIG_PATH=str(next(prefix.glob("lib*/pkgconfig"))))
    libraries = next(prefix.glob("lib*/libndotl.so")).parent
    for name in names:
        ask = ["pkg-config", "--cflags", "--libs", name]
        shared = run(ask, env=environment).split() + [f"-Wl,-rpath,{libraries}"]
        static = [f"-l:lib{flag[2:]}.a" if flag.startswith("-lndotl") else flag
                  for flag in run([*ask, "--static"], env=environment).split()]
        for command, language in [(["cc", "-std=c11"], "c"), (["c++", "-std=c++17"], "cpp")]:
            for kind, flags in [("shared", shared), ("static", static)]:
                program = folder / f"pkg_{name}_{kind}_{language}"
                run([*command, "-Wall", "-Wextra", "-Werror", folder / f"{name}.{language}",
                     "-o", program, *flags])
                expect(program)


def by_find_package(folder, prefix, names):
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    build = folder / "build"
    run(["cmake", *generator, "-S", folder, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}"])
    run(["cmake", "--build", build])
    for name in names:
        for kind in ["", "_static"]:
            for language in ["c", "cpp"]:
                expect(build / f"{name}{kind}_{language}")


def check_exports(prefix):
    """Only ndl_ names are exported, and the workbench has no kernels of its own: the choice of
    instruction set is made in one place."""
    for library in prefix.glob("lib*/libndotl*.so"):
        for line in run(["nm", "-D", "--defined-only", library]).splitlines():
            if not line.split()[-1].startswith("ndl_"):
                sys.exit(f"{library.name} exports {line.split()[-1]}")
        if "workbench" in library.name and "nd_kernels" in run(["nm", library]):
            sys.exit(f"{library.name} has its own kernels: it links more of libndotl.a than the "
                     "parser; use the public functions")


def main():
    for tool in ["pkg-config", "c++", "cc"]:
        if not shutil.which(tool):
            print(f"skipped: {tool} is missing")
            sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        first, prefix = folder / "first", folder / "moved"
        run(["cmake", "--install", os.environ["NDOTL_BUILD"], "--prefix", first])
        first.rename(prefix)
        names = [name for name in PROGRAMS if list(prefix.glob(f"lib*/lib{name}.so"))]
        for name in names:
            for language in ["c", "cpp"]:
                (folder / f"{name}.{language}").write_text(PROGRAMS[name])
        (folder / "CMakeLists.txt").write_text(PROJECT)
        check_exports(prefix)
        by_pkg_config(folder, prefix, names)
        by_find_package(folder, prefix, names)
        if "ndotl" not in run([prefix / "bin" / "ndotl", "--version"]):
            sys.exit("the installed ndotl does not print its version")
        print("ok: ndotl --version")


if __name__ == "__main__":
    main()
