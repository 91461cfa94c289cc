#!/usr/bin/env python3
"""Measures how the cost of hard inputs grows with their size.

usage: growth.py PROGRAM [--only TEXT] [--scale F] [--limit SECONDS] [--instructions] [--plot FILE]

Runs each input of bench/growth with n, 2 n and 4 n, each in a process of its own, and prints a Markdown table:
the processor time of the measured part, its exponent between the smallest and the largest size (1: linear), and the peak
memory of the process with the largest size.

  --only TEXT       only the inputs whose names contain TEXT
  --scale F         multiplies every n by F
  --limit SECONDS   leaves out a size if the size before took longer than this (10)
  --instructions    also counts the instructions of the measured part, with `perf stat` or, where the processor has no
                    counters, with valgrind; counts do not depend on other work of the machine
  --plot FILE       draws the exponents of the instructions into FILE, an SVG picture; needs --instructions
"""

import argparse
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SIZES = (1, 2, 4)
LEAST = 0.002  # seconds: the exponent of shorter times is noise
AIM = 1.15  # the largest exponent of an input whose cost is n log n, at these sizes
ONE_OPERATION = 0.15  # the largest exponent of one operation whose cost is log n

WIDTH, ROW, LEFT, RIGHT, TOP, BOTTOM = 1000, 20, 470, 20, 40, 36
WITHIN, ABOVE = "#0072b2", "#d55e00"  # of Okabe and Ito


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


def count(command, uses_perf):
    if uses_perf:
        result = subprocess.run(["perf", "stat", "-x,", "-e", "instructions:u", *command], check=True, capture_output=True,
                                text=True)
        return int(re.search(r"^(\d+),", result.stderr, re.MULTILINE)[1])
    result = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *command], check=True,
                            capture_output=True, text=True)
    return int(re.search(r"Collected : (\d+)", result.stderr)[1])


def instructions(command, uses_perf):
    """Counts the instructions of the measured part: those until its end less those until its start."""
    return count([*command, "stop"], uses_perf) - count([*command, "start"], uses_perf)


class Progress:
    """One line on a terminal; nothing in a pipe."""

    def __init__(self):
        self.is_shown = sys.stderr.isatty()

    def show(self, text):
        if self.is_shown:
            print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)


def exponent(costs, least=0):
    """Returns the exponent between the first and the last cost, or None."""
    if len(costs) < 2 or costs[-2] < least:
        return None
    return math.log(costs[-1] / costs[0]) / math.log(SIZES[len(costs) - 1] / SIZES[0])


def cells(costs, text, growth):
    values = [text(cost) for cost in costs] + ["–"] * (len(SIZES) - len(costs))
    return [*values, "–" if growth is None else f"{growth:.2f}"]


def milliseconds(seconds):
    return f"{seconds * 1000:.3g}" if seconds < 1 else f"{seconds * 1000:,.0f}"


def millions(number):
    return f"{number / 1e6:,.3g}" if number < 1e8 else f"{number / 1e6:,.0f}"


def text(x, y, words, anchor="middle"):
    words = words.replace("&", "&amp;").replace("<", "&lt;")
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{words}</text>'


def draw(rows, file):
    """Draws a bar for each input: its exponent. Two lines show the largest exponents of n log n and of log n."""
    highest = max([2.0, *(growth for _, _, growth in rows)])
    width, bottom = WIDTH - LEFT - RIGHT, TOP + ROW * len(rows)

    def place(growth):
        return LEFT + max(growth, 0.0) / highest * width

    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{bottom + BOTTOM}"'
        f' viewBox="0 0 {WIDTH} {bottom + BOTTOM}" font-family="sans-serif" font-size="11">',
        f'<rect width="{WIDTH}" height="{bottom + BOTTOM}" fill="white"/>',
        text(14, 19, "exponent of the instructions between n and 4 n", "start"),
    ]
    for i in range(int(highest * 4) + 1):
        x = place(i / 4)
        out.append(f'<path d="M{x:.1f} {TOP}V{bottom}" stroke="#dddddd"/>')
        out.append(text(x, bottom + 15, f"{i / 4:g}"))
    for i, (what, is_operation, growth) in enumerate(rows):
        aim, y = ONE_OPERATION if is_operation else AIM, TOP + ROW * i
        colour = WITHIN if growth <= aim else ABOVE
        out.append(text(LEFT - 8, y + 14, what, "end"))
        out.append(f'<rect x="{LEFT}" y="{y + 4}" width="{place(growth) - LEFT:.1f}" height="12" fill="{colour}"/>')
        out.append(f'<path d="M{place(aim):.1f} {y}v{ROW}" stroke="black" stroke-width="1.5"/>')
    note = "black lines: the largest exponents of n log n and, for one operation, of log n"
    out.append(text(LEFT + width / 2, bottom + 30, note))
    file.write_text("\n".join([*out, "</svg>", ""]), encoding="utf-8")


def headings(counts):
    columns = ["ms at n", "at 2 n", "at 4 n", "exponent"]
    columns += ["10^6 instructions at n", "at 2 n", "at 4 n", "exponent"] if counts else []
    return ["input", "n", *columns, "MB"]


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--only", default="")
    parser.add_argument("--scale", type=float, default=1.0)
    parser.add_argument("--limit", type=float, default=10.0)
    parser.add_argument("--instructions", action="store_true")
    parser.add_argument("--plot", type=Path)
    options = parser.parse_args()
    uses_perf = options.instructions and has_counters()
    progress = Progress()
    names = headings(options.instructions)
    print(f"| {' | '.join(names)} |")
    print(f"| --- |{' ---: |' * (len(names) - 1)}")
    rows = []
    for name, smallest, kind, what in list_inputs(options.program):
        if options.only not in name:
            continue
        size = max(4, round(smallest * options.scale))
        times, counts, memory = [], [], 0
        for factor in SIZES:
            if times and times[-1] > options.limit:
                break
            progress.show(f"{name} {factor * size:,}")
            command = [options.program, name, str(factor * size)]
            output, memory = run(command)
            times.append(float(output))
            if options.instructions:
                counts.append(instructions(command, uses_perf))
        progress.show("")
        row = cells(times, milliseconds, exponent(times, LEAST))
        if options.instructions:
            row += cells(counts, millions, exponent(counts))
            if len(counts) > 1:
                rows.append((what, kind == "operation", exponent(counts)))
        target = " (best: 0)" if kind == "operation" else ""
        print(f"| {what} (`{name}`){target} | {size:,} | {' | '.join(row)} | {memory / 1e6:,.0f} |", flush=True)
    if options.plot and rows:
        draw(rows, options.plot)


if __name__ == "__main__":
    main()
