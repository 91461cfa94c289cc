#include "oracle/exact.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace waywright::oracle {
namespace {

/// mantissa * 2^exponent. The mantissa is odd, or 0 for the number 0.
struct Binary {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

Binary binary(double value) {
  if (value == 0.0) return {};
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {mantissa / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

Integer shifted(Integer value, int bits) {
  value <<= static_cast<unsigned>(bits);
  return value;
}

int sign_of(const Integer& value) { return value.sign(); }

int bit_length(const Integer& positive) { return static_cast<int>(boost::multiprecision::msb(positive)) + 1; }

}  // namespace

Grid::Grid(const std::vector<OraclePoint>& points) {
  bool first = true;
  const auto take = [&](double value) {
    if (value == 0.0) return;
    const int exponent = binary(value).exponent;
    exponent_ = first ? exponent : std::min(exponent_, exponent);
    first = false;
  };
  for (const OraclePoint& p : points) {
    take(p.x);
    take(p.y);
  }
}

ExactPosition Grid::point(OraclePoint p) const {
  const Binary x = binary(p.x);
  const Binary y = binary(p.y);
  int finer = 0;
  if (x.mantissa != 0) finer = std::max(finer, exponent_ - x.exponent);
  if (y.mantissa != 0) finer = std::max(finer, exponent_ - y.exponent);
  const auto on_grid = [&](const Binary& value) {
    return value.mantissa == 0 ? Integer(0) : shifted(Integer(value.mantissa), value.exponent - exponent_ + finer);
  };
  return {on_grid(x), on_grid(y), shifted(Integer(1), finer), {p.x, p.x}, {p.y, p.y}};
}

ExactPosition Grid::crossing(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c,
                             const ExactPosition& d) const {
  const Integer ab_x = b.x - a.x;
  const Integer ab_y = b.y - a.y;
  const Integer cd_x = d.x - c.x;
  const Integer cd_y = d.y - c.y;
  Integer across = ab_x * cd_y - ab_y * cd_x;
  Integer along = (c.x - a.x) * cd_y - (c.y - a.y) * cd_x;
  if (across.sign() < 0) {
    across = -across;
    along = -along;
  }
  ExactPosition result{a.x * across + along * ab_x, a.y * across + along * ab_y, across, {}, {}};
  const OraclePoint near{nearest_double(result.x, result.w), nearest_double(result.y, result.w)};
  result.near_x = {near.x, near.x};
  result.near_y = {near.y, near.y};
  const ExactPosition rounded = point(near);
  if (result.x * rounded.w != rounded.x * result.w) result.near_x = {below(near.x), above(near.x)};
  if (result.y * rounded.w != rounded.y * result.w) result.near_y = {below(near.y), above(near.y)};
  return result;
}

ExactPosition Grid::midpoint(const ExactPosition& a, const ExactPosition& b) {
  const Interval half{0.5, 0.5};
  return {a.x * b.w + b.x * a.w, a.y * b.w + b.y * a.w, 2 * a.w * b.w, (a.near_x + b.near_x) * half,
          (a.near_y + b.near_y) * half};
}

std::string Grid::text(const ExactPosition& p) const { return rational_text(p.x, p.w) + ' ' + rational_text(p.y, p.w); }

std::string Grid::rational_text(const Integer& numerator, const Integer& denominator) const {
  if (numerator.is_zero()) return "0 1";
  Integer top = exponent_ > 0 ? shifted(numerator, exponent_) : numerator;
  Integer bottom = exponent_ < 0 ? shifted(denominator, -exponent_) : denominator;
  const Integer common = gcd(top, bottom);
  top /= common;
  bottom /= common;
  return top.str() + ' ' + bottom.str();
}

OraclePoint Grid::nearest(const ExactPosition& p) const {
  if (p.is_double()) return {p.near_x.lo, p.near_y.lo};
  return {nearest_double(p.x, p.w), nearest_double(p.y, p.w)};
}

double Grid::nearest_double(const Integer& numerator, const Integer& denominator) const {
  if (numerator.is_zero()) return 0.0;
  Integer top = abs(numerator);
  Integer bottom = denominator;
  // Computes a quotient of 55 or 56 bits. A double has two or three bits less, so a sticky bit decides every tie.
  const int shift = 55 - bit_length(top) + bit_length(bottom);
  if (shift > 0) top = shifted(top, shift);
  if (shift < 0) bottom = shifted(bottom, -shift);
  Integer quotient;
  Integer remainder;
  divide_qr(top, bottom, quotient, remainder);
  auto bits = static_cast<std::uint64_t>(quotient);
  if (!remainder.is_zero()) bits |= 1;
  const int extra = static_cast<int>(std::bit_width(bits)) - 53;
  const std::uint64_t half = std::uint64_t{1} << (extra - 1);
  const std::uint64_t rest = bits & (2 * half - 1);
  std::uint64_t mantissa = bits >> extra;
  if (rest > half || (rest == half && (mantissa & 1) != 0)) ++mantissa;
  const double magnitude = std::ldexp(static_cast<double>(mantissa), extra - shift + exponent_);
  return numerator.sign() < 0 ? -magnitude : magnitude;
}

int compare_x(const ExactPosition& a, const ExactPosition& b) {
  if (a.near_x.hi < b.near_x.lo) return -1;
  if (a.near_x.lo > b.near_x.hi) return 1;
  if (a.near_x.lo == a.near_x.hi && b.near_x.lo == b.near_x.hi) return 0;
  return sign_of(a.x * b.w - b.x * a.w);
}

int compare_y(const ExactPosition& a, const ExactPosition& b) {
  if (a.near_y.hi < b.near_y.lo) return -1;
  if (a.near_y.lo > b.near_y.hi) return 1;
  if (a.near_y.lo == a.near_y.hi && b.near_y.lo == b.near_y.hi) return 0;
  return sign_of(a.y * b.w - b.y * a.w);
}

int compare_xy(const ExactPosition& a, const ExactPosition& b) {
  const int by_x = compare_x(a, b);
  return by_x != 0 ? by_x : compare_y(a, b);
}

int orientation(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
  const int filtered =
      certain_sign((a.near_x - c.near_x) * (b.near_y - c.near_y) - (a.near_y - c.near_y) * (b.near_x - c.near_x));
  if (filtered != 0) return filtered;
  return sign_of(a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w) + a.w * (b.x * c.y - c.x * b.y));
}

int in_circle(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c, const ExactPosition& d) {
  const auto filtered = [&] {
    const auto row = [&](const ExactPosition& p) {
      const Interval dx = p.near_x - d.near_x;
      const Interval dy = p.near_y - d.near_y;
      return std::array<Interval, 3>{dx, dy, dx * dx + dy * dy};
    };
    const auto [ax, ay, az] = row(a);
    const auto [bx, by, bz] = row(b);
    const auto [cx, cy, cz] = row(c);
    return certain_sign(az * (bx * cy - cx * by) - bz * (ax * cy - cx * ay) + cz * (ax * by - bx * ay));
  }();
  if (filtered != 0) return filtered;
  // A point's offset from d is (dx, dy) / (w * d.w). Its row is multiplied by (w * d.w)^2, and two columns are divided
  // by their common factor d.w.
  const auto row = [&](const ExactPosition& p) {
    const Integer dx = p.x * d.w - d.x * p.w;
    const Integer dy = p.y * d.w - d.y * p.w;
    return std::array<Integer, 3>{dx * p.w, dy * p.w, dx * dx + dy * dy};
  };
  const auto [ax, ay, az] = row(a);
  const auto [bx, by, bz] = row(b);
  const auto [cx, cy, cz] = row(c);
  return sign_of(az * (bx * cy - cx * by) - bz * (ax * cy - cx * ay) + cz * (ax * by - bx * ay));
}

bool on_segment(const ExactPosition& a, const ExactPosition& b, const ExactPosition& p) {
  if (p.near_x.hi < std::min(a.near_x.lo, b.near_x.lo) || p.near_x.lo > std::max(a.near_x.hi, b.near_x.hi) ||
      p.near_y.hi < std::min(a.near_y.lo, b.near_y.lo) || p.near_y.lo > std::max(a.near_y.hi, b.near_y.hi)) {
    return false;
  }
  if (orientation(a, b, p) != 0) return false;
  return compare_xy(a, p) * compare_xy(p, b) >= 0;
}

bool same_direction(const ExactPosition& at, const ExactPosition& u, const ExactPosition& v) {
  return compare_xy(at, u) == compare_xy(at, v);
}

bool in_angle(const ExactPosition& at, const ExactPosition& u, const ExactPosition& t, const ExactPosition& v) {
  const int turn = orientation(at, u, v);
  const int from_u = orientation(at, u, t);
  const int to_v = orientation(at, t, v);
  if (turn > 0) return from_u > 0 && to_v > 0;
  if (turn == 0) return from_u > 0;
  return !(to_v <= 0 && from_u <= 0);  // not in the closed angle from v to u, which is less than half a turn
}

bool cross_properly(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c, const ExactPosition& d) {
  const auto apart = [](Interval p, Interval q, Interval r, Interval s) {
    return std::max(p.hi, q.hi) < std::min(r.lo, s.lo) || std::max(r.hi, s.hi) < std::min(p.lo, q.lo);
  };
  if (apart(a.near_x, b.near_x, c.near_x, d.near_x) || apart(a.near_y, b.near_y, c.near_y, d.near_y)) return false;
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

}  // namespace waywright::oracle
