#include "constraint/use_lists.hpp"

#include <algorithm>
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

}  // namespace
}  // namespace waywright::test
