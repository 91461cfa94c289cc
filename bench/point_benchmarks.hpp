#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workloads.hpp"

namespace waywright::bench {

/// The size of a workload of points. Large ones run only if a filter names them.
struct PointSize {
  std::string prefix;
  std::size_t count;

  [[nodiscard]] std::string name(const std::string& workload) const {
    return prefix + workload + '/' + std::to_string(count);
  }
};

inline const std::vector<PointSize>& point_sizes() {
  static const std::vector<PointSize> sizes = {{"", 10'000}, {"", 100'000}, {"large/", 1'000'000}};
  return sizes;
}

/// The lengths of the rows of lattices with about as many points.
inline const std::vector<PointSize>& lattice_rows() {
  static const std::vector<PointSize> sides = {{"", 100}, {"", 316}, {"large/", 1000}};
  return sides;
}

/// The sizes of a growing world of points, for the time per vertex.
inline const std::vector<PointSize>& growing_sizes() {
  static const std::vector<PointSize> sizes = {{"large/", 100'000}, {"large/", 1'000'000}, {"large/", 10'000'000}};
  return sizes;
}

/// Which points a benchmark locates, and among which vertices.
struct LocationKind {
  std::string name;
  PointsToLocate (*make)(std::size_t count);
};

inline const std::vector<LocationKind>& location_kinds() {
  static const std::vector<LocationKind> kinds = {{"locate", random_points_to_locate},
                                                  {"locate_sorted", sorted_points_to_locate},
                                                  {"locate_uneven", uneven_points_to_locate}};
  return kinds;
}

inline constexpr std::size_t kSegmentCount = 100'000;
inline constexpr std::size_t kThesisPointCounts[] = {1'000, 10'000};
inline constexpr std::size_t kRemovalCount = 200'000;

}  // namespace waywright::bench
