#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "memory/arena.hpp"
#include "support/each_flavour.hpp"
#include "support/history_check.hpp"

namespace waywright::test {
namespace {

constexpr std::size_t kHistorySteps = 120;

TEST(HistoryProperty, AgreesWithAModelThatKeepsTheItemsOfEachTick) {
  HistoryCounts all;
  check_each_flavour([&](Flavour flavour, std::uint64_t seed) {
    const HistoryReport report = check_history(flavour, seed, kHistorySteps);
    ASSERT_EQ(report.fault, "");
    ASSERT_EQ(report.counts.steps, kHistorySteps);
    all += report.counts;
  });
  // Every kind of step happens in every run, however short.
  EXPECT_GT(all.refusals, 0U);
  EXPECT_GT(all.rewinds, all.steps / 40);
  EXPECT_GT(all.attempts, all.steps / 40);
  EXPECT_GT(all.snapshots_of_ticks, all.steps / 40);
  EXPECT_GT(all.comparisons, all.steps / 40);
  EXPECT_EQ(all.sharing_replicas > 0, memory::Arena::make(1) != nullptr);
  EXPECT_GT(all.clones, 0U);
  EXPECT_GT(all.saves, 0U);
}

}  // namespace
}  // namespace waywright::test
