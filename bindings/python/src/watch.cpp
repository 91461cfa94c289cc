#include <memory>
#include <string>

#include "bind.hpp"

// Paths that are watched for changes of the world.

namespace waywright::python {

namespace {

/// A watch, and its world.
struct WatchHandle {
  explicit WatchHandle(WorldPointer of)
      : world(std::move(of)), watch(world->read([](const World& w) { return PathWatch(w); })) {}

  WorldPointer world;
  PathWatch watch;
};

PathChanges update(WatchHandle& self) {
  PathChanges changes;
  self.world->refuse_in_attempt();
  self.world->read([&](const World& world) { self.watch.update(world, changes); });
  return changes;
}

std::string repr_of(const PathChanges& changes) {
  return "<waywright.PathChanges " + std::to_string(changes.blocked.size()) + " blocked, " +
         std::to_string(changes.may_be_blocked.size()) + " may be blocked, " +
         std::to_string(changes.may_be_too_long.size()) + " may be too long>";
}

void bind_path_changes(py::module_& module) {
  py::class_<PathChanges>(
      module, "PathChanges",
      "The answer of PathWatch.update(): the keys of the paths that the operations concern, ascending.")
      .def_property_readonly(
          "blocked", [](const PathChanges& self) { return self.blocked; },
          "The paths of point agents that are not clear any more.")
      .def_property_readonly(
          "may_be_blocked", [](const PathChanges& self) { return self.may_be_blocked; },
          "The paths of discs near which an item was inserted.")
      .def_property_readonly(
          "may_be_too_long", [](const PathChanges& self) { return self.may_be_too_long; },
          "The paths that may be longer than necessary, because an item was removed.")
      .def(
          "__eq__", [](const PathChanges& a, const PathChanges& b) { return a == b; }, py::is_operator())
      .def("__repr__", &repr_of);
}

}  // namespace

void bind_watch(py::module_& module) {
  bind_path_changes(module);
  py::class_<WatchHandle>(module, "PathWatch", R"(
Watches the paths of many agents. After operations, it finds the paths that the agents should search for again.

>>> watch = waywright.PathWatch(world)
>>> watch.add(7, world.find_path((10, 70), (90, 70)))
>>> world.insert_segment((30, 65), (30, 75))
3
>>> watch.update().blocked
[7]
)")
      .def(py::init([](WorldPointer world) { return std::make_unique<WatchHandle>(std::move(world)); }),
           py::arg("world"))
      .def(
          "add", [](WatchHandle& self, std::uint64_t key, const Path& path) { self.watch.add(key, path); },
          py::arg("key"), py::arg("path"), "Watches a path under a key.")
      .def(
          "remove", [](WatchHandle& self, std::uint64_t key) { return self.watch.remove(key); }, py::arg("key"),
          "Stops watching the path under a key. Returns whether there was one.")
      .def("update", &update, "Finds out what the operations since the last update mean for the paths.")
      .def(
          "__contains__", [](const WatchHandle& self, std::uint64_t key) { return self.watch.contains(key); },
          py::arg("key"))
      .def("__len__", [](const WatchHandle& self) { return self.watch.size(); })
      .def("__bool__", [](const WatchHandle&) { return true; })
      .def("__repr__", [](const WatchHandle& self) {
        return "<waywright.PathWatch of " + std::to_string(self.watch.size()) + " paths>";
      });
}

}  // namespace waywright::python
