#include "exact/predicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "exact/doubles.hpp"
#include "exact/error_bounds.hpp"
#include "exact/homogeneous.hpp"
#include "exact/offsets.hpp"
#include "exact/position.hpp"
#include "exact/wide_integer.hpp"

namespace waywright::exact {

namespace detail {

namespace {

/// Returns the answer of the lattice stage or, if it has none, of integers of any size, and counts which stage has
/// answered.
template <class Answer, class AnyInteger>
Answer decide(StageCounts& stages, const std::optional<Answer>& on_lattice, AnyInteger&& any_integer) {
  if (on_lattice) {
    ++stages.lattice;
    return *on_lattice;
  }
  ++stages.integers;
  return any_integer();
}

}  // namespace

Sign finer_orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
  if (const auto sign = filter::fine::orientation(a, b, c)) {
    ++counts.orientation.doubles;
    return *sign;
  }
  return decide(counts.orientation, lattice::orientation(a, b, c), [&] { return integers::orientation(a, b, c); });
}

Sign finer_in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c, const ExactPosition& d) {
  if (const auto sign = lattice::whole_in_circle(a, b, c, d)) {
    ++counts.in_circle.lattice;
    return *sign;
  }
  if (const auto sign = filter::fine::in_circle(a, b, c, d)) {
    ++counts.in_circle.doubles;
    return *sign;
  }
  if (const auto sign = lattice::in_circle(a, b, c, d)) {
    ++counts.in_circle.lattice;
    return *sign;
  }
  if (const auto sign = any_origin::in_circle(a, b, c, d)) {
    ++counts.in_circle.doubles;
    return *sign;
  }
  ++counts.in_circle.integers;
  return integers::in_circle(a, b, c, d);
}

std::strong_ordering compare_beyond_doubles(const ExactPosition& p, const ExactPosition& q) {
  return decide(counts.order, lattice::compare(p, q), [&] { return integers::compare(p, q); });
}

}  // namespace detail

namespace any_origin {

// A cyclic shift of four points is an odd permutation, so it changes the sign of the determinant.
std::optional<Sign> in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                              const ExactPosition& d) {
  struct Site {
    Bounded x, y;
  };
  const auto site = [](const ExactPosition& p) -> Site {
    const double rounding = p.is_explicit() ? 0.0 : filter::kHalfUlp;
    return {{p.x, rounding * std::abs(p.x)}, {p.y, rounding * std::abs(p.y)}};
  };
  const auto minus = [](const Site& p, const Site& q) -> Site { return {p.x - q.x, p.y - q.y}; };
  const auto lift = [](const Site& p) { return p.x * p.x + p.y * p.y; };
  const auto cross = [](const Site& p, const Site& q) { return p.x * q.y - p.y * q.x; };
  std::array<Site, 4> sites = {site(a), site(b), site(c), site(d)};
  for (const bool is_odd : {false, true, false, true}) {
    const Site p = minus(sites[0], sites[3]);
    const Site q = minus(sites[1], sites[3]);
    const Site r = minus(sites[2], sites[3]);
    const Bounded determinant = lift(p) * cross(q, r) + lift(q) * cross(r, p) + lift(r) * cross(p, q);
    if (const auto sign = sign_if_sure(determinant)) return is_odd ? -*sign : *sign;
    std::rotate(sites.begin(), sites.begin() + 1, sites.end());
  }
  return std::nullopt;
}

}  // namespace any_origin

namespace integers {

namespace {

template <class... Points>
int common_lattice(const Points&... points) {
  LatticeExponent lattice;
  (lattice.include(points), ...);
  return lattice.value();
}

}  // namespace

// The sign of | a.x a.y a.w |
//             | b.x b.y b.w |
//             | c.x c.y c.w |, which is the orientation's determinant times a.w b.w c.w > 0.
Sign orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
  const int lattice = common_lattice(a, b, c);
  const Homogeneous p = to_homogeneous(a, lattice);
  const Homogeneous q = to_homogeneous(b, lattice);
  const Homogeneous r = to_homogeneous(c, lattice);
  const Integer determinant =
      p.x * (q.y * r.w - q.w * r.y) - p.y * (q.x * r.w - q.w * r.x) + p.w * (q.x * r.y - q.y * r.x);
  return sign_of(determinant);
}

