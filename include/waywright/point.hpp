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

/// @addtogroup items
/// @{

/// A point in the plane, or a vector from one point to another. The library takes every finite double exactly as it is;
/// -0.0 means 0.0.
///
/// @code{.cpp}
/// const Point a{1, 2};
/// const Point middle = (a + Point{5, 4}) / 2;  // == Point{3, 3}
/// world.insert_segment(a, middle).value();
/// @endcode
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

/// @name The range of coordinates
/// A world accepts a coordinate that is 0, or that has a magnitude from kSmallestCoordinate to kLargestCoordinate.
/// Every double in this range is a multiple of 2^-152. So differences of coordinates, and products of up to four of
/// them, neither overflow nor underflow. Check data from outside with is_in_range.
///
/// @code{.cpp}
/// const bool is_good = is_in_range(Point{1e-3, 1e6});  // == true
/// const bool is_bad = is_in_range(1e300);              // == false
/// @endcode
/// @{

/// The largest magnitude of a coordinate: 2^100.
inline constexpr double kLargestCoordinate = 0x1p100;
/// The smallest magnitude of a coordinate that is not 0: 2^-100.
inline constexpr double kSmallestCoordinate = 0x1p-100;

/// Returns whether a world accepts a coordinate.
[[nodiscard]] inline bool is_in_range(double coordinate) {
  const double magnitude = std::abs(coordinate);
  return coordinate == 0.0 || (magnitude >= kSmallestCoordinate && magnitude <= kLargestCoordinate);
}
/// Returns whether a world accepts both coordinates of a point.
[[nodiscard]] inline bool is_in_range(const Point& point) { return is_in_range(point.x) && is_in_range(point.y); }

/// @}

/// @name Arithmetic of points
/// Plain arithmetic in doubles, rounded as usual. In your program, your compiler compiles these functions with your
/// options: if it fuses a multiplication and an addition (`-ffp-contract=fast`), the last bit of a result may change.
/// The answers of the library do not depend on your options.
///
/// @code{.cpp}
/// const Point a{0, 0};
/// const Point b{3, 4};
/// const double length_of_side = distance(a, b);   // == 5
/// const Point quarter = lerp(a, b, 0.25);         // == Point{0.75, 1}
/// const bool turns_left = cross(b, {-4, 3}) > 0;  // == true
/// const std::string text = to_string(b);          // == "(3, 4)"
/// @endcode
/// @{

/// Returns the dot product.
[[nodiscard]] WAYWRIGHT_INLINE constexpr double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
/// Returns the z coordinate of the cross product. It is positive if the direction `b` points to the left of the
/// direction `a`.
[[nodiscard]] WAYWRIGHT_INLINE constexpr double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
/// Returns the square of the length, without computing a square root.
[[nodiscard]] WAYWRIGHT_INLINE constexpr double squared_length(const Point& a) { return dot(a, a); }
/// Returns the distance from (0, 0).
[[nodiscard]] WAYWRIGHT_INLINE double length(const Point& a) { return std::sqrt(squared_length(a)); }
/// Returns the distance between two points.
[[nodiscard]] WAYWRIGHT_INLINE double distance(const Point& a, const Point& b) { return length(b - a); }
/// Returns the point at the fraction `t` of the segment from `a` to `b`: exactly `a` if t = 0, exactly `b` if t = 1.
[[nodiscard]] WAYWRIGHT_INLINE constexpr Point lerp(const Point& a, const Point& b, double t) {
  return t == 1.0 ? b : Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}
