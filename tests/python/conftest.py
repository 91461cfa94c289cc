"""What the tests of the Python package share."""

import os
import sys
from pathlib import Path

import pytest

import waywright

ROOT = Path(__file__).resolve().parents[2]
# Children that a test starts find the package where this process has found it.
os.environ["PYTHONPATH"] = os.pathsep.join(
    [str(Path(waywright.__file__).parents[1]), *filter(None, [os.environ.get("PYTHONPATH")])]
)


@pytest.fixture
def world():
    """The world of the examples: a house, a wall, and bridges."""
    made = waywright.World((0, 0, 100, 100), keep_bridges=True)
    made.insert_polygon([(40, 40), (60, 40), (60, 60), (40, 60)], id=1)
    made.insert_segment((20, 80), (80, 80))
    return made


@pytest.fixture
def python():
    """The interpreter for children."""
    return sys.executable
