#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "constraint/exact_triangulation.hpp"
#include "memory/count.hpp"
#include "mesh/triangle_mesh.hpp"
#include "nav/abstraction.hpp"
#include "path/looked_at.hpp"

namespace waywright {

/// The version of a world, and which faces its operations touch, for sliced searches that go on in a world that has
/// changed. A world and its searches share one; it outlives the world. Faces are noted only while a search runs.
///
/// Threads: searches may begin and end at once with one another; all else follows the rules of World.
class TouchLog {
 public:
  static constexpr std::uint64_t kGone = std::numeric_limits<std::uint64_t>::max();

  [[nodiscard]] std::uint64_t version() const { return version_; }
  void note_world_gone() { version_ = kGone; }

  void add_search() { searches_.fetch_add(1, std::memory_order_relaxed); }
  void remove_search() { searches_.fetch_sub(1, std::memory_order_relaxed); }

  /// Takes note of what an operation has touched of the mesh. The operation may be taken back afterwards. Allocates.
  void note_mesh(const constraint::ExactTriangulation& triangulation);
  /// Then, of what it has changed in the abstraction. Allocates nothing: if that is more than note_mesh() has made room
  /// for, the operation counts as one that has touched everything.
  void note_abstraction(const nav::Abstraction& abstraction);
  /// Takes note that an operation has touched everything. Allocates nothing.
  void note_everything() { complete_since_ = version_ + 1; }
  /// An operation succeeds.
  void commit() { ++version_; }

  /// Whether an operation after the version `since` has touched a face that a search has looked at.
  [[nodiscard]] bool has_touched(const path::LookedAt& looked_at, std::uint64_t since) const;

  void count_memory(MemoryUse& use) const { memory::count_spare(use, entries_); }
  /// Gives back spare memory. The notes stay while a search runs.
  void shrink_to_fit();

 private:
  /// A log that is longer starts anew, and all searches do, too.
  static constexpr std::size_t kLongest = std::size_t{1} << 20;
  /// Room for so many changes of the abstraction.
  static constexpr std::size_t kSpare = 4096;

  /// A face, and the version that the operation which touched it led to.
  struct Entry {
    std::uint64_t version;
    mesh::Face face;
  };

  std::uint64_t version_ = 0;
  std::atomic<std::size_t> searches_ = 0;
  std::uint64_t complete_since_ = 0;  ///< there are entries for all operations after this version
  std::vector<Entry> entries_;        ///< by version, ascending
};

}  // namespace waywright
