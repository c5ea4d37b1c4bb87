#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Direction of includes: who may see whom, and the one place of every foreign library.

    shade <- core <- {check, bake, plot, shader} <- io <- {data, fit, render} <- cli
    base from everywhere above shade; web, python, examples and bench see include/ndotl only
"""
import re

import lint

VERBS = ["check", "bake", "plot", "shader"]
LOW = ["base", "shade", "core"]
SEES = {"shade": ["shade"], "base": ["base"], "core": LOW, "io": LOW + VERBS + ["io"]}
for verb in VERBS:
    SEES[verb] = LOW + [verb]
for verb in ["data", "fit", "render"]:
    SEES[verb] = LOW + VERBS + ["io", verb]
SEES["cli"] = LOW + VERBS + ["io", "data", "fit", "render", "cli"]
OUTSIDE = ["web", "python", "examples", "bench"]

# (pattern of a header, pattern of the files that may include it, the cure)
PLACES = [
    (r"embree\d?/.*", r"src/render/embree\.c", "only src/render/embree.c includes Embree"),
    (r"(png|zlib|jansson)\.h|(openexr|stb_).*|(assimp|stb|OpenEXR)/.*", r"src/io/.*",
     "put the call into src/io, the only place of this library"),
    (r"(unistd|pthread|fcntl|dlfcn|signal|poll|spawn|dirent|sched|termios|semaphore|glob|ftw"
     r"|strings|syslog|pwd|grp|fnmatch)\.h|(sys|netinet|arpa|net|linux)/.*", r"src/base/.*",
     "put the call into src/base, the only place of POSIX"),
]
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.M)


def folder_of(path):
    """The folder of the house that a file belongs to, such as core; None outside of it."""
    parts = path.parts
    if parts[0] == "src":
        return parts[1] if len(parts) > 2 else None
    return parts[0]


def target_of(tree, path, name):
    """(folder, public) of an included project header; (None, False) for a foreign one."""
    if name.startswith("ndotl/"):
        return None, True
    for base in [path.parent, path.parent.__class__("src"), path.parent.__class__("cli")]:
        if (tree / base / name).exists():
            relative = (tree / base / name).resolve().relative_to(tree.resolve())
            return folder_of(relative), relative.parts[0] == "include"
    first = name.split("/")[0]
    return (first, False) if first in SEES and "/" in name else (None, False)


def finding(tree, path, name):
    """Why this include is wrong, or None."""
    folder = folder_of(path)
    target, public = target_of(tree, path, name)
    if folder == "shade" and public:
        return "shading text sees src/shade only"
    if folder in OUTSIDE and target is not None and target != folder:
        return f"{folder} sees include/ndotl only: use the public API"
    if folder == "include" and target is not None:
        return "a public header includes public and standard headers only"
    if target is not None and folder in SEES and target not in SEES[folder]:
        return (f"{folder} may not see {target}, only {', '.join(SEES[folder])} and ndotl/...: "
                "move what both need below them")
    for header, places, cure in PLACES:
        if target is None and re.fullmatch(header, name) and not re.fullmatch(places, str(path)):
            return cure
    return None


def check(tree):
    findings = []
    tops = ["src", "cli", "include"] + OUTSIDE
    for path in lint.files(tree, *[f"{top}/**/*.[ch]" for top in tops],
                           "src/**/*.def", "src/**/*.inc", "cli/**/*.def"):
        code, _ = lint.split_comments((tree / path).read_text())
        for match in INCLUDE.finditer(code):
            why = finding(tree, path, match.group(2))
            if why:
                findings.append(f"{path}:{lint.line_of(code, match.start())}: "
                                f"includes {match.group(2)}; {why}")
    return findings


GOOD = {
    "src/shade/a.h": "", "src/base/a.h": "#include <pthread.h>\n", "include/ndotl/ndotl.h": "",
    "src/core/a.c": '#include "shade/a.h"\n#include "base/a.h"\n#include <ndotl/ndotl.h>\n',
    "src/render/embree.c": "#include <embree3/rtcore.h>\n",
    "src/io/png.c": '#include <png.h>\n/* #include "cli/main.h" */\n',
}
BAD = [
    ({"src/core/a.h": "", "src/shade/a.h": '\n#include "core/a.h"\n'}, "src/shade/a.h:2: "),
    ({"src/shade/a.h": "#include <ndotl/ndotl.h>\n"}, "shading text sees"),
    ({"src/core/a.h": "", "src/shade/a.h": '#include "../core/a.h"\n'}, "shade may not see core"),
    ({"src/plot/p.h": "", "src/bake/b.c": '#include "plot/p.h"\n'}, "bake may not see plot"),
    ({"src/core/a.c": '#include "io/png.h"\n'}, "core may not see io"),
    ({"src/base/a.c": '#include "core/a.h"\n'}, "base may not see core"),
    ({"src/render/film.c": "#include <embree3/rtcore.h>\n"}, "only src/render/embree.c"),
    ({"cli/main.c": "#include <png.h>\n"}, "put the call into src/io"),
    ({"cli/main.c": "#  include <unistd.h>\n"}, "put the call into src/base"),
    ({"src/core/a.c": "#include <sys/mman.h>\n"}, "put the call into src/base"),
    ({"bench/b.c": '#include "core/a.h"\n'}, "use the public API"),
    ({"include/ndotl/ndotl.h": '#include "core/a.h"\n'}, "a public header"),
]

if __name__ == "__main__":
    lint.main(check, BAD, GOOD)
