"""Queries on a real scheduler and real worker processes, one of which dies."""

import os
import signal
import threading
import time

import numpy as np
import pytest
import waywright
from waywright import Agent, Change, Shape, World

distributed = pytest.importorskip("distributed")
from waywright.distributed import DistributedWorld, _Worlds, State, Operation, WorkerError, find_paths_in_worlds  # noqa: E402


@pytest.fixture(scope="module")
def cluster():
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, memory_limit=0
    ) as made:
        yield made


@pytest.fixture
def client(cluster):
    with distributed.Client(cluster) as made:
        made.wait_for_workers(2, timeout=60)
        yield made


def walls(seed, count=400, **options):
    generator = np.random.default_rng(seed)
    world = World((0, 0, 100, 100), **options)
    starts = generator.uniform(2, 98, (count, 2))
    points = np.stack([starts, starts + generator.uniform(-2, 2, (count, 2))], axis=1).reshape(-1, 2)
    world.insert_ragged("segment", points, np.arange(0, 2 * count + 1, 2))
    return world


def queries(count, seed=9):
    generator = np.random.default_rng(seed)
    return generator.uniform(1, 99, (count, 2)), generator.uniform(1, 99, (count, 2))


def test_the_answers_are_those_of_one_process(client):
    world = walls(1, keep_bridges=True)
    starts, goals = queries(2000)
    everywhere, done = DistributedWorld(client, world), []
    for agent in (Agent(), [Agent(radius=0.5 * (i % 2)) for i in range(2000)]):
        batch = everywhere.find_paths(starts, goals, agent, progress=lambda *numbers: done.append(numbers))
        assert batch.to_bytes() == world.find_paths(starts, goals, agent).to_bytes()
    assert done[-1][0] == done[-1][1] > 1
    assert everywhere.find_paths(starts, goals, chunk_size=7).to_bytes() == world.find_paths(starts, goals).to_bytes()
    assert len(everywhere.find_paths([], [])) == 0


def test_only_operations_travel(client):
    world = walls(2)
    starts, goals = queries(600)
    everywhere = DistributedWorld(client, world)
    before = everywhere.find_paths(starts, goals)
    for step in range(70):  # more than OPERATIONS_PER_BASE
        wall = Shape.segment((step + 10, 5), (step + 10, 95))
        changes = [Change.insert(wall, 1000 + step), Change.remove(step + 1)]
        changes += [Change.remove(999 + step)] if step else []
        assert everywhere.apply(changes) == world.apply(changes)
        if step % 10 == 3 or step > 67:
            batch = everywhere.find_paths(starts, goals)
            assert batch.to_bytes() == world.find_paths(starts, goals).to_bytes()
            assert batch != before
    assert everywhere.items_hash == world.items_hash and everywhere.version == 70
    with pytest.raises(waywright.UnknownIdError):
        everywhere.apply([Change.remove(12345)])
    assert everywhere.find_paths(starts, goals).to_bytes() == world.find_paths(starts, goals).to_bytes()


def test_many_worlds_over_one_batch(client):
    worlds = [walls(seed, 100) for seed in range(20, 30)]
    starts, goals = queries(150)
    answers = find_paths_in_worlds(client, worlds, starts, goals)
    for world, batch in zip(worlds, answers):
        assert batch.to_bytes() == world.find_paths(starts, goals).to_bytes()
    assert len({batch.to_bytes() for batch in answers}) == 10


def test_the_error_names_the_first_refused_query(client):
    starts, goals = queries(1000)
    goals[[555, 700, 901]] = 500
    began = time.monotonic()
    with pytest.raises(waywright.BadValueError) as caught:
        DistributedWorld(client, walls(1)).find_paths(starts, goals, chunk_size=50)
    assert caught.value.index == 555 and "query 555" in str(caught.value)
    assert time.monotonic() - began < 5
    logs = "".join(message for log in client.get_worker_logs().values() for _, message in log)
    assert "Compute Failed" not in logs


