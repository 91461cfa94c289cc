#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "oracle/exact.hpp"
#include "oracle/oracle.hpp"

namespace waywright::oracle {

/// A constrained segment of some length, a before b in (x, y) order, and the items with just this side.
struct Wall {
  OraclePoint a;
  OraclePoint b;
  ExactPoint exact_a;
  ExactPoint exact_b;
  std::vector<std::uint64_t> ids;
  /// All vertices on it, from a to b.
  std::vector<std::uint32_t> vertices;
};

/// All places where a scene's walls, corners and points are.
struct Arrangement {
  explicit Arrangement(const OracleScene& scene);

  Grid grid;
  std::vector<Wall> walls;
  std::vector<ExactPoint> vertices;        ///< in (x, y) order
  std::vector<OraclePoint> near_vertices;  ///< correctly rounded
  std::vector<OracleConstraint> constraints;
  std::size_t crossing_count = 0;  ///< vertices that are no item's corner or point

  /// The vertices whose x may lie in a range: their first index and one past their last.
  [[nodiscard]] std::pair<std::size_t, std::size_t> vertices_between(double min_x, double max_x) const;

 private:
  struct Crossing {
    std::uint32_t first_wall = 0;
    std::uint32_t second_wall = 0;
    ExactPoint at;
  };

  void collect_walls(const OracleScene& scene);
  [[nodiscard]] std::vector<Crossing> find_crossings() const;
  void merge_vertices(const std::vector<OraclePoint>& corners, std::vector<Crossing> crossings);
  void find_vertices_on(Wall& wall) const;
  void collect_constraints();
};

/// The domain's corners, counter-clockwise from its lower left.
[[nodiscard]] std::array<OraclePoint, 4> corners_of(const OracleBox& domain);

/// -0.0 becomes 0.0, so that equal points have equal bits.
[[nodiscard]] OraclePoint without_negative_zero(OraclePoint p);

}  // namespace waywright::oracle
