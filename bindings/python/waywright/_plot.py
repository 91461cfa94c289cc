"""Pictures: matplotlib for plots, SVG for Jupyter."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from waywright import _core

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from waywright._batch import AnyWorld, PathBatch

WALL_COLOUR = "#1b1b1b"
SOLID_COLOUR = "#b9b4a9"
MESH_COLOUR = "#d5d9e0"
POINTS_PER_CIRCLE = 96


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    from matplotlib import pyplot

    ax = pyplot.gca()
    ax.set_aspect("equal")
    return ax


def _directed(rings: list[np.ndarray]) -> list[np.ndarray]:
    """Returns the rings in such directions that the rule 'nonzero' fills the area that 'even-odd' fills.

    matplotlib fills by the rule 'nonzero'. A ring directly inside another ring gets the opposite direction. This is
    exact for rings that do not cross.
    """
    from matplotlib.path import Path as Outline

    directed = []
    for ring in rings:
        around = [other for other in rings if other is not ring and Outline(other).contains_points(ring).mean() > 0.5]
        x, y = ring.T
        is_left = np.dot(x, np.roll(y, -1)) > np.dot(np.roll(x, -1), y)
        directed.append(ring if is_left == (len(around) % 2 == 0) else ring[::-1])
    return directed


def _filled(shape: _core.Shape) -> Any:
    """Returns a path of matplotlib with all rings."""
    from matplotlib.path import Path as Outline

    vertices, codes = [], []
    for ring in _directed(shape.rings) if shape.fill == "even-odd" and len(shape.rings) > 1 else shape.rings:
        vertices.append(np.vstack([ring, ring[:1]]))
        codes += [Outline.MOVETO] + [Outline.LINETO] * (len(ring) - 1) + [Outline.CLOSEPOLY]
    return Outline(np.concatenate(vertices), codes)


def plot_world(
    self: AnyWorld, ax: Axes | None = None, *, mesh: bool = False, paths: Any = (), ids: bool = False
) -> Axes:
    """Draws the world with matplotlib, and paths on top. Returns the axes.

    ``ax`` is where to draw; None for the current axes. ``mesh`` also draws the triangles, ``ids`` the ids of the items.
    """
    from matplotlib.collections import LineCollection, PathCollection

    ax = _axes(ax)
    x0, y0, x1, y1 = self.domain
    ax.set_xlim(x0, x1)
    ax.set_ylim(y0, y1)
    if mesh:
        copy = self.snapshot()
        ax.triplot(*copy.vertices.T, copy.triangles, color=MESH_COLOUR, linewidth=0.5, zorder=1)
    items = self.items()
    polygons = [_filled(shape) for _, shape in items if shape.kind == "polygon"]
    walls = [shape.points for _, shape in items if shape.kind in ("segment", "polyline")]
    points = [shape.points[0] for _, shape in items if shape.kind == "point"]
    ax.add_collection(PathCollection(polygons, facecolor=SOLID_COLOUR, edgecolor=WALL_COLOUR, zorder=2))
    ax.add_collection(LineCollection(walls, color=WALL_COLOUR, zorder=2))
    if points:
        ax.scatter(*np.array(points).T, s=6, color=WALL_COLOUR, zorder=2)
    for number, shape in items if ids else ():
        ax.annotate(str(number), shape.centroid(), ha="center", va="center", zorder=4)
    for path in [paths] if isinstance(paths, _core.Path) else paths:
        path.plot(ax)
    return ax


def plot_path(self: _core.Path, ax: Axes | None = None, **style: Any) -> Axes:
    """Draws the path with matplotlib. Returns the axes. ``style`` is for Axes.plot()."""
    ax = _axes(ax)
    if self.found:
        ax.plot(*self.polyline(self.agent.radius / 100.0).T, zorder=3, **style)
    return ax


def plot_batch(self: PathBatch, ax: Axes | None = None, **style: Any) -> Axes:
    """Draws all paths that have points with matplotlib. Returns the axes. ``style`` is for LineCollection."""
    from matplotlib.collections import LineCollection

    ax = _axes(ax)
    ax.add_collection(LineCollection([points for points in self if len(points) > 1], zorder=3, **style))
    return ax


def world_svg(self: AnyWorld) -> str:
    """The picture of the world in Jupyter."""
    return self.to_svg(width=800)