def test_bad_arguments_do_not_reach_the_workers(client):
    everywhere = DistributedWorld(client, walls(1))
    starts, goals = queries(10)
    for bad in ((starts[0], goals[0]), (starts, goals[:-1]), (starts[:, :1], goals)):
        with pytest.raises(ValueError, match="starts"):
            everywhere.find_paths(*bad)
    with pytest.raises(ValueError, match="chunk_size"):
        everywhere.find_paths(starts, goals, chunk_size=-3)
    with pytest.raises(TypeError, match="list of Change"):
        everywhere.apply(3)
    assert everywhere.apply(Change.remove(1)) == [1] and len(everywhere.apply(Shape.point((3, 3)))) == 1


def test_errors_of_workers(client):
    """The error of a worker reaches the caller. The log of the worker does not contain the bytes of the world."""
    everywhere = DistributedWorld(client, walls(1))
    everywhere._base_state = everywhere._base_state._replace(items_hash="0" * 32)
    with pytest.raises(WorkerError, match="0{32}"):
        everywhere.find_paths(*queries(10))
    with pytest.raises(TypeError, match="algoritm"):
        DistributedWorld(client, walls(1)).find_paths(*queries(10), algoritm="ta")
    logs = "".join(message for log in client.get_worker_logs().values() for _, message in log)
    assert "<saved world of" in logs and "WWORLD" not in logs


def test_a_worker_that_dies_changes_nothing(cluster, client):
    world = walls(3, 1500)
    starts, goals = queries(4000)
    everywhere = DistributedWorld(client, world)
    everywhere.apply([Change.insert(Shape.segment((50, 10), (50, 90)))])
    workers = {address: worker["pid"] for address, worker in client.run(lambda dask_worker: {"pid": os.getpid()}).items()}
    killed, done = [], []

    def report(finished, total):
        done.append(finished)
        if not killed and finished >= 2:
            # Kill the worker that has the world: the other one, or a new one, must get it again.
            killed.append(list(workers.values())[0])
            os.kill(killed[0], signal.SIGKILL)

    batch = everywhere.find_paths(starts, goals, chunk_size=100, progress=report)
    assert killed and len(done) == 40
    client.wait_for_workers(2, timeout=60)
    assert killed[0] not in client.run(os.getpid).values()
    assert batch.to_bytes() == everywhere.world.find_paths(starts, goals).to_bytes()
    # The new worker answers, too.
    assert everywhere.find_paths(starts, goals, chunk_size=100).to_bytes() == batch.to_bytes()


def test_a_worker_that_joins_late_changes_nothing(client, cluster):
    world = walls(4, 2000)
    starts, goals = queries(10_000)
    everywhere = DistributedWorld(client, world)
    cluster.scale(1)
    while len(client.nthreads()) > 1:
        time.sleep(0.05)
    joining = threading.Timer(0.1, lambda: cluster.scale(2))
    joining.start()
    batch = everywhere.find_paths(starts, goals, chunk_size=200)
    joining.join()
    client.wait_for_workers(2, timeout=60)
    assert batch.to_bytes() == world.find_paths(starts, goals).to_bytes()


def test_what_a_worker_keeps():
    """A worker goes on from the version that it has, and gives an old task its old world."""
    world = walls(5, 50)
    base, states = world.to_bytes(), [State("w", 0, world.items_hash)]
    operations = []
    for step in range(3):
        changes = [Change.remove(step + 1)]
        world.apply(changes)
        states.append(State("w", step + 1, world.items_hash))
        operations.append(Operation(changes, states[-1]))
    worlds = _Worlds()
    with worlds.use(base, states[0], []) as first:
        with worlds.use(base, states[0], operations[:2]) as second:
            assert (first.items_hash, second.items_hash) == (states[0].items_hash, states[2].items_hash)
    with worlds.use(base, states[0], operations) as third:
        assert third.items_hash == world.items_hash and third is second
    with worlds.use(base, states[0], operations[:1]) as old:
        assert old.items_hash == states[1].items_hash and old is not third
    with worlds.use(base, states[0], operations) as again:
        assert again is third
    wrong = states[0]._replace(name="x", items_hash="0" * 32)
    with pytest.raises(WorkerError):
        with worlds.use(base, wrong, []):
            pass
