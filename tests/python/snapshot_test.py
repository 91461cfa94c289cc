"""Snapshots: immutable worlds for readers on other threads."""

import copy
import gc
import pickle
import threading

import numpy as np
import pytest
import waywright
from waywright import Agent, Change, PathSearch, PathWatch, Shape, Snapshot, World

GENERATOR = np.random.default_rng(5)
STARTS, GOALS = GENERATOR.uniform(1, 99, (2, 60, 2))
DISC = Agent(radius=0.5)
WALL = Shape.segment((50, 10), (50, 90))

# What a snapshot has and a world gives at another time, or has not at all; and what only a world has.
ONLY_SNAPSHOTS = {"release"}
ONLY_WORLDS = {
    *("insert", "insert_point", "insert_segment", "insert_polyline", "insert_polygon", "insert_all", "insert_points"),
    *("insert_ragged", "remove", "replace", "reserve_ids", "apply", "attempt", "would_disconnect", "keep_history", "mark"),
    *("rewind", "new_vertex_limit", "shrink_to_fit", "publish", "load", "from_bytes", "from_scene"),
}


def public(cls):
    return {name for name in dir(cls) if not name.startswith("_")}


def scattered_walls(count=150, **options):
    generator = np.random.default_rng(6)
    world = World((0, 0, 100, 100), **options)
    starts = generator.uniform(5, 95, (count, 2))
    points = np.stack([starts, starts + generator.uniform(-3, 3, (count, 2))], axis=1).reshape(-1, 2)
    world.insert_ragged("segment", points, np.arange(0, 2 * count + 1, 2))
    world.insert_polygon([(40, 40), (60, 40), (60, 60), (40, 60)])
    return world


def answers(world, path, tmp_path):
    """Returns the answers of all queries by name. ``path`` was found in the world some operations ago."""
    pairs = list(zip(STARTS.tolist(), GOALS.tolist()))
    world.save(tmp_path / "saved.wwb")
    axes = pytest.importorskip("matplotlib.figure").Figure().subplots()
    result = {name: getattr(world, name) for name in FACTS}
    result |= {name: getattr(world, name)() for name in ("item_ids", "items", "dump", "mesh_hash", "validate", "to_bytes")}
    result |= {name: [getattr(world, name)(a) for a, _ in pairs] for name in ("locate", "items_at")}
    result |= {name: [getattr(world, name)(a, b) for a, b in pairs] for name in ("items_crossed", "widest_path")}
    result |= {name: [getattr(world, name)(a, DISC) for a, _ in pairs] for name in ("fit_disc", "nearest_fit")}
    result |= {
        "save": (tmp_path / "saved.wwb").read_bytes(),
        "clone": world.clone().mesh_hash(),
        "contains": [world.contains(number) and number in world for number in range(200)],
        "shape": world.shape(3),
        "to_geojson": (world.to_geojson(), world.__geo_interface__),
        "snapshot": pickle.dumps(world.snapshot()),
        "to_svg": (world.to_svg(), world._repr_svg_()),
        "plot": [len(each.get_paths()) for each in world.plot(axes, mesh=True).collections],
        "items_in": world.items_in((10, 10, 60, 60)),
        "bridges": pickle.dumps(world.bridges()),
        "is_clear": [world.is_clear([a, b]) for a, b in pairs],
        "ray": [world.ray(a, b, agent) for a, b in pairs for agent in (Agent(), DISC)],
        "find_path": [pickle.dumps(world.find_path(a, b)) for a, b in pairs],
        "find_paths": world.find_paths(STARTS, GOALS, DISC, threads=2).to_bytes(),
        "find_paths_from": [found.length for found in world.find_paths_from((1, 1), GOALS, wants_points=True)],
        "rays": pickle.dumps(world.rays(STARTS, GOALS, DISC, threads=2)),
        "fit_discs": world.fit_discs(STARTS, DISC, threads=2),
        "nearest_fits": pickle.dumps(world.nearest_fits(STARTS, DISC)),
        "items_at_all": world.items_at_all(STARTS),
        "are_clear": world.are_clear(STARTS, GOALS),
        "is_affected": (world.is_affected(path, 1), world.is_affected(path.points, 3)),
        "find_affected": (world.find_affected([path], 1), world.find_affected([path], 3)),
        "changes_since": (world.changes_since(1), world.changes_since(3)),
    }
    return {name: repr(answer) for name, answer in result.items()}


FACTS = ["domain", "item_count", "vertex_count", "triangle_count", "version", "items_hash", "largest_id_seen"]
FACTS += ["default_end_tolerance", "options"]


def test_a_snapshot_has_all_queries_of_a_world():
    assert public(Snapshot) - public(World) == ONLY_SNAPSHOTS
    assert public(World) - public(Snapshot) == ONLY_WORLDS


def test_a_snapshot_gives_the_answers_of_its_moment(tmp_path):
    world = scattered_walls(keep_bridges=True)
    path = world.find_path((10, 45), (90, 45))
    world.insert(Shape.segment((30, 0), (30, 80)))
    then = answers(world, path, tmp_path)
    assert then.keys() | {"memory"} == public(Snapshot) - ONLY_SNAPSHOTS
    first = world.publish()
    assert answers(first, path, tmp_path) == then
    house = Shape.rectangle((5, 60, 35, 95))
    world.apply([Change.remove(2), Change.insert(WALL), Change.insert(house), Change.replace(3, Shape.point((3, 3)))])
    now = answers(world, path, tmp_path)
    same = {name for name in then if then[name] == now[name]}
    assert same == {"domain", "options", "default_end_tolerance", "validate"}
    assert answers(first, path, tmp_path) == then
    second = world.publish()
    del world
    gc.collect()
    assert answers(first, path, tmp_path) == then and answers(second, path, tmp_path) == now
    first.release()
    assert answers(second, path, tmp_path) == now and second.memory()["total"] > 0


