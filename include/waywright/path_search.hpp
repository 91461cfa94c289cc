#pragma once

#include <cstddef>
#include <span>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/owned.hpp"
#include "waywright/path.hpp"

namespace waywright {

/// @addtogroup paths
/// @{

class World;

/// A path search in slices: each call of step() carries out one slice of the search. Use it if a whole search takes
/// more time than one frame of your program has. The answer is the answer that World::find_path gives at the time of
/// the last slice. The object has its own memory and keeps it from one search to the next.
///
/// @code{.cpp}
/// PathSearch search;
/// search.begin(world, {.start = {1, 1}, .goal = {90, 90}}).value();
/// while (!search.step(500).value()) run_one_frame(world);  // may insert and remove items
/// std::printf("%g, after %zu restarts\n", search.path().length, search.restarts());
/// @endcode
///
/// Between the slices a program may query the world, run other searches, move the world and change it. If a change
/// touches the start, the goal, or a triangle at which the search has looked, the next slice starts the search again.
/// The search also starts again if an operation changes so many triangles that the world does not record each of them,
/// and in rare cases after an operation that failed. Otherwise it continues. In three cases, a change that touches any
/// triangle of the world makes the next slice start the search again: the search has moved an end; begin() has found
/// the answer already, for example because the straight segment meets no wall, and no vertex between its ends; or the
/// algorithm is PathAlgorithm::tra. While searches run, each operation on the world also records the triangles that it
/// touches, and the triangles around their corners, at a cost proportional to the number of these triangles. If you
/// move a search to another object, you may only assign to the first object or destroy it.
///
/// If the agent is a disc, every change of the world makes the next slice start the search again. So does a
/// call of World::shrink_to_fit that frees the second mesh (WorldOptions::keep_bridges).
///
/// Threads: a search belongs to one thread at a time. begin() and step() read the world: call them only while no other
/// thread changes it.
class WAYWRIGHT_API PathSearch {
 public:
  PathSearch();
  ~PathSearch();
  PathSearch(PathSearch&&) noexcept;
  PathSearch& operator=(PathSearch&&) noexcept;

  /// Starts a search, and cancels the search that is running, if there is one. If the function returns an error, no
  /// search is running afterwards.
  /// Errors: the errors of World::find_path.
  /// Cost: the location of both ends, and the triangles that the straight segment between them crosses up to the first
  /// wall. If the segment meets no wall, and no vertex between its ends, the first call of step() ends the search. For
  /// a radius above 0: the location of both ends, the walls near them, and the triangles that the straight segment
  /// crosses or that are nearer to it than the radius.
  Result<void> begin(const World& world, const PathQuery& query);

  /// Continues the search until it has entered `expansions` further triangles, or a few more. Returns whether the
  /// search is done. If the radius is 0, a search by PathAlgorithm::tra ends in the first call with a number above 0.
  /// If no search is running, the function returns true. For a radius above 0, `expansions` counts what
  /// Path::expansions counts. If the radius is above 0 and there is no path, the last slice also finds Path::widest, at
  /// the cost of World::widest_path.
  /// Errors: world_gone, if the world has been destroyed or another world has been assigned to it. This cancels the
  /// search.
  /// Cost: proportional to the number of triangles that the search enters; for a radius above 0, to what
  /// Path::expansions counts. Exceptions: std::bad_alloc, if memory runs out. This cancels the search.
  Result<bool> step(std::size_t expansions);

  /// Returns the answer if the search is done. Before that, a search by PathAlgorithm::ta returns the best path so far
  /// and its proven lower bound. The status is PathStatus::no_path as long as `ta` has found no path and, for the other
  /// algorithms, until the search is done. After cancel() or an error, the path is no answer. The reference is valid
  /// until you assign to this object, move it or destroy it; begin() and step() change the path.
  /// Cost: O(1).
  [[nodiscard]] const Path& path() const;

  /// Returns how often the search has started again. Path::expansions counts from the last start.
  /// Cost: O(1).
  [[nodiscard]] std::size_t restarts() const;

  /// Sets whether the searches that begin() starts from now on record their windows (SearchWindow). The default is
  /// false. A search that records its windows takes more time and memory; its answer is the same.
  void record_windows(bool wanted);
  /// Returns the windows that the search has followed since its last start, in order: one or more for each triangle
  /// that it has entered, so their number is at least Path::expansions. The list is valid until you call another member
  /// of this object that is not const.
  ///
  /// The list is empty if record_windows() was not called before begin(); if the algorithm is not
  /// PathAlgorithm::optimal; if the agent is a disc; and if no search was necessary, for example because the
  /// straight segment from the start to the goal meets no wall, and no vertex between its ends.
  ///
  /// @code{.cpp}
  /// PathSearch search;
  /// search.record_windows(true);
  /// search.begin(world, {.start = {1, 1}, .goal = {90, 90}}).value();
  /// while (!search.step(500).value()) continue;
  /// const bool has_enough = search.windows().size() >= search.path().expansions;  // == true
  /// for (const SearchWindow& window : search.windows()) draw_line(window.interval.left, window.interval.right);
  /// @endcode
  [[nodiscard]] std::span<const SearchWindow> windows() const;

  /// Cancels the search, if one is running.
  /// Cost: O(1).
  void cancel();
  /// Returns whether a search has begun and is neither done nor cancelled.
  /// Cost: O(1).
  [[nodiscard]] bool is_running() const;

 private:
  struct Impl;
  detail::Owned<Impl, detail::kMovedSearch> impl_;
};

/// @}

}  // namespace waywright
