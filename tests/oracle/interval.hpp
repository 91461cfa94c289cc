#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace waywright::oracle {

/// A closed interval of doubles that contains a number which is not known exactly. The sum and the product of intervals
/// contain the exact sum and product.
struct Interval {
  double lo = 0.0;
  double hi = 0.0;
};

// Four times the rounding error, and the smallest subnormal number for results so small that the relative error says
// nothing.
inline double below(double x) { return x - (std::fabs(x) * 0x1p-51 + 0x1p-1074); }
inline double above(double x) { return x + (std::fabs(x) * 0x1p-51 + 0x1p-1074); }

inline Interval operator+(Interval a, Interval b) { return {below(a.lo + b.lo), above(a.hi + b.hi)}; }
inline Interval operator-(Interval a, Interval b) { return {below(a.lo - b.hi), above(a.hi - b.lo)}; }
inline Interval operator*(Interval a, Interval b) {
  const auto [least, most] = std::minmax({a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi});
  return {below(least), above(most)};
}

/// Returns the common sign of all numbers in the interval, or 0 if they differ or may be 0.
inline int certain_sign(Interval a) { return a.lo > 0.0 ? 1 : (a.hi < 0.0 ? -1 : 0); }

}  // namespace waywright::oracle
