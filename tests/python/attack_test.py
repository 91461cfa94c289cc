"""Objects without contents, hostile sequences, masked arrays, special files and threads at the end of the program."""

import copy
import os
import pickle
import stat
import subprocess
import sys

import numpy as np
import pytest
import waywright
from waywright import PathSearch, PathWatch, ReplayWriter, Shape, World, _core

CLASSES = [value for value in vars(_core).values() if isinstance(value, type)]


# Members that do not read the object, and pictures, which need matplotlib.
NOT_USED = ("__new__", "__init__", "__setstate__", "__enter__", "__reduce_ex__", "__eq__", "plot")


def members_of(cls):
    """Yields functions that use an object of a class in each manner that the class has."""
    for name, value in vars(cls).items():
        if isinstance(value, property):
            yield name, value.fget
        elif callable(value) and not isinstance(value, staticmethod) and name not in NOT_USED:
            yield name, lambda thing, value=value: value(thing)


@pytest.mark.parametrize("cls", CLASSES, ids=lambda cls: cls.__name__)
def test_objects_without_contents(cls, world):
    """What __new__ makes has no contents, and each use of it is an error."""
    empty = cls.__new__(cls)
    checked = 0
    for name, use in members_of(cls):
        with pytest.raises(TypeError):
            use(empty)
            pytest.fail(name)
        checked += 1
    assert checked > 0
    path = world.find_path((10, 70), (90, 70))
    for use in (
        lambda: world.is_affected(empty, 0),
        lambda: world.insert(empty),
        lambda: world.apply([empty]),
        lambda: world.to_svg(empty),
        lambda: world.to_svg([empty]),
        lambda: path.advance(empty, 1),
        lambda: PathSearch().begin(empty, (1, 1), (2, 2)),
        lambda: PathWatch(empty),
        lambda: PathWatch(world).add(1, empty),
        lambda: PathWatch(world).update(empty),
        lambda: World.from_scene(empty),
        lambda: waywright.replay(empty),
        lambda: waywright.to_script(empty),
        lambda: World.find_path(empty, (1, 1), (2, 2)),
    ):
        with pytest.raises(TypeError):
            use()
    assert world.validate() is None


def unpicklable(world):
    script = waywright.parse_script("waywright 1\ndomain 0 0 9 9\npoint 1 2 2\ntick 1\n")
    return [
        *(world.publish(), PathSearch(), PathWatch(world), PathWatch(world).update(), script, script.lines[0]),
        *(script.scene(), waywright.replay(script), ReplayWriter(os.devnull, world)),
    ]


def test_objects_without_pickle(world):
    for thing in unpicklable(world):
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            with pytest.raises(TypeError, match="cannot be pickled"):
                pickle.dumps(thing, protocol)
    with pytest.raises(TypeError, match=r"clone\(\)"):
        pickle.dumps(world.publish())
    with pytest.raises(TypeError, match="cannot be pickled"):
        copy.copy(PathSearch())
    snapshot = world.publish()
    assert copy.copy(snapshot).items_hash == copy.deepcopy(snapshot).items_hash == world.items_hash
    assert pickle.loads(pickle.dumps(snapshot.clone())).items_hash == world.items_hash


def test_every_protocol_of_pickle(python):
    """Wrong code for old protocols would end the process, so a child runs this."""
    code = """
import pickle, waywright
class Level(waywright.World):
    pass
world = Level((0, 0, 100, 100), keep_bridges=True)
world.insert_segment((50, 0), (50, 60))
path, disc = world.find_path((20, 50), (80, 50)), world.find_path((20, 50), (80, 50), waywright.Agent(radius=5))
things = [world, world.clone(), path, disc, path.at(1), world.locate((50, 50)), world.ray((20, 50), (80, 50))]
things += [world.fit_disc((49, 50), disc.agent), world.nearest_fit((49, 50), disc.agent)]
things += [disc.agent, world.widest_path((20, 50), (80, 50))]
things += [world.bridges(), world.snapshot(), world.shape(1), waywright.Change.remove(1)]
for thing in things:
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        copy = pickle.loads(pickle.dumps(thing, protocol))
        assert type(copy) is type(thing) and repr(copy) == repr(thing), thing
picklable = {cls for cls in vars(waywright._core).values() if isinstance(cls, type) and "__setstate__" in vars(cls)}
assert picklable == {type(thing) for thing in things[1:]}
print("end")
"""
    run = subprocess.run([python, "-c", code], capture_output=True, text=True, timeout=60)
    assert (run.returncode, run.stdout, run.stderr) == (0, "end\n", "")


def test_a_pickled_arc_that_is_too_large(world):
    path = world.find_path((10, 45), (90, 45), agent=waywright.Agent(radius=5))
    make, arguments, state = path.__reduce_ex__(4)[:3]
    pieces = path.pieces.copy()
    pieces["radius"][1] = 1e30
    damaged = make(*arguments)
    with pytest.raises(ValueError, match="damaged"):
        damaged.__setstate__((*state[:5], pieces.tobytes(), *state[6:]))
    copied = pickle.loads(pickle.dumps(path))
    assert copied.polyline(0.1).tolist() == path.polyline(0.1).tolist()


