#include <array>
#include <optional>
#include <utility>

#include "exact/formula.hpp"
#include "exact/gap.hpp"

namespace waywright::exact {

namespace formula {

namespace {

// The disc whose diameter is the gap from u to v contains a position P if f(P) = (P - u) . (P - v) <= 0. On the
// segment, P = c + t (d - c), and f is a quadratic function of t, strictly convex unless c = d. With C = c - u, W = v -
// u and E = d - c:
//   f(0) = C . (C - W), f'(0) = E . (2 C - W), and similarly at t = 1.
// The least value of f is the product of the distances of the line cd from u and v, with signs, less the square of half
// of the projection of W on the line: min f = (E x C) (E x (C - W)) / |E|^2 - (E . W)^2 / (4 |E|^2). (The centre of the
// disc has the distance |E x (2 C - W)| / (2 |E|) from the line, and the radius is |W| / 2. Lagrange's identity
// |E|^2 |W|^2 = (E x W)^2 + (E . W)^2 gives the formula.)
//
// The ends of the gap do not count, and f is 0 there. So the formula must know for each position with f = 0 whether it
// is u or v:
//   c and d: each disc below has a number for this, which is 0 only at u and v.
//   The position with the least value, if this is 0: the line cd is a tangent, and it touches the circle there. If this
//   position is u or v, then the line is perpendicular to the gap, so E . W = 0. Conversely, if E . W = 0, then one of
//   the distances is 0 because min f = 0: the line contains u or v.
// If u = v, all three conditions hold, and no position counts.
//
// A disc has the members
//   value(P): a positive multiple of f(P);
//   off_ends(P): 0 if P is u or v, not 0 for other positions P with f(P) = 0;
//   slope(P): a positive multiple of the derivative of f at P, which is c or d;
//   least(): a positive multiple of the least value of f on the line cd;
//   along(): 0 if and only if E . W = 0.

/// The disc of a gap between two points.
template <class Coordinate>
struct DiscToPoint {
  using Position = Site<Coordinate>;
  Position u, v, c, d;

  [[nodiscard]] auto value(const Position& p) const { return dot_product(p - u, p - v); }
  [[nodiscard]] auto off_ends(const Position& p) const { return square(p - u) * square(p - v); }
  [[nodiscard]] auto slope(const Position& p) const { return dot_product(d - c, (p - u) + (p - v)); }
  [[nodiscard]] auto least() const {
    const auto from_u = cross_product(d - c, c - u);
    const auto from_v = cross_product(d - c, c - v);
    const auto projection = along();
    return (from_u + from_u) * (from_v + from_v) - projection * projection;
  }
  [[nodiscard]] auto along() const { return dot_product(d - c, v - u); }
};

/// The disc of a gap to the foot of the perpendicular on the line through a and b. With D = b - a, M = |D|^2 and
/// X = D x (a - u), the foot is v = u + W with W = (X / M) (-D.y, D.x). So for every vector V:
///   V . W = (X / M) (D x V),  V x W = (X / M) (D . V).
/// The values and slopes of f are multiplied by M, and its least value by 4 |E|^2 M^2.
///
/// At a position P with f(P) = 0, let V = P - u. If D . V = 0, then P lies on the line through u and v, so it is one of
/// them. Both have D . V = 0.
template <class Coordinate>
class DiscToFoot {
 public:
  using Position = Site<Coordinate>;

  DiscToFoot(const Position& u, const Position& a, const Position& b, const Position& c, const Position& d)
      : u_(u), c_(c), ab_(b - a), cd_(d - c), m_(square(ab_)), x_(cross_product(ab_, a - u)) {}

  [[nodiscard]] auto value(const Position& p) const {
    const auto from_u = p - u_;
    return m_ * square(from_u) - x_ * cross_product(ab_, from_u);
  }
  [[nodiscard]] auto off_ends(const Position& p) const { return dot_product(ab_, p - u_); }
  [[nodiscard]] auto slope(const Position& p) const {
    const auto from_u = p - u_;
    return m_ * dot_product(cd_, from_u + from_u) - along();
  }
  [[nodiscard]] auto least() const {
    const auto from_u = cross_product(cd_, c_ - u_);
    const auto from_v = m_ * from_u - x_ * dot_product(ab_, cd_);
    const auto projection = along();
    return ((m_ + m_) * (from_u + from_u)) * from_v - projection * projection;
  }
  [[nodiscard]] auto along() const { return x_ * cross_product(ab_, cd_); }

