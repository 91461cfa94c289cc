#include "watch/box_grid.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace waywright::test {
namespace {

using namespace watch;

// Boxes of all sizes, some beyond the domain, compared with a plain list.
TEST(BoxGrid, FindsTheBoxesThatAListFinds) {
  Random random(4);
  const Box domain{{-10, 0}, {90, 50}};
  BoxGrid<std::uint32_t> grid(domain);
  std::map<BoxGrid<std::uint32_t>::Handle, std::pair<Box, std::uint32_t>> boxes;
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
      const auto handle = grid.insert(box, number);
      ASSERT_TRUE(boxes.emplace(handle, std::pair(box, number)).second);
    } else {
      const auto any = std::next(boxes.begin(), static_cast<std::ptrdiff_t>(random.below(boxes.size())));
      grid.remove(any->first);
      boxes.erase(any);
    }
    if (i % 10 != 0) continue;
    const Box asked = random_box();
    std::vector<std::uint32_t> numbers;
    grid.for_each_overlapping(asked, [&](std::uint32_t number, const Box& box) {
      numbers.push_back(number);
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

}  // namespace
}  // namespace waywright::test
