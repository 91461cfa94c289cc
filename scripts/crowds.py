#!/usr/bin/env python3
"""Measures a crowd of 1,000 discs of five radii on a map where 10 buildings change in every tick.

usage: crowds.py PROGRAM FOLDER [MAP...] [--ticks N] [--runs N] [--again]

PROGRAM is waywright_crowds. Measures the bundled map and each MAP, a file of Moving AI. Prints two Markdown tables: the
times of ticks, and the times of searches by radius. Draws FOLDER/crowds.svg. Each run is a process of its own. All runs of
a row do the same work. The time of a tick is the least time of this tick in all runs.

  --ticks N  the number of ticks (200); where all units ask for shortest paths, a tenth of them
  --runs N   the number of runs (3)
  --again    measures nothing; prints and draws the results that are in FOLDER
"""

import argparse
import math
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from growth import Progress  # noqa: E402 (it writes no cache beside the scripts)
from plots import figure, logarithmic_axis  # noqa: E402

BUNDLED = Path(__file__).resolve().parent.parent / "examples/maps/highground.wws"
BUNDLED_RADII = ("0.5", "1", "2", "3", "4")
CELL_RADII = ("0.25", "0.5", "1", "2", "4")  # for maps of cells
MODES = {
    "tra": "all, `tra`",
    "two_threads": "all, `tra`, two threads",
    "affected": "the affected, `tra`",
    "optimal": "all, `optimal`",
}
UPDATE = "update"
# Okabe and Ito's colours, which most people with colour blindness can distinguish.
STYLES = {
    "optimal": ("all, optimal", "#d55e00"),
    "tra": ("all, tra", "#0072b2"),
    "two_threads": ("all, tra, 2 threads", "#009e73"),
    "affected": ("the affected, tra", "#e69f00"),
    UPDATE: ("update of the world", "#444444"),
}


class Measurement:
    """The ticks of one map and one mode: the least time of each tick in several runs that do the same work."""

    def __init__(self, texts, radii, mode):
        self.groups = 1 if mode == "two_threads" else len(radii)
        runs = [[line.split("\t") for line in text.splitlines()] for text in texts]
        self.vertices = int(runs[0][0][0])
        counts = [[[int(cell) for cell in row[1 + self.groups :]] for row in run[1:]] for run in runs]
        if any(other != counts[0] for other in counts):
            raise SystemExit("crowds.py: two runs of the same work differ in their answers")
        self.searches = [row[: self.groups] for row in counts[0]]
        self.statuses = [row[self.groups :] for row in counts[0]]
        times = [[[float(cell) for cell in row[: 1 + self.groups]] for row in run[1:]] for run in runs]
        self.updates = [min(row[0] for row in rows) for rows in zip(*times)]
        self.paths = [min(sum(row[1:]) for row in rows) for rows in zip(*times)]
        self.by_radius = [[min(cells) for cells in zip(*(row[1:] for row in rows))] for rows in zip(*times)]

    def search_microseconds(self, group):
        searches = sum(row[group] for row in self.searches)
        return 1e6 * sum(row[group] for row in self.by_radius) / max(searches, 1)


def percentile(values, share):
    """Returns the least value that at least this share of the values does not exceed."""
    return sorted(values)[max(0, math.ceil(share * len(values)) - 1)]


def number(value):
    return f"{value:,.0f}" if value >= 100 else f"{value:#.3g}".rstrip(".")


def milliseconds(values):
    return [number(1000 * value) for value in (percentile(values, 0.5), percentile(values, 0.99), max(values))]


def measure(options, file, mode, progress):
    """Returns the output of each run."""
    radii = BUNDLED_RADII if file == BUNDLED else CELL_RADII
    ticks = max(1, options.ticks // 10) if mode == "optimal" else options.ticks
    texts = []
    for run in range(1, options.runs + 1):
        kept = Path(options.folder) / f"{file.stem}_{mode}_{run}.tsv"
        if not options.again:
            progress.show(f"{file.stem} {mode}, run {run} of {options.runs}")
            command = [options.program, str(file), mode, str(ticks), *radii]
            kept.write_text(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)
        if kept.is_file():
            texts.append(kept.read_text())
    progress.show("")
    if not texts:
        raise SystemExit(f"crowds.py: {options.folder} has no results for {file.stem}, {mode}; measure without --again")
    return Measurement(texts, radii, mode)


def print_ticks(measured):
    print("| map | who asks | ticks | path time, ms: p50 | p99 | max | update time, ms: p50 | p99 | max | searches a tick "
          "| µs a search | µs a change | found | blocked | no path |")
    print("| --- | --- |" + " ---: |" * 13)
    for (name, mode), ticks in measured.items():
        count = len(ticks.updates)
        searches = sum(map(sum, ticks.searches))
        found, *blocked, none = (sum(column) / sum(map(sum, ticks.statuses)) for column in zip(*ticks.statuses))
        cells = [name, MODES[mode], str(count), *milliseconds(ticks.paths), *milliseconds(ticks.updates),
                 f"{searches / count:,.0f}", number(1e6 * sum(ticks.paths) / searches),
                 number(1e6 * sum(ticks.updates) / (20 * count)),
                 *(f"{100 * share:.1f} %" for share in (found, sum(blocked), none))]
        print("| " + " | ".join(cells) + " |")


def print_radii(measured):
    print("\n| map | who asks | µs a search, by radius | | | | |\n| --- | --- |" + " ---: |" * 5)
    for (name, mode), ticks in measured.items():
        if ticks.groups == 1:
            continue
        radii = BUNDLED_RADII if name == BUNDLED.stem else CELL_RADII
        cells = [f"{radius}: {number(ticks.search_microseconds(group))}" for group, radius in enumerate(radii)]
        print(f"| {name} | {MODES[mode]} | " + " | ".join(cells) + " |")


def curve(values):
    """Returns the sorted values in milliseconds against the share of values that they are not below, in per cent."""
    return [(100 * (i + 1) / len(values), 1000 * value) for i, value in enumerate(sorted(values))]


def draw(measured):
    panels = []
    for name in dict.fromkeys(name for name, _ in measured):
        curves = {mode: curve(ticks.paths) for (other, mode), ticks in measured.items() if other == name}
        curves[UPDATE] = curve(measured[name, "tra"].updates)
        title = f"{name}: {measured[name, 'tra'].vertices:,} vertices"
        panels.append((curves, title, "% of ticks that take no longer", "ms a tick"))
    return figure(panels, STYLES, logarithmic_axis, has_dots=False)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("maps", type=Path, nargs="*")
    parser.add_argument("--ticks", type=int, default=200)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--again", action="store_true")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    progress = Progress()
    rows = [(file, mode) for file in (BUNDLED, *options.maps) for mode in MODES]
    measured = {(file.stem, mode): measure(options, file, mode, progress) for file, mode in rows}
    print_ticks(measured)
    print_radii(measured)
    (options.folder / "crowds.svg").write_text(draw(measured), encoding="utf-8")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(error.returncode)  # the program has said why
