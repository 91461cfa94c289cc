#include "world/ellipse_bucket.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace waywright::test {
namespace {

Point random_point(Random& random) {
  return {static_cast<double>(random.below(100000)) / 1000.0, static_cast<double>(random.below(100000)) / 1000.0};
}

double distance_to_box(const Point& p, const Box& box) {
  const Point nearest{std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)};
  return distance(p, nearest);
}

// More ellipses than one word of lanes has bits, and a number that is no multiple of the lanes of a block.
TEST(EllipseBucket, VisitsEachEllipseThatABoxMeets) {
  constexpr std::uint32_t kCount = 203;
  const Box domain{{0.0, 0.0}, {100.0, 100.0}};
  Random random(11);
  EllipseBucket bucket(domain);
  std::vector<Ellipse> ellipses;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const Point start = random_point(random);
    const Point goal = random_point(random);
    const double length = distance(start, goal) * (1.0 + static_cast<double>(random.below(100)) / 100.0);
    ellipses.push_back({start, goal, length * (1.0 + 0x1p-40), 0.0});
    bucket.add(domain, {ellipses.back(), 1000 + i}, i);
  }
  for (int query = 0; query < 300; ++query) {
    const Point low = random_point(random);
    const Box box =
        Box::bounding(std::vector<Point>{low, {std::min(low.x + 3.0, 100.0), std::min(low.y + 2.0, 100.0)}});
    std::vector<bool> is_visited(kCount);
    bucket.for_each_overlapping(box, [&](std::uint32_t slot) {
      ASSERT_GE(slot, 1000U);
      ASSERT_LT(slot, 1000U + kCount);
      ASSERT_FALSE(is_visited[slot - 1000]);
      is_visited[slot - 1000] = true;
    });
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const Ellipse& ellipse = ellipses[i];
      const Point middle = 0.5 * (box.min + box.max);
      if (distance(middle, ellipse.start) + distance(middle, ellipse.goal) <= ellipse.length) {
        ASSERT_TRUE(is_visited[i]) << i;
      }
      const double least = distance_to_box(ellipse.start, box) + distance_to_box(ellipse.goal, box);
      if (least > ellipse.length * 1.000001) {
        ASSERT_FALSE(is_visited[i]) << i;
      }
    }
  }
}

// The ellipse of a straight path is a segment, apart from rounding errors.
TEST(EllipseBucket, VisitsTheEllipseOfAStraightPathAtEachPositionOfThePath) {
  const Box domain{{0.0, 0.0}, {100.0, 100.0}};
  Random random(12);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    EllipseBucket bucket(domain);
    const Point start = random_point(random);
    const Point goal = i % 3 == 0 ? start + Point{1e-3, 1e-4} * static_cast<double>(i % 7) : random_point(random);
    bucket.add(domain, {{start, goal, distance(start, goal) * (1.0 + 0x1p-30), 0.0}, i}, i);
    const double share = static_cast<double>(random.below(1000)) / 1000.0;
    for (const double t : {0.0, share, share * 0x1p-10, 1.0 - share * 0x1p-10, share * 0x1p-20, 1.0}) {
      const Point p = lerp(start, goal, t);
      std::uint32_t visited = 0;
      bucket.for_each_overlapping({p, p}, [&](std::uint32_t) { ++visited; });
      ASSERT_EQ(visited, 1U) << "ellipse " << i << " at the share " << t;
    }
  }
}

}  // namespace
}  // namespace waywright::test
