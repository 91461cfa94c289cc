#include "clearance/bridges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/bridges_check.hpp"
#include "support/bridges_oracle.hpp"
#include "support/case_count.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

using bridge_oracle::BridgeSet;
using bridge_oracle::exactly;
using bridge_oracle::expected_bridges;
using bridge_oracle::foot_on;
using bridge_oracle::ordered;
using bridge_oracle::Segment;
using bridge_oracle::Vector;
using clearance::Bridges;
using mesh::HalfEdge;
clearance::ChangedWalls changed_by(const Shape& shape) {
  clearance::ChangedWalls changed;
  changed.add(Box::bounding(shape.rings.points()));
  changed.make_tree();
  return changed;
}

/// A mesh of walls with its bridges. Changes them in the same order as a world does.
class Walls {
 public:
  explicit Walls(const Box& domain, const clearance::SearchLimits& limits = {})
      : mesh_(domain), bridges_(mesh_, limits) {}

  void insert(const Shape& shape, ItemId id) {
    constraint::ConstrainedTriangulation::UndoGuard operation(mesh_);
    mesh_.insert(shape, id);
    update(changed_by(shape));
    operation.commit();
  }
  void remove(ItemId id) {
    constraint::ConstrainedTriangulation::UndoGuard operation(mesh_);
    mesh_.remove(id);
    clearance::ChangedWalls any;
    any.add_all();
    update(any);
    operation.commit();
  }
  void remove(const Shape& shape, ItemId id) {
    constraint::ConstrainedTriangulation::UndoGuard operation(mesh_);
    mesh_.remove(id);
    update(changed_by(shape));
    operation.commit();
  }
  [[nodiscard]] const Bridges& bridges() const { return bridges_; }
  [[nodiscard]] const constraint::ConstrainedTriangulation& mesh() const { return mesh_; }

  [[nodiscard]] std::vector<Segment> walls() const {
    std::set<Segment> result;
    for_each_wall([&](HalfEdge h) {
      mesh_.for_each_side(
          h, [&](const constraint::Side& side) { result.insert(ordered(position(side.from), position(side.to))); });
    });
    return {result.begin(), result.end()};
  }
  [[nodiscard]] BridgeSet found() const {
    BridgeSet result;
    for (std::uint32_t i = 0; i < 3 * mesh_.topology().face_slots(); ++i) {
      const HalfEdge h{i};
      if (bridges_.is_bridge(h)) {
        result.insert(ordered(position(mesh_.topology().origin(h)), position(mesh_.topology().target(h))));
      }
      if (bridges_.foot_at(h) == Bridges::kNone) continue;
      const constraint::Side& side = mesh_.any_side(bridges_.wall_of(bridges_.foot_at(h)));
      const Vector from = position(mesh_.topology().origin(h));
      result.insert({from, foot_on(from, {position(side.from), position(side.to)})});
    }
    return result;
  }

 private:
  void update(const clearance::ChangedWalls& changed) {
    const mesh::TouchedFaces::Guard guard(touched_);
    touched_.collect(mesh_.topology());
    bridges_.update(mesh_, touched_, changed);
  }
  [[nodiscard]] Vector position(mesh::Vertex v) const {
    return exactly(mesh_.triangulation().geometry().rounded(number(v)));
  }
  template <class Visit>
  void for_each_wall(Visit&& visit) const {
    for (std::uint32_t i = 0; i < 3 * mesh_.topology().face_slots(); ++i) {
      if (mesh_.topology().is_live(mesh::face(HalfEdge{i})) && mesh_.topology().is_fixed(HalfEdge{i}))
        visit(HalfEdge{i});
    }
  }

  constraint::ConstrainedTriangulation mesh_;
  Bridges bridges_;
  mesh::TouchedFaces touched_;
};

/// Returns whether each ring of the shape has a side.
bool has_walls(const Shape& shape) {
  if (shape.kind == ItemKind::point) return false;
  return std::all_of(shape.rings.begin(), shape.rings.end(), [](const auto& ring) {
    return std::any_of(ring.begin(), ring.end(), [&](const Point& p) { return !(p == ring.front()); });
  });
}

