#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "bind.hpp"
#include "path.hpp"
#include "structs.hpp"

// Searches in slices.

namespace waywright::python {

namespace {

/// A search, and the world or the snapshot that it searches. The search has its own handle of the snapshot. So the
/// immutable world exists as long as the search, even after Snapshot.release().
struct SearchHandle {
  using BoundToPython = void;

  WorldOrSnapshot searched;
  PathSearch search;
};

WorldPointer kept(const WorldPointer& world) { return world; }
SnapshotPointer kept(const SnapshotPointer& snapshot) { return std::make_shared<SnapshotHandle>(snapshot->copy()); }

// To wait for a world releases the GIL. Another thread can begin another search before the wait ends.
void begin(SearchHandle& self, const WorldOrSnapshot& world, Point start, Point goal, WAYWRIGHT_PATH_QUERY_PARAMETERS) {
  const PathQuery query = to_path_query(start, goal, WAYWRIGHT_PATH_QUERY_NAMES);
  const auto begin_in = [&](const auto& pointer) {
    pointer->refuse_in_attempt();
    const auto searched = kept(pointer);
    return searched->read([&](const World& w) {
      self.search.begin(w, query).value();
      return std::exchange(self.searched, searched);
    });
  };
  static_cast<void>(std::visit(begin_in, world));
}

bool step(SearchHandle& self, std::size_t expansions) {
  if (!self.search.is_running()) return true;
  const WorldOrSnapshot searched = self.searched;
  const auto step_in = [&](const auto& pointer) {
    pointer->refuse_in_attempt();
    return pointer->read([&](const World&) {
      if (self.searched != searched) throw std::runtime_error("another thread has begun another search");
      return self.search.step(expansions).value();
    });
  };
  return std::visit(step_in, searched);
}

/// Returns the type of the elements of an array of windows.
py::dtype window_type() {
  const auto names = py::make_tuple("root", "edge", "interval", "length", "bound");
  const auto formats = py::make_tuple("2f8", "(2,2)f8", "(2,2)f8", "f8", "f8");
  const auto offsets =
      py::make_tuple(offsetof(SearchWindow, root), offsetof(SearchWindow, edge), offsetof(SearchWindow, interval),
                     offsetof(SearchWindow, length), offsetof(SearchWindow, bound));
  return py::dtype(py::list(names), py::list(formats), py::list(offsets), sizeof(SearchWindow));
}

/// Copies the windows: the search writes to its list again.
py::array windows_of(const SearchHandle& self) {
  const auto windows = self.search.windows();
  return py::array(window_type(), {static_cast<py::ssize_t>(windows.size())}, {sizeof(SearchWindow)}, windows.data());
}

}  // namespace

void bind_search(py::module_& module) {
  py::class_<SearchHandle>(module, "PathSearch", R"(
A path search in slices, for a search that takes longer than one frame of a program has.

Between the slices the world may change: the search then continues, or starts again if the change concerns it.

>>> search = waywright.PathSearch()
>>> search.begin(world, (10, 45), (90, 45))
>>> while not search.step(100):
...     pass  # run one frame; it may insert and remove items
>>> search.path.found
True
)")
      .def(py::init([] { return std::make_unique<SearchHandle>(); }))
      .def("begin", &begin, py::arg("world").none(false), py::arg("start"), py::arg("goal"),
           WAYWRIGHT_PATH_QUERY_ARGUMENTS,
           "Starts a search in a world or a snapshot, and cancels the search that is running, if there is one. See "
           "World.find_path().")
      .def("step", &step, py::arg("expansions"),
           "Continues the search for this number of triangles. Returns whether the search is done.")
      .def_property_readonly(
          "path", [](const SearchHandle& self) { return Path(self.search.path()); },
          "A copy of the answer or, before the search is done, of the best path so far.")
      .def_property_readonly(
          "restarts", [](const SearchHandle& self) { return self.search.restarts(); },
          "How often the search has started again because of changes of the world.")
      .def(
          "record_windows", [](SearchHandle& self, bool wanted) { self.search.record_windows(wanted); },
          py::arg("wanted") = true, "Sets whether the searches that begin from now on record their windows.")
      .def_property_readonly("windows", &windows_of, R"(
The windows that the search has followed, one or more for each triangle that it has entered: an array of WINDOW_DTYPE.

A window is the piece of an edge that is visible from its root: the start of the path, or a point at which the path
turns. The fields are ``root``, ``edge`` and ``interval`` (the left and the right end of each), ``length`` (of the path
to the root) and ``bound`` (no path through the window to the goal is shorter). The array is empty if the search does
not record windows, if the algorithm is not ``"optimal"``, if the radius is above 0, or if no search was necessary, for
example because the straight segment meets no wall, and no vertex between its ends.

>>> search = waywright.PathSearch()
>>> search.record_windows()
>>> search.begin(world, (10, 45), (90, 45))
>>> while not search.step(100):
...     pass
>>> len(search.windows) >= search.path.expansions
True
>>> search.windows["root"][0].tolist()
[10.0, 45.0]
)")
      .def_property_readonly(
          "is_running", [](const SearchHandle& self) { return self.search.is_running(); },
          "Whether a search has begun and is neither done nor cancelled.")
      .def(
          "cancel", [](SearchHandle& self) { self.search.cancel(); }, "Cancels the search.")
      .def("__reduce_ex__", &refuse_pickle, py::arg("protocol"))
      .def("__repr__", [](const SearchHandle& self) {
        return std::string("<waywright.PathSearch ") + (self.search.is_running() ? "running>" : "not running>");
      });
  module.attr("WINDOW_DTYPE") = window_type();
}

}  // namespace waywright::python
