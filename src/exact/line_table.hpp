#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/memory_use.hpp"

#include "exact/exact_point.hpp"
#include "memory/count.hpp"
#include "memory/free_list.hpp"
#include "memory/journal.hpp"

namespace waywright::exact {

/// The lines that cross at constructed vertices, by number. Many constructed vertices can lie on one line, and the table
/// stores this line only once. It counts the uses of each line, and frees a line that has no use any more. A hash table
/// finds the line of two points.
///
/// An undo log records all changes; roll_back() takes them back to the last begin().
class LineTable {
 public:
  using Number = std::uint32_t;
  static constexpr Number kNone = memory::FreeList::kEnd;  ///< no line has this number

  /// Returns the line through these two points, and counts one more use of it. The line may be stored with its two
  /// points in the other order. Requires: the points differ. Cost: expected O(1), amortised.
  [[nodiscard]] Number add_use(const PointPair& points);
  /// Counts one use less. If the line has no use at the next begin(), begin() frees it.
  void remove_use(Number line);
  /// The two points of a line.
  [[nodiscard]] const PointPair& operator[](Number line) const { return records_[line].points; }

  /// The number of lines, including lines without a use that the next begin() frees. Cost: linear.
  [[nodiscard]] std::size_t size() const;

  /// Empties the undo log.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const {
    memory::count(use, part, records_);
    memory::count(use, part, buckets_);
    journal_.count_memory(use);
  }
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() {
    memory::shrink(records_, buckets_);
    journal_.release();
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffff;  ///< instead of the number of uses
  static constexpr std::size_t kFewestBuckets = 16;

  struct Record {
    PointPair points;
    std::uint32_t uses;
    Number next;  ///< the next line in the bucket, or the next free record
  };
  enum class Change : std::uint8_t { make, add_use, remove_use };
  struct Undo {
    Number line;
    Change change;
  };

  [[nodiscard]] std::size_t bucket_of(const PointPair& points) const;
  [[nodiscard]] Number find(const PointPair& points) const;
  [[nodiscard]] Number make(const PointPair& points);
  void free_line(Number line);
  void grow_buckets();
  /// Puts a line into its bucket.
  void link(Number line);

  std::vector<Record> records_;
  memory::FreeList free_records_;  ///< linked by Record::next
  std::vector<Number> buckets_;    ///< the first line of each bucket; as many as a power of two, at least one per record
  memory::Journal<Undo> journal_;
};

}  // namespace waywright::exact
