#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "waywright/scene.hpp"
#include "waywright/script.hpp"

namespace waywright {
namespace {

TEST(ToScript, WritesOneLineAnItem) {
  const Scene scene{.domain = {{-1, -0.0}, {10, 0.1}},
                    .items = {{{3}, {ItemKind::point, {{{1, 2}}}}},
                              {{1}, {ItemKind::segment, {{{1, 2}, {3, 4.5}}}}},
                              {{2}, {ItemKind::polyline, {{{1, 2}, {3, 4}, {-0.0, 6}}}}},
                              {{7}, {ItemKind::polygon, {{{0, 0}, {9, 0}, {0, 9}}, {{1, 1}}}}},
                              {{8}, {ItemKind::polygon, {{{0, 0}, {9, 0}}, {{1, 1}}}, FillRule::nonzero}}},
                    .y_down = true};
  EXPECT_EQ(to_script(scene),
            "waywright 1\n"
            "domain -1 0 10 0.1\n"
            "point 3 1 2\n"
            "segment 1 1 2 3 4.5\n"
            "polyline 2 3 1 2 3 4 0 6\n"
            "polygon 7 3 0 0 9 0 0 9 / 1 1 1\n"
            "polygon 8 nonzero 2 0 0 9 0 / 1 1 1\n");
}

TEST(ToScript, WritesAnEmptyScene) {
  EXPECT_EQ(to_script(Scene{.domain = {{0, 0}, {1, 1}}, .items = {}}), "waywright 1\ndomain 0 0 1 1\n");
}

rc::Gen<double> any_coordinate() {
  return rc::gen::map(rc::gen::pair(rc::gen::inRange<std::int64_t>(-(std::int64_t{1} << 53), std::int64_t{1} << 53),
                                    rc::gen::inRange(-60, 40)),
                      [](const std::pair<std::int64_t, int>& parts) {
                        return std::ldexp(static_cast<double>(parts.first), parts.second);
                      });
}

rc::Gen<Point> any_point() { return rc::gen::construct<Point>(any_coordinate(), any_coordinate()); }

std::vector<Point> any_ring(ItemKind kind) {
  if (kind == ItemKind::point) return *rc::gen::container<std::vector<Point>>(1, any_point());
  if (kind == ItemKind::segment) return *rc::gen::container<std::vector<Point>>(2, any_point());
  return *rc::gen::nonEmpty(rc::gen::container<std::vector<Point>>(any_point()));
}

RC_GTEST_PROP(ToScript, ReadsBackAsTheSameScene, ()) {
  // Every coordinate above is smaller than 2^93 in absolute value.
  Scene scene{.domain = {{-0x1p93, -0x1p93}, {0x1p93, 0x1p93}}, .items = {}};
  const auto ids = *rc::gen::unique<std::vector<std::uint64_t>>(
      rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t id) { return id % ItemId::kLargest + 1; }));
  for (const std::uint64_t id : ids) {
    Item item{{id}, {}};
    item.shape.kind = *rc::gen::element(ItemKind::point, ItemKind::segment, ItemKind::polyline, ItemKind::polygon);
    const int rings = item.shape.kind == ItemKind::polygon ? *rc::gen::inRange(1, 4) : 1;
    for (int i = 0; i < rings; ++i) item.shape.rings.push_back(any_ring(item.shape.kind));
    if (item.shape.kind == ItemKind::polygon)
      item.shape.fill = *rc::gen::element(FillRule::even_odd, FillRule::nonzero);
    scene.items.push_back(std::move(item));
  }
  const Result<Script> script = parse_script(to_script(scene), "printed.wws");
  RC_ASSERT(script.ok());
  RC_ASSERT(scene_of(*script) == scene);
}

}  // namespace
}  // namespace waywright
