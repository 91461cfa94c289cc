"""Compares the column of Python in docs/languages.md with the package."""

import importlib
import re

import pytest
import waywright
from conftest import ROOT

ROWS = [
    line.split(" | ")
    for line in (ROOT / "docs" / "languages.md").read_text(encoding="utf-8").splitlines()
    if line.startswith("| ")
]
CELLS = [row[3] for row in ROWS]
NAMES = {name for cell in CELLS for name in re.findall(r"`([\w.]+)`", cell)}
ARGUMENTS = {name for cell in CELLS if cell.startswith("the argument") for name in re.findall(r"`([a-z_]+)`", cell)}

# The classes whose public members the table must name. The members of the other classes are data of an answer.
CLASSES = ["Change", "MeshSnapshot", "Path", "PathBatch", "PathSearch", "PathWatch", "ReplayWriter", "Scene", "Script"]
CLASSES += ["Shape", "Snapshot", "WaywrightError", "World"]
# What only Python has: pictures by matplotlib, GeoJSON for Shapely and others, and the methods of Exception.
ONLY_PYTHON = {"World.plot", "Path.plot", "PathBatch.plot", "World.to_geojson"}
ONLY_PYTHON |= {f"WaywrightError.{name}" for name in dir(Exception)}


def exists(name):
    """Returns whether the package has an object, or a module of Python that the table names: `pickle.dumps`."""
    owner, _, member = name.partition(".")
    if hasattr(waywright, owner):
        return not member or name in members_of(owner)
    if owner == "distributed":
        pytest.importorskip("distributed")
        owner = "waywright.distributed"
    return owner in ("copy", "pickle", "waywright.distributed") and hasattr(importlib.import_module(owner), member)


def members_of(name):
    """Returns the public members of a class, also those that each object gets in __init__()."""
    found = getattr(waywright, name)
    members = {*dir(found), *getattr(found, "__annotations__", {})}
    members |= vars(found("", "")).keys() if found is waywright.WaywrightError else set()
    return {f"{name}.{member}" for member in members if not member.startswith("_")}


def test_the_columns():
    assert ROWS[0] == ["| task", "C++", "C", "Python", "JavaScript |"]
    assert {len(row) for row in ROWS} == {5}


def test_every_name_in_the_table_exists():
    assert len(NAMES) > 100
    others = ARGUMENTS | {"ValueError", "RuntimeError", "__geo_interface__"}
    assert [name for name in sorted(NAMES - others) if not exists(name)] == []
    for name in ARGUMENTS:
        assert re.search(rf"\b{name}: ", waywright.World.to_svg.__doc__), name


def test_the_table_names_every_member_and_every_function():
    missing = {member for name in CLASSES for member in members_of(name)} | set(waywright.__all__)
    missing -= {f"Snapshot.{name.partition('.')[2]}" for name in members_of("World")}
    assert sorted(missing - NAMES - ONLY_PYTHON) == []
    assert not ONLY_PYTHON & NAMES
