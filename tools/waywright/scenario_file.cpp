#include "scenario_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "failure.hpp"
#include "input.hpp"

namespace waywright::command {

namespace {

constexpr std::size_t kFields = 9;
constexpr std::string_view kBlanks = " \t\r";

using Fields = std::vector<std::string_view>;

Fields fields_of(std::string_view line) {
  Fields fields;
  for (std::size_t at = line.find_first_not_of(kBlanks); at != line.npos; at = line.find_first_not_of(kBlanks, at)) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    fields.push_back(line.substr(at, end - at));
    at = end;
  }
  return fields;
}

std::optional<double> number(std::string_view word) {
  double value = 0.0;
  const auto [stop, fault] = base::read_double(word.data(), word.data() + word.size(), value);
  if (stop != word.data() + word.size() || fault != std::errc{} || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Half a unit of a decimal number's last digit.
double precision_of(std::string_view word) {
  const std::size_t point = word.find('.');
  const std::size_t end = std::min(word.find_first_of("eE"), word.size());
  double unit = point == word.npos ? 1.0 : std::pow(10.0, -static_cast<double>(end - point - 1));
  if (end < word.size()) unit *= std::pow(10.0, number(word.substr(end + 1)).value_or(0.0));
  return unit / 2.0;
}

ScenarioQuery query_of(const Fields& fields, std::uint32_t line, const std::string& name) {
  if (fields.size() != kFields) {
    throw Failure(fmt::format("{}:{}: expected 9 fields (bucket, map, width, height, start, goal, length), not {}",
                              name, line, fields.size()));
  }
  std::array<double, 5> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string_view word = fields[4 + i];
    const auto value = number(word);
    if (!value) throw Failure(fmt::format("{}:{}: field {}: '{}' is not a number", name, line, 5 + i, word));
    numbers.at(i) = *value;
  }
  return {line, {numbers[0], numbers[1]}, {numbers[2], numbers[3]}, numbers[4], precision_of(fields.back())};
}

}  // namespace

std::vector<ScenarioQuery> load_scenario(const std::string& name) {
  const std::string text = read_text(name);
  std::vector<ScenarioQuery> queries;
  std::uint32_t line = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const Fields fields = fields_of(std::string_view(text).substr(at, end - at));
    at = end + 1;
    if (++line == 1) {
      if (fields.size() == 2 && fields[0] == "version" && (fields[1] == "1" || fields[1] == "1.0")) continue;
      throw Failure(fmt::format("{}:1: expected 'version 1', as scenarios of Moving AI begin", name));
    }
    if (!fields.empty()) queries.push_back(query_of(fields, line, name));
  }
  if (queries.empty()) throw Failure(fmt::format("{}: holds no queries", name));
  return queries;
}

}  // namespace waywright::command
