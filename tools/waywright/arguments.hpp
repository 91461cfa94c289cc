#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace waywright::command {

/// Finds what is wrong with the number and the kind of the command line's words: an unknown command or option, too few
/// or too many values, an option given twice, an argument that is missing or one too many. CLI11 takes the word after
/// an option as its value, whatever it is, and so blames the wrong word. Throws Failure. Words that ask for help or for
/// the version end the search.
void check_arguments(const CLI::App& app, const std::vector<std::string>& words);

/// The command of that name; null where there is none.
[[nodiscard]] const CLI::App* command_named(const CLI::App& app, std::string_view name);

/// The names of all commands for a message: `run, path, ... and help`.
[[nodiscard]] std::string names_of_commands(const CLI::App& app);

}  // namespace waywright::command
