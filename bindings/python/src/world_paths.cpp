#include <memory>
#include <optional>

#include "bind.hpp"
#include "path.hpp"
#include "structs.hpp"

// Queries for one path, and for the paths from one start.

namespace waywright::python {

namespace {

template <class Handle>
std::unique_ptr<Path> find_path(const Handle& self, Point start, Point goal, WAYWRIGHT_PATH_QUERY_PARAMETERS) {
  const PathQuery query = to_path_query(start, goal, WAYWRIGHT_PATH_QUERY_NAMES);
  auto path = std::make_unique<Path>();
  const ContextPool::Loan context(self.contexts());
  self.read_long([&](const World& world) { world.find_path(query, *context, *path).value(); });
  return path;
}

template <class Handle>
std::vector<Path> find_paths_from(const Handle& self, Point start, const PointsArg& goals,
                                  WAYWRIGHT_MANY_GOALS_QUERY_PARAMETERS) {
  const ManyGoalsQuery query = to_many_goals_query(start, goals, WAYWRIGHT_MANY_GOALS_QUERY_NAMES);
  const ContextPool::Loan context(self.contexts());
  return self.read_long([&](const World& world) {
    std::vector<Path> paths;
    world.find_paths_from(query, *context, paths).value();
    return paths;
  });
}

template <class Class>
void bind_affected(Class& world) {
  using Handle = typename Class::type;
  world
      .def(
          "is_affected",
          [](const Handle& self, const py::object& path, std::uint64_t since, const std::optional<Agent>& agent) {
            if (py::isinstance<Path>(path)) {
              if (agent) throw py::type_error("a Path has its own agent");
              const auto& known = path.cast<const Path&>();
              return self.read([&](const World& w) { return w.is_affected(known, since); });
            }
            const auto points = path.cast<PointsArg>();
            return self.read(
                [&](const World& w) { return w.is_affected(points.span(), since, agent.value_or(Agent{})); });
          },
          py::arg("path"), py::arg("version"), py::arg("agent") = py::none(),
          "Returns whether an agent on a path or on a list of points meets a box that an operation after a version has "
          "changed. A list of points takes an agent; a Path has its own.")
      .def(
          "find_affected",
          [](const Handle& self, const py::iterable& paths, std::uint64_t since) {
            // The iterable may run code of Python, which may use the world.
            const py::list list(paths);
            std::vector<const Path*> all;
            for (const py::handle path : list) {
              if (!py::isinstance<Path>(path)) throw py::type_error("paths must be a list of Path");
              all.push_back(&path.cast<const Path&>());
            }
            std::vector<std::size_t> affected;
            self.read([&](const World& w) {
              for (std::size_t i = 0; i < all.size(); ++i) {
                if (w.is_affected(*all[i], since)) affected.push_back(i);
              }
            });
            return affected;
          },
          py::arg("paths"), py::arg("version"), "Returns the indices of the paths for which is_affected() is true.");
}

}  // namespace

template <class Class>
void bind_world_paths(Class& world) {
  using Handle = typename Class::type;
  world
      .def("find_path", &find_path<Handle>, py::arg("start"), py::arg("goal"), WAYWRIGHT_PATH_QUERY_ARGUMENTS,
           R"(Finds a path from a start to a goal. "No path" is an answer, not an error.

For an agent with a radius, it is the shortest path of a disc's centre, in Path.pieces; the world must keep its bridges.
``algorithm`` is 'optimal', 'ta' (a first path quickly, and a better one with a budget) or 'tra' (for crowds).
``end_tolerance``: the largest distance by which the search may move a blocked end. ``budget_expansions``: the number of
triangles, ``budget_time``: the number of seconds that a search by 'ta' may use.

>>> world.find_path((10, 45), (90, 45), agent=waywright.Agent(radius=5))
<waywright.Path found, length 83.30297354829254, 5 pieces, radius 5.0>
>>> world.find_path((50, 50), (90, 45)).status
'start-blocked'
)")
      .def("find_paths_from", &find_paths_from<Handle>, py::arg("start"), py::arg("goals"),
           WAYWRIGHT_MANY_GOALS_QUERY_ARGUMENTS,
           R"(Finds the shortest path from a start to each goal. Returns a list of paths.

With ``wants_points=False`` the paths have a status and a length only.

>>> [round(path.length, 3) for path in world.find_paths_from((10, 50), [(90, 50), (90, 90)])]
[83.246, 90.3]
)");
  bind_affected(world);
}

template void bind_world_paths(WorldClass& world);
template void bind_world_paths(SnapshotClass& snapshot);

}  // namespace waywright::python
