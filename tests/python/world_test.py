"""Worlds, items, changes and queries."""

import copy
import pickle

import numpy as np
import pytest
import waywright
from waywright import Change, Shape, World


def test_ids_and_facts(world):
    assert world.insert_point((5, 5)) == 3
    assert world.insert_polyline([(1, 1), (2, 2), (3, 1)], id=20) == 20
    assert world.item_count == 4
    assert world.item_ids().tolist() == [1, 2, 3, 20]
    assert 20 in world and 21 not in world
    assert world.largest_id_seen == 20
    world.reserve_ids(99)
    assert world.insert_point((6, 6)) == 100
    assert world.domain == (0, 0, 100, 100)
    assert world.validate() is None
    assert "5 items" in repr(world)


def test_bad_arguments_are_type_errors(world):
    for bad in ("ab", (1,), (1, 2, 3), None, ("1", "2"), 7):
        with pytest.raises(TypeError):
            world.insert_point(bad)
    with pytest.raises(TypeError):
        world.remove("1")
    with pytest.raises(TypeError):
        world.remove(1.0)
    with pytest.raises(TypeError):
        world.find_path((0, 0), (1, 1), algoritm="ta")
    with pytest.raises(ValueError, match="'ta', 'tra', 'optimal'"):
        world.find_path((0, 0), (1, 1), algorithm="best")
    with pytest.raises(ValueError, match="shape"):
        world.insert_points([(1, 2, 3)])


def test_errors_have_a_code_an_index_and_an_item(world):
    before = world.items_hash
    with pytest.raises(waywright.BadValueError) as caught:
        world.insert_points([(1, 1), (2, 2), (200, 1)])
    assert (caught.value.code, caught.value.index) == ("out-of-domain", 2)
    assert isinstance(caught.value, ValueError) and "outside the domain" in str(caught.value)
    with pytest.raises(KeyError) as caught:
        world.apply([Change.remove(1), Change.remove(77)])
    assert (caught.value.code, caught.value.index, caught.value.item) == ("unknown-id", 1, 77)
    with pytest.raises(waywright.IdInUseError):
        world.insert_point((1, 1), id=1)
    for number in (-1, 2**63, 2**70, -(2**70)):
        with pytest.raises(waywright.BadValueError) as caught:
            world.remove(number)
        assert caught.value.code == "bad-id"
    with pytest.raises(OSError):
        World.load("/nowhere/at/all.wwb")
    with pytest.raises(waywright.TickError):
        world.rewind(1)
    with pytest.raises(waywright.NotSupportedError):
        World((0, 0, 1, 1)).widest_path((0.2, 0.2), (0.8, 0.8))
    assert world.items_hash == before


def test_errors_pickle():
    for error in (
        waywright.FileError("unreadable", "x: cannot be read", 3, 4),
        waywright.UnknownIdError("unknown-id", "no item has id 4", 0, 4),
    ):
        other = pickle.loads(pickle.dumps(error))
        assert type(other) is type(error)
        assert (other.code, str(other), other.index, other.item) == (error.code, str(error), error.index, error.item)


def test_broken_preconditions_are_exceptions(world):
    with pytest.raises(ValueError):
        world.mark()
    with pytest.raises(ValueError):
        world.find_path((50, 50), (1, 1)).at(3)
    with pytest.raises(ValueError):
        world.insert_points([(1, 1)], threads=0)
    with pytest.raises(ValueError):
        world.find_paths([(1, 1)], [(2, 2)], threads=0)
    with pytest.raises(ValueError):
        waywright.ReplayWriter("/dev/null", world, 0)


def test_pickle_and_copy(world):
    world.insert_all([Shape.polygon([[(5, 5), (30, 5), (30, 30)], [(10, 8), (20, 8), (20, 12)]], fill="nonzero")])
    world.reserve_ids(500)
    world.new_vertex_limit = 1000
    for other in (pickle.loads(pickle.dumps(world)), copy.copy(world), copy.deepcopy(world), world.clone()):
        assert other.items_hash == world.items_hash
        assert other.mesh_hash() == world.mesh_hash()
        assert other.options == world.options
        assert other.new_vertex_limit == 1000
        assert other.insert_point((1, 1)) == 501
    assert 501 not in world


