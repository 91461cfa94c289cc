#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <gmpxx.h>
#include <limits>
#include <utility>

#include "exact/geometry.hpp"
#include "random.hpp"
#include "thesis/double_arithmetic.hpp"
#include "thesis/interval_arithmetic.hpp"
#include "thesis/rational_arithmetic.hpp"
#include "thesis/tables.hpp"

namespace waywright::bench {
namespace {

using exact::Sign;

constexpr std::int64_t kLargest = 100;  // numerators and denominators are 1 to kLargest
constexpr int kSmallestMove = 17;       // moves are 10^-1 to 10^-17

struct Fraction {
  std::int64_t over;
  std::int64_t under;

  [[nodiscard]] mpq_class rational() const {
    mpq_class value(over, under);
    value.canonicalize();
    return value;
  }
};

Fraction random_fraction(Random& random) {
  const auto part = [&] { return 1 + static_cast<std::int64_t>(random.below(kLargest)); };
  const std::int64_t over = part();
  return {over, part()};
}

__int128 power_of_ten(int exponent) {
  __int128 power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

/// A rectangle, one corner of which moves along a side by 10^-exponent in either direction.
class MovedRectangle {
 public:
  MovedRectangle(Random& random, int exponent) : exponent_(exponent), grows_(random.below(2) == 0) {
    do {
      x1_ = random_fraction(random);
      x2_ = random_fraction(random);
    } while (width_sign() == 0);
    do {
      y1_ = random_fraction(random);
      y2_ = random_fraction(random);
    } while (height_sign() == 0);
    rotation_ = random.below(4);
  }

  /// Returns the corners in counter-clockwise or clockwise order, starting with any of them.
  [[nodiscard]] std::array<RationalPoint, 4> corners() const {
    const mpq_class x1 = x1_.rational();
    const mpq_class x2 = x2_.rational();
    const mpq_class y1 = y1_.rational();
    const mpq_class y2 = y2_.rational();
    mpq_class move(1);
    mpz_ui_pow_ui(move.get_den_mpz_t(), 10, static_cast<unsigned long>(exponent_));
    const mpq_class moved = grows_ ? mpq_class(x2 + move) : mpq_class(x2 - move);
    const std::array<RationalPoint, 4> around = {{{x1, y2}, {x1, y1}, {x2, y1}, {moved, y2}}};
    std::array<RationalPoint, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = around[(i + rotation_) % 4];
    return corners;
  }

  /// Returns the correct result of the in-circle test, by Thales' theorem: two of the three other corners are the ends
  /// of a diameter, and the moved corner lies inside the circle if it sees that diameter under an obtuse angle. Each
  /// rotation of the four corners by one position changes the sign.
  [[nodiscard]] Sign in_circle() const {
    const int seen = move_sign() * moved_width_sign();
    const int inside = seen < 0 ? 1 : seen > 0 ? -1 : 0;
    const int turns = rotation_ % 2 == 0 ? 1 : -1;
    return exact::sign_of(inside * width_sign() * height_sign() * turns);
  }

 private:
  static int sign(__int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }
  static int difference_sign(const Fraction& p, const Fraction& q) { return sign(p.over * q.under - q.over * p.under); }
  [[nodiscard]] int width_sign() const { return difference_sign(x2_, x1_); }
  [[nodiscard]] int height_sign() const { return difference_sign(y2_, y1_); }
  [[nodiscard]] int move_sign() const { return grows_ ? 1 : -1; }
  /// Returns the sign of x2 - x1 plus the move, over their common denominator: numbers below 2^84.
  [[nodiscard]] int moved_width_sign() const {
    const __int128 width = x2_.over * x1_.under - x1_.over * x2_.under;
    return sign(width * power_of_ten(exponent_) + move_sign() * __int128{x1_.under * x2_.under});
  }

  int exponent_;
  bool grows_;
  Fraction x1_{}, x2_{}, y1_{}, y2_{};
  std::size_t rotation_ = 0;
};

/// Returns the nearest double; GMP's conversion only truncates.
double nearest(const mpq_class& number) {
  const double cut = number.get_d();
  if (cmp(number, mpq_class(cut)) == 0) return cut;
  const double beyond = std::nextafter(cut, sgn(number) * std::numeric_limits<double>::infinity());
  return abs(number - mpq_class(cut)) <= abs(mpq_class(beyond) - number) ? cut : beyond;
}

template <class Arithmetic, class Points>
Sign ask(const Points& points, const Arithmetic& arithmetic) {
  return arithmetic.in_circle(arithmetic.view(points[0]), arithmetic.view(points[1]), arithmetic.view(points[2]),
                              arithmetic.view(points[3]));
}

struct Wrong {
  std::size_t double_of_rationals = 0;
  std::size_t double_of_doubles = 0;
  std::size_t intervals = 0;
  std::size_t ours_of_rationals = 0;
  std::size_t ours_of_doubles = 0;
};

void try_once(const MovedRectangle& rectangle, Wrong& wrong) {
  const std::array<RationalPoint, 4> corners = rectangle.corners();
  std::array<Point, 4> rounded;
  std::array<IntervalArithmetic::Position, 4> positions;
  for (std::size_t i = 0; i < 4; ++i) {
    rounded[i] = {nearest(corners[i].x), nearest(corners[i].y)};
    positions[i] = IntervalArithmetic::at(corners[i]);
  }
  const Sign of_rationals = rectangle.in_circle();
  const Sign of_doubles = ask(rounded, RationalArithmetic());
  const Sign by_double = ask(rounded, DoubleArithmetic());
  const Sign by_intervals = ask(positions, IntervalArithmetic());
  const Sign by_us = ask(rounded, exact::Geometry(Box{{-101.0, -101.0}, {101.0, 101.0}}));
  wrong.double_of_rationals += by_double != of_rationals ? 1 : 0;
  wrong.double_of_doubles += by_double != of_doubles ? 1 : 0;
  wrong.intervals += by_intervals != of_rationals ? 1 : 0;
  wrong.ours_of_rationals += by_us != of_rationals ? 1 : 0;
  wrong.ours_of_doubles += by_us != of_doubles ? 1 : 0;
}

}  // namespace

void print_in_circle_table(std::size_t trials) {
  std::printf(
      "| moved by | double, wrong for the fractions | double, wrong for the doubles | "
      "interval + exact, wrong for the fractions | Waywright, wrong for the fractions | "
      "Waywright, wrong for the doubles |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: |\n");
  const auto percent = [&](std::size_t count) {
    return 100.0 * static_cast<double>(count) / static_cast<double>(trials);
  };
  for (int exponent = 1; exponent <= kSmallestMove; ++exponent) {
    Random random(static_cast<std::uint64_t>(exponent));
    Wrong wrong;
    for (std::size_t trial = 0; trial < trials; ++trial) try_once(MovedRectangle(random, exponent), wrong);
    std::printf("| 10^-%d | %.4f %% | %.4f %% | %.4f %% | %.4f %% | %.4f %% |\n", exponent,
                percent(wrong.double_of_rationals), percent(wrong.double_of_doubles), percent(wrong.intervals),
                percent(wrong.ours_of_rationals), percent(wrong.ours_of_doubles));
    std::fflush(stdout);
  }
}

}  // namespace waywright::bench
