"""The examples in docstrings and in docs/python.md run as printed."""

import doctest
import inspect
import pydoc
import re

import numpy as np
import pytest
import waywright
from conftest import ROOT

FLAGS = doctest.ELLIPSIS | doctest.IGNORE_EXCEPTION_DETAIL | doctest.NORMALIZE_WHITESPACE


def make_world():
    world = waywright.World((0, 0, 100, 100), keep_bridges=True)
    world.insert_polygon([(40, 40), (60, 40), (60, 60), (40, 60)], id=1)
    world.insert_segment((20, 80), (80, 80))
    return world


def documented():
    """Yields the public objects of the package and their members, with their names."""
    yield "waywright", waywright
    for name in waywright.__all__:
        thing = getattr(waywright, name)
        yield name, thing
        if inspect.isclass(thing):
            for member, value in vars(thing).items():
                if not member.startswith("_"):
                    yield f"{name}.{member}", value


EXAMPLES = {name: thing.__doc__ for name, thing in documented() if ">>>" in (thing.__doc__ or "")}


def run(text, name, **names):
    names = {"waywright": waywright, "np": np, **names}
    test = doctest.DocTestParser().get_doctest(inspect.cleandoc(text), names, name, name, 0)
    report = []
    result = doctest.DocTestRunner(optionflags=FLAGS).run(test, out=report.append)
    assert result.failed == 0, "".join(report)
    return result.attempted


@pytest.mark.parametrize("name", EXAMPLES)
def test_docstring(name):
    assert run(EXAMPLES[name], name, world=make_world()) > 0


def test_there_are_many_examples_and_every_method_has_a_docstring():
    assert len(EXAMPLES) > 40
    for name, thing in documented():
        if "." in name or inspect.isclass(thing):
            if isinstance(thing, (int, float, tuple)) or type(thing).__name__ == "_tuplegetter":
                continue
            assert thing.__doc__, f"{name} has no docstring"
    assert "find_path" in pydoc.render_doc(waywright.World)


def test_the_guide_runs_as_printed(tmp_path, monkeypatch):
    text = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```pycon\n(.*?)```", text, re.DOTALL)
    names = {}
    assert len(blocks) > 5
    for block in blocks:
        test = doctest.DocTestParser().get_doctest(block, names, "docs/python.md", "docs/python.md", 0)
        test.globs = names  # the blocks continue each other
        report = []
        result = doctest.DocTestRunner(optionflags=FLAGS).run(test, out=report.append, clear_globs=False)
        assert result.failed == 0, "".join(report)
