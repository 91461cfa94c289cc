#pragma once

#include <compare>
#include <optional>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "exact/error_bounds.hpp"
#include "exact/position.hpp"

namespace waywright::exact {

// Predicates for clearance. They compare gaps between explicit positions, and distances. Like the predicates of
// predicates.hpp they run in stages: doubles with a proven error bound; integers of fixed width, if all coordinates lie
// on one lattice; integers of any size. All functions require: the points are in range.

/// The straight gap from a point to another point (then a == b), or to the foot of the perpendicular from the point on
/// the line through a and b.
struct Gap {
  Point from;
  Point a;
  Point b;

  /// Whether the gap ends at the foot of a perpendicular.
  [[nodiscard]] bool has_foot() const { return a != b; }
};

namespace detail {
/// These functions run the stages that follow the filter of dot(), one after the other.
[[nodiscard]] Sign finer_dot(const Point& p, const Point& q, const Point& a, const Point& b);
[[nodiscard]] Sign finer_dot(const Point& p, const Crossing& q, const Point& a, const Point& b);

/// The filter of dot(). The coordinates of q are exact or rounded to nearest.
template <class Coordinate>
[[nodiscard]] auto dot_in_doubles(const Point& p, const Coordinate& qx, const Coordinate& qy, const Point& a,
                                  const Point& b) {
  const auto exact = [](double coordinate) { return ExactDouble{coordinate}; };
  return sign_if_sure((qx - exact(p.x)) * (exact(b.x) - exact(a.x)) + (qy - exact(p.y)) * (exact(b.y) - exact(a.y)));
}
}  // namespace detail

/// The sign of (q - p) . (b - a).
[[nodiscard]] inline Sign dot(const Point& p, const Point& q, const Point& a, const Point& b) {
  if (const auto sign = detail::dot_in_doubles(p, ExactDouble{q.x}, ExactDouble{q.y}, a, b)) return *sign;
  return detail::finer_dot(p, q, a, b);
}

/// The sign of (q - p) . (b - a). `q` may be a crossing.
[[nodiscard]] inline Sign dot(const Point& p, const ExactPosition& q, const Point& a, const Point& b) {
  if (q.is_explicit()) return dot(p, Point{q.x, q.y}, a, b);
  if (const auto sign = detail::dot_in_doubles(p, NearestDouble{q.x}, NearestDouble{q.y}, a, b)) return *sign;
  return detail::finer_dot(p, q.crossing(), a, b);
}

/// Consider the line through `w` and the centre of the circle through `w`, `x` and `y`, in the direction from `w` to
/// the centre. Returns where `z` lies relative to this line: positive if it lies left of it, negative if it lies right
/// of it, zero if it lies on it. Requires: `w`, `x` and `y` are counter-clockwise. Computes with integers of any size
/// only.
[[nodiscard]] Sign side_of_diameter(const Point& w, const ExactPosition& x, const ExactPosition& y,
                                    const ExactPosition& z);

/// Whether the closed disc whose diameter is the gap contains a position of the segment from `c` to `d` other than the
/// two ends of the gap. `c` and `d` may be equal.
[[nodiscard]] bool touches(const Gap& gap, const Point& c, const Point& d);

/// Compares the length of the gap with 2 * radius. Requires: the radius is finite and not negative. It may be subnormal
/// or larger than kLargestCoordinate.
[[nodiscard]] std::strong_ordering compare_to_diameter(const Gap& gap, double radius);

/// Compares the lengths of two gaps.
[[nodiscard]] std::strong_ordering compare_lengths(const Gap& p, const Gap& q);

/// Compares the distance from `c` to the segment from `a` to `b` with the radius. `a` and `b` may be equal. Requires:
/// the radius is finite and not negative, as for compare_to_diameter().
[[nodiscard]] std::strong_ordering compare_distance(const Point& c, const Point& a, const Point& b, double radius);

/// Compares the distances from `c` to two segments. Each segment may be a point.
[[nodiscard]] std::strong_ordering compare_distances(const Point& c, const Point& a1, const Point& b1, const Point& a2,
                                                     const Point& b2);

/// The largest radius of a disc whose diameter is not larger than the length of the gap: half the length, rounded down
/// exactly. Requires: the length of the gap is above 0. Cost: a few products of wide integers, which allocate nothing.
[[nodiscard]] double largest_radius(const Gap& gap);

/// The length of the gap, up to a few ulps. For output and for the order of a search only, never for decisions.
[[nodiscard]] double length(const Gap& gap);

/// The end of the gap, `a` or the foot of the perpendicular: each coordinate up to a few ulps. For output and for the
/// order of a search only, never for decisions.
[[nodiscard]] Point end_of(const Gap& gap);

/// The answer of each stage alone, so that tests can compare them with one another. A stage that cannot answer is
/// empty.
template <class Answer>
struct StageAnswers {
  std::optional<Answer> doubles;
  std::optional<Answer> whole;     ///< small multiples of 1 (with a radius: of 2^-10), without a search for the lattice
  std::optional<Answer> small;     ///< offsets below 2^13 in units of the lattice
  std::optional<Answer> narrow;    ///< offsets below 2^29
  std::optional<Answer> wide;      ///< offsets below 2^60
  std::optional<Answer> integers;  ///< integers of any size, which always answer
};

namespace stages {
[[nodiscard]] StageAnswers<Sign> dot(const Point& p, const Point& q, const Point& a, const Point& b);
/// For a crossing, only the doubles and the integers of any size answer.
[[nodiscard]] StageAnswers<Sign> dot(const Point& p, const ExactPosition& q, const Point& a, const Point& b);
[[nodiscard]] StageAnswers<bool> touches(const Gap& gap, const Point& c, const Point& d);
[[nodiscard]] StageAnswers<Sign> compare_to_diameter(const Gap& gap, double radius);
[[nodiscard]] StageAnswers<Sign> compare_lengths(const Gap& p, const Gap& q);
[[nodiscard]] StageAnswers<Sign> compare_distance(const Point& c, const Point& a, const Point& b, double radius);
[[nodiscard]] StageAnswers<Sign> compare_distances(const Point& c, const Point& a1, const Point& b1, const Point& a2,
                                                   const Point& b2);
}  // namespace stages

}  // namespace waywright::exact
