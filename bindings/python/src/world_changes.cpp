#include <optional>

#include "bind.hpp"

// Several changes at once, going back, trying out, and what has changed.

namespace waywright::python {

namespace {

/// Returns changes from a list of them, or the insertion of a geometry.
std::vector<Change> changes_of(const py::object& source) {
  if (py::isinstance<Change>(source)) return {source.cast<Change>()};
  if (py::isinstance<Shape>(source) || py::isinstance<py::dict>(source) || py::hasattr(source, "__geo_interface__")) {
    return {Change::insert(read_shape(source))};
  }
  constexpr const char* kWanted = "changes must be a list of Change, or a geometry to insert";
  if (!py::isinstance<py::iterable>(source)) throw py::type_error(kWanted);
  std::vector<Change> changes;
  for (const py::handle change : source) {
    if (!py::isinstance<Change>(change)) throw py::type_error(kWanted);
    changes.push_back(change.cast<const Change&>());
  }
  return changes;
}

template <class Handle>
py::object changes_since(const Handle& self, std::uint64_t since) {
  std::vector<ChangedBox> boxes;
  const bool has_all = self.read([&](const World& world) {
    const auto all = world.changes_since(since);
    if (all) boxes.assign(all->begin(), all->end());
    return all.has_value();
  });
  if (!has_all) return py::none();
  const py::object make = py::module_::import("waywright._batch").attr("ChangedBox");
  py::list list;
  for (const ChangedBox& box : boxes) list.append(make(box.version, box.box, box.is_insertion, box.is_removal));
  return list;
}

void bind_history(WorldClass& world) {
  world
      .def(
          "keep_history",
          [](WorldHandle& self, std::size_t ticks) {
            self.write([&](World& w) {
              w.keep_history(ticks);
              self.keeps_history = ticks > 0;
            });
          },
          py::arg("ticks"), "Makes the world remember its last ``ticks`` ticks, for rewind() and publish().")
      .def(
          "mark",
          [](WorldHandle& self) {
            return self.write([&](World& w) {
              if (!self.keeps_history) throw py::value_error("call keep_history() with 1 or more before mark()");
              return w.mark();
            });
          },
          "Names the current state of the world. Returns its tick.")
      .def(
          "rewind",
          [](WorldHandle& self, std::uint64_t tick) { self.write([&](World& w) { w.rewind(tick).value(); }); },
          py::arg("tick"), R"(Brings back the state of the world at a tick.

>>> world.keep_history(8)
>>> tick = world.mark()
>>> world.remove(1)
>>> world.rewind(tick)
>>> 1 in world
True
)");
}

}  // namespace

void bind_world_changes(py::module_& module, WorldClass& world) {
  module.def("_changes", &changes_of, py::arg("changes"));
  world
      .def(
          "apply",
          [](WorldHandle& self, const py::object& changes) {
            const std::vector<Change> list = changes_of(changes);
            return self.write([&](World& w) { return w.apply(list).value(); });
          },
          py::arg("changes"),
          "Makes several changes as one operation: all or, on an error, none. Returns the id of the item of each "
          "change.")
      .def(
          "attempt",
          [](const py::object& self, const py::object& changes, const py::function& question) {
            return self.cast<WorldHandle&>().attempt(changes_of(changes), self, question);
          },
          py::arg("changes"), py::arg("question"),
          R"(Makes changes, calls ``question(world)``, takes the changes back, and returns the answer of the question.

The question may ask anything about the world, but must not change it. ``changes`` is a list of changes, or a geometry to
insert.

>>> wall = waywright.Shape.segment((30, 0), (30, 100))
>>> world.attempt(wall, lambda changed: changed.find_path((10, 50), (90, 50)).found)
False
>>> world.find_path((10, 50), (90, 50)).found
True
)")
      .def(
          "would_disconnect",
          [](WorldHandle& self, const py::object& changes, const PointsArg& points, const Agent& agent) {
            const std::vector<Change> list = changes_of(changes);
            return self.write([&](World& w) { return w.would_disconnect(list, points.span(), agent).value(); });
          },
          py::arg("changes"), py::arg("points"), py::arg("agent") = Agent{},
          R"(Returns whether changes would block one of the points, or disconnect it from another one.

>>> world.would_disconnect(waywright.Shape.segment((30, 0), (30, 100)), [(10, 50), (90, 50)])
True
)");
  bind_history(world);
}

template <class Class>
void bind_changes_since(Class& world) {
  world.def("changes_since", &changes_since<typename Class::type>, py::arg("version"),
            R"(Returns the boxes that the operations after a version have changed.

The result is None if the world no longer has them, or if ``version`` is above the version of the world.

>>> before = world.version
>>> world.remove(1)
>>> world.changes_since(before)[0].box
(40.0, 40.0, 60.0, 60.0)
)");
}

template void bind_changes_since(WorldClass& world);
template void bind_changes_since(SnapshotClass& snapshot);

}  // namespace waywright::python
