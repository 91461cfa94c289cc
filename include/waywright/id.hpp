#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>

namespace waywright {

namespace detail {

/// An integer that counts or names something; `bool` and the character types do not.
template <class T>
concept IdNumber = std::integral<T> && !std::same_as<T, bool> && !std::same_as<T, char> && !std::same_as<T, wchar_t> &&
                   !std::same_as<T, char8_t> && !std::same_as<T, char16_t> && !std::same_as<T, char32_t>;

/// Not constexpr, so that a negative id in a constant expression does not compile.
inline void negative_id() {}

}  // namespace detail

/// Names an item of a world: a point, segment, polyline or polygon. The number is the user's own, 1 to 2^63 - 1, or is
/// handed out by the world. Zero is null; where the items on an edge are listed, zero stands for the domain's boundary.
struct ItemId {
  std::uint64_t value = 0;

  static constexpr std::uint64_t kLargest = (std::uint64_t{1} << 63) - 1;

  /// The null id.
  constexpr ItemId() = default;
  /// Any integer is an id, so that `world.remove(7)` works. A negative number becomes an id above `kLargest`, which
  /// every operation refuses; in a constant expression it does not compile.
  template <detail::IdNumber Number>
  constexpr ItemId(Number number) : value(static_cast<std::uint64_t>(number)) {
    if (std::is_constant_evaluated() && value > kLargest && std::signed_integral<Number>) detail::negative_id();
  }

  [[nodiscard]] constexpr bool is_null() const { return value == 0; }
  friend constexpr auto operator<=>(const ItemId&, const ItemId&) = default;
};

}  // namespace waywright

template <>
struct std::hash<waywright::ItemId> {
  std::size_t operator()(waywright::ItemId id) const noexcept { return std::hash<std::uint64_t>{}(id.value); }
};
