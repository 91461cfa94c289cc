#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "constraint/cover_finder.hpp"
#include "locate/walk.hpp"
#include "memory/pages.hpp"
#include "memory/scratch.hpp"
#include "nav/components.hpp"

namespace waywright::path {

/// Finds the free position nearest to a position that polygons cover. A face is open if no polygon covers it. A
/// position is free if it lies inside an open face or on its border. Use one object for many queries, because it keeps
/// its memory.
class FreePositions {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// The faces with which a free position must be connected: only faces in the components of these faces are allowed.
  struct Connection {
    const nav::Components* components = nullptr;  ///< null if every open face is allowed
    const std::vector<mesh::HalfEdge>* faces = nullptr;

    /// Returns whether the face of `h` is connected with one of the faces.
    [[nodiscard]] bool contains(mesh::HalfEdge h) const;
  };

  /// Returns the nearest free position, rounded to a free point, or nothing if its distance is larger than `limit`. An
  /// exact computation decides which position is nearest and whether it is near enough. Of two equally near positions,
  /// the function takes the first in (x, y) order. It rounds the coordinates of this position. The candidates for
  /// the answer are the rounded position and the eight points around it. The answer is the free one that is nearest to
  /// the rounded position. If none of them is free, the position lies in a narrow wedge between walls. Then the
  /// function looks for a free point farther inside the wedge. It compares this point with the next positions, on other
  /// edges. Requires: no face around `location` is open, `point` lies at `location`, `limit` is positive. Cost: the
  /// covered faces within the distance of the answer, or of `limit`.
  [[nodiscard]] std::optional<Point> nearest(const Triangulation& triangulation, constraint::CoverFinder& cover_finder,
                                             const Point& point, const locate::Located& location, double limit,
                                             const Connection& connection);

 private:
  /// A half-edge of a covered face with an open face beyond it, and its distance, computed in doubles.
  struct Candidate {
    mesh::HalfEdge h;
    double distance;
  };

  void flood(const locate::Located& location, double limit, const Connection& connection);
  void visit(mesh::HalfEdge h, const Connection& connection);
  [[nodiscard]] bool is_refused(mesh::HalfEdge h) const;
  [[nodiscard]] double distance_to(mesh::HalfEdge h) const;
  [[nodiscard]] bool is_open(mesh::HalfEdge h, const Connection& connection);
  [[nodiscard]] bool choose(double limit, const Connection& connection);
  [[nodiscard]] std::optional<Point> round_to_free(const Point& rounded, const Connection& connection);
  void look_in_wedge(mesh::HalfEdge h, const Point& position, double limit, const Connection& connection);
  [[nodiscard]] std::optional<Point> wedge_direction(mesh::HalfEdge h, bool is_at_target) const;
  [[nodiscard]] std::optional<Point> nearest_on_ray(const Point& apex, const Point& direction, double limit,
                                                    const Connection& connection);
  void take_nearer(const Point& found);
  [[nodiscard]] bool is_in_domain(const Point& point) const;
  [[nodiscard]] bool is_free(const Point& point, const Connection& connection);

  const Triangulation* triangulation_ = nullptr;
  constraint::CoverFinder* cover_finder_ = nullptr;
  Point point_;
  double slack_ = 0.0;                  ///< a bound of the rounding error of a distance in doubles
  double nearest_ = 0.0;                ///< `slack_` plus the smaller of `limit` and the least candidate distance
  memory::Pages<std::uint32_t> marks_;  ///< by face: the last search that reached it
  memory::Stamp stamp_;
  std::vector<mesh::HalfEdge> waiting_;
  std::vector<Candidate> candidates_;
  std::vector<mesh::HalfEdge> refused_;  ///< edges that have no free point next to their nearest position
  std::optional<Point> nearest_found_;   ///< the nearest free point that the search has found so far
};

}  // namespace waywright::path
