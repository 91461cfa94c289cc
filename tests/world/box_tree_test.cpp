#include "world/box_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "world/ellipse_bucket.hpp"
#include "world/piece_bucket.hpp"

namespace waywright::test {
namespace {

// Boxes of all sizes, some beyond the domain, compared with a plain list.
TEST(BoxTree, FindsTheBoxesThatAListFinds) {
  Random random(4);
  const Box domain{{-10, 0}, {90, 50}};
  BoxTree<PieceBucket> tree(domain);
  std::map<BoxTree<PieceBucket>::Handle, std::pair<Box, std::uint32_t>> boxes;
  const auto random_box = [&] {
    const double size = 200.0 / static_cast<double>(std::size_t{1} << random.below(16));
    const Point at{static_cast<double>(random.between(-20, 100)), static_cast<double>(random.between(-10, 60))};
    return Box{at, at + Point{size * 0.25 * static_cast<double>(random.below(5)), size}};
  };
  std::size_t found = 0;
  std::size_t most = 0;
  for (int i = 0; i < 20000; ++i) {
    if (boxes.size() < 20 || random.chance(i / 2000 % 2 == 0 ? 70 : 30)) {
      const Box box = random_box();
      const auto number = static_cast<std::uint32_t>(i);
      const auto handle = tree.insert(box, {number, 0, Diagonal::none});
      ASSERT_TRUE(boxes.emplace(handle, std::pair(box, number)).second);
    } else {
      const auto any = std::next(boxes.begin(), static_cast<std::ptrdiff_t>(random.below(boxes.size())));
      tree.remove(any->first);
      boxes.erase(any);
    }
    if (i % 10 != 0) continue;
    const Box asked = random_box();
    std::vector<std::uint32_t> numbers;
    tree.for_each_overlapping(asked, [&](const Piece& piece, const Box& box) {
      numbers.push_back(piece.slot);
      EXPECT_TRUE(box.overlaps(asked));
    });
    std::sort(numbers.begin(), numbers.end());
    std::vector<std::uint32_t> expected;
    for (const auto& [handle, entry] : boxes) {
      if (entry.first.overlaps(asked)) expected.push_back(entry.second);
    }
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(numbers, expected) << "step " << i;
    found += numbers.size();
    most = std::max(most, boxes.size());
  }
  EXPECT_GT(found, 1000U);
  EXPECT_GT(most, 500U);
}

// The domains lie near (0, 0) and far away, and are small and large.
const std::vector<Box> kDomains = {{{0, 0}, {100, 100}},
                                   {{500'000, 4'600'000}, {500'100, 4'600'050}},
                                   {{0x1p40, 0x1p40}, {0x1p40 + 1, 0x1p40 + 2}},
                                   {{-0x1p90, -0x1p90}, {0x1p90, 0x1p90}},
                                   {{0x1p-80, 0x1p-80}, {0x1p-79, 0x1p-79}}};

/// Positions in a domain, often on a lattice, so that lines and boxes touch.
Point random_point(Random& random, const Box& domain) {
  const auto share = [&] {
    return random.chance(50) ? static_cast<double>(random.below(17)) / 16
                             : static_cast<double>(random.below(1U << 30)) * 0x1p-30;
  };
  return domain.min + Point{domain.width() * share(), domain.height() * share()};
}

Box random_box(Random& random, const Box& domain) {
  const Point a = random_point(random, domain);
  const Point size = random_point(random, domain) - domain.min;
  const double share = random.chance(50) ? 0x1p-6 : 1.0;
  return {a, {std::min(a.x + size.x * share, domain.max.x), std::min(a.y + size.y * share, domain.max.y)}};
}

// The segment has positions at equal distances. If one of them lies in the box, the bucket must visit the segment.
TEST(PieceBucket, MissesNoDiagonalThatMeetsABox) {
  Random random(7);
  std::size_t met = 0;
  std::size_t visited = 0;
  std::size_t overlapping = 0;
  for (const Box& domain : kDomains) {
    PieceBucket bucket(domain);
    std::vector<std::pair<Point, Point>> segments;
    for (std::uint32_t i = 0; i < 500; ++i) {
      const Point a = random_point(random, domain);
      const Point b = random_point(random, domain);
      Box box{a, a};
      box.expand(b);
      const bool rises = (a.x <= b.x) == (a.y <= b.y);
      bucket.add(box, {i, 0, rises ? Diagonal::rising : Diagonal::falling}, i);
      segments.emplace_back(a, b);
    }
    for (int i = 0; i < 100; ++i) {
      const Box asked = random_box(random, domain);
      std::vector<bool> is_visited(segments.size());
      bucket.for_each_overlapping(asked, [&](const Piece& piece, const Box&) { is_visited[piece.slot] = true; });
      for (std::size_t k = 0; k < segments.size(); ++k) {
        const auto& [a, b] = segments[k];
        bool meets = false;
        for (int step = 0; step <= 256; ++step) {
          const Point p = step == 256 ? b : a + step / 256.0 * (b - a);
          meets = meets || asked.contains(p);
        }
        Box box{a, a};
        box.expand(b);
        ASSERT_TRUE(!meets || is_visited[k]);
        met += meets ? 1 : 0;
        visited += is_visited[k] ? 1 : 0;
        overlapping += box.overlaps(asked) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(met, 10'000U);
  EXPECT_LT(visited, overlapping * 9 / 10) << "the bucket leaves out diagonals that miss the box";
}

// The domain is small and far from (0, 0). Coordinates there have an error of up to 2^-45 times their magnitude, here
// 2^-5. The box is nearer than this error to the diagonal.
TEST(PieceBucket, MissesNoDiagonalThatIsARoundingErrorAway) {
  const Box domain{{0x1p40, 0x1p40}, {0x1p40 + 256, 0x1p40 + 256}};
  const Point middle = 0.5 * (domain.min + domain.max);
  for (const Diagonal diagonal : {Diagonal::rising, Diagonal::falling}) {
    PieceBucket bucket(domain);
    bucket.add(domain, {3, 0, diagonal}, 0);
    const Point near = middle + Point{0x1p-6, diagonal == Diagonal::rising ? -0x1p-6 : 0x1p-6};
    std::size_t visited = 0;
    bucket.for_each_overlapping({near, near}, [&](const Piece&, const Box&) { ++visited; });
    EXPECT_EQ(visited, 1U);
    const Point far = middle + Point{16, diagonal == Diagonal::rising ? -16.0 : 16.0};
    bucket.for_each_overlapping({far, far}, [&](const Piece&, const Box&) { ++visited; });
    EXPECT_EQ(visited, 1U) << "the bucket leaves out a diagonal that is clearly elsewhere";
  }
}

// Samples positions of the box. If one of them, or of the box widened by the reach, lies in an ellipse, the bucket must
// visit the ellipse. It must leave out ellipses that lie clearly beyond the box.
TEST(EllipseBucket, MissesNoEllipseThatMeetsABox) {
  Random random(8);
  std::size_t met = 0;
  std::size_t visited = 0;
  std::size_t missed = 0;
  for (const Box& domain : kDomains) {
    EllipseBucket bucket(domain);
    std::vector<Ellipse> ellipses;
    for (std::uint32_t i = 0; i < 500; ++i) {
      Ellipse ellipse;
      ellipse.start = random_point(random, domain);
      ellipse.goal = random_point(random, domain);
      const double stretch = 1.0 + 0.25 * static_cast<double>(random.below(4));
      ellipse.length = distance(ellipse.start, ellipse.goal) * stretch * (1.0 + 0x1p-30);
      if (i % 50 == 0) ellipse.length = std::numeric_limits<double>::infinity();
      if (i % 3 == 0) ellipse.reach = 0.05 * domain.width();
      const double half = 0.5 * ellipse.length + ellipse.reach;
      const Point centre = 0.5 * (ellipse.start + ellipse.goal);
      const Box bounds = i % 50 == 0 ? Box{domain.min, domain.max} : Box{centre, centre}.expanded(half);
      bucket.add(bounds, {ellipse, i}, i);
      ellipses.push_back(ellipse);
    }
    for (int i = 0; i < 100; ++i) {
      const Box asked = random_box(random, domain);
      std::vector<bool> is_visited(ellipses.size());
      bucket.for_each_overlapping(asked, [&](std::uint32_t slot) { is_visited[slot] = true; });
      for (std::size_t k = 0; k < ellipses.size(); ++k) {
        const Ellipse& ellipse = ellipses[k];
        double least = std::numeric_limits<double>::infinity();
        for (int sample = 0; sample < 25; ++sample) {
          const Point p = asked.min + Point{asked.width() * (sample % 5) / 4.0, asked.height() * (sample / 5) / 4.0};
          least = std::min(least, distance(p, ellipse.start) + distance(p, ellipse.goal));
        }
        const double size = distance(asked.min, asked.max) + 4.0 * ellipse.reach;
        met += least <= ellipse.length ? 1 : 0;
        visited += is_visited[k] ? 1 : 0;
        ASSERT_TRUE(is_visited[k] || least > ellipse.length);
        const bool is_beyond = least > ellipse.length + 2.0 * size + 1e-9 * ellipse.length;
        ASSERT_FALSE(is_beyond && is_visited[k]);
        missed += is_beyond ? 1 : 0;
      }
    }
  }
  EXPECT_GT(met, 10'000U);
  EXPECT_GT(missed, 10'000U);
  EXPECT_LT(visited, met * 3);
}

}  // namespace
}  // namespace waywright::test