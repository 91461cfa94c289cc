"""Wrong arguments, damaged pickles and careless callbacks: an exception that says what is wrong, and nothing has changed.

A call that does not return would hang the tests, so each of these calls would end in an error of the test run.
"""

import pickle
import random

import numpy as np
import pytest
import waywright
from waywright import Change, PathSearch, PathWatch, Shape, World

STARTS, GOALS = np.full((3000, 2), 10.0), np.full((3000, 2), 90.0)


def test_a_progress_function_may_read_what_its_call_reads(world):
    seen = []
    world.find_paths(STARTS, GOALS, progress=lambda done, total: seen.append(world.find_path((1, 1), (2, 2)).found))
    assert seen and all(seen)


def test_a_progress_function_must_not_change_what_its_call_reads(world):
    before, faults = world.items_hash, []

    def change(done, total):
        try:
            world.remove(1)
        except RuntimeError as error:
            faults.append(str(error))

    world.find_paths(STARTS, GOALS, progress=change)
    assert faults and "must not change the world" in faults[0] and world.items_hash == before
    for bad in (3, "bar"):
        with pytest.raises(TypeError, match="progress must be a function"):
            world.find_paths(STARTS, GOALS, progress=bad)


def test_iterables_may_use_the_world(world):
    path, version = world.find_path((10, 45), (90, 45)), world.version
    assert world.find_affected((path for _ in range(2) if world.insert_segment((30, 0), (30, 60))), version) == [0, 1]
    with pytest.raises(TypeError, match="list of Path"):
        world.find_affected([path, 3], version)


BAD_ARRAYS = [[["a", "b"]], [[1, [2]]], [[1j, 2]], b"ab", np.array([["1", "2"]]), np.array([[1j, 2]])]
BAD_ARRAYS += [np.array([["2020-01-01", "2020-01-02"]], "datetime64[s]"), np.zeros(2, [("x", "f8"), ("y", "f8")])]


@pytest.mark.parametrize("points", BAD_ARRAYS)
def test_arrays_of_no_numbers(world, points):
    before = world.items_hash
    for call in (
        lambda: world.insert_points(points),
        lambda: world.insert_polyline(points),
        lambda: world.find_paths(points, points),
        lambda: world.is_clear(points),
    ):
        with pytest.raises(TypeError, match="points must be numbers") as caught:
            call()
        assert len(str(caught.value)) < 100
    with pytest.raises(TypeError, match="agent must be an Agent"):
        world.find_paths([(1, 1)], [(2, 2)], agent="x")
    assert world.items_hash == before


def test_errors_do_not_print_whole_lists(world):
    with pytest.raises(TypeError) as caught:
        world.find_paths([(1, 1)] * 100_000, [(1, "x")] * 100_000)
    assert "points must be numbers" in str(caught.value) and len(str(caught.value)) < 100
    with pytest.raises(ValueError, match=r"not \(5, 3\)"):
        world.insert_points(np.zeros((5, 3)))
    for threads, kind in ((0, ValueError), (-1, ValueError), (1.5, TypeError), ("2", TypeError), (2**70, OverflowError)):
        with pytest.raises(kind):
            world.find_paths([(1, 1)], [(2, 2)], threads=threads)
        with pytest.raises(kind):
            world.insert_points([(1, 1)], threads=threads)


def test_changes_of_other_types(world):
    for bad in ([3], [None], None, 7):
        calls = [lambda: world.apply(bad), lambda: world.attempt(bad, len), lambda: world.would_disconnect(bad, [(1, 1)])]
        for call in calls:
            with pytest.raises(TypeError, match="changes must be a list of Change"):
                call()
    for bad in (None, world.clone(), 3):
        with pytest.raises(TypeError):
            world.to_svg(paths=[bad])
    for call in (lambda: PathSearch().begin(None, (1, 1), (2, 2)), lambda: PathWatch(None)):
        with pytest.raises(TypeError):
            call()


def test_offsets(world):
    points = [(1, 1), (3, 1), (5, 5), (8, 5)]
    for kind in (np.uint64, np.int32, np.int64):
        assert len(world.insert_ragged("segment", points, np.array([0, 2, 4], kind))) == 2
    assert world.insert_ragged("segment", points, Shape.segment((1, 1), (2, 2)).ring_offsets.tolist()).size == 1
    before = world.items_hash
    for bad in ([0, 1.5, 4], ["a"], None):
        with pytest.raises(TypeError, match="integers"):
            world.insert_ragged("segment", points, bad)
    for bad in ([], [0, 2**62], np.array([0, 2**64 - 1], np.uint64), [-1, 2], [2, 1]):
        with pytest.raises(ValueError, match="ascend"):
            world.insert_ragged("segment", points, bad)
    assert world.items_hash == before


