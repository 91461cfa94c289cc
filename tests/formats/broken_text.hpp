#pragma once

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "waywright/error.hpp"
#include "waywright/scene.hpp"

#include "formats/reader.hpp"

namespace waywright::test {

/// A text that a reader must refuse.
struct BrokenText {
  std::string name;
  std::string text;
  std::size_t line = 1;
  std::string what;  ///< a part of the message
  ErrorCode code = ErrorCode::malformed;
};

inline void PrintTo(const BrokenText& broken, std::ostream* out) { *out << broken.name; }

inline std::string name_of_broken(const testing::TestParamInfo<BrokenText>& info) { return info.param.name; }

using Parse = Result<Scene> (*)(std::string_view, std::string_view, const formats::ReadProgress&);

/// Expects that a reader refuses the text, and says where and why.
inline void expect_refused(Parse parse, const BrokenText& broken) {
  const Result<Scene> scene = parse(broken.text, "file", {});
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().code, broken.code);
  const std::string message = scene.error().message();
  EXPECT_EQ(scene.error().index, broken.line) << message;
  EXPECT_TRUE(message.starts_with("file:" + std::to_string(broken.line) + ": ")) << message;
  EXPECT_NE(message.find(broken.what), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

/// Cuts a text after each of its characters: the reader must refuse or accept each beginning, and never crash.
inline void read_beginnings(Parse parse, std::string_view text) {
  for (std::size_t size = 0; size <= text.size(); ++size) {
    const Result<Scene> scene = parse(text.substr(0, size), "file", {});
    if (!scene.ok()) {
      EXPECT_TRUE(scene.error().message().starts_with("file:")) << scene.error().message();
    }
  }
}

}  // namespace waywright::test