def test_readers_need_not_wait_for_a_writer():
    """Readers in threads see one state for as long as they have its snapshot, while a writer changes the world."""
    world = scattered_walls()
    shared, stop, faults, reads = [world.publish()], threading.Event(), [], []

    def read():
        while not stop.is_set():
            with copy.copy(shared[0]) as snapshot:
                seen = [(snapshot.items_hash, snapshot.find_paths(STARTS, GOALS).to_bytes()) for _ in range(3)]
                count = snapshot.item_count
            reads.append(count)
            if len(set(seen)) > 1 or count % 2 == 0:
                faults.append((seen, count))

    threads = [threading.Thread(target=read) for _ in range(3)]
    for thread in threads:
        thread.start()
    for step in range(150):
        world.apply([Change.remove(step + 1), Change.insert(WALL), Change.insert(Shape.point((step / 2 + 1, 1)))])
        world.apply([Change.remove(number) for number in world.item_ids()[-2:-1]])
        before, shared[0] = shared[0], world.publish()
        before.release()
    stop.set()
    for thread in threads:
        thread.join()
    assert not faults and len(reads) > 3


def test_a_released_snapshot(world):
    snapshot = world.publish()
    other, deep = copy.copy(snapshot), copy.deepcopy(snapshot)
    assert "2 items" in repr(snapshot) and snapshot
    snapshot.release()
    snapshot.release()
    assert not snapshot and repr(snapshot) == "<waywright.Snapshot released>" and other and deep
    calls = [
        lambda: snapshot.version,
        lambda: snapshot.find_path((1, 1), (2, 2)),
        lambda: snapshot.find_paths([(1, 1)], [(2, 2)], threads=2),
        lambda: snapshot.clone(),
        lambda: copy.copy(snapshot),
        lambda: PathSearch().begin(snapshot, (1, 1), (2, 2)),
        lambda: PathWatch(snapshot),
    ]
    for call in calls:
        with pytest.raises(ValueError, match="released"):
            call()
    assert other.item_count == deep.item_count == 2
    with pytest.raises(TypeError):
        Snapshot()


def test_a_progress_function_may_release_the_snapshot(world):
    """The call that runs keeps what it reads."""
    snapshot = world.publish()
    expected = snapshot.find_paths(STARTS, GOALS).to_bytes()

    def release(done, total):
        snapshot.release()
        world.apply([Change.remove(1), Change.insert(WALL, 1)])
        world.publish()

    assert snapshot.find_paths(STARTS.repeat(50, 0), GOALS.repeat(50, 0), progress=release)[0].tolist()
    with world.clone().publish() as other:
        assert other.find_paths(STARTS, GOALS).to_bytes() != expected


def test_a_tick_can_be_published(world):
    with pytest.raises(waywright.TickError, match="history"):
        world.publish(1)
    world.keep_history(2)
    tick = world.mark()
    dump, version = world.dump(), world.version
    world.insert_segment((10, 10), (20, 20))
    with world.publish(tick) as past, world.publish(tick=None) as present:
        assert (past.dump(), past.version) == (dump, version)
        assert present.dump() == world.dump() != dump
    with pytest.raises(waywright.TickError):
        world.publish(tick + 1)
    with pytest.raises(TypeError):
        world.publish("1")
    assert world.publish(tick).clone().dump() == dump


def test_an_attempt_makes_no_snapshot(world):
    with pytest.raises(RuntimeError):
        world.attempt([Change.remove(1)], lambda changed: changed.publish())
    assert world.publish().version == world.version


def test_a_search_keeps_its_snapshot(world):
    search, snapshot = PathSearch(), world.publish()
    expected = snapshot.find_path((10, 45), (90, 45), waywright.Agent(radius=5))
    search.begin(snapshot, (10, 45), (90, 45), waywright.Agent(radius=5))
    snapshot.release()
    for _ in range(4):  # without the search, these would use the memory of the snapshot
        world.apply([Change.remove(1), Change.insert(WALL, 1)])
        world.publish()
    while not search.step(1):
        pass
    assert np.array_equal(search.path.pieces, expected.pieces) and search.restarts == 0
    search.begin(world, (10, 45), (90, 45), waywright.Agent(radius=5))
    assert search.step(1000) and search.path.length != expected.length


def test_a_watch_reads_snapshots(world):
    paths = [world.find_path((10, y), (90, y)) for y in (45, 70)]
    by_world, by_snapshots, first = PathWatch(world), PathWatch(world.publish()), world.publish()
    for watch in (by_world, by_snapshots):
        for key, path in enumerate(paths):
            watch.add(key, path)
    world.insert_segment((30, 65), (30, 75))
    second = world.publish()
    world.insert_segment((30, 40), (30, 55))
    for watch in (by_world, by_snapshots):
        assert watch.update(first).blocked == []
        assert watch.update(second).blocked == [1]
        with pytest.raises(ValueError, match="older"):
            watch.update(first)
        with pytest.raises(ValueError, match="another world"):
            watch.update(world.clone().publish())
    assert by_world.update().blocked == [0] == by_snapshots.update(world.publish()).blocked
    with pytest.raises(ValueError, match="later snapshot"):
        by_snapshots.update()
    world.keep_history(2)
    tick = world.mark()
    world.insert(WALL)
    world.rewind(tick)
    by_world.update()
