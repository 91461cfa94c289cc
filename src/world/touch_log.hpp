#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "constraint/constrained_triangulation.hpp"
#include "memory/count.hpp"
#include "mesh/triangle_mesh.hpp"
#include "nav/abstraction.hpp"
#include "path/looked_at.hpp"

namespace waywright {

/// The version of a world, and the faces that its operations have touched. A search in slices reads it to find out
/// whether it can continue in a world that has changed. A world and its searches share one log. A search can read the
/// log even after the world has been destroyed. The log records faces only while a search runs.
///
/// Threads: several threads may call add_search() and remove_search() at once. The other functions follow the rules of
/// World: while a thread calls one that is not const, no other thread may use the log.
class TouchLog {
 public:
  static constexpr std::uint64_t kWorldGone = std::numeric_limits<std::uint64_t>::max();

  TouchLog() = default;
  /// Makes the log of a world that starts with this version. It has no records of earlier versions.
  explicit TouchLog(std::uint64_t version) : version_(version), complete_since_(version) {}

  [[nodiscard]] std::uint64_t version() const { return version_; }
  void note_world_gone() { version_ = kWorldGone; }

  void add_search() { searches_.fetch_add(1, std::memory_order_relaxed); }
  void remove_search() { searches_.fetch_sub(1, std::memory_order_relaxed); }

  /// Records the faces that an operation has touched in the mesh. Allocates memory. If the operation is taken back
  /// afterwards, the records stay: a search may then start again although nothing has changed.
  void note_mesh(const constraint::ConstrainedTriangulation& triangulation);
  /// Records the faces whose entry in the abstraction has changed. Call it after note_mesh(). Allocates nothing: it
  /// uses the room that note_mesh() has made. If this room is too small, the operation counts as one that has touched
  /// every face.
  void note_abstraction(const nav::Abstraction& abstraction);
  /// Records that an operation has touched every face. Allocates nothing.
  void note_everything() { complete_since_ = version_ + 1; }
  /// Ends an operation that has succeeded.
  void commit() { ++version_; }

  /// Starts again at a version, without records of earlier versions. Allocates nothing.
  void restart(std::uint64_t version) {
    entries_.clear();
    version_ = version;
    complete_since_ = version;
  }

  /// Returns whether an operation after version `since` has touched a face at which the search has looked.
  [[nodiscard]] bool has_touched(const path::LookedAt& looked_at, std::uint64_t since) const;

  void count_memory(MemoryUse& use) const { memory::count_spare(use, entries_); }
  /// Frees spare memory. While a search runs, the entries stay.
  void shrink_to_fit();

 private:
  /// Records the faces that an operation has touched. Returns whether the log has room for all of them (kLongest).
  [[nodiscard]] bool add_touched_faces(const constraint::ConstrainedTriangulation& triangulation);

  /// The largest number of entries. If an operation would make the log longer, the operation empties the log, and all
  /// searches start again.
  static constexpr std::size_t kLongest = std::size_t{1} << 20;
  /// The number of entries for which note_mesh() makes room, so that note_abstraction() can add them.
  static constexpr std::size_t kSpare = 4096;

  /// A face that an operation has touched, and the version of the world after that operation.
  struct Entry {
    std::uint64_t version;
    mesh::Face face;
  };

  std::uint64_t version_ = 0;
  std::atomic<std::size_t> searches_ = 0;
  std::uint64_t complete_since_ = 0;  ///< the log has the faces of all operations after this version
  std::vector<Entry> entries_;        ///< by version, ascending
};

}  // namespace waywright
