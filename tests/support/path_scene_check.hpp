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

/// The algorithms that are held against the oracle.
inline constexpr std::array kPathAlgorithms{PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal};

/// How long an algorithm's paths are beside the shortest ones.
struct PathRatios {
  std::size_t count = 0;  ///< paths found of some length
  double sum = 0.0;       ///< of the paths' lengths by the shortest ones'
  double worst = 1.0;

  [[nodiscard]] double mean() const { return count == 0 ? 1.0 : sum / static_cast<double>(count); }
  PathRatios& operator+=(const PathRatios& other);
};

/// What checking a case found.
struct PathReport {
  std::optional<std::string> fault;  ///< the first
  std::string line;                  ///< the script's line that shows the fault
  std::size_t failed_query = 0;
  std::size_t queries = 0;  ///< checked, of all algorithms
  std::size_t vertices = 0;
  std::array<PathRatios, kPathAlgorithms.size()> ratios;
};

/// The starts and goals of a case's queries.
[[nodiscard]] std::vector<oracle::OraclePoint> oracle_ends(const PathCase& path_case);

using PathFinder = std::function<Result<void>(const World&, const PathQuery&, QueryContext&, Path&)>;

/// World::find_path
[[nodiscard]] PathFinder world_finder();

/// Builds the world, asks for every path by every algorithm, and holds the answers against the oracle: blocked ends are
/// those strictly inside a polygon; a path is found exactly when there is one, leads from start to goal, is as long as
/// it says, can be walked by a point agent, and is no shorter than the shortest, which is above its lower bound;
/// `optimal` is no longer either. Between the same ends, rays hit the first wall.
[[nodiscard]] PathReport check_paths(const PathCase& path_case, const PathFinder& find = world_finder());

/// Shrinks a case that fails to the one query that shows it and to the items that it takes, and writes it as a world
/// script into the folder for temporary files. Returns a message with the fault, the file's name and the script.
[[nodiscard]] std::string report_failure(const PathCase& path_case, const std::string& name,
                                         const PathFinder& find = world_finder());

}  // namespace waywright::test
