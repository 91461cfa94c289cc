"""Queries on a cluster of Dask: many queries over one world, or many worlds over one batch of queries.

The program sends a world to each worker once, as the bytes of a saved world. Each worker checks the hash of the world.
The program sends later changes as operations, and each worker carries them out before it answers the next query about
the changed world. A worker that joins late, or replaces a dead worker, gets the same bytes and operations, and so gives
the same answers.
"""

from __future__ import annotations

import threading
import uuid
import warnings
from collections import OrderedDict
from collections.abc import Callable, Iterable, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from distributed import Client, Future, as_completed

from waywright import Agent, PathBatch, WaywrightError, World, _core, _progress

Progress = Callable[[int, int], object]

OPERATIONS_PER_BASE = 64  # after so many operations, the next query sends the whole world again
CHUNKS_PER_THREAD = 8
SMALLEST_CHUNK = 64
WORLDS_PER_WORKER = 8


class WorkerError(RuntimeError):
    """A worker has another world than the program that asks, for example because its library is another one."""


class State(NamedTuple):
    """The state of a world: the name of the world, the number of its operations, and the hash of its items."""

    name: str
    version: int
    items_hash: str


class Operation(NamedTuple):
    """One operation: a list of changes, and the state after it."""

    changes: list
    state: State


@dataclass
class _Kept:
    """A world that a worker keeps. ``users`` is the number of tasks that read it."""

    world: World
    state: State
    users: int = 0


class _Worlds:
    """The worlds of one worker."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._kept: OrderedDict[str, _Kept] = OrderedDict()

    @contextmanager
    def use(self, base: bytes, base_state: State, operations: Sequence[Operation]):
        """Gives the world after the operations. No other task changes the world until this task has used it."""
        with self._lock:
            kept = self._at(base, base_state, operations)
            kept.users += 1
        try:
            yield kept.world
        finally:
            with self._lock:
                kept.users -= 1

    def _at(self, base: bytes, base_state: State, operations: Sequence[Operation]) -> _Kept:
        wanted = operations[-1].state if operations else base_state
        kept = self._kept.get(wanted.name)
        if kept is None or not base_state.version <= kept.state.version <= wanted.version:
            loaded = _checked(_Kept(World.from_bytes(base), base_state))
            if kept is None or kept.state.version < wanted.version:
                self._keep(loaded)
            kept = loaded
        elif kept.users > 0 and kept.state != wanted:
            kept = _Kept(kept.world.clone(), kept.state)
            self._keep(kept)
        if kept.state.name in self._kept:
            self._kept.move_to_end(kept.state.name)
        for operation in operations:
            if operation.state.version > kept.state.version:
                kept.world.apply(operation.changes)
                kept.state = operation.state
                _checked(kept)
        return kept

    def _keep(self, kept: _Kept) -> None:
        self._kept[kept.state.name] = kept
        while len(self._kept) > WORLDS_PER_WORKER:
            self._kept.popitem(last=False)


def _checked(kept: _Kept) -> _Kept:
    if kept.world.items_hash != kept.state.items_hash:
        raise WorkerError(f"the world of a worker has the hash {kept.world.items_hash}, not {kept.state.items_hash}")
    return kept


_worlds = _Worlds()


class _Base(NamedTuple):
    """The bytes of a saved world. Logs of Dask show the repr() of a task's arguments, so it is short."""

    data: bytes

    def __repr__(self) -> str:
        return f"<saved world of {len(self.data)} bytes>"


def _value(value: Any) -> Any:
    """A task whose result is its argument. If the worker that has the result dies, the scheduler repeats the task."""
    return value


@dataclass(frozen=True)
class _Refused:
    """The answer of a chunk with a refused query. A task that raised the error would fill the log of its worker."""

    error: WaywrightError


def _answer(
    base: _Base, base_state: State, operations: list[Operation], arrays: tuple, first: int, options: dict[str, Any]
) -> PathBatch | _Refused:
    """Answers the queries of one chunk, on a worker. ``first`` is the index of its first query in the batch."""
    starts, goals, agent = arrays
    with _worlds.use(base.data, base_state, operations) as world:
        try:
            return world.find_paths(starts, goals, agent, **options)
        except WaywrightError as error:
            index = first + error.index
            message = error.message.replace(f"query {error.index}", f"query {index}", 1)
            return _Refused(type(error)(error.code, message, index, error.item))


