#include "arguments.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "failure.hpp"

namespace waywright::command {

namespace {

using Words = std::vector<std::string>;

bool asks_for_help(std::string_view word) { return word == "-h" || word == "--help" || word == "--version"; }

/// Returns whether a word is an option at a position where no value is expected.
bool is_option(std::string_view word) { return word.size() > 1 && word[0] == '-'; }

/// Returns whether a word is a value at a position where one is expected: -1, -.5 and - are values too.
bool is_value(std::string_view word) {
  if (!is_option(word) || word == "-inf" || word == "-nan") return true;
  return word[1] != '-' && std::isalpha(static_cast<unsigned char>(word[1])) == 0;
}

std::string quoted(const Words& words) {
  std::string out;
  for (const std::string& word : words) fmt::format_to(std::back_inserter(out), "{}'{}'", out.empty() ? "" : " ", word);
  return out;
}

/// Checks the words that follow a command.
class WordCheck {
 public:
  explicit WordCheck(const CLI::App& command) : command_(command) {}

  void run(const Words& words);

 private:
  /// Reads an option and its values. Returns the index of the next word.
  std::size_t read_option(const Words& words, std::size_t at);
  /// Throws Failure unless the option has as many values as it takes. `values` are the words after the option.
  void check_values(const CLI::Option& option, const std::string& name, const Words& values) const;
  void check_positionals() const;
  void check_required() const;
  [[noreturn]] void fail(const std::string& what) const;

  const CLI::App& command_;
  Words positionals_;
  std::set<const CLI::Option*> seen_;
  std::string crowded_;  ///< the message about the first option with more words after it than it takes
};

void WordCheck::fail(const std::string& what) const {
  throw Failure(
      fmt::format("waywright {}: {} (see waywright {} --help)", command_.get_name(), what, command_.get_name()));
}

/// Returns the values that the option takes as text: `a value, FILE` or `2 values, X Y`.
std::string needs_of(const CLI::Option& option) {
  const int count = option.get_items_expected_min();
  const std::string values = count == 1 ? "a value" : fmt::format("{} values", count);
  return fmt::format("{}, {}", values, option.get_type_name());
}

void WordCheck::check_values(const CLI::Option& option, const std::string& name, const Words& values) const {
  const auto needed = static_cast<std::size_t>(option.get_items_expected_min());
  if (values.size() >= needed) return;
  if (values.empty()) fail(fmt::format("{} takes {}, and none is given", name, needs_of(option)));
  fail(fmt::format("{} takes {}, and only {} is given: {}", name, needs_of(option), values.size(), quoted(values)));
}

std::size_t WordCheck::read_option(const Words& words, std::size_t at) {
  const std::string& word = words[at++];
  const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
  const std::string name = word.substr(0, equals);
  const CLI::Option* const option = command_.get_option_no_throw(name);
  if (option == nullptr) {
    const char* const hint = name.starts_with("--") ? "" : "; for a file with this name, write ./";
    fail(fmt::format("there is no option '{}'{}{}", name, hint, *hint == '\0' ? "" : name));
  }
  const auto needed = static_cast<std::size_t>(option->get_items_expected_min());
  const bool is_flag = option->get_items_expected_max() == 0;
  if (is_flag && equals != std::string::npos) fail(fmt::format("{} takes no value", name));
  if (is_flag) return at;
  const bool may_repeat = option->get_items_expected_max() > option->get_items_expected_min();
  if (!seen_.insert(option).second && !may_repeat) fail(fmt::format("{} is given twice", name));
  Words values;
  if (equals != std::string::npos && equals + 1 < word.size()) values.push_back(word.substr(equals + 1));
  const auto take = [&] { values.push_back(words[at++]); };
  while (values.size() < needed && at < words.size() && is_value(words[at])) take();
  check_values(*option, name, values);
  const std::size_t next = at;
  while (at < words.size() && is_value(words[at])) take();
  if (values.size() > needed && crowded_.empty()) {
    crowded_ = fmt::format("{} takes {}, and {} follow it: {}", name, needs_of(*option), values.size(), quoted(values));
  }
  return next;
}

void WordCheck::check_positionals() const {
  Words names;
  for (const CLI::Option* const option : command_.get_options()) {
    if (!option->get_positional()) continue;
    names.push_back(option->get_name());
    if (!option->get_required() || positionals_.size() >= names.size()) continue;
    fail(fmt::format("{} is missing: {}", option->get_name(), option->get_description()));
  }
  if (positionals_.size() <= names.size()) return;
  if (!crowded_.empty()) fail(crowded_);
  fail(fmt::format("'{}' is one argument too many, after {}", positionals_[names.size()], fmt::join(names, " ")));
}

void WordCheck::check_required() const {
  for (const CLI::Option* const option : command_.get_options()) {
    if (option->get_positional() || !option->get_required() || seen_.contains(option)) continue;
    fail(fmt::format("{} {} is missing: {}", option->get_name(), option->get_type_name(), option->get_description()));
  }
}

void WordCheck::run(const Words& words) {
  for (std::size_t at = 0; at < words.size();) {
    const std::string& word = words[at];
    if (asks_for_help(word)) return;
    if (word == "--") {
      positionals_.insert(positionals_.end(), words.begin() + static_cast<std::ptrdiff_t>(at) + 1, words.end());
      break;
    }
    if (is_option(word)) {
      at = read_option(words, at);
    } else {
      positionals_.push_back(word);
      ++at;
    }
  }
  check_positionals();
  check_required();
}

}  // namespace

const CLI::App* command_named(const CLI::App& app, std::string_view name) {
  const auto found = app.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; });
  return found.empty() ? nullptr : found.front();
}

std::string names_of_commands(const CLI::App& app) {
  const auto commands = app.get_subcommands([](const CLI::App* /*command*/) { return true; });
  std::string names;
  for (const CLI::App* const command : commands) {
    names += names.empty() ? "" : command == commands.back() ? " and " : ", ";
    names += command->get_name();
  }
  return names;
}

void check_arguments(const CLI::App& app, const std::vector<std::string>& words) {
  const auto fail = [&](const std::string& what) {
    throw Failure(
        fmt::format("waywright: {}; the commands are {} (see waywright --help)", what, names_of_commands(app)));
  };
  if (words.empty()) fail("a command is missing");
  if (asks_for_help(words.front())) return;
  if (is_option(words.front())) fail(fmt::format("there is no option '{}' before the command", words.front()));
  const CLI::App* const command = command_named(app, words.front());
  if (command == nullptr) fail(fmt::format("'{}' is not a command", words.front()));
  WordCheck(*command).run({words.begin() + 1, words.end()});
}

}  // namespace waywright::command
