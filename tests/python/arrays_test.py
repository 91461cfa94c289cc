"""Arrays of NumPy: what they share, what they mean, and what threads do."""

import threading
import time

import numpy as np
import pytest
import waywright
from waywright import World


def addresses(array):
    """Returns the memory of an array: its address and the end of it."""
    start = array.__array_interface__["data"][0]
    return start, start + array.nbytes


def test_paths_and_shapes_share_their_memory(world):
    path = world.find_path((10, 45), (90, 45))
    assert path.points.base is path and not path.points.flags.writeable
    assert addresses(path.points) == addresses(path.points)
    with pytest.raises(ValueError):
        path.points[0, 0] = 7
    points = path.points
    del path
    assert points.tolist() == [[10, 45], [40, 40], [60, 40], [90, 45]]
    shape = world.shape(1)
    assert addresses(shape.rings[0]) == addresses(shape.points)
    disc = world.find_path((10, 45), (90, 45), agent=waywright.Agent(radius=5))
    assert disc.pieces.base is not None and addresses(disc.pieces) == addresses(disc.pieces)
    assert disc.pieces["kind"].tolist() == [0, 1, 0, 1, 0]
    assert disc.pieces["from"][0].tolist() == [10, 45] and disc.pieces["to"][-1].tolist() == [90, 45]
    assert disc.pieces["centre"][1].tolist() == [40, 40] and disc.pieces["radius"][1] == 5


def test_the_mesh_shares_its_memory(world):
    mesh = world.snapshot()
    for name in ("vertices", "triangles", "constrained_edges", "ids"):
        assert getattr(mesh, name).base is mesh and addresses(getattr(mesh, name)) == addresses(getattr(mesh, name))
    assert mesh.constrained_edges.strides[0] > 8  # the indices lie in the library's struct of an edge
    corners = mesh.vertices[mesh.triangles]
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    doubled = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    assert (doubled > 0).all() and doubled.sum() / 2 == 100 * 100
    ids = [mesh.ids[i:j].tolist() for i, j in zip(mesh.id_offsets, mesh.id_offsets[1:])]
    lies_on_wall = (mesh.vertices[mesh.constrained_edges][:, :, 1] == 80).all(axis=1)
    assert [ids[i] for i in np.flatnonzero(lies_on_wall)] == [[2]] * lies_on_wall.sum()


def test_points_are_read_in_place():
    """An array in the right layout is not copied: the call sees its memory. Any other layout gives the same world."""
    points = np.random.default_rng(1).uniform(0, 100, (2000, 2))
    reference = World((0, 0, 100, 100))
    reference.insert_points(points)
    wide = np.zeros((2000, 5))
    wide[:, 1:3] = points
    unaligned = np.frombuffer(b"x" + points.tobytes(), np.uint8)[1:].view(np.float64).reshape(-1, 2)
    for other in (np.asfortranarray(points), wide[:, 1:3], points.tolist(), points.astype(">f8"), unaligned):
        world = World((0, 0, 100, 100))
        world.insert_points(other)
        assert world.items_hash == reference.items_hash
    big = np.zeros((4_000_000, 2))
    big[:, 0] = 200  # the first point is refused, so only a copy would take time or memory
    resource = pytest.importorskip("resource")
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(ValueError):
        World((0, 0, 100, 100)).insert_points(big)
    assert (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) * 1024 < big.nbytes / 2


def crossing_queries(count, seed=2):
    generator = np.random.default_rng(seed)
    return generator.uniform(1, 99, (count, 2)), generator.uniform(1, 99, (count, 2))


def many_walls(count=300, **options):
    generator = np.random.default_rng(3)
    world = World((0, 0, 100, 100), **options)
    starts = generator.uniform(2, 98, (count, 2))
    points = np.stack([starts, starts + generator.uniform(-2, 2, (count, 2))], axis=1).reshape(-1, 2)
    world.insert_ragged("segment", points, np.arange(0, 2 * count + 1, 2))
    return world


@pytest.mark.parametrize("threads", [1, 3])
def test_batches_give_the_answers_of_single_queries(threads):
    world = many_walls(keep_bridges=True)
    starts, goals = crossing_queries(200)
    agents = [waywright.Agent(radius=0.0 if i % 2 == 0 else 0.7) for i in range(200)]
    batch = world.find_paths(starts, goals, agents, threads=threads)
    assert len(batch) == 200 and batch.offsets[-1] == len(batch.points)
    statuses = set()
    for i in range(200):
        path = world.find_path(starts[i], goals[i], agents[i])
        statuses.add(path.status)
        assert waywright.PATH_STATUSES[batch.statuses[i]] == path.status
        assert batch.lengths[i] == path.length
        assert np.array_equal(batch[i], path.points) and np.array_equal(batch.pieces_of(i), path.pieces)
    assert "found" in statuses and len(statuses) > 1
    for algorithm in ("ta", "tra"):
        batch = world.find_paths(starts, goals, algorithm=algorithm, threads=threads)
        assert batch.lengths.tolist() == [world.find_path(a, b, algorithm=algorithm).length for a, b in zip(starts, goals)]


