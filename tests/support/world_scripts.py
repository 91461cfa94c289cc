"""World scripts for the tests of all languages: more queries for each script, known answers, the answers of a program."""

import json
import subprocess
import sys

CHANGES = {"point", "segment", "polyline", "polygon", "remove", "replace"}
KNOWN = "# answers "


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


def check_known(script, text, found):
    """Compares answers with those in the comments of a script, if it has any. A comment names at least one member."""
    known, number = {}, 0
    for index, line in enumerate(text.splitlines(), 1):
        if line.startswith(KNOWN):
            known[number] = json.loads(line.removeprefix(KNOWN))
        else:
            number = index
    if not known:
        return
    lines = [answer["line"] for answer in found]
    if lines != sorted(known):
        sys.exit(f"{script}: answers of the lines {lines}, and known answers of the lines {sorted(known)}")
    for answer in found:
        wanted = known[answer["line"]]
        if not wanted or answer != {**answer, **wanted}:
            sys.exit(f"{script}: the command answers\n{answer}\ninstead of\n{wanted}")


def answers(command):
    run = subprocess.run(command, check=False, capture_output=True, text=True, encoding="utf-8", timeout=600)
    if run.returncode not in (0, 1) or run.stderr:  # 1: a hash is wrong
        sys.exit(f"{' '.join(map(str, command))} ended with {run.returncode}: {run.stderr}")
    return [json.loads(line) for line in run.stdout.splitlines()]
