#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "waywright/point.hpp"

#include "clearance/disc_passage.hpp"
#include "clearance/near_walls.hpp"
#include "clearance/offset_curve.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "constraint/cover_finder.hpp"
#include "memory/scratch.hpp"

namespace waywright::clearance {

/// Among all positions where a disc fits, finds the nearest one to a given point. Use one object for many queries,
/// because it keeps its memory.
///
/// The search visits faces in the order of their distances from the point. For each wall it takes the two offset curves
/// of the wall, and for each vertex the circle around it. clip() removes from a curve the positions that are too near
/// to another wall. At each remaining position, the disc fits and touches the curve's wall. Rounding errors can add
/// positions, but they never remove one. The nearest position of each remaining interval is a candidate. The search
/// stops when no other candidate and no other wall can give a nearer position.
///
/// Exact predicates check each answer. The search rounds a candidate to a point where the disc fits: it first
/// tries the nearest point, then points at larger and larger distances from the walls.
class NearestFit {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  struct Query {
    Point point;
    double radius = 0.0;  ///< above 0
    double limit = 0.0;   ///< the largest distance of the answer from the point; may be infinity
  };
  /// A goal: the answer must be a position from which the disc can move to the goal.
  struct Goal {
    const Triangulation& walls;
    const Bridges& bridges;
    CellEdge cell;  ///< an edge of the cell that contains the goal; the disc fits at the goal
  };

  /// Returns the nearest point where the disc fits, or nothing if there is none within the limit. If `goal` is not
  /// null, the answer is the nearest of the points from which the disc can move to the goal. Of equally near points,
  /// the first in (x, y) order is the answer. Requires: the point lies in the domain.
  [[nodiscard]] std::optional<Point> find(const Triangulation& triangulation, constraint::CoverFinder& cover_finder,
                                          NearWalls& near_walls, const Query& query, const Goal* goal);

 private:
  enum class Kind : std::uint8_t {
    enter,      ///< the face of `h`, which the search has not entered yet
    line,       ///< an interval of an offset line of which nothing has been removed yet: an element of `pieces_`
    circle,     ///< the circle around a vertex, the origin of `h`
    candidate,  ///< an interval without the positions that walls block: an element of `pieces_`
  };
  struct Entry {
    double bound;  ///< no position that the entry can give is nearer to the query's point than this
    Kind kind;
    mesh::HalfEdge h;
    std::uint32_t piece;  ///< index in `pieces_`, if the kind is line or candidate
  };
  struct Piece {
    OffsetCurve curve;
    OffsetCurve::Interval interval;
    mesh::HalfEdge h;  ///< of a line: the wall with the line on its left; of a circle: starts at its vertex
  };
  /// The best answer so far.
  struct Best {
    bool is_found = false;
    Point at;
    double distance = 0.0;
  };

  void push(double bound, Kind kind, mesh::HalfEdge h, std::uint32_t piece);
  [[nodiscard]] Entry pop();
  void enter(mesh::HalfEdge h);
  void look(mesh::HalfEdge h);
  void add_line(mesh::HalfEdge wall);
  void add_circle(mesh::HalfEdge h);
  void push_piece(Kind kind, const Piece& piece);
  void clip_line(std::uint32_t piece);
  void clip_circle(mesh::HalfEdge h);
  [[nodiscard]] bool is_outside(mesh::HalfEdge h, const Point& direction);
  void clip(const OffsetCurve& curve, mesh::HalfEdge own);
  void block(const OffsetCurve& curve, mesh::HalfEdge wall);
  void divide_at_gaps(const OffsetCurve& curve, mesh::HalfEdge own, mesh::HalfEdge wall);

  void settle(const Piece& piece);
  [[nodiscard]] mesh::HalfEdge blocker_at(const Piece& piece, double parameter) const;
  [[nodiscard]] double sharpened(const Piece& piece, double parameter) const;
  [[nodiscard]] Point inward(const Piece& piece, double parameter) const;
  [[nodiscard]] bool push_inwards(const Point& from, const Point& direction, double least, double most);
  [[nodiscard]] bool try_around(const Point& position);
  void follow(const Piece& piece, double parameter, double end);
  [[nodiscard]] bool try_at(const Point& position);
  [[nodiscard]] bool try_point(const Point& point);
  [[nodiscard]] bool fits(const Point& point);
  [[nodiscard]] bool is_allowed(const Point& point);
  [[nodiscard]] const Point& position(mesh::Vertex v) const;
  [[nodiscard]] bool is_explicit(mesh::Vertex v) const;

  const Triangulation* triangulation_ = nullptr;
  constraint::CoverFinder* cover_finder_ = nullptr;
  NearWalls* near_walls_ = nullptr;
  const Goal* goal_ = nullptr;
  Query query_;
  Best best_;
  double rounding_ = 0.0;    ///< a bound of the rounding error of a coordinate of a constructed vertex
  double largest_ = 0.0;     ///< the largest magnitude of a coordinate of the domain
  double step_ = 0.0;        ///< at least half of the distance of neighbouring doubles near the candidate
  std::vector<Entry> open_;  ///< a heap
  std::vector<Piece> pieces_;
  OffsetCurve::Intervals intervals_;
  std::vector<mesh::HalfEdge> to_cross_;
  memory::ZeroedArray<std::uint32_t> entered_;  ///< by face: the last query that entered it
  memory::ZeroedArray<std::uint32_t> seen_;     ///< by vertex: the last query that saw it
  memory::ZeroedArray<std::uint32_t> clipped_;  ///< by face: the last call of clip() that entered it
  memory::Stamp stamp_;
  memory::Stamp clip_stamp_;
  DiscReach reach_;
};

}  // namespace waywright::clearance
