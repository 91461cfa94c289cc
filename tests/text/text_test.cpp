#include "text/text.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/number_text.hpp"

namespace waywright::text {
namespace {

using base::append_number;
using base::append_unsigned;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<std::string> lines_of(std::string_view text) {
  LineReader reader(text);
  std::vector<std::string> lines;
  for (std::string_view line; reader.next(line);) lines.emplace_back(line);
  return lines;
}

std::vector<std::string> words_of(std::string_view line) {
  WordReader reader(line);
  std::vector<std::string> words;
  for (std::string_view word; reader.next(word);) words.emplace_back(word);
  return words;
}

TEST(WordReader, PeeksAtTheNextWord) {
  WordReader words(" one\ttwo ");
  std::string_view word;
  for (const std::string_view expected : {"one", "two"}) {
    EXPECT_EQ(words.peek(), expected);
    ASSERT_TRUE(words.next(word));
    EXPECT_EQ(word, expected);
  }
  EXPECT_EQ(words.peek(), "");
}

TEST(LineReader, EndsLinesAtLineFeedsWithOrWithoutCarriageReturns) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(lines_of(""), Lines{});
  EXPECT_EQ(lines_of("\n"), Lines{""});
  EXPECT_EQ(lines_of("a\nb"), (Lines{"a", "b"}));
  EXPECT_EQ(lines_of("a\r\n\r\nb\r\n"), (Lines{"a", "", "b"}));
  EXPECT_EQ(lines_of("a\rb\n"), Lines{"a\rb"});
}

TEST(LineReader, CountsLinesFromOne) {
  LineReader reader("a\n\nb\n");
  std::string_view line;
  EXPECT_EQ(reader.number(), 1U);
  for (const std::uint64_t number : {1U, 2U, 3U}) {
    ASSERT_TRUE(reader.next(line));
    EXPECT_EQ(reader.number(), number);
  }
  EXPECT_FALSE(reader.next(line));
  EXPECT_EQ(reader.number(), 3U);
}

TEST(WordReader, PartsWordsAtBlanksAndTabs) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(words_of(""), Words{});
  EXPECT_EQ(words_of(" \t "), Words{});
  EXPECT_EQ(words_of("\ta  b\tc "), (Words{"a", "b", "c"}));
}

TEST(WithoutComment, CutsAtTheFirstHash) {
  EXPECT_EQ(without_comment("a b # c # d"), "a b ");
  EXPECT_EQ(without_comment("a b"), "a b");
  EXPECT_EQ(without_comment("#"), "");
}

TEST(ReadNumber, TakesDecimalNumbers) {
  const std::vector<std::pair<std::string_view, double>> cases{
      {"0", 0.0},      {"-0", 0.0},      {"1", 1.0},        {"+1", 1.0},          {"-1", -1.0},
      {"007", 7.0},    {".5", 0.5},      {"5.", 5.0},       {"-.5", -0.5},        {"+.5", 0.5},
      {"1e3", 1000.0}, {"1E3", 1000.0},  {"1e+3", 1000.0},  {"-.25E1", -2.5},     {"1e-2", 0.01},
      {"0.1", 0.1},    {"1e308", 1e308}, {"0e999999", 0.0}, {"1e-323", 0x1p-1073}};
  for (const auto& [text, expected] : cases) EXPECT_EQ(read_number(text), expected) << text;
}

TEST(ReadNumber, RoundsToTheNearestDouble) {
  // 2^53 + 1 lies midway between two doubles, and 2^53 is the even one. One more digit makes the upper one nearer.
  EXPECT_EQ(read_number("9007199254740993"), 0x1p53);
  EXPECT_EQ(read_number("9007199254740993.0000000000000000000000000000000001"), 0x1p53 + 2.0);
  // Half the smallest subnormal number is 2.47...e-324.
  EXPECT_EQ(read_number("2.5e-324"), 0x1p-1074);
  EXPECT_EQ(read_number("2.4e-324"), 0.0);
  EXPECT_EQ(read_number("-2.4e-324"), 0.0);
}

