#!/usr/bin/env python3
"""Makes the pictures that README.md and docs/ show, or checks that they are up to date.

usage: make_pictures.py [--check] COMMAND DRAW_UNITS

COMMAND is the program waywright, DRAW_UNITS the example draw_units. Draws each picture as SVG and converts it to
docs/images/NAME.png (needs rsvg-convert and pngquant). docs/images/pictures.sha256 contains two hashes for each picture: of
the SVG text, which is the same on every machine, and of the PNG file, whose bytes depend on the converter's version.

--check draws every SVG text anew and compares hashes. It needs no converter. If pictures are out of date, it prints their
names and exits 1; otherwise it exits 0.
"""

import hashlib
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MAP = "examples/maps/highground.wws"
ROCKS = "examples/maps/rocks.wws"
ROCKS_ENDS = ("12", "40", "108", "40")
ADVICE = "run ./dev pictures, and look at what it makes"


def demo_ends(root):
    """Returns the ends of the path that ./dev demo finds, as arguments."""
    text = (root / "dev").read_text(encoding="utf-8")
    start, goal = (re.search(rf"^demo_{end}=\((.*)\)$", text, re.M).group(1).split() for end in ("from", "to"))
    return ["--from", *start, "--to", *goal]


def three_paths(root):
    """Returns the bundled map's script with one query for each algorithm at its end."""
    queries = [f"path 198 360 500 261 0 {algorithm}\n" for algorithm in ("optimal", "ta", "tra")]
    return (root / MAP).read_text(encoding="utf-8") + "".join(queries)


def four_discs(root):
    """Returns the script of the map of rocks with one query for each of four radii at its end."""
    queries = [f"path {' '.join(ROCKS_ENDS)} {radius}\n" for radius in (1, 2.5, 5, 9)]
    return (root / ROCKS).read_text(encoding="utf-8") + "".join(queries)


class Pictures:
    """Draws each picture as SVG text into a folder."""

    def __init__(self, root, command, draw_units, folder):
        self.root = root
        self.command = command
        self.draw_units = draw_units
        self.folder = Path(folder)

    def run(self, *arguments):
        subprocess.run(arguments, cwd=self.root, check=True, stdout=subprocess.DEVNULL)

    def draw_all(self):
        """Returns the SVG texts by name."""
        script = self.folder / "paths.wws"
        script.write_text(three_paths(self.root), encoding="utf-8")
        self.waywright("demo", "path", MAP, *demo_ends(self.root), "--theme", "light")
        self.waywright("dark", "path", MAP, *demo_ends(self.root), "--theme", "dark", "--crop", "30", "20", "190", "120")
        self.waywright("paths", "run", str(script), "--theme", "light")
        self.waywright("queries", "run", "docs/images/queries.wws", "--theme", "light")
        script = self.folder / "discs.wws"
        script.write_text(four_discs(self.root), encoding="utf-8")
        self.waywright("discs", "run", str(script), "--theme", "light", "--no-mesh")
        ends = ["--from", *ROCKS_ENDS[:2], "--to", *ROCKS_ENDS[2:]]
        self.waywright("discs_gap", "path", ROCKS, *ends, "--radius", "10", "--theme", "light", "--no-mesh")
        self.run(self.draw_units, str(self.folder / "units.svg"))
        return {file.stem: file.read_bytes() for file in sorted(self.folder.glob("*.svg"))}

    def waywright(self, name, *arguments):
        self.run(self.command, *arguments, "--svg", str(self.folder / f"{name}.svg"))


def draw_all(root, command, draw_units):
    with tempfile.TemporaryDirectory() as folder:
        return Pictures(root, command, draw_units, folder).draw_all()


def hash_of(data):
    return hashlib.sha256(data).hexdigest()


def png_of(root, name):
    return root / "docs" / "images" / f"{name}.png"


def read_hashes(root):
    """Returns the stored hashes by name: of the SVG text and of the PNG file."""
    lines = (root / "docs/images/pictures.sha256").read_text(encoding="utf-8").splitlines()
    rows = [line.split() for line in lines if line and not line.startswith("#")]
    return {name: (svg, png) for svg, png, name in rows}


def convert(root, texts):
    rows = ["# hash of the SVG text, hash of the PNG file, name: written by scripts/make_pictures.py\n"]
    for name, text in texts.items():
        drawn = subprocess.run(["rsvg-convert"], input=text, check=True, stdout=subprocess.PIPE).stdout
        png = subprocess.run(["pngquant", "--nofs", "256", "-"], input=drawn, check=True, stdout=subprocess.PIPE).stdout
        png_of(root, name).write_bytes(png)
        rows.append(f"{hash_of(text)} {hash_of(png)} {name}\n")
    (root / "docs/images/pictures.sha256").write_text("".join(rows), encoding="utf-8")


def faults_of(root, texts):
    """Returns a line for each picture that is out of date."""
    kept = read_hashes(root)
    faults = []
    for name in sorted(texts.keys() | kept.keys()):
        png = png_of(root, name)
        shown = png.relative_to(root)
        if name not in kept or not png.is_file():
            faults.append(f"{shown}: is missing; {ADVICE}")
        elif name not in texts:
            faults.append(f"{shown}: nothing draws it any more; remove it, its line in pictures.sha256, and links to it")
        elif hash_of(texts[name]) != kept[name][0]:
            faults.append(f"{shown}: is stale, the picture drawn now is another one; {ADVICE}")
        elif hash_of(png.read_bytes()) != kept[name][1]:
            faults.append(f"{shown}: was changed by hand; {ADVICE}")
    table = (root / "docs/paths.md").read_text(encoding="utf-8")
    for length in re.findall(r">path, length ([0-9.]+)</text>", texts["paths"].decode("utf-8")):
        if f"| {length} |" not in table:
            faults.append(f"docs/paths.md: its table lacks the length {length}, which its picture shows")
    return faults


def main(arguments):
    is_check = arguments[:1] == ["--check"]
    if len(arguments) != 2 + is_check:
        print(__doc__, file=sys.stderr)
        return 2
    command, draw_units = (str(Path(program).resolve()) for program in arguments[-2:])
    texts = draw_all(ROOT, command, draw_units)
    if not is_check:
        convert(ROOT, texts)
    faults = faults_of(ROOT, texts)
    print("".join(f"{fault}\n" for fault in faults), end="", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
