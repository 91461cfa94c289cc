#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "path/pieces.hpp"
#include "support/case_count.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_paths.hpp"
#include "support/disc_scenes.hpp"

namespace waywright::test {
namespace {

using Real = long double;

constexpr Real kPi = 3.14159265358979323846264338327950288L;

struct Vector {
  Real x = 0.0L;
  Real y = 0.0L;
};

Real length_of(Vector v) { return std::hypot(v.x, v.y); }
Vector between(Point a, Point b) {
  return {static_cast<Real>(b.x) - static_cast<Real>(a.x), static_cast<Real>(b.y) - static_cast<Real>(a.y)};
}

/// A straight line, an arc of the angle `turn` (positive: to the left) and another straight line that touches it.
struct Bend {
  Point centre;
  double radius = 0.0;
  double start = 0.0;
  double turn = 0.0;
  double line = 0.0;  ///< the length of each line

  [[nodiscard]] Real sign() const { return turn > 0.0 ? 1.0L : -1.0L; }
  [[nodiscard]] Real arc_length() const { return std::fabs(static_cast<Real>(turn)) * radius; }
  [[nodiscard]] Real length() const { return 2.0L * line + arc_length(); }

  [[nodiscard]] Vector heading(Real distance) const {
    const Real turned = std::clamp(distance - line, 0.0L, arc_length()) / radius;
    const Real angle = start + sign() * (turned + kPi / 2.0L);
    return {std::cos(angle), std::sin(angle)};
  }
  [[nodiscard]] Vector at(Real distance) const {
    const Real turned = std::clamp(distance - line, 0.0L, arc_length()) / radius;
    const Real angle = start + sign() * turned;
    const Real ahead = distance < line ? distance - line : std::max(distance - line - arc_length(), 0.0L);
    const Vector along = heading(distance);
    return {centre.x + radius * std::cos(angle) + ahead * along.x,
            centre.y + radius * std::sin(angle) + ahead * along.y};
  }
  [[nodiscard]] Point point_at(Real distance) const {
    const Vector v = at(distance);
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
  }
  /// The largest coordinate, for the size of rounding errors.
  [[nodiscard]] Real size() const { return std::max(std::fabs(centre.x), std::fabs(centre.y)) + radius + line; }

  [[nodiscard]] Path path() const {
    const Point arrive = point_at(line);
    const Point leave = point_at(line + arc_length());
    Path path;
    path.status = PathStatus::found;
    path.agent.radius = radius;
    path.pieces = {{PathPiece::Kind::line, point_at(0), arrive, {}, 0.0, 0.0, 0.0},
                   {PathPiece::Kind::arc, arrive, leave, centre, radius, start, start + turn},
                   {PathPiece::Kind::line, leave, point_at(length()), {}, 0.0, 0.0, 0.0}};
    path.length = static_cast<double>(length());
    return path;
  }
};

double fraction(Random& random) { return static_cast<double>(random.between(0, std::int64_t{1} << 40)) * 0x1p-40; }

Bend random_bend(Random& random) {
  Bend bend;
  bend.radius = std::pow(10.0, 12.0 * fraction(random) - 6.0);
  const double far = bend.radius * std::pow(10.0, 4.0 * fraction(random) - 2.0);
  bend.centre = {far * (2.0 * fraction(random) - 1.0), far * (2.0 * fraction(random) - 1.0)};
  bend.start = (2.0 * fraction(random) - 1.0) * 3.14159;
  const double turn = random.chance(70) ? 0.001 + 6.28 * fraction(random) : std::pow(10.0, -9.0 * fraction(random));
  bend.turn = random.chance(50) ? turn : -turn;
  bend.line = bend.radius * (0.001 + 3.0 * fraction(random));
  // The angle of the end of the arc is a double, too.
  bend.turn = (bend.start + bend.turn) - bend.start;
  return bend;
}

std::string text(const Bend& bend) {
  return "arc around " + to_string(bend.centre) + " of radius " + std::to_string(bend.radius) + " from " +
         std::to_string(bend.start) + " by " + std::to_string(bend.turn);
}

class DiscPathPosition : public testing::Test {
 protected:
  void for_each_bend(const std::function<void(const Bend&, const Path&)>& check) {
    for (std::uint64_t i = 0; i < 4 * case_count(); ++i) {
      const Bend bend = random_bend(random_);
      SCOPED_TRACE(text(bend));
      check(bend, bend.path());
      if (HasFailure()) return;
    }
  }

