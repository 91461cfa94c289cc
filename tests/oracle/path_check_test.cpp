#include <gmock/gmock.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "oracle/oracle.hpp"
#include "oracle/small_scenes.hpp"

namespace waywright::oracle {
namespace {

using ::testing::HasSubstr;

std::string path_fault_of(const OracleScene& scene, const std::vector<OraclePoint>& points) {
  return check_path(scene, points).value_or("no fault");
}

const OracleScene kWall = square(4, {segment(7, {2, 0}, {2, 2})});

TEST(OraclePath, MayNotPassAWall) {
  EXPECT_THAT(path_fault_of(kWall, {{1, 1}, {3, 1}}), HasSubstr("passes through a wall of item 7"));
  EXPECT_EQ(path_fault_of(kWall, {{1, 1}, {2, 2}, {3, 1}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{1, 2}, {3, 2}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{1, 3}, {3, 1}}), "no fault");
}

TEST(OraclePath, MayTouchAWallButNotLeaveItOnTheOtherSide) {
  EXPECT_EQ(path_fault_of(kWall, {{1, 3}, {2, 1}, {1, 1}}), "no fault");
  EXPECT_THAT(path_fault_of(kWall, {{1, 3}, {2, 1}, {3, 1}}), HasSubstr("where walls meet, (2 1)"));
  EXPECT_THAT(path_fault_of(kWall, {{1, 1}, {2, 1}, {2, 0.5}, {3, 0.5}}), HasSubstr("where walls meet, (2 0.5)"));
  EXPECT_EQ(path_fault_of(kWall, {{1, 1}, {2, 1}, {2, 0.5}, {1, 0.5}}), "no fault");
}

TEST(OraclePath, MaySlideAlongAWallAndRoundItsEnd) {
  EXPECT_EQ(path_fault_of(kWall, {{2, 3}, {2, 1}, {3, 1}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{2, 3}, {2, 1}, {1, 1}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{1, 1}, {2, 1}, {2, 2}, {3, 1}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{1, 1}, {2, 1}, {2, 2}, {2, 1}, {3, 1}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{1, 1}, {2, 1}, {2, 1.5}, {2, 1}, {1, 1}}), "no fault");
  EXPECT_THAT(path_fault_of(kWall, {{1, 1}, {2, 1}, {2, 1.5}, {2, 1}, {3, 1}}), HasSubstr("where walls meet, (2 1)"));
}

TEST(OraclePath, MayStartAndEndOnEitherSideOfAWall) {
  EXPECT_EQ(path_fault_of(kWall, {{2, 1}, {1, 1}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{3, 1}, {2, 1}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{2, 0}, {2, 1}, {3, 1}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{2, 1}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{2, 1}, {2, 1}, {3, 1}}), "no fault");
  EXPECT_THAT(path_fault_of(kWall, {}), HasSubstr("no points"));
}

TEST(OraclePath, MayNotSqueezeBetweenAWallAndTheDomain) {
  EXPECT_THAT(path_fault_of(kWall, {{1, 1}, {2, 0}, {3, 1}}), HasSubstr("where walls meet, (2 0)"));
  EXPECT_THAT(path_fault_of(kWall, {{1, 0}, {3, 0}}), HasSubstr("where walls meet, (2 0)"));
  EXPECT_EQ(path_fault_of(kWall, {{1, 1}, {1, 0}, {2, 0}, {1, 1}}), "no fault");
  EXPECT_EQ(path_fault_of(kWall, {{0, 0}, {0, 4}, {4, 4}, {4, 0}}), "no fault");
  EXPECT_THAT(path_fault_of(kWall, {{1, 1}, {1, -1}, {3, 1}}), HasSubstr("leaves the domain"));
}

TEST(OraclePath, MayNotRunThroughASolid) {
  const OracleScene scene = square(8, {box(1, {2, 2}, {4, 4})});
  EXPECT_THAT(path_fault_of(scene, {{1, 3}, {5, 3}}), HasSubstr("wall of item 1"));
  EXPECT_THAT(path_fault_of(scene, {{1, 1}, {2, 2}, {4, 4}, {5, 5}}), HasSubstr("(2 2)"));
  EXPECT_THAT(path_fault_of(scene, {{2, 3}, {4, 3}}), HasSubstr("inside of a polygon after (2 3)"));
  EXPECT_THAT(path_fault_of(scene, {{1, 3}, {3, 3}}), HasSubstr("wall of item 1"));
  EXPECT_THAT(path_fault_of(scene, {{3, 3}, {5, 5}}), HasSubstr("starts inside a polygon"));
  EXPECT_THAT(path_fault_of(scene, {{3, 3}}), HasSubstr("starts inside a polygon"));
  EXPECT_EQ(path_fault_of(scene, {{1, 1}, {2, 2}, {2, 4}, {4, 4}, {5, 3}}), "no fault");
}

TEST(OraclePath, MayNotPassADoubleCorner) {
  const OracleScene boxes = square(8, {box(1, {2, 2}, {4, 4}), box(2, {4, 4}, {6, 6})});
  EXPECT_THAT(path_fault_of(boxes, {{3, 5}, {4, 4}, {5, 3}}), HasSubstr("where walls meet, (4 4)"));
  EXPECT_THAT(path_fault_of(boxes, {{3, 5}, {5, 3}}), HasSubstr("where walls meet, (4 4)"));
  EXPECT_EQ(path_fault_of(boxes, {{3, 5}, {4, 4}, {4, 5}}), "no fault");
  const OracleScene pinched = square(8, {{1, OracleKind::polygon, {{{2, 2}, {4, 2}, {4, 6}, {6, 6}, {6, 4}, {2, 4}}}}});
  EXPECT_THAT(path_fault_of(pinched, {{3, 5}, {4, 4}, {5, 3}}), HasSubstr("where walls meet, (4 4)"));
  EXPECT_THAT(path_fault_of(pinched, {{3, 5}, {5, 3}}), HasSubstr("wall of item 1"));
  EXPECT_EQ(path_fault_of(pinched, {{3, 5}, {4, 4}, {4, 5}}), "no fault");
}

TEST(OraclePath, MaySlideBetweenASolidAndAWallOnlyWhereThereIsRoom) {
  // No path runs along the side that two boxes share. A path may run along the sides of a hole.
  const OracleScene boxes = square(8, {box(1, {2, 2}, {4, 4}), box(2, {4, 2}, {6, 4})});
  EXPECT_THAT(path_fault_of(boxes, {{4, 2}, {4, 4}}), HasSubstr("inside of a polygon after (4 2)"));
  EXPECT_THAT(path_fault_of(boxes, {{4, 1}, {4, 5}}), HasSubstr("where walls meet, (4 2)"));
  OracleItem ring = box(1, {1, 1}, {7, 7});
  ring.rings.push_back(box(1, {2, 2}, {6, 6}).rings.front());
  const OracleScene hole = square(8, {ring});
  EXPECT_EQ(path_fault_of(hole, {{2, 2}, {2, 6}, {6, 6}, {3, 3}}), "no fault");
  EXPECT_THAT(path_fault_of(hole, {{2, 2}, {1, 1}}), HasSubstr("inside of a polygon after (2 2)"));
}

TEST(OraclePath, PointsAndZeroLengthItemsAreNoWalls) {
  const OracleScene scene = square(4, {{1, OracleKind::point, {{{2, 2}}}}, segment(2, {3, 3}, {3, 3})});
  EXPECT_EQ(path_fault_of(scene, {{1, 1}, {4, 4}}), "no fault");
}

// The walls cross at (1, 2/3), which is not a pair of doubles.
const OracleScene kCross{{{-1, -1}, {4, 4}}, {segment(1, {0, 0}, {3, 2}), segment(2, {0, 1}, {3, 0})}};
const OraclePoint kCrossCorner{1, 2.0 / 3.0};

TEST(OraclePath, ARoundedCornerStandsForItsCrossing) {
  EXPECT_EQ(path_fault_of(kCross, {{1, 2}, kCrossCorner, {2, 3}}), "no fault");
  EXPECT_EQ(path_fault_of(kCross, {{0, 1}, kCrossCorner, {3, 2}}), "no fault");
  EXPECT_EQ(path_fault_of(kCross, {{3, 2}, kCrossCorner, {3, 0}}), "no fault");
  EXPECT_THAT(path_fault_of(kCross, {{0, 1}, kCrossCorner, {3, 0}}), HasSubstr("where walls meet"));
  EXPECT_THAT(path_fault_of(kCross, {{1, 2}, kCrossCorner, {1, 0}}), HasSubstr("where walls meet"));
  EXPECT_THAT(path_fault_of(kCross, {{1, 2}, kCrossCorner, {2, 2.0 / 3.0}}), HasSubstr("where walls meet"));
}

TEST(OraclePath, OtherCornersAndEndsAreExact) {
  // The point is one unit in the last place away, so it does not stand for the crossing.
  const OraclePoint beside{1, 0x1.5555555555557p-1};
  EXPECT_THAT(path_fault_of(kCross, {{0, 1}, beside, {3, 0}}), HasSubstr("wall of item"));
  // As a goal the point stands for itself: the double nearest to 2/3 lies below the crossing of the walls, that is
  // beyond the wall.
  EXPECT_THAT(path_fault_of(kCross, {{1, 2}, kCrossCorner}), HasSubstr("wall of item 1"));
}

}  // namespace
}  // namespace waywright::oracle
