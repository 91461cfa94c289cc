#!/usr/bin/env python3
"""Draws the figures of Chen's thesis again, with the library's curves in them.

usage: thesis_figures.py FOLDER PICTURES

FOLDER contains the results of scripts/thesis.py, one JSON file for each experiment. Writes an SVG file into PICTURES for
each of these files. A contender that failed at a size has no point there.
"""

import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from bench_ratios import has_failed, median_time, read_runs  # noqa: E402 (it writes no cache beside the scripts)

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

WIDTH, HEIGHT = 330, 300  # of a panel
LEFT, RIGHT, TOP, BOTTOM = 58, 26, 34, 46  # around its plot
LEGEND, LEGEND_ENTRY = 26, 160  # its height, the width of an entry


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


def round_step(span, count):
    """Returns the step of 1, 2 or 5 times a power of ten that divides `span` into about `count` intervals."""
    rough = span / count
    power = 10.0 ** math.floor(math.log10(rough))
    return next(factor * power for factor in (1, 2, 5, 10) if factor * power >= rough)


def text(x, y, content, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{content}</text>'


def panel(curves, x0, y0, title, along, up):
    left, bottom = x0 + LEFT, y0 + HEIGHT - BOTTOM
    width, height = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM
    most_x = max(x for curve in curves.values() for x, _ in curve)
    most_y = max(y for curve in curves.values() for _, y in curve)
    step_x, step_y = round_step(most_x, 5), round_step(most_y * 1.05, 5)
    end_y = step_y * math.ceil(most_y * 1.02 / step_y)

    def place(x, y):
        return left + width * x / most_x, bottom - height * y / end_y

    parts = [text(left + width / 2, y0 + 20, title, more=' font-weight="bold"')]
    for i in range(round(end_y / step_y) + 1):
        _, y = place(0, i * step_y)
        parts.append(f'<path d="M{left:.1f} {y:.1f}h{width}" stroke="#ddd"/>')
        parts.append(text(left - 6, y + 4, f"{i * step_y:,.10g}", "end"))
    for i in range(int(most_x / step_x) + 1):
        x, _ = place(i * step_x, 0)
        parts.append(f'<path d="M{x:.1f} {bottom:.1f}v4" stroke="#444"/>')
        parts.append(text(x, bottom + 18, f"{i * step_x:,.0f}"))
    parts.append(f'<path d="M{left:.1f} {bottom:.1f}h{width}" stroke="#444"/>')
    parts.append(text(left + width / 2, bottom + 36, along))
    middle = y0 + TOP + height / 2
    parts.append(text(x0 + 14, middle, up, more=f' transform="rotate(-90 {x0 + 14:.1f} {middle:.1f})"'))
    for contender in CONTENDERS:
        if contender not in curves:
            continue
        colour = CONTENDERS[contender][1]
        places = [place(x, y) for x, y in curves[contender]]
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>')
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="{colour}"/>' for x, y in places]
    return parts


def legend(names, width):
    parts = []
    x = max(10.0, (width - LEGEND_ENTRY * len(names)) / 2)
    for name in names:
        label, colour = CONTENDERS[name]
        parts.append(f'<path d="M{x:.1f} 14h22" stroke="{colour}" stroke-width="3"/>')
        parts.append(text(x + 28, 18, label, "start"))
        x += LEGEND_ENTRY
    return parts


def draw(file, panels):
    """Returns the SVG text of a figure, or None if nothing was measured."""
    drawn = [(read_curves(file, workload), *labels) for workload, *labels in panels]
    drawn = [entry for entry in drawn if entry[0]]
    if not drawn:
        return None
    names = [name for name in CONTENDERS if any(name in curves for curves, *_ in drawn)]
    width = max(WIDTH * len(drawn), LEGEND_ENTRY * len(names) + 20)
    start = (width - WIDTH * len(drawn)) / 2
    parts = legend(names, width)
    for i, (curves, title, along, up) in enumerate(drawn):
        parts += panel(curves, start + i * WIDTH, LEGEND, title, along, up)
    height = HEIGHT + LEGEND
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
        'font-family="sans-serif" font-size="12" fill="#222">\n<rect width="100%" height="100%" fill="white"/>\n'
    )
    return head + "\n".join(parts) + "\n</svg>\n"


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
