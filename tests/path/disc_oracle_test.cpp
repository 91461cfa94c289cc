#include "support/disc_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/case_count.hpp"
#include "support/disc_scenes.hpp"
#include "support/random.hpp"

namespace waywright::test::disc {
namespace {

constexpr double kPi = 3.14159265358979323846;

double above(double value) { return std::nextafter(value, std::numeric_limits<double>::infinity()); }

Walls chain(const std::vector<Point>& points) {
  Walls walls;
  for (std::size_t i = 1; i < points.size(); ++i) walls.segments.emplace_back(points[i - 1], points[i]);
  return walls;
}

Walls operator+(Walls a, const Walls& b) {
  a.segments.insert(a.segments.end(), b.segments.begin(), b.segments.end());
  return a;
}

Walls box(Point min, Point max) { return chain({min, {max.x, min.y}, max, {min.x, max.y}, min}); }

bool has_bridge(const std::vector<Bridge>& bridges, const RationalPoint& p, const RationalPoint& q) {
  return std::any_of(bridges.begin(), bridges.end(), [&](const Bridge& bridge) {
    return (bridge.from == p && bridge.to == q) || (bridge.from == q && bridge.to == p);
  });
}

// Bridges

TEST(DiscBridges, GoFromEndsToFeet) {
  // The segment from (0, 4) to (3, 2) is longer than the distance 3 of the walls, so its disc meets both.
  const std::vector<Bridge> found = bridges(chain({{0, 0}, {0, 4}}) + chain({{3, 2}, {3, 6}}));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].from, (RationalPoint{0, 4}));
  EXPECT_EQ(found[0].to, (RationalPoint{3, 4}));
  EXPECT_EQ(found[0].squared_length, 9);
  EXPECT_EQ(found[0].from_end, 1U);
  EXPECT_TRUE(found[0].is_foot);
  EXPECT_EQ(found[0].to_end, 1U);
  EXPECT_EQ(found[1].from, (RationalPoint{3, 2}));
  EXPECT_EQ(found[1].to, (RationalPoint{0, 2}));
  EXPECT_EQ(found[1].from_end, 2U);
  EXPECT_EQ(found[1].to_end, 0U);
}

TEST(DiscBridges, GoBetweenEnds) {
  const std::vector<Bridge> found = bridges(chain({{0, 0}, {-1, 0}}) + chain({{3, 4}, {5, 4}}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].squared_length, 25);
  EXPECT_FALSE(found[0].is_foot);
  EXPECT_EQ(found[0].from_end, 0U);
  EXPECT_EQ(found[0].to_end, 2U);
}

TEST(DiscBridges, HaveRationalFeet) {
  // The foot of (0, 1) on the line through (0, 0) and (2, 1) is (0.4, 0.2).
  const std::vector<Bridge> found = bridges(chain({{-2, -1}, {2, 1}}) + chain({{0, 1}, {-2, 5}}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].to, (RationalPoint{Rational(2, 5), Rational(1, 5)}));
  EXPECT_EQ(found[0].squared_length, Rational(4, 5));
}

TEST(DiscBridges, NameEachSegmentOnce) {
  // Repeated and overlapping walls, a wall of length zero in a disc, an end of a wall at a foot.
  const Walls walls = chain({{0, 0}, {8, 0}}) + chain({{2, 0}, {6, 0}}) + chain({{8, 0}, {0, 0}}) +
                      chain({{4, 2}, {4, 5}}) + chain({{4, 5}, {4, 2}}) + chain({{4, 1}, {4, 1}});
  const std::vector<Bridge> one = bridges(walls);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_TRUE(one[0].is_foot);
  EXPECT_EQ(one[0].from_end, 6U);
  EXPECT_EQ(one[0].to_end, 0U);
  const std::vector<Bridge> other = bridges(walls + chain({{4, 0}, {4, -3}}));
  ASSERT_EQ(other.size(), 1U);
  EXPECT_FALSE(other[0].is_foot);
  EXPECT_EQ(other[0].from_end, 6U);
  EXPECT_EQ(other[0].to_end, 12U);
}