class DistributedWorld:
    """A world on all workers of a Dask client.

    It starts as a copy of ``world``. Use apply() to change it. The answers equal the answers of World.find_paths(). They
    do not depend on the workers.

    >>> with distributed.Client() as client:                       # doctest: +SKIP
    ...     everywhere = waywright.distributed.DistributedWorld(client, world)
    ...     batch = everywhere.find_paths(starts, goals, progress=True)
    """

    def __init__(self, client: Client, world: World) -> None:
        self._client = client
        self._world = world.clone()
        self._name = f"waywright-{uuid.uuid4().hex}"
        self._version = 0
        self._rebase()

    @property
    def world(self) -> World:
        """A copy of the world as it is now."""
        return self._world.clone()

    @property
    def items_hash(self) -> str:
        """The hash of the items."""
        return self._world.items_hash

    @property
    def version(self) -> int:
        """The number of operations since the copy was made."""
        return self._version

    def apply(self, changes: Any) -> list[int]:
        """Makes changes, as World.apply() does. Returns the id of the item of each change."""
        changes = _core._changes(changes)
        ids = self._world.apply(changes)
        self._version += 1
        self._operations.append(self._send(Operation(changes, self._state()), f"operation-{self._version}"))
        return ids

    def find_paths(
        self,
        starts: Any,
        goals: Any,
        agent: Any = Agent(),
        algorithm: str = "optimal",
        *,
        chunk_size: int | None = None,
        progress: Progress | bool | None = None,
        **options: Any,
    ) -> PathBatch:
        """Finds a path for each pair of a start and a goal. See World.find_paths().

        ``chunk_size`` is the number of queries of one task. It does not change the answers.
        """
        chunks = self._submit(starts, goals, agent, chunk_size, {"algorithm": algorithm, **options})
        return PathBatch.concatenate(_gather(chunks, progress))

    def _state(self) -> State:
        return State(self._name, self._version, self._world.items_hash)

    def _send(self, value: Any, name: str) -> Future:
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message="Large object")  # dask would rather scatter it, and could lose it
            return self._client.submit(_value, value, key=f"{self._name}-{name}")

    def _rebase(self) -> None:
        self._base_state = self._state()
        self._base = self._send(_Base(self._world.to_bytes()), f"base-{self._version}")
        self._operations: list[Future] = []

    def _submit(
        self, starts: Any, goals: Any, agent: Any, chunk_size: int | None, options: dict[str, Any]
    ) -> list[Future]:
        starts, goals = (np.ascontiguousarray(each, np.float64) for each in (starts, goals))
        is_one = isinstance(agent, Agent)
        if any(each.size > 0 and (each.ndim != 2 or each.shape[1] != 2) for each in (starts, goals)):
            raise ValueError("starts and goals must be arrays of shape (N, 2)")
        if chunk_size is not None and chunk_size < 1:
            raise ValueError("chunk_size must be 1 or more")
        if len(starts) != len(goals) or not is_one and len(agent) != len(starts):
            raise ValueError("starts, goals and agent must have the same length")
        if len(self._operations) > OPERATIONS_PER_BASE:
            self._rebase()
        size = chunk_size or self._chunk_size(len(starts))
        batch = uuid.uuid4().hex
        return [
            self._client.submit(
                _answer,
                self._base,
                self._base_state,
                self._operations,
                (starts[i : i + size], goals[i : i + size], agent if is_one else agent[i : i + size]),
                i,
                options,
                key=f"{self._name}-paths-{batch}-{i}",
            )
            for i in range(0, len(starts), size)
        ]

    def _chunk_size(self, count: int) -> int:
        threads = max(sum(self._client.nthreads().values()), 1)
        return max(count // (threads * CHUNKS_PER_THREAD), SMALLEST_CHUNK)

    def __repr__(self) -> str:
        return f"<waywright.distributed.DistributedWorld version {self._version} of {self._world!r}>"


def find_paths_in_worlds(
    client: Client,
    worlds: Iterable[World],
    starts: Any,
    goals: Any,
    agent: Any = Agent(),
    algorithm: str = "optimal",
    *,
    chunk_size: int | None = None,
    progress: Progress | bool | None = None,
    **options: Any,
) -> list[PathBatch]:
    """Answers one batch of path queries in each of many worlds. Returns the answers in the order of the worlds."""
    everywhere = [DistributedWorld(client, world) for world in worlds]
    size = chunk_size or max(len(starts), 1)  # the worlds are many, so one task for each is enough
    chunks = [each._submit(starts, goals, agent, size, {"algorithm": algorithm, **options}) for each in everywhere]
    answers = iter(_gather([chunk for each in chunks for chunk in each], progress))
    return [PathBatch.concatenate([next(answers) for _ in each]) for each in chunks]


def _gather(chunks: Sequence[Future], progress: Progress | bool | None) -> list[PathBatch]:
    """Returns the answers of the chunks in their order.

    If the worlds refuse queries, raises the error of the first one. Chunks after a refused one are cancelled.
    """
    report = _progress.bar() if progress is True else progress or (lambda done, total: None)
    index_of = {chunk.key: index for index, chunk in enumerate(chunks)}
    answers: list[Any] = [None] * len(chunks)
    failed = len(chunks)
    try:
        for done, chunk in enumerate(as_completed(chunks), 1):
            report(done, len(chunks))
            index = index_of[chunk.key]
            if index > failed:
                continue
            answers[index] = chunk.result()
            if isinstance(answers[index], _Refused):
                _cancel(chunks[index + 1 : failed])
                failed = index
        if failed < len(chunks):
            raise answers[failed].error
        return answers
    except BaseException:
        _cancel(chunks)
        raise


def _cancel(chunks: Sequence[Future]) -> None:
    """Cancels the chunks that still run, all at once: the scheduler takes its time for each call."""
    running = [chunk for chunk in chunks if not chunk.done()]
    if running:
        running[0].client.cancel(running)
