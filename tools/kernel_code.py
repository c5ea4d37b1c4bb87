# SPDX-License-Identifier: Apache-2.0
"""What the compiler made of the kernels: float instructions inside the loops of an object file.

Reads `objdump -d` of x86-64 code. A loop body is what a backward jump spans.
"""

import re
import subprocess

# Packed and scalar float arithmetic; an fma is two operations.
ARITHMETIC = re.compile(
    r"^v?(add|sub|mul|div|sqrt|min|max|fn?m(?:add|sub)\d+|rcp14|rsqrt14|rcp|rsqrt"
    r"|round|rndscale)([ps])s$"
)
WIDTH = {"z": 16, "y": 8, "x": 4}
FUNCTION = re.compile(r"^[0-9a-f]+ <([^>]+)>:$")
LINE = re.compile(r"^\s*([0-9a-f]+):\s+(\S+)\s*(.*)$")
JUMP = re.compile(r"^([0-9a-f]+)\b")
STORE = re.compile(r"^v?mov(?:[au]p[sd]|ntp[sd]|dq[au]\d*)$")
STACK = re.compile(r"\(%r[sb]p")


class Kernel:
    """One function. Of the innermost loop that computes most: `wide` packed operations, `lanes` of
    the widest store, `scalar` operations beside them, and `flops` and `roots` (divisions and square
    roots among them) for each value stored. `rest`: scalar operations of the largest loop that
    stores no vectors. `alias`: it is a jump to another function."""

    def __init__(self, name):
        self.name, self.lines = name, []
        self.wide, self.lanes, self.scalar, self.rest, self.flops, self.roots = 0, 0, 0, 0, 0.0, 0.0
        self.alias = False

    def count(self):
        loops = []
        for at, name, rest in self.lines:
            target = JUMP.match(rest)
            if name.startswith("j") and target:
                to = int(target.group(1), 16)
                if self.lines[0][0] <= to <= at:
                    loops.append((to, at))
        self.alias = not loops and any(name.startswith("jmp") for _, name, _ in self.lines)
        for first, last in loops:
            if not any(
                (first, last) != other and first <= other[0] and other[1] <= last for other in loops
            ):
                self.count_body([line for line in self.lines if first <= line[0] <= last])

    def count_body(self, body):
        stored = [
            lanes_of(rest)
            for _, name, rest in body
            if STORE.match(name) and rest.endswith(")") and not STACK.search(rest)
        ]
        packed = [(name, lanes_of(rest)) for _, name, rest in body if kind_of(name) == "p"]
        scalar = sum(kind_of(name) == "s" for _, name, _ in body)
        if not stored:
            self.rest = max(self.rest, scalar)
            return
        self.scalar = max(self.scalar, scalar)
        if self.lanes and len(packed) <= self.wide:
            return
        self.wide, self.lanes = len(packed), max(stored)
        values = sum(stored)
        self.flops = (
            sum(n * (2 if "fm" in name or "fnm" in name else 1) for name, n in packed) / values
        )
        self.roots = sum(n for name, n in packed if re.match("v?(div|sqrt)", name)) / values


def kind_of(name):
    """p for packed float arithmetic, s for scalar, None for anything else."""
    found = ARITHMETIC.match(name)
    return found.group(2) if found else None


def lanes_of(operands):
    return max((WIDTH[r] for r in re.findall(r"%([xyz])mm", operands)), default=0)


def kernels(path, pattern):
    """The functions of an object file whose name matches the pattern, counted."""
    text = subprocess.run(
        ["objdump", "-d", "--no-show-raw-insn", "-w", str(path)],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    found, current = [], None
    for line in text.splitlines():
        begin = FUNCTION.match(line)
        if begin:
            name = re.sub(r"\.(?:constprop|isra|part|cold)\.?\d*", "", begin.group(1))
            current = Kernel(name) if re.match(pattern, name) else None
            if current:
                found.append(current)
            continue
        part = LINE.match(line) if current else None
        if part:
            current.lines.append((int(part.group(1), 16), part.group(2), part.group(3)))
    for kernel in found:
        kernel.count()
    return found
