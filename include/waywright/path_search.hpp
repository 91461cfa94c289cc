#pragma once

#include <cstddef>
#include <memory>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/path.hpp"

namespace waywright {

class World;

/// A search for a path that is made in slices, so that none takes longer than a frame can spare. However it is sliced,
/// its answer is that of World::find_path. It has its own memory, which one search leaves to the next.
///
/// Between the slices anything may be asked of the world and other searches may be on their way. A world that changes
/// or goes meanwhile ends the search with an error; it may be moved. A search that has been moved from may only be
/// assigned to or destroyed.
///
/// Threads: a search belongs to one thread at a time; step() reads the world.
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

  /// Searches on, by at most `expansions` triangles or a few more. Returns whether the search is done. Of `tra` the
  /// first step is the last; where no search is running, nothing is left to do. Errors: world_changed, when the world
  /// is no longer what it was at begin(); the search is given up then, and also where memory runs out (std::bad_alloc).
  Result<bool> step(std::size_t expansions);

  /// The answer, once the search is done. Before that the best path so far, with what is proven of it; its status is
  /// `no_path` as long as there is none.
  [[nodiscard]] const Path& path() const;

  /// Gives the search up.
  void cancel();
  /// Whether a search has begun and is neither done nor given up.
  [[nodiscard]] bool is_running() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace waywright
