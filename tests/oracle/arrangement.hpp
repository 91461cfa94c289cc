#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "oracle/exact.hpp"
#include "oracle/oracle.hpp"

namespace waywright::oracle {

/// A constrained segment with length above 0, a before b in (x, y) order, and the items that have exactly this side.
struct Wall {
  OraclePoint a;
  OraclePoint b;
  ExactPosition exact_a;
  ExactPosition exact_b;
  std::vector<std::uint64_t> ids;
  /// All vertices on the segment, from a to b.
  std::vector<std::uint32_t> vertices;
};

/// All positions of a scene's walls, corners and points.
struct Arrangement {
  explicit Arrangement(const OracleScene& scene);

  Grid grid;
  std::vector<Wall> walls;
  std::vector<ExactPosition> vertices;     ///< in (x, y) order
  std::vector<OraclePoint> near_vertices;  ///< correctly rounded
  std::vector<OracleConstraint> constraints;
  std::size_t crossing_count = 0;  ///< vertices that are not the corner or point of an item

  /// Returns the vertices whose x may lie in a range: the first index and one past the last index.
  [[nodiscard]] std::pair<std::size_t, std::size_t> vertices_between(double min_x, double max_x) const;

 private:
  struct Crossing {
    std::uint32_t first_wall = 0;
    std::uint32_t second_wall = 0;
    ExactPosition at;
  };

  void collect_walls(const OracleScene& scene);
  [[nodiscard]] std::vector<Crossing> find_crossings() const;
  void merge_vertices(const std::vector<OraclePoint>& corners, std::vector<Crossing> crossings);
  void find_vertices_on(Wall& wall) const;
  void collect_constraints();
};

/// Returns the domain's corners, counter-clockwise from the lower left.
[[nodiscard]] std::array<OraclePoint, 4> corners_of(const OracleBox& domain);

/// Replaces -0.0 by 0.0, so that equal points have equal bits.
[[nodiscard]] OraclePoint without_negative_zero(OraclePoint p);

}  // namespace waywright::oracle
