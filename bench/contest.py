# SPDX-License-Identifier: Apache-2.0
"""Programs that measure on request, taking turns on one core: a Contest asks every entrant in each
round and keeps the medians."""

import json
import math
import os
import statistics
import subprocess


class Server:
    """A program that answers lines of stdin by lines of stdout."""

    def __init__(self, words, **environment):
        self.process = subprocess.Popen(
            [str(w) for w in words],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            bufsize=1,
            env={**os.environ, **environment},
        )

    def ask(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline()
        if not answer:
            raise RuntimeError(f"no answer to: {line}")
        return answer.strip()

    def close(self):
        self.process.stdin.close()
        self.process.wait()


class Rates(Server):
    """bench/rates.c; rates in evaluations per second, NaN where this machine cannot."""

    def rate(self, line):
        return float(self.ask(line).split()[0])


class Mitsuba(Server):
    """bench/peers/mitsuba.py"""

    def call(self, line):
        return json.loads(self.ask(line))


class Contest:
    """Entrants: name -> function that measures once and returns a rate."""

    def __init__(self, entrants, rounds):
        taken = {name: [] for name in entrants}
        for _ in range(rounds):
            for name, measure in entrants.items():
                taken[name].append(measure())
        self.rates = {name: statistics.median(values) for name, values in taken.items()}

    def __getitem__(self, name):
        return self.rates[name]

    def ratio(self, a, b):
        """Rate of a over rate of b."""
        return self.rates[a] / self.rates[b]


def geomean(values):
    values = [v for v in values if not math.isnan(v)]
    return math.exp(statistics.fmean(map(math.log, values))) if values else math.nan


def pin(core):
    """This process and all that it starts stay on one core, which is returned; None: it failed."""
    try:
        cores = sorted(os.sched_getaffinity(0))
        core = cores[-1] if core is None else core
        os.sched_setaffinity(0, {core})
        return core
    except (AttributeError, OSError):
        return None