/// Returns whether `a` comes before `b` in (x, y) order: by x and, if the x are equal, by y. Use it with std::sort and
/// std::map.
[[nodiscard]] constexpr bool comes_before(const Point& a, const Point& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Returns the text `(X, Y)`. Each coordinate is the shortest decimal number from which the same double can be read;
/// -0.0 is `0`.
[[nodiscard]] WAYWRIGHT_API std::string to_string(const Point& point);

/// @}

/// A view of points in an array that another object owns: a std::span with three additions. You can make it from
/// braces, compare it with other lists of points, and convert it to a std::vector. `PointSpan` is a good parameter type
/// for a list of points. If you make it from braces or from a temporary, it is valid only until the end of the full
/// expression.
///
/// @code{.cpp}
/// const auto length_of = [](PointSpan points) {
///   double sum = 0;
///   for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
///   return sum;
/// };
/// const double from_braces = length_of({{0, 0}, {3, 4}, {3, 5}});  // == 6
/// const double of_path = length_of(path.points);                   // == 0
/// @endcode
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

  /// Returns a copy.
  operator std::vector<Point>() const { return {this->begin(), this->end()}; }

  template <class Points>
  requires std::convertible_to<const Points&, std::span<const Point>>
  [[nodiscard]] friend constexpr bool operator==(const BasicPointSpan& a, const Points& b) {
    const std::span<const Point> others(b);
    return std::equal(a.begin(), a.end(), others.begin(), others.end());
  }
};

/// A view of points that you can read.
using PointSpan = BasicPointSpan<const Point>;
/// A view of points that you can change.
using MutablePointSpan = BasicPointSpan<Point>;

/// A closed axis-aligned box.
///
/// @code{.cpp}
/// const Box box = Box::bounding({{4, 1}, {2, 5}, {3, 3}});  // == Box{{2, 1}, {4, 5}}
/// const bool is_inside = box.contains({2, 1});        // == true
/// const std::vector<ItemId> near = world.items_in(box.expanded(20)).value();
/// @endcode
struct Box {
  Point min;
  Point max;

  friend constexpr bool operator==(const Box&, const Box&) = default;

  /// Returns the smallest box that contains all of the points.
  /// Requires: there is a point.
  [[nodiscard]] WAYWRIGHT_API static Box bounding(PointSpan points);

  /// Returns the extent in x.
  [[nodiscard]] constexpr double width() const { return max.x - min.x; }
  /// Returns the extent in y.
  [[nodiscard]] constexpr double height() const { return max.y - min.y; }
  /// Returns the middle of the box, rounded to doubles.
  [[nodiscard]] WAYWRIGHT_INLINE constexpr Point centre() const { return {min.x + width() / 2, min.y + height() / 2}; }

  /// Returns whether the point lies in the box or on its border.
  [[nodiscard]] constexpr bool contains(const Point& point) const {
    return point.x >= min.x && point.x <= max.x && point.y >= min.y && point.y <= max.y;
  }
  /// Returns whether the two boxes have a point in common.
  [[nodiscard]] constexpr bool overlaps(const Box& other) const {
    return min.x <= other.max.x && max.x >= other.min.x && min.y <= other.max.y && max.y >= other.min.y;
  }

  /// Enlarges the box as little as possible, so that it contains the point.
  constexpr void expand(const Point& point) {
    if (point.x < min.x) min.x = point.x;
    if (point.y < min.y) min.y = point.y;
    if (point.x > max.x) max.x = point.x;
    if (point.y > max.y) max.y = point.y;
  }
  /// Returns a copy of the box that is larger by `margin` in each of the four directions.
  [[nodiscard]] constexpr Box expanded(double margin) const {
    return {{min.x - margin, min.y - margin}, {max.x + margin, max.y + margin}};
  }
};

/// @}

}  // namespace waywright

/// The hash of a point, for std::unordered_map. Equal points have equal hashes, also 0.0 and -0.0.
template <>
struct std::hash<waywright::Point> {
  std::size_t operator()(const waywright::Point& point) const noexcept {
    const std::size_t x = std::hash<double>{}(point.x);
    const std::size_t y = std::hash<double>{}(point.y);
    return x ^ (y + static_cast<std::size_t>(0x9e3779b97f4a7c15U) + (x << 6) + (x >> 2));
  }
};
