#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/scenario.hpp"
#include "waywright/scene.hpp"
#include "waywright/script.hpp"

#include "io/triangle.hpp"

namespace waywright {
namespace {

/// A reader of texts. Returns what is wrong with a text, or an empty text if nothing is.
struct Reader {
  std::string name;
  std::string good;  ///< a text that the reader accepts
  std::string (*fault)(std::string_view text);
};

template <class Value>
std::string message_of(const Result<Value>& result) {
  return result.ok() ? std::string() : result.error().message();
}

const std::string kNode = "1 2 0 0\n1 0 0\n";

const std::vector<Reader> kReaders{
    {"script", "waywright 1\ndomain 0 0 1 1\n",
     [](std::string_view text) { return message_of(parse_script(text, "t")); }},
    {"map", "type octile\nheight 1\nwidth 1\nmap\n.\n",
     [](std::string_view text) { return message_of(parse_movingai_map(text, "t")); }},
    {"poly", kNode + "0\n0\n", [](std::string_view text) { return message_of(parse_triangle_poly(text, "t")); }},
    {"node", kNode, [](std::string_view text) { return message_of(parse_triangle_node(text, "t")); }},
    {"node_beside_poly", kNode,
     [](std::string_view text) { return message_of(parse_triangle_poly("0 2 0 0\n0\n0\n", "poly", text, "t")); }},
    {"scenario", "version 1\n0 a.map 3 3 0 0 1 1 1.4\n",
     [](std::string_view text) { return message_of(parse_movingai_scenario(text, "t")); }},
};

/// Returns an ASCII text encoded in units of `size` bytes.
std::string widened(std::string_view text, std::size_t size, bool is_big_endian) {
  std::string out;
  for (const char c : text) {
    std::string unit(size, '\0');
    unit[is_big_endian ? size - 1 : 0] = c;
    out += unit;
  }
  return out;
}

TEST(ByteOrderMark, OfUtf8IsSkippedByEveryReader) {
  for (const Reader& reader : kReaders) {
    EXPECT_EQ(reader.fault(reader.good), "") << reader.name;
    EXPECT_EQ(reader.fault("\xef\xbb\xbf" + reader.good), "") << reader.name;
    EXPECT_NE(reader.fault("\xef\xbb\xbf\xef\xbb\xbf" + reader.good), "")
        << reader.name << ": only one mark is skipped";
  }
}

TEST(ByteOrderMark, DoesNotChangeWhatIsRead) {
  const std::string map = "type octile\nheight 2\nwidth 2\nmap\n.@\n..\n";
  EXPECT_EQ(parse_movingai_map("\xef\xbb\xbf" + map, "t").value(), parse_movingai_map(map, "t").value());
  EXPECT_TRUE(
      io::lacks_vertices("\xef\xbb\xbf"
                         "0 2 0 0\n"));
}

TEST(ByteOrderMark, LeavesLineNumbersAsTheyAre) {
  EXPECT_EQ(message_of(parse_script("\xef\xbb\xbfwaywright 2\n", "t")),
            "t:1: expected format version 1 in 'waywright 1', found '2'");
}

void expect_recognised(const Reader& reader, const std::string& text, const std::string& encoding) {
  EXPECT_EQ(reader.fault(text), "t:1: expected UTF-8, found " + encoding +
                                    "; save the text as UTF-8, or convert it with 'iconv -f " + encoding + " -t UTF-8'")
      << reader.name;
}

TEST(WideEncodings, AreRecognisedByEveryReader) {
  using namespace std::string_literals;
  for (const Reader& reader : kReaders) {
    for (const bool with_mark : {true, false}) {
      const auto mark = [&](const std::string& bytes) { return with_mark ? bytes : ""s; };
      expect_recognised(reader, mark("\xff\xfe"s) + widened(reader.good, 2, false), "UTF-16LE");
      expect_recognised(reader, mark("\xfe\xff"s) + widened(reader.good, 2, true), "UTF-16BE");
      expect_recognised(reader, mark("\xff\xfe\0\0"s) + widened(reader.good, 4, false), "UTF-32LE");
      expect_recognised(reader, mark("\0\0\xfe\xff"s) + widened(reader.good, 4, true), "UTF-32BE");
    }
  }
}

TEST(WideEncodings, AreNotSeenInOtherTexts) {
  using namespace std::string_literals;
  for (const std::string& text :
       {""s, "w"s, "\0"s, "\0\0"s, "\xff"s, "\xfe"s, "\0\0\0\0"s, "\xef\xbb\xbf"s, "wa\0\0"s}) {
    EXPECT_EQ(message_of(parse_script(text, "t")).find("UTF"), std::string::npos) << text.size();
  }
}

}  // namespace
}  // namespace waywright
