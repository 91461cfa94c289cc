#include "exact/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <type_traits>

#include "exact/doubles.hpp"
#include "exact/error_bounds.hpp"
#include "exact/gap.hpp"
#include "exact/homogeneous.hpp"

namespace waywright::exact {

namespace {

// The centre is p(t) = from + t d with d = to - from, and t runs from 0 to 1. Let the disc touch nothing at t = 0.
//
// The side's two ends are a and b; ab = b - a, M = |ab|^2. Exchange the ends so that s = ab x (from - a) >= 0.
//
// Line. If s > r sqrt(M), the centre lies outside the strip of the positions nearer to the side's line than r. It
// enters the strip at t = (s - r sqrt(M)) / c with c = d x ab, if c > 0. If the centre then lies between the
// perpendiculars at the two ends, the disc touches the side there, strictly between its ends. The perpendicular at
// a does not separate the centre from b if
//   ab . (p(t) - a) > 0. With f = from - a, this is (ab . f) c + (ab . d) (s - r sqrt(M)) > 0. Because of
//   (ab . f) (d x ab) + (ab . d) (ab x f) = M (d x f), it is sqrt(M) (d x f) - r (ab . d) > 0.
// If the perpendicular at a separates the centre from b at this t, the centre can enter the capsule around the side
// only through the circle around a: every other point of the capsule lies within the strip, not separated from b by the
// perpendicular at a, and the diameter of the circle blocks the strip there. The same is true at b. If the centre
// starts in the strip, it does not lie between the two perpendiculars, and again it can enter the capsule only through
// the circle around the nearer end.
//
// Vertex v. With q = v - from, D = |d|^2 and e = d . q, the centre enters the circle at the smaller root of
//   D t^2 - 2 e t + |q|^2 - r^2 = 0, which is t = (e - sqrt(E)) / D with E = D r^2 - (d x q)^2 = e^2 - D (|q|^2 - r^2).
// The circle lies ahead if e > 0, and the line meets it if E >= 0. The centre reaches it by t = 1 if it has passed the
// middle of the chord, e <= D, or if it ends in the circle.

template <class Number>
struct Vector {
  Number x, y;
};
template <class Number>
Number cross(const Vector<Number>& p, const Vector<Number>& q) {
  return p.x * q.y - p.y * q.x;
}
template <class Number>
Number dot(const Vector<Number>& p, const Vector<Number>& q) {
  return p.x * q.x + p.y * q.y;
}

/// A touch happens at t = (n - m sqrt(p)) / k with k > 0, n > 0 and m >= 0.
template <class Number>
struct Root {
  Number n, m, p, k;
};

// Doubles

std::optional<Sign> sign_of_sum(const Bounded& a, const Bounded& b, const Bounded& p) {
  return sign_if_sure(a + b * square_root(p));
}
std::optional<Sign> sign_of_sum(const Bounded& a, const Bounded& b, const Bounded& p, const Bounded& c,
                                const Bounded& q) {
  return sign_if_sure(a + b * square_root(p) + c * square_root(q));
}

/// The numbers of a sweep in doubles.
class InDoubles {
 public:
  using Number = Bounded;

  explicit InDoubles(const Sweep& sweep) : radius_{sweep.radius, 0.0} {}

  /// The vector from q to p.
  [[nodiscard]] Vector<Number> difference(const Point& p, const Point& q) const {
    return {bounded_difference(p.x, q.x), bounded_difference(p.y, q.y)};
  }
  [[nodiscard]] const Number& radius() const { return radius_; }
  [[nodiscard]] static Number one() { return {1.0, 0.0}; }