TEST(ReadNumber, ReadsWhatIsTooLargeAsInfinityAndWhatIsTooSmallAsZero) {
  for (const std::string_view text :
       {"1e999", "+1e999", "2e308", "1e99999999999999999999", "1e+99999999999999999999", "1e9223372036854775807",
        "0.001e400", "123456e305", "inf", "+inf", "INF", "Infinity"}) {
    EXPECT_EQ(read_number(text), kInfinity) << text;
  }
  EXPECT_EQ(read_number("-1e999"), -kInfinity);
  EXPECT_EQ(read_number("-inf"), -kInfinity);
  EXPECT_EQ(read_number(std::string(400, '9')), kInfinity);
  EXPECT_EQ(read_number(std::string(400, '9') + ".5"), kInfinity);
  for (const std::string& text :
       {std::string("1e-999"), std::string("1e-99999999999999999999"), std::string("1e-9223372036854775807"),
        std::string("1000e-400"), "0." + std::string(400, '0') + "1", "." + std::string(400, '0') + "1e5"}) {
    EXPECT_EQ(read_number(text), 0.0) << text;
  }
}

TEST(ReadNumber, ReadsTheWordsForNotANumber) {
  for (const std::string_view text : {"nan", "NaN", "-nan", "+nan"}) {
    const std::optional<double> value = read_number(text);
    ASSERT_TRUE(value.has_value()) << text;
    EXPECT_TRUE(std::isnan(*value)) << text;
  }
}

TEST(ReadNumber, RefusesEverythingElse) {
  for (const std::string_view text :
       {"",      "+",   "-",     ".",  "+-1", "-+1", "++1", "--1",   "e5",   "1e",    "1e+", "0x10",
        "0x1p3", "1,5", "1.2.3", "1f", "1 ",  " 1",  "1/2", "infin", "nano", "1_000", "one", "\xd9\xa1"}) {
    EXPECT_EQ(read_number(text), std::nullopt) << text;
  }
}

TEST(ReadUnsigned, TakesDigitsAlone) {
  EXPECT_EQ(read_unsigned("0"), 0U);
  EXPECT_EQ(read_unsigned("007"), 7U);
  EXPECT_EQ(read_unsigned("18446744073709551615"), UINT64_MAX);
  for (const std::string_view text : {"", "+1", "-1", "1.0", "1e3", "0x1", "18446744073709551616", "a"}) {
    EXPECT_EQ(read_unsigned(text), std::nullopt) << text;
  }
}

TEST(ReadId, TakesFromOneToTheLargest) {
  EXPECT_EQ(read_id("1"), ItemId{1});
  EXPECT_EQ(read_id("9223372036854775807"), ItemId{ItemId::kLargest});
  for (const std::string_view text : {"0", "9223372036854775808", "18446744073709551615", "-1", "+1", "1.0"}) {
    EXPECT_EQ(read_id(text), std::nullopt) << text;
  }
}

std::string printed(double value) {
  std::string out;
  append_number(out, value);
  return out;
}

TEST(AppendNumber, PrintsTheShortestTextThatReadsBack) {
  EXPECT_EQ(printed(0.0), "0");
  EXPECT_EQ(printed(-0.0), "0");
  EXPECT_EQ(printed(1.0), "1");
  EXPECT_EQ(printed(-2.5), "-2.5");
  EXPECT_EQ(printed(0.1), "0.1");
  EXPECT_EQ(printed(1e300), "1e+300");
  EXPECT_EQ(printed(0x1p-1074), "5e-324");
  EXPECT_EQ(printed(kInfinity), "inf");
  EXPECT_EQ(printed(-kInfinity), "-inf");
}

RC_GTEST_PROP(AppendNumber, EveryDoubleReadsBack, (std::uint64_t bits)) {
  const auto value = std::bit_cast<double>(bits);
  const std::optional<double> back = read_number(printed(value));
  RC_ASSERT(back.has_value());
  RC_ASSERT(*back == value || (std::isnan(*back) && std::isnan(value)));
}

TEST(AppendUnsigned, PrintsDigits) {
  std::string out = "n";
  append_unsigned(out, 0);
  append_unsigned(out, UINT64_MAX);
  EXPECT_EQ(out, "n018446744073709551615");
}

TEST(InQuotes, ClipsAndShowsBytesThatDoNotPrint) {
  EXPECT_EQ(in_quotes("abc"), "'abc'");
  EXPECT_EQ(in_quotes(std::string_view("a\0\n\xff", 4)), "'a\\x00\\x0a\\xff'");
  EXPECT_EQ(in_quotes(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
  EXPECT_EQ(in_quotes(std::string(40, 'x')), "'" + std::string(40, 'x') + "'");
}

TEST(ErrorAt, NamesTextAndLine) {
  const Error error = error_at(ErrorCode::malformed, "a.wws", 12, "expected more");
  EXPECT_EQ(error.code, ErrorCode::malformed);
  EXPECT_EQ(error.message(), "a.wws:12: expected more");
  EXPECT_EQ(error.index, 12U);
}

}  // namespace
}  // namespace waywright::text
