#include "world/box_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace waywright::test {
namespace {

// Boxes of all sizes, some beyond the domain, compared with a plain list.
TEST(BoxTree, FindsTheBoxesThatAListFinds) {
  Random random(4);
  const Box domain{{-10, 0}, {90, 50}};
  BoxTree tree(domain);
  std::map<BoxTree::Handle, Box> boxes;
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
      const BoxTree::Handle handle = tree.insert(box, number);
      ASSERT_TRUE(boxes.emplace(handle, box).second);
    } else {
      const auto any = std::next(boxes.begin(), static_cast<std::ptrdiff_t>(random.below(boxes.size())));
      tree.remove(any->first);
      boxes.erase(any);
    }
    if (i % 10 != 0) continue;
    const Box asked = random_box();
    std::size_t count = 0;
    tree.for_each_overlapping(asked, [&](std::uint32_t) { ++count; });
    const auto overlaps = [&](const auto& entry) { return entry.second.overlaps(asked); };
    ASSERT_EQ(count, static_cast<std::size_t>(std::count_if(boxes.begin(), boxes.end(), overlaps))) << "step " << i;
    found += count;
    most = std::max(most, boxes.size());
  }
  EXPECT_GT(found, 1000U);
  EXPECT_GT(most, 500U);
}

}  // namespace
}  // namespace waywright::test
