#pragma once

#include <cstddef>

#include "exact/offsets.hpp"
#include "exact/wide_integer.hpp"

namespace waywright::exact {

/// Offsets that are smaller than 2^29 differ by less than 2^30. With such offsets, the denominator of a crossing fits
/// one limb.
inline constexpr int kNarrowBits = 29;

/// The point (x / w, y / w) in units of a lattice, w > 0; the denominator has kW limbs. One limb is enough if
/// coordinates differ by at most 2^30, two limbs if they differ by at most 2^62: for differences of at most 2^b, w is
/// at most 2^(2b + 1), and x and y are less than 2^(3b + 2).
template <std::size_t kW>
struct LatticePoint {
  WideInteger<kW + 1> x, y;
  WideInteger<kW> w;
};

template <std::size_t kW>
[[nodiscard]] constexpr LatticePoint<kW> lattice_point(const LatticeVector& p) {
  return {p.x, p.y, 1};
}

// The point a + t (b - a) lies on the line through c and d if t = ((c - a) x (d - c)) / ((b - a) x (d - c)).
template <std::size_t kW>
[[nodiscard]] constexpr LatticePoint<kW> lattice_crossing(const LatticeVector& a, const LatticeVector& b,
                                                          const LatticeVector& c, const LatticeVector& d) {
  const auto minus = [](const LatticeVector& p, const LatticeVector& q) -> LatticeVector {
    return {p.x - q.x, p.y - q.y};
  };
  using Coordinate = WideInteger<1>;
  const auto cross = [](const LatticeVector& u, const LatticeVector& v) {
    const WideInteger<2> product = Coordinate(u.x) * Coordinate(v.y) - Coordinate(u.y) * Coordinate(v.x);
    return product.resize<kW>();
  };
  const LatticeVector ab = minus(b, a);
  const LatticeVector cd = minus(d, c);
  WideInteger<kW> w = cross(ab, cd);
  WideInteger<kW> t = cross(minus(c, a), cd);
  if (w.is_negative()) {
    w = -w;
    t = -t;
  }
  return {w * Coordinate(a.x) + t * Coordinate(ab.x), w * Coordinate(a.y) + t * Coordinate(ab.y), w};
}

}  // namespace waywright::exact
