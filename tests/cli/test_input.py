#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `ndotl eval` reads and where reading or writing fails."""
import math
import os
import random
import select
import struct
import subprocess

from cli import BIN, PAIR, SLOW, Folder, main, ok, refused, run

LINE = "0.318309873 0.318309873 0.318309873\n"
WHITE = "lambert(color=1)"


def test_no_input_gives_no_output():
    assert ok("eval", WHITE).out == b""
    assert ok("eval", WHITE, "--csv").text.count("\n") == 1
    assert '"rows":[\n]}' in ok("eval", WHITE, "--json").text
    assert ok("eval", WHITE, "--binary", "f32").out == b""
    assert b"'shape': (0, 3)" in ok("eval", WHITE, "--binary", "npy").out
    assert ok("eval", WHITE, stdin="# only a comment\n\n  \t \n#").out == b""


def test_blanks_tabs_commas_comments_and_line_ends_are_understood():
    for text in ["0 0.6 0.8 0 -0.6 0.8", "0\t0.6\t0.8\t0\t-0.6\t0.8\n", "0,0.6,0.8,0,-0.6,0.8\n",
                 "0, 0.6 ,0.8\t,0 -0.6,0.8\n", "  0 0.6 0.8 0 -0.6 0.8  \r\n",
                 "0 0.6 0.8 0 -0.6 0.8 # c\n", "0 0.6 0.8 0 -0.6 0.8# \xff\n", "\ufeff" + PAIR,
                 "+0 .6 8e-1 0E0 -6.e-1 0.8\n", "# c\n\r\n" + PAIR + "\r\n#\n"]:
        assert ok("eval", WHITE, stdin=text).text == LINE, text


def test_a_file_is_read_like_stdin():
    with Folder() as folder:
        path = folder.file("d.txt", PAIR * 3)
        assert ok("eval", WHITE, path).text == LINE * 3
        assert ok("eval", WHITE, "-", stdin=PAIR).text == LINE


def test_a_malformed_line_is_named_with_its_number():
    cases = [("0 0.6 0.8 0 -0.6", "expected 6 numbers, found 5"),
             ("30 0 40 0", "add --angles"), ("1 2 3 4 5 6 7", "found 7"),
             ("0 0.6 0.8 0 -0.6 x", "'x' is no number"), ("0 0.6 0.8 0 -0.6 0.8x", "'0.8x'"),
             ("0 0.6 0.8 0 -0.6 nan", "'nan'"), ("0 0.6 0.8 0 -0.6 -inf", "'-inf'"),
             ("0 0.6 0.8 0 -0.6 1e999", "too large"), ("0 0 0 0 -0.6 0.8", "wi is zero"),
             ("0 0.6 0.8 -0 0 0", "wo is zero"), ("0,,0.6,0.8,0,-0.6,0.8", "','"),
             ("0,0.6,0.8,0,-0.6,0.8,", "','"), (",0 0.6 0.8 0 -0.6 0.8", "','"),
             ("0 0.6 0.8 0 -0.6 1e", "'1e'"), ("0 0.6 0.8 0 0x1 1", "'0x1'"),
             ("0 0.6 0.8 0 -0.6 \x01", "\\x01"), ("0 0.6 0.8 0 -0.6 \u2212", "\\xe2"),
             ("0 0.6 0.8 0 -0.6 0.8\0", "'0.8"), ("\0", "\\x00"),
             ("0 0.6 0.8 0 -0.6 0\f8", "\\x0c")]
    for text, says in cases:
        done = refused(1, "eval", WHITE, stdin=f"# c\n{PAIR}{text}\n{PAIR}", says=says,
                       place="stdin:3")
        assert done.text == LINE, done
        with Folder() as folder:
            path = folder.file("d.txt", text)
            assert refused(1, "eval", WHITE, path, says=says, place=f"{path}:1").out == b""
    refused(1, "eval", WHITE, "--angles", stdin=PAIR, says="drop --angles", place="stdin:1")
    refused(1, "eval", WHITE, stdin=("0 1\n" * 5).replace("0 1", "", 4), place="stdin:5")


def test_json_of_a_malformed_input_is_absent():
    for words in [["--json"], ["--binary", "npy"]]:
        assert refused(1, "eval", WHITE, *words, stdin=PAIR + "x\n", place="stdin:2").out == b""


def test_raw_input_that_is_cut_off_or_not_finite_is_named():
    refused(1, "eval", WHITE, "--binary", "f32", stdin=bytes(25), says="wi is zero",
            place="stdin: row 1")
    one = b"\0\0\0\0\0\0\0\0\0\0\x80\x3f" * 2
    done = refused(1, "eval", WHITE, "--binary", "f32", stdin=one + one[:23], says="23 of 24",
                   place="stdin: row 2")
    assert len(done.out) == 12
    refused(1, "eval", WHITE, "--binary", "f32", stdin=one + b"\0\0\xc0\x7f" + one[4:],
            says="wi is not finite", place="stdin: row 2")