 private:
  Number radius_;
};

/// Bounds the radius. In range, no distance is above 2^101.5, so two larger radii give the same answers.
Sweep bounded(const Sweep& sweep) { return {sweep.from, sweep.to, std::min(sweep.radius, 0x1p103)}; }

// Integers

/// An offset between coordinates in range has at most 253 bits on their lattice, whose unit is at least kSmallestUnit.
/// The widest number below is the product of 16 lengths, times less than 16. If the radius is a multiple of the unit,
/// all numbers lie on the stack. The memory of numbers for smaller radii comes from the heap.
constexpr int kSmallestUnit = -152;
using WideLength = StackInteger<4160>;

template <class Number>
concept AnyInteger = std::is_same_v<Number, WideLength> || std::is_same_v<Number, Integer>;

template <AnyInteger Number>
Sign sign_of_integer(const Number& number) {
  return sign_of(number.sign());
}
template <AnyInteger Number>
std::optional<Sign> sign_if_sure(const Number& number) {
  return sign_of_integer(number);
}

/// The sign of a + b sqrt(p). Requires: p >= 0.
template <AnyInteger Number>
std::optional<Sign> sign_of_sum(const Number& a, const Number& b, const Number& p) {
  const Sign first = sign_of_integer(a);
  const Sign second = p.is_zero() ? Sign::zero : sign_of_integer(b);
  if (second == Sign::zero || first == second) return first;
  if (first == Sign::zero) return second;
  const Sign larger = sign_of_integer(Number{a * a - b * b * p});
  return first == Sign::positive ? larger : -larger;
}

/// The sign of a + b sqrt(p) + c sqrt(q). Requires: p >= 0 and q >= 0. Let S be the sum of the last two terms. If a and
/// S have opposite signs, the larger magnitude decides: a^2 - S^2 = (a^2 - b^2 p - c^2 q) - 2 b c sqrt(p q).
template <AnyInteger Number>
std::optional<Sign> sign_of_sum(const Number& a, const Number& b, const Number& p, const Number& c, const Number& q) {
  const Number bbp = b * b * p;
  const Number ccq = c * c * q;
  const Sign of_b = bbp.is_zero() ? Sign::zero : sign_of_integer(b);
  const Sign of_c = ccq.is_zero() ? Sign::zero : sign_of_integer(c);
  const Sign larger = sign_of_integer(Number{bbp - ccq});
  const Sign of_larger = larger == Sign::negative ? of_c : of_b;
  const Sign rest = larger == Sign::zero && of_b != of_c ? Sign::zero : of_larger;
  const Sign first = sign_of_integer(a);
  if (rest == Sign::zero || first == rest) return first;
  if (first == Sign::zero) return rest;
  const Sign difference = *sign_of_sum(Number{a * a - bbp - ccq}, Number{-2 * b * c}, Number{p * q});
  return first == Sign::positive ? difference : -difference;
}

/// The number as a mantissa times a power of two. Unlike to_dyadic(), the function also accepts subnormal numbers.
Dyadic to_any_dyadic(double value) {
  constexpr int kShift = 200;
  if (value == 0.0 || std::abs(value) >= 0x1p-1000) return to_dyadic(value);
  const Dyadic shifted = to_dyadic(value * power_of_two(kShift));
  return {shifted.mantissa, shifted.exponent - kShift};
}

WideLength to_length(const Dyadic& number, int lattice_exponent, const WideLength* /*type*/) {
  return to_stack_integer<4160>(number, lattice_exponent);
}
Integer to_length(const Dyadic& number, int lattice_exponent, const Integer* /*type*/) {
  return Integer{number.mantissa} << static_cast<unsigned>(number.exponent - lattice_exponent);
}

/// The numbers of a sweep in integers, on the common lattice of the points and the radius.
template <AnyInteger Integers>
class InIntegers {
 public:
  using Number = Integers;

  InIntegers(const Sweep& sweep, int exponent) : exponent_(exponent), radius_(integer(to_any_dyadic(sweep.radius))) {}

  [[nodiscard]] Vector<Number> difference(const Point& p, const Point& q) const {
    return {difference(p.x, q.x), difference(p.y, q.y)};
  }
  [[nodiscard]] const Number& radius() const { return radius_; }
  [[nodiscard]] static Number one() { return Number{1}; }
  [[nodiscard]] int exponent() const { return exponent_; }

