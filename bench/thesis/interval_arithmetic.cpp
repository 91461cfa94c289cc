#include "thesis/interval_arithmetic.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace waywright::bench {
namespace {

/// GMP's conversion to double truncates towards 0. So the number lies between the result and the next double away from
/// 0.
Bounds bounds_of(const mpq_class& number) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double cut = number.get_d();
  const int order = cmp(number, mpq_class(cut));
  if (order == 0) return {cut, cut};
  return order > 0 ? Bounds{cut, std::nextafter(cut, kInfinity)} : Bounds{std::nextafter(cut, -kInfinity), cut};
}

std::optional<std::strong_ordering> order_of_bounds(const Bounds& p, const Bounds& q) {
  if (p.high < q.low) return std::strong_ordering::less;
  if (p.low > q.high) return std::strong_ordering::greater;
  if (p.low == p.high && q.low == q.high) return std::strong_ordering::equal;
  return std::nullopt;
}

}  // namespace

Evaluations IntervalArithmetic::evaluations;

IntervalArithmetic::Position IntervalArithmetic::at(const Point& point) {
  return {{{point.x, point.x}, {point.y, point.y}}, {mpq_class(point.x), mpq_class(point.y)}, point};
}

IntervalArithmetic::Position IntervalArithmetic::at(RationalPoint point) {
  const Point rounded = {point.x.get_d(), point.y.get_d()};
  const BoundedPoint bounds = {bounds_of(point.x), bounds_of(point.y)};
  return {bounds, std::move(point), rounded};
}

IntervalArithmetic::Position IntervalArithmetic::crossing(const Position& a, const Position& b, const Position& c,
                                                          const Position& d) {
  return at(bench::crossing(a.exact, b.exact, c.exact, d.exact));
}

exact::Sign IntervalArithmetic::orientation(const View& a, const View& b, const View& c) {
  ++evaluations.interval;
  if (const auto sign = bench::orientation(a->bounds, b->bounds, c->bounds)) return *sign;
  ++evaluations.exact;
  return bench::orientation(a->exact, b->exact, c->exact);
}

exact::Sign IntervalArithmetic::in_circle(const View& a, const View& b, const View& c, const View& d) {
  ++evaluations.interval;
  if (const auto sign = bench::in_circle(a->bounds, b->bounds, c->bounds, d->bounds)) {
    return *sign;
  }
  ++evaluations.exact;
  return bench::in_circle(a->exact, b->exact, c->exact, d->exact);
}

/// Comparisons of bounds are not arithmetic, so they are not counted.
std::strong_ordering IntervalArithmetic::order(const View& p, const View& q) {
  const auto by_x = order_of_bounds(p->bounds.x, q->bounds.x);
  if (by_x && *by_x != 0) return *by_x;
  const auto by_y = order_of_bounds(p->bounds.y, q->bounds.y);
  if (by_x && by_y) return *by_y;
  return bench::order(p->exact, q->exact);
}

}  // namespace waywright::bench
