#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/memory_use.hpp"

#include "exact/position.hpp"
#include "memory/array.hpp"
#include "memory/count.hpp"
#include "memory/journal.hpp"

namespace waywright::exact {

/// The lines that cross at constructed vertices, by slot. A line is a pair of points: two different pairs are two
/// lines, also if they are collinear. The table stores the line of a pair only once, however many constructed vertices
/// lie on it. It counts the uses of each line, and frees a line that has no use any more.
///
/// A binary trie finds the line of two points. Its keys are the bits of the four coordinates, so no chain of nodes from
/// the root to a line is longer than 256.
///
/// An undo log records which lines are new. The caller must record the uses: before roll_back(), it must restore the
/// number of uses that each line had at the last begin().
///
/// Source: Morrison, *PATRICIA: practical algorithm to retrieve information coded in alphanumeric*, JACM 1968.
class LineTable {
 public:
  using Slot = std::uint32_t;
  static constexpr Slot kNone = memory::FreeList::kEnd;  ///< no line has this slot

  /// Returns the line of these two points. If the table has no such line, makes one without a use. The line may be
  /// stored with its two points in the other order. If the line has the slot `hint`, the function finds it faster; the
  /// hint may be any number. Requires: the points differ. Cost: at most 256 steps, and O(log n) for most inputs;
  /// amortised.
  [[nodiscard]] Slot find_or_make(const PointPair& points, Slot hint = kNone) {
    const bool is_hint = hint < records_.size() && records_[hint].uses != kFree && is_line(hint, points);
    return is_hint ? hint : find_or_make_in_trie(points);
  }
  /// Counts one use more of each of the two lines. Allocates nothing.
  void add_uses(Slot one, Slot other) {
    ++records_[one].uses;
    ++records_[other].uses;
  }
  /// Counts one use less of each of the two lines. The next begin() frees a line that has no use then. If memory runs
  /// out, no use changes. Requires: the lines differ.
  void remove_uses(Slot one, Slot other) {
    for (const Slot line : {one, other}) {
      if (records_[line].uses == 1) changed_.push_back(line);
    }
    take_back_uses(one, other);
  }
  /// Takes add_uses() back. Allocates nothing, and a line without a use stays. From outside, call it only before
  /// roll_back().
  void take_back_uses(Slot one, Slot other) {
    --records_[one].uses;
    --records_[other].uses;
  }
  /// The two points of a line.
  [[nodiscard]] const PointPair& operator[](Slot line) const { return records_[line].points; }

  /// The number of lines, including lines without a use that the next begin() frees. Cost: linear.
  [[nodiscard]] std::size_t size() const;

  /// Starts an operation: frees the lines without a use.
  void begin() {
    if (!changed_.empty()) free_unused();
  }
  /// Frees the lines that are new since begin(). Allocates nothing. Requires: they have no use.
  void roll_back();

  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const {
    memory::count(use, part, records_);
    memory::count(use, part, forks_);
    memory::count_spare(use, changed_);
  }
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() {
    memory::shrink(records_, forks_);
    memory::release(changed_);
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffff;  ///< instead of the number of uses
  /// The bits of the four coordinates of a line. They do not depend on the order of the two points.
  using Key = std::array<std::uint64_t, 4>;
  /// A node of the trie: the slot of a line, or the index of a fork plus kFork.
  using Node = std::uint32_t;
  static constexpr Node kFork = 0x80000000;

  struct Record {
    PointPair points;
    std::uint32_t uses;
    Slot next;  ///< the next free record, if this one is free
  };
  /// The keys below a fork agree in all bits before bit number `bit`. This bit decides whether a key lies below the
  /// first or below the second child. Bit 0 is the highest bit of the first coordinate.
  struct Fork {
    std::uint32_t bit;
    std::array<Node, 2> children;  ///< of a free fork: the first is the next free fork
  };

  [[nodiscard]] bool is_line(Slot line, const PointPair& points) const {
    const PointPair& stored = records_[line].points;
    return (stored.a == points.a && stored.b == points.b) || (stored.a == points.b && stored.b == points.a);
  }
  [[nodiscard]] static Key key_of(const PointPair& points);
  [[nodiscard]] Slot find_or_make_in_trie(const PointPair& points);
  [[nodiscard]] Slot candidate(const Key& key) const;
  [[nodiscard]] Slot make(const PointPair& points);
  void free_line(Slot line);
  void free_unused();
  /// Puts a line into the trie. Requires: there is a free fork.
  void link(Slot line);

  memory::Array<Record> records_;
  memory::FreeList free_records_;  ///< linked by Record::next
  memory::Array<Fork> forks_;      ///< as many as records
  memory::FreeList free_forks_;    ///< linked by the first child
  Node root_ = kNone;              ///< kNone if the table has no line
  std::vector<Slot> changed_;      ///< the lines that are new since begin(), and lines whose last use was removed
};

}  // namespace waywright::exact
