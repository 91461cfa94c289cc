#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

#include "base/compiler.hpp"

namespace waywright::constraint {

/// A bijection in which every bit of the result depends on every bit of `z`: the finaliser of SplitMix64. Source:
/// Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// The hash of an item. The hash has two words of 64 bits. The hash of a set of items is the sum of the items' hashes,
/// word by word. So the update after an insertion or removal reads only the points of this item. docs/hashes.md defines
/// the hash; a change of the definition needs a new format version.
class ItemHash {
 public:
  using Words = std::array<std::uint64_t, 2>;

  ItemHash(ItemId id, ItemKind kind, FillRule fill, std::size_t ring_count) : words_{0, 1} {
    constexpr std::uint64_t kNonzeroPolygon = 4;
    const bool is_nonzero = kind == ItemKind::polygon && fill == FillRule::nonzero;
    add(id.value);
    add(is_nonzero ? kNonzeroPolygon : static_cast<std::uint64_t>(kind));
    add(ring_count);
  }
  void begin_ring(std::size_t point_count) { add(point_count); }
  /// Adds a point. Requires: no coordinate is -0.
  void add(const Point& point) {
    add(base::bit_cast<std::uint64_t>(point.x));
    add(base::bit_cast<std::uint64_t>(point.y));
  }
  [[nodiscard]] const Words& words() const { return words_; }

  static void add_to(Words& sum, const Words& item) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += item[i];
  }
  static void subtract_from(Words& sum, const Words& item) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] -= item[i];
  }

 private:
  void add(std::uint64_t word) {
    for (std::uint64_t& lane : words_) lane = mix(lane ^ word);
  }

  Words words_;
};

}  // namespace waywright::constraint
