#include "waywright/world.hpp"

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

constexpr Box kFour = {{0, 0}, {4, 4}};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

World empty_world(const Box& domain = kFour) { return World::create(domain).value(); }

/// Returns the ids on each constrained edge, as "x0,y0-x1,y1: ids".
std::set<std::string> constraints(const World& world) {
  const MeshSnapshot mesh = world.snapshot();
  const auto text = [](double v) {
    std::string digits = std::to_string(v);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return digits;
  };
  std::set<std::string> result;
  for (const auto& edge : mesh.constraints) {
    const Point p = mesh.vertices[edge.vertices[0]];
    const Point q = mesh.vertices[edge.vertices[1]];
    std::string line = text(p.x) + ',' + text(p.y) + '-' + text(q.x) + ',' + text(q.y) + ':';
    for (std::uint32_t i = 0; i < edge.id_count; ++i) line += ' ' + std::to_string(mesh.ids[edge.first_id + i].value);
    result.insert(line);
  }
  return result;
}

TEST(World, EmptyDumpIsTheBox) {
  EXPECT_EQ(empty_world().dump(),
            "vertices 4\n0 1 0 1\n0 1 4 1\n4 1 0 1\n4 1 4 1\n"
            "triangles 2\n0 2 3\n0 3 1\n"
            "constraints 4\n0 1 0\n0 2 0\n1 3 0\n2 3 0\n");
}

TEST(World, CreateRefusesWhatIsNoDomain) {
  const auto code = [](const Box& box) { return World::create(box).error().code; };
  EXPECT_EQ(code({{0, 0}, {0, 1}}), ErrorCode::bad_domain);
  EXPECT_EQ(code({{0, 1}, {1, 0}}), ErrorCode::bad_domain);
  EXPECT_EQ(code({{0, 0}, {kInfinity, 1}}), ErrorCode::coordinate_range);
  EXPECT_EQ(code({{kNan, 0}, {1, 1}}), ErrorCode::coordinate_range);
  EXPECT_EQ(code({{0, 0}, {0x1p101, 1}}), ErrorCode::coordinate_range);
  EXPECT_TRUE(World::create({{-0x1p100, -0x1p100}, {0x1p100, 0x1p100}}).ok());
}

TEST(World, CrossingSegmentsMeetInAVertex) {
  World world = empty_world();
  ASSERT_TRUE(world.insert_segment({1, 1}, {3, 3}, {5}).ok());
  ASSERT_TRUE(world.insert_segment({1, 3}, {3, 1}, {6}).ok());
  EXPECT_EQ(world.vertex_count(), 9U);
  const std::set<std::string> expected = {"0,0-0,4: 0", "0,0-4,0: 0", "0,4-4,4: 0", "4,0-4,4: 0",
                                          "1,1-2,2: 5", "2,2-3,3: 5", "1,3-2,2: 6", "2,2-3,1: 6"};
  EXPECT_EQ(constraints(world), expected);
  EXPECT_TRUE(world.validate().ok);
}

TEST(World, OverlapsShareTheirEdges) {
  World world = empty_world();
  ASSERT_TRUE(world.insert_segment({0, 2}, {3, 2}, {1}).ok());
  ASSERT_TRUE(world.insert_segment({4, 2}, {1, 2}, {2}).ok());
  ASSERT_TRUE(world.insert_segment({1, 2}, {3, 2}, {3}).ok());
  ASSERT_TRUE(world.insert_segment({2, 0}, {2, 2}, {4}).ok());
  const std::set<std::string> expected = {"0,0-0,2: 0",     "0,2-0,4: 0",     "0,0-2,0: 0", "2,0-4,0: 0",
                                          "0,4-4,4: 0",     "4,0-4,2: 0",     "4,2-4,4: 0", "0,2-1,2: 1",
                                          "1,2-2,2: 1 2 3", "2,2-3,2: 1 2 3", "3,2-4,2: 2", "2,0-2,2: 4"};
  EXPECT_EQ(constraints(world), expected);
  EXPECT_TRUE(world.validate().ok);
}

TEST(World, SidesOnTheDomainBorderShareItsEdges) {
  World world = empty_world();
  ASSERT_TRUE(world.insert_polygon(std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {7}).ok());
  const std::set<std::string> expected = {"0,0-0,4: 0 7", "0,0-4,0: 0 7", "0,4-4,4: 0 7", "4,0-4,4: 0 7"};
  EXPECT_EQ(constraints(world), expected);
  EXPECT_EQ(world.vertex_count(), 4U);
  EXPECT_EQ(world.locate({1, 1}).value().polygons, (std::vector<ItemId>{{7}}));
}