 private:
  [[nodiscard]] Number difference(double p, double q) const { return integer(to_dyadic(p)) - integer(to_dyadic(q)); }
  [[nodiscard]] Number integer(const Dyadic& number) const {
    return to_length(number, number.mantissa == 0 ? number.exponent : exponent_, static_cast<const Number*>(nullptr));
  }

  int exponent_;
  Number radius_;
};

/// Calls ask() with the numbers of the sweep in integers. The lattice also contains `points`.
template <class Ask>
auto in_integers(const Sweep& sweep, std::initializer_list<Point> points, const Ask& ask) {
  LatticeExponent lattice;
  lattice.include(sweep.from);
  lattice.include(sweep.to);
  for (const Point& point : points) lattice.include(point);
  const Sweep limited = bounded(sweep);
  const int exponent = std::min(lattice.value(), to_any_dyadic(limited.radius).exponent);
  if (exponent >= kSmallestUnit) return ask(InIntegers<WideLength>(limited, exponent));
  return ask(InIntegers<Integer>(limited, exponent));
}

// The formulas. They take the numbers of a stage. An answer that is not sure is empty.

template <class Numbers>
Root<typename Numbers::Number> root_of(const Numbers& numbers, const Sweep& sweep, const Touch& touch) {
  const auto d = numbers.difference(sweep.to, sweep.from);
  const auto& r = numbers.radius();
  if (touch.kind == Touch::Kind::line) {
    const auto ab = numbers.difference(touch.b, touch.a);
    return {cross(ab, numbers.difference(sweep.from, touch.a)), r, dot(ab, ab), cross(d, ab)};
  }
  const auto q = numbers.difference(touch.a, sweep.from);
  const auto across = cross(d, q);
  const auto squared_length = dot(d, d);
  return {dot(d, q), numbers.one(), squared_length * r * r - across * across, squared_length};
}

using stages::TouchAnswer;

constexpr TouchAnswer kUnsure{};
constexpr TouchAnswer kMissed{true, std::nullopt};

/// Requires: at t = 0, the disc does not touch `v`.
template <class Numbers>
TouchAnswer touch_vertex(const Numbers& numbers, const Sweep& sweep, const Point& v) {
  const auto d = numbers.difference(sweep.to, sweep.from);
  const auto q = numbers.difference(v, sweep.from);
  const auto ahead = dot(d, q);
  const std::optional<Sign> is_ahead = sign_if_sure(ahead);
  if (!is_ahead) return kUnsure;
  if (*is_ahead != Sign::positive) return kMissed;
  const auto across = cross(d, q);
  const auto squared_length = dot(d, d);
  const auto radicand = squared_length * numbers.radius() * numbers.radius() - across * across;
  const std::optional<Sign> meets = sign_if_sure(radicand);
  if (!meets) return kUnsure;
  if (*meets == Sign::negative) return kMissed;
  const TouchAnswer touched{true, Touch{Touch::Kind::vertex, v, v}};
  const std::optional<Sign> passes = sign_if_sure(squared_length - ahead);
  if (passes && *passes != Sign::negative) return touched;
  if (compare_distance(sweep.to, v, v, sweep.radius) <= 0) return touched;
  return passes ? kMissed : kUnsure;
}

/// Requires: at t = 0, the disc does not touch the side, and the centre does not lie right of the line from a to b.
template <class Numbers>
TouchAnswer touch_side(const Numbers& numbers, const Sweep& sweep, const Point& a, const Point& b) {
  const auto d = numbers.difference(sweep.to, sweep.from);
  const auto ab = numbers.difference(b, a);
  const auto from_a = numbers.difference(sweep.from, a);
  const auto squared_length = dot(ab, ab);
  const auto& r = numbers.radius();
  const auto is_outside_strip = [&](const Vector<typename Numbers::Number>& f) {
    return sign_of_sum(cross(ab, f), -r, squared_length);
  };
  const std::optional<Sign> at_start = is_outside_strip(from_a);
  if (!at_start) return kUnsure;
  if (*at_start != Sign::positive) {
    const std::optional<Sign> beyond_a = sign_if_sure(dot(ab, from_a));
    return beyond_a ? touch_vertex(numbers, sweep, *beyond_a == Sign::negative ? a : b) : kUnsure;
  }
  const std::optional<Sign> approaches = sign_if_sure(cross(d, ab));
  const std::optional<Sign> at_end = is_outside_strip(numbers.difference(sweep.to, a));
  if ((approaches && *approaches != Sign::positive) || (at_end && *at_end == Sign::positive)) return kMissed;
  // The position of the centre relative to the two perpendiculars, at the time when the centre enters the strip.
  const auto beyond_perpendicular = [&](const Vector<typename Numbers::Number>& f) {
    return sign_of_sum(-(r * dot(ab, d)), cross(d, f), squared_length);
  };
  const std::optional<Sign> beyond_a = beyond_perpendicular(from_a);
  const std::optional<Sign> beyond_b = beyond_perpendicular(numbers.difference(sweep.from, b));
  if (!approaches || !at_end || !beyond_a || !beyond_b) return kUnsure;
  if (*beyond_a != Sign::positive) return touch_vertex(numbers, sweep, a);
  if (*beyond_b != Sign::negative) return touch_vertex(numbers, sweep, b);
  return {true, Touch{Touch::Kind::line, a, b}};
}

/// Requires: at t = 0, the disc does not touch the side.
template <class Numbers>
TouchAnswer touch_side_ahead(const Numbers& numbers, const Sweep& sweep, const Point& a, const Point& b) {
  const std::optional<Sign> orientation =
      sign_if_sure(cross(numbers.difference(b, a), numbers.difference(sweep.from, a)));
  if (!orientation) return kUnsure;
  return *orientation == Sign::negative ? touch_side(numbers, sweep, b, a) : touch_side(numbers, sweep, a, b);
}

/// Compares two touches. Requires: neither of them is at the start.
template <class Numbers>
std::optional<Sign> compare_roots(const Numbers& numbers, const Sweep& sweep, const Touch& p, const Touch& q) {
  const auto first = root_of(numbers, sweep, p);
  const auto second = root_of(numbers, sweep, q);
  return sign_of_sum(first.n * second.k - second.n * first.k, -(first.m * second.k), first.p, second.m * first.k,
                     second.p);
}

bool is_touched_at_start(const Sweep& sweep, const Point& a, const Point& b) {
  return compare_distance(sweep.from, a, b, sweep.radius) <= 0;
}

/// Returns the order if it does not need the roots.
std::optional<Sign> compare_kinds(const Touch& p, const Touch& q) {
  if (p == q) return Sign::zero;
  const bool is_first_at_start = p.kind == Touch::Kind::start;
  const bool is_second_at_start = q.kind == Touch::Kind::start;
  if (is_first_at_start && is_second_at_start) return Sign::zero;
  if (is_first_at_start) return Sign::negative;
  if (is_second_at_start) return Sign::positive;
  return std::nullopt;
}

// Output

/// A number of the size value * 2^exponent, with a relative error.
struct Scaled {
  double value;
  int exponent;
};

template <AnyInteger Number>
Scaled to_scaled(const Number& number) {
  constexpr int kBits = 53;
  if (number.is_zero()) return {0.0, 0};
  const int bits = static_cast<int>(msb(Number{abs(number)})) + 1;
  const int shift = std::max(bits - kBits, 0);
  const auto mantissa = static_cast<std::int64_t>(Number{abs(number) >> static_cast<unsigned>(shift)});
  return {static_cast<double>(number.sign() * mantissa), shift};
}

Scaled operator*(const Scaled& p, const Scaled& q) { return {p.value * q.value, p.exponent + q.exponent}; }
Scaled operator/(const Scaled& p, const Scaled& q) { return {p.value / q.value, p.exponent - q.exponent}; }

/// Requires: the numbers are not negative and below 2^200 2^exponent.
Scaled operator+(const Scaled& p, const Scaled& q) {
  if (p.value == 0.0) return q;
  if (q.value == 0.0) return p;
  if (p.exponent < q.exponent) return q + p;
  const int shift = p.exponent - q.exponent;
  if (shift > 500) return p;
  return {p.value + q.value * power_of_two(-shift), p.exponent};
}

Scaled square_root(const Scaled& p) {
  const bool is_odd = p.exponent % 2 != 0;
  return {std::sqrt(is_odd ? 2.0 * p.value : p.value), (p.exponent - (is_odd ? 1 : 0)) / 2};
}

double to_double(Scaled number) {
  for (; number.exponent < -900; number.exponent += 900) number.value *= 0x1p-900;
  return number.value * power_of_two(number.exponent);
}

}  // namespace

TouchAnswer stages::first_touch_in_doubles(const Sweep& sweep, const Point& a, const Point& b) {
  if (is_touched_at_start(sweep, a, b)) return {true, Touch{Touch::Kind::start, a, b}};
  return touch_side_ahead(InDoubles(bounded(sweep)), sweep, a, b);
}

std::optional<Touch> stages::first_touch_in_integers(const Sweep& sweep, const Point& a, const Point& b) {
  if (is_touched_at_start(sweep, a, b)) return Touch{Touch::Kind::start, a, b};
  return in_integers(sweep, {a, b}, [&](const auto& numbers) { return touch_side_ahead(numbers, sweep, a, b).touch; });
}

std::optional<Touch> first_touch(const Sweep& sweep, const Point& a, const Point& b) {
  const TouchAnswer answer = stages::first_touch_in_doubles(sweep, a, b);
  if (answer.is_sure) return answer.touch;
  return in_integers(sweep, {a, b}, [&](const auto& numbers) { return touch_side_ahead(numbers, sweep, a, b).touch; });
}

std::optional<Sign> stages::compare_touches_in_doubles(const Sweep& sweep, const Touch& p, const Touch& q) {
  if (const auto sign = compare_kinds(p, q)) return sign;
  return compare_roots(InDoubles(bounded(sweep)), sweep, p, q);
}

Sign stages::compare_touches_in_integers(const Sweep& sweep, const Touch& p, const Touch& q) {
  if (const auto sign = compare_kinds(p, q)) return *sign;
  return in_integers(sweep, {p.a, p.b, q.a, q.b},
                     [&](const auto& numbers) { return *compare_roots(numbers, sweep, p, q); });
}

std::strong_ordering compare_touches(const Sweep& sweep, const Touch& p, const Touch& q) {
  if (const auto sign = stages::compare_touches_in_doubles(sweep, p, q)) return order_of(*sign);
  return order_of(stages::compare_touches_in_integers(sweep, p, q));
}

// The difference n - m sqrt(p) may cancel, so t is computed as (n^2 - m^2 p) / (k (n + m sqrt(p))). In integers, the
// numerator is exact.
Point centre_at(const Sweep& sweep, const Touch& touch) {
  if (touch.kind == Touch::Kind::start) return sweep.from;
  return in_integers(sweep, {touch.a, touch.b}, [&]<class Numbers>(const Numbers& numbers) {
    using Number = typename Numbers::Number;
    const auto [n, m, p, k] = root_of(numbers, sweep, touch);
    const Number numerator = n * n - m * m * p;
    const Scaled denominator = to_scaled(k) * (to_scaled(n) + to_scaled(m) * square_root(to_scaled(p)));
    const Vector<Number> d = numbers.difference(sweep.to, sweep.from);
    const auto at = [&](double from, double to, const Number& along) {
      const Scaled step = to_scaled(Number{numerator * along}) / denominator;
      const double position = from + to_double({step.value, step.exponent + numbers.exponent()});
      return std::clamp(position, std::min(from, to), std::max(from, to));
    };
    return Point{at(sweep.from.x, sweep.to.x, d.x), at(sweep.from.y, sweep.to.y, d.y)};
  });
}

}  // namespace waywright::exact
