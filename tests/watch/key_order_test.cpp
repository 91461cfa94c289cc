#include "watch/key_order.hpp"

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace waywright::test {
namespace {

using watch::KeyOrder;

/// Keys in a KeyOrder and in a std::map.
class TwoOrders {
 public:
  explicit TwoOrders(std::uint64_t seed) : random_(seed) {}

  void add(std::uint64_t key) {
    const std::uint32_t slot = take_slot();
    const auto [found, is_new] = slots_.try_emplace(key, slot);
    if (is_new) {
      order_.add(slot, key);
    } else {
      order_.move(found->second, slot);
      free_.push_back(std::exchange(found->second, slot));
    }
  }
  void remove_any() {
    const auto found = any();
    order_.remove(found->second);
    free_.push_back(found->second);
    slots_.erase(found);
  }
  [[nodiscard]] std::size_t size() const { return slots_.size(); }

  /// Marks `count` keys, some of them twice, and compares the keys that the order takes.
  void compare(std::size_t count) {
    std::set<std::uint64_t> expected;
    std::vector<std::uint64_t> slots;
    for (std::size_t i = 0; i < count && !slots_.empty(); ++i) {
      const auto [key, slot] = *any();
      expected.insert(key);
      slots.push_back(slot);
      order_.mark(slot);
    }
    std::vector<std::uint64_t> keys{1, 2, 3};
    order_.take_marked(keys);
    ASSERT_EQ(keys, std::vector<std::uint64_t>(expected.begin(), expected.end()));
    order_.take_marked(keys);
    ASSERT_TRUE(keys.empty()) << "the marks are gone";
    order_.replace_by_keys(slots);
    ASSERT_EQ(slots, std::vector<std::uint64_t>(expected.begin(), expected.end()));
  }

 private:
  std::uint32_t take_slot() {
    if (free_.empty()) free_.push_back(slot_count_++);
    // The last freed slot, or any.
    if (random_.chance(50)) std::swap(free_[random_.below(free_.size())], free_.back());
    order_.make_room(free_.back());
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    return slot;
  }
  std::map<std::uint64_t, std::uint32_t>::iterator any() {
    return std::next(slots_.begin(), static_cast<std::ptrdiff_t>(random_.below(slots_.size())));
  }

  Random random_;
  KeyOrder order_;
  std::map<std::uint64_t, std::uint32_t> slots_;  ///< by key
  std::vector<std::uint32_t> free_;
  std::uint32_t slot_count_ = 0;
};

// Ascending keys, descending keys, and random keys of which many occur again.
TEST(KeyOrder, ListsTheKeysThatASortedMapLists) {
  for (int kind = 0; kind < 4; ++kind) {
    Random random(static_cast<std::uint64_t>(kind));
    TwoOrders orders(static_cast<std::uint64_t>(kind));
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const bool grows = i / 400 % 2 == 0;
      if (orders.size() < 10 || random.chance(grows ? 80 : 30)) {
        const std::uint64_t any_key = kind == 2 ? random.below(700) : random.next();
        orders.add(kind == 0 ? i : kind == 1 ? 100'000 - i : any_key);
      } else {
        orders.remove_any();
      }
      if (random.chance(10)) orders.compare(random.below(random.chance(50) ? 8 : 300));
      if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(orders.size(), 100U) << "enough keys to sort new ones into the array";
  }
}

}  // namespace
}  // namespace waywright::test
