#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright::constraint {

/// A 128-bit hash of items as a set: the sum of the items' own hashes, word by word, so that items come and go at the
/// cost of their own points. docs/hashes.md defines it; nothing here may change without a new format version.
class ItemHash {
 public:
  using Words = std::array<std::uint64_t, 2>;

  ItemHash(ItemId id, ItemKind kind, FillRule fill, std::size_t ring_count);
  void begin_ring(std::size_t point_count) { add(point_count); }
  /// Requires: no coordinate is -0.
  void add(const Point& point);
  [[nodiscard]] const Words& words() const { return words_; }

  static void add_to(Words& sum, const Words& item);
  static void subtract_from(Words& sum, const Words& item);

 private:
  void add(std::uint64_t word);

  Words words_;
};

}  // namespace waywright::constraint
