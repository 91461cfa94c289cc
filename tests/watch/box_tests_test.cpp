#include "watch/box_tests.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace waywright::test {
namespace {

using namespace watch;

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

// The slack of positions in a domain, as PathWatch computes it.
double slack_in(const Box& domain) { return slack_of(domain.min, domain.max); }

// The segment has positions at equal distances. If one of them lies in the box, the diagonal may touch the box.
TEST(Diagonal, MissesNoBoxThatItMeets) {
  Random random(7);
  std::size_t met = 0;
  std::size_t touched = 0;
  std::size_t overlapping = 0;
  for (const Box& domain : kDomains) {
    for (int i = 0; i < 50000; ++i) {
      const Point a = random_point(random, domain);
      const Point b = random_point(random, domain);
      Box box{a, a};
      box.expand(b);
      const Box asked = random_box(random, domain);
      if (!box.overlaps(asked)) continue;
      ++overlapping;
      const bool rises = (a.x <= b.x) == (a.y <= b.y);
      const bool may_touch =
          may_touch_diagonal(box, rises ? Diagonal::rising : Diagonal::falling, asked, slack_in(domain));
      bool meets = false;
      for (int step = 0; step <= 256; ++step) {
        const Point p = step == 256 ? b : a + step / 256.0 * (b - a);
        meets = meets || asked.contains(p);
      }
      ASSERT_TRUE(!meets || may_touch);
      met += meets ? 1 : 0;
      touched += may_touch ? 1 : 0;
    }
  }
  EXPECT_GT(met, 10'000U);
  EXPECT_LT(touched, overlapping * 9 / 10) << "the test leaves out boxes that the diagonal misses";
}

// The domain is small and far from (0, 0). Coordinates there have an error of up to 2^-45 times their magnitude, here
// 2^-5. The box is nearer than this error to the diagonal.
TEST(Diagonal, MissesNoBoxThatIsARoundingErrorAway) {
  const Box domain{{0x1p40, 0x1p40}, {0x1p40 + 256, 0x1p40 + 256}};
  const Point middle = 0.5 * (domain.min + domain.max);
  for (const Diagonal diagonal : {Diagonal::rising, Diagonal::falling}) {
    const Point near = middle + Point{0x1p-6, diagonal == Diagonal::rising ? -0x1p-6 : 0x1p-6};
    EXPECT_TRUE(may_touch_diagonal(domain, diagonal, {near, near}, slack_in(domain)));
    const Point far = middle + Point{16, diagonal == Diagonal::rising ? -16.0 : 16.0};
    EXPECT_FALSE(may_touch_diagonal(domain, diagonal, {far, far}, slack_in(domain)));
  }
}

// Samples positions of the box. If one of them, or of the box widened by the reach, lies in the ellipse, the box may
// meet it. It misses an ellipse that lies clearly beyond the box. The box of the ellipse contains the ellipse.
TEST(Ellipse, MissesNoBoxThatItMeets) {
  Random random(8);
  std::size_t met = 0;
  std::size_t near = 0;
  std::size_t missed = 0;
  for (const Box& domain : kDomains) {
    for (int i = 0; i < 50000; ++i) {
      Ellipse ellipse;
      ellipse.start = random_point(random, domain);
      ellipse.goal = random_point(random, domain);
      const double stretch = 1.0 + 0.25 * static_cast<double>(random.below(4));
      ellipse.length = distance(ellipse.start, ellipse.goal) * stretch * (1.0 + 0x1p-30);
      if (i % 50 == 0) ellipse.length = std::numeric_limits<double>::infinity();
      if (i % 3 == 0) ellipse.reach = 0.05 * domain.width();
      const Box asked = random_box(random, domain);
      double least = std::numeric_limits<double>::infinity();
      for (int sample = 0; sample < 25; ++sample) {
        const Point p = asked.min + Point{asked.width() * (sample % 5) / 4.0, asked.height() * (sample / 5) / 4.0};
        least = std::min(least, distance(p, ellipse.start) + distance(p, ellipse.goal));
      }
      const double size = distance(asked.min, asked.max) + 4.0 * ellipse.reach;
      const bool meets = least <= ellipse.length;
      const bool may = may_meet(ellipse, asked);
      ASSERT_TRUE(may || !meets);
      ASSERT_TRUE(!meets || bounds_of(ellipse).overlaps(asked));
      const bool is_beyond = least > ellipse.length + 2.0 * size + 1e-9 * ellipse.length;
      ASSERT_FALSE(is_beyond && may);
      met += meets ? 1 : 0;
      near += may ? 1 : 0;
      missed += is_beyond ? 1 : 0;
    }
  }
  EXPECT_GT(met, 10'000U);
  EXPECT_GT(missed, 10'000U);
  EXPECT_LT(near, met * 3);
}

// The ellipse of a straight path is a segment, apart from rounding errors.
TEST(Ellipse, OfAStraightPathMeetsEachPositionOfThePath) {
  const Box domain{{0.0, 0.0}, {100.0, 100.0}};
  Random random(12);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const Point start = random_point(random, domain);
    const Point goal =
        i % 3 == 0 ? start + Point{1e-3, 1e-4} * static_cast<double>(i % 7) : random_point(random, domain);
    const Ellipse ellipse{start, goal, distance(start, goal) * (1.0 + 0x1p-30), 0.0};
    const double share = static_cast<double>(random.below(1000)) / 1000.0;
    for (const double t : {0.0, share, share * 0x1p-10, 1.0 - share * 0x1p-10, share * 0x1p-20, 1.0}) {
      const Point p = lerp(start, goal, t);
      ASSERT_TRUE(may_meet(ellipse, {p, p})) << "ellipse " << i << " at the share " << t;
    }
  }
}

}  // namespace
}  // namespace waywright::test
