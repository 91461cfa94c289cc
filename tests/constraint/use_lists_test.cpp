#include "constraint/use_lists.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace waywright::test {
namespace {

using constraint::UseLists;
using constraint::Uses;

std::vector<std::uint32_t> sorted(const UseLists& lists, Uses list) {
  std::vector<std::uint32_t> users;
  lists.for_each(list, [&](std::uint32_t user) { users.push_back(user); });
  std::sort(users.begin(), users.end());
  return users;
}

TEST(UseLists, ListsGrowOneByOneAndMayRepeat) {
  UseLists lists;
  Uses list = UseLists::kNone;
  EXPECT_TRUE(sorted(lists, list).empty());
  list = lists.add(list, 0);
  EXPECT_NE(list, UseLists::kNone);
  EXPECT_EQ(lists.any(list), 0U);
  list = lists.add(list, UseLists::kLargestUser);
  list = lists.add(list, 5);
  list = lists.add(list, 5);
  EXPECT_EQ(sorted(lists, list), (std::vector<std::uint32_t>{0, 5, 5, UseLists::kLargestUser}));
}

TEST(UseLists, ACopyIsIndependent) {
  UseLists lists;
  const Uses list = lists.add(lists.add(lists.add(UseLists::kNone, 1), 2), 3);
  Uses copy = lists.copy(list);
  EXPECT_EQ(sorted(lists, copy), sorted(lists, list));
  EXPECT_NE(copy, list);
  copy = lists.add(copy, 4);
  EXPECT_EQ(sorted(lists, list), (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(lists.copy(UseLists::single(9)), UseLists::single(9)) << "a lone user takes no memory";
  EXPECT_EQ(lists.copy(UseLists::kNone), UseLists::kNone);
}

// Each list must contain what a sorted vector of its users contains, also after a roll-back.
TEST(UseLists, ListsAgreeWithSortedVectors) {
  UseLists lists;
  std::array<Uses, 4> made{};
  std::array<std::vector<std::uint32_t>, 4> expected;
  std::uint64_t state = 1;
  const auto below = [&](std::uint32_t count) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint32_t>(state >> 33) % count;
  };
  for (int operation = 0; operation < 300; ++operation) {
    const auto made_before = made;
    const auto expected_before = expected;
    lists.begin();
    for (int change = 0; change < 20; ++change) {
      const std::size_t i = below(4);
      std::vector<std::uint32_t>& users = expected[i];
      if (!users.empty() && below(11) < 5) {
        const std::size_t k = below(static_cast<std::uint32_t>(users.size()));
        made[i] = lists.remove(made[i], users[k]);
        users.erase(users.begin() + static_cast<std::ptrdiff_t>(k));
      } else if (below(30) == 0) {
        const std::size_t other = (i + 1) % 4;
        lists.release(made[other]);
        made[other] = lists.copy(made[i]);
        expected[other] = users;
      } else {
        users.insert(users.begin(), below(40));
        made[i] = lists.add(made[i], users.front());
        std::sort(users.begin(), users.end());
      }
      ASSERT_EQ(sorted(lists, made[i]), users);
      const std::uint32_t user = below(40);
      ASSERT_EQ(lists.contains(made[i], user), std::binary_search(users.begin(), users.end(), user));
      if (!users.empty()) {
        ASSERT_TRUE(std::binary_search(users.begin(), users.end(), lists.any(made[i])));
      }
    }
    if (operation % 3 != 0) continue;
    lists.roll_back();
    made = made_before;
    expected = expected_before;
    for (std::size_t i = 0; i < 4; ++i) ASSERT_EQ(sorted(lists, made[i]), expected[i]);
  }
}

}  // namespace
}  // namespace waywright::test
