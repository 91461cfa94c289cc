#!/usr/bin/env python3
"""Measures how long single updates and queries take in large worlds.

usage: latency.py PROGRAM FOLDER [--rounds N] [--runs N] [--huge]

Runs bench/latency/main.cpp in worlds of 10^4, 10^5 and 10^6 vertices, and in towns and streets with bridges. Prints a Markdown table with percentiles of the times
of each kind of update and query, and what the slowest of them did to the world's memory. Draws them into FOLDER/latency.svg.

  --rounds N  rounds of updates and queries in each world (20000)
  --runs N    runs of each world, each in a process of its own (3); all runs do the same, so the time of an operation is the
              shortest of its times in all runs. This leaves out delays by other programs, but not delays by the library.
  --huge      also runs a world of 10^7 vertices, most of them points
"""

import argparse
import math
import subprocess
from pathlib import Path

from plots import text

WORLDS = [("buildings", 10**4), ("buildings", 10**5), ("buildings", 10**6)]
HUGE = [("points", 10**7)]
# Worlds with bridges; the plot does not show them.
WITH_BRIDGES = [("discs", 10**5), ("street", 10**4), ("street", 10**5)]
# The lines of the plot and their colours, of Okabe and Ito.
PERCENTILES = [("p50", 0.5, "#0072b2"), ("p99", 0.99, "#009e73"), ("p99.9", 0.999, "#e69f00"), ("max", 1.0, "#d55e00")]

WIDTH, HEIGHT = 250, 220  # of a panel
LEFT, RIGHT, TOP, BOTTOM = 66, 12, 30, 40  # around its plot
LEGEND, COLUMNS = 28, 4


def run(command):
    """Returns the number of vertices, and {kind: [(nanoseconds, growth, growth of the sectors), ...]} in order."""
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    kinds = {}
    for line in lines[1:]:
        kind, *numbers = line.split("\t")
        kinds.setdefault(kind, []).append(tuple(map(int, numbers)))
    return int(lines[0]), kinds


def measure(program, world, vertices, options):
    command = [program, world, str(vertices), str(options.rounds)]
    runs = [run(command) for _ in range(options.runs)]
    shortest = {kind: [min(times) for times in zip(*(kinds[kind] for _, kinds in runs))] for kind in runs[0][1]}
    return runs[0][0], shortest


def percentile(times, share):
    """Returns the smallest time that is not exceeded by this share of the times."""
    ordered = sorted(times)
    return ordered[max(0, math.ceil(share * len(ordered)) - 1)]


def slowest(operations):
    """Says which operation took longest, and what it did."""
    number = max(range(len(operations)), key=lambda i: operations[i])
    _, growth, sectors = operations[number]
    changes = [f"memory {growth / 1e6:+.1f} MB"] if growth else []
    changes += [f"sectors {sectors / 1e6:+.2f} MB"] if sectors else []
    return f"number {number:,}" + (": " + ", ".join(changes) if changes else "")


def microseconds(nanoseconds):
    value = nanoseconds / 1000
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def panel(x0, y0, kind, curves):
    """Draws the percentiles of a kind over the number of vertices; both axes are logarithmic."""
    left, bottom = x0 + LEFT, y0 + HEIGHT - BOTTOM
    width, height = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM
    sizes = [size for size, _ in curves]
    values = [value for _, row in curves for value in row]
    first_x, last_x = math.floor(math.log10(min(sizes)) + 0.1), math.ceil(math.log10(max(sizes)) - 0.1)
    last_x = max(last_x, first_x + 1)
    first_y, last_y = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))

    def place(size, value):
        across = (math.log10(size) - first_x) / (last_x - first_x)
        up = (math.log10(value) - first_y) / (last_y - first_y)
        return left + across * width, bottom - up * height

    out = [text(left + width / 2, y0 + TOP - 12, kind, more=' font-weight="bold"')]
    for power in range(first_x, last_x + 1):
        x, _ = place(10**power, 10**first_y)
        out.append(f'<path d="M{x:.1f} {bottom}V{bottom - height}" stroke="#dddddd"/>')
        out.append(text(x, bottom + 15, f'10<tspan dy="-4" font-size="8">{power}</tspan>'))
    for power in range(first_y, last_y + 1):
        _, y = place(10**first_x, 10.0**power)
        out.append(f'<path d="M{left} {y:.1f}H{left + width}" stroke="#dddddd"/>')
        out.append(text(left - 5, y + 4, f"{10.0 ** power:,.12g}", "end"))
    out.append(text(left + width / 2, bottom + 31, "vertices"))
    for i, (_, _, colour) in enumerate(PERCENTILES):
        points = [place(size, row[i]) for size, row in curves]
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        out.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>')
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in points]
    return out


def draw(results, file):
    kinds = list(results[0][1])
    rows = math.ceil(len(kinds) / COLUMNS)
    width, height = COLUMNS * WIDTH, LEGEND + rows * HEIGHT
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}"'
        ' font-family="sans-serif" font-size="11">',
        f'<rect width="{width}" height="{height}" fill="white"/>',
        text(14, 19, "microseconds for one operation", "start"),
    ]
    for i, (name, _, colour) in enumerate(PERCENTILES):
        out.append(f'<path d="M{220 + 90 * i} 15h22" stroke="{colour}" stroke-width="2"/>')
        out.append(text(247 + 90 * i, 19, name, "start"))
    for i, kind in enumerate(kinds):
        curves = []
        for size, operations in results:
            times = [time for time, _, _ in operations[kind]]
            curves.append((size, [percentile(times, share) / 1000 for _, share, _ in PERCENTILES]))
        out += panel(i % COLUMNS * WIDTH, LEGEND + i // COLUMNS * HEIGHT, kind, curves)
    file.write_text("\n".join([*out, "</svg>", ""]), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--rounds", type=int, default=20000)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--huge", action="store_true")
    options = parser.parse_args()
    names = " | ".join(name for name, _, _ in PERCENTILES)
    print(f"| operation | vertices | number | {names} | the slowest |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: | --- |")
    results = []
    for world, vertices in WORLDS + (HUGE if options.huge else []) + WITH_BRIDGES:
        size, kinds = measure(options.program, world, vertices, options)
        is_plotted = (world, vertices) not in WITH_BRIDGES
        if is_plotted:
            results.append((size, kinds))
        for kind, operations in kinds.items():
            times = [time for time, _, _ in operations]
            cells = " | ".join(microseconds(percentile(times, share)) for _, share, _ in PERCENTILES)
            name = kind if is_plotted else f"{world} with bridges: {kind}"
            print(f"| {name} | {size:,} | {len(times):,} | {cells} | {slowest(operations)} |", flush=True)
    options.folder.mkdir(parents=True, exist_ok=True)
    draw(results, options.folder / "latency.svg")


if __name__ == "__main__":
    main()