  Random random_{17};
};

TEST_F(DiscPathPosition, LiesOnLinesAndArcs) {
  for_each_bend([&](const Bend& bend, const Path& path) {
    for (int i = 0; i <= 200; ++i) {
      const double distance = path.length * (i / 200.0);
      const PathPosition position = path.at(distance);
      const Vector exact = bend.at(distance);
      const Real error = std::hypot(position.at.x - exact.x, position.at.y - exact.y);
      ASSERT_LT(error, 0x1p-50L * (bend.size() + bend.length())) << distance;
      const Vector heading = bend.heading(distance);
      ASSERT_LT(std::hypot(position.heading.x - heading.x, position.heading.y - heading.y),
                0x1p-49L * (1.0L + bend.size() / bend.radius))
          << distance;
    }
    ASSERT_EQ(path.at(0).at, path.pieces.front().from);
    ASSERT_EQ(path.at(2 * path.length).at, path.pieces.back().to);
    ASSERT_EQ(path.at(-1).at, path.pieces.front().from);
    ASSERT_EQ(path.at(std::nan("")).at, path.pieces.front().from);
  });
}

// Around (0, 0), so that no coordinate of the centre adds a rounding error. Turns of up to 360 degrees end at angles of
// up to 540 degrees.
TEST(DiscPathPositions, OnArcsAreExactTo15Digits) {
  Random random(19);
  Real worst = 0.0L;
  for (std::uint64_t i = 0; i < 2000 * case_count(); ++i) {
    const double start = (2.0 * fraction(random) - 1.0) * 3.141592653589793;
    const double turn = (2.0 * fraction(random) - 1.0) * 6.283185307179586;
    const double radius = std::pow(10.0, 12.0 * fraction(random) - 6.0);
    const PathPiece arc{PathPiece::Kind::arc, {}, {}, {}, radius, start, start + turn};
    const double along = path::length_of(arc) * (0.001 + 0.998 * fraction(random));
    const Point at = path::position_at(arc, along);
    const Real angle = start + (turn > 0.0 ? 1.0L : -1.0L) * along / radius;
    worst = std::max(worst, std::hypot(at.x - radius * std::cos(angle), at.y - radius * std::sin(angle)) / radius);
  }
  EXPECT_LT(worst, 1e-15L);
  RecordProperty("worst", std::to_string(worst * 0x1p53L) + " * 2^-53 of the radius");
}

// Positions at equal distances: the sum of their chords, by two step lengths, gives the length of the curve.
TEST_F(DiscPathPosition, ItsDistanceIsTheLengthOfTheCurve) {
  for_each_bend([&](const Bend& bend, const Path& path) {
    const double end = bend.line + static_cast<double>(bend.arc_length()) * fraction(random_);
    if (end - bend.line < 1e-3 * bend.radius) return;
    const auto chords = [&](int count) {
      Real sum = length_of(between(path.at(0).at, path.at(bend.line).at));
      for (int i = 1; i <= count; ++i) {
        const auto at = [&](int k) { return path.at(bend.line + (end - bend.line) * k / count).at; };
        sum += length_of(between(at(i - 1), at(i)));
      }
      return sum;
    };
    const Real fine = chords(400);
    const Real length = fine + (fine - chords(200)) / 3.0L;
    ASSERT_NEAR(static_cast<double>(length / path.at(end).distance), 1.0, 1e-9);
  });
}

// Simpson's rule, whose error is step^5 / (2880 radius^4).
TEST_F(DiscPathPosition, ItsHeadingIsTheDerivative) {
  for_each_bend([&](const Bend& bend, const Path& path) {
    const double step = bend.radius / 64;
    for (int i = 0; i < 50; ++i) {
      const double distance = (path.length - step) * fraction(random_);
      const PathPosition a = path.at(distance);
      const PathPosition middle = path.at(distance + step / 2);
      const PathPosition b = path.at(distance + step);
      ASSERT_NEAR(length(middle.heading), 1.0, 0x1p-50);
      if (a.segment != b.segment) continue;
      const Point integral = (step / 6) * (a.heading + 4 * middle.heading + b.heading);
      const Vector moved = between(a.at, b.at);
      const Real error = std::hypot(moved.x - integral.x, moved.y - integral.y);
      ASSERT_LT(error, 3e-11L * step + 0x1p-48L * bend.size());
    }
  });
}

TEST_F(DiscPathPosition, AdvancesAsFarAsAUnitGoes) {
  for_each_bend([&](const Bend& bend, const Path& path) {
    const double step = path.length * (0.001 + 0.3 * fraction(random_));
    PathPosition position = path.at(0);
    for (int i = 1; i < 20; ++i) {
      position = path.advance(position, random_.chance(80) ? step : -step);
      const PathPosition same = path.at(position.distance);
      ASSERT_LT(distance(position.at, same.at), 0x1p-48 * static_cast<double>(bend.size()));
      ASSERT_EQ(position.before, same.before);
      ASSERT_EQ(position.segment, same.segment);
    }
  });
}

TEST_F(DiscPathPosition, IsNearestToAPoint) {
  for_each_bend([&](const Bend& bend, const Path& path) {
    constexpr int kSamples = 2000;
    std::vector<Point> samples;
    for (int i = 0; i <= kSamples; ++i) samples.push_back(path.at(path.length * i / kSamples).at);
    for (int k = 0; k < 10; ++k) {
      const double reach = 3 * (bend.radius + bend.line) * fraction(random_);
      const double angle = 7 * fraction(random_);
      const Point point = bend.centre + reach * Point{std::cos(angle), std::sin(angle)};
      Real least = 1e300L;
      for (const Point& sample : samples) least = std::min(least, length_of(between(point, sample)));
      const PathPosition nearest = path.nearest(point);
      const Real found = length_of(between(point, nearest.at));
      const Real rounding = 0x1p-48L * (bend.size() + reach);
      ASSERT_LE(found, least + rounding);
      ASSERT_GE(found, least - path.length / kSamples);
      ASSERT_LT(distance(path.at(nearest.distance).at, nearest.at), rounding);
    }
  });
}

TEST(DiscPathPositions, OfEquallyNearPositionsTheFirstIsNearest) {
  const Bend half{{3, 4}, 2, 0, static_cast<double>(kPi), 5};
  const Path path = half.path();
  EXPECT_EQ(path.nearest({3, 4}).distance, 5);
  EXPECT_EQ(path.nearest({3, -100}).distance, 0);
  const PathPosition top = path.nearest({3, 100});
  EXPECT_NEAR(top.at.x, 3, 1e-15);
  EXPECT_NEAR(top.at.y, 6, 1e-15);
  EXPECT_EQ(top.segment, 1U);
  EXPECT_EQ(top.before, 5);
}

TEST(DiscPathPositions, FitIntoFloatIfAsked) {
  const Bend bend{{0.1, 0.2}, 0.3, 0.4, -2.5, 0.7};
  const Path path = bend.path();
  for (int i = 0; i <= 50; ++i) {
    const double distance = path.length * i / 50;
    const PathPosition position = path.at(distance, Precision::float32);
    EXPECT_EQ(static_cast<double>(static_cast<float>(position.at.x)), position.at.x);
    EXPECT_EQ(static_cast<double>(static_cast<float>(position.at.y)), position.at.y);
    EXPECT_LT(waywright::distance(position.at, path.at(distance).at), 1e-7);
    const PathPosition nearest = path.nearest({0, 0}, Precision::float32);
    EXPECT_EQ(static_cast<double>(static_cast<float>(nearest.at.x)), nearest.at.x);
  }
}

// A line so short that the difference of its ends says nothing of its direction.
TEST(DiscPathPositions, AShortLineHasTheHeadingOfItsArcs) {
  const double end = 1.0;
  const Point joint{std::cos(end) * 2 + 1000, std::sin(end) * 2 + 1000};
  const Point other = joint + Point{0x1p-43, 0};
  Path path;
  path.status = PathStatus::found;
  path.agent.radius = 2;
  path.pieces = {{PathPiece::Kind::arc, {1002, 1000}, joint, {1000, 1000}, 2, 0, end},
                 {PathPiece::Kind::line, joint, other, {}, 0, 0, 0},
                 {PathPiece::Kind::arc, other, {0, 0}, {0, 0}, 2, end + 3.14159265358979, end - 1}};
  const Point heading = path.at(2 + 0x1p-44).heading;
  EXPECT_NEAR(heading.x, -std::sin(end), 1e-14);
  EXPECT_NEAR(heading.y, std::cos(end), 1e-14);
}

TEST(DiscPathPositions, KeepTheRadiusFromAllWalls) {
  double worst = 0.0;
  disc::for_each_path([&](const disc::NamedScene& scene, const disc::Walls& walls, const Path& path) {
    const double ulp = 0x1p-52 * std::max(disc::largest_coordinate(scene.domain), path.agent.radius);
    for (int i = 0; i <= 40; ++i) {
      const PathPosition position = path.at(path.length * i / 40);
      const double missing = path.agent.radius - disc::check_path(walls, position.at, position.at, 0.0, {}).clearance;
      worst = std::max(worst, missing / ulp);
      ASSERT_LE(missing, 8 * ulp) << "at " << position.distance;
    }
  });
  testing::Test::RecordProperty("worst", std::to_string(worst) + " ulps");
}

TEST(DiscPathPositions, ReachTheGoalInSteps) {
  disc::for_each_path([&](const disc::NamedScene& scene, const disc::Walls&, const Path& path) {
    const std::pair ends{path.at(0).at, path.at(path.length).at};
    ASSERT_GE(std::count(scene.queries.begin(), scene.queries.end(), ends), 1);
    for (std::size_t i = 1; i < path.pieces.size(); ++i) ASSERT_EQ(path.pieces[i - 1].to, path.pieces[i].from);
    PathPosition position = path.at(0);
    int steps = 0;
    for (; position.distance < path.length && steps < 100; ++steps) position = path.advance(position, path.length / 37);
    ASSERT_EQ(position.at, path.pieces.back().to);
    ASSERT_EQ(position.distance, path.length);
    ASSERT_NEAR(steps, path.length > 0.0 ? 37 : 0, 1);
    ASSERT_EQ(path.at(path.length).distance, path.length);
  });
}

// A line has the direction of an arc next to it. Its own ends give the same direction, as far as they are exact.
TEST(DiscPathPositions, HaveNoJumpInTheirHeading) {
  double worst = 0.0;
  double worst_line = 0.0;
  disc::for_each_path([&](const disc::NamedScene& scene, const disc::Walls&, const Path& path) {
    const double ulp = 0x1p-52 * std::max(disc::largest_coordinate(scene.domain), path.agent.radius);
    for (std::size_t i = 0; i < path.pieces.size(); ++i) {
      const PathPiece& piece = path.pieces[i];
      const double length = path::length_of(piece);
      const Point end = path::heading_at(path.pieces, i, length);
      if (i + 1 < path.pieces.size()) {
        const double jump = distance(end, path::heading_at(path.pieces, i + 1, 0.0));
        worst = std::max(worst, jump);
        ASSERT_LT(jump, 0x1p-48) << "behind piece " << i;
      }
      if (piece.kind != PathPiece::Kind::line || length == 0.0) continue;
      const double error = distance(end, (piece.to - piece.from) / length) / (ulp / length + 0x1p-52);
      worst_line = std::max(worst_line, error);
      ASSERT_LT(error, 16) << "on piece " << i;
    }
  });
  testing::Test::RecordProperty("worst", std::to_string(worst * 0x1p53) + " * 2^-53");
  testing::Test::RecordProperty("worst line", std::to_string(worst_line) + " ulps");
}

TEST(DiscPathPositions, OfAPathWithoutLengthAreItsPoint) {
  const World world = World::create({{0, 0}, {10, 10}}, {.keep_bridges = true}).value();
  const Path path =
      world.find_path({.start = {4, 5}, .goal = {4, 5}, .agent = {.radius = 1}, .wants_time = true}).value();
  for (const PathPosition& position : {path.at(0), path.at(3), path.nearest({8, 8}), path.advance(path.at(0), 1)}) {
    EXPECT_EQ(position.at, (Point{4, 5}));
    EXPECT_EQ(position.heading, (Point{0, 0}));
    EXPECT_EQ(position.distance, 0);
  }
  EXPECT_EQ(path.polyline(0.1).value(), (std::vector<Point>{{4, 5}}));
  EXPECT_EQ(path.agent.radius, 1);
}

}  // namespace
}  // namespace waywright::test
