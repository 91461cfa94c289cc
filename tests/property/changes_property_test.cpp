#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/case_count.hpp"
#include "support/changes_check.hpp"
#include "support/random_changes.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

struct Lengths {
  std::size_t steps = 0;
  std::size_t live_count = 0;
};

/// RapidCheck chooses scripts, the same in each run, and reduces the lengths of a script that fails. Then the test
/// shrinks the script step by step and prints it as a world script.
void check_flavour(Flavour flavour, const std::string& what, const Lengths& largest, const Comparisons& comparisons) {
  std::optional<std::uint64_t> failed_seed;
  ChangeScript failed;
  const auto property = [&] {
    const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()).as("seed");
    const auto steps =
        *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, largest.steps + 1)).as("steps");
    const auto live_count =
        *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(1, largest.live_count + 1)).as("live items");
    const ChangeScript script = random_changes(flavour, seed, steps, live_count);
    const ChangesReport report = check_changes(script, seed, comparisons);
    if (!report.fault) return;
    failed_seed = seed;
    failed = script;
    RC_FAIL(*report.fault);
  };
  rc::detail::TestParams params;
  params.seed = 20090301 + static_cast<std::uint64_t>(flavour);
  params.maxSuccess = static_cast<int>(case_count());
  const rc::detail::TestResult result = rc::detail::checkTestable(property, rc::detail::TestMetadata(), params);
  if (result.template is<rc::detail::SuccessResult>()) return;
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  if (failed_seed) {
    const std::string name = what + "-" + std::string(to_string(flavour)) + "-" + std::to_string(*failed_seed);
    message << '\n' << report_failure(failed, name, *failed_seed);
  }
  FAIL() << message.str();
}

class ChangesProperty : public ::testing::TestWithParam<Flavour> {};

TEST_P(ChangesProperty, FewItemsAreAfterEveryStepThoseOfAFreshWorld) {
  check_flavour(GetParam(), "few", {60, 6}, {.with_rebuild = 1000, .with_oracle = 100});
}

TEST_P(ChangesProperty, ManyItemsAreNowAndThenThoseOfAFreshWorld) {
  check_flavour(GetParam(), "many", {300, 60}, {.with_rebuild = 30, .with_oracle = 5});
}

INSTANTIATE_TEST_SUITE_P(Flavours, ChangesProperty, ::testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

}  // namespace
}  // namespace waywright::test
