#include "bind.hpp"

// The module waywright._core. The package waywright shows its names.

PYBIND11_MODULE(_core, module) {
  using namespace waywright::python;
  module.attr("__version__") = WAYWRIGHT_VERSION;
  module.attr("LARGEST_COORDINATE") = waywright::kLargestCoordinate;
  module.attr("SMALLEST_COORDINATE") = waywright::kSmallestCoordinate;
  module.attr("LARGEST_ID") = waywright::ItemId::kLargest;
  py::tuple statuses(kPathStatuses.size());
  for (std::size_t i = 0; i < kPathStatuses.size(); ++i) statuses[i] = py::cast(kPathStatuses[i]);
  module.attr("PATH_STATUSES") = statuses;
  bind_errors(module);
  bind_shapes(module);
  bind_answers(module);
  bind_path(module);
  WorldClass world(module, "World", R"(
A world of obstacles that can change between path queries.

It is a dynamic constrained Delaunay triangulation of a closed box, its domain. Every decision about the mesh is exact.
Geometry is never an error: items may cross, overlap or repeat each other. ``domain`` is the smallest x and y and the
largest x and y. ``keep_abstraction``: whether the world maintains the path abstraction, which makes searches fast.
``keep_bridges``: whether it maintains what paths for a radius above 0 need. ``new_vertex_limit``: the largest number of
vertices that one operation may make; None for no limit.

Several threads may use a world at once: queries run together, and a change waits until it is alone.

In the examples, ``world`` is the world that this example makes:

>>> world = waywright.World((0, 0, 100, 100), keep_bridges=True)
>>> world.insert_polygon([(40, 40), (60, 40), (60, 60), (40, 60)], id=1)
1
>>> world.insert_segment((20, 80), (80, 80))
2
)");
  bind_world(world);
  bind_world_items(world);
  bind_world_changes(world);
  bind_world_queries(world);
  bind_world_paths(world);
  bind_batches(world);
  bind_mesh(module, world);
  bind_search(module);
  bind_watch(module);
  bind_scenes(module, world);
  bind_replay(module);
  bind_svg(world);
}
