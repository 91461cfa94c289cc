#pragma once

#include <cmath>
#include <deque>
#include <string>

#include <gtest/gtest.h>

#include "exact/crossing.hpp"
#include "exact/position.hpp"
#include "exact/rational.hpp"
#include "support/random.hpp"

namespace waywright::test {

/// Returns random points, explicit and constructed, of several kinds. Stores the crossings that its points refer to.
class PointSource {
 public:
  enum class Kind { small_lattice, large_integers, doubles, mixed_sizes };

  PointSource(Kind kind, std::uint64_t seed) : kind_(kind), random_(seed) {}

  Random& random() { return random_; }

  double coordinate() {
    switch (kind_) {
      case Kind::small_lattice:
        return static_cast<double>(random_.between(-3, 3));
      case Kind::large_integers:
        return static_cast<double>(random_.between(-(1LL << 40), 1LL << 40));
      case Kind::doubles:
        return static_cast<double>(random_.between(-(1LL << 53), 1LL << 53)) * 0x1p-53;
      case Kind::mixed_sizes:
        break;
    }
    const auto mantissa = static_cast<double>(random_.between(-(1LL << 53), 1LL << 53));
    return std::ldexp(mantissa, static_cast<int>(random_.between(-153, 46)));
  }

  Point point() { return {coordinate(), coordinate()}; }

  /// Returns a random point. Half of the points are crossings; many of these have segments that share an end or a line
  /// with an earlier crossing.
  exact::ExactPosition any() {
    if (random_.chance(50)) return exact::explicit_position(point());
    for (;;) {
      exact::Crossing crossing{point(), point(), point(), point()};
      if (!crossings_.empty() && random_.chance(60)) {
        const exact::Crossing& earlier = crossings_[random_.below(crossings_.size())];
        crossing.ab.a = earlier.ab.a;
        crossing.ab.b = random_.chance(50) ? earlier.ab.b : crossing.ab.b;
      }
      if (!in_range(crossing) || is_parallel(crossing)) continue;
      const exact::RoundedCrossing rounded = exact::round_to_nearest(crossing);
      if (rounded.is_exact) return exact::explicit_position(rounded.nearest);
      crossings_.push_back(crossing);
      return {rounded.nearest.x, rounded.nearest.y, &crossings_.back()};
    }
  }

 private:
  static bool in_range(const exact::Crossing& crossing) {
    return is_in_range(crossing.ab.a) && is_in_range(crossing.ab.b) && is_in_range(crossing.cd.a) &&
           is_in_range(crossing.cd.b);
  }
  static bool is_parallel(const exact::Crossing& crossing) {
    const RationalPoint a = rational(crossing.ab.a), b = rational(crossing.ab.b);
    const RationalPoint c = rational(crossing.cd.a), d = rational(crossing.cd.b);
    return (b.x - a.x) * (d.y - c.y) == (b.y - a.y) * (d.x - c.x);
  }

  Kind kind_;
  Random random_;
  std::deque<exact::Crossing> crossings_;
};

/// Returns the name of a kind for the names of tests.
inline std::string kind_name(const testing::TestParamInfo<PointSource::Kind>& kind) {
  switch (kind.param) {
    case PointSource::Kind::small_lattice:
      return "SmallLattice";
    case PointSource::Kind::large_integers:
      return "LargeIntegers";
    case PointSource::Kind::doubles:
      return "Doubles";
    case PointSource::Kind::mixed_sizes:
      return "MixedSizes";
  }
  return "Unknown";
}

}  // namespace waywright::test
