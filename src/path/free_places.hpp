#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "constraint/cover.hpp"
#include "constraint/exact_triangulation.hpp"
#include "locate/walk.hpp"
#include "memory/pages.hpp"
#include "memory/stamp.hpp"
#include "nav/components.hpp"

namespace waywright::path {

/// Finds the free place nearest to a place that polygons cover. A place is free if it lies in or on the border of an
/// open face: one that no polygon covers. Keep the object: its memory serves many queries.
class FreePlaces {
 public:
  using Triangulation = constraint::ExactTriangulation;

  /// The faces that a free place must be joined with: only faces of the same component count as open.
  struct Joined {
    const nav::Components* components = nullptr;  ///< null if any open face will do
    const std::vector<mesh::HalfEdge>* faces = nullptr;
  };

  /// The nearest free place, rounded to a double that is free itself, or nothing if it is farther than `limit`. Which
  /// place is nearest, and whether it is near enough, is decided exactly; of two equally near, the first in (x, y)
  /// order is taken. Of the doubles around it, the free one that is nearest to it, rounded, is the answer. Requires: no
  /// face around `place`, which is where `point` lies, is open; `limit` is positive. Cost: the covered faces within the
  /// distance of the answer, or of `limit`.
  [[nodiscard]] std::optional<Point> nearest(const Triangulation& triangulation, constraint::Cover& cover,
                                             const Point& point, const locate::Located& place, double limit,
                                             const Joined& joined);

 private:
  /// A half-edge of a covered face with an open face beyond it, and its distance in doubles.
  struct Candidate {
    mesh::HalfEdge h;
    double distance;
  };

  void flood(const locate::Located& place, double limit, const Joined& joined);
  void visit(mesh::HalfEdge h, const Joined& joined);
  [[nodiscard]] double distance_to(mesh::HalfEdge h) const;
  [[nodiscard]] bool is_open(mesh::HalfEdge h, const Joined& joined);
  [[nodiscard]] std::optional<Point> choose(double limit, const Joined& joined);
  [[nodiscard]] std::optional<Point> round_to_free(const Point& rounded, const Joined& joined);
  [[nodiscard]] bool is_free(const Point& point, const Joined& joined);

  const Triangulation* triangulation_ = nullptr;
  constraint::Cover* cover_ = nullptr;
  Point point_;
  double slack_ = 0.0;                  ///< more than the rounding errors of a distance in doubles
  double nearest_ = 0.0;                ///< no candidate's distance in doubles is smaller
  memory::Pages<std::uint32_t> marks_;  ///< by face: the query that reached it last
  memory::Stamp stamp_;
  std::vector<mesh::HalfEdge> waiting_;
  std::vector<Candidate> candidates_;
};

}  // namespace waywright::path
