#include <string>

#include "bind.hpp"

// Shapes of items, and changes of worlds.

namespace waywright::python {

namespace {

using ShapeClass = py::class_<Shape>;

py::array points_of(const py::object& self) { return view_points(self.cast<const Shape&>().rings.points(), self); }

py::list rings_of(const py::object& self) {
  py::list rings;
  for (const PointSpan ring : self.cast<const Shape&>().rings) rings.append(view_points(ring, self));
  return rings;
}

std::vector<std::size_t> ring_offsets(const Shape& shape) {
  std::vector<std::size_t> offsets = {0};
  for (const PointSpan ring : shape.rings) offsets.push_back(offsets.back() + ring.size());
  return offsets;
}

/// Makes the rings of a shape from all points and the index of the first point of each ring, and of the end.
Rings rings_from(std::span<const Point> points, const std::vector<std::size_t>& offsets) {
  Rings rings;
  rings.reserve(points.size());
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    if (offsets[i - 1] > offsets[i] || offsets[i] > points.size()) {
      throw py::value_error("the offsets of the rings must ascend, and end at the number of points");
    }
    rings.push_back(PointSpan(points.subspan(offsets[i - 1], offsets[i] - offsets[i - 1])));
  }
  return rings;
}

/// Makes rings from an array of shape (N, 2), which is one ring, or from a list of such arrays.
Rings rings_from(const py::object& source) {
  const bool is_array = py::isinstance<py::array>(source);
  const auto is_list_of_points = [&] {
    const py::list list(source);
    Point point;
    return !list.empty() && read_point(list[0], point) && !py::isinstance<py::array>(list[0]);
  };
  if ((is_array && source.cast<py::array>().ndim() == 2) || (!is_array && is_list_of_points())) {
    const auto points = source.cast<PointsArg>();
    return std::vector<Point>(points.span().begin(), points.span().end());
  }
  Rings rings;
  for (const py::handle ring : py::list(source)) rings.push_back(PointSpan(ring.cast<PointsArg>().span()));
  return rings;
}

std::string repr_of_shape(const Shape& shape) {
  std::string text = "<waywright.Shape " + std::string(to_string(shape.kind));
  const std::size_t count = shape.rings.points().size();
  if (count <= 2) {
    for (const Point& point : shape.rings.points()) text += " " + to_string(point);
  } else {
    text += " of " + std::to_string(count) + " points";
  }
  if (shape.rings.size() > 1) text += " in " + std::to_string(shape.rings.size()) + " rings";
  if (shape.kind == ItemKind::polygon && shape.fill == FillRule::nonzero) text += ", nonzero";
  return text + ">";
}

void bind_shape_makers(ShapeClass& shape) {
  shape.def_static("point", &Shape::point, py::arg("point"), "Returns a point.")
      .def_static("segment", &Shape::segment, py::arg("a"), py::arg("b"), "Returns the segment from ``a`` to ``b``.")
      .def_static(
          "polyline", [](const PointsArg& points) { return Shape::polyline(points.span()); }, py::arg("points"),
          "Returns the polyline through the points.")
      .def_static(
          "polygon", [](const py::object& rings, FillRule fill) { return Shape::polygon(rings_from(rings), fill); },
          py::arg("rings"), py::arg("fill") = FillRule::even_odd,
          R"(Returns a polygon of one ring (a list of points) or of several (a list of lists of points).

With the fill rule 'even-odd', a ring in a ring bounds a hole. With 'nonzero', it bounds one only if their directions
differ.

>>> waywright.Shape.polygon([[(0, 0), (9, 0), (9, 9), (0, 9)], [(3, 3), (6, 3), (6, 6)]])
<waywright.Shape polygon of 7 points in 2 rings>
)")
      .def_static("rectangle", &Shape::rectangle, py::arg("box"), "Returns the polygon of a box.")
      .def_static("regular_polygon", &Shape::regular_polygon, py::arg("centre"), py::arg("radius"),
                  py::arg("corner_count"),
                  R"(
Returns the polygon of corners on a circle. It is the same on every machine.

A polygon has 3 corners or more. For fewer, the shape has no rings, and a world refuses it (code 'bad-shape').
)");
}

void bind_shape(py::module_& module) {
  ShapeClass shape(module, "Shape", R"(
The form of an item: a point, a segment, a polyline or a polygon. It does not change.

>>> house = waywright.Shape.rectangle((2, 2, 6, 5))
>>> house.translated(10, 0).centroid()
(14.0, 3.5)
)");
  bind_shape_makers(shape);
  shape
      .def_property_readonly(
          "kind", [](const Shape& self) { return self.kind; }, "'point', 'segment', 'polyline' or 'polygon'.")
      .def_property_readonly(
          "fill", [](const Shape& self) { return self.fill; }, "The fill rule of a polygon: 'even-odd' or 'nonzero'.")
      .def_property_readonly("points", &points_of, "The points of all rings: an array that shares the shape's memory.")
      .def_property_readonly("rings", &rings_of, "The points of each ring: arrays that share the shape's memory.")
      .def_property_readonly(
          "ring_offsets", [](const Shape& self) { return own_numbers(ring_offsets(self)); },
          "The index in ``points`` of the first point of each ring, and the number of points.")
      .def("translated", &translated, py::arg("dx"), py::arg("dy"), "Returns a copy that is moved by (dx, dy).")
      .def(
          "centroid",
          [](const Shape& self) {
            if (self.rings.points().empty()) throw py::value_error("a shape without points has no centroid");
            return centroid(self);
          },
          "Returns the centroid, computed in plain doubles.")
      .def(
          "__eq__", [](const Shape& self, const Shape& other) { return self == other; }, py::is_operator())
      .def("__hash__",
           [](const Shape& self) {
             std::size_t hash = self.rings.size();
             for (const Point& point : self.rings.points()) hash = hash * 31 + std::hash<Point>{}(point);
             return static_cast<py::ssize_t>(hash >> 1U);
           })
      .def("__repr__", &repr_of_shape)
      .def(py::pickle(
          [](const Shape& self) {
            const std::vector<Point> points(self.rings.points().begin(), self.rings.points().end());
            return py::make_tuple(self.kind, self.fill, bytes_of(points), bytes_of(ring_offsets(self)));
          },
          [](const py::tuple& state) {
            const auto points = from_bytes<Point>(state[2].cast<py::bytes>());
            return Shape{state[0].cast<ItemKind>(),
                         rings_from(points, from_bytes<std::size_t>(state[3].cast<py::bytes>())),
                         state[1].cast<FillRule>()};
          }));
}

void bind_change(py::module_& module) {
  py::class_<Change>(module, "Change", R"(
One of several changes that World.apply() makes together.

>>> waywright.Change.remove(1)
<waywright.Change remove 1>
>>> world.apply([waywright.Change.remove(1), waywright.Change.insert(waywright.Shape.point((5, 5)), 7)])
[1, 7]
)")
      .def_static(
          "insert", [](const ShapeArg& shape, ItemId id) { return Change::insert(shape.get(), id); }, py::arg("shape"),
          py::arg("id") = py::none(),
          "Returns the insertion of a shape under an id, or under an id that the world chooses.")
      .def_static("remove", &Change::remove, py::arg("id"), "Returns the removal of an item.")
      .def_static(
          "replace", [](ItemId id, const ShapeArg& shape) { return Change::replace(id, shape.get()); }, py::arg("id"),
          py::arg("shape"), "Returns the replacement of the shape of an item.")
      .def_property_readonly(
          "kind", [](const Change& self) { return self.kind; }, "'insert', 'remove' or 'replace'.")
      .def_property_readonly(
          "id", [](const Change& self) { return self.id; }, "The id of the item; 0 if the world chooses the id.")
      .def_property_readonly(
          "shape", [](const Change& self) { return self.shape; }, "The shape of an insertion or a replacement.")
      .def(
          "__eq__",
          [](const Change& a, const Change& b) { return a.kind == b.kind && a.id == b.id && a.shape == b.shape; },
          py::is_operator())
      .def("__repr__",
           [](const Change& self) {
             std::string text = "<waywright.Change " + std::string(name_of(self.kind));
             if (!self.id.is_null()) text += " " + std::to_string(self.id.value);
             if (self.kind != Change::Kind::remove) text += ": " + repr_of_shape(self.shape);
             return text + ">";
           })
      .def(py::pickle([](const Change& self) { return py::make_tuple(self.kind, self.id, self.shape); },
                      [](const py::tuple& state) {
                        return Change{state[0].cast<Change::Kind>(), state[1].cast<ItemId>(), state[2].cast<Shape>()};
                      }));
}

}  // namespace

void bind_shapes(py::module_& module) {
  bind_shape(module);
  bind_change(module);
  module.def(
      "_points",
      [](const py::object& coordinates) {
        const DoubleArray points = doubles_of(coordinates, "an element is not a number");
        if (points.size() == 0) return DoubleArray(std::vector<py::ssize_t>{0, 2});
        if (points.ndim() != 2 || points.shape(1) < 2) throw py::value_error("it is not a list of pairs");
        return DoubleArray(points[py::make_tuple(py::ellipsis(), py::make_tuple(0, 1))]);
      },
      py::arg("coordinates"));
  module.def(
      "_shape",
      [](ItemKind kind, const PointsArg& points, const std::vector<std::size_t>& offsets, FillRule fill) {
        return Shape{kind, rings_from(points.span(), offsets), fill};
      },
      py::arg("kind"), py::arg("points"), py::arg("offsets"), py::arg("fill") = FillRule::even_odd);
}

}  // namespace waywright::python