def test_geometries_that_are_none(world):
    before = world.items_hash
    cases = [
        ({}, ValueError, "type of GeoJSON"),
        ({"type": "Polygon"}, ValueError, "needs coordinates"),
        ({"type": "LineString", "coordinates": [[1, 1], [2]]}, ValueError, "pairs of numbers"),
        ({"type": "Feature", "geometry": None}, ValueError, "no geometry"),
        ([(1, 1), (2, 2)], TypeError, "not list"),
        ({"type": "MultiPoint", "coordinates": [[1, 1]]}, ValueError, "insert_all"),
    ]
    for bad, kind, words in cases:
        with pytest.raises(kind, match=words):
            world.insert(bad)
    good = Shape.point((5, 5))
    cases = [
        ([good, {"type": "Polygon"}], ValueError, "item 1: .* needs coordinates"),
        ([good, (7, good), 3], TypeError, "item 2: .* not int"),
        ({"type": "FeatureCollection"}, ValueError, "needs features"),
        ({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": None}]}, ValueError, "item 0: "),
        (5, TypeError, "not int"),
    ]
    for bad, kind, words in cases:
        with pytest.raises(kind, match=words):
            world.insert_all(bad)
    assert world.items_hash == before
    assert world.insert_all([(None, good), (np.int64(9), good)]) == [3, 9]


def test_file_names(world, tmp_path):
    name = tmp_path / "a"
    for call in (world.save, World.load, waywright.read_scene, lambda file: waywright.ReplayWriter(file, world)):
        with pytest.raises(ValueError, match="zero byte"):
            call(f"{name}\0b.wwb")
        with pytest.raises(TypeError):
            call(7)
    world.save(bytes(name))
    assert World.load(name).items_hash == world.items_hash


def test_positions_and_steps(world):
    path, turn = world.find_path((10, 70), (90, 70)), world.find_path((10, 45), (90, 45), waywright.Agent(radius=5))
    with pytest.raises(ValueError, match="not on this path"):
        path.advance(turn.at(80), 1)
    for step in (0.0, -1.0, np.nan, 1e-300):
        with pytest.raises(ValueError, match="step"):
            path.walk(step)
    without_points = world.find_paths_from((10, 70), [(90, 70)])[0]
    for call in (lambda p: p.at(1), lambda p: p.nearest((1, 1)), lambda p: p.walk(1)):
        with pytest.raises(ValueError, match="wants_points"):
            call(without_points)
    with pytest.raises(ValueError, match="wants_points"):
        PathWatch(world).add(1, without_points)


def values_like(value, choose):
    """Returns a damaged version of a pickled value."""
    if isinstance(value, bytes):
        damaged = bytearray(value)
        for _ in range(choose.randint(1, 8) if value else 0):
            damaged[choose.randrange(len(value))] = choose.randrange(256)
        return choose.choice([bytes(damaged), value[: len(value) // 2], value + value, value[:-1], b""])
    if isinstance(value, (tuple, list)) and value:
        place = choose.randrange(len(value))
        return tuple(values_like(each, choose) if i == place else each for i, each in enumerate(value))
    return choose.choice([0, -1, 2**63 - 1, 2**70, 1e308, float("nan"), -1.0, "found", "x", None, (1, 2), b"abc", True])


def use(thing, world):
    """Calls what might trust a damaged object. Exceptions are answers."""
    path, disc = world.find_path((10, 50), (90, 50)), world.find_path((10, 50), (90, 50), waywright.Agent(radius=5))
    calls = [lambda name=name: repr(getattr(thing, name)) for name in dir(thing) if not name.startswith("__")]
    calls += [
        *(lambda: thing.at(3.0), lambda: thing.nearest((3, 3)), lambda: thing.polyline(0.1), lambda: thing.walk(5.0)),
        *(lambda: thing.advance(thing.at(1), 5), lambda: world.is_affected(thing, 0), lambda: world.to_svg(thing)),
        *(lambda: path.advance(thing, 1), lambda: disc.advance(thing, -1e9), lambda: disc.advance(thing, 1e9)),
        *(lambda: PathWatch(world).add(1, thing), lambda: world.clone().insert(thing), lambda: world.clone().apply([thing])),
        *(lambda: thing.centroid(), lambda: hash(thing), lambda: thing.__geo_interface__, lambda: thing.validate()),
    ]
    for call in calls:
        try:
            call()
        except Exception:  # noqa: BLE001, S110
            pass


@pytest.mark.parametrize("seed", range(15))
def test_damaged_pickles(world, seed):
    choose = random.Random(seed)
    things = [
        *(world.find_path((10, 50), (90, 50), waywright.Agent(radius=5)), world.find_path((10, 50), (90, 50), wants_channel=True)),
        *(world.find_path((10, 70), (90, 70), waywright.Agent(radius=30)), world.find_path((10, 50), (90, 50)).at(3)),
        *(world.locate((50, 50)), world.ray((10, 50), (90, 50)), world.fit_disc((38, 50), waywright.Agent(radius=5))),
        world.nearest_fit((45, 50), waywright.Agent(radius=5)),
        *(world.widest_path((10, 70), (90, 70)), world.snapshot(), world.shape(1), Change.replace(1, world.shape(2)), world),
    ]
    for thing in things:
        make, arguments, state = thing.__reduce_ex__(4)[:3]
        for _ in range(6):
            damaged = make(*arguments)
            try:
                damaged.__setstate__(values_like(state, choose))
            except Exception:  # noqa: BLE001, S112
                continue
            use(damaged, world)
        for length in (3, 40, -1):
            with pytest.raises(Exception):  # noqa: B017, PT011
                pickle.loads(pickle.dumps(thing)[:length])
    assert world.validate() is None
