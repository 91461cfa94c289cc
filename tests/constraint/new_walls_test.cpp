#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/item.hpp"

#include "constraint/constrained_triangulation.hpp"
#include "mesh/triangle_mesh.hpp"
#include "support/case_count.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using constraint::ConstrainedTriangulation;

constexpr double kDomainSize = 8;

class NewWalls : public ::testing::Test {
 protected:
  void insert(const Shape& shape) {
    mesh_.insert(shape, ItemId{++last_id_});
    live_.push_back(ItemId{last_id_});
  }
  void remove(std::size_t index) {
    mesh_.remove(live_[index]);
    live_.erase(live_.begin() + static_cast<std::ptrdiff_t>(index));
  }
  /// Inserts the shapes as one operation. Returns what the triangulation says at its end.
  bool may_divide(const std::vector<Shape>& shapes) {
    ConstrainedTriangulation::UndoGuard operation(mesh_);
    for (const Shape& shape : shapes) insert(shape);
    operation.commit();
    return mesh_.may_have_divided();
  }
  bool may_divide(const Shape& shape) { return may_divide(std::vector{shape}); }

  /// The number of the region of each sample. The samples lie in the cells of the lattice, off its lines and diagonals.
  [[nodiscard]] std::vector<std::size_t> regions() const {
    std::vector<std::size_t> region_of(mesh_.topology().face_slots(), 0);
    std::size_t count = 0;
    std::vector<std::size_t> result;
    for (double x = 0.3183; x < kDomainSize; x += 0.5) {
      for (double y = 0.4142; y < kDomainSize; y += 0.5) {
        const mesh::Face f = mesh::face(mesh_.triangulation().locate({x, y}).h);
        if (region_of[number(f)] == 0) flood(f, ++count, region_of);
        result.push_back(region_of[number(f)]);
      }
    }
    return result;
  }

  ConstrainedTriangulation mesh_{{{0, 0}, {kDomainSize, kDomainSize}}};
  std::vector<ItemId> live_;

 private:
  void flood(mesh::Face start, std::size_t region, std::vector<std::size_t>& region_of) const {
    const mesh::TriangleMesh& mesh = mesh_.topology();
    std::vector<mesh::Face> found = {start};
    region_of[number(start)] = region;
    while (!found.empty()) {
      const mesh::Face f = found.back();
      found.pop_back();
      for (std::uint32_t i = 0; i < 3; ++i) {
        const mesh::HalfEdge h{3 * number(f) + i};
        const mesh::Face other = mesh::face(mesh.twin(h));
        if (mesh.is_fixed(h) || region_of[number(other)] != 0) continue;
        region_of[number(other)] = region;
        found.push_back(other);
      }
    }
  }

  std::uint64_t last_id_ = 0;
};

bool is_divided(const std::vector<std::size_t>& before, const std::vector<std::size_t>& after) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (before[i] == before[k] && after[i] != after[k]) return true;
    }
  }
  return false;
}

TEST_F(NewWalls, AWallInOpenSpaceDividesNothing) {
  EXPECT_FALSE(may_divide(Shape::segment({1, 1}, {3, 2})));
  EXPECT_FALSE(may_divide(Shape::polyline({{4, 4}, {5, 4}, {5, 5}, {4, 5}})));
}

TEST_F(NewWalls, AWallThatTouchesOneWallOnceDividesNothing) {
  EXPECT_FALSE(may_divide(Shape::segment({1, 4}, {7, 4})));
  EXPECT_FALSE(may_divide(Shape::segment({2, 2}, {2, 6})));  // crosses it
  EXPECT_FALSE(may_divide(Shape::segment({3, 6}, {3, 4})));  // ends on it
}

TEST_F(NewWalls, AClosedWallMayDivide) {
  EXPECT_TRUE(may_divide(Shape::polygon({{1, 1}, {2, 1}, {2, 2}, {1, 2}})));
  EXPECT_TRUE(may_divide(Shape::polyline({{4, 4}, {5, 4}, {5, 5}, {4, 4}})));
}

TEST_F(NewWalls, AWallThatCrossesItselfMayDivide) {
  EXPECT_TRUE(may_divide(Shape::polyline({{1, 1}, {5, 1}, {5, 5}, {2, 0.5}})));
}

TEST_F(NewWalls, NewWallsThatMeetTwiceMayDivide) {
  // They share a corner and cross.
  EXPECT_TRUE(may_divide({Shape::segment({1, 1}, {5, 1}), Shape::polyline({{1, 1}, {2, 3}, {4, 0.5}})}));
  // They share a corner, and another corner of the second one lies on the first one.
  EXPECT_TRUE(may_divide({Shape::segment({1, 6}, {5, 6}), Shape::polyline({{3, 6}, {2, 7}, {1, 6}})}));
}

TEST_F(NewWalls, AWallBetweenTwoWallsMayDivide) {
  EXPECT_FALSE(may_divide(Shape::segment({2, 1}, {2, 7})));
  EXPECT_FALSE(may_divide(Shape::segment({5, 1}, {5, 7})));
  EXPECT_TRUE(may_divide(Shape::segment({2, 3}, {5, 3})));
  EXPECT_TRUE(may_divide(Shape::segment({0, 5}, {2, 5})));  // between the border of the domain and a wall
}

TEST_F(NewWalls, AnExistingEdgeIsNoNewWall) {
  EXPECT_TRUE(may_divide(Shape::polygon({{1, 1}, {2, 1}, {2, 2}, {1, 2}})));
  EXPECT_FALSE(may_divide(Shape::polygon({{1, 1}, {2, 1}, {2, 2}, {1, 2}})));
}

TEST_F(NewWalls, RandomWallsThatDivideAreNeverMissed) {
  std::size_t divided = 0;
  std::size_t told_apart = 0;
  for (std::uint64_t seed = 0; seed < 4 * case_count(); ++seed) {
    Random random(seed);
    const auto coordinate = [&] {
      return static_cast<double>(random.below(static_cast<std::size_t>(kDomainSize) + 1));
    };
    const auto corner = [&] { return Point{coordinate(), coordinate()}; };
    mesh_ = ConstrainedTriangulation{{{0, 0}, {kDomainSize, kDomainSize}}};
    live_.clear();
    for (int step = 0; step < 5; ++step) {
      const std::vector<std::size_t> before = regions();
      ConstrainedTriangulation::UndoGuard operation(mesh_);
      for (std::size_t i = 0; i <= random.below(3); ++i) {
        if (!live_.empty() && random.chance(30)) remove(random.below(live_.size()));
        std::vector<Point> corners(2 + random.below(4));
        for (Point& p : corners) p = corner();
        insert(random.chance(15) ? Shape::polygon(corners) : Shape::polyline(corners));
      }
      operation.commit();
      const bool is = is_divided(before, regions());
      divided += is ? 1 : 0;
      told_apart += mesh_.may_have_divided() ? 0 : 1;
      EXPECT_TRUE(mesh_.may_have_divided() || !is) << "seed " << seed << ", step " << step;
    }
  }
  EXPECT_GT(divided, 0U);
  EXPECT_GT(told_apart, 0U);
}

}  // namespace
}  // namespace waywright::test