class RandomScenes : public testing::TestWithParam<Flavour> {};

TEST_P(RandomScenes, HaveTheBridgesOfTheDefinition) {
  for (std::uint64_t seed = 0; seed < (case_count() + 3) / 4; ++seed) {
    const Scene scene = random_scene(GetParam(), seed, 1 + seed % 9);
    Walls walls(scene.domain);
    for (const Item& item : scene.items) {
      if (has_walls(item.shape)) walls.insert(item.shape, item.id);
    }
    ASSERT_TRUE(walls.found() == expected_bridges(walls.walls())) << "seed " << seed;
    ASSERT_EQ(walls.bridges().find_fault(walls.mesh()), std::nullopt) << "seed " << seed;
  }
}

TEST_P(RandomScenes, KeepTheBridgesOfARebuildAfterEveryChange) {
  for (std::uint64_t seed = 0; seed < (case_count() + 9) / 10; ++seed) {
    const Scene scene = random_scene(GetParam(), 1000 + seed, 4 + 4 * (seed % 8));
    Random random(seed);
    Walls walls(scene.domain);
    std::vector<bool> is_live(scene.items.size());
    for (int step = 0; step < 100; ++step) {
      const std::size_t i = random.below(scene.items.size());
      if (!has_walls(scene.items[i].shape)) continue;
      if (is_live[i]) {
        walls.remove(scene.items[i].id);
      } else {
        walls.insert(scene.items[i].shape, scene.items[i].id);
      }
      is_live[i] = !is_live[i];
      ASSERT_EQ(walls.bridges().find_fault(walls.mesh()), std::nullopt) << "seed " << seed << ", step " << step;
    }
  }
}

TEST_P(RandomScenes, KeepTheBridgesWithLooseCornersAndUndoneSteps) {
  for (std::uint64_t seed = 0; seed < (case_count() + 9) / 10; ++seed) {
    const ChangeScript script = random_changes(GetParam(), seed, 200, 10 + 10 * (seed % 6));
    const BridgesReport report = check_bridges(script, seed);
    ASSERT_EQ(report.fault, std::nullopt) << "seed " << seed;
    EXPECT_GT(report.changes, 100U);
    EXPECT_GT(report.undone, 0U);
  }
}

/// A street: a row of houses and fences beside a long wall, and things that stand on this wall. The mesh has vertices
/// with many edges, and the wall has many feet.
class RandomStreet {
 public:
  RandomStreet(std::uint64_t seed, std::size_t size) : random_(seed), shapes_(size) {
    is_slanted_ = random_.below(2) == 0;
    unevenness_ = random_.below(3) == 0 ? 0.0 : random_.below(2) == 0 ? 0x1p-40 : 2.0;
    for (std::size_t i = 0; i < size; ++i) shapes_[i] = make(i);
  }

  [[nodiscard]] Box domain() const { return {{-20, -100}, {8.0 * static_cast<double>(shapes_.size()) + 20, 300}}; }
  [[nodiscard]] Shape long_wall() const { return Shape::segment(at(-15, 0), at(domain().max.x - 5, 0)); }
  [[nodiscard]] const Shape& shape(std::size_t i) const { return shapes_[i]; }

 private:
  /// A position, given by its x and its height above the long wall.
  [[nodiscard]] Point at(double x, double height) const { return {x, height + (is_slanted_ ? x * 0.25 : 0.0)}; }
  [[nodiscard]] Shape make(std::size_t i) {
    const double x = 8.0 * static_cast<double>(i);
    const double height = 30 + unevenness_ * static_cast<double>(random_.below(16));
    switch (random_.below(8)) {
      case 0:
        return Shape::segment(at(x, height), at(x, height + 5));
      case 1:
        return Shape::polygon({at(x, 0), at(x + 4, 0), at(x + 4, 3), at(x, 3)});  // on the wall
      case 2:
        return Shape::segment(at(x + 2, -3), at(x + 2, 0));  // behind the wall, up to it
      default:
        return Shape::polygon({at(x, height), at(x + 6, height), at(x + 6, height + 4), at(x, height + 4)});
    }
  }

