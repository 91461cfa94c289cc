#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace waywright::bench {

/// A size of a workload of points; large ones are run only on demand.
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

/// The sides of lattices: about as many points.
inline const std::vector<PointSize>& lattice_sides() {
  static const std::vector<PointSize> sides = {{"", 100}, {"", 316}, {"large/", 1000}};
  return sides;
}

inline constexpr std::size_t kThesisPointCounts[] = {1'000, 10'000};
inline constexpr std::size_t kRemovalCount = 200'000;

}  // namespace waywright::bench
