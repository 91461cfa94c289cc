#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace waywright {

/// Names an item of a world: a point, segment, polyline or polygon. The number is the user's own, 1 to 2^63 - 1, or is
/// handed out by the world. Zero is null; where the items on an edge are listed, zero stands for the domain's boundary.
struct ItemId {
  std::uint64_t value = 0;

  static constexpr std::uint64_t kLargest = (std::uint64_t{1} << 63) - 1;

  [[nodiscard]] constexpr bool is_null() const { return value == 0; }
  friend auto operator<=>(const ItemId&, const ItemId&) = default;
};

}  // namespace waywright

template <>
struct std::hash<waywright::ItemId> {
  std::size_t operator()(waywright::ItemId id) const noexcept { return std::hash<std::uint64_t>{}(id.value); }
};