def test_a_number_that_changes_its_list(world):
    for length in (2, 4):
        corners = [1.0] * length

        class Evil:
            def __float__(self):
                corners.clear()
                corners.extend([object()] * 50)
                corners.clear()
                return 1.0

        corners[0] = Evil()
        with pytest.raises(TypeError):
            World(corners) if length == 4 else world.locate(corners)


def test_sequences_that_are_no_points(world):
    class Endless:
        def __len__(self):
            return 2

        def __getitem__(self, index):
            return 1.0

    class Interrupted:
        def __float__(self):
            raise KeyboardInterrupt

    assert world.locate(Endless()).kind == world.locate((1, 1)).kind
    for bad in (range(10**12), range(3), np.array(3.0), {1: 2, 3: 4}, b"ab", "12", (1,), [1, None]):
        with pytest.raises(TypeError):
            world.locate(bad)
    for bad in (range(10**12), range(3), np.array(3.0), b"ab", [(0, 0), (1, 1), (2, 2)]):
        with pytest.raises(TypeError):
            World(bad)
    with pytest.raises(KeyboardInterrupt):
        world.locate([Interrupted(), 1])

    class Odd:
        __geo_interface__ = {"coordinates": (1, 1)}

    with pytest.raises(TypeError):
        world.locate(Odd())


def test_masked_arrays(world):
    hidden = np.ma.array([[1.0, 1.0], [2.0, 2.0]], mask=[[0, 0], [0, 1]])
    before = world.items_hash
    calls = [
        lambda: world.insert_points(hidden),
        lambda: world.insert_points([*hidden]),
        lambda: world.find_paths(hidden, hidden),
        lambda: world.insert({"type": "LineString", "coordinates": hidden}),
        lambda: world.insert_ragged("segment", [(1, 1), (2, 2)], np.ma.array([0, 2], mask=[0, 1])),
        lambda: Shape.polygon(hidden),
    ]
    for call in calls:
        with pytest.raises(ValueError, match="mask"):
            call()
    assert world.items_hash == before
    assert world.insert_points(np.ma.array([[1.0, 1.0]], mask=False)) == 3


def test_text_is_no_number(world):
    before = world.items_hash
    for bad in ([["1", "2"]], [("1", 2.0)], np.array([["1", 2]], object), [[b"1", 2]]):
        with pytest.raises(TypeError, match="points must be numbers"):
            world.insert_points(bad)
        with pytest.raises(ValueError, match="pairs of numbers"):
            world.insert({"type": "LineString", "coordinates": bad})
    with pytest.raises(ValueError, match="pairs of numbers"):
        world.insert({"type": "LineString", "coordinates": np.array([[1j, 2]])})
    assert world.items_hash == before
    assert world.insert_points(np.array([[1, 2.5]], object)) == 3


def test_shapes_of_arrays(world):
    before = world.items_hash
    for bad in (np.zeros((0, 3)), np.zeros((5, 0)), [[]], np.zeros((0, 2, 2)), np.float64(3), np.zeros(4)):
        with pytest.raises(ValueError, match="shape"):
            world.insert_points(bad)
    with pytest.raises(ValueError, match="one for each query"):
        world.find_paths([(1, 1), (2, 2)], [(3, 3), (4, 4)], agent=[waywright.Agent()])
    for bad in (np.zeros((2, 2), int), np.int64(0), [[0, 2]]):
        with pytest.raises(ValueError, match="offsets"):
            world.insert_ragged("segment", [(1, 1), (2, 2)], bad)
    assert world.items_hash == before
    assert len(world.find_paths([], np.empty((0, 2)))) == 0


HOSTILE = [
    ({"type": "GeometryCollection", "geometries": [5]}, TypeError, "not int"),
    ({"type": "GeometryCollection", "geometries": 5}, ValueError, "must be a list"),
    ({"type": "GeometryCollection", "geometries": "ab"}, ValueError, "must be a list"),
    ({"type": "FeatureCollection", "features": 5}, ValueError, "must be a list"),
    ({"type": "FeatureCollection", "features": [5]}, TypeError, "not int"),
    ({"type": "MultiPoint", "coordinates": 5}, ValueError, "must be a list"),
    ({"type": "Polygon", "coordinates": 5}, ValueError, "must be a list"),
    ({"type": "Polygon", "coordinates": [5]}, ValueError, "pairs of numbers"),
    ({"type": "MultiPolygon", "coordinates": [5]}, ValueError, "list of rings"),
    ({"type": "MultiPolygon", "coordinates": [[[5]]]}, ValueError, "pairs of numbers"),
    ({"type": "Feature", "geometry": {"type": "Feature", "geometry": 5}}, ValueError, "must not be a feature"),
    ({"type": "Feature", "geometry": 5}, TypeError, "not int"),
]


