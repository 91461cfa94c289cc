#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_scenes.hpp"

namespace waywright::test::disc {

/// Returns a world with bridges whose items are the walls of the scene.
[[nodiscard]] inline World world_of(const NamedScene& scene) {
  World world = World::create(scene.domain, {.keep_bridges = true}).value();
  for (const auto& [a, b] : scene.walls.segments) world.insert_segment(a, b).value();
  return world;
}

/// Expects two equal answers to a query for a disc. Does not compare how much the searches have expanded.
inline void expect_equal(const Path& path, const Path& expected) {
  EXPECT_EQ(path.status, expected.status);
  EXPECT_EQ(path.length, expected.length);
  EXPECT_EQ(path.lower_bound, expected.lower_bound);
  EXPECT_EQ(path.pieces, expected.pieces);
  EXPECT_EQ(path.blockers, expected.blockers);
  EXPECT_EQ(path.widest, expected.widest);
  EXPECT_EQ(path.agent.radius, expected.agent.radius);
  EXPECT_EQ(path.moved_start, expected.moved_start);
  EXPECT_EQ(path.moved_goal, expected.moved_goal);
}

/// Returns the pieces of a path, for the oracle.
[[nodiscard]] inline std::vector<Piece> pieces_of(const Path& path) {
  std::vector<Piece> result;
  for (const PathPiece& piece : path.pieces) {
    result.push_back(piece.kind == PathPiece::Kind::line
                         ? Piece::line(piece.from, piece.to)
                         : Piece::arc(piece.centre, piece.radius, piece.start_angle, piece.end_angle));
  }
  return result;
}

[[nodiscard]] inline double largest_coordinate(const Box& domain) {
  return std::max({std::fabs(domain.min.x), std::fabs(domain.min.y), std::fabs(domain.max.x), std::fabs(domain.max.y)});
}

/// Calls `check(scene, walls, path)` for the paths of discs through traps and random scenes.
template <class Check>
void for_each_path(const Check& check) {
  Random random(23);
  std::vector<NamedScene> scenes = trap_scenes(1);
  for (std::uint64_t i = 0; i < (case_count() + 1) / 2; ++i) {
    scenes.push_back(random_scene(random, kSceneKinds[i % kSceneKinds.size()]));
  }
  for (const NamedScene& scene : scenes) {
    const World world = world_of(scene);
    const Walls walls = walls_of(scene);
    for (const auto& [start, goal] : scene.queries) {
      for (const double radius : scene.radii) {
        const Path path =
            world.find_path({.start = start, .goal = goal, .agent = {.radius = radius}, .end_tolerance = 0.0}).value();
        if (path.status != PathStatus::found) continue;
        SCOPED_TRACE(scene.name + ", " + to_string(start) + " to " + to_string(goal) + ", " + std::to_string(radius));
        check(scene, walls, path);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

}  // namespace waywright::test::disc
