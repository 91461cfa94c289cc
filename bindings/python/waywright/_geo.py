"""Conversions from and to GeoJSON, and so from and to Shapely and other libraries with ``__geo_interface__``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from operator import index
from typing import TYPE_CHECKING, Any

import numpy as np

from waywright import _core

if TYPE_CHECKING:
    from waywright._batch import AnyWorld

Geometry = Mapping[str, Any]
DEEPEST = 100  # collections in collections, so that a collection that contains itself ends
COLLECTIONS = ("FeatureCollection", "GeometryCollection", "MultiPoint", "MultiLineString")


def _object_of(source: Any) -> Geometry:
    """Returns the GeoJSON object that an object is or has."""
    geometry = source if isinstance(source, Mapping) else getattr(source, "__geo_interface__", None)
    if isinstance(geometry, Mapping):
        return geometry
    wanted = "a Shape, a GeoJSON geometry, or an object with __geo_interface__"
    raise TypeError(f"a geometry must be {wanted}, not {type(source).__name__}")


def geometry_of(source: Any) -> Geometry:
    """Returns the GeoJSON geometry of an object. If the object is a feature, returns the geometry of the feature."""
    geometry = _object_of(source)
    if geometry.get("type") != "Feature":
        return geometry
    if geometry.get("geometry") is None:
        raise ValueError("this feature has no geometry")
    geometry = _object_of(geometry["geometry"])
    if geometry.get("type") == "Feature":
        raise ValueError("the geometry of a feature must not be a feature")
    return geometry


def _member(geometry: Geometry, name: str) -> Any:
    """Returns a member of a GeoJSON object, which must be a list."""
    member = geometry.get(name)
    if member is None:
        raise ValueError(f"a GeoJSON object of the type {geometry.get('type')} needs {name}")
    if isinstance(member, (str, bytes, Mapping)) or not isinstance(member, Iterable):
        raise ValueError(f"{name} of a GeoJSON object must be a list")
    return member


def _points(coordinates: Any) -> np.ndarray:
    try:
        return _core._points(coordinates)
    except (TypeError, ValueError) as error:
        raise ValueError(f"the coordinates of a geometry must be pairs of numbers: {error}") from error


def _rings(polygon: Any) -> list[Any]:
    if isinstance(polygon, (str, bytes, Mapping)) or not isinstance(polygon, Iterable):
        raise ValueError("the coordinates of a polygon must be a list of rings")
    return list(polygon)


def _polygon(rings: Iterable[Any]) -> _core.Shape:
    """Returns a polygon. GeoJSON repeats the first point of a ring as its last one."""
    lists = [_points(ring) for ring in rings]
    lists = [ring[:-1] if len(ring) > 1 and (ring[0] == ring[-1]).all() else ring for ring in lists]
    points = np.concatenate(lists) if lists else np.empty((0, 2))
    return _core._shape("polygon", points, [0, *np.cumsum([len(ring) for ring in lists], dtype=int).tolist()])


def shape_of(source: Any) -> _core.Shape:
    """Returns the shape of a geometry that is one item.

    A multi-polygon is one item with the rings of all its polygons.
    """
    if isinstance(source, _core.Shape):
        return source
    geometry = geometry_of(source)
    kind = geometry.get("type")
    if kind not in ("Point", "LineString", "LinearRing", "Polygon", "MultiPolygon"):
        if kind in COLLECTIONS:
            raise ValueError(f"a geometry of the type {kind} is not one item; use insert_all() for a collection")
        raise ValueError(f"a geometry has a type of GeoJSON, such as 'Polygon', not {kind!r}")
    coordinates = _member(geometry, "coordinates")
    if kind == "Point":
        points = _points([coordinates])
        return _core._shape("point", points, [0, 1])
    if kind in ("LineString", "LinearRing"):
        points = _points(coordinates)
        return _core._shape("segment" if len(points) == 2 else "polyline", points, [0, len(points)])
    if kind == "Polygon":
        return _polygon(_rings(coordinates))
    return _polygon(ring for rings in coordinates for ring in _rings(rings))


def _geometries(source: Any, depth: int = 0) -> Iterator[Any]:
    """Yields the geometries of a collection, each of which is one item, and pairs (id, geometry)."""
    if depth > DEEPEST:
        raise ValueError(f"collections of geometries are nested more than {DEEPEST} deep")
    geometry = _object_of(source)
    kind = geometry.get("type")
    if kind == "FeatureCollection":
        for feature in _member(geometry, "features"):
            yield from _items_of_feature(feature)
    elif kind == "GeometryCollection":
        for member in _member(geometry, "geometries"):
            yield from _geometries(member, depth + 1)
    elif kind in ("MultiPoint", "MultiLineString"):
        for coordinates in _member(geometry, "coordinates"):
            yield {"type": kind[len("Multi") :], "coordinates": coordinates}
    else:
        yield geometry


def _items_of_feature(feature: Any) -> Iterator[Any]:
    if not isinstance(feature, Mapping) or feature.get("geometry") is None:
        yield feature  # shape_of() says what is wrong
        return
    shapes = list(_geometries(geometry_of(feature)))
    number = feature.get("id")
    if isinstance(number, int) and not isinstance(number, bool) and len(shapes) == 1:
        yield number, shapes[0]
    else:
        yield from shapes


def _elements(source: Any) -> Iterable[Any]:
    """Returns the elements of a list of items or of a collection."""
    if isinstance(source, _core.Shape):
        return [source]
    if isinstance(source, Mapping) or hasattr(source, "__geo_interface__"):
        geometry = _object_of(source)
        return _items_of_feature(geometry) if geometry.get("type") == "Feature" else _geometries(geometry)
    if not isinstance(source, Iterable):
        raise TypeError(f"items must be geometries, or a collection of GeoJSON or Shapely, not {type(source).__name__}")
    return source


def _item(element: Any) -> tuple[int | None, _core.Shape]:
    if isinstance(element, tuple) and len(element) == 2:
        number, element = element
        return None if number is None else index(number), shape_of(element)
    return None, shape_of(element)


def items_of(source: Any) -> Iterator[tuple[int | None, _core.Shape]]:
    """Yields what insert_all() inserts. An error names the index of its item."""
    for count, element in enumerate(_elements(source)):
        try:
            yield _item(element)
        except (TypeError, ValueError) as error:
            kind = TypeError if isinstance(error, TypeError) else ValueError
            raise kind(f"item {count}: {error}") from error


def _coordinates(points: np.ndarray) -> list[tuple[float, float]]:
    return [(x, y) for x, y in points.tolist()]


def shape_to_geojson(shape: _core.Shape) -> dict[str, Any]:
    """The shape as a GeoJSON geometry. Shapely and other libraries read it."""
    if shape.kind == "point":
        points = _coordinates(shape.points)
        return {"type": "Point", "coordinates": points[0] if points else ()}
    if shape.kind != "polygon":
        return {"type": "LineString", "coordinates": _coordinates(shape.points)}
    rings = [_coordinates(ring) for ring in shape.rings]
    return {"type": "Polygon", "coordinates": [[*ring, *ring[:1]] for ring in rings]}


def path_to_geojson(path: _core.Path) -> dict[str, Any]:
    """The path as a GeoJSON line. The line of a disc's path differs from it by 1/100 of the radius at most."""
    points = path.polyline(path.agent.radius / 100.0) if path.found else np.empty((0, 2))
    return {"type": "LineString", "coordinates": _coordinates(points)}


def world_to_geojson(self: AnyWorld) -> dict[str, Any]:
    """Returns the items as a GeoJSON collection of features, each with its id.

    A ring of a polygon is a hole by the rule of the polygon, whatever its index. (Readers of GeoJSON take the first ring
    for the outer one.)

    >>> [feature["geometry"]["type"] for feature in world.to_geojson()["features"]]
    ['Polygon', 'LineString']
    """
    features = [
        {
            "type": "Feature",
            "id": number,
            "properties": {"kind": shape.kind, "fill": shape.fill} if shape.kind == "polygon" else {"kind": shape.kind},
            "geometry": shape_to_geojson(shape),
        }
        for number, shape in self.items()
    ]
    return {"type": "FeatureCollection", "features": features}
