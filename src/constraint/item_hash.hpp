#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright::constraint {

/// The hash of an item. The hash has two words of 64 bits. The hash of a set of items is the sum of the items' hashes,
/// word by word. So the update after an insertion or removal reads only the points of this item. docs/hashes.md defines
/// the hash; a change of the definition needs a new format version.
class ItemHash {
 public:
  using Words = std::array<std::uint64_t, 2>;

  ItemHash(ItemId id, ItemKind kind, FillRule fill, std::size_t ring_count);
  void begin_ring(std::size_t point_count) { add(point_count); }
  /// Adds a point. Requires: no coordinate is -0.
  void add(const Point& point);
  [[nodiscard]] const Words& words() const { return words_; }

  static void add_to(Words& sum, const Words& item);
  static void subtract_from(Words& sum, const Words& item);

 private:
  void add(std::uint64_t word);

  Words words_;
};

}  // namespace waywright::constraint
