#include "path/disc_channel.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/case_count.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_scenes.hpp"
#include "support/random.hpp"
#include "support/wall_mesh.hpp"

namespace waywright::test {
namespace {

using disc::NamedScene;
using mesh::HalfEdge;

constexpr std::size_t kAllExpansions = std::numeric_limits<std::size_t>::max();

/// Checks that the exits lead from a face at the start, face by face, to the end of the channel at the goal, that the
/// disc fits on each of them, and that no narrow foot bridge separates one from the next.
void check_exits(const path::DiscMap& map, const path::DiscEnds& ends, const path::DiscChannel& channel) {
  const mesh::TriangleMesh& mesh = map.mesh();
  const std::span<const HalfEdge> exits = channel.exits();
  ASSERT_TRUE(ends.is_goal_face(mesh::face(channel.goal_face())));
  if (exits.empty()) {
    ASSERT_TRUE(ends.have_common_face());
    return;
  }
  const locate::Located& start = ends.at_start();
  const bool is_at_start =
      mesh::face(exits[0]) == mesh::face(start.h) ||
      (start.kind == locate::LocatedKind::edge && mesh::face(exits[0]) == mesh::face(mesh.twin(start.h)));
  ASSERT_TRUE(is_at_start);
  for (std::size_t i = 0; i < exits.size(); ++i) {
    ASSERT_FALSE(map.is_closed(exits[i])) << "exit " << i;
    const mesh::Face beyond = mesh::face(mesh.twin(exits[i]));
    const bool is_last = i + 1 == exits.size();
    ASSERT_EQ(mesh::face(is_last ? channel.goal_face() : exits[i + 1]), beyond) << "exit " << i;
    ASSERT_TRUE(is_last || exits[i + 1] != mesh.twin(exits[i])) << "exit " << i;
    if (i == 0) continue;
    // A narrow foot bridge at the vertex of the entry and the exit would separate them.
    const HalfEdge entry = mesh.twin(exits[i - 1]);
    const HalfEdge corner = exits[i] == mesh::previous(entry) ? entry : exits[i];
    ASSERT_FALSE(map.narrow_bridge_foot(corner).has_value()) << "exit " << i;
  }
}

/// Searches for a channel, at once and in small steps. Checks both results, and returns the exits. `is_connected` says
/// whether the disc can move from the start to the goal.
std::vector<HalfEdge> find_channel(const path::DiscMap& map, const Point& start, const Point& goal, bool is_connected) {
  path::DiscEnds ends;
  ends.begin(map, start, goal);
  path::DiscChannel channel;
  std::size_t expansions = 0;
  channel.begin(map, ends);
  EXPECT_TRUE(channel.step(kAllExpansions, expansions));
  // A channel may cross a narrow foot bridge that starts outside of it. So there may be a channel without a path.
  const bool is_found = channel.is_found();
  EXPECT_TRUE(is_found || !is_connected);
  if (is_found) check_exits(map, ends, channel);
  const std::vector<HalfEdge> exits(channel.exits().begin(), channel.exits().end());
  std::size_t steps = 0;
  channel.begin(map, ends);
  for (std::size_t limit = 1; !channel.step(limit, steps); ++limit) EXPECT_LE(steps, limit);
  EXPECT_EQ(channel.is_found(), is_found);
  EXPECT_EQ(steps, expansions);
  EXPECT_EQ(std::vector<HalfEdge>(channel.exits().begin(), channel.exits().end()), exits);
  return exits;
}

void check_scene(const NamedScene& scene) {
  const disc::Walls walls = walls_of(scene);
  const disc::Connectivity connectivity(walls);
  const WallMesh map(scene);
  for (const auto& [start, goal] : scene.queries) {
    for (const double radius : scene.radii) {
      if (!connectivity.fits(start, radius) || !connectivity.fits(goal, radius)) continue;
      SCOPED_TRACE(scene.name + ", " + to_string(start) + " to " + to_string(goal) + ", radius " +
                   std::to_string(radius));
      const bool is_connected = connectivity.connected(start, goal, radius);
      for (const nav::TwoCore* core : {static_cast<const nav::TwoCore*>(nullptr), &map.core()}) {
        const path::DiscMap disc_map(map.walls(), map.bridges(), radius, start, core);
        static_cast<void>(find_channel(disc_map, start, goal, is_connected));
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

/// Appends a wall from one point to another, in pieces of the length 1.
void append_wall(NamedScene& scene, const Point& from, const Point& to) {
  const Point difference = to - from;
  const auto pieces = static_cast<int>(length(difference));
  for (int i = 0; i < pieces; ++i) {
    const Point a = from + (static_cast<double>(i) / pieces) * difference;
    const Point b = from + (static_cast<double>(i + 1) / pieces) * difference;
    scene.walls.segments.emplace_back(a, b);
  }
}

// The start lies in a corridor of more than 60 faces, which is closed towards the goal. Without a choice, the
// search follows the corridor away from the goal. It pauses there while nodes at the closed end have smaller bounds.
TEST(DiscChannel, LeavesALongCorridorAwayFromTheGoal) {
  NamedScene scene;
  scene.name = "corridor";
  scene.domain = {{0, 0}, {70, 20}};
  append_wall(scene, {4, 8}, {50, 8});
  append_wall(scene, {4, 12}, {50, 12});
  append_wall(scene, {50, 0}, {50, 16});
  scene.queries = {{{25, 10}, {60, 10}}, {{60, 10}, {25, 10}}, {{47, 10}, {60, 10}}};
  scene.radii = {0.25, 1, 1.5, 2};
  check_scene(scene);
  const WallMesh map(scene);
  const path::DiscMap disc_map(map.walls(), map.bridges(), 1.0, scene.queries[0].first);
  EXPECT_GT(find_channel(disc_map, scene.queries[0].first, scene.queries[0].second, true).size(), 60U);
}

class RandomChannels : public testing::TestWithParam<disc::SceneKind> {};

TEST_P(RandomChannels, ExistIfTheDiscCanReachTheGoal) {
  Random random(11);
  for (std::uint64_t i = 0; i < (case_count() + 9) / 10; ++i) {
    check_scene(disc::random_scene(random, GetParam()));
    if (testing::Test::HasFailure()) FAIL() << "scene " << i;
  }
}

// The test takes radii of about half the length of each foot bridge. For the last ones, doubles cannot tell the length
// from the width of the disc.
TEST_P(RandomChannels, KnowLongFootBridgesOnlyIfTheyAreLong) {
  Random random(5);
  std::size_t long_feet = 0;
  for (std::uint64_t i = 0; i < (case_count() + 9) / 10; ++i) {
    const NamedScene scene = disc::random_scene(random, GetParam());
    const WallMesh mesh(scene);
    const Point& start = scene.queries[0].first;
    for (std::uint32_t h = 0; h < 3 * mesh.walls().topology().face_slots(); ++h) {
      const HalfEdge corner{h};
      if (mesh.bridges().foot_at(corner) == clearance::Bridges::kNone) continue;
      const path::DiscMap widest(mesh.walls(), mesh.bridges(), 1e6, start);
      const Point from = widest.position(mesh.walls().topology().origin(corner));
      const double half = 0.5 * length(widest.narrow_bridge_foot(corner).value() - from);
      for (const double share : {0.5, 0.999, 1.0 - 0x1p-40, 1.0 - 0x1p-53, 1.0, 1.0 + 0x1p-52, 1.0 + 0x1p-40, 1.001}) {
        const path::DiscMap map(mesh.walls(), mesh.bridges(), half * share, start);
        const bool is_long = map.is_foot_surely_long(corner);
        ASSERT_FALSE(is_long && map.narrow_bridge_foot(corner))
            << "scene " << i << ", half-edge " << h << ", " << share;
        if (is_long) ++long_feet;
      }
    }
  }
  EXPECT_GT(long_feet, 0);
}

INSTANTIATE_TEST_SUITE_P(DiscChannel, RandomChannels, testing::ValuesIn(disc::kSceneKinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

}  // namespace
}  // namespace waywright::test