TEST(World, DegeneratePiecesActAsPoints) {
  World world = empty_world();
  ASSERT_TRUE(world.insert_segment({1, 1}, {1, 1}, {1}).ok());
  ASSERT_TRUE(world.insert_polyline(std::vector<Point>{{2, 2}}, {2}).ok());
  ASSERT_TRUE(world.insert_polygon(std::vector<Point>{{3, 3}, {3, 3}, {3, 3}}, {3}).ok());
  ASSERT_TRUE(world.insert_polygon(std::vector<Point>{{1, 3}, {2, 3}, {1, 3}}, {4}).ok());
  EXPECT_EQ(world.vertex_count(), 9U);
  EXPECT_EQ(world.locate({3, 3}).value().polygons, (std::vector<ItemId>{{3}}));
  EXPECT_EQ(world.locate({1.5, 3}).value().polygons, (std::vector<ItemId>{{4}}));
  EXPECT_TRUE(world.locate({1.5, 2.9}).value().polygons.empty());
  EXPECT_EQ(world.shape({1}).value().rings[0].size(), 2U);
  EXPECT_EQ(world.shape({3}).value().rings[0].size(), 1U);
  EXPECT_TRUE(world.validate().ok);
}

TEST(World, RingsThatRepeatTheirFirstPointAtTheEnd) {
  World world = empty_world();
  ASSERT_TRUE(world.insert_polygon(std::vector<Point>{{1, 1}, {3, 1}, {1, 3}, {1, 1}, {1, 1}}, {1}).ok());
  EXPECT_EQ(world.shape({1}).value().rings[0], (std::vector<Point>{{1, 1}, {3, 1}, {1, 3}}));
  // A polyline may end where it starts.
  ASSERT_TRUE(world.insert_polyline(std::vector<Point>{{1, 1}, {3, 1}, {1, 1}, {1, 1}}, {2}).ok());
  EXPECT_EQ(world.shape({2}).value().rings[0], (std::vector<Point>{{1, 1}, {3, 1}, {1, 1}}));
  EXPECT_TRUE(world.validate().ok) << world.validate().fault;
}

TEST(World, LocateReturnsKindVerticesAndPolygons) {
  World world = empty_world();
  const std::vector<std::vector<Point>> rings = {{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
  ASSERT_TRUE(world.insert_polygon(rings, {9}).ok());
  const auto inside = [&](double x, double y) { return world.locate({x, y}).value().polygons; };
  const std::vector<ItemId> nine = {{9}};
  EXPECT_EQ(inside(0.5, 0.25), nine);
  EXPECT_TRUE(inside(1.5, 1.25).empty()) << "in the hole";
  EXPECT_EQ(inside(1, 1.5), nine) << "on the hole's side";
  EXPECT_EQ(inside(3, 3), nine) << "on a corner";
  EXPECT_TRUE(inside(3.5, 1).empty());
  const Location corner = world.locate({2, 1}).value();
  EXPECT_EQ(corner.kind, LocationKind::vertex);
  EXPECT_EQ(corner.vertex_count, 1U);
  EXPECT_EQ(corner.vertices[0], (Point{2, 1}));
  const Location side = world.locate({1.25, 2}).value();
  EXPECT_EQ(side.kind, LocationKind::edge);
  EXPECT_EQ(side.vertex_count, 2U);
  EXPECT_EQ(side.vertices[0], (Point{1, 2}));
  EXPECT_EQ(side.vertices[1], (Point{2, 2}));
  EXPECT_EQ(world.locate({0.5, 0.125}).value().kind, LocationKind::face);
  EXPECT_EQ(world.locate({5, 5}).error().code, ErrorCode::out_of_domain);
  EXPECT_EQ(world.locate({kNan, 5}).error().code, ErrorCode::coordinate_range);
}

TEST(World, RefusedInsertionsChangeNothing) {
  World world = empty_world();
  ASSERT_TRUE(world.insert_point({1, 2}, {3}).ok());
  const std::string before = world.dump();
  const auto expect_refused = [&](const Result<ItemId>& result, ErrorCode code, std::uint64_t index) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, code) << result.error().message();
    EXPECT_EQ(result.error().index, index);
    EXPECT_EQ(world.dump(), before);
  };
  expect_refused(world.insert_point({1, 1}, {3}), ErrorCode::id_in_use, 0);
  expect_refused(world.insert_point({1, 1}, {ItemId::kLargest + 1}), ErrorCode::bad_id, 0);
  expect_refused(world.insert_segment({1, 1}, {5, 1}), ErrorCode::out_of_domain, 1);
  expect_refused(world.insert_segment({kInfinity, 1}, {5, 1}), ErrorCode::coordinate_range, 0);
  expect_refused(world.insert_segment({1, 1}, {1, 0x1p-101}), ErrorCode::coordinate_range, 1);
  expect_refused(world.insert_polyline({}), ErrorCode::bad_shape, 0);
  expect_refused(world.insert_polygon(std::vector<std::vector<Point>>{{{1, 1}}, {}}), ErrorCode::bad_shape, 0);
  expect_refused(world.insert({ItemKind::segment, {{{1, 1}}}}), ErrorCode::bad_shape, 0);
  expect_refused(world.insert({ItemKind::point, {{{1, 1}}, {{2, 2}}}}), ErrorCode::bad_shape, 0);
  expect_refused(world.insert({static_cast<ItemKind>(77), {{{1, 1}}}}), ErrorCode::bad_shape, 0);
  Shape shape = Shape::polygon({{1, 1}, {2, 1}, {2, 2}});
  shape.fill = static_cast<FillRule>(9);
  expect_refused(world.insert(shape), ErrorCode::bad_shape, 0);
  Change change = Change::insert(Shape::point({1, 1}));
  change.kind = static_cast<Change::Kind>(9);
  EXPECT_EQ(world.apply({change}).error().code, ErrorCode::bad_shape);
  expect_refused(world.insert_polygon(std::vector<std::vector<Point>>{{{1, 1}, {2, 2}}, {{kNan, 1}}}),
                 ErrorCode::coordinate_range, 2);
  EXPECT_EQ(world.item_count(), 1U);
}

