#include <string>

#include "bind.hpp"

// Items of a world: inserting, removing, replacing and reading them.

namespace waywright::python {

namespace {

std::vector<ItemId> insert_items(WorldHandle& self, const std::vector<Item>& items, ThreadCount threads,
                                 const py::object& progress) {
  Reporter reporter(progress);
  const BulkOptions options{.threads = threads.value, .progress = reporter.function()};
  return self.write([&](World& world) { return world.insert_all(items, options).value(); });
}

std::vector<ItemId> insert_all(WorldHandle& self, const py::object& items, ThreadCount threads,
                               const py::object& progress) {
  std::vector<Item> list;
  for (const py::handle pair : py::module_::import("waywright._geo").attr("items_of")(items)) {
    auto [id, shape] = pair.cast<std::pair<ItemId, ShapeArg>>();
    list.push_back({id, shape.shape != nullptr ? *shape.shape : std::move(shape.made)});
  }
  return insert_items(self, list, threads, progress);
}

ItemId insert_points(WorldHandle& self, const PointsArg& points, ItemId first, ThreadCount threads,
                     const py::object& progress) {
  Reporter reporter(progress);
  const BulkOptions options{.threads = threads.value, .progress = reporter.function()};
  return self.write([&](World& world) { return world.insert_points(points.span(), first, options).value(); });
}

using Offsets = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// Exceptions: py::type_error, if the offsets are no integers.
Offsets offsets_of(const py::object& source) {
  refuse_masked(source);
  const py::array array = py::array::ensure(source);
  const char kind = array ? array.dtype().kind() : 'O';
  if (kind != 'i' && kind != 'u' && (!array || array.size() > 0)) throw py::type_error("offsets must be integers");
  if (array.ndim() != 1) throw py::value_error("offsets must be a list of integers");
  return Offsets(array);
}

/// Returns the elements of a list of offsets, which must ascend from 0 to `end`.
std::span<const std::int64_t> checked_offsets(const Offsets& offsets, std::size_t end) {
  const std::span<const std::int64_t> all(offsets.data(), static_cast<std::size_t>(offsets.size()));
  bool ascends = !all.empty() && all.front() >= 0 && all.back() <= static_cast<std::int64_t>(end);
  for (std::size_t i = 1; i < all.size(); ++i) ascends = ascends && all[i - 1] <= all[i];
  if (!ascends)
    throw py::value_error("offsets must ascend, from 0 or more up to the length of the list that they divide");
  return all;
}

/// Makes items of a ragged array. `offsets` says which points belong to each ring. `item_offsets` says which rings
/// belong to each item; if it is None, each ring is an item.
std::vector<Item> ragged_items(ItemKind kind, std::span<const Point> points, const Offsets& offsets,
                               const py::object& item_offsets, FillRule fill, ItemId first) {
  const auto rings = checked_offsets(offsets, points.size());
  const std::size_t ring_count = rings.size() - 1;
  Offsets of_items;
  if (!item_offsets.is_none()) of_items = offsets_of(item_offsets);
  const auto ends = item_offsets.is_none() ? std::span<const std::int64_t>() : checked_offsets(of_items, ring_count);
  const std::size_t count = item_offsets.is_none() ? ring_count : ends.size() - 1;
  std::vector<Item> items(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!first.is_null()) items[i].id = ItemId(first.value + i);
    items[i].shape.kind = kind;
    items[i].shape.fill = fill;
    const std::size_t begin = ends.empty() ? i : static_cast<std::size_t>(ends[i]);
    const std::size_t end = ends.empty() ? i + 1 : static_cast<std::size_t>(ends[i + 1]);
    for (std::size_t ring = begin; ring < end; ++ring) {
      auto from = static_cast<std::size_t>(rings[ring]);
      auto to = static_cast<std::size_t>(rings[ring + 1]);
      // GeoJSON and Shapely repeat the first point of a ring as its last one.
      if (kind == ItemKind::polygon && to - from > 1 && points[from] == points[to - 1]) --to;
      items[i].shape.rings.push_back(PointSpan(points.subspan(from, to - from)));
    }
  }
  return items;
}

void bind_bulk(WorldClass& world) {
  world
      .def("insert_all", &insert_all, py::arg("items"), py::kw_only(), py::arg("threads") = 1,
           py::arg("progress") = py::none(),
           R"(Inserts many items as one operation, and returns their ids.

``items`` is an iterable of geometries, as for insert(), or of pairs (id, geometry); or a collection of GeoJSON or Shapely.
``progress`` is a function of two numbers, what is done and the total, or True for a bar of tqdm.

>>> world.insert_all([waywright.Shape.segment((5, 5), (9, 5)), (12, waywright.Shape.rectangle((2, 2, 4, 4)))])
[3, 12]
)")
      .def("insert_points", &insert_points, py::arg("points"), py::arg("first") = py::none(), py::kw_only(),
           py::arg("threads") = 1, py::arg("progress") = py::none(),
           R"(Inserts many points as one operation. Returns the id of the first; each further id is one more.

An array of shape (N, 2) of doubles in C order is read where it is, without a copy.

>>> world.insert_points(np.array([[1.0, 1.0], [2.0, 1.0], [3.0, 1.0]]), first=100)
100
)")
      .def(
          "insert_ragged",
          [](WorldHandle& self, ItemKind kind, const PointsArg& points, const py::object& offsets,
             const py::object& item_offsets, FillRule fill, ItemId first, ThreadCount threads,
             const py::object& progress) {
            const auto items = ragged_items(kind, points.span(), offsets_of(offsets), item_offsets, fill, first);
            return own_ids(insert_items(self, items, threads, progress));
          },
          py::arg("kind"), py::arg("points"), py::arg("offsets"), py::arg("item_offsets") = py::none(), py::kw_only(),
          py::arg("fill") = FillRule::even_odd, py::arg("first") = py::none(), py::arg("threads") = 1,
          py::arg("progress") = py::none(),
          R"(Inserts the items of a ragged array, as shapely.to_ragged_array gives them. Returns an array of their ids.

The points from ``offsets[i]`` to ``offsets[i + 1]`` are a ring. If there are ``item_offsets``, the rings from
``item_offsets[k]`` to ``item_offsets[k + 1]`` belong to the item k. Otherwise each ring is an item.

>>> points = np.array([[1, 1], [3, 1], [3, 3], [5, 5], [8, 5], [8, 8], [5, 8]], float)
>>> world.insert_ragged("polygon", points, [0, 3, 7])
array([3, 4], dtype=uint64)
)");
}

void bind_single(WorldClass& world) {
  world
      .def(
          "insert",
          [](WorldHandle& self, const ShapeArg& shape, ItemId id) {
            return self.write([&](World& w) { return w.insert(shape.get(), id).value(); });
          },
          py::arg("geometry"), py::arg("id") = py::none(),
          R"(Inserts an item, and returns its id. If ``id`` is None, the world chooses it.

``geometry`` is a Shape, an object with ``__geo_interface__`` (for example of Shapely), or a GeoJSON geometry.

>>> world.insert({"type": "LineString", "coordinates": [(5, 5), (9, 5), (9, 9)]})
3
)")
      .def(
          "insert_point",
          [](WorldHandle& self, Point point, ItemId id) {
            return self.write([&](World& w) { return w.insert_point(point, id).value(); });
          },
          py::arg("point"), py::arg("id") = py::none(), "Inserts a point: a vertex that is no wall. Returns the id.")
      .def(
          "insert_segment",
          [](WorldHandle& self, Point a, Point b, ItemId id) {
            return self.write([&](World& w) { return w.insert_segment(a, b, id).value(); });
          },
          py::arg("a"), py::arg("b"), py::arg("id") = py::none(),
          "Inserts a segment from ``a`` to ``b``. Returns the id.")
      .def(
          "insert_polyline",
          [](WorldHandle& self, const PointsArg& points, ItemId id) {
            return self.write([&](World& w) { return w.insert_polyline(points.span(), id).value(); });
          },
          py::arg("points"), py::arg("id") = py::none(), "Inserts an open polyline. Returns the id.")
      .def(
          "insert_polygon",
          [](WorldHandle& self, const py::object& rings, FillRule fill, ItemId id) {
            const auto shape = py::type::of<Shape>().attr("polygon")(rings, fill).cast<Shape>();
            return self.write([&](World& w) { return w.insert(shape, id).value(); });
          },
          py::arg("rings"), py::arg("fill") = FillRule::even_odd, py::arg("id") = py::none(),
          "Inserts a solid obstacle of one ring, or of a list of rings. Returns the id. See Shape.polygon().");
}

void bind_changing(WorldClass& world) {
  world
      .def(
          "remove", [](WorldHandle& self, ItemId id) { self.write([&](World& w) { w.remove(id).value(); }); },
          py::arg("id"),
          R"(Removes an item.

>>> world.remove(99)
Traceback (most recent call last):
waywright.UnknownIdError: no item has id 99
)")
      .def(
          "replace",
          [](WorldHandle& self, ItemId id, const ShapeArg& shape) {
            self.write([&](World& w) { w.replace(id, shape.get()).value(); });
          },
          py::arg("id"), py::arg("geometry"),
          R"(Gives an item another shape. Use it to move an obstacle.

>>> world.replace(1, world.shape(1).translated(5, 0))
>>> world.shape(1).points[0]
array([45., 40.])
)")
      .def(
          "reserve_ids",
          [](WorldHandle& self, ItemId last) { self.write([&](World& w) { w.reserve_ids(last).value(); }); },
          py::arg("last"), "Lets the world continue its ids after ``last``.");
}

}  // namespace

