#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "oracle/oracle.hpp"
#include "support/random_path_cases.hpp"

namespace waywright::test {

/// The algorithms that the check compares with the oracle.
inline constexpr std::array kPathAlgorithms{PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal};

/// The ratios of an algorithm's path lengths to the shortest lengths.
struct PathRatios {
  std::size_t count = 0;  ///< paths with length above 0
  double sum = 0.0;       ///< of the ratios of the paths' lengths to the shortest
  double worst = 1.0;

  [[nodiscard]] double mean() const { return count == 0 ? 1.0 : sum / static_cast<double>(count); }
  PathRatios& operator+=(const PathRatios& other);
};

/// The result of checking a case.
struct PathReport {
  std::optional<std::string> fault;  ///< the first fault
  std::string line;                  ///< the line of a script that shows the fault
  std::size_t failed_query = 0;
  std::size_t queries = 0;  ///< queries checked, of all algorithms
  std::size_t vertices = 0;
  std::array<PathRatios, kPathAlgorithms.size()> ratios;
};

/// Returns the starts and goals of a case's queries.
[[nodiscard]] std::vector<oracle::OraclePoint> oracle_ends(const PathCase& path_case);

using PathFinder = std::function<Result<void>(const World&, const PathQuery&, QueryContext&, Path&)>;

/// Returns a finder that calls World::find_path.
[[nodiscard]] PathFinder world_finder();

/// Builds the world, searches every path by every algorithm, and compares the answers with the oracle. Ends are blocked
/// exactly if they are strictly inside a polygon. A path is found exactly if one exists. It leads from start to goal,
/// has the length that it reports, and a point agent can walk it. It is not shorter than the shortest path, whose
/// length is not below the path's lower bound. A path by `optimal` is not longer than the shortest path either. Rays
/// between the same ends hit the first wall.
[[nodiscard]] PathReport check_paths(const PathCase& path_case, const PathFinder& find = world_finder());

/// Shrinks a case that fails to the one query that shows the fault and to the items that it needs. Writes it as a world
/// script into the folder for temporary files. Returns a message with the fault, the file's name and the script.
[[nodiscard]] std::string report_failure(const PathCase& path_case, const std::string& name,
                                         const PathFinder& find = world_finder());

}  // namespace waywright::test
