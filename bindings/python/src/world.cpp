#include <optional>
#include <string>

#include "bind.hpp"
#include "structs.hpp"

// Worlds: making, copying, and facts about the whole world.

namespace waywright::python {

namespace {

WorldPointer create(const Box& domain, WAYWRIGHT_WORLD_OPTIONS_PARAMETERS) {
  return std::make_shared<WorldHandle>(World::create(domain, to_world_options(WAYWRIGHT_WORLD_OPTIONS_NAMES)).value());
}

SnapshotPointer publish(WorldHandle& self, std::optional<std::uint64_t> tick) {
  self.refuse_in_attempt();
  return std::make_shared<SnapshotHandle>(
      self.write([&](World& world) { return tick ? world.publish(*tick).value() : world.publish(); }), self.pool());
}

WorldPointer clone(const WorldHandle& self) {
  self.refuse_in_attempt();
  return self.read_long([&](const World& world) {
    auto copy = std::make_shared<WorldHandle>(world.clone());
    copy->keeps_history = self.keeps_history;
    return copy;
  });
}

}  // namespace

void bind_world(WorldClass& world) {
  world.def(py::init(&create), py::arg("domain"), WAYWRIGHT_WORLD_OPTIONS_ARGUMENTS)
      .def("clone", &clone, R"(Returns an independent copy, with the same answers and the same ids for later items.

>>> copy = world.clone()
>>> copy.remove(1)
>>> 1 in world, 1 in copy
(True, False)
)")
      .def("__copy__", &clone)
      .def(
          "__deepcopy__", [](const WorldHandle& self, const py::dict&) { return clone(self); }, py::arg("memo"))
      .def(
          "shrink_to_fit",
          [](WorldHandle& self) {
            self.write([](World& w) { w.shrink_to_fit(); });
            self.contexts().clear();
          },
          "Frees most of the spare memory.")
      .def_property(
          "new_vertex_limit",
          [](const WorldHandle& self) { return self.read([](const World& w) { return limit_of(w); }); },
          [](WorldHandle& self, std::optional<std::size_t> limit) {
            self.write([&](World& w) { w.set_new_vertex_limit(limit.value_or(kNoVertexLimit)); });
          },
          "The largest number of vertices that one operation may make; None for no limit.")
      .def("publish", &publish, py::arg("tick") = py::none(),
           R"(Returns a snapshot: an immutable world with the state of this moment, for readers on other threads.

The first call copies the world. A later call repeats what has changed in the memory of a snapshot that has been released,
so its cost depends on the changes.

>>> snapshot = world.publish()
>>> world.remove(1)
>>> snapshot.find_path((10, 50), (90, 50)).length > world.find_path((10, 50), (90, 50)).length
True

With ``tick``, the snapshot has the state of an earlier tick, and the world does not change. To keep many earlier states,
keep a history instead of their snapshots: it takes memory only for the items that have changed.

>>> world.keep_history(600)
>>> tick = world.mark()
>>> world.remove(2)
>>> 2 in world, 2 in world.publish(tick)
(False, True)
)")
      .def("__repr__", [](const WorldHandle& self) {
        return self.read([](const World& w) { return "<waywright.World " + facts_of(w) + ">"; });
      });
}

template <class Class>
void bind_facts(Class& world) {
  using Handle = typename Class::type;
  world.def(
      "memory", [](const Handle& self) { return to_dict(self.read([](const World& w) { return w.memory(); })); },
      "Returns the bytes that the world takes, by purpose, and their sum as 'total'.");
  const auto fact = [&world](const char* name, auto read, const char* doc) {
    world.def_property_readonly(
        name, [read](const Handle& self) { return self.read(read); }, doc);
  };
  fact(
      "domain", [](const World& w) { return w.domain(); }, "The smallest x and y and the largest x and y.");
  fact(
      "item_count", [](const World& w) { return w.item_count(); }, "The number of items.");
  fact(
      "vertex_count", [](const World& w) { return w.vertex_count(); }, "The number of vertices of the mesh.");
  fact(
      "triangle_count", [](const World& w) { return w.triangle_count(); }, "The number of triangles of the mesh.");
  fact(
      "version", [](const World& w) { return w.version(); },
      "The number of operations that the world has carried out.");
  fact(
      "items_hash", [](const World& w) { return w.items_hash(); },
      "The hash of the domain and the items, as 32 hexadecimal digits. It is equal for equal items on every machine.");
  fact(
      "largest_id_seen", [](const World& w) { return w.largest_id_seen(); }, "The largest id that the world has seen.");
  fact(
      "default_end_tolerance", [](const World& w) { return w.default_end_tolerance(); },
      "The default of ``end_tolerance`` in path queries.");
  world.def_property_readonly(
      "options", [](const Handle& self) { return to_dict(self.read([](const World& w) { return w.options(); })); },
      R"(The options, as World() takes them.

>>> waywright.World((0, 0, 1, 1), **world.options).options["keep_bridges"]
True
)");
}

template void bind_facts(WorldClass& world);
template void bind_facts(SnapshotClass& snapshot);

}  // namespace waywright::python
