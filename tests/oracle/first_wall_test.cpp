#include "oracle/first_wall.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace waywright::oracle {
namespace {

const OracleScene kScene{{{0, 0}, {8, 8}},
                         {{1, OracleKind::segment, {{{4, 1}, {4, 7}}}},
                          {2, OracleKind::polygon, {{{4, 4}, {6, 4}, {6, 6}, {4, 6}}}},
                          {3, OracleKind::point, {{{2, 2}}}}}};

void expect_hit(const OracleRay& ray, OraclePoint at, const std::vector<std::uint64_t>& ids) {
  const OracleHit hit = first_walls(kScene, {ray}).front();
  EXPECT_TRUE(hit.hit);
  EXPECT_EQ(hit.at, at);
  EXPECT_EQ(hit.ids, ids);
}

TEST(OracleFirstWall, IsTheFirstOfAllThatAreMet) {
  expect_hit({{1, 2}, {7, 2}}, {4, 2}, {1});
  expect_hit({{7, 5}, {1, 5}}, {6, 5}, {2});
  expect_hit({{1, 5}, {7, 5}}, {4, 5}, {1, 2});
  EXPECT_FALSE(first_walls(kScene, {{{1, 1}, {3, 3}}}).front().hit) << "a point is no wall";
}

TEST(OracleFirstWall, MayBeTouchedAtItsEndOrFromOneOfTheRays) {
  expect_hit({{3, 8}, {5, 6}}, {3, 8}, {0});
  expect_hit({{3, 7.5}, {4, 7}}, {4, 7}, {1});
  expect_hit({{4, 7.5}, {4, 0.5}}, {4, 7}, {1});
  expect_hit({{4, 2}, {4, 6}}, {4, 2}, {1});
  expect_hit({{5, 3}, {7, 5}}, {6, 4}, {2});
  expect_hit({{4, 4}, {4, 4}}, {4, 4}, {1, 2});
}

TEST(OracleFirstWall, PositionsAreRoundedCorrectly) {
  const OracleScene scene{{{0, 0}, {8, 8}}, {{1, OracleKind::segment, {{{1, 1}, {4, 3}}}}}};
  const OracleHit hit = first_walls(scene, {{{1, 2}, {4, 1}}}).front();
  EXPECT_EQ(hit.at, (OraclePoint{2, 5.0 / 3.0}));
}

}  // namespace
}  // namespace waywright::oracle
