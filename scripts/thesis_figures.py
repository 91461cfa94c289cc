#!/usr/bin/env python3
"""Draws the figures of Chen's thesis again, with the library's curves in them.

usage: thesis_figures.py FOLDER PICTURES

FOLDER contains the results of scripts/thesis.py, one JSON file for each experiment. Writes an SVG file into PICTURES for
each of these files. A contender that failed at a size has no point there.
"""

import sys
from pathlib import Path

sys.dont_write_bytecode = True
from bench_ratios import has_failed, median_time, read_runs  # noqa: E402 (it writes no cache beside the scripts)
from plots import figure  # noqa: E402

# Okabe and Ito's colours, which most people with colour blindness can distinguish.
CONTENDERS = {
    "waywright": ("Waywright", "#0072b2"),
    "double": ("double", "#d55e00"),
    "interval_exact": ("interval + exact", "#009e73"),
    "last_face": ("last face", "#d55e00"),
    "cube_root": ("cube-root sampling", "#e69f00"),
    "sectors_16": ("16 × 16 sectors", "#009e73"),
}

# For each experiment its panels: the workload, the title, the labels of the x axis and the y axis.
FIGURES = {
    "location": [("location", "Experiment 2: location", "points", "µs a query")],
    "insertion": [("insertion", "Experiment 3: insertion", "points", "µs a point")],
    "points": [("points", "Experiment 4: points", "points", "µs a point")],
    "constraints": [
        ("short_segments", "Experiment 5: short, axis-aligned", "constraints", "µs a constraint"),
        ("long_segments", "long, axis-aligned", "constraints", "µs a constraint"),
        ("random_segments", "random", "constraints", "µs a constraint"),
    ],
    "moving": [
        ("moving_square_aligned", "Experiment 6: axis-aligned", "steps", "µs a step"),
        ("moving_square_45", "turned by 45°", "steps", "µs a step"),
    ],
}


def read_curves(file, workload):
    """Returns {contender: [(size, microseconds), ...]} by size."""
    curves = {}
    for name, contenders in read_runs([file]).items():
        head, size = name.rsplit("/", 1)
        if head != workload:
            continue
        for contender, runs in contenders.items():
            if not has_failed(runs):
                curves.setdefault(contender, []).append((int(size), median_time(runs)))
    return {contender: sorted(curve) for contender, curve in curves.items()}


def draw(file, panels):
    """Returns the SVG text of a figure, or None if nothing was measured."""
    drawn = [(read_curves(file, workload), *labels) for workload, *labels in panels]
    drawn = [entry for entry in drawn if entry[0]]
    if not drawn:
        return None
    return figure(drawn, CONTENDERS)


def main(arguments):
    if len(arguments) != 2 or arguments[0].startswith("-"):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    folder, pictures = map(Path, arguments)
    for name, panels in FIGURES.items():
        file = folder / f"{name}.json"
        picture = draw(file, panels) if file.is_file() else None
        if picture:
            (pictures / f"thesis_{name}.svg").write_text(picture, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
