#include "exact/predicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/error_bounds.hpp"
#include "exact/homogeneous.hpp"
#include "exact/position.hpp"

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
