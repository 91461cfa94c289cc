#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/case_count.hpp"
#include "support/random_scenes.hpp"
#include "support/scene_check.hpp"

namespace waywright::test {
namespace {

using CheckOfSeed = std::function<SceneReport(const Scene&, Flavour, std::uint64_t)>;

/// The seed and the size of a scene that failed.
struct Failure {
  std::uint64_t seed = 0;
  std::size_t item_count = 0;
};

/// RapidCheck chooses scenes, the same in each run, and reduces the number of items of a scene that fails. Then the
/// test shrinks the scene item by item and prints it as a script.
void check_flavour(Flavour flavour, const std::string& what, const CheckOfSeed& check) {
  std::optional<Failure> failure;
  const auto property = [&] {
    const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()).as("seed");
    const auto item_count =
        *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, 61)).as("count of items");
    const SceneReport report = check(random_scene(flavour, seed, item_count), flavour, seed);
    if (!report.fault) return;
    failure = {seed, item_count};
    RC_FAIL(*report.fault);
  };
  rc::detail::TestParams params;
  params.seed = 20090101 + static_cast<std::uint64_t>(flavour);
  params.maxSuccess = static_cast<int>(case_count());
  const rc::detail::TestResult result = rc::detail::checkTestable(property, rc::detail::TestMetadata(), params);
  if (result.template is<rc::detail::SuccessResult>()) return;
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  if (failure) {
    const Scene scene = random_scene(flavour, failure->seed, failure->item_count);
    const std::string name = what + "-" + std::string(to_string(flavour)) + "-" + std::to_string(failure->seed);
    message << '\n'
            << report_failure(scene, name, [&](const Scene& less) { return check(less, flavour, failure->seed); });
  }
  FAIL() << message.str();
}

class WorldProperty : public ::testing::TestWithParam<Flavour> {};

TEST_P(WorldProperty, MatchesTheOracleInAnyOrder) { check_flavour(GetParam(), "world", check_scene); }

INSTANTIATE_TEST_SUITE_P(Flavours, WorldProperty, ::testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

}  // namespace
}  // namespace waywright::test
