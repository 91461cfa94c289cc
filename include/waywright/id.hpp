#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>

namespace waywright {

namespace detail {

/// An integer type that can hold an id: every integral type except `bool` and the character types.
template <class T>
concept IdNumber = std::integral<T> && !std::same_as<T, bool> && !std::same_as<T, char> && !std::same_as<T, wchar_t> &&
                   !std::same_as<T, char8_t> && !std::same_as<T, char16_t> && !std::same_as<T, char32_t>;

/// The constructor of ItemId calls this function for a negative id in a constant expression. The function is not
/// constexpr, so such an expression does not compile.
inline void negative_id() {}

}  // namespace detail

/// @addtogroup items
/// @{

/// The id of an item in a world: a number from 1 to 2^63 - 1. You choose it, or you let the world choose it. The id 0
/// is null. In a list of the items on an edge, the id 0 stands for the border of the domain.
///
/// @code{.cpp}
/// world.insert_segment({1, 1}, {4, 1}, 12).value();      // an id that you choose
/// const ItemId id = world.insert_point({5, 5}).value();  // == 13
/// world.remove(12).value();                              // a plain number is an id
/// world.reserve_ids(1000).value();                       // the world continues its ids after 1000
/// const ItemId next = world.insert_point({3, 3}).value();  // == 1001
/// @endcode
struct ItemId {
  std::uint64_t value = 0;

  /// The largest id that a world accepts: 2^63 - 1.
  static constexpr std::uint64_t kLargest = (std::uint64_t{1} << 63) - 1;

  /// The null id.
  constexpr ItemId() = default;
  /// Makes an id from any integer, so that `world.remove(7)` works. A negative number becomes an id above `kLargest`,
  /// which every operation refuses. In a constant expression a negative number does not compile.
  template <detail::IdNumber Number>
  constexpr ItemId(Number number) : value(static_cast<std::uint64_t>(number)) {
    if (std::is_constant_evaluated() && value > kLargest && std::signed_integral<Number>) detail::negative_id();
  }

  [[nodiscard]] constexpr bool is_null() const { return value == 0; }
  friend constexpr auto operator<=>(const ItemId&, const ItemId&) = default;
};

/// @}

}  // namespace waywright

/// The hash of an id, for std::unordered_map.
template <>
struct std::hash<waywright::ItemId> {
  std::size_t operator()(waywright::ItemId id) const noexcept { return std::hash<std::uint64_t>{}(id.value); }
};
