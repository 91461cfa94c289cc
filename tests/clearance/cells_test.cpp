#include "clearance/cells.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "clearance/near_walls.hpp"
#include "clearance/widest.hpp"
#include "exact/gap.hpp"
#include "support/case_count.hpp"
#include "support/disc_oracle.hpp"
#include "support/disc_scenes.hpp"

namespace waywright::test {
namespace {

using clearance::Bridges;
using clearance::CellEdge;
using clearance::Cells;
using disc::NamedScene;
using disc::Rational;

/// A mesh of the walls of a scene, with its bridges.
class Map {
 public:
  explicit Map(const NamedScene& scene) : mesh_(scene.domain) {
    std::vector<Item> items;
    for (const auto& [a, b] : scene.walls.segments) {
      if (!(a == b)) items.push_back({ItemId{items.size() + 1}, Shape::segment(a, b)});
    }
    constraint::ConstrainedTriangulation::UndoGuard operation(mesh_);
    for (const Item& item : items) mesh_.insert(item.shape, item.id);
    operation.commit();
    bridges_.emplace(mesh_);
  }

  [[nodiscard]] bool fits(const Point& point, double radius) { return near_.has_no_nearer_wall(mesh_, point, radius); }
  [[nodiscard]] std::optional<CellEdge> cell_at(const Point& point) { return near_.find_cell(mesh_, *bridges_, point); }
  [[nodiscard]] clearance::Narrowest narrowest(const CellEdge& start, const CellEdge& goal) {
    return widest_.find(cells(), start, goal);
  }
  [[nodiscard]] Cells cells() const { return {mesh_, *bridges_}; }

 private:
  constraint::ConstrainedTriangulation mesh_;
  std::optional<Bridges> bridges_;
  clearance::NearWalls near_;
  clearance::WidestSearch widest_;
};

Rational squared_length(const exact::Gap& gap) {
  const auto difference = [](const Point& p, const Point& q) {
    return std::pair<Rational, Rational>{Rational(p.x) - Rational(q.x), Rational(p.y) - Rational(q.y)};
  };
  const auto [x, y] = difference(gap.a, gap.from);
  if (gap.a == gap.b) return x * x + y * y;
  const auto [dx, dy] = difference(gap.b, gap.a);
  const Rational area = x * dy - y * dx;
  return area * area / (dx * dx + dy * dy);
}

// If another wall touches the circle whose diameter is a gap, the library does not call this gap a bridge. Then a disc
// whose diameter is larger than the gap fits at no position on the left of the gap, or at no position on its right. So
// the library and the oracle agree about all discs that fit at both ends.
void check_scene(const NamedScene& scene) {
  SCOPED_TRACE(scene.name);
  const disc::Connectivity oracle(walls_of(scene));
  Map map(scene);
  for (const auto& [start, goal] : scene.queries) {
    SCOPED_TRACE(to_string(start) + " to " + to_string(goal));
    for (const double radius : scene.radii) {
      ASSERT_EQ(map.fits(start, radius), oracle.fits(start, radius)) << "start, radius " << radius;
      ASSERT_EQ(map.fits(goal, radius), oracle.fits(goal, radius)) << "goal, radius " << radius;
    }
    const auto start_cell = map.cell_at(start);
    const auto goal_cell = map.cell_at(goal);
    const auto widest = oracle.widest(start, goal);
    if (!start_cell || !goal_cell) {
      ASSERT_FALSE(widest.has_value());
      continue;
    }
    const clearance::Narrowest found = map.narrowest(*start_cell, *goal_cell);
    ASSERT_EQ(found.is_connected, widest.has_value());
    if (!widest) continue;
    const Rational largest = disc::largest_at(walls_of(scene), start, goal);
    const Rational expected = widest->is_limited ? std::min(largest, widest->squared_diameter) : largest;
    ASSERT_EQ(found.gate ? std::min(largest, squared_length(map.cells().gap(*found.gate))) : largest, expected);
    for (const double radius : scene.radii) {
      if (!oracle.fits(start, radius) || !oracle.fits(goal, radius)) continue;
      const bool fits = !found.gate || exact::compare_to_diameter(map.cells().gap(*found.gate), radius) >= 0;
      ASSERT_EQ(fits, oracle.connected(start, goal, radius)) << "radius " << radius;
    }
  }
}

TEST(Cells, SayWhichDiscsGetThroughInTrapScenes) {
  for (std::uint64_t seed = 0; seed < (case_count() + 99) / 100; ++seed) {
    for (const NamedScene& scene : disc::checked_trap_scenes(seed)) {
      check_scene(scene);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

class RandomWalls : public testing::TestWithParam<disc::SceneKind> {};

TEST_P(RandomWalls, SayWhichDiscsGetThrough) {
  Random random(2);
  for (std::uint64_t i = 0; i < (case_count() + 4) / 5; ++i) {
    check_scene(disc::random_scene(random, GetParam()));
    if (testing::Test::HasFatalFailure()) FAIL() << "scene " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, RandomWalls, testing::ValuesIn(disc::kSceneKinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

}  // namespace
}  // namespace waywright::test
