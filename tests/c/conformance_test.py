"""Runs world scripts by the command and through the C interface, and compares all answers and hashes.

usage: conformance_test.py COMMAND RUN_SCRIPT FOLDER FILE_OR_FOLDER...

COMMAND is the program waywright, RUN_SCRIPT the program tests/c/run_script.c. Runs each script twice: as it is, and with a
hash after each operation, many queries between them and a wrong hash of a tick. Writes the longer scripts to FOLDER.
"""

import json
import subprocess
import sys
from pathlib import Path

CHANGES = {"point", "segment", "polyline", "polygon", "remove", "replace"}


def queries_over(box):
    """Yields queries of all kinds, at positions all over a box."""
    x0, y0, x1, y1 = box
    steps = [0.0, 0.137, 0.25, 0.5, 0.6180339887, 0.75, 1.0]
    points = [(x0 + (x1 - x0) * i, y0 + (y1 - y0) * j) for i in steps for j in steps]
    size = min(x1 - x0, y1 - y0)
    for k, (x, y) in enumerate(points):
        u, v = points[(k * 31 + 17) % len(points)]
        radius = size * (k % 5) / 40
        yield f"locate {x!r} {y!r}"
        yield f"ray {x!r} {y!r} {u!r} {v!r}"
        yield f"ray {x!r} {y!r} {u!r} {v!r} {radius!r}"
        yield f"disc {x!r} {y!r} {radius!r}"
        yield f"nearest {x!r} {y!r} {radius!r}"
        yield f"nearest {x!r} {y!r} {radius + size / 100!r} goal {u!r} {v!r}"
        yield f"path {x!r} {y!r} {u!r} {v!r} 0 {('optimal', 'ta', 'tra')[k % 3]}"
        yield f"path {x!r} {y!r} {u!r} {v!r} {radius!r}"
        yield f"path {x!r} {y!r} {u!r} {v!r} 0 optimal tolerance {size!r}"
        yield f"clear 3 {x!r} {y!r} {u!r} {v!r} {x!r} {v!r}"
    yield f"path {x0!r} {y0!r} {x1!r} {y1!r} -1"
    yield f"path {x0!r} {y0!r} {x1!r} {y1!r} 0 optimal tolerance -1"
    yield f"locate {x1 * 2 + 1!r} {y0!r}"


def with_queries(text):
    """Returns a script with hashes after its operations, and queries in its middle and at its end."""
    lines = text.splitlines()
    box = next(list(map(float, line.split()[1:5])) for line in lines if line.split()[:1] == ["domain"])
    operations = sum(line.split()[:1] != [] and line.split()[0] in CHANGES for line in lines)
    result, done = [], 0
    for line in lines:
        result.append(line)
        if line.split()[:1] != [] and line.split()[0] in CHANGES:
            done += 1
            if operations < 200:
                result.append("hash")
            if done == operations // 2:
                result += queries_over(box)
    ticks = ["tick 1", f"tick 2 {'0' * 32}"] if "tick" not in text else []
    return "\n".join([*result, *queries_over(box), "check", "hash", *ticks, ""])


def answers(command):
    run = subprocess.run(command, check=False, capture_output=True, text=True, encoding="utf-8", timeout=600)
    if run.returncode not in (0, 1) or run.stderr:  # 1: a hash is wrong
        sys.exit(f"{' '.join(map(str, command))} ended with {run.returncode}: {run.stderr}")
    return [json.loads(line) for line in run.stdout.splitlines()]


def scripts_of(paths):
    for path in map(Path, paths):
        yield from sorted(path.glob("*.wws")) if path.is_dir() else [path]


def main(arguments):
    command, run_script, folder, *paths = arguments
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    count, kinds = 0, {}
    for script in scripts_of(paths):
        longer = folder / script.name
        longer.write_text(with_queries(script.read_text(encoding="utf-8")), encoding="utf-8")
        for each in (script, longer):
            expected, actual = answers([command, "run", each]), answers([run_script, each])
            for here, there in zip(expected, actual):
                if here != there:
                    sys.exit(f"{each}: the command answers\n{here}\nand C answers\n{there}")
            if len(expected) != len(actual):
                sys.exit(f"{each}: {len(expected)} answers of the command, {len(actual)} of C")
            count += len(expected)
            for answer in expected:
                kinds[answer["op"]] = kinds.get(answer["op"], 0) + 1
    if len(kinds) < 8:
        sys.exit(f"only these operations have answers: {kinds}")
    print(f"{count} equal answers: {kinds}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
