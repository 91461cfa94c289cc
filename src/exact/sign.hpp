#pragma once

namespace waywright::exact {

enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

template <class Number>
[[nodiscard]] constexpr Sign sign_of(const Number& value) {
  return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
}

[[nodiscard]] constexpr Sign operator-(Sign sign) { return static_cast<Sign>(-static_cast<signed char>(sign)); }

}  // namespace waywright::exact
