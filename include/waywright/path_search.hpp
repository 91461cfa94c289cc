#pragma once

#include <cstddef>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/owned.hpp"
#include "waywright/path.hpp"

namespace waywright {

class World;

/// A search for a path that is made in slices, so that none takes longer than a frame can spare. Its answer is the one
/// that World::find_path gives in the world as it is at the last slice. It has its own memory, which one search leaves
/// to the next.
///
/// Between the slices a program may ask the world anything, run other searches, move the world, and change it. If a
/// change touches faces that the search has looked at, or the ends, the next slice begins the search again; otherwise
/// the search goes on. While searches run, each operation on the world also notes which faces it touched, at a cost
/// proportional to them. A search that has been moved from may only be assigned to or destroyed.
///
/// Threads: a search belongs to one thread at a time; step() reads the world.
///
///     search.begin(world, {.start = {1, 1}, .goal = {90, 90}}).value();
///     while (!search.step(500).value()) run_one_frame(world);  // may insert and remove items
///     use(search.path(), search.restarts());
class WAYWRIGHT_API PathSearch {
 public:
  PathSearch();
  ~PathSearch();
  PathSearch(PathSearch&&) noexcept;
  PathSearch& operator=(PathSearch&&) noexcept;

  /// Starts a search, and gives up the one before. Errors: those of World::find_path; there is no search then. Cost:
  /// the location of both ends, and what the straight way between them crosses up to the first wall; where it meets
  /// none, the first step is the last.
  Result<void> begin(const World& world, const PathQuery& query);

  /// Searches on, by at most `expansions` triangles or a few more. Returns whether the search is done. The first step
  /// of `tra` is its last. If no search is running, nothing is left to do, and the answer is true. Errors: world_gone,
  /// if the world has been destroyed or another one has been assigned to it. The search is given up then, and also if
  /// memory runs out (std::bad_alloc).
  Result<bool> step(std::size_t expansions);

  /// The answer, once the search is done. Before that the best path so far, with what is proven of it; its status is
  /// `no_path` as long as there is none.
  [[nodiscard]] const Path& path() const;

  /// How often the search has begun again because the world had changed where it had looked. Path::expansions counts
  /// from the last beginning.
  [[nodiscard]] std::size_t restarts() const;

  /// Gives the search up.
  void cancel();
  /// Whether a search has begun and is neither done nor given up.
  [[nodiscard]] bool is_running() const;

 private:
  struct Impl;
  detail::Owned<Impl, detail::kMovedSearch> impl_;
};

}  // namespace waywright
