#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "constraint/batch.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "mesh/triangle_mesh.hpp"
#include "support/random.hpp"
#include "threads/thread_team.hpp"

// A bulk load of sides by several threads. The scenes are large enough for many regions.

namespace waywright::test {
namespace {

using constraint::ConstrainedTriangulation;

constexpr double kSize = 256;

/// Short sides of every kind: some are edges, some cross free edges, some cross each other, overlap, repeat or pass
/// through corners. Coordinates are multiples of `unit`; a large unit makes many ties. `long_sides` items cross the
/// domain.
std::vector<Item> sides(std::uint64_t seed, double unit, std::size_t count, std::size_t long_sides) {
  Random random(seed);
  const auto below = [&](double size) {
    return unit * static_cast<double>(random.below(static_cast<std::size_t>(size / unit)));
  };
  std::vector<Item> items;
  while (items.size() < count) {
    const bool is_long = items.size() < long_sides;
    const double reach = is_long ? kSize / 2 : 4;
    const Point at{below(kSize - reach), below(kSize - reach)};
    const auto near = [&] { return Point{at.x + below(reach), at.y + below(reach)}; };
    const ItemId id{items.size() + 1};
    switch (random.below(4)) {
      case 0:
        items.push_back({id, {ItemKind::point, {{at}}}});
        break;
      case 1:
        items.push_back({id, {ItemKind::polygon, {{near(), near(), near(), near()}}}});
        break;
      case 2:
        items.push_back({id, {ItemKind::polyline, {{at, near(), near()}}}});
        break;
      default:
        items.push_back({id, Shape::segment(at, near())});
    }
  }
  return items;
}

ConstrainedTriangulation load(const std::vector<Item>& items, std::size_t threads) {
  std::vector<ItemId> ids;
  for (const Item& item : items) ids.push_back(item.id);
  return ConstrainedTriangulation({{0, 0}, {kSize, kSize}}, constraint::ShapeBatch{items, ids},
                                  threads::ThreadTeam(threads, {}));
}

/// The vertices, twins and labels of all half-edges.
std::vector<std::uint32_t> raw(const mesh::TriangleMesh& mesh) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
    const mesh::HalfEdge h{i};
    numbers.insert(numbers.end(), {number(mesh.origin(h)), number(mesh.twin(h)), mesh.label(h)});
  }
  return numbers;
}

struct Case {
  double unit;
  std::size_t count;
  std::size_t long_sides;
};

constexpr Case kCases[] = {{0x1p-30, 9000, 0}, {0x1p-30, 6000, 6}, {0.5, 6000, 2}, {1, 20000, 0}};

TEST(BulkSides, AreTheSameMeshWithAnyNumberOfThreads) {
  for (const Case& scene : kCases) {
    const std::vector<Item> items = sides(scene.count, scene.unit, scene.count, scene.long_sides);
    const ConstrainedTriangulation alone = load(items, 1);
    EXPECT_EQ(alone.find_fault().value_or(""), "") << scene.unit;
    const std::vector<std::uint32_t> expected = raw(alone.topology());
    for (const std::size_t threads : {2U, 5U}) {
      EXPECT_EQ(raw(load(items, threads).topology()), expected) << scene.unit << ", " << threads << " threads";
    }
  }
}

TEST(BulkSides, MakeTheMeshOfSingleInsertions) {
  for (const Case& scene : kCases) {
    const std::vector<Item> items = sides(7 * scene.count, scene.unit, scene.count / 2, scene.long_sides);
    World at_once = World::create({{0, 0}, {kSize, kSize}}).value();
    World one_by_one = World::create({{0, 0}, {kSize, kSize}}).value();
    at_once.insert_all(items, {3, {}}).value();
    for (const Item& item : items) one_by_one.insert(item.shape, item.id).value();
    EXPECT_EQ(at_once.dump(), one_by_one.dump()) << scene.unit;
  }
}

}  // namespace
}  // namespace waywright::test
