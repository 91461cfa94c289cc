#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "bind.hpp"

// Paths that are watched for changes of the world.

namespace waywright::python {

namespace {

/// A watch, and its world. A watch for a snapshot has no world: it reads only snapshots.
struct WatchHandle {
  using BoundToPython = void;

  template <class Handle>
  WatchHandle(WorldPointer own, const Handle& handle)
      : world(std::move(own)), pool(handle.pool()), watch(handle.read([&](const World& w) {
          version = w.version();
          return PathWatch(w);
        })) {}

  WorldPointer world;
  std::shared_ptr<ContextPool> pool;  ///< of the world, and of no other one
  std::uint64_t version = 0;          ///< of the world at the last update
  PathWatch watch;
};

std::unique_ptr<WatchHandle> make(const WorldOrSnapshot& world) {
  const auto* const snapshot = std::get_if<SnapshotPointer>(&world);
  if (snapshot != nullptr) return std::make_unique<WatchHandle>(nullptr, **snapshot);
  const auto& own = std::get<WorldPointer>(world);
  own->refuse_in_attempt();
  return std::make_unique<WatchHandle>(own, *own);
}

template <class Handle>
PathChanges update_from(WatchHandle& self, const Handle& handle) {
  handle.refuse_in_attempt();
  return handle.read([&](const World& world) {
    if (world.version() < self.version) throw py::value_error("the snapshot is older than the last update");
    PathChanges changes;
    self.watch.update(world, changes);
    self.version = world.version();
    return changes;
  });
}

PathChanges update(WatchHandle& self, const SnapshotHandle* snapshot) {
  if (snapshot == nullptr) {
    if (!self.world) throw py::value_error("this watch was made for a snapshot: give update() a later snapshot");
    return update_from(self, *self.world);
  }
  if (snapshot->pool() != self.pool) throw py::value_error("the snapshot is of another world than the watch");
  return update_from(self, *snapshot);
}

std::string repr_of_changes(const PathChanges& changes) {
  return "<waywright.PathChanges " + std::to_string(changes.blocked.size()) + " blocked, " +
         std::to_string(changes.may_be_blocked.size()) + " may be blocked, " +
         std::to_string(changes.may_be_too_long.size()) + " may be too long>";
}

void bind_path_changes(py::module_& module) {
  py::class_<PathChanges>(
      module, "PathChanges",
      "The answer of PathWatch.update(): the keys of the paths that the operations affect, ascending.")
      .def_property_readonly(
          "blocked", [](const PathChanges& self) { return self.blocked; },
          "The paths of point agents that are not clear any more.")
      .def_property_readonly(
          "may_be_blocked", [](const PathChanges& self) { return self.may_be_blocked; },
          "The paths of discs near which an item was inserted.")
      .def_property_readonly(
          "may_be_too_long", [](const PathChanges& self) { return self.may_be_too_long; },
          "The paths that may be longer than necessary, because an item was removed, and those that have become "
          "possible.")
      .def(
          "__eq__", [](const PathChanges& a, const PathChanges& b) { return a == b; }, py::is_operator())
      .def("__reduce_ex__", &refuse_pickle, py::arg("protocol"))
      .def("__repr__", &repr_of_changes);
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
      .def(py::init(&make), py::arg("world").none(false))
      .def(
          "add",
          [](WatchHandle& self, std::uint64_t key, const Path& path) {
            if (path.status == PathStatus::found && path.points.empty() && path.pieces.empty()) {
              throw py::value_error("this path has no points: find_paths_from() gives them with wants_points=True");
            }
            self.watch.add(key, path);
          },
          py::arg("key"), py::arg("path"), "Watches a path under a key.")
      .def(
          "remove", [](WatchHandle& self, std::uint64_t key) { return self.watch.remove(key); }, py::arg("key"),
          "Stops watching the path under a key. Returns whether there was one.")
      .def("update", &update, py::arg("snapshot") = py::none(),
           R"(Finds out what the operations since the last update mean for the paths.

Without ``snapshot``, it asks the world as it is now. The snapshot must be one of this world, and not be older than the
last update.

>>> watch = waywright.PathWatch(world)
>>> watch.add(7, world.find_path((10, 70), (90, 70)))
>>> world.insert_segment((30, 65), (30, 75))
3
>>> list(watch.update(world.publish()).blocked)
[7]
)")
      .def(
          "__contains__", [](const WatchHandle& self, std::uint64_t key) { return self.watch.contains(key); },
          py::arg("key"))
      .def("__len__", [](const WatchHandle& self) { return self.watch.size(); })
      .def("__bool__", [](const WatchHandle&) { return true; })
      .def("__reduce_ex__", &refuse_pickle, py::arg("protocol"))
      .def("__repr__", [](const WatchHandle& self) {
        return "<waywright.PathWatch of " + std::to_string(self.watch.size()) + " paths>";
      });
}

}  // namespace waywright::python