TEST(DiscBridges, DoNotEndAtCrossings) {
  const Walls walls =
      chain({{0, 3}, {12, 3}}) + chain({{0, 9}, {12, 9}}) + chain({{3, 0}, {3, 12}}) + chain({{9, 0}, {9, 12}});
  const std::vector<Bridge> found = bridges(walls);
  EXPECT_EQ(found.size(), 4U) << "the disc from (0, 3) to (3, 0) meets walls; a disc can always leave this corner";
  EXPECT_TRUE(has_bridge(found, {3, 0}, {9, 0}));
  for (const Bridge& bridge : found) EXPECT_EQ(bridge.squared_length, 36);
  // No bridge is in the room in the middle, and none is needed: a disc that fits there cannot leave.
  const Connectivity connectivity(walls);
  EXPECT_TRUE(connectivity.connected({6, 6}, {6.5, 5.5}, 2.5));
  EXPECT_FALSE(connectivity.connected({6, 6}, {6, 20}, 0.001));
}

TEST(DiscBridges, MayCross) {
  const Walls walls = chain({{7, 0}, {7, 6}}) + chain({{13, 0}, {13, 6}}) + chain({{7, 20}, {7, 14}}) +
                      chain({{13, 20}, {13, 14}}) + box({-10, 0}, {30, 20});
  const Connectivity connectivity(walls);
  EXPECT_TRUE(has_bridge(connectivity.bridges(), {7, 6}, {13, 14}));
  EXPECT_TRUE(has_bridge(connectivity.bridges(), {7, 14}, {13, 6}));
  EXPECT_EQ(connectivity.widest({3, 10}, {17, 10})->squared_diameter, 64);
  EXPECT_EQ(connectivity.widest({10, 1}, {17, 10})->squared_diameter, 36);
  EXPECT_EQ(connectivity.widest({10, 1}, {10, 10})->squared_diameter, 36) << "the goal is where the diagonals cross";
  EXPECT_TRUE(connectivity.connected({3, 10}, {17, 10}, 4));
  EXPECT_FALSE(connectivity.connected({3, 10}, {17, 10}, above(4)));
  EXPECT_TRUE(connectivity.fits({10, 10}, 5)) << "all four ends are 5 away";
  EXPECT_TRUE(connectivity.connected({10, 10}, {10, 10}, 5));
  EXPECT_FALSE(connectivity.fits({10, 10}, above(5)));
}

// Connectivity

TEST(DiscConnectivity, FreePositionsAreExact) {
  const Walls walls = chain({{0, 0}, {4, 3}});
  EXPECT_TRUE(fits(walls, {-3, 4}, 5)) << "the nearest point is the end";
  EXPECT_TRUE(fits(walls, {-1, 5.5}, 5)) << "the nearest point is inside the wall";
  EXPECT_FALSE(fits(walls, {-1, 5.5}, above(5)));
  EXPECT_FALSE(fits(walls, {2, 1.5}, 1e-300));
  EXPECT_TRUE(fits(walls + chain({{9, 9}, {9, 9}}), {9, 9}, 1)) << "a wall of length zero";
  EXPECT_TRUE(fits({}, {9, 9}, 1));
}

TEST(DiscConnectivity, DependsOnTheGapsOfALongAlley) {
  const Walls walls =
      chain({{-10, 0}, {10, 0}}) + chain({{0, 0.12}, {0, 5}}) + chain({{9, 0.1}, {9, 5}}) + box({-10, -5}, {10, 5});
  const Connectivity connectivity(walls);
  EXPECT_EQ(connectivity.widest({-5, 2}, {4, 2})->squared_diameter, Rational(0.12) * Rational(0.12));
  EXPECT_EQ(connectivity.widest({-5, 2}, {9.5, 0.5})->squared_diameter, Rational(0.1) * Rational(0.1));
  EXPECT_TRUE(connectivity.connected({-5, 2}, {4, 2}, 0.055));
  EXPECT_FALSE(connectivity.connected({-5, 2}, {9.5, 0.5}, 0.055));
  EXPECT_TRUE(connectivity.connected({-5, 2}, {9.5, 0.5}, 0.05));
  EXPECT_FALSE(connectivity.connected({-5, 2}, {9.5, 0.5}, above(0.05)));
  EXPECT_EQ(connectivity.widest({-5, 2}, {4, -2}), std::nullopt);
  EXPECT_FALSE(connectivity.connected({-5, 2}, {4, -2}, 1e-9));
}