  Random random_;
  std::vector<Shape> shapes_;
  bool is_slanted_ = false;
  double unevenness_ = 0.0;
};

TEST(RandomStreets, KeepTheBridgesOfARebuildAfterEveryChange) {
  for (std::uint64_t seed = 0; seed < (case_count() + 3) / 4; ++seed) {
    const std::size_t size = 20 + 10 * (seed % 6);
    const RandomStreet street(seed, size);
    Walls walls(street.domain(), seed % 3 == 0 ? clearance::SearchLimits{1, 0, 1} : clearance::SearchLimits{});
    walls.insert(street.long_wall(), ItemId{1000});
    Random random(seed);
    std::vector<bool> is_live(size);
    for (std::size_t step = 0; step < 4 * size; ++step) {
      const std::size_t i = random.below(size);
      if (is_live[i]) {
        walls.remove(street.shape(i), ItemId{i + 1});
      } else {
        walls.insert(street.shape(i), ItemId{i + 1});
      }
      is_live[i] = !is_live[i];
      ASSERT_EQ(walls.bridges().find_fault(walls.mesh()), std::nullopt) << "seed " << seed << ", step " << step;
    }
    if (seed % 8 != 0) continue;
    ASSERT_TRUE(walls.found() == expected_bridges(walls.walls())) << "seed " << seed;
  }
}

// Many short walls stand around the end of a long wall, each at an angle of its own, so the end is a vertex with many
// edges. A segment comes and goes beside the bridges from there, with several edges between the segment and such a
// bridge.
TEST(Hubs, KeepTheBridgesOfARebuildAfterEveryChange) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    Walls walls({{-2000, -2000}, {2000, 2000}},
                seed % 2 == 0 ? clearance::SearchLimits{1, 0, 1} : clearance::SearchLimits{});
    walls.insert(Shape::segment({-1000, 0}, {0, 0}), ItemId{1});
    const auto at = [](double radius, double degrees) {
      const double angle = degrees * 0.017453292519943295;
      return Point{radius * std::cos(angle), radius * std::sin(angle)};
    };
    for (int k = -24; k <= 24; ++k) {
      const double radius = 99.0 + static_cast<double>(random.below(3));
      walls.insert(Shape::segment(at(radius, 3.0 * k), at(radius + 10, 3.0 * k)),
                   ItemId{100U + static_cast<unsigned>(k)});
    }
    ASSERT_EQ(walls.bridges().find_fault(walls.mesh()), std::nullopt) << "seed " << seed;
    for (int step = 0; step < 40; ++step) {
      const double degrees = 0.001 * static_cast<double>(random.below(140001)) - 70.0;
      const double radius = 30.0 + 0.001 * static_cast<double>(random.below(65001));
      const Shape segment = Shape::segment(at(radius, degrees), at(radius + 1, degrees + 1));
      walls.insert(segment, ItemId{2});
      ASSERT_EQ(walls.bridges().find_fault(walls.mesh()), std::nullopt) << "seed " << seed << ", step " << step;
      walls.remove(segment, ItemId{2});
      ASSERT_EQ(walls.bridges().find_fault(walls.mesh()), std::nullopt) << "seed " << seed << ", step " << step;
    }
  }
}