 private:
  using Difference = decltype(std::declval<Position>() - std::declval<Position>());
  using Product = decltype(square(std::declval<Difference>()));

  Position u_, c_;
  Difference ab_, cd_;
  Product m_, x_;
};

/// Whether the disc contains a position that is neither u nor v. `sign` is the sign of f at this position. Calls
/// off_ends() only if f is 0.
template <class OffEnds>
std::optional<bool> is_touch(const std::optional<Sign>& sign, const OffEnds& off_ends) {
  if (!sign) return std::nullopt;
  if (*sign != Sign::zero) return *sign == Sign::negative;
  const std::optional<Sign> off = sign_if_sure(off_ends());
  if (!off) return std::nullopt;
  return *off != Sign::zero;
}

/// Whether the disc contains a position of the segment other than u and v.
template <class Disc>
std::optional<bool> touches_segment(const Disc& disc, const typename Disc::Position& c,
                                    const typename Disc::Position& d) {
  const auto touches_at = [&](const auto& p) {
    return is_touch(sign_if_sure(disc.value(p)), [&] { return disc.off_ends(p); });
  };
  const std::optional<bool> at_c = touches_at(c);
  if (at_c && *at_c) return true;
  const std::optional<bool> at_d = touches_at(d);
  if (at_d && *at_d) return true;
  // Here, if at_c is known, then f(0) >= 0, and the disc contains c only if this is u or v. If f does not fall at c,
  // then f is positive elsewhere. The same holds at d.
  const std::optional<Sign> slope_at_c = sign_if_sure(disc.slope(c));
  if (slope_at_c && *slope_at_c != Sign::negative) return at_c;
  const std::optional<Sign> slope_at_d = sign_if_sure(disc.slope(d));
  if (slope_at_d && *slope_at_d != Sign::positive) return at_d;
  if (!slope_at_c || !slope_at_d) return std::nullopt;
  // The least value on the line lies between c and d. If it is positive, the answer does not depend on at_c and at_d.
  return is_touch(sign_if_sure(disc.least()), [&] { return disc.along(); });
}

struct TouchesToPoint {
  static constexpr bool kHasRadius = false;
  template <class Coordinate>
  static std::optional<bool> answer(const Sites<Coordinate, 4>& sites) {
    const auto& [u, v, c, d] = sites;
    return touches_segment(DiscToPoint<Coordinate>{u, v, c, d}, c, d);
  }
};

struct TouchesToFoot {
  static constexpr bool kHasRadius = false;
  template <class Coordinate>
  static std::optional<bool> answer(const Sites<Coordinate, 5>& sites) {
    const auto& [u, a, b, c, d] = sites;
    return touches_segment(DiscToFoot<Coordinate>(u, a, b, c, d), c, d);
  }
};

template <class Run>
auto run_touches(const Gap& gap, const Point& c, const Point& d) {
  if (!gap.has_foot()) return Run::template run<TouchesToPoint>(std::array{gap.from, gap.a, c, d});
  return Run::template run<TouchesToFoot>(std::array{gap.from, gap.a, gap.b, c, d});
}

}  // namespace

}  // namespace formula

bool touches(const Gap& gap, const Point& c, const Point& d) {
  // The line through a and b touches the disc at the foot only. The filter could not decide this tie.
  const auto is_on_line = [&](const Point& p) { return p == gap.a || p == gap.b; };
  if (gap.has_foot() && is_on_line(c) && is_on_line(d)) return false;
  return formula::run_touches<formula::Decide>(gap, c, d);
}

StageAnswers<bool> stages::touches(const Gap& gap, const Point& c, const Point& d) {
  return formula::run_touches<formula::AskEachStage>(gap, c, d);
}

}  // namespace waywright::exact
