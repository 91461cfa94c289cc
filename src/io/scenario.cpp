#include "waywright/scenario.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "base/float_environment.hpp"
#include "text/text.hpp"

namespace waywright {
namespace {

constexpr std::size_t kFields = 9;

/// Returns half a unit of the last digit of a decimal number. Reads the result from a text, because std::pow rounds
/// differently on other machines.
double precision_of(std::string_view word) {
  constexpr double kBeyondDoubles = 400.0;
  const std::size_t point = word.find('.');
  const std::size_t end = std::min(word.find_first_of("eE"), word.size());
  const double digits = point == std::string_view::npos ? 0.0 : static_cast<double>(end - point - 1);
  const double exponent = end < word.size() ? text::read_number(word.substr(end + 1)).value_or(0.0) : 0.0;
  const double position = std::clamp(exponent - digits - 1.0, -kBeyondDoubles, kBeyondDoubles);
  return text::read_number("5e" + std::to_string(static_cast<int>(position))).value_or(0.0);
}

/// Reads one scenario. Each function that returns bool returns false after it has stored an error in `error_`.
class ScenarioParser {
 public:
  ScenarioParser(std::string_view text, std::string_view name) : lines_(text), name_(name) {}

  Result<std::vector<ScenarioQuery>> run();

 private:
  bool read_header();
  bool read_query(const std::vector<std::string_view>& fields);
  bool tiles(std::string_view field, std::string_view word, std::uint64_t& value);
  bool number(std::string_view field, std::string_view word, double& value);
  bool fail(std::string_view what);

  text::LineReader lines_;
  std::string_view name_;
  std::vector<ScenarioQuery> queries_;
  Error error_;
};

bool ScenarioParser::fail(std::string_view what) {
  error_ = text::error_at(ErrorCode::malformed, name_, lines_.number(), what);
  return false;
}

bool ScenarioParser::read_header() {
  std::string_view line;
  std::string_view word;
  std::string_view version;
  if (!lines_.next(line)) {
    return fail("expected 'version 1', as scenarios of Moving AI begin, found the end of the text");
  }
  text::WordReader words(line);
  const bool matches = words.next(word) && word == "version" && words.next(version) && words.at_end() &&
                       (version == "1" || version == "1.0");
  return matches || fail("expected 'version 1', as scenarios of Moving AI begin, found " + text::in_quotes(line));
}

bool ScenarioParser::tiles(std::string_view field, std::string_view word, std::uint64_t& value) {
  const std::optional<std::uint64_t> read = text::read_unsigned(word);
  value = read.value_or(0);
  std::string what = "expected a whole number of tiles as the ";
  what += field;
  what += ", found ";
  return read || fail(what + text::in_quotes(word));
}

bool ScenarioParser::number(std::string_view field, std::string_view word, double& value) {
  const std::optional<double> read = text::read_number(word);
  value = read.value_or(0.0);
  std::string what = "expected a finite number as the ";
  what += field;
  what += ", found ";
  return (read && std::isfinite(*read)) || fail(what + text::in_quotes(word));
}

bool ScenarioParser::read_query(const std::vector<std::string_view>& fields) {
  if (fields.size() != kFields) {
    return fail(text::with_number(
        "expected 9 fields (bucket, map, width, height, start x, start y, goal x, goal y, length), found ",
        fields.size(), ""));
  }
  ScenarioQuery query;
  query.line = static_cast<std::uint32_t>(lines_.number());
  query.map = fields[1];
  const bool ok = tiles("width", fields[2], query.width) && tiles("height", fields[3], query.height) &&
                  number("start's x", fields[4], query.start.x) && number("start's y", fields[5], query.start.y) &&
                  number("goal's x", fields[6], query.goal.x) && number("goal's y", fields[7], query.goal.y) &&
                  number("length", fields[8], query.length);
  query.precision = precision_of(fields[8]);
  if (ok) queries_.push_back(std::move(query));
  return ok;
}

Result<std::vector<ScenarioQuery>> ScenarioParser::run() {
  if (!read_header()) return std::move(error_);
  std::string_view line;
  std::vector<std::string_view> fields;
  while (lines_.next(line)) {
    fields.clear();
    text::WordReader words(line);
    std::string_view word;
    while (words.next(word)) fields.push_back(word);
    if (!fields.empty() && !read_query(fields)) return std::move(error_);
  }
  if (queries_.empty()) {
    fail("expected a query after 'version 1', found the end of the text");
    return std::move(error_);
  }
  return std::move(queries_);
}

}  // namespace

Result<std::vector<ScenarioQuery>> parse_movingai_scenario(std::string_view text, std::string_view name) {
  const base::FloatEnvironment environment;
  if (auto error = text::skip_byte_order_mark(text, name)) return *std::move(error);
  return ScenarioParser(text, name).run();
}

}  // namespace waywright
