#include <array>
#include <cstdio>
#include <string>

#include "bind.hpp"
#include "structs.hpp"

// The answers of queries other than paths.

namespace waywright::python {

namespace {

std::string text_of(double number) {
  char* const text = PyOS_double_to_string(number, 'r', 0, Py_DTSF_ADD_DOT_0, nullptr);
  const std::string result = text;
  PyMem_Free(text);
  return result;
}

std::string text_of(const std::vector<ItemId>& ids) {
  std::string text = "[";
  for (const ItemId id : ids) text += (text.size() > 1 ? ", " : "") + std::to_string(id.value);
  return text + "]";
}

void bind_agent(py::module_& module) {
  py::class_<Agent> agent(module, "Agent", R"(
What moves: a point, or a disc with a radius.

>>> waywright.Agent(radius=5)
<waywright.Agent radius 5.0>
)");
  bind_members(agent);
  agent.def(py::init(&to_agent), WAYWRIGHT_AGENT_ARGUMENTS)
      .def(
          "__eq__", [](const Agent& a, const Agent& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const Agent& self) { return py::hash(py::float_(self.radius)); })
      .def("__repr__", [](const Agent& self) { return "<waywright.Agent radius " + text_of(self.radius) + ">"; });
}

void bind_location(py::module_& module) {
  py::class_<Location>(module, "Location",
                       "The answer of World.locate(): the vertex, edge or face at a point, and the polygons there.")
      .def_property_readonly(
          "kind", [](const Location& self) { return self.kind; }, "'vertex', 'edge' or 'face'.")
      .def_property_readonly(
          "vertices",
          [](const Location& self) {
            py::list vertices;
            for (std::size_t i = 0; i < self.vertex_count; ++i) vertices.append(self.vertices[i]);
            return vertices;
          },
          "The vertex, the two ends of the edge, or the three vertices of the face.")
      .def_property_readonly(
          "polygons", [](const Location& self) { return self.polygons; },
          "The ids of the polygons that contain the point, ascending.")
      .def("__repr__",
           [](const Location& self) {
             return "<waywright.Location " + std::string(to_string(self.kind)) + ", polygons " +
                    text_of(self.polygons) + ">";
           })
      .def(py::pickle(
          [](const Location& self) {
            return py::make_tuple(self.kind, self.vertices, self.vertex_count, bytes_of(self.polygons));
          },
          [](const py::tuple& state) {
            if (state[2].cast<std::size_t>() > 3) throw py::value_error("the pickled location is damaged");
            return Location{state[0].cast<LocationKind>(), state[1].cast<std::array<Point, 3>>(),
                            state[2].cast<std::size_t>(), from_bytes<ItemId>(state[3].cast<py::bytes>())};
          }));
}

void bind_ray_hit(py::module_& module) {
  py::class_<RayHit> hit(module, "RayHit", "The answer of World.ray(): the first wall that the agent touches.");
  bind_members(hit);
  hit.def("__bool__", [](const RayHit& self) { return self.hit; })
      .def(
          "__eq__", [](const RayHit& a, const RayHit& b) { return a == b; }, py::is_operator())
      .def("__repr__", [](const RayHit& self) {
        if (!self.hit) return std::string("<waywright.RayHit none>");
        return "<waywright.RayHit at " + to_string(self.at) + ", items " + text_of(self.items) + ">";
      });
}

void bind_fits(py::module_& module) {
  py::class_<DiscFit> fit(module, "DiscFit", "The answer of World.fit_disc(): whether a disc fits at a position.");
  bind_members(fit);
  fit.def("__bool__", [](const DiscFit& self) { return self.fits; })
      .def(
          "__eq__", [](const DiscFit& a, const DiscFit& b) { return a == b; }, py::is_operator())
      .def("__repr__", [](const DiscFit& self) {
        return self.fits ? "<waywright.DiscFit fits>" : "<waywright.DiscFit stopped by " + text_of(self.items) + ">";
      });
  py::class_<NearestFit> nearest(module, "NearestFit",
                                 "The answer of World.nearest_fit(): the nearest point where a disc fits.");
  bind_members(nearest);
  nearest.def("__bool__", [](const NearestFit& self) { return self.is_found; })
      .def(
          "__eq__", [](const NearestFit& a, const NearestFit& b) { return a == b; }, py::is_operator())
      .def("__repr__", [](const NearestFit& self) {
        if (!self.is_found) return std::string("<waywright.NearestFit none>");
        return "<waywright.NearestFit at " + to_string(self.at) + ", " + text_of(self.distance) + " away>";
      });
}

void bind_widest(py::module_& module) {
  py::class_<WidestPath> widest(module, "WidestPath",
                                "The largest disc that can move from a start to a goal, and the gap that stops "
                                "every larger disc.");
  bind_members(widest);
  widest
      .def_property_readonly(
          "gap", [](const WidestPath& self) { return py::make_tuple(self.from, self.to); }, "The two ends of the gap.")
      .def(
          "__eq__", [](const WidestPath& a, const WidestPath& b) { return a == b; }, py::is_operator())
      .def("__repr__", [](const WidestPath& self) {
        if (!self.is_connected) return std::string("<waywright.WidestPath not connected>");
        std::string text = "<waywright.WidestPath radius " + text_of(self.radius);
        if (self.is_limited) text += ", gap " + to_string(self.from) + " to " + to_string(self.to);
        return text + ">";
      });
}

/// Returns the index in the list's ids of the first id at each end of each bridge, and the number of ids.
std::vector<std::int64_t> id_offsets(const BridgeList& list) {
  std::vector<std::int64_t> offsets;
  offsets.reserve(2 * list.bridges.size() + 1);
  for (const Bridge& bridge : list.bridges) {
    offsets.push_back(bridge.first_id);
    offsets.push_back(std::int64_t{bridge.first_id} + bridge.from_count);
  }
  offsets.push_back(static_cast<std::int64_t>(list.ids.size()));
  return offsets;
}

void bind_bridges(py::module_& module) {
  const auto first = [](const BridgeList& list) { return list.bridges.empty() ? nullptr : list.bridges.data(); };
  const auto count = [](const BridgeList& list) { return static_cast<py::ssize_t>(list.bridges.size()); };
  py::class_<BridgeList>(module, "BridgeList", R"(
The answer of World.bridges(): the straight connections between two walls at the gaps between them. Its arrays
share its memory.

>>> list = world.bridges()
>>> list.ends.shape == (len(list), 2, 2)
True
)")
      .def_property_readonly(
          "ends",
          [=](const py::object& self) {
            const auto& list = self.cast<const BridgeList&>();
            return view_numbers(first(list) == nullptr ? nullptr : &first(list)->from.x, {count(list), 2, 2},
                                {sizeof(Bridge), sizeof(Point), sizeof(double)}, self);
          },
          "The two ends of each bridge: an array (N, 2, 2). The first end is a corner.")
      .def_property_readonly(
          "radii",
          [=](const py::object& self) {
            const auto& list = self.cast<const BridgeList&>();
            return view_numbers(first(list) == nullptr ? nullptr : &first(list)->radius, {count(list)},
                                {sizeof(Bridge)}, self);
          },
          "The largest radius of a disc that passes each bridge.")
      .def_property_readonly(
          "have_foot",
          [=](const py::object& self) {
            const auto& list = self.cast<const BridgeList&>();
            return view_numbers(first(list) == nullptr ? nullptr : &first(list)->has_foot, {count(list)},
                                {sizeof(Bridge)}, self);
          },
          "Whether each bridge ends strictly inside a wall.")
      .def_property_readonly(
          "ids",
          [](const py::object& self) {
            const auto& ids = self.cast<const BridgeList&>().ids;
            return view_numbers(ids.empty() ? nullptr : &ids.data()->value, {static_cast<py::ssize_t>(ids.size())},
                                {sizeof(ItemId)}, self);
          },
          "The ids of the items at the first end, then at the second end, bridge after bridge; 0 stands for the border "
          "of the domain.")
      .def_property_readonly(
          "id_offsets", [](const BridgeList& self) { return own_numbers(id_offsets(self)); },
          "The index in ``ids`` of the first id at each end of each bridge, and the number of ids: 2 N + 1 numbers.")
      .def("__len__", [](const BridgeList& self) { return self.bridges.size(); })
      .def(
          "__eq__", [](const BridgeList& a, const BridgeList& b) { return a == b; }, py::is_operator())
      .def("__repr__",
           [](const BridgeList& self) {
             return "<waywright.BridgeList " + std::to_string(self.bridges.size()) + " bridges>";
           })
      .def(py::pickle([](const BridgeList& self) { return py::make_tuple(bytes_of(self.bridges), bytes_of(self.ids)); },
                      [](const py::tuple& state) {
                        return BridgeList{from_bytes<Bridge>(state[0].cast<py::bytes>()),
                                          from_bytes<ItemId>(state[1].cast<py::bytes>())};
                      }));
}

}  // namespace

void bind_answers(py::module_& module) {
  bind_agent(module);
  bind_location(module);
  bind_ray_hit(module);
  bind_fits(module);
  bind_widest(module);
  bind_bridges(module);
}

}  // namespace waywright::python