def test_other_objects_pickle(world):
    path = world.find_path((10, 50), (90, 50), agent=waywright.Agent(radius=5))
    for each in (
        path,
        world.find_path((10, 50), (90, 50), wants_channel=True),
        world.find_path((50, 50), (90, 50)),
        world.find_path((10, 70), (90, 70), agent=waywright.Agent(radius=30)),
        path.at(3),
        world.ray((10, 50), (90, 50)),
        world.fit_disc((38, 50), waywright.Agent(radius=5)),
        world.nearest_fit((45, 50), waywright.Agent(radius=5)),
        world.widest_path((10, 70), (90, 70)),
        world.locate((50, 50)),
        world.snapshot(),
        world.shape(1),
        Change.replace(1, world.shape(2)),
    ):
        other = pickle.loads(pickle.dumps(each))
        assert repr(other) == repr(each)
        for name in (name for name in dir(each) if not name.startswith("_")):
            value = getattr(each, name)
            if not callable(value):
                assert np.array_equal(getattr(other, name), value) or repr(getattr(other, name)) == repr(value), name


def test_saved_files(world, tmp_path):
    world.save(tmp_path / "a.wwb")
    done = []
    other = World.load(tmp_path / "a.wwb", threads=2, progress=lambda *numbers: done.append(numbers))
    assert other.items_hash == world.items_hash and other.to_bytes() == world.to_bytes()
    assert done and done[-1][0] == done[-1][1]
    with pytest.raises(ValueError) as caught:
        World.from_bytes(world.to_bytes()[:-1])
    assert caught.value.code == "malformed"
    with pytest.raises(ValueError):
        World.from_bytes(world.to_bytes() + b"x")


def test_history_and_attempts(world, tmp_path):
    world.keep_history(4)
    tick, before = world.mark(), world.items_hash
    world.apply([Change.remove(1), Change.insert(Shape.point((3, 3)), 9), Change.replace(2, Shape.point((4, 4)))])
    assert world.items_hash != before
    world.rewind(tick)
    assert world.items_hash == before
    changed = world.attempt([Change.remove(1)], lambda w: (w.item_count, len(w.find_paths([(1, 1)], [(9, 9)], threads=2))))
    assert changed == (1, 1)
    with pytest.raises(ZeroDivisionError):
        world.attempt([Change.remove(1)], lambda w: 1 / 0)
    for forbidden in (lambda w: w.remove(2), lambda w: w.attempt([], print), lambda w: w.clone(), lambda w: w.mark()):
        with pytest.raises(RuntimeError):
            world.attempt([Change.remove(1)], forbidden)
    with pytest.raises(RuntimeError):
        world.attempt([], lambda w: waywright.PathSearch().begin(w, (1, 1), (2, 2)))
    with pytest.raises(RuntimeError):
        world.attempt([], lambda w: waywright.PathWatch(w))
    log_file = tmp_path / "log.wws"
    with pytest.raises(RuntimeError):
        world.attempt([], lambda w: waywright.ReplayWriter(log_file, w))
    with waywright.ReplayWriter(log_file, world) as log, pytest.raises(RuntimeError):
        world.attempt([], log.tick)
    assert world.items_hash == before
    world.remove(2)


def test_a_progress_function_must_not_use_the_world(world):
    before = world.items_hash
    points = np.random.default_rng(5).uniform(0, 100, (300_000, 2))
    with pytest.raises(RuntimeError, match="progress"):
        world.insert_points(points, progress=lambda done, total: world.item_count)
    with pytest.raises(ZeroDivisionError):
        world.insert_points(points, progress=lambda done, total: 1 / 0)
    assert world.items_hash == before


def test_what_has_changed(world):
    before = world.version
    path = world.find_path((10, 45), (90, 45))
    world.insert_segment((50, 35), (50, 39))
    far = world.find_path((1, 1), (2, 2))
    assert world.is_affected(path, before) is False
    world.insert_segment((50, 30), (50, 45))
    assert world.is_affected(path, before) and world.is_affected(path.points, before)
    assert world.find_affected([far, path], before) == [1]
    assert [box.box for box in world.changes_since(before)] == [(50, 35, 50, 39), (50, 30, 50, 45)]
    assert world.changes_since(world.version) == []


