#include <cstdint>

#include <gtest/gtest.h>

#include "support/each_flavour.hpp"
#include "support/rollback_check.hpp"

namespace waywright::test {
namespace {

TEST(RollbackProperty, LeadsToTheWorldThatNeverPredicted) {
  check_each_flavour([](Flavour flavour, std::uint64_t seed) {
    const RollbackReport report = check_rollbacks(flavour, seed, 3);
    ASSERT_EQ(report.fault, "");
    ASSERT_EQ(report.rollbacks, 3U);
    ASSERT_GT(report.changes, 0U);
  });
}

}  // namespace
}  // namespace waywright::test
