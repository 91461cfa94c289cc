#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "clearance/disc.hpp"
#include "exact/point_source.hpp"
#include "exact/rational.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using clearance::Diameter;
using exact::Sign;

/// The vertices w, x, y, right, left: the exact positions, and positions whose coordinates may be wrong by `rounding`.
/// The position of w is exact.
struct Case {
  std::array<Point, 5> exact;
  std::array<Point, 5> rounded;
  double rounding;
};

/// What the doubles decided in the cases.
struct Decided {
  int signs = 0;
  int crossings = 0;  ///< rejected
  int ends = 0;       ///< rejected
};

bool is_acute(const RationalPoint& p, const RationalPoint& v, const RationalPoint& q) {
  return (p.x - v.x) * (q.x - v.x) + (p.y - v.y) * (q.y - v.y) > 0;
}

void check(const Case& at, Decided& decided) {
  const std::array exact{rational(at.exact[0]), rational(at.exact[1]), rational(at.exact[2]), rational(at.exact[3]),
                         rational(at.exact[4])};
  const auto& [w, x, y, p, q] = exact;
  if (rational_orientation(w, x, y) != Sign::positive || rational_orientation(w, p, q) != Sign::positive) return;
  const RationalPoint centre = centre_of_circle(w, x, y);
  const RationalPoint end = {2 * centre.x - w.x, 2 * centre.y - w.y};
  const Diameter::Errors errors(at.rounding);
  const auto vector_to = [&](std::size_t i) { return Diameter::vector(at.rounded[i] - at.rounded[0], errors); };
  const Diameter diameter(vector_to(1), vector_to(2), errors);
  Diameter::Vector right = vector_to(3);
  Diameter::Vector left = vector_to(4);
  diameter.compute_s(right);
  diameter.compute_s(left);
  if (const Sign sign = diameter.sure_side_of(left); sign != Sign::zero) {
    EXPECT_EQ(sign, rational_orientation(w, centre, q));
    ++decided.signs;
  }
  const bool crosses = is_acute(w, p, q) && is_acute(w, q, p);
  if (!Diameter::may_cross(right, left)) {
    EXPECT_FALSE(crosses);
    ++decided.crossings;
  }
  if (!diameter.may_end_beyond(right, left)) {
    EXPECT_NE(rational_orientation(p, q, end), Sign::negative);
    ++decided.ends;
  }
}

class Diameters : public testing::TestWithParam<PointSource::Kind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, Diameters,
                         testing::Values(PointSource::Kind::small_lattice, PointSource::Kind::large_integers,
                                         PointSource::Kind::doubles, PointSource::Kind::mixed_sizes),
                         [](const auto& kind) { return kind_name(kind); });

TEST_P(Diameters, DecideOnlyWhatIsSure) {
  PointSource source(GetParam(), 6);
  Random random(7);
  Decided decided;
  for (int i = 0; i < 6000 && !HasFailure(); ++i) {
    Case at{};
    double extent = 0.0;
    for (Point& point : at.exact) {
      point = source.point();
      extent = std::max({extent, std::abs(point.x), std::abs(point.y)});
    }
    // Near ties: an end of the edge lies near the end of the diameter, or near x.
    if (random.chance(40)) at.exact[4] = at.exact[1] + at.exact[2] - at.exact[0];
    if (random.chance(20)) at.exact[3] = at.exact[1] * (1.0 + 0x1p-50);
    at.rounded = at.exact;
    if (random.chance(50)) {
      at.rounding = extent * std::ldexp(1.0, -static_cast<int>(random.between(10, 50)));
      const auto wrong = [&] { return static_cast<double>(random.between(-1, 1)) * at.rounding * 0.99; };
      for (std::size_t k = 1; k < 5; ++k) at.rounded[k] += Point{wrong(), wrong()};
    }
    check(at, decided);
  }
  EXPECT_GT(decided.signs, 200);
  EXPECT_GT(decided.crossings, 200);
  EXPECT_GT(decided.ends, 100);
}

}  // namespace
}  // namespace waywright::test