TEST(World, RefusalsSayWhichPointIsWrongAndWhereItLies) {
  World world = World::create({{0, 0}, {10, 10}}).value();
  const auto message = [](const auto& result) { return result.error().message(); };
  EXPECT_EQ(message(World::create({{0, 0}, {1e40, 1}})), "x of the domain's max, 1e+40, lies beyond +-2^100");
  EXPECT_EQ(message(world.insert_segment({1, 2}, {11, 2.5})),
            "point 1, (11, 2.5), lies outside the domain, (0, 0) to (10, 10)");
  EXPECT_EQ(message(world.insert_point({1, 0x1p-101})),
            "y of point 0, 3.944304526105059e-31, is nearer to 0 than 2^-100 without being 0");
  EXPECT_EQ(message(world.locate({kNan, 5})), "x of the point, nan, is not finite");
  EXPECT_EQ(message(world.ray({1, 1}, {-3, 1})), "the end, (-3, 1), lies outside the domain, (0, 0) to (10, 10)");
  EXPECT_EQ(message(world.find_path({.start = {1, 1}, .goal = {1, 12}})),
            "the goal, (1, 12), lies outside the domain, (0, 0) to (10, 10)");
  const std::vector<Item> items{{{1}, {ItemKind::point, {{{1, 1}}}}}, {{1}, {ItemKind::point, {{{2, 2}}}}}};
  EXPECT_EQ(message(world.insert_all(items)), "item 1: an item has id 1 already");
}

TEST(World, HandsOutIdsAfterTheLargestSeen) {
  World world = empty_world();
  EXPECT_EQ(world.insert_point({1, 1}).value(), ItemId{1});
  EXPECT_EQ(world.insert_point({1, 1}, {40}).value(), ItemId{40});
  EXPECT_EQ(world.insert_point({1, 1}).value(), ItemId{41});
  EXPECT_EQ(world.item_ids(), (std::vector<ItemId>{{1}, {40}, {41}}));
  EXPECT_TRUE(world.contains({40}));
  EXPECT_FALSE(world.contains({2}));
  EXPECT_EQ(world.shape({2}).error().code, ErrorCode::unknown_id);
}

TEST(World, NegativeZeroIsZero) {
  World world = empty_world({{-0.0, -0.0}, {4, 4}});
  ASSERT_TRUE(world.insert_segment({-0.0, 2}, {2, -0.0}).ok());
  const Point corner = world.shape({1}).value().rings[0][0];
  EXPECT_FALSE(std::signbit(corner.x));
  EXPECT_EQ(world.vertex_count(), 6U);
  EXPECT_TRUE(world.validate().ok);
}

TEST(World, TrianglesCoverTheDomain) {
  World world = empty_world();
  ASSERT_TRUE(world.insert_segment({0.5, 0.5}, {3.5, 2.5}).ok());
  ASSERT_TRUE(world.insert_segment({0.5, 2.5}, {3.5, 0.25}).ok());
  const MeshSnapshot mesh = world.snapshot();
  EXPECT_EQ(mesh.vertices.size(), world.vertex_count());
  EXPECT_EQ(mesh.triangles.size(), world.triangle_count());
  double area = 0.0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Point a = mesh.vertices[i], b = mesh.vertices[j], c = mesh.vertices[k];
    area += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  EXPECT_NEAR(area, 16.0, 1e-12);
}

// The lines x = 3 y, 2 x + 7 y = 14, x + 10 y = 14 and 3 x + 4 y = 14 all run through (42/13, 14/13), which is not a
// pair of doubles.
TEST(World, ManySegmentsThroughOneConstructedPoint) {
  World world = empty_world({{-100, -100}, {100, 100}});
  ASSERT_TRUE(world.insert_segment({0, 0}, {9, 3}).ok());
  ASSERT_TRUE(world.insert_segment({0, 2}, {7, 0}).ok());
  EXPECT_EQ(world.vertex_count(), 9U);
  ASSERT_TRUE(world.insert_segment({24, -1}, {-6, 2}).ok());
  ASSERT_TRUE(world.insert_segment({6, -1}, {-2, 5}).ok());
  EXPECT_EQ(world.vertex_count(), 13U);
  EXPECT_NE(world.dump().find("\n42 13 14 13\n"), std::string::npos);
  EXPECT_TRUE(world.validate().ok);
}

}  // namespace
}  // namespace waywright::test
