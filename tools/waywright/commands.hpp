#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "exit_status.hpp"
#include "picture.hpp"

namespace waywright::command {

/// In all options below, the file name `-` means standard input or standard output.

/// `waywright run`
struct RunOptions {
  std::string script;
  std::string dump;  ///< empty for none
  std::string svg;   ///< empty for none
  PictureOptions picture;
  bool check = false;
  bool strict = false;
  bool stats = false;
  std::size_t limit = kNoVertexLimit;  ///< of new vertices, for each operation
};

/// `waywright path`
struct PathOptions {
  std::string map;
  std::vector<std::string> from;  ///< x, y
  std::vector<std::string> to;    ///< x, y
  std::string radius = "0";       ///< of the agent
  PathAlgorithm algorithm = PathAlgorithm::optimal;
  std::string svg;  ///< empty for none
  PictureOptions picture;
};

/// `waywright scenario`
struct ScenarioOptions {
  std::string map;
  std::string scenario;
  std::string radius = "0";  ///< of the agent of every query
  PathAlgorithm algorithm = PathAlgorithm::optimal;
  std::string csv;                   ///< empty for none
  std::string svg;                   ///< empty for none
  std::vector<std::size_t> queries;  ///< the numbers of the queries to draw, from 1
  bool any_map = false;
  PictureOptions picture;
};

/// `waywright convert`
struct ConvertOptions {
  std::string in;
  std::string out;
  std::string format;  ///< `wws`, `wwb`, `svg`, or empty if the ending of `out` tells the format
  PictureOptions picture;
};

/// `waywright replay`
struct ReplayOptions {
  std::string log;
  std::string other;  ///< the log to compare with; empty for none
};

/// The subcommands. Each throws Failure for errors that end in status 2.
[[nodiscard]] ExitStatus run(const RunOptions& options);
[[nodiscard]] ExitStatus path(const PathOptions& options);
[[nodiscard]] ExitStatus scenario(const ScenarioOptions& options);
[[nodiscard]] ExitStatus convert(const ConvertOptions& options);
[[nodiscard]] ExitStatus replay(const ReplayOptions& options);

}  // namespace waywright::command
