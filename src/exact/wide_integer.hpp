#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "base/compiler.hpp"
#include "exact/position.hpp"

namespace waywright::exact {

/// A number of 128 bits, as two halves.
struct Halves {
  std::uint64_t low, high;
};

/// Returns a b + c + d, which always fits 128 bits. Computes it from products of 32 bits, for compilers that have no
/// integer of 128 bits.
[[nodiscard]] constexpr Halves multiply_by_halves(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
  constexpr std::uint64_t kLow = 0xffffffff;
  const std::uint64_t lowest = (a & kLow) * (b & kLow);
  const std::uint64_t cross = (a >> 32) * (b & kLow) + (lowest >> 32);
  const std::uint64_t other = (a & kLow) * (b >> 32) + (cross & kLow);
  const std::uint64_t product = (other << 32) | (lowest & kLow);
  const std::uint64_t sum = product + c;
  const std::uint64_t low = sum + d;
  const std::uint64_t carries = (sum < c ? 1U : 0U) + (low < d ? 1U : 0U);
  return {low, (a >> 32) * (b >> 32) + (cross >> 32) + (other >> 32) + carries};
}

[[nodiscard]] constexpr Halves multiply(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
#if defined(WAYWRIGHT_HAS_UINT128)
  const base::UInt128 sum = base::UInt128{a} * b + c + d;
  return {static_cast<std::uint64_t>(sum), static_cast<std::uint64_t>(sum >> 64)};
#else
  return multiply_by_halves(a, b, c, d);
#endif
}

/// An integer with a fixed number of 64-bit limbs in two's complement, on the stack. A product has as many limbs as
/// both factors together, so it never overflows. A sum has as many limbs as its terms: the caller makes sure that this
/// is enough.
template <std::size_t kLimbs>
class WideInteger {
 public:
  constexpr WideInteger() = default;
  constexpr WideInteger(std::int64_t value) {  // NOLINT(google-explicit-constructor): every int64 is one
    limbs_.fill(value < 0 ? ~std::uint64_t{0} : 0);
    limbs_[0] = static_cast<std::uint64_t>(value);
  }

  [[nodiscard]] constexpr std::uint64_t limb(std::size_t i) const { return limbs_[i]; }
  [[nodiscard]] constexpr bool is_negative() const { return limbs_[kLimbs - 1] >> 63 != 0; }
  [[nodiscard]] constexpr Sign sign() const {
    if (is_negative()) return Sign::negative;
    std::uint64_t bits = 0;
    for (const std::uint64_t limb : limbs_) bits |= limb;
    return bits == 0 ? Sign::zero : Sign::positive;
  }

  /// Returns the same number with another number of limbs. Requires: it fits.
  template <std::size_t kOther>
  [[nodiscard]] constexpr WideInteger<kOther> resize() const {
    WideInteger<kOther> result(is_negative() ? -1 : 0);
    for (std::size_t i = 0; i < kOther && i < kLimbs; ++i) result.limbs_[i] = limbs_[i];
    return result;
  }

  /// The number of bits up to the highest bit that is set. Requires: the number is not negative.
  [[nodiscard]] constexpr int bit_width() const {
    std::size_t i = kLimbs - 1;
    while (i > 0 && limbs_[i] == 0) --i;
    return static_cast<int>(64 * i) + static_cast<int>(std::bit_width(limbs_[i]));
  }

  /// A double near the number, for a first guess. Requires: the number's magnitude is at most 2^1000.
  [[nodiscard]] constexpr double approximate() const {
    if (is_negative()) return -(WideInteger{} - *this).approximate();
    double value = 0.0;
    for (std::size_t i = kLimbs; i-- > 0;) value = value * 0x1p64 + static_cast<double>(limbs_[i]);
    return value;
  }

  /// Returns the number times 2^bits. Requires: the result fits.
  [[nodiscard]] constexpr WideInteger operator<<(int bits) const {
    const auto skipped = static_cast<std::size_t>(bits / 64);
    const int within = bits % 64;
    WideInteger result;
    for (std::size_t i = skipped; i < kLimbs; ++i) {
      result.limbs_[i] = limbs_[i - skipped] << within;
      if (within != 0 && i > skipped) result.limbs_[i] |= limbs_[i - skipped - 1] >> (64 - within);
    }
    return result;
  }

  constexpr WideInteger& operator+=(const WideInteger& other) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      const std::uint64_t sum = limbs_[i] + carry;
      carry = sum < carry ? 1 : 0;
      limbs_[i] = sum + other.limbs_[i];
      carry += limbs_[i] < sum ? 1 : 0;
    }
    return *this;
  }
  constexpr WideInteger& operator-=(const WideInteger& other) {
    subtract_from(0, other);
    return *this;
  }
  [[nodiscard]] friend constexpr WideInteger operator+(WideInteger a, const WideInteger& b) { return a += b; }
  [[nodiscard]] friend constexpr WideInteger operator-(WideInteger a, const WideInteger& b) { return a -= b; }
  [[nodiscard]] friend constexpr WideInteger operator-(const WideInteger& a) { return WideInteger{} - a; }

 private:
  template <std::size_t kOther>
  friend class WideInteger;
  template <std::size_t kA, std::size_t kB>
  friend constexpr WideInteger<kA + kB> operator*(const WideInteger<kA>& a, const WideInteger<kB>& b);

  /// Subtracts `other` times 2^(64 shift), modulo 2^(64 kLimbs).
  template <std::size_t kOther>
  constexpr void subtract_from(std::size_t shift, const WideInteger<kOther>& other) {
    std::uint64_t borrow = 0;
    for (std::size_t i = shift; i < kLimbs && i - shift < kOther; ++i) {
      const std::uint64_t limb = limbs_[i];
      const std::uint64_t less = limb - borrow;
      borrow = less > limb ? 1 : 0;
      limbs_[i] = less - other.limbs_[i - shift];
      borrow += limbs_[i] > less ? 1 : 0;
    }
  }

  std::array<std::uint64_t, kLimbs> limbs_{};
};

// Multiplies the limbs as if the numbers were unsigned. A negative factor of n limbs is then too large by 2^(64 n). The
// last lines subtract the resulting error from the product.
template <std::size_t kA, std::size_t kB>
[[nodiscard]] constexpr WideInteger<kA + kB> operator*(const WideInteger<kA>& a, const WideInteger<kB>& b) {
  WideInteger<kA + kB> result;
  for (std::size_t i = 0; i < kA; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < kB; ++j) {
      const auto [low, high] = multiply(a.limbs_[i], b.limbs_[j], result.limbs_[i + j], carry);
      result.limbs_[i + j] = low;
      carry = high;
    }
    result.limbs_[i + kB] = carry;
  }
  if (a.is_negative()) result.subtract_from(kA, b);
  if (b.is_negative()) result.subtract_from(kB, a);
  return result;
}

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