// With dx = p.x d.w - d.x p.w and dy = p.y d.w - d.y p.w, a row of the in-circle determinant about d is (dx p.w, dy
// p.w, dx^2 + dy^2): the row times (p.w d.w)^2, with a factor d.w > 0 taken out of the first two columns.
Sign in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c, const ExactPosition& d) {
  const int lattice = common_lattice(a, b, c, d);
  const Homogeneous centre = to_homogeneous(d, lattice);
  struct Row {
    Integer x, y, lift;
  };
  const auto row = [&](const ExactPosition& point) {
    const Homogeneous p = to_homogeneous(point, lattice);
    const Integer dx = p.x * centre.w - centre.x * p.w;
    const Integer dy = p.y * centre.w - centre.y * p.w;
    return Row{dx * p.w, dy * p.w, dx * dx + dy * dy};
  };
  const Row p = row(a);
  const Row q = row(b);
  const Row r = row(c);
  const Integer determinant =
      p.lift * (q.x * r.y - r.x * q.y) + q.lift * (r.x * p.y - p.x * r.y) + r.lift * (p.x * q.y - q.x * p.y);
  return sign_of(determinant);
}

std::strong_ordering compare(const ExactPosition& p, const ExactPosition& q) {
  const int lattice = common_lattice(p, q);
  const Homogeneous a = to_homogeneous(p, lattice);
  const Homogeneous b = to_homogeneous(q, lattice);
  const Sign by_x = sign_of(Integer(a.x * b.w - b.x * a.w));
  return order_of(by_x != Sign::zero ? by_x : sign_of(Integer(a.y * b.w - b.y * a.w)));
}

}  // namespace integers

}  // namespace waywright::exact

namespace waywright {

PredicateCounts predicate_counts() { return exact::counts; }

}  // namespace waywright

namespace waywright::exact::lattice {

namespace {

/// For offsets of at most this many bits, a product of two offsets fits 64 bits, and a sum of two of these products
/// fits 64 bits, too.
constexpr int kSmallBits = 30;

/// Positions as offsets from an origin: an explicit position as one offset, a constructed position as the offsets of
/// the four points that define its lines. The origin is the last position or, if this is constructed, the first of its
/// four points.
template <std::size_t kCount>
class CommonOffsets {
 public:
  explicit CommonOffsets(const std::array<const ExactPosition*, kCount>& points)
      : points_(points), offsets_(points.back()->is_explicit() ? nearest(*points.back()) : points.back()->ab->a) {
    for (const ExactPosition* const point : points) {
      if (point->is_explicit()) {
        offsets_.add(nearest(*point));
      } else {
        for (const PointPair* const line : {point->ab, point->cd}) {
          offsets_.add(line->a);
          offsets_.add(line->b);
        }
      }
    }
  }

  [[nodiscard]] bool find_lattice() { return offsets_.find_lattice(); }
  [[nodiscard]] bool find_any_lattice() { return offsets_.find_any_lattice(); }
  [[nodiscard]] bool is_narrow() const { return offsets_.bits() <= kNarrowBits; }

  template <std::size_t kW>
  [[nodiscard]] std::array<LatticePoint<kW>, kCount> to_lattice() const {
    std::array<LatticePoint<kW>, kCount> result;
    std::size_t next = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
      if (points_[i]->is_explicit()) {
        result[i] = lattice_point<kW>(offsets_[next]);
        next += 1;
      } else {
        result[i] = lattice_crossing<kW>(offsets_[next], offsets_[next + 1], offsets_[next + 2], offsets_[next + 3]);
        next += 4;
      }
    }
    return result;
  }

 private:
  [[nodiscard]] static Point nearest(const ExactPosition& point) { return {point.x, point.y}; }

  std::array<const ExactPosition*, kCount> points_;
  Offsets<4 * kCount> offsets_;
};

// The sign of | a.x a.y a.w |
//             | b.x b.y b.w |
//             | c.x c.y c.w |, which is the orientation's determinant times a.w b.w c.w > 0. If c is explicit, it is
//             the origin.
template <std::size_t kW>
Sign orientation_of(const std::array<LatticePoint<kW>, 3>& points, bool is_last_origin) {
  const auto& [a, b, c] = points;
  if (is_last_origin) return (a.x * b.y - a.y * b.x).sign();
  return (a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w) + a.w * (b.x * c.y - b.y * c.x)).sign();
}

