#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <boost/multiprecision/cpp_int.hpp>

#include "support/disc_oracle.hpp"

/// The numbers of the oracle of connectivity: points and lines in whole units of a grid. Only `disc_oracle.cpp`
/// includes this header.
namespace waywright::test::disc {

/// An integer of any size. The first 512 bits need no heap.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked>,
    boost::multiprecision::et_off>;

inline int sign(const Integer& value) { return value.sign(); }

/// Returns the exponent of the lowest set bit of a double that is not 0.
inline int lowest_exponent(double value) {
  int exponent = 0;
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  for (; mantissa % 2 == 0; mantissa /= 2) ++exponent;
  return exponent;
}

/// Returns value / 2^exponent. Requires: this is an integer.
inline Integer scaled(double value, int exponent) {
  if (value == 0.0) return 0;
  const int own = lowest_exponent(value);
  const Integer odd = static_cast<std::int64_t>(std::ldexp(value, -own));
  return odd << static_cast<unsigned>(own - exponent);
}

/// The point (x / w, y / w) in units of the grid, w > 0.
struct GridPoint {
  Integer x;
  Integer y;
  Integer w = 1;
};

inline Integer product(const GridPoint& a, const GridPoint& b) { return a.x * b.x + a.y * b.y; }

/// Returns a - b. Requires: both have w = 1.
inline GridPoint difference(const GridPoint& a, const GridPoint& b) { return {a.x - b.x, a.y - b.y, 1}; }

inline int compare_x(const GridPoint& a, const GridPoint& b) { return sign(a.x * b.w - b.x * a.w); }
inline int compare_y(const GridPoint& a, const GridPoint& b) { return sign(a.y * b.w - b.y * a.w); }
inline int compare(const GridPoint& a, const GridPoint& b) {
  const int by_x = compare_x(a, b);
  return by_x != 0 ? by_x : compare_y(a, b);
}

/// The line a x + b y + c w = 0.
struct Line {
  Integer a;
  Integer b;
  Integer c;

  /// Returns the line through two points.
  static Line through(const GridPoint& p, const GridPoint& q) {
    return {p.y * q.w - p.w * q.y, p.w * q.x - p.x * q.w, p.x * q.y - p.y * q.x};
  }
  /// Returns 1, 0 or -1 if p is left of, on or right of the line, as seen from its first towards its second point.
  [[nodiscard]] int place(const GridPoint& p) const { return sign(a * p.x + b * p.y + c * p.w); }
};

/// Returns the crossing of two lines. Requires: they are not parallel.
inline GridPoint crossing(const Line& l, const Line& m) {
  GridPoint p{l.b * m.c - l.c * m.b, l.c * m.a - l.a * m.c, l.a * m.b - l.b * m.a};
  Integer factor = gcd(gcd(p.x, p.y), p.w);
  if (sign(p.w) < 0) factor = -factor;
  return {p.x / factor, p.y / factor, p.w / factor};
}

/// The grid of all multiples of 2^exponent: the coarsest grid that contains all ends of walls.
struct Grid {
  int exponent = 0;

  explicit Grid(const Walls& walls) {
    bool is_first = true;
    for (const auto& [a, b] : walls.segments) {
      for (const double value : {a.x, a.y, b.x, b.y}) {
        if (value == 0.0) continue;
        exponent = is_first ? lowest_exponent(value) : std::min(exponent, lowest_exponent(value));
        is_first = false;
      }
    }
  }

  [[nodiscard]] GridPoint point(Point p) const {
    int low = exponent;
    if (p.x != 0.0) low = std::min(low, lowest_exponent(p.x));
    if (p.y != 0.0) low = std::min(low, lowest_exponent(p.y));
    return {scaled(p.x, low), scaled(p.y, low), Integer(1) << static_cast<unsigned>(exponent - low)};
  }

  [[nodiscard]] Rational power(int factor) const {
    const boost::multiprecision::cpp_int power = boost::multiprecision::cpp_int(1)
                                                 << static_cast<unsigned>(std::abs(exponent * factor));
    return exponent * factor < 0 ? Rational(1, power) : Rational(power);
  }
  [[nodiscard]] static Rational quotient(const Integer& n, const Integer& d) {
    return Rational(boost::multiprecision::cpp_int(n), boost::multiprecision::cpp_int(d));
  }
  [[nodiscard]] RationalPoint rational(const GridPoint& p) const {
    return {quotient(p.x, p.w) * power(1), quotient(p.y, p.w) * power(1)};
  }
};

/// A double near n / d, with a relative error below 1e-15.
inline double approximate(const Integer& n, const Integer& d) {
  if (sign(n) == 0) return 0.0;
  const Integer magnitude = abs(n);
  const int drop_n = std::max(0, static_cast<int>(msb(magnitude)) - 61);
  const int drop_d = std::max(0, static_cast<int>(msb(d)) - 61);
  const auto near_n =
      static_cast<double>(static_cast<std::int64_t>(Integer(magnitude >> static_cast<unsigned>(drop_n))));
  const auto near_d = static_cast<double>(static_cast<std::int64_t>(Integer(d >> static_cast<unsigned>(drop_d))));
  return std::ldexp(near_n / near_d, drop_n - drop_d) * sign(n);
}

}  // namespace waywright::test::disc
