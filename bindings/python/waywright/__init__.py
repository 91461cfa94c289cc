"""A dynamic, exact constrained Delaunay triangulation with pathfinding on top.

>>> import waywright
>>> world = waywright.World((0, 0, 10, 10))
>>> world.insert_segment((4, 0), (4, 7))
1
>>> world.find_path((1, 1), (7, 1)).points.tolist()
[[1.0, 1.0], [4.0, 7.0], [7.0, 1.0]]
"""

from waywright import _batch, _core, _geo, _plot
from waywright._batch import ChangedBox, NearestFits, PathBatch, RayHits
from waywright._core import (
    LARGEST_COORDINATE,
    LARGEST_ID,
    PATH_STATUSES,
    PIECE_DTYPE,
    SMALLEST_COORDINATE,
    WINDOW_DTYPE,
    Agent,
    BridgeList,
    Change,
    DiscFit,
    Location,
    MeshSnapshot,
    NearestFit,
    Path,
    PathChanges,
    PathPosition,
    PathSearch,
    PathWatch,
    RayHit,
    ReplayResult,
    ReplayWriter,
    Scene,
    Script,
    ScriptLine,
    Shape,
    Snapshot,
    WidestPath,
    World,
    __version__,
    find_difference,
    is_in_range,
    parse_movingai_map,
    parse_movingai_scenario,
    parse_script,
    predicate_counts,
    read_scene,
    replay,
    to_script,
)
from waywright._errors import (
    BadValueError,
    FileError,
    IdInUseError,
    LimitError,
    NotSupportedError,
    TickError,
    UnknownIdError,
    WaywrightError,
)

for _class in (World, Snapshot):
    _class.rays = _batch.rays
    _class.nearest_fits = _batch.nearest_fits
    _class.items_at_all = _batch.items_at_all
    _class.to_geojson = _geo.world_to_geojson
    _class.__geo_interface__ = property(_geo.world_to_geojson)
    _class.plot = _plot.plot_world
    _class._repr_svg_ = _plot.world_svg
Shape.__geo_interface__ = property(_geo.shape_to_geojson)
Path.__geo_interface__ = property(_geo.path_to_geojson)
Path.plot = _plot.plot_path
PathBatch.plot = _plot.plot_batch

__all__ = [
    "LARGEST_COORDINATE",
    "LARGEST_ID",
    "PATH_STATUSES",
    "PIECE_DTYPE",
    "SMALLEST_COORDINATE",
    "WINDOW_DTYPE",
    "Agent",
    "BadValueError",
    "BridgeList",
    "Change",
    "ChangedBox",
    "DiscFit",
    "FileError",
    "IdInUseError",
    "LimitError",
    "Location",
    "MeshSnapshot",
    "NearestFit",
    "NearestFits",
    "NotSupportedError",
    "Path",
    "PathBatch",
    "PathChanges",
    "PathPosition",
    "PathSearch",
    "PathWatch",
    "RayHit",
    "RayHits",
    "ReplayResult",
    "ReplayWriter",
    "Scene",
    "Script",
    "ScriptLine",
    "Shape",
    "Snapshot",
    "TickError",
    "UnknownIdError",
    "WaywrightError",
    "WidestPath",
    "World",
    "__version__",
    "find_difference",
    "is_in_range",
    "parse_movingai_map",
    "parse_movingai_scenario",
    "parse_script",
    "predicate_counts",
    "read_scene",
    "replay",
    "to_script",
]


def _reduce_ex(self, protocol):
    """The protocols 0 and 1 of pickle would call the constructor of pybind11's base class, which ends the process."""
    return object.__reduce_ex__(self, max(protocol, 2))


for _object in vars(_core).values():
    if isinstance(_object, type) and "__setstate__" in vars(_object):
        _object.__reduce_ex__ = _reduce_ex

# Pickle, repr() and help() show the public name of each object.
for _name in __all__:
    _object = globals()[_name]
    if getattr(_object, "__module__", "").startswith("waywright._") and isinstance(_object, type):
        _object.__module__ = "waywright"
del _class, _name, _object