// A bridge runs from the origin up to a wall, in a disc of the diameter 1000. To the right of this disc, short walls
// form a chain such that the circles of the triangles at the origin grow towards the bridge. A wall that comes and goes
// near the origin, in the disc, touches none of the last circles before the bridge. So only the edges at the origin
// lead from this wall to the bridge. An inversion at the origin maps the chain to a concave curve below the line y = 1,
// which is the image of the disc's circle.
TEST(Hubs, LoseAndWinABridgeManyEdgesAway) {
  const auto from_inverse = [](double x, double y) {
    const double square = x * x + y * y;
    const Point p{1000 * x / square, 1000 * y / square};
    return Shape::segment(p, {p.x + 1, p.y});
  };
  for (const int count : {2, 4, 10, 40}) {
    for (const clearance::SearchLimits& limits : {clearance::SearchLimits{}, clearance::SearchLimits{1, 0, 1}}) {
      Walls walls({{-5000, -5000}, {5000, 5000}}, limits);
      walls.insert(Shape::segment({-1000, 1000}, {500, 1000}), ItemId{1});
      walls.insert(Shape::segment({0, -10}, {0, 0}), ItemId{2});
      unsigned id = 10;
      for (int i = 1; i <= count; ++i) {
        const double x = 0.8 * i / count;
        walls.insert(from_inverse(0.4 + x, 0.8 + 0.33 * x - 0.175 * x * x), ItemId{id++});
      }
      walls.insert(from_inverse(3, 0.98), ItemId{id++});
      walls.insert(from_inverse(6, 0.8), ItemId{id++});
      const Shape wall = from_inverse(5, 1.1);
      for (int step = 0; step < 3; ++step) {
        SCOPED_TRACE(std::to_string(count) + " walls in the chain, step " + std::to_string(step));
        ASSERT_EQ(walls.bridges().find_fault(walls.mesh()), std::nullopt);
        walls.insert(wall, ItemId{3});
        ASSERT_EQ(walls.bridges().find_fault(walls.mesh()), std::nullopt);
        walls.remove(wall, ItemId{3});
      }
    }
  }
}

// A corner stands nearly on the normal at the end of a long slanted wall. Its foot lies strictly inside the wall, but
// so near the end that the rounding of the foot, computed from the other end, is larger than this distance.
TEST(FarWalls, HaveFeetNearTheirEnds) {
  Random random(1);
  std::size_t feet = 0;
  for (int i = 0; i < 400; ++i) {
    const double angle = 0.1 + 0.0013 * i;
    const Point along{std::cos(angle), std::sin(angle)};
    const Point end{70000.0 * along.x, 70000.0 * along.y};
    const auto at = [&](double x, double height) {
      return Point{end.x + x * along.x - height * along.y, end.y + x * along.y + height * along.x};
    };
    Walls walls({{-1000, -1000}, {100000, 100000}}, {1, 0, 1});
    const bool is_reversed = i % 2 == 0;
    walls.insert(is_reversed ? Shape::segment(end, {0, 0}) : Shape::segment({0, 0}, end), ItemId{1});
    for (std::uint64_t k = 0; k < 8; ++k) {
      const double x = 2.0 + 3.0 * static_cast<double>(k);
      walls.insert(Shape::segment(at(x, 6), at(x, 8)), ItemId{10 + k});
    }
    const Point corner = at(-1e-11 * static_cast<double>(1 + random.below(40)), 5);
    walls.insert(Shape::segment(corner, at(-1, 9)), ItemId{2});
    ASSERT_EQ(walls.bridges().find_fault(walls.mesh()), std::nullopt) << "case " << i;
    for (std::uint32_t h = 0; h < 3 * walls.mesh().topology().face_slots(); ++h) {
      if (!walls.mesh().topology().is_live(mesh::face(HalfEdge{h}))) continue;
      const Point& from =
          walls.mesh().triangulation().geometry().rounded(number(walls.mesh().topology().origin(HalfEdge{h})));
      if (from == corner && walls.bridges().foot_at(HalfEdge{h}) != Bridges::kNone) ++feet;
    }
  }
  EXPECT_GT(feet, 50U);
}

TEST_P(RandomScenes, HaveTheSameBridgesWithTheTree) {
  for (std::uint64_t seed = 0; seed < (case_count() + 3) / 4; ++seed) {
    const Scene scene = random_scene(GetParam(), seed, 4 + seed % 60);
    Walls walls(scene.domain, {1, 0, 1});
    for (const Item& item : scene.items) {
      if (has_walls(item.shape)) walls.insert(item.shape, item.id);
    }
    ASSERT_EQ(walls.bridges().find_fault(walls.mesh()), std::nullopt) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Bridges, RandomScenes, testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

}  // namespace
}  // namespace waywright::test