def test_other_batches_give_the_answers_of_single_queries():
    world = many_walls()
    starts, goals = crossing_queries(150)
    hits = world.rays(starts, goals, threads=2)
    discs = world.rays(starts, goals, waywright.Agent(radius=0.5), threads=2)
    fits = world.fit_discs(starts, waywright.Agent(radius=0.8))
    nearest = world.nearest_fits(starts, [waywright.Agent(radius=1.5)] * 150, threads=2)
    ids, offsets = world.items_at_all(np.concatenate([starts, [world.shape(3).points[0]]]))
    assert ids[offsets[-2] : offsets[-1]].tolist() == [3]
    clear = world.are_clear(starts, goals, threads=2)
    for i, (start, goal) in enumerate(zip(starts, goals)):
        for batch, hit in ((hits, world.ray(start, goal)), (discs, world.ray(start, goal, waywright.Agent(radius=0.5)))):
            assert batch.hit[i] == hit.hit and tuple(batch.at[i]) == hit.at and tuple(batch.contact[i]) == hit.contact
            assert batch.items[batch.offsets[i] : batch.offsets[i + 1]].tolist() == hit.items
        assert fits[i] == world.fit_disc(start, waywright.Agent(radius=0.8)).fits
        assert tuple(nearest.at[i]) == world.nearest_fit(start, waywright.Agent(radius=1.5)).at
        assert clear[i] == world.is_clear([start, goal])
    assert 0 < clear.sum() < 150 and 0 < fits.sum() < 150


@pytest.mark.parametrize("threads", [1, 2, 4])
def test_a_batch_names_the_first_refused_query(world, threads):
    starts = np.full((5000, 2), 10.0)
    goals = np.full((5000, 2), 20.0)
    goals[[1234, 1300, 4000]] = 500
    with pytest.raises(waywright.BadValueError) as caught:
        world.find_paths(starts, goals, threads=threads)
    assert caught.value.index == 1234 and "query 1234" in str(caught.value)
    with pytest.raises(ValueError, match="same length"):
        world.find_paths(starts, goals[:-1])
    assert len(world.find_paths(np.empty((0, 2)), [])) == 0


def test_batches_concatenate():
    world = many_walls(keep_bridges=True)
    starts, goals = crossing_queries(60)
    whole = world.find_paths(starts, goals, waywright.Agent(radius=0.4), tolerance=0.1)
    pieces = [world.find_paths(starts[i : i + 17], goals[i : i + 17], waywright.Agent(radius=0.4), tolerance=0.1) for i in range(0, 60, 17)]
    assert waywright.PathBatch.concatenate(pieces) == whole
    assert waywright.PathBatch.concatenate([]).offsets.tolist() == [0]
    assert whole != waywright.PathBatch.concatenate(pieces[1:])
    assert len(list(whole)) == 60 and np.array_equal(whole[-1], whole[59])


def test_progress_of_a_batch(world):
    done = []
    starts, goals = crossing_queries(3000)
    world.find_paths(starts, goals, progress=lambda *numbers: done.append(numbers))
    assert done[-1][0] == done[-1][1] and done == sorted(done)
    world.find_paths(starts, goals, threads=2, progress=True)


def test_a_long_call_releases_the_gil():
    """While one thread is in a long call, this thread goes on."""
    world = many_walls(3000)
    starts, goals = crossing_queries(20_000)
    ended = []

    def search():
        world.find_paths(starts, goals, wants_points=False)
        ended.append(time.monotonic())

    thread = threading.Thread(target=search)
    began = time.monotonic()
    thread.start()
    counted = 0
    while thread.is_alive():
        counted += 1
        time.sleep(0.001)
    thread.join()
    assert ended[0] - began > 0.1, "the call was too short to say anything"
    assert counted > 10


def test_queries_wait_for_a_change():
    """Threads that change and query one world at once see whole states only."""
    world = World((0, 0, 100, 100))
    stop, faults = threading.Event(), []

    def ask():
        while not stop.is_set():
            count = len(world.items())
            length = world.find_path((10, 50), (90, 50)).length
            if count % 2 or not (length == 80 or length > 80.1):
                faults.append((count, length))

    def search():
        slices = waywright.PathSearch()
        while not stop.is_set():
            slices.begin(world, (10, 50), (90, 50))
            while not slices.step(1):
                pass

    threads = [threading.Thread(target=ask) for _ in range(2)] + [threading.Thread(target=search)]
    for thread in threads:
        thread.start()
    shapes = [waywright.Shape.segment((50, 30), (50, 70)), waywright.Shape.point((3, 3))]
    for _ in range(300):
        ids = world.insert_all(shapes)
        world.apply([waywright.Change.remove(number) for number in ids])
    stop.set()
    for thread in threads:
        thread.join()
    assert not faults