TEST(DiscConnectivity, HasNoTolerance) {
  for (const double scale : {1.0, 0.1, 1e12, 1e-9}) {
    const Point p{10 * scale, 9 * scale};
    const Point q{10 * scale, 11 * scale};
    const Walls walls = chain({{p.x, 0}, p}) + chain({q, {q.x, 20 * scale}}) + box({0, 0}, {20 * scale, 20 * scale});
    const double r = (q.y - p.y) / 2;  // the subtraction is exact
    EXPECT_TRUE(connected(walls, {5 * scale, 10 * scale}, {15 * scale, 10 * scale}, r)) << scale;
    EXPECT_FALSE(connected(walls, {5 * scale, 10 * scale}, {15 * scale, 10 * scale}, above(r))) << scale;
  }
}

TEST(DiscConnectivity, OfARoomThatTheDiscFills) {
  const Walls open = chain({{2, 0}, {0, 0}, {0, 2}, {2, 2}});
  EXPECT_TRUE(connected(open, {1, 1}, {8, 1}, 1));
  EXPECT_FALSE(connected(open, {1, 1}, {8, 1}, above(1)));
  const Walls narrow = open + chain({{2, 2}, {2, 1.5}});
  EXPECT_EQ(widest_squared_diameter(narrow, {1, 1}, {8, 1})->squared_diameter, Rational(9, 4));
  EXPECT_TRUE(connected(narrow, {1, 1}, {1, 1}, 1));
  EXPECT_FALSE(connected(narrow, {1, 1}, {8, 1}, 1));
}

TEST(DiscConnectivity, IsNotLimitedWithinACell) {
  const Walls walls = box({0, 0}, {10, 10});
  const auto widest = widest_squared_diameter(walls, {1, 1}, {9, 9});
  ASSERT_TRUE(widest);
  EXPECT_FALSE(widest->is_limited);
  EXPECT_EQ(widest_squared_diameter(walls, {1, 1}, {0, 9}), std::nullopt) << "on a wall";
  EXPECT_EQ(widest_squared_diameter(walls, {1, 1}, {11, 9}), std::nullopt);
  EXPECT_FALSE(widest_squared_diameter(walls, {11, 1}, {11, 9})->is_limited);
  EXPECT_FALSE(widest_squared_diameter({}, {11, 1}, {11, 9})->is_limited);
}

TEST(DiscConnectivity, APositionOnABridgeBelongsToBothCells) {
  const Walls walls = chain({{5, 0}, {5, 4}}) + chain({{5, 6}, {5, 10}}) + box({0, 0}, {10, 10});
  EXPECT_FALSE(widest_squared_diameter(walls, {5, 5}, {1, 5})->is_limited);
  EXPECT_FALSE(widest_squared_diameter(walls, {9, 5}, {5, 5.5})->is_limited);
  EXPECT_EQ(widest_squared_diameter(walls, {9, 9}, {1, 1})->squared_diameter, 4);
  EXPECT_EQ(widest_squared_diameter(walls, {5, 5}, {1, 1})->squared_diameter, 25) << "by the bridge to (0, 4)";
}

TEST(DiscConnectivity, OfIslandsInRooms) {
  // A box in a box in a box; the two inner rings of space are open to each other by a gap of 1.
  const Walls walls =
      box({0, 0}, {30, 30}) + chain({{5, 15}, {5, 5}, {25, 5}, {25, 25}, {5, 25}, {5, 16}}) + box({10, 10}, {20, 20});
  EXPECT_EQ(widest_squared_diameter(walls, {2, 15}, {7, 7})->squared_diameter, 1);
  EXPECT_EQ(widest_squared_diameter(walls, {15, 15}, {7, 7}), std::nullopt);
  EXPECT_TRUE(connected(walls, {7, 7}, {23, 23}, 2));
  EXPECT_FALSE(connected(walls, {7, 15.5}, {2, 15}, 0.75));
}

// Shortest paths

TEST(DiscShortest, IsStraightWithoutWallsBetween) {
  EXPECT_DOUBLE_EQ(shortest({}, {0, 0}, {3, 4}, 1).value(), 5);
  EXPECT_DOUBLE_EQ(shortest(chain({{0, -1}, {10, -1}}), {2, 0}, {7, 0}, 1).value(), 5) << "along a wall";
  EXPECT_EQ(shortest(chain({{0, -1}, {10, -1}}), {2, 0}, {7, 0}, 1.001), std::nullopt) << "not free";
  EXPECT_EQ(shortest({}, {1, 1}, {1, 1}, 1), 0.0);
}

