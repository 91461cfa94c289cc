#pragma once

#include <compare>

namespace waywright::exact {

enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

template <class Number>
[[nodiscard]] constexpr Sign sign_of(const Number& value) {
  return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
}

[[nodiscard]] constexpr Sign operator-(Sign sign) { return static_cast<Sign>(-static_cast<signed char>(sign)); }

[[nodiscard]] constexpr std::strong_ordering order_of(Sign sign) {
  return static_cast<signed char>(sign) <=> static_cast<signed char>(0);
}

}  // namespace waywright::exact
