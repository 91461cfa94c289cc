#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "exact/sign.hpp"
#include "exact/wide_integer.hpp"

namespace waywright::exact {

/// An integer with a magnitude below 2^kBits, on the stack: in 64 bits if it fits, otherwise in as many limbs as it
/// needs. The compiler derives the sizes of sums and products, so no operation can overflow.
template <int kBits>
class SizedInteger {
 public:
  /// The number of 64-bit limbs for kBits bits and a sign.
  static constexpr std::size_t kLimbs = static_cast<std::size_t>(kBits) / 64 + 1;
  using Storage = std::conditional_t<kLimbs == 1, std::int64_t, WideInteger<kLimbs>>;

  constexpr SizedInteger() = default;
  /// Requires: the magnitude is below 2^kBits.
  explicit constexpr SizedInteger(const Storage& value) : value_(value) {}

  [[nodiscard]] constexpr const Storage& value() const { return value_; }

  /// The same number in the storage of a larger size.
  template <std::size_t kWider>
  [[nodiscard]] constexpr auto widened() const {
    if constexpr (kWider == kLimbs) {
      return value_;
    } else if constexpr (kLimbs == 1) {
      return WideInteger<kWider>(value_);
    } else {
      return value_.template resize<kWider>();
    }
  }

 private:
  Storage value_{};
};

template <int kA, int kB>
[[nodiscard]] constexpr SizedInteger<std::max(kA, kB) + 1> operator+(const SizedInteger<kA>& a,
                                                                     const SizedInteger<kB>& b) {
  using Sum = SizedInteger<std::max(kA, kB) + 1>;
  return Sum(a.template widened<Sum::kLimbs>() + b.template widened<Sum::kLimbs>());
}

template <int kA, int kB>
[[nodiscard]] constexpr SizedInteger<std::max(kA, kB) + 1> operator-(const SizedInteger<kA>& a,
                                                                     const SizedInteger<kB>& b) {
  using Difference = SizedInteger<std::max(kA, kB) + 1>;
  return Difference(a.template widened<Difference::kLimbs>() - b.template widened<Difference::kLimbs>());
}

template <int kA, int kB>
[[nodiscard]] constexpr SizedInteger<kA + kB> operator*(const SizedInteger<kA>& a, const SizedInteger<kB>& b) {
  using Product = SizedInteger<kA + kB>;
  if constexpr (Product::kLimbs == 1) {
    return Product(a.value() * b.value());
  } else {
    constexpr std::size_t kLimbsA = SizedInteger<kA>::kLimbs;
    constexpr std::size_t kLimbsB = SizedInteger<kB>::kLimbs;
    const auto product = WideInteger<kLimbsA>(a.value()) * WideInteger<kLimbsB>(b.value());
    if constexpr (Product::kLimbs == kLimbsA + kLimbsB) {
      return Product(product);
    } else {
      return Product(product.template resize<Product::kLimbs>());
    }
  }
}

/// The sign, which is always sure. It has the same type as for doubles, so that one formula serves both.
template <int kBits>
[[nodiscard]] constexpr std::optional<Sign> sign_if_sure(const SizedInteger<kBits>& number) {
  if constexpr (SizedInteger<kBits>::kLimbs == 1) {
    return sign_of(number.value());
  } else {
    return number.value().sign();
  }
}

}  // namespace waywright::exact
