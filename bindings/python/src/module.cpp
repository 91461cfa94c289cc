#include "bind.hpp"

// The module waywright._core. The package waywright shows its names.

namespace waywright::python {

namespace {

/// Adds what worlds and snapshots have.
template <class Class>
void bind_queries(Class& world) {
  bind_facts(world);
  bind_saving(world);
  bind_reading_items(world);
  bind_changes_since(world);
  bind_world_queries(world);
  bind_world_paths(world);
  bind_batches(world);
  bind_mesh(world);
  bind_svg(world);
}

}  // namespace

}  // namespace waywright::python

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
No arrangement of items is an error: items may cross, overlap or repeat each other. ``domain`` is the smallest x and y
and the largest x and y. ``keep_abstraction``: whether the world maintains the path abstraction, which makes searches
fast. ``keep_bridges``: whether it maintains what paths for a radius above 0 need. ``new_vertex_limit``: the largest
number of vertices that one operation may make; None for no limit.

Several threads may use a world at once: queries run together, and a change waits until it is alone.

In the examples, ``world`` is the world that this example makes:

>>> world = waywright.World((0, 0, 100, 100), keep_bridges=True)
>>> world.insert_polygon([(40, 40), (60, 40), (60, 60), (40, 60)], id=1)
1
>>> world.insert_segment((20, 80), (80, 80))
2
)");
  SnapshotClass snapshot(module, "Snapshot", R"(
A world that never changes: the state that a world had when its World.publish() was called, or at an earlier tick.

It has all queries of World, with the same answers as the world gave. Any number of threads may use it while another thread
changes the world, and neither waits for the other. release() lets the world use its memory again, and so does the end of a
``with`` statement or of the last reference.

>>> with world.publish() as snapshot:
...     world.remove(1)
...     1 in snapshot, 1 in world
(True, False)
)");
  bind_world(world);
  bind_loading(world);
  bind_world_items(world);
  bind_world_changes(module, world);
  bind_snapshot(snapshot);
  bind_queries(world);
  bind_queries(snapshot);
  bind_mesh_snapshot(module);
  bind_search(module);
  bind_watch(module);
  bind_scenes(module, world);
  bind_replay(module);
}