TEST(DiscShortest, TurnsAroundAnEnd) {
  const Walls walls = chain({{0, -10}, {0, 0}});
  const auto path = shortest_path(walls, {-5, 0}, {5, 0}, 1);
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->length, 2 * std::sqrt(24.0) + 2 * std::asin(0.2), 1e-14);
  ASSERT_EQ(path->pieces.size(), 3U);
  EXPECT_TRUE(path->pieces[1].is_arc);
  EXPECT_GT(path->pieces[1].start_angle, path->pieces[1].end_angle) << "clockwise";
  const PathReport report = check_path(walls, {-5, 0}, {5, 0}, 1, path->pieces);
  EXPECT_EQ(report.fault, "");
  EXPECT_NEAR(report.length, path->length, 1e-14);
  EXPECT_NEAR(report.clearance, 1, 1e-14);
}

TEST(DiscShortest, GoesFromCircleToCircle) {
  // Two half circles of radius 2 that touch at (2, 0).
  const Walls walls = chain({{0, -10}, {0, 0}}) + chain({{4, 10}, {4, 0}});
  EXPECT_NEAR(shortest(walls, {-2, 0}, {6, 0}, 2).value(), 4 * kPi, 1e-12);
  EXPECT_EQ(shortest(walls + box({-10, -10}, {20, 10}), {-2, 0}, {6, 0}, 2.001), std::nullopt);
  // With the radius 1: the common tangent leans by asin(2 / 4), so each arc turns by 120 degrees.
  EXPECT_NEAR(shortest(walls, {-1, 0}, {5, 0}, 1).value(), 4 * kPi / 3 + std::sqrt(12.0), 1e-14);
}

TEST(DiscShortest, CannotPassWhereTheDiscDoesNotFit) {
  const Walls walls = chain({{5, 0}, {5, 4}}) + chain({{5, 6}, {5, 10}}) + box({0, 0}, {10, 10});
  EXPECT_NEAR(shortest(walls, {2, 5}, {8, 5}, 0.99).value(), 6, 1e-14);
  EXPECT_NEAR(shortest(walls, {2, 5}, {8, 5}, 1).value(), 6, 1e-14);
  EXPECT_EQ(shortest(walls, {2, 5}, {8, 5}, 1.01), std::nullopt);
}

// The check of paths

TEST(DiscPathCheck, FindsFaults) {
  const Walls walls = chain({{0, -10}, {0, 0}});
  const std::vector<Piece> good{Piece::line({-1, -5}, {-1, 0}), Piece::arc({0, 0}, 1, kPi, 0),
                                Piece::line({1, 0}, {1, -5})};
  const auto fault = [&](const std::vector<Piece>& pieces, double r = 1) {
    return check_path(walls, {-1, -5}, {1, -5}, r, pieces).fault;
  };
  EXPECT_EQ(fault(good), "");
  EXPECT_NEAR(check_path(walls, {-1, -5}, {1, -5}, 1, good).length, 10 + kPi, 1e-14);
  EXPECT_NE(fault(good, 1.0001), "") << "the start is not free";
  EXPECT_NE(fault({}), "");
  EXPECT_NE(fault({good[0], good[1]}), "") << "ends before the goal";
  EXPECT_NE(fault({good[1], good[2]}), "") << "begins after the start";
  EXPECT_NE(fault({good[0], good[2]}), "") << "a missing piece";
  EXPECT_NE(fault({good[0], Piece::arc({0, 0}, 1, kPi, 2 * kPi), good[2]}), "") << "through the wall";
  EXPECT_NE(fault({good[0], Piece::line({-1, 0}, {1, 0}), good[2]}), "") << "touches the end";
  EXPECT_NE(fault({good[0], Piece::arc({0, -0.5}, std::sqrt(1.25), std::atan2(0.5, -1), std::atan2(0.5, 1)), good[2]}),
            "")
      << "too near to the end";
  EXPECT_EQ(fault({good[0], Piece::arc({0, 0}, 1, kPi, kPi / 2), Piece::arc({0, 0}, 1, -1.5 * kPi, -2 * kPi), good[2]}),
            "")
      << "angles may have any number of turns";
  EXPECT_NE(check_path(walls, {-1, -5}, {1, -5}, 1, {Piece::line({-1, -5}, {1, -5})}).fault, "");
  EXPECT_EQ(check_path(walls, {-1, -5}, {-1, -5}, 1, {}).fault, "");
}

