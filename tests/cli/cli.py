# SPDX-License-Identifier: Apache-2.0
"""What the tests of the command line share: running it, and a harness of test_ functions."""
import inspect
import os
import subprocess
import sys
import tempfile

BIN = os.environ["NDOTL_BIN"]
SLOW = bool(os.environ.get("NDOTL_SANITIZE")) or os.environ.get("NDOTL_BUILD_TYPE") == "Debug"
PAIR = "0 0.6 0.8  0 -0.6 0.8\n"


class Done:
    """A finished run: code, out (bytes), text, err."""

    def __init__(self, words, done):
        self.words, self.code, self.out = words, done.returncode, done.stdout or b""
        self.text = self.out.decode("utf-8", "replace")
        self.err = done.stderr.decode("utf-8", "replace")

    def __repr__(self):
        return f"{self.words}: exit {self.code}\nstdout: {self.text[:2000]}\nstderr: {self.err}"

    def rows(self):
        return [[float(x) for x in line.split()] for line in self.text.splitlines()]


def run(*words, stdin=b"", env=None, **more):
    """Runs ndotl with these words."""
    if isinstance(stdin, str):
        stdin = stdin.encode()
    feed = {"stdin": stdin} if not isinstance(stdin, bytes) else {"input": stdin}
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **feed, **more}
    environment = {**os.environ, "NDOTL_ISA": "", "NDOTL_TABLE": "", **(env or {})}
    done = subprocess.run([BIN, *words], env=environment, timeout=200, check=False, **streams)
    return Done(words, done)


def ok(*words, **more):
    """A run that must succeed in silence."""
    done = run(*words, **more)
    assert done.code == 0 and done.err == "", done
    return done


def refused(code, *words, says=(), place=None, **more):
    """A run that must end with this code and one line of message; stdout is empty for 2."""
    done = run(*words, **more)
    assert done.code == code, done
    lines = done.err.splitlines()
    assert lines and lines[-1].startswith("ndotl"), done
    assert code != 2 or done.text == "", done
    for part in [says] if isinstance(says, str) else says:
        assert part in done.err, (part, done)
    assert place is None or f": {place}: " in done.err, (place, done)
    return done


def has_workbench():
    return "workbench (" in ok("--version").text


def models():
    return [line.split()[0] for line in ok("models").text.splitlines() if line[0] != " "]


class Folder:
    """A temporary folder; file(name, content) makes a file and returns its path."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = self.folder.name
        return self

    def __exit__(self, *_):
        self.folder.cleanup()

    def file(self, name, content):
        path = os.path.join(self.path, name)
        with open(path, "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return path


def main(names):
    """Runs every test_ function of a module."""
    failed = []
    tests = {name: f for name, f in names.items()
             if name.startswith("test_") and inspect.isfunction(f)}
    for name, test in tests.items():
        try:
            test()
            print(f"ok   {name}")
        except AssertionError as error:
            print(f"FAIL {name}: {error}")
            failed.append(name)
    print(f"{len(tests) - len(failed)} of {len(tests)} passed")
    sys.exit(1 if failed or not tests else 0)