/// A row of the in-circle determinant | x y x^2 + y^2 1 |, times w^2.
template <std::size_t kW>
struct Row {
  WideInteger<2 * kW + 1> x, y;
  WideInteger<2 * kW + 2> lift;
  WideInteger<2 * kW> one;
};

// Laplace expansion along the first two columns: each 2 x 2 minor of these columns times the complementary minor of the
// last two columns. If the last point is explicit, it is the origin, and three rows and three columns remain.
template <std::size_t kW>
Sign in_circle_of(const std::array<LatticePoint<kW>, 4>& points, bool is_last_origin) {
  std::array<Row<kW>, 4> row;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [x, y, w] = points[i];
    row[i] = {x * w, y * w, x * x + y * y, w * w};
  }
  const auto area = [&](std::size_t i, std::size_t j) { return row[i].x * row[j].y - row[j].x * row[i].y; };
  if (is_last_origin) {
    return (row[0].lift * area(1, 2) - row[1].lift * area(0, 2) + row[2].lift * area(0, 1)).sign();
  }
  const auto rest = [&](std::size_t i, std::size_t j) { return row[i].lift * row[j].one - row[j].lift * row[i].one; };
  const auto determinant = area(0, 1) * rest(2, 3) - area(0, 2) * rest(1, 3) + area(0, 3) * rest(1, 2) +
                           area(1, 2) * rest(0, 3) - area(1, 3) * rest(0, 2) + area(2, 3) * rest(0, 1);
  return determinant.sign();
}

template <std::size_t kW>
std::strong_ordering compare_of(const std::array<LatticePoint<kW>, 2>& points) {
  const auto& [p, q] = points;
  const Sign by_x = (p.x * q.w - q.x * p.w).sign();
  return order_of(by_x != Sign::zero ? by_x : (p.y * q.w - q.y * p.w).sign());
}

using Offset = WideInteger<1>;

WideInteger<2> cross(const LatticeVector& p, const LatticeVector& q) {
  return Offset(p.x) * Offset(q.y) - Offset(p.y) * Offset(q.x);
}
WideInteger<2> lift(const LatticeVector& p) { return Offset(p.x) * Offset(p.x) + Offset(p.y) * Offset(p.y); }

std::int64_t small_cross(const LatticeVector& p, const LatticeVector& q) { return p.x * q.y - p.y * q.x; }
std::int64_t small_lift(const LatticeVector& p) { return p.x * p.x + p.y * p.y; }

/// The vector from `origin` to `p`. Empty unless the coordinates of `p` are whole numbers that differ from the
/// coordinates of `origin` by at most 2^kSmallBits. This test recognises by far the most common lattice without a
/// search for it.
/// Requires: the coordinates of `origin` are whole numbers.
std::optional<LatticeVector> whole_offset(const ExactPosition& p, const ExactPosition& origin) {
  constexpr double kFurthest = std::int64_t{1} << kSmallBits;
  const double x = p.x - origin.x;
  const double y = p.y - origin.y;
  if (!(std::abs(x) <= kFurthest && std::abs(y) <= kFurthest && is_whole(p.x) && is_whole(p.y))) return std::nullopt;
  return LatticeVector{static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)};
}

std::optional<Sign> explicit_orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
  Offsets<2> offsets({c.x, c.y});
  offsets.add({a.x, a.y});
  offsets.add({b.x, b.y});
  if (!offsets.find_any_lattice()) return std::nullopt;
  if (offsets.bits() <= kSmallBits) return sign_of(small_cross(offsets[0], offsets[1]));
  return cross(offsets[0], offsets[1]).sign();
}

Sign small_in_circle(const LatticeVector& p, const LatticeVector& q, const LatticeVector& r) {
  const auto term = [](std::int64_t lift, std::int64_t cross) { return Offset(lift) * Offset(cross); };
  return (term(small_lift(p), small_cross(q, r)) + term(small_lift(q), small_cross(r, p)) +
          term(small_lift(r), small_cross(p, q)))
      .sign();
}

