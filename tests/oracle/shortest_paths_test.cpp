#include "oracle/shortest_paths.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "oracle/small_scenes.hpp"

namespace waywright::oracle {
namespace {

/// Returns the length from one point to another, which must be equal in the opposite direction, or why there is no
/// path.
std::string length(const OracleScene& scene, OraclePoint start, OraclePoint goal) {
  ShortestPaths paths(scene, {start, goal});
  const ShortestPath there = paths.between(start, goal);
  const ShortestPath back = paths.between(goal, start);
  if (there.status == OracleStatus::start_blocked) return "start blocked";
  if (there.status == OracleStatus::goal_blocked) return "goal blocked";
  if (there.status != back.status || std::fabs(there.length - back.length) > 1e-14 * there.length)
    return "not the same";
  return there.status == OracleStatus::found ? std::to_string(there.length) : "no path";
}

std::string text(double value) { return std::to_string(value); }

TEST(ShortestPaths, GoStraightWhereNothingStands) {
  EXPECT_EQ(length(square(8, {}), {1, 1}, {4, 5}), text(5));
  EXPECT_EQ(length(square(8, {}), {0, 0}, {8, 8}), text(8 * std::sqrt(2)));
  EXPECT_EQ(length(square(8, {}), {0, 0}, {0, 8}), text(8));
  EXPECT_EQ(length(square(8, {}), {3, 3}, {3, 3}), text(0));
  EXPECT_EQ(length(square(8, {{1, OracleKind::point, {{{2, 2}}}}, segment(2, {3, 3}, {3, 3})}), {1, 1}, {4, 4}),
            text(3 * std::sqrt(2)));
}

TEST(ShortestPaths, BendRoundTheEndsOfWalls) {
  const OracleScene scene = square(10, {segment(1, {4, 0}, {4, 7}), segment(2, {2, 4}, {8, 4})});
  EXPECT_EQ(length(scene, {1, 1}, {7, 1}), text(std::sqrt(10) + std::sqrt(13) + 5 + std::sqrt(10)));
  EXPECT_EQ(length(square(10, {segment(1, {4, 0}, {4, 7})}), {1, 1}, {7, 1}), text(2 * std::sqrt(45)));
}

TEST(ShortestPaths, TouchCornersOnAStraightPath) {
  // The straight path from (1, 1) to (7, 7) touches the corners of two boxes, one to its left and one to its right.
  const OracleScene scene = square(8, {box(1, {2, 3}, {3, 4}), box(2, {5, 4}, {6, 5})});
  EXPECT_EQ(length(scene, {1, 1}, {7, 7}), text(6 * std::sqrt(2)));
}

TEST(ShortestPaths, SlideAlongWalls) {
  const OracleScene scene = square(8, {box(1, {2, 2}, {4, 4}), segment(2, {4, 2}, {6, 2})});
  EXPECT_EQ(length(scene, {1, 2}, {7, 2}), text(6));
  EXPECT_EQ(length(scene, {3, 2}, {3, 4}), text(4));
  EXPECT_EQ(length(scene, {3, 2}, {5, 2}), text(2));
  EXPECT_EQ(length(scene, {4, 3}, {5, 2}), text(std::sqrt(2)));
}

TEST(ShortestPaths, EndOnEitherSideOfAWall) {
  const OracleScene scene = square(8, {segment(1, {4, 0}, {4, 6})});
  EXPECT_EQ(length(scene, {4, 3}, {1, 3}), text(3));
  EXPECT_EQ(length(scene, {4, 3}, {7, 3}), text(3));
  EXPECT_EQ(length(scene, {4, 0}, {7, 0}), text(3));
  EXPECT_EQ(length(scene, {3, 0}, {5, 0}), text(2 * std::sqrt(37)));
}

TEST(ShortestPaths, NeverPassWhereWallsMeet) {
  // Two walls that meet enclose a corner of the domain; so does a wall that ends on another.
  const OracleScene corner = square(8, {segment(1, {0, 4}, {4, 4}), segment(2, {4, 4}, {4, 0})});
  EXPECT_EQ(length(corner, {1, 1}, {7, 7}), "no path");
  EXPECT_EQ(length(corner, {4, 4}, {1, 1}), text(3 * std::sqrt(2)));
  const OracleScene cross = square(8, {segment(1, {0, 4}, {8, 4}), segment(2, {4, 0}, {4, 8})});
  EXPECT_EQ(length(cross, {3, 3}, {5, 5}), "no path");
  EXPECT_EQ(length(cross, {3, 3}, {4, 4}), text(std::sqrt(2)));
  const OracleScene tee = square(8, {segment(1, {2, 4}, {6, 4}), segment(2, {4, 4}, {4, 8})});
  EXPECT_EQ(length(tee, {3, 4}, {5, 4}), text(2));
  EXPECT_EQ(length(tee, {3, 5}, {5, 5}), text(2 * std::sqrt(2) + 4));
}

TEST(ShortestPaths, GoRoundADoubleCorner) {
  const OracleScene boxes = square(8, {box(1, {2, 2}, {4, 4}), box(2, {4, 4}, {6, 6})});
  EXPECT_EQ(length(boxes, {3, 5}, {5, 3}), text(std::sqrt(2) + 2 + 2 + std::sqrt(2)));
  const OracleItem pinched{1, OracleKind::polygon, {{{2, 2}, {4, 2}, {4, 6}, {6, 6}, {6, 4}, {2, 4}}}};
  // The polygon's sides cross at (4, 4). The path around it touches a corner of either square.
  EXPECT_EQ(length(square(8, {pinched}), {3, 5}, {5, 3}), text(std::sqrt(2) + 2 + 2 + std::sqrt(2)));
  EXPECT_EQ(length(square(8, {pinched}), {4, 4}, {4, 3}), text(1));
}

TEST(ShortestPaths, KnowWhatIsSolid) {
  const OracleScene scene = square(8, {box(1, {2, 2}, {4, 4}), box(2, {4, 2}, {6, 4})});
  EXPECT_EQ(length(scene, {3, 3}, {1, 1}), "start blocked");
  EXPECT_EQ(length(scene, {1, 1}, {5, 3}), "goal blocked");
  EXPECT_EQ(length(scene, {4, 1}, {4, 5}), text(2 * std::sqrt(5) + 2));
  // The point lies on the sides of both boxes and inside neither. Still no path leads away from it.
  EXPECT_EQ(length(scene, {4, 3}, {1, 1}), "no path");
  EXPECT_EQ(length(scene, {4, 3}, {4, 3}), text(0));
  OracleItem ring = box(1, {1, 1}, {7, 7});
  ring.rings.push_back(box(1, {2, 2}, {6, 6}).rings.front());
  EXPECT_EQ(length(square(8, {ring}), {2, 2}, {6, 6}), text(4 * std::sqrt(2)));
  EXPECT_EQ(length(square(8, {ring}), {2, 2}, {1, 1}), "no path");
}

TEST(ShortestPaths, NeedNoDoubleToNameACrossing) {
  // The walls cross at (1, 2/3) and leave four wedges there, each less than half a turn. The path from the upper wedge
  // to the right one leads around the end (3, 2).
  const OracleScene scene{{{-1, -1}, {4, 4}}, {segment(1, {0, 0}, {3, 2}), segment(2, {0, 1}, {3, 0})}};
  EXPECT_EQ(length(scene, {1, 2}, {3, 1}), text(2 + 1));
}

TEST(ShortestPaths, SeeThroughNoGapThatIsNone) {
  // The smallest difference decides: if the wall's end lies on the other wall there is no path; if it is one unit short
  // there is.
  const double less = std::nextafter(4.0, 0.0);
  EXPECT_EQ(length(square(8, {segment(1, {0, 4}, {8, 4}), segment(2, {4, 0}, {4, 4})}), {3, 3}, {5, 3}), "no path");
  EXPECT_EQ(length(square(8, {segment(1, {0, 4}, {8, 4}), segment(2, {4, 0}, {4, less})}), {3, 3}, {5, 3}),
            text(2 * std::sqrt(2)));
}

}  // namespace
}  // namespace waywright::oracle
