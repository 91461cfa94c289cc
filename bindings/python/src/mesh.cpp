#include <cstddef>
#include <string>

#include "bind.hpp"

// The mesh as arrays, its dump, its hash and its validation.

namespace waywright::python {

namespace {

using Edges = MeshSnapshot::ConstrainedEdge;

py::array constrained_edges_of(const py::object& self) {
  const auto& edges = self.cast<const MeshSnapshot&>().constraints;
  return view_numbers(edges.empty() ? nullptr : edges.data()->vertices.data(),
                      {static_cast<py::ssize_t>(edges.size()), 2}, {sizeof(Edges), sizeof(std::uint32_t)}, self);
}

std::vector<std::int64_t> id_offsets(const MeshSnapshot& mesh) {
  std::vector<std::int64_t> offsets;
  offsets.reserve(mesh.constraints.size() + 1);
  for (const Edges& edge : mesh.constraints) offsets.push_back(edge.first_id);
  offsets.push_back(static_cast<std::int64_t>(mesh.ids.size()));
  return offsets;
}

}  // namespace

void bind_mesh_snapshot(py::module_& module) {
  py::class_<MeshSnapshot>(module, "MeshSnapshot", R"(
A copy of the mesh of a world in canonical order. Its arrays share its memory.

>>> mesh = world.snapshot()
>>> mesh
<waywright.MeshSnapshot 10 vertices, 14 triangles, 9 constrained edges>
>>> mesh.vertices[mesh.triangles[0]].shape
(3, 2)
)")
      .def_property_readonly(
          "vertices",
          [](const py::object& self) { return view_points(self.cast<const MeshSnapshot&>().vertices, self); },
          "The vertices, sorted by (x, y), each coordinate rounded to the nearest double: an array (N, 2).")
      .def_property_readonly(
          "triangles",
          [](const py::object& self) {
            const auto& triangles = self.cast<const MeshSnapshot&>().triangles;
            return view_numbers(triangles.empty() ? nullptr : triangles.data()->data(),
                                {static_cast<py::ssize_t>(triangles.size()), 3},
                                {3 * sizeof(std::uint32_t), sizeof(std::uint32_t)}, self);
          },
          "The indices of the vertices of each triangle, counter-clockwise: an array (N, 3).")
      .def_property_readonly("constrained_edges", &constrained_edges_of,
                             "The indices of the two vertices of each constrained edge: (N, 2).")
      .def_property_readonly(
          "ids",
          [](const py::object& self) {
            const auto& ids = self.cast<const MeshSnapshot&>().ids;
            return view_numbers(ids.empty() ? nullptr : &ids.data()->value, {static_cast<py::ssize_t>(ids.size())},
                                {sizeof(ItemId)}, self);
          },
          "The ids of the items on the constrained edges, edge after edge; 0 stands for the border of the domain.")
      .def_property_readonly(
          "id_offsets", [](const MeshSnapshot& self) { return own_numbers(id_offsets(self)); },
          "The index in ``ids`` of the first id of each constrained edge, and the number of ids.")
      .def("__repr__",
           [](const MeshSnapshot& self) {
             return "<waywright.MeshSnapshot " + std::to_string(self.vertices.size()) + " vertices, " +
                    std::to_string(self.triangles.size()) + " triangles, " + std::to_string(self.constraints.size()) +
                    " constrained edges>";
           })
      .def(py::pickle(
          [](const MeshSnapshot& self) {
            return py::make_tuple(bytes_of(self.vertices), bytes_of(self.triangles), bytes_of(self.constraints),
                                  bytes_of(self.ids));
          },
          [](const py::tuple& state) {
            return MeshSnapshot{from_bytes<Point>(state[0].cast<py::bytes>()),
                                from_bytes<std::array<std::uint32_t, 3>>(state[1].cast<py::bytes>()),
                                from_bytes<Edges>(state[2].cast<py::bytes>()),
                                from_bytes<ItemId>(state[3].cast<py::bytes>())};
          }));
}

template <class Class>
void bind_mesh(Class& world) {
  using Handle = typename Class::type;
  world
      .def(
          "snapshot",
          [](const Handle& self) {
            auto mesh = std::make_unique<MeshSnapshot>();
            const ContextPool::Loan context(self.contexts());
            self.read_long([&](const World& w) { w.snapshot(*context, *mesh); });
            return mesh;
          },
          "Returns a copy of the mesh.")
      .def(
          "dump", [](const Handle& self) { return self.read_long([](const World& w) { return w.dump(); }); },
          "Returns the mesh as canonical text with exact coordinates.")
      .def(
          "mesh_hash",
          [](const Handle& self) { return self.read_long([](const World& w) { return to_string(w.mesh_hash()); }); },
          "Returns the SHA-256 of dump(), as 64 hexadecimal digits.")
      .def(
          "validate",
          [](const Handle& self) {
            const Validation result = self.read_long([](const World& w) { return w.validate(); });
            return result.ok ? py::object(py::none()) : py::str(result.fault);
          },
          R"(Checks the whole world, exactly. Returns the first fault, or None if there is none.

>>> world.validate() is None
True
)");
}

template void bind_mesh(WorldClass& world);
template void bind_mesh(SnapshotClass& snapshot);

}  // namespace waywright::python