@pytest.mark.parametrize(("bad", "kind", "words"), HOSTILE)
def test_hostile_geojson(world, bad, kind, words):
    before = world.items_hash
    with pytest.raises(kind, match=words):
        world.insert_all(bad)
    with pytest.raises((TypeError, ValueError)):
        world.insert(bad)
    assert world.items_hash == before


def test_geojson_that_contains_itself(world):
    collection = {"type": "GeometryCollection", "geometries": []}
    collection["geometries"].append(collection)
    feature = {"type": "Feature"}
    feature["geometry"] = feature
    for bad in (collection, feature, [collection], {"type": "FeatureCollection", "features": [feature]}):
        with pytest.raises(ValueError, match="nested|feature|insert_all"):
            world.insert_all(bad)
    deep = {"type": "Point", "coordinates": (1, 1)}
    for _ in range(50):
        deep = {"type": "GeometryCollection", "geometries": [deep]}
    assert len(world.insert_all(deep)) == 1
    point = {"type": "Feature", "id": True, "geometry": {"type": "Point", "coordinates": (1, 1)}}
    assert world.insert_all(point) == [4]


def test_geojson_of_shapes_without_points():
    assert Shape.polygon([]).__geo_interface__["coordinates"] == []
    assert Shape.polygon([np.empty((0, 2))]).__geo_interface__["coordinates"] == [[]]
    assert Shape.polyline([]).__geo_interface__["coordinates"] == []


def test_pieces_count_from_the_end(world):
    batch = world.find_paths([(10, 45), (10, 70)], [(90, 45), (90, 70)], agent=waywright.Agent(radius=5))
    assert len(batch.pieces_of(-1)) == len(batch.pieces_of(1)) == 1
    assert len(batch.pieces_of(-2)) == 5
    for bad in (2, -3):
        with pytest.raises(IndexError):
            batch.pieces_of(bad)


def test_file_names_that_are_not_utf8(world, tmp_path):
    name = os.fsencode(tmp_path) + b"/\xff\xfe.wwb"
    text = os.fsdecode(name)
    calls = [World.load, waywright.read_scene, lambda file: world.save(os.path.join(os.fsdecode(file), "x"))]
    for file in (name, text):
        for call in calls:
            with pytest.raises(waywright.FileError) as caught:
                call(file)
            assert text in str(caught.value)
    world.save(text)
    assert World.load(name).items_hash == world.items_hash
    assert os.listdir(tmp_path) == ["\udcff\udcfe.wwb"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no named pipes")
def test_saving_over_special_files(world, tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    (tmp_path / "link").symlink_to(pipe)
    for name in ("pipe", "link"):
        with pytest.raises(waywright.FileError, match="regular file"):
            world.save(tmp_path / name)
    with pytest.raises(waywright.FileError, match="directory"):
        world.save(tmp_path)
    assert stat.S_ISFIFO(pipe.stat().st_mode) and (tmp_path / "link").is_symlink()
    assert sorted(os.listdir(tmp_path)) == ["link", "pipe"]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs a device without room")
def test_a_replay_log_without_room(world):
    log = ReplayWriter("/dev/full", world)
    with pytest.raises(waywright.FileError, match="/dev/full"):
        log.close()
    log.close()
    with pytest.raises(waywright.FileError), ReplayWriter("/dev/full", world) as log:
        log.tick(world)
    with pytest.raises(ValueError, match="closed"):
        log.tick(world)


def test_ctrl_c_in_the_last_report(world):
    def interrupt(done, total):
        if done == total:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        world.insert_points([(1, 1)], first=10, progress=interrupt)
        for _ in range(1000):
            pass
    assert 10 in world


def test_objects_that_need_a_lasting_world(world):
    wall = Shape.segment((30, 0), (30, 100))
    for use in (World.publish, World.clone, copy.copy, lambda changed: PathSearch().begin(changed, (1, 1), (2, 2))):
        with pytest.raises(RuntimeError, match="must not"):
            world.attempt(wall, use)
    assert world.version == 2


DAEMON = """
import threading, time
import numpy as np
import waywright
world = waywright.World((0, 0, 1000, 1000))
a = np.random.default_rng(1).uniform(2, 998, (2000, 2))
points = np.stack([a, a + 1.5], axis=1).reshape(-1, 2)
world.insert_ragged("segment", points, np.arange(0, 4001, 2))
def ask(call):
    while True:
        call()
def search():
    world.find_paths(a, a[::-1], wants_points=False, threads=2, progress=lambda done, total: None)
for call in (search, lambda: world.find_path((1, 1), (999, 999)), lambda: world.apply([])):
    for _ in range(2):
        threading.Thread(target=ask, args=(call,), daemon=True).start()
time.sleep(0.3)
print("end", flush=True)
"""


def test_the_program_ends_while_threads_search():
    for _ in range(3):
        run = subprocess.run([sys.executable, "-c", DAEMON], capture_output=True, text=True, timeout=60)
        assert (run.returncode, run.stdout, run.stderr) == (0, "end\n", "")
