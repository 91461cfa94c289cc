"""Batches of queries: arrays of NumPy in and out."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from waywright import _core

AnyWorld = Union[_core.World, _core.Snapshot]
Agents = Union[_core.Agent, Sequence[_core.Agent]]  # one, or one for each query
Progress = Union[Callable[[int, int], object], bool, None]


class ChangedBox(NamedTuple):
    """A region that an operation has changed: an element of the answer of World.changes_since()."""

    version: int
    box: tuple[float, float, float, float]
    is_insertion: bool
    is_removal: bool


class RayHits(NamedTuple):
    """The answers of World.rays(), one for each ray.

    ``items[offsets[i]:offsets[i + 1]]`` are the ids of the items that the ray i touches.
    """

    hit: NDArray[np.bool_]
    at: NDArray[np.float64]
    contact: NDArray[np.float64]
    items: NDArray[np.uint64]
    offsets: NDArray[np.int64]


class NearestFits(NamedTuple):
    """The answers of World.nearest_fits(), one for each point."""

    is_found: NDArray[np.bool_]
    at: NDArray[np.float64]
    distance: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PathBatch:
    """The answers of World.find_paths(), in the order of the queries.

    ``statuses[i]`` is the index of the status of the path i in ``waywright.PATH_STATUSES``; 0 means found.
    ``points[offsets[i]:offsets[i + 1]]`` are its points, and ``pieces[piece_offsets[i]:piece_offsets[i + 1]]`` its lines
    and arcs, if it is the path of a disc. ``batch[i]`` are the points of the path i.

    >>> batch = world.find_paths([(10, 45), (50, 50)], [(90, 45), (90, 45)])
    >>> batch
    <waywright.PathBatch of 2 paths, 1 found>
    >>> batch[0].tolist()
    [[10.0, 45.0], [40.0, 40.0], [60.0, 40.0], [90.0, 45.0]]
    """

    statuses: NDArray[np.uint8]
    lengths: NDArray[np.float64]
    points: NDArray[np.float64]
    offsets: NDArray[np.int64]
    pieces: NDArray[Any]
    piece_offsets: NDArray[np.int64]

    @property
    def found(self) -> NDArray[np.bool_]:
        """Whether each path was found."""
        return self.statuses == 0

    def __len__(self) -> int:
        return len(self.statuses)

    def __getitem__(self, index: int) -> NDArray[np.float64]:
        index = self._checked(index)
        return self.points[self.offsets[index] : self.offsets[index + 1]]

    def _checked(self, index: int) -> int:
        if not -len(self) <= index < len(self):
            raise IndexError("there is no path with this index")
        return index % len(self)

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        return (self[index] for index in range(len(self)))

    def pieces_of(self, index: int) -> NDArray[Any]:
        """Returns the lines and arcs of a path."""
        index = self._checked(index)
        return self.pieces[self.piece_offsets[index] : self.piece_offsets[index + 1]]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, PathBatch):
            return NotImplemented
        return self.to_bytes() == other.to_bytes()

    def to_bytes(self) -> bytes:
        """Returns the bytes of all arrays. They are equal for equal answers, on every machine of this byte order."""
        return b"".join(np.ascontiguousarray(array).tobytes() for array in self._fields())

    def _fields(self) -> list[NDArray[Any]]:
        fields = [self.statuses, self.lengths, self.points, self.offsets, self.piece_offsets]
        return fields + [self.pieces[name] for name in self.pieces.dtype.names]

    @staticmethod
    def concatenate(batches: Sequence[PathBatch]) -> PathBatch:
        """Returns one batch with the paths of several, one batch after the other."""
        return PathBatch(
            np.concatenate([np.empty(0, np.uint8), *(batch.statuses for batch in batches)]),
            np.concatenate([np.empty(0), *(batch.lengths for batch in batches)]),
            np.concatenate([np.empty((0, 2)), *(batch.points for batch in batches)]),
            _joined_offsets([batch.offsets for batch in batches]),
            np.concatenate([np.empty(0, _core.PIECE_DTYPE), *(batch.pieces for batch in batches)]),
            _joined_offsets([batch.piece_offsets for batch in batches]),
        )

    def __repr__(self) -> str:
        return f"<waywright.PathBatch of {len(self)} paths, {int(self.found.sum())} found>"


def _joined_offsets(lists: Sequence[NDArray[np.int64]]) -> NDArray[np.int64]:
    counts = np.concatenate([np.zeros(1, np.int64), *(np.diff(offsets) for offsets in lists)])
    return np.cumsum(counts)


def rays(
    self: AnyWorld,
    starts: ArrayLike,
    ends: ArrayLike,
    agent: Agents = _core.Agent(),
    *,
    threads: int = 1,
    progress: Progress = None,
) -> RayHits:
    """Finds the first wall that each agent touches while it moves along a segment.

    >>> world.rays([(10, 50), (10, 70)], [(90, 50), (90, 70)]).hit
    array([ True, False])
    """
    return RayHits(*self._rays(starts, ends, agent, threads, progress))


def nearest_fits(
    self: AnyWorld,
    points: ArrayLike,
    agent: Agents,
    *,
    limit: float = np.inf,
    threads: int = 1,
    progress: Progress = None,
) -> NearestFits:
    """Finds for each point the nearest point where a disc fits.

    >>> world.nearest_fits([(45, 50), (10, 50)], waywright.Agent(radius=5)).distance
    array([10.,  0.])
    """
    return NearestFits(*self._nearest_fits(points, agent, limit, threads, progress))


def items_at_all(
    self: AnyWorld, points: ArrayLike, *, threads: int = 1, progress: Progress = None
) -> tuple[NDArray[np.uint64], NDArray[np.int64]]:
    """Returns the ids of the items that contain each point, and offsets.

    The ids of the point i are ``ids[offsets[i]:offsets[i + 1]]``.

    >>> world.items_at_all([(50, 50), (10, 50), (50, 80)])
    (array([1, 2], dtype=uint64), array([0, 1, 1, 2]))
    """
    return self._items_at_all(points, threads, progress)
