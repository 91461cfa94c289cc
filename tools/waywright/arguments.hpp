#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace waywright::command {

/// Checks the number and the kind of the words in the command line. Throws Failure for an unknown command or option,
/// for too few or too many values, for an option that appears twice, and for a missing or an extra argument. CLI11
/// alone would take any word after an option as its value, and so name the wrong word in its message. Words that ask
/// for help or for the version end the check.
void check_arguments(const CLI::App& app, const std::vector<std::string>& words);

/// Returns the command of that name, or null if there is none.
[[nodiscard]] const CLI::App* command_named(const CLI::App& app, std::string_view name);

/// Returns the names of all commands for a message: `run, path, ... and help`.
[[nodiscard]] std::string names_of_commands(const CLI::App& app);

}  // namespace waywright::command
