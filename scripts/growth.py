#!/usr/bin/env python3
"""Measures how the cost of hard inputs grows with their size.

usage: growth.py PROGRAM [--only TEXT] [--scale F] [--limit SECONDS] [--instructions]

Runs each input of bench/growth/inputs.cpp with n, 2 n and 4 n, each in a process of its own, and prints a Markdown table:
the processor time of the measured part, the exponent between the last two sizes (1: linear), and the peak memory of the
process with the largest size.

  --only TEXT       only the inputs whose names contain TEXT
  --scale F         multiplies every n by F
  --limit SECONDS   leaves out a size if the size before took longer than this (10)
  --instructions    counts the instructions of the whole process with `perf stat` or, where the processor has no
                    counters, with valgrind; counts do not depend on other work of the machine
"""

import argparse
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

SIZES = (1, 2, 4)
LEAST = 0.002  # seconds: the exponent of shorter times is noise


def list_inputs(program):
    lines = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
    return [(name, int(size), kind, what) for name, size, kind, what in (line.split("\t") for line in lines)]


def run(command):
    """Runs a command. Returns its standard output and its peak memory in bytes."""
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen(command, stdout=output)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            raise subprocess.CalledProcessError(process.returncode, command)
        output.seek(0)
        unit = 1 if sys.platform == "darwin" else 1024
        return output.read(), usage.ru_maxrss * unit


def has_counters():
    if shutil.which("perf") is None:
        return False
    result = subprocess.run(["perf", "stat", "-x,", "-e", "instructions:u", "true"], capture_output=True, text=True)
    return re.search(r"^\d+,", result.stderr, re.MULTILINE) is not None


def instructions(command, uses_perf):
    if uses_perf:
        result = subprocess.run(["perf", "stat", "-x,", "-e", "instructions:u", *command], check=True, capture_output=True,
                                text=True)
        return int(re.search(r"^(\d+),", result.stderr, re.MULTILINE)[1])
    result = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *command], check=True,
                            capture_output=True, text=True)
    return int(re.search(r"Collected : (\d+)", result.stderr)[1])


class Progress:
    """One line on a terminal; nothing in a pipe."""

    def __init__(self):
        self.is_shown = sys.stderr.isatty()

    def show(self, text):
        if self.is_shown:
            print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)


def measure(program, name, size, options, uses_perf):
    """Returns the cost (seconds or instructions), the processor time and the peak memory."""
    command = [program, name, str(size)]
    if options.instructions:
        count = instructions(command, uses_perf)
        return count, count / 1e9, 0
    output, memory = run(command)
    seconds = float(output)
    return seconds, seconds, memory


def exponent(costs, least):
    if len(costs) < 2 or costs[-2] < least:
        return "–"
    return f"{math.log2(costs[-1] / costs[-2]):.1f}"


def number(cost, options):
    if options.instructions:
        return f"{cost / 1e6:,.0f}"
    return f"{cost * 1000:.3g}" if cost < 1 else f"{cost * 1000:,.0f}"


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--only", default="")
    parser.add_argument("--scale", type=float, default=1.0)
    parser.add_argument("--limit", type=float, default=10.0)
    parser.add_argument("--instructions", action="store_true")
    options = parser.parse_args()
    uses_perf = options.instructions and has_counters()
    least = 0 if options.instructions else LEAST
    progress = Progress()
    unit = "10^6 instructions" if options.instructions else "ms"
    print(f"| input | n | {unit} at n | at 2 n | at 4 n | exponent | peak memory, MB |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for name, smallest, kind, what in list_inputs(options.program):
        if options.only not in name:
            continue
        size = max(4, round(smallest * options.scale))
        costs, memory, seconds = [], 0, 0.0
        for factor in SIZES:
            if seconds > options.limit:
                break
            progress.show(f"{name} {factor * size:,}")
            cost, seconds, memory = measure(options.program, name, factor * size, options, uses_perf)
            costs.append(cost)
        progress.show("")
        cells = [number(cost, options) for cost in costs] + ["–"] * (len(SIZES) - len(costs))
        target = " (0 is best)" if kind == "operation" else ""
        peak = "–" if options.instructions else f"{memory / 1e6:,.0f}"
        print(f"| {what} (`{name}`) | {size:,} | {' | '.join(cells)} | {exponent(costs, least)}{target} | {peak} |",
              flush=True)


if __name__ == "__main__":
    main()
