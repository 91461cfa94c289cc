#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "waywright/export.hpp"

namespace waywright {

/// A place in the plane, or the way from one place to another. Every finite double is taken exactly as it is; -0.0
/// means 0.0.
///
/// The functions below are plain arithmetic in doubles, rounded as usual, for the callers' own use: no decision of the
/// library depends on them. They are compiled with the caller's options; a compiler that fuses a multiplication and an
/// addition (`-ffp-contract=fast`) may change the last bit of a result.
struct Point {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(const Point&, const Point&) = default;

  constexpr Point& operator+=(const Point& other) { return *this = {x + other.x, y + other.y}; }
  constexpr Point& operator-=(const Point& other) { return *this = {x - other.x, y - other.y}; }
  constexpr Point& operator*=(double factor) { return *this = {x * factor, y * factor}; }
  constexpr Point& operator/=(double divisor) { return *this = {x / divisor, y / divisor}; }

  [[nodiscard]] friend constexpr Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
  [[nodiscard]] friend constexpr Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
  [[nodiscard]] friend constexpr Point operator-(const Point& a) { return {-a.x, -a.y}; }
  [[nodiscard]] friend constexpr Point operator*(const Point& a, double factor) { return {a.x * factor, a.y * factor}; }
  [[nodiscard]] friend constexpr Point operator*(double factor, const Point& a) { return a * factor; }
  [[nodiscard]] friend constexpr Point operator/(const Point& a, double divisor) {
    return {a.x / divisor, a.y / divisor};
  }
};

/// The magnitudes between which the coordinates of a world must lie, unless they are 0. Every double in this range is a
/// multiple of 2^-152, so differences and products of up to four of them neither overflow nor underflow.
inline constexpr double kLargestCoordinate = 0x1p100;
inline constexpr double kSmallestCoordinate = 0x1p-100;

/// Whether a world accepts a coordinate: it is 0, or its magnitude is from kSmallestCoordinate to kLargestCoordinate.
[[nodiscard]] inline bool is_in_range(double coordinate) {
  const double magnitude = std::abs(coordinate);
  return coordinate == 0.0 || (magnitude >= kSmallestCoordinate && magnitude <= kLargestCoordinate);
}
[[nodiscard]] inline bool is_in_range(const Point& point) { return is_in_range(point.x) && is_in_range(point.y); }

/// The dot product.
[[nodiscard]] WAYWRIGHT_INLINE constexpr double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
/// The third coordinate of the cross product: positive where `b` points to the left of `a`.
[[nodiscard]] WAYWRIGHT_INLINE constexpr double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
/// The square of the length; it takes no root.
[[nodiscard]] WAYWRIGHT_INLINE constexpr double squared_length(const Point& a) { return dot(a, a); }
/// The distance from (0, 0).
[[nodiscard]] WAYWRIGHT_INLINE double length(const Point& a) { return std::sqrt(squared_length(a)); }
/// The distance between two places.
[[nodiscard]] WAYWRIGHT_INLINE double distance(const Point& a, const Point& b) { return length(b - a); }
/// The place that divides the way from `a` to `b`: `a` at t = 0, `b` at t = 1, exactly.
[[nodiscard]] WAYWRIGHT_INLINE constexpr Point lerp(const Point& a, const Point& b, double t) {
  return t == 1.0 ? b : Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}
/// Whether `a` comes before `b` in (x, y) order: by x and, where these are equal, by y. The order for std::sort and
/// std::map.
[[nodiscard]] constexpr bool comes_before(const Point& a, const Point& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// `(X, Y)`, each as the shortest decimal number that reads back as the same double; -0.0 as `0`.
[[nodiscard]] WAYWRIGHT_API std::string to_string(const Point& point);

/// Points that lie somewhere else, one after the other: a std::span that is also made from braces, compares with other
/// lists of points and becomes a vector where one is wanted. `PointSpan` is a good parameter for a list of points. Made
/// from braces or from a temporary, it is valid up to the end of the full expression, as a std::span is.
template <class P>
class BasicPointSpan : public std::span<P> {
 public:
  using const_iterator = typename std::span<const Point>::iterator;

  constexpr BasicPointSpan() = default;
  constexpr BasicPointSpan(std::initializer_list<Point> points) requires std::is_const_v<P>
      : std::span<P>(std::data(points), points.size()) {}
  template <class Points>
  requires(!std::derived_from<Points, BasicPointSpan> &&
           std::convertible_to<Points&, std::span<P>>) constexpr BasicPointSpan(Points& points)
      : std::span<P>(points) {}
  template <class Points>
  requires(!std::derived_from<Points, BasicPointSpan> &&
           std::convertible_to<const Points&, std::span<P>>) constexpr BasicPointSpan(const Points& points)
      : std::span<P>(points) {}

  operator std::vector<Point>() const { return {this->begin(), this->end()}; }

  template <class Points>
  requires std::convertible_to<const Points&, std::span<const Point>>
  [[nodiscard]] friend constexpr bool operator==(const BasicPointSpan& a, const Points& b) {
    const std::span<const Point> others(b);
    return std::equal(a.begin(), a.end(), others.begin(), others.end());
  }
};

using PointSpan = BasicPointSpan<const Point>;
using MutablePointSpan = BasicPointSpan<Point>;

/// A closed axis-aligned box.
struct Box {
  Point min;
  Point max;

  friend constexpr bool operator==(const Box&, const Box&) = default;

  /// The smallest box that contains all of the points. Requires: there is a point.
  [[nodiscard]] WAYWRIGHT_API static Box of(PointSpan points);

  [[nodiscard]] constexpr double width() const { return max.x - min.x; }
  [[nodiscard]] constexpr double height() const { return max.y - min.y; }
  /// The middle, rounded.
  [[nodiscard]] WAYWRIGHT_INLINE constexpr Point centre() const { return {min.x + width() / 2, min.y + height() / 2}; }

  /// Whether the point lies in the box or on its border.
  [[nodiscard]] constexpr bool contains(const Point& point) const {
    return point.x >= min.x && point.x <= max.x && point.y >= min.y && point.y <= max.y;
  }
  /// Whether the two boxes have a point in common.
  [[nodiscard]] constexpr bool overlaps(const Box& other) const {
    return min.x <= other.max.x && max.x >= other.min.x && min.y <= other.max.y && max.y >= other.min.y;
  }

  /// Makes the box just large enough to contain the point.
  constexpr void expand(const Point& point) {
    if (point.x < min.x) min.x = point.x;
    if (point.y < min.y) min.y = point.y;
    if (point.x > max.x) max.x = point.x;
    if (point.y > max.y) max.y = point.y;
  }
  /// The box, larger by `margin` on each side.
  [[nodiscard]] constexpr Box expanded(double margin) const {
    return {{min.x - margin, min.y - margin}, {max.x + margin, max.y + margin}};
  }
};

}  // namespace waywright

/// Equal points have equal hashes, 0.0 and -0.0 among them.
template <>
struct std::hash<waywright::Point> {
  std::size_t operator()(const waywright::Point& point) const noexcept {
    const std::size_t x = std::hash<double>{}(point.x);
    const std::size_t y = std::hash<double>{}(point.y);
    return x ^ (y + static_cast<std::size_t>(0x9e3779b97f4a7c15U) + (x << 6) + (x >> 2));
  }
};