// One oracle against the other

/// Returns whether the tolerance of `shortest` could decide: a bridge of nearly the diameter, or an end that is nearly
/// not free.
bool is_tie(const Connectivity& connectivity, Point start, Point goal, double r, double rounding) {
  for (const Point end : {start, goal}) {
    if (connectivity.fits(end, r * (1 - 1e-9)) != connectivity.fits(end, r * (1 + 1e-9))) return true;
  }
  return std::any_of(connectivity.bridges().begin(), connectivity.bridges().end(), [&](const Bridge& bridge) {
    const double length = std::sqrt(bridge.squared_length.convert_to<double>());
    return std::abs(length - 2 * r) <= 1e-9 * r + rounding;
  });
}

void expect_agreement(const NamedScene& scene) {
  SCOPED_TRACE(scene.name);
  const Walls walls = walls_of(scene);
  const Connectivity connectivity(walls);
  const double largest = largest_coordinate(scene.domain);
  for (const auto& [start, goal] : scene.queries) {
    const std::optional<Widest> widest = connectivity.widest(start, goal);
    for (const double r : scene.radii) {
      SCOPED_TRACE(::testing::Message() << start.x << ' ' << start.y << " to " << goal.x << ' ' << goal.y
                                        << " for the radius " << r);
      const bool is_connected = connectivity.connected(start, goal, r);
      if (connectivity.fits(start, r) && connectivity.fits(goal, r)) {
        const Rational diameter = 2 * Rational(r);
        EXPECT_EQ(is_connected, widest && (!widest->is_limited || diameter * diameter <= widest->squared_diameter));
      }
      const std::optional<ShortestPath> path = shortest_path(walls, start, goal, r);
      if (!is_tie(connectivity, start, goal, r, largest * 1e-15)) {
        EXPECT_EQ(path.has_value(), is_connected);
      }
      if (!path) continue;
      const PathReport report = check_path(walls, start, goal, r, path->pieces);
      EXPECT_EQ(report.fault, "");
      EXPECT_NEAR(report.length, path->length, 1e-9 * path->length + largest * 1e-14);
      EXPECT_NEAR(shortest(walls, goal, start, r).value_or(-1), path->length, 1e-9 * path->length);
    }
  }
}

TEST(DiscOracles, AgreeInTrapScenes) {
  for (const NamedScene& scene : checked_trap_scenes(0)) expect_agreement(scene);
}

class DiscOraclesInRandomScenes : public ::testing::TestWithParam<SceneKind> {};

TEST_P(DiscOraclesInRandomScenes, Agree) {
  for (std::uint64_t seed = 1; seed <= case_count<std::uint64_t>(4, 4); ++seed) {
    Random random(seed);
    expect_agreement(random_scene(random, GetParam()));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, DiscOraclesInRandomScenes, ::testing::ValuesIn(kSceneKinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

// The scenes

void expect_usable(const NamedScene& scene) {
  EXPECT_FALSE(scene.name.empty());
  for (const auto& [a, b] : scene.walls.segments) {
    EXPECT_TRUE(scene.domain.contains(a) && scene.domain.contains(b)) << scene.name;
  }
  EXPECT_GE(scene.queries.size(), 2U) << scene.name;
  for (const auto& [start, goal] : scene.queries) {
    EXPECT_TRUE(scene.domain.contains(start) && scene.domain.contains(goal)) << scene.name;
  }
  EXPECT_TRUE(std::is_sorted(scene.radii.begin(), scene.radii.end())) << scene.name;
  EXPECT_GT(scene.radii[0], 0.0);
}

TEST(DiscScenes, LieInTheirDomain) {
  Random random(7);
  for (const SceneKind kind : kSceneKinds) {
    for (int i = 0; i < case_count(50); ++i) expect_usable(random_scene(random, kind));
  }
  for (std::uint64_t seed = 0; seed < 5; seed += is_quick() ? 3 : 1) {
    for (const NamedScene& scene : checked_trap_scenes(seed)) expect_usable(scene);
  }
}

}  // namespace
}  // namespace waywright::test::disc
