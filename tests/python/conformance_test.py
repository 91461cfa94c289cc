"""All world scripts of the tests give the answers and hashes of the command ``waywright run``.

The command is the program that WAYWRIGHT_COMMAND names; CMake sets it.
"""

import json
import os
import subprocess

import pytest
from conftest import ROOT
from run_script import answers

COMMAND = os.environ.get("WAYWRIGHT_COMMAND")
SCRIPTS = sorted((ROOT / "tests" / "scripts").glob("*.wws"))
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
    return "\n".join([*result, *queries_over(box), "check", "hash", ""])


@pytest.mark.skipif(not COMMAND, reason="WAYWRIGHT_COMMAND does not name the command")
@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
@pytest.mark.parametrize("longer", [False, True], ids=["as it is", "with queries"])
def test_script(script, longer):
    text = script.read_text(encoding="utf-8")
    text = with_queries(text) if longer else text
    command = [COMMAND, "run", "-"]
    run = subprocess.run(command, input=text, capture_output=True, text=True, encoding="utf-8", timeout=600, check=True)
    expected = [json.loads(line) for line in run.stdout.splitlines()]
    actual = list(answers(text, "-"))
    for here, there in zip(expected, actual):
        assert there == here
    assert len(actual) == len(expected)


def test_there_are_scripts():
    assert len(SCRIPTS) > 20