def test_directions_are_normalised_with_a_warning():
    done = run("eval", WHITE, stdin="0 0 1.0009 0 0 0.9991\n")
    assert (done.code, done.err, done.text) == (0, "", LINE)
    for text in ["0 0 1.0011 0 0 1\n", "0 0 1e-300 0 0 1\n", "0 0 1 0 0 5e-324\n",
                 "1e300 0 1e300 0 0 1\n", "0 0 1 1e-200 1e-200 1e-200\n"]:
        done = run("eval", WHITE, stdin=text)
        assert done.code == 0 and done.text == LINE, done
        assert "ndotl eval: stdin:1: warning: a direction of length" in done.err, done
    done = run("eval", WHITE, stdin="0 0 2 0 0 1\n" * 1000)
    assert done.text == LINE * 1000 and len(done.err.splitlines()) == 2 and "1000 rows" in done.err


def test_directions_are_rounded_once():
    text = ok("eval", WHITE, "--csv", stdin="0 0.6 0.8 0.28 0 0.96\n0 0 1 0 0 -1\n").text
    assert text.splitlines()[1].startswith("0,0.600000024,0.800000012,0.280000001,0,0.959999979,")
    draw = random.Random(2)
    rows = [[draw.gauss(0, 1) for _ in range(3)] for _ in range(100)]
    rows = [[x / math.sqrt(sum(y * y for y in row)) for x in row] for row in rows]
    text = "".join("%r %r %r 0 0 1\n" % tuple(row) for row in rows)
    out = ok("eval", WHITE, "--csv", stdin=text).text
    for row, line in zip(rows, out.splitlines()[1:]):
        for x, word in zip(row, line.split(",")):
            assert word == "%.9g" % struct.unpack("<f", struct.pack("<f", x))[0], (row, line)


def test_files_that_cannot_be_read_are_named():
    with Folder() as folder:
        missing = os.path.join(folder.path, "missing")
        refused(1, "eval", WHITE, missing, says="cannot be opened", place=missing)
        refused(1, "eval", WHITE, folder.path, says="cannot be read", place=folder.path)
    refused(1, "eval", WHITE, "", says="cannot be opened")


def test_a_closed_stdin_or_stdout_is_an_error():
    for words, says in [("<&-", "stdin: cannot be read"), (">&-", "stdout: cannot write")]:
        script = f'echo "0 0 1 0 0 1" | (exec "$0" eval lambert {words})'
        done = subprocess.run(["bash", "-c", script, BIN], capture_output=True, text=True,
                              check=False)
        assert done.returncode == 1 and says in done.stderr, done


def test_a_full_disk_or_closed_pipe_is_an_error():
    for words in [[], ["--json"], ["--csv"], ["--binary", "npy"], ["--print"]]:
        with open("/dev/full", "wb") as full:
            done = run("eval", WHITE, *words, stdin=PAIR, stdout=full)
        assert done.code == 1 and "stdout: cannot write: No space" in done.err, done
    with Folder() as folder:
        path = folder.file("d.txt", PAIR * 100000)
        done = subprocess.run(["bash", "-c", '"$0" eval lambert "$1" | head -n 1; '
                               'echo "${PIPESTATUS[0]}"', BIN, path],
                              capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[1] == "1" and "cannot write: Broken pipe" in done.stderr, done


def test_a_line_is_answered_before_the_next_one_is_written():
    with subprocess.Popen([BIN, "eval", WHITE], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as p:
        for _ in range(3):
            p.stdin.write(PAIR.encode())
            p.stdin.flush()
            assert select.select([p.stdout], [], [], 60)[0], "no answer"
            assert p.stdout.readline().decode() == LINE
        p.stdin.close()
        assert p.wait() == 0


def test_long_lines_are_read_or_refused():
    zeros = "0" * 300000
    assert ok("eval", WHITE, stdin=f"0 0 1 0 0.{zeros} 1 # {zeros}\n").text == LINE
    refused(1, "eval", WHITE, stdin=PAIR + "0" * 3000000, says="longer than", place="stdin:2")
    refused(1, "eval", WHITE, stdin=PAIR + "#" * 3000000 + "\n" + PAIR, place="stdin:2")
    refused(1, "eval", WHITE, stdin=" 1" * 200000, says="found 1000", place="stdin:1")


def test_random_bytes_never_crash():
    draw = random.Random(4)
    for i in range(60):
        data = bytes(draw.randrange(256) for _ in range(draw.randrange(200)))
        if i % 2:
            data = PAIR.encode() * 3 + bytes(draw.choice(b"0123456789.-+eE \t,#\n\r\0x")
                                             for _ in range(80))
        for words in [[], ["--binary", "f32"], ["--angles"]]:
            done = run("eval", WHITE, *words, stdin=data)
            assert done.code in (0, 1), (data, done)


def test_a_million_lines():
    n = 100000 if SLOW else 1000000
    draw = random.Random(5)
    block = "".join(f"{draw.uniform(-1, 1)!r} {draw.uniform(-1, 1):.9g} {draw.random():.6f} "
                    f"0 -0.6 0.8\n" for _ in range(1000))
    text = run("eval", "ggx", stdin=block).out
    with Folder() as folder:
        path = folder.file("d.txt", block * (n // 1000))
        assert run("eval", "ggx", path).out == text * (n // 1000)


if __name__ == "__main__":
    main(globals())
