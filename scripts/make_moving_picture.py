#!/usr/bin/python3
"""Makes the moving picture of README.md from the frames that playground/record.mjs has taken.

usage: make_moving_picture.py FOLDER PICTURE
"""

import sys
from pathlib import Path

from PIL import Image

WIDTH = 800
MILLISECONDS_PER_FRAME = 90
MILLISECONDS_AT_END = 1500


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    paths = sorted(Path(sys.argv[1]).glob("*.png"))
    if not paths:
        print(f"make_moving_picture.py: {sys.argv[1]} has no frames; take them with playground/record.mjs", file=sys.stderr)
        return 1
    frames = []
    for path in paths:
        with Image.open(path) as image:
            height = round(image.height * WIDTH / image.width)
            frames.append(image.convert("RGB").resize((WIDTH, height), Image.Resampling.LANCZOS))
    durations = [MILLISECONDS_PER_FRAME] * (len(frames) - 1) + [MILLISECONDS_AT_END]
    frames[0].save(sys.argv[2], save_all=True, append_images=frames[1:], duration=durations, loop=0, quality=60, method=6)
    print(f"{sys.argv[2]}: {len(frames)} frames, {Path(sys.argv[2]).stat().st_size:,} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
