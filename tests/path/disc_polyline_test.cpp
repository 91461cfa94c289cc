#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "support/disc_oracle.hpp"
#include "support/disc_paths.hpp"

namespace waywright::test {
namespace {

using Real = long double;

std::vector<disc::Piece> lines_of(const std::vector<Point>& points) {
  std::vector<disc::Piece> lines;
  for (std::size_t i = 1; i < points.size(); ++i) lines.push_back(disc::Piece::line(points[i - 1], points[i]));
  return lines;
}

/// How far the chord of an arc of the angle `turn` is from the arc.
Real sagitta(Real turn, Real radius) { return radius * 2.0L * std::sin(turn / 4.0L) * std::sin(turn / 4.0L); }

/// Returns the smallest number of chords of an arc, by trying: the largest number with a chord too far from the arc,
/// plus 1. Rounding may decide where both are right.
bool is_smallest(std::size_t count, const PathPiece& arc, Real tolerance) {
  const Real turn = std::fabs(static_cast<Real>(arc.end_angle) - static_cast<Real>(arc.start_angle));
  const auto parts = static_cast<Real>(count);
  return sagitta(turn / parts, arc.radius) <= tolerance * (1.0L + 1e-12L) &&
         (count == 1 || sagitta(turn / (parts - 1.0L), arc.radius) > tolerance * (1.0L - 1e-12L));
}

const PathPiece* only_arc(const Path& path) {
  return path.pieces.size() == 3 && path.pieces[1].kind == PathPiece::Kind::arc ? &path.pieces[1] : nullptr;
}

TEST(DiscPolyline, KeepsTheRadiusWithoutTheTolerance) {
  double worst = 0.0;
  disc::for_each_path([&](const disc::NamedScene& scene, const disc::Walls& walls, const Path& path) {
    const double ulp = 0x1p-52 * std::max(disc::largest_coordinate(scene.domain), path.agent.radius);
    std::vector<Point> points;
    for (const double share : {10.0, 0.5, 0.25, 0.03, 0.001, 1e-5}) {
      path.polyline(path.agent.radius * share, points).value();
      ASSERT_EQ(points.front(), path.pieces.front().from);
      ASSERT_EQ(points.back(), path.pieces.back().to);
      const double tolerance = path.agent.radius * std::min(share, 0.5);
      const disc::PathReport report = disc::check_path(walls, points.front(), points.back(), 0.0, lines_of(points));
      ASSERT_EQ(report.fault, "");
      const double missing = path.agent.radius - tolerance - report.clearance;
      worst = std::max(worst, missing / ulp);
      ASSERT_LE(missing, 8 * ulp) << "tolerance " << tolerance;
      ASSERT_LE(report.length, path.length * (1 + 1e-12) + 100 * ulp);
      for (std::size_t i = 1; i < points.size(); ++i) ASSERT_FALSE(points[i - 1] == points[i]);
      if (share > 0.02) {
        for (const Point& point : points) ASSERT_LE(distance(path.nearest(point).at, point), 8 * ulp);
      }
    }
  });
  RecordProperty("worst", std::to_string(worst) + " ulps");
}

TEST(DiscPolyline, HasAsFewPointsAsTheToleranceAllows) {
  std::size_t arcs = 0;
  disc::for_each_path([&](const disc::NamedScene& scene, const disc::Walls&, const Path& path) {
    const PathPiece* const arc = only_arc(path);
    // Points of a shorter arc may be equal.
    if (arc == nullptr || distance(arc->from, arc->to) < 0x1p-30 * disc::largest_coordinate(scene.domain)) return;
    ++arcs;
    for (const double share : {0.5, 0.25, 0.03, 0.001, 1e-5}) {
      const std::size_t chords = path.polyline(path.agent.radius * share).value().size() - 3;
      ASSERT_TRUE(is_smallest(chords, *arc, static_cast<Real>(path.agent.radius) * share))
          << chords << " for " << share;
    }
    ASSERT_TRUE(is_smallest(path.polyline(1e9 * path.agent.radius).value().size() - 3, *arc, arc->radius * 0.5L));
  });
  EXPECT_GE(arcs, 20U);
}

Path half_circle() {
  Path path;
  path.status = PathStatus::found;
  path.agent.radius = 4;
  path.pieces = {{PathPiece::Kind::arc, {5, 0}, {-3, 0}, {1, 0}, 4, 0, 3.141592653589793}};
  path.length = 4 * 3.141592653589793;
  return path;
}

// A chord over 60 degrees is 4 (1 - cos 30 degrees) = 0.535898... away from the arc.
TEST(DiscPolyline, DividesArcsIntoEqualChords) {
  const std::vector<Point> points = half_circle().polyline(0.53589838486225).value();
  ASSERT_EQ(points.size(), 4U);
  EXPECT_NEAR(points[1].x, 3, 1e-14);
  EXPECT_NEAR(points[1].y, std::sqrt(12.0), 1e-14);
  EXPECT_NEAR(points[2].x, -1, 1e-14);
  EXPECT_EQ(half_circle().polyline(0.53589838486224).value().size(), 5U);
}

TEST(DiscPolyline, RefusesATolerance) {
  const Path path = half_circle();
  std::vector<Point> points{{7, 7}};
  for (const double tolerance : {0.0, -1.0, 3.8e-6, std::nan(""), -std::numeric_limits<double>::infinity()}) {
    const auto refused = path.polyline(tolerance, points);
    ASSERT_FALSE(refused.ok()) << tolerance;
    EXPECT_EQ(refused.error().code, ErrorCode::bad_distance);
    EXPECT_EQ(points.size(), 1U) << "a refused call changes nothing";
  }
  EXPECT_EQ(path.polyline(4 * 0x1p-20).value().size(), 1139U) << "half of 2,275 chords, rounded up";
  EXPECT_EQ(path.polyline(std::numeric_limits<double>::infinity()).value().size(), 3U) << "half the radius";
}

TEST(DiscPolyline, OfAPointAgentIsItsPoints) {
  Path path;
  EXPECT_TRUE(path.polyline(1).value().empty()) << "no path";
  path.points = {{1, 2}, {3, 4}, {5, 4}};
  EXPECT_EQ(path.polyline(0).value(), path.points);
  EXPECT_EQ(path.polyline(1).value(), path.points);
  EXPECT_FALSE(path.polyline(-1).ok());
}

}  // namespace
}  // namespace waywright::test
