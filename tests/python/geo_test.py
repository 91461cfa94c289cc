"""Shapely, GeoJSON and ragged arrays."""

import json

import numpy as np
import pytest
import waywright
from waywright import Shape, World

shapely = pytest.importorskip("shapely")
geometry = pytest.importorskip("shapely.geometry")


def to_ragged_array(polygons):
    """The coordinates and offsets of shapely.to_ragged_array(), which Shapely has since version 2."""
    if hasattr(shapely, "to_ragged_array"):
        _, coordinates, offsets = shapely.to_ragged_array(polygons)
        return coordinates, offsets
    rings = [[polygon.exterior, *polygon.interiors] for polygon in polygons]
    lists = [np.array(ring.coords) for each in rings for ring in each]
    ring_offsets = np.cumsum([0, *(len(ring) for ring in lists)])
    return np.concatenate(lists), (ring_offsets, np.cumsum([0, *(len(each) for each in rings)]))


HOUSE = [(10, 10), (30, 10), (30, 30), (10, 30)]
COURT = [(15, 15), (20, 15), (20, 20)]


def test_geometries_of_shapely():
    world = World((0, 0, 100, 100))
    world.insert(geometry.Point(1, 2))
    world.insert(geometry.LineString([(1, 1), (2, 2)]))
    world.insert(geometry.LineString([(1, 1), (2, 2), (3, 1)]))
    world.insert(geometry.Polygon(HOUSE, [COURT]))
    world.insert(geometry.LinearRing(HOUSE))
    world.insert(geometry.MultiPolygon([geometry.Polygon(HOUSE, [COURT]), geometry.box(50, 50, 60, 60)]))
    kinds = [(shape.kind, [len(ring) for ring in shape.rings]) for _, shape in world.items()]
    assert kinds == [
        ("point", [1]),
        ("segment", [2]),
        ("polyline", [3]),
        ("polygon", [4, 3]),
        ("polyline", [5]),
        ("polygon", [4, 3, 4]),
    ]
    # GeoJSON repeats the first point of a ring, a shape does not.
    assert waywright.Change.insert(geometry.Polygon(HOUSE, [COURT])).shape.ring_offsets.tolist() == [0, 4, 7]
    with pytest.raises(ValueError, match="insert_all"):
        world.insert(geometry.MultiPoint([(1, 1), (2, 2)]))
    with pytest.raises(TypeError):
        world.insert("POINT (1 1)")
    assert world.find_path(geometry.Point(1, 1), geometry.Point(9, 1)).found


def test_the_world_and_shapely_agree_about_the_inside():
    polygon = geometry.Polygon(HOUSE, [COURT])
    world = World((0, 0, 100, 100))
    world.insert(polygon)
    generator = np.random.default_rng(7)
    for x, y in generator.uniform(5, 35, (300, 2)):
        assert (world.items_at((x, y)) == [1]) == polygon.intersects(geometry.Point(x, y))


def test_collections():
    world = World((0, 0, 100, 100))
    assert world.insert_all(geometry.MultiPoint([(1, 1), (2, 2)])) == [1, 2]
    assert world.insert_all(geometry.GeometryCollection([geometry.Point(3, 3), geometry.box(4, 4, 5, 5)])) == [3, 4]
    assert world.insert_all([geometry.box(6, 6, 7, 7), (20, Shape.point((8, 8)))]) == [5, 20]
    with pytest.raises(TypeError):
        world.insert_all([3])


def test_geojson_round_trip():
    world = World((0, 0, 100, 100))
    world.insert(geometry.Polygon(HOUSE, [COURT]), id=7)
    world.insert_polyline([(1, 1), (2, 2), (3, 1)])
    world.insert_point((4, 4))
    text = json.dumps(world.to_geojson())
    other = World((0, 0, 100, 100))
    assert other.insert_all(json.loads(text)) == [7, 8, 9]
    assert other.items_hash == world.items_hash
    assert geometry.shape(world.shape(7)).area == 20 * 20 - 5 * 5 / 2
    path = world.find_path((5, 20), (40, 22))
    assert geometry.shape(path).length == pytest.approx(path.length)


def test_ragged_arrays_of_shapely():
    generator = np.random.default_rng(4)
    polygons = [geometry.Polygon(HOUSE, [COURT])]
    polygons += [geometry.Point(*at).buffer(2, 3) for at in generator.uniform(40, 90, (30, 2))]
    points, (offsets, item_offsets) = to_ragged_array(polygons)
    bulk, single = World((0, 0, 100, 100)), World((0, 0, 100, 100))
    assert bulk.insert_ragged("polygon", points, offsets, item_offsets).tolist() == list(range(1, 32))
    for polygon in polygons:
        single.insert(polygon)
    assert bulk.items_hash == single.items_hash
    starts, goals = generator.uniform(1, 99, (40, 2)), generator.uniform(1, 99, (40, 2))
    batch = bulk.find_paths(starts, goals)
    for start, goal, path in zip(starts, goals, batch):
        if len(path) < 2:
            continue
        line = geometry.LineString(path)
        assert line.length == pytest.approx(bulk.find_path(start, goal).length)
        assert not any(line.intersects(polygon.buffer(-1e-6)) for polygon in polygons)
    with pytest.raises(ValueError, match="offsets"):
        bulk.insert_ragged("polygon", points, offsets[::-1])
    with pytest.raises(ValueError, match="offsets"):
        bulk.insert_ragged("polygon", points, [0, len(points) + 1])
    with pytest.raises(waywright.BadValueError):
        bulk.insert_ragged("polygon", [(1, 1), (2, 2)], [0, 0, 2])