void bind_world_items(WorldClass& world) {
  bind_single(world);
  bind_changing(world);
  bind_bulk(world);
}

template <class Class>
void bind_reading_items(Class& world) {
  using Handle = typename Class::type;
  world
      .def(
          "contains",
          [](const Handle& self, ItemId id) { return self.read([&](const World& w) { return w.contains(id); }); },
          py::arg("id"), "Returns whether there is an item with this id. ``id in world`` does the same.")
      .def(
          "__contains__",
          [](const Handle& self, ItemId id) { return self.read([&](const World& w) { return w.contains(id); }); },
          py::arg("id"))
      .def(
          "item_ids",
          [](const Handle& self) { return own_ids(self.read([](const World& w) { return w.item_ids(); })); },
          "Returns an array of the ids of all items, ascending.")
      .def(
          "shape",
          [](const Handle& self, ItemId id) { return self.read([&](const World& w) { return w.shape(id).value(); }); },
          py::arg("id"), R"(Returns the shape of an item.

>>> world.shape(2)
<waywright.Shape segment (20, 80) (80, 80)>
)")
      .def(
          "items",
          [](const Handle& self) {
            std::vector<Item> items = self.read_long([](const World& w) { return w.items(); });
            py::list list(items.size());
            for (std::size_t i = 0; i < items.size(); ++i) {
              list[i] = py::make_tuple(items[i].id, std::move(items[i].shape));
            }
            return list;
          },
          R"(Returns all items as pairs (id, shape), ascending by id.

>>> [id for id, shape in world.items()]
[1, 2]
)");
}

template void bind_reading_items(WorldClass& world);
template void bind_reading_items(SnapshotClass& snapshot);

}  // namespace waywright::python
