#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "exact/homogeneous.hpp"

namespace waywright::exact {

/// An integer of at most kBits bits. It lies on the stack, so it allocates nothing. Requires: no result has more bits.
template <unsigned kBits>
using StackInteger = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<kBits, kBits, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

/// Requires: the number is a multiple of 2^lattice_exponent.
template <unsigned kBits>
[[nodiscard]] StackInteger<kBits> to_stack_integer(const Dyadic& number, int lattice_exponent) {
  if (number.mantissa == 0) return StackInteger<kBits>{0};
  return StackInteger<kBits>{number.mantissa} << static_cast<unsigned>(number.exponent - lattice_exponent);
}

}  // namespace waywright::exact