def test_queries(world):
    assert world.locate((40, 40)).kind == "vertex"
    assert world.locate((50, 40)).polygons == [1]
    assert world.items_at((50, 80)) == [2]
    assert world.items_in((0, 0, 100, 50)).tolist() == [1]
    hit = world.ray((10, 50), (90, 50))
    assert hit and (hit.at, hit.contact, hit.items) == ((40, 50), (40, 50), [1])
    assert not world.ray((10, 10), (90, 10))
    assert world.ray((10, 50), (90, 50), waywright.Agent(radius=5)).contact == (40, 50)
    assert world.fit_disc((2, 50), waywright.Agent(radius=5)).items == [0]
    assert world.nearest_fit((45, 50), waywright.Agent(radius=5), goal=(10, 10)).at == (35, 50)
    assert not world.nearest_fit((45, 50), waywright.Agent(radius=5), limit=2)
    widest = world.widest_path((10, 70), (90, 70))
    assert widest.is_connected and widest.is_limited and widest.radius == 20 and widest.gap[0][1] == 40 or widest.gap


def test_bridges():
    world = World((0, 0, 100, 100), keep_bridges=True)
    world.insert_polygon([(40, 40), (60, 40), (60, 60), (40, 60)])
    found = world.bridges()
    assert len(found) == 8 and found.have_foot.all() and found.radii.tolist() == 8 * [20]
    assert found.ends[0].tolist() == [[40, 40], [0, 40]]
    assert found.ids.tolist() == 8 * [1, 0] and found.id_offsets.tolist() == list(range(17))
    assert found == world.publish().bridges((-9, -9, 109, 109)) == pickle.loads(pickle.dumps(found))
    assert world.bridges((20, 30, 30, 50)).ends.tolist() == [[[40, 40], [0, 40]]]
    assert len(world.bridges((20, 45, 30, 50))) == 0 and world.bridges((20, 45, 30, 50)).ends.shape == (0, 2, 2)
    with pytest.raises(waywright.NotSupportedError):
        World((0, 0, 1, 1)).bridges()


def test_windows_of_a_search(world):
    search = waywright.PathSearch()
    for wanted in (False, True):
        search.record_windows(wanted)
        search.begin(world, (10, 45), (90, 45))
        while not search.step(1):
            pass
        assert not wanted or len(search.windows) >= search.path.expansions > 0
        assert wanted or len(search.windows) == 0
    windows = search.windows
    assert windows.dtype == waywright.WINDOW_DTYPE and search.path.points.tolist()[1] == [40, 40]
    assert windows["root"][0].tolist() == [10, 45] and windows["length"][0] == 0
    turned = windows[(windows["root"] == (40, 40)).all(axis=1)]
    assert len(turned) > 0 and np.allclose(turned["length"], np.hypot(30, 5))
    assert (windows["bound"] >= windows["length"]).all()
    for edge, interval in zip(windows["edge"], windows["interval"]):
        (x, y), (along_x, along_y) = edge[0], edge[1] - edge[0]
        assert np.allclose(along_x * (interval[:, 1] - y), along_y * (interval[:, 0] - x))


def test_limits():
    world = World((0, 0, 100, 100), new_vertex_limit=3)
    world.insert_segment((10, 50), (90, 50))
    world.insert_segment((50, 10), (50, 90))
    with pytest.raises(waywright.LimitError):
        world.insert_segment((20, 40), (60, 60))
    world.new_vertex_limit = None
    world.insert_segment((20, 40), (60, 60))
    assert world.memory()["total"] > 0
    world.shrink_to_fit()


def test_shapes():
    shape = Shape.polygon([[(0, 0), (9, 0), (9, 9)], [(3, 2), (4, 2), (4, 3)]])
    assert [len(ring) for ring in shape.rings] == [3, 3] and shape.ring_offsets.tolist() == [0, 3, 6]
    assert shape == Shape.polygon([np.array([(0, 0), (9, 0), (9, 9)]), [(3, 2), (4, 2), (4, 3)]])
    assert hash(shape) == hash(pickle.loads(pickle.dumps(shape))) and shape != shape.translated(1, 0)
    assert Shape.polygon(np.array([(0, 0), (9, 0), (9, 9)])) == Shape.polygon([(0, 0), (9, 0), (9, 9)])
    assert Shape.regular_polygon((0, 0), 1, 8).points.shape == (8, 2)
    assert not Shape.regular_polygon((0, 0), 1, 2).rings
    with pytest.raises(waywright.WaywrightError) as caught:
        waywright.World(((0, 0), (9, 9))).insert(Shape.regular_polygon((5, 5), 1, 2))
    assert caught.value.code == "bad-shape"
    assert repr(Shape.point((1, 2))) == "<waywright.Shape point (1, 2)>"