std::optional<Sign> explicit_in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                                       const ExactPosition& d) {
  if (is_whole(d.x) && is_whole(d.y)) {
    const auto p = whole_offset(a, d);
    const auto q = whole_offset(b, d);
    const auto r = whole_offset(c, d);
    if (p && q && r) return small_in_circle(*p, *q, *r);
  }
  Offsets<3> offsets({d.x, d.y});
  for (const ExactPosition* const point : {&a, &b, &c}) offsets.add({point->x, point->y});
  if (!offsets.find_lattice()) return std::nullopt;
  const LatticeVector p = offsets[0];
  const LatticeVector q = offsets[1];
  const LatticeVector r = offsets[2];
  if (offsets.bits() <= kSmallBits) return small_in_circle(p, q, r);
  return (lift(p) * cross(q, r) + lift(q) * cross(r, p) + lift(r) * cross(p, q)).sign();
}

/// If the last element of the array is a constructed position and another element is explicit, swaps these two. So the
/// array then ends with an explicit position. Returns whether the function has swapped two elements.
template <std::size_t kCount>
bool put_explicit_last(std::array<const ExactPosition*, kCount>& points) {
  if (points.back()->is_explicit()) return false;
  const auto found =
      std::find_if(points.begin(), points.end(), [](const ExactPosition* p) { return p->is_explicit(); });
  if (found == points.end()) return false;
  std::swap(*found, points.back());
  return true;
}

}  // namespace

std::optional<Sign> orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
  if (a.is_explicit() && b.is_explicit() && c.is_explicit()) return explicit_orientation(a, b, c);
  std::array points{&a, &b, &c};
  const bool is_swapped = put_explicit_last(points);
  CommonOffsets<3> offsets(points);
  if (!offsets.find_any_lattice()) return std::nullopt;
  const bool is_last_origin = points.back()->is_explicit();
  const Sign sign = offsets.is_narrow() ? orientation_of<1>(offsets.to_lattice<1>(), is_last_origin)
                                        : orientation_of<2>(offsets.to_lattice<2>(), is_last_origin);
  return is_swapped ? -sign : sign;
}

// If the sum of the squares of all offsets is at most 2^30, neither a term of the determinant nor the sum of its terms
// exceeds 2^60.
std::optional<Sign> whole_in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                                    const ExactPosition& d) {
  constexpr double kMostSquares = 0x1p30;
  const auto offset = [&](const ExactPosition& p) -> Point { return {p.x - d.x, p.y - d.y}; };
  const auto square = [](const Point& p) { return p.x * p.x + p.y * p.y; };
  const auto to_integers = [](const Point& p) -> LatticeVector {
    return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)};
  };
  const std::array<Point, 3> offsets = {offset(a), offset(b), offset(c)};
  if (!(square(offsets[0]) + square(offsets[1]) + square(offsets[2]) <= kMostSquares)) return std::nullopt;
  for (const ExactPosition* const point : {&a, &b, &c, &d}) {
    if (!point->is_explicit() || !is_whole(point->x) || !is_whole(point->y)) return std::nullopt;
  }
  const LatticeVector p = to_integers(offsets[0]);
  const LatticeVector q = to_integers(offsets[1]);
  const LatticeVector r = to_integers(offsets[2]);
  return sign_of(small_lift(p) * small_cross(q, r) + small_lift(q) * small_cross(r, p) +
                 small_lift(r) * small_cross(p, q));
}

std::optional<Sign> in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                              const ExactPosition& d) {
  if (a.is_explicit() && b.is_explicit() && c.is_explicit() && d.is_explicit()) return explicit_in_circle(a, b, c, d);
  std::array points{&a, &b, &c, &d};
  const bool is_swapped = put_explicit_last(points);
  CommonOffsets<4> offsets(points);
  if (!offsets.find_lattice()) return std::nullopt;
  const bool is_last_origin = points.back()->is_explicit();
  const Sign sign = offsets.is_narrow() ? in_circle_of<1>(offsets.to_lattice<1>(), is_last_origin)
                                        : in_circle_of<2>(offsets.to_lattice<2>(), is_last_origin);
  return is_swapped ? -sign : sign;
}

std::optional<std::strong_ordering> compare(const ExactPosition& p, const ExactPosition& q) {
  CommonOffsets<2> points({&p, &q});
  if (!points.find_any_lattice()) return std::nullopt;
  return points.is_narrow() ? compare_of<1>(points.to_lattice<1>()) : compare_of<2>(points.to_lattice<2>());
}

}  // namespace waywright::exact::lattice
