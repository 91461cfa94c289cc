#pragma once

#include <string>
#include <vector>

#include "exit_status.hpp"

namespace waywright::command {

/// `waywright run`
struct RunOptions {
  std::string script;  ///< a file's name, or `-`
  std::string dump;    ///< empty: none
  std::string svg;     ///< empty: none
  bool check = false;
  bool strict = false;
};

/// `waywright path`
struct PathOptions {
  std::string map;
  std::vector<std::string> from;  ///< x, y
  std::vector<std::string> to;    ///< x, y
  std::string svg;                ///< empty: none
  bool no_mesh = false;
};

/// `waywright convert`
struct ConvertOptions {
  std::string in;
  std::string out;
  bool no_mesh = false;
};

/// The subcommands. Each throws Failure for what ends in status 2.
[[nodiscard]] ExitStatus run(const RunOptions& options);
[[nodiscard]] ExitStatus path(const PathOptions& options);
[[nodiscard]] ExitStatus convert(const ConvertOptions& options);

}  // namespace waywright::command
