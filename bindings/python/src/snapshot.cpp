#include <memory>
#include <string>

#include "bind.hpp"

// Snapshots of worlds, for readers on other threads.

namespace waywright::python {

WorldSnapshot SnapshotHandle::held() const {
  if (!snapshot_) throw py::value_error("this snapshot has been released; World.publish() makes a new one");
  return snapshot_;
}

void SnapshotHandle::release() {
  WorldSnapshot last = std::move(snapshot_);
  const WithoutGil no_gil;
  last.release();
}

void bind_snapshot(SnapshotClass& snapshot) {
  const auto copy = [](const SnapshotHandle& self) { return std::make_shared<SnapshotHandle>(self.copy()); };
  snapshot
      .def("release", &SnapshotHandle::release,
           R"(Lets the world use the memory of the snapshot again. Queries that run on other threads continue.

>>> snapshot = world.publish()
>>> snapshot.release()
>>> snapshot.item_count
Traceback (most recent call last):
ValueError: this snapshot has been released; World.publish() makes a new one
)")
      .def(
          "clone",
          [](const SnapshotHandle& self) {
            return self.read_long([](const World& world) { return std::make_shared<WorldHandle>(world.clone()); });
          },
          R"(Returns an independent world that can change, without history.

>>> changed = world.publish().clone()
>>> changed.remove(1)
>>> 1 in world, 1 in changed
(True, False)
)")
      .def("__copy__", copy)
      .def(
          "__deepcopy__", [copy](const SnapshotHandle& self, const py::dict&) { return copy(self); }, py::arg("memo"))
      .def(
          "__reduce_ex__",
          [](const SnapshotHandle&, int) -> py::object {
            throw py::type_error("a snapshot cannot be pickled: pickle its clone(), which is a World");
          },
          py::arg("protocol"))
      .def("__bool__", &SnapshotHandle::is_held)
      .def("__enter__", [](const py::object& self) { return self; })
      .def("__exit__", [](SnapshotHandle& self, const py::args&) { self.release(); })
      .def("__repr__", [](const SnapshotHandle& self) {
        if (!self.is_held()) return std::string("<waywright.Snapshot released>");
        return self.read([](const World& world) {
          return "<waywright.Snapshot " + facts_of(world) + ", version " + std::to_string(world.version()) + ">";
        });
      });
}

}  // namespace waywright::python
