#pragma once

#include <cstddef>
#include <functional>
#include <limits>

#include "waywright/job_system.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// The value of WorldOptions::new_vertex_limit that means "no limit".
inline constexpr std::size_t kNoVertexLimit = std::numeric_limits<std::size_t>::max();

/// The options of World::create.
///
/// @code{.cpp}
/// World mesh_only = World::create({{0, 0}, {10, 10}}, {.keep_abstraction = false}).value();
/// @endcode
struct WorldOptions {
  /// Whether the world maintains the path abstraction: data that says which triangles are connected, which polygons
  /// cover them, and which triangles lie in dead ends. Without the abstraction, an operation costs less, and a world
  /// takes 10 bytes less for each vertex (up to 18 bytes less if operations have changed walls in all parts of the
  /// world). But then many path queries enter far more triangles, each query that needs the polygons at a point takes
  /// time that grows with the world, and PathAlgorithm::tra, World::would_disconnect and World::nearest_fit with
  /// a goal return not_supported for point agents.
  bool keep_abstraction = true;
  /// Whether the world maintains the bridges of its walls: the shortest connections between two walls at each gap. They
  /// say how wide the gaps are, for discs of any radius. World::bridges, World::widest_path and path queries with a
  /// radius above 0 need them, and World::would_disconnect and World::nearest_fit with a goal need them for such a
  /// radius. An operation then takes about twice as long, because it also updates the bridges near its
  /// changes. A world takes about 110 bytes more for each vertex. If an item is a point or has a ring with only one
  /// corner, the world also keeps a second mesh, which contains only the walls, and each operation changes both meshes.
  /// World::shrink_to_fit() drops the second mesh if no item needs it any more. The first such item
  /// costs as much as a new world, because the world then makes the second mesh.
  ///
  /// There are scenes in which bridges cost far more: if n walls end on one line, like the teeth of a comb, or are
  /// nearly parallel, and face a large open area, each bridge across this area costs up to n steps. With a comb of
  /// 1,000 short walls, bridges take most of the time of a bulk load (50 ms); with 4,000 walls, the load takes 16 times
  /// as long.
  bool keep_bridges = false;
  /// The largest number of vertices that one operation may make. World::set_new_vertex_limit changes it. World::rewind
  /// has no limit, because the world had its vertices before.
  ///
  /// Few points can make many vertices: two polylines of n points can have n^2 crossings. So set a limit if your
  /// program takes shapes from people whom you do not know. Limit the number of points, too: sides that lie on existing
  /// edges make no vertices, but take time and memory. To limit the size of a world, set the limit to the difference
  /// between your largest size and World::vertex_count().
  ///
  /// The limit counts the vertices at new corners and the vertices at new crossings. It does not count vertices that
  /// exist already. If an operation changes several items, the limit applies to the sum of their new vertices. If the
  /// removal of an item removes a vertex and an insertion of the same operation makes this vertex again, the vertex
  /// counts.
  ///
  /// An operation that would make more vertices stops, takes all its changes back and returns too_many_vertices.
  /// Error::item is the item at which it exceeded the limit. World::insert_all, insert_points and apply choose the
  /// order in which they make the vertices of the items. So Error::item need not be the item with the most vertices. A
  /// refused operation costs the check of all its points, the work until it exceeded the limit, and taking this work
  /// back.
  ///
  /// @code{.cpp}
  /// World board = World::create({{0, 0}, {100, 100}}, {.new_vertex_limit = 3}).value();
  /// board.insert_segment({10, 50}, {90, 50}).value();  // makes 2 vertices: the ends
  /// board.insert_segment({50, 10}, {50, 90}).value();  // makes 3: the ends and a crossing
  /// const Result<ItemId> refused = board.insert_segment({20, 40}, {60, 60});  // 4: the ends and two crossings
  /// const bool is_refused = refused.error().code == ErrorCode::too_many_vertices;  // == true
  /// @endcode
  std::size_t new_vertex_limit = kNoVertexLimit;
};

/// The options of World::insert_all and World::insert_points.
///
/// @code{.cpp}
/// BulkOptions options;
/// options.threads = 2;
/// options.progress = [](std::size_t done, std::size_t total) { std::printf("%zu of %zu\n", done, total); };
/// world.insert_points({{1, 1}, {2, 1}, {3, 1}}, 100, options).value();
/// @endcode
struct BulkOptions {
  /// The number of threads, 1 or more, including the calling thread. The world is the same for any number. More than
  /// one thread makes the call faster if the world has no items yet. With a job system, this is the number of jobs that
  /// may run at the same time. A number above 256 counts as 256.
  std::size_t threads = 1;
  /// A function that the library calls on the calling thread from time to time, and at the end with `done` equal to
  /// `total`. Only the ratio of the two numbers has a meaning: what they count may differ in other versions. The
  /// function must not use the world. If it throws an exception, the call ends with this exception. If it throws in the
  /// last report, the world contains the items. If it throws in an earlier report, the world does not change.
  std::function<void(std::size_t done, std::size_t total)> progress;
  /// The job system that provides the other threads. If it is null, the library starts threads.
  JobSystem* jobs = nullptr;
};

/// @}

}  // namespace waywright
