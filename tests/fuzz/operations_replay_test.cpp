#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fuzz/operations_body.hpp"
#include "support/case_count.hpp"
#include "support/changes_check.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

/// Returns the inputs in the fuzz target's corpus, ordered by file name.
std::vector<std::string> corpus() {
  const std::filesystem::path folder = std::filesystem::path(WAYWRIGHT_SOURCE_DIR) / "tests/fuzz/corpus/operations";
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> inputs;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return inputs;
}

/// Returns the operations as a world script, for a message from which a reader can reproduce a fault.
std::string script_of(std::string_view bytes) { return to_script(BytesReader(bytes).read()); }

TEST(FuzzReplay, Operations) {
  const std::vector<std::string> inputs = corpus();
  ASSERT_FALSE(inputs.empty());
  Random random(1);
  const std::size_t step = is_quick() ? 24 : 1;
  for (std::size_t at = 0; at < inputs.size(); at += step) {
    const std::string& input = inputs[at];
    EXPECT_EQ(fault_of_operations(input), "") << script_of(input);
    const ChangesReport report = check_changes(BytesReader(input).read(), 1, {.with_rebuild = 200, .with_oracle = 0});
    EXPECT_FALSE(report.fault) << *report.fault << script_of(input);
    for (int i = 0; i < case_count(5, 5); ++i) {
      std::string mutated = input;
      for (std::size_t changes = 1 + random.below(4); changes > 0 && !mutated.empty(); --changes) {
        mutated[random.below(mutated.size())] = static_cast<char>(random.below(256));
      }
      ASSERT_EQ(fault_of_operations(mutated), "") << script_of(mutated);
    }
  }
}

// Two walls that cross. The second comes in one batch with the removal of the first and with an unknown id.
TEST(FuzzReplay, BytesAreReadAsOperations) {
  const std::string bytes("\x00\x3f\x00\x01\x11\x77\x00\x01\x17\x71\x06", 11);
  EXPECT_EQ(script_of(bytes),
            "waywright 1\ndomain -1 -2 10 9\n# a batch of 3\nsegment 1 1 1 7 7\nsegment 2 1 7 7 1\nremove 1\n");
  EXPECT_EQ(script_of(std::string("\x00\x96", 2)), "waywright 1\ndomain -1 -2 10 9\n# refused: unknown-id\n");
}

}  // namespace
}  // namespace waywright::test
