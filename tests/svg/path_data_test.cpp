#include "svg/path_data.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/point.hpp"

namespace waywright::svg {
namespace {

const Box kBox{{0, 0}, {10, 6}};

bool is_in_box(const Point& p) {
  return p.x >= kBox.min.x && p.x <= kBox.max.x && p.y >= kBox.min.y && p.y <= kBox.max.y;
}

TEST(ClipSegment, CutsWhatCrossesTheBox) {
  Point a{-5, 3};
  Point b{15, 3};
  EXPECT_TRUE(clip_segment(kBox, a, b));
  EXPECT_EQ(a, (Point{0, 3}));
  EXPECT_EQ(b, (Point{10, 3}));

  a = {-2, 4};  // falls by 1 for each 1 to the right: enters at (0, 2), leaves at (2, 0)
  b = {4, -2};
  EXPECT_TRUE(clip_segment(kBox, a, b));
  EXPECT_EQ(a, (Point{0, 2}));
  EXPECT_EQ(b, (Point{2, 0}));
}

TEST(ClipSegment, LeavesWhatIsInsideAsItIs) {
  Point a{0.1, 0.3};
  Point b{9.7, 6};
  EXPECT_TRUE(clip_segment(kBox, a, b));
  EXPECT_EQ(a, (Point{0.1, 0.3}));
  EXPECT_EQ(b, (Point{9.7, 6}));
}

TEST(ClipSegment, RefusesWhatMissesTheBox) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<Point>> misses{{{-1, 0}, {-1, 6}},         {{11, -3}, {30, 9}},
                                               {{-4, 3}, {3, -4}},  // the last passes a corner
                                               {{7, 7}, {7, 7}},           {{0, NAN}, {1, 1}},
                                               {{1, 1}, {infinity, 1}},  // a point, and coordinates that are not finite
                                               {{1, 1}, {1, NAN}},         {{-infinity, 3}, {infinity, 3}},
                                               {{-1e308, 3}, {1e308, NAN}}};
  for (const auto& ends : misses) {
    Point a = ends[0];
    Point b = ends[1];
    EXPECT_FALSE(clip_segment(kBox, a, b)) << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y;
  }
}

TEST(ClipSegment, KeepsThePointsThatAreInTheBox) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-12.0, 22.0);
  int cut = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point from{anywhere(random), anywhere(random)};
    const Point to{anywhere(random), anywhere(random)};
    Point a = from;
    Point b = to;
    const bool meets = clip_segment(kBox, a, b);
    cut += meets && a != from ? 1 : 0;
    // Samples of the segment lie in the box exactly where the clipped piece lies, except close to its ends.
    for (int k = 0; k <= 100; ++k) {
      const double part = k / 100.0;
      const Point p{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
      const double along = meets ? std::abs(a.x - from.x) / std::abs(to.x - from.x) : 2.0;
      const double until = meets ? std::abs(b.x - from.x) / std::abs(to.x - from.x) : -1.0;
      if (std::abs(part - along) < 1e-9 || std::abs(part - until) < 1e-9) continue;
      ASSERT_EQ(is_in_box(p), part > along && part < until) << i << ' ' << part;
    }
  }
  EXPECT_GT(cut, 100);
}

/// Returns the winding number of the rings around `p`, from the sides that a ray from `p` to the right crosses.
int winding_number(const std::vector<std::vector<Point>>& rings, const Point& p) {
  int winding = 0;
  for (const std::vector<Point>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& a = ring[i];
      const Point& b = ring[(i + 1) % ring.size()];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) winding += b.y > a.y ? 1 : -1;
    }
  }
  return winding;
}

TEST(ClipRing, KeepsTheWindingNumberOfRingsThatCrossThemselvesAndOneAnother) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> anywhere(-20.0, 30.0);
  std::uniform_real_distribution<double> part(0.001, 0.999);
  int inside_count = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<std::vector<Point>> rings(2);
    for (auto& ring : rings) {
      for (int k = 0; k < 7; ++k) ring.push_back({anywhere(random), anywhere(random)});
    }
    std::vector<std::vector<Point>> cut = rings;
    std::vector<Point> scratch;
    for (auto& ring : cut) {
      clip_ring(kBox, ring, scratch);
      for (const Point& p : ring) ASSERT_TRUE(is_in_box(p)) << p.x << ' ' << p.y;
    }
    for (int k = 0; k < 30; ++k) {
      const Point p{10 * part(random), 6 * part(random)};
      const int before = winding_number(rings, p);
      inside_count += before != 0 ? 1 : 0;
      ASSERT_EQ(winding_number(cut, p), before) << i;
    }
  }
  EXPECT_GT(inside_count, 1000);
}

TEST(ClipRing, LeavesNothingOfARingBesideTheBoxAndAllOfOneInside) {
  std::vector<Point> scratch;
  std::vector<Point> beside{{11, 0}, {14, 0}, {12, 5}};
  clip_ring(kBox, beside, scratch);
  EXPECT_TRUE(beside.empty());

  const std::vector<Point> inside{{1, 1}, {10, 1}, {3.3, 5.9}};
  std::vector<Point> ring = inside;
  clip_ring(kBox, ring, scratch);
  EXPECT_EQ(ring, inside);

  std::vector<Point> around{{-5, -5}, {50, -5}, {50, 50}, {-5, 50}};
  clip_ring(kBox, around, scratch);
  EXPECT_EQ(around.size(), 4U);
}

}  // namespace
}  // namespace waywright::svg
