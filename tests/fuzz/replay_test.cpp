#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "fuzz/parse_bodies.hpp"

namespace waywright::test {
namespace {

using Body = std::string (*)(std::string_view);

/// Returns the texts in a fuzz target's corpus, ordered by file name.
std::vector<std::string> corpus(const std::string& target) {
  const std::filesystem::path folder = std::filesystem::path(WAYWRIGHT_SOURCE_DIR) / "tests/fuzz/corpus" / target;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return texts;
}

class Mutator {
 public:
  /// Makes one to four random changes to a text.
  std::string mutate(std::string text) {
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }

  void change(std::string& text) {
    static constexpr std::string_view kWords[] = {" ",
                                                  "\n",
                                                  "\r\n",
                                                  "#",
                                                  "/",
                                                  "%",
                                                  "0",
                                                  "1",
                                                  "-",
                                                  "+",
                                                  "9223372036854775808",
                                                  "18446744073709551615",
                                                  "nan",
                                                  "1e999",
                                                  "1e-999",
                                                  "-0.",
                                                  ".5e1",
                                                  "@.",
                                                  ".@\n",
                                                  "map",
                                                  "\0x",
                                                  "polygon",
                                                  "replace",
                                                  "\xef\xbb\xbf",
                                                  "\xff\xfe"};
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(below(8), text.size() - at);
    switch (below(4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, kWords[below(std::size(kWords))]);
        break;
      case 2:
        text.insert(below(text.size() + 1), text.substr(at, length));
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
    }
  }

  std::mt19937_64 random_{1};
};

void replay(const std::string& target, Body body) {
  const std::vector<std::string> texts = corpus(target);
  ASSERT_FALSE(texts.empty());
  Mutator mutator;
  for (const std::string& text : texts) {
    EXPECT_EQ(body(text), "") << text;
    for (int i = 0; i < 2000; ++i) {
      const std::string mutated = mutator.mutate(text);
      ASSERT_EQ(body(mutated), "") << mutated;
    }
  }
}

TEST(FuzzReplay, Scripts) { replay("parse_script", fault_of_script); }
TEST(FuzzReplay, Maps) { replay("parse_map", fault_of_map); }
TEST(FuzzReplay, Polys) { replay("parse_poly", fault_of_poly); }
TEST(FuzzReplay, SavedWorlds) { replay("load_world", fault_of_saved_world); }
TEST(FuzzReplay, Scenarios) { replay("parse_scenario", fault_of_scenario); }

TEST(FuzzBodies, SeeAWrongScene) {
  Scene scene{.domain = {{0, 0}, {1, 1}}, .items = {{{1}, {ItemKind::point, {{{2, 2}}}}}}};
  EXPECT_NE(fault_of_scene(scene), "");
  scene.items[0].shape.rings[0][0] = {0.5, 0.5};
  EXPECT_EQ(fault_of_scene(scene), "");
  scene.domain.max.x = 0.0;
  EXPECT_NE(fault_of_scene(scene), "");
}

TEST(FuzzBodies, SeeAWrongError) {
  EXPECT_EQ(fault_of_error({ErrorCode::malformed, "fuzz:2: x", {}, 2}, "a\nb"), "");
  EXPECT_NE(fault_of_error({ErrorCode::malformed, "fuzz:3: x", {}, 3}, "a\nb"), "");
  EXPECT_NE(fault_of_error({ErrorCode::malformed, "fuzz:1: x", {}, 2}, "a\nb"), "");
  EXPECT_NE(fault_of_error({ErrorCode::too_large, "fuzz:1: x", {}, 1}, "a\nb"), "");
}

}  // namespace
}  // namespace waywright::test
