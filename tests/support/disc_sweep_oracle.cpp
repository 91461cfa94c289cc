#include "support/disc_sweep_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace waywright::test::disc {
namespace {

namespace mp = boost::multiprecision;

template <unsigned kBits>
using Float = mp::number<mp::cpp_bin_float<kBits, mp::digit_base_2>, mp::et_off>;
/// For positions, and for moments that surely differ.
using Wide = Float<400>;
/// More bits than two moments of the scenes have in common unless they are equal.
using LongReal = Float<24000>;

RationalPoint rational(Point p) { return {Rational(p.x), Rational(p.y)}; }
RationalPoint minus(const RationalPoint& p, const RationalPoint& q) { return {p.x - q.x, p.y - q.y}; }
Rational dot(const RationalPoint& p, const RationalPoint& q) { return p.x * q.x + p.y * q.y; }
Rational cross(const RationalPoint& p, const RationalPoint& q) { return p.x * q.y - p.y * q.x; }

/// Whether the boxes around the motion and the wall are farther apart than the radius, by more than all rounding
/// errors.
bool is_surely_missed(const Motion& motion, const std::pair<Point, Point>& wall) {
  const auto is_apart = [&](double from, double to, double a, double b) {
    const double margin = motion.radius + 1e-9 * (motion.radius + std::abs(from) + std::abs(to));
    return std::max(a, b) < std::min(from, to) - margin || std::min(a, b) > std::max(from, to) + margin;
  };
  return is_apart(motion.from.x, motion.to.x, wall.first.x, wall.second.x) ||
         is_apart(motion.from.y, motion.to.y, wall.first.y, wall.second.y);
}

/// The function a t^2 + b t + c.
struct Quadratic {
  Rational a, b, c;
  [[nodiscard]] Rational at(const Rational& t) const { return (a * t + b) * t + c; }
};

/// The first time from `begin` to `end` at which the function is at most 0. Requires: a >= 0.
std::optional<Moment> first_not_positive(const Quadratic& f, const Rational& begin, const Rational& end) {
  if (f.at(begin) <= 0) return Moment{begin, 0};
  if (f.a == 0) {
    if (f.b >= 0) return std::nullopt;
    const Rational root = -f.c / f.b;
    return root <= end ? std::optional(Moment{root, 0}) : std::nullopt;
  }
  const Rational middle = -f.b / (2 * f.a);
  if (middle <= begin) return std::nullopt;
  if (f.at(end < middle ? end : middle) > 0) return std::nullopt;
  return Moment{middle, middle * middle - f.c / f.a};
}

template <class Number>
Number to(const Rational& value) {
  return Number(mp::numerator(value)) / Number(mp::denominator(value));
}
/// The sign of p - q, or nothing if the numbers have too few bits.
template <class Number>
std::optional<int> sign_of_difference(const Moment& p, const Moment& q) {
  const std::array<Number, 4> terms{to<Number>(p.whole), -sqrt(to<Number>(p.square)), -to<Number>(q.whole),
                                    sqrt(to<Number>(q.square))};
  Number sum = 0;
  Number magnitude = 0;
  for (const Number& term : terms) {
    sum += term;
    magnitude += abs(term);
  }
  if (abs(sum) <= ldexp(magnitude, 20 - std::numeric_limits<Number>::digits)) return std::nullopt;
  return sum < 0 ? -1 : 1;
}

/// Whether two moments are equal: then sqrt(p.square) = difference + sqrt(q.square).
bool are_equal(const Moment& p, const Moment& q) {
  const Rational difference = p.whole - q.whole;
  if (difference == 0) return p.square == q.square;
  const Rational root = (p.square - q.square - difference * difference) / (2 * difference);
  return root >= 0 && root * root == q.square && difference + root >= 0;
}

struct RealPoint {
  Wide x, y;
};

RealPoint position(const Motion& motion, const Moment& moment) {
  const Wide t = to<Wide>(moment.whole) - sqrt(to<Wide>(moment.square));
  const auto between = [&](double from, double to) -> Wide { return Wide(from) + t * (Wide(to) - Wide(from)); };
  return {between(motion.from.x, motion.to.x), between(motion.from.y, motion.to.y)};
}

Point rounded(const RealPoint& p) { return {p.x.convert_to<double>(), p.y.convert_to<double>()}; }

RealPoint nearest(const RealPoint& p, const std::pair<Point, Point>& wall) {
  const Wide x = Wide(wall.second.x) - Wide(wall.first.x);
  const Wide y = Wide(wall.second.y) - Wide(wall.first.y);
  Wide share = ((p.x - Wide(wall.first.x)) * x + (p.y - Wide(wall.first.y)) * y) / (x * x + y * y);
  if (share < 0) share = 0;
  if (share > 1) share = 1;
  return {Wide(wall.first.x) + share * x, Wide(wall.first.y) + share * y};
}

}  // namespace

std::optional<Moment> first_moment(const Motion& motion, const std::pair<Point, Point>& wall) {
  const RationalPoint from = rational(motion.from);
  const RationalPoint d = minus(rational(motion.to), from);
  const RationalPoint a = rational(wall.first);
  const RationalPoint ab = minus(rational(wall.second), a);
  const Rational length = dot(ab, ab);
  const Rational limit = Rational(motion.radius) * Rational(motion.radius);
  const auto to_end = [&](const RationalPoint& end) {
    const RationalPoint f = minus(from, end);
    return Quadratic{dot(d, d), 2 * dot(d, f), dot(f, f) - limit};
  };
  const Rational start = cross(ab, minus(from, a));
  const Rational rate = cross(ab, d);
  const Quadratic to_line{rate * rate / length, 2 * start * rate / length, start * start / length - limit};
  // The projection on the wall is `before` + t `speed`, from 0 at `a` to `length` at the other end.
  const Rational before = dot(ab, minus(from, a));
  const Rational speed = dot(ab, d);
  std::vector<Rational> times{0, 1};
  if (speed != 0) {
    for (const Rational& t : {Rational(-before / speed), Rational((length - before) / speed)}) {
      if (t > 0 && t < 1) times.push_back(t);
    }
    std::sort(times.begin(), times.end());
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    const Rational projection = before + (times[i - 1] + times[i]) / 2 * speed;
    const Quadratic f = projection <= 0 ? to_end(a) : projection < length ? to_line : to_end(rational(wall.second));
    if (const auto moment = first_not_positive(f, times[i - 1], times[i])) return moment;
  }
  return std::nullopt;
}

int compare(const Moment& p, const Moment& q) {
  if (const auto sign = sign_of_difference<Wide>(p, q)) return *sign;
  if (are_equal(p, q)) return 0;
  return sign_of_difference<LongReal>(p, q).value();
}

FirstTouch first_touch(const Walls& walls, const Motion& motion) {
  FirstTouch result;
  std::optional<Moment> first;
  for (std::size_t i = 0; i < walls.segments.size(); ++i) {
    const auto& wall = walls.segments[i];
    if (wall.first == wall.second || is_surely_missed(motion, wall)) continue;
    const auto moment = first_moment(motion, wall);
    if (!moment) continue;
    const int order = first ? compare(*moment, *first) : -1;
    if (order < 0) {
      result.walls.clear();
      first = moment;
    }
    if (order <= 0) result.walls.push_back(i);
  }
  if (!first) return result;
  const RealPoint centre = position(motion, *first);
  result.centre = rounded(centre);
  for (const std::size_t i : result.walls) result.contacts.push_back(rounded(nearest(centre, walls.segments[i])));
  return result;
}

}  // namespace waywright::test::disc
