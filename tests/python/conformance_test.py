"""All world scripts of the tests give the answers and hashes of the command ``waywright run``.

The command is the program that WAYWRIGHT_COMMAND names; CMake sets it.
"""

import os
import sys

import pytest
from conftest import ROOT
from run_script import answers

sys.path.append(str(ROOT / "tests" / "support"))
import world_scripts  # noqa: E402

COMMAND = os.environ.get("WAYWRIGHT_COMMAND")
SCRIPTS = [*sorted((ROOT / "tests" / "scripts").glob("*.wws")), ROOT / "examples" / "maps" / "rocks.wws"]


@pytest.mark.skipif(not COMMAND, reason="WAYWRIGHT_COMMAND does not name the command")
@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
@pytest.mark.parametrize("longer", [False, True], ids=["as it is", "with queries"])
def test_script(script, longer, tmp_path):
    text = script.read_text(encoding="utf-8")
    if longer:
        text, script = world_scripts.with_queries(text), tmp_path / script.name
        script.write_text(text, encoding="utf-8")
    expected, actual = world_scripts.answers([COMMAND, "run", script]), list(answers(text, str(script)))
    for here, there in zip(expected, actual):
        assert there == here
    assert len(actual) == len(expected)


def test_there_are_scripts():
    assert len(SCRIPTS) > 30
