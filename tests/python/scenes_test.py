"""Searches in slices, watches, scenes, scripts and replay logs."""

import gc

import numpy as np
import pytest
import waywright
from conftest import ROOT
from waywright import Change, Shape, World

MAP = ROOT / "examples" / "maps" / "highground.wws"


def test_a_search_in_slices(world):
    search = waywright.PathSearch()
    assert search.step(10)  # no search is running
    search.begin(world, (10, 45), (90, 45), waywright.Agent(radius=5))
    assert search.is_running
    while not search.step(1):
        pass
    expected = world.find_path((10, 45), (90, 45), waywright.Agent(radius=5))
    assert np.array_equal(search.path.pieces, expected.pieces) and not search.is_running
    search.begin(world, (10, 45), (90, 45), waywright.Agent(radius=5))
    search.step(1)
    world.insert_segment((30, 0), (30, 45))
    while not search.step(1):
        pass
    assert search.restarts == 1 and search.path.length == world.find_path((10, 45), (90, 45), waywright.Agent(radius=5)).length
    search.begin(world, (10, 45), (90, 45))
    search.cancel()
    assert not search.is_running


def test_a_search_keeps_its_world_alive():
    search = waywright.PathSearch()
    world = World((0, 0, 10, 10))
    world.insert_segment((5, 0), (5, 9))
    search.begin(world, (1, 1), (9, 1))
    watch = waywright.PathWatch(world)
    del world
    gc.collect()
    while not search.step(1):
        pass
    assert search.path.found and watch.update().blocked == []


def test_a_watch(world):
    watch = waywright.PathWatch(world)
    watch.add(1, world.find_path((10, 45), (90, 45)))
    watch.add(2, world.find_path((10, 45), (90, 45), waywright.Agent(radius=5)))
    watch.add(3, world.find_path((1, 1), (2, 1)))
    assert len(watch) == 3 and 2 in watch and 9 not in watch
    world.insert_segment((50, 30), (50, 42))
    changes = watch.update()
    assert (changes.blocked, changes.may_be_blocked, changes.may_be_too_long) == ([1], [2], [])
    world.remove(1)
    assert watch.update().may_be_too_long == [1, 2]
    assert watch.remove(1) and not watch.remove(1)


def test_scenes():
    scene = waywright.read_scene(MAP)
    world = World.from_scene(scene, keep_bridges=True, threads=2)
    assert world.domain == scene.domain and world.item_count == len(scene.items)
    again = waywright.parse_script(waywright.to_script(scene)).scene()
    assert World.from_scene(again).items_hash == world.items_hash
    with pytest.raises(waywright.FileError):
        waywright.read_scene("/nowhere.map")
    with pytest.raises(ValueError) as caught:
        waywright.parse_script("waywright 1\ndomain 0 0 1 1\npoint x\n", "a.wws")
    assert caught.value.code == "malformed" and "a.wws:3" in str(caught.value)


def test_a_scenario():
    starts, goals, lengths = waywright.parse_movingai_scenario("version 1\n0 a.map 49 49 1 11 1 12 1.5\n")
    assert starts.tolist() == [[1, 11]] and goals.tolist() == [[1, 12]] and lengths.tolist() == [1.5]


def test_replay_logs(world, tmp_path):
    with waywright.ReplayWriter(tmp_path / "a.wws", world, 2) as log:
        for step in range(4):
            changes = [Change.insert(Shape.point((step + 1, 5)))]
            log.record(changes, world.apply(changes))
            log.tick(world)
        assert log.last_tick == 4
    with pytest.raises(ValueError):
        log.tick(world)
    text = (tmp_path / "a.wws").read_text()
    script = waywright.parse_script(text)
    assert waywright.replay(script) and waywright.replay(script).ticks == 4
    assert waywright.find_difference(script, script) is None
    assert "point 5 3 5" in text
    other = waywright.parse_script(text.replace("point 5 3 5", "point 5 3 6"))
    difference = waywright.find_difference(script, other)
    assert (difference["kind"], difference["tick"], difference["item"]) == ("change", 3, 5)
    result = waywright.replay(other)
    assert not result and result.tick == 4 and result.last_same == 2 and result.expected == world.items_hash
    with pytest.raises(waywright.FileError):
        waywright.ReplayWriter(tmp_path / "none" / "a.wws", world)


def test_paths_from_one_start(world):
    goals = np.random.default_rng(1).uniform(1, 99, (300, 2))
    paths = world.find_paths_from((10, 45), goals, wants_points=True)
    for goal, path in zip(goals, paths):
        one = world.find_path((10, 45), goal)
        assert path.status == one.status and path.length == pytest.approx(one.length, rel=1e-12)


def test_walking(world):
    path = world.find_path((10, 45), (90, 45), waywright.Agent(radius=5))
    points = path.walk(0.5)
    assert tuple(points[0]) == (10, 45) and tuple(points[-1]) == (90, 45)
    assert np.linalg.norm(np.diff(points, axis=0), axis=1).max() <= 0.5 + 1e-9
    position = path.advance(path.at(3), 4)
    assert position.distance == pytest.approx(7) and path.nearest(position.at).distance == pytest.approx(7)
    for bad in (0, -1, float("nan")):
        with pytest.raises(ValueError):
            path.walk(bad)
    line = path.polyline(0.001)
    assert len(line) > len(path.polyline(2.0))
    with pytest.raises(waywright.BadValueError):
        path.polyline(-1)
