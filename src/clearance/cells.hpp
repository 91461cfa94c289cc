#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "clearance/bridges.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "exact/gap.hpp"

namespace waywright::clearance {

/// A piece of the border of a cell, in the direction that has the cell on its left.
struct CellEdge {
  enum class Kind : std::uint8_t {
    bridge,     ///< a bridge along an edge: `h` has the cell on its left
    foot_down,  ///< a foot bridge, from its vertex to its foot: `h` is its corner
    foot_up,    ///< a foot bridge, from its foot to its vertex: `h` is its corner
    wall,       ///< a piece of a wall: `h` has the cell on its left
  };

  Kind kind = Kind::wall;
  mesh::HalfEdge h = mesh::kNoHalfEdge;
  /// The number of the foot bridge. For a wall, the foot bridge at whose foot the piece of the wall starts, or kNone if
  /// the piece starts at the origin of `h`.
  std::uint32_t foot = Bridges::kNone;

  [[nodiscard]] bool is_gate() const { return kind != Kind::wall; }
  friend bool operator==(const CellEdge&, const CellEdge&) = default;
};

/// The cells: the regions into which walls and bridges divide the domain. A disc moves from one cell to the next across
/// a bridge (a *gate*). It can cross the gate if its diameter is not larger than the length of the bridge.
///
/// Two facts make cells the right pieces for discs:
/// - The wall that is nearest to a position lies on the border of the position's cell: a straight line to the nearest
///   wall crosses no bridge. So a disc in a cell touches only walls of this cell.
/// - If a disc fits at two positions of one cell, these positions are connected for this disc: within a cell, the
///   distance to the walls has one maximum.
///
/// A cell is not stored. next() follows its border, and across() leads to the cell beyond a gate. Cost of next(): the
/// degree of the vertex at the end of the edge.
class Cells {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  Cells(const Triangulation& triangulation, const Bridges& bridges)
      : triangulation_(triangulation), mesh_(triangulation.topology()), bridges_(bridges) {}

  /// The next edge on the border of the same cell.
  [[nodiscard]] CellEdge next(const CellEdge& edge) const;
  /// The same bridge as an edge of the cell beyond it. Requires: the edge is a gate.
  [[nodiscard]] CellEdge across(const CellEdge& gate) const;
  /// The vertex at which the edge starts, or kNoVertex if it starts at a foot.
  [[nodiscard]] mesh::Vertex origin(const CellEdge& edge) const;
  /// The bridge as a gap.
  [[nodiscard]] exact::Gap gap(const CellEdge& gate) const;
  /// The position of a vertex of the cell's border near the edge, in doubles.
  [[nodiscard]] Point position_near(const CellEdge& edge) const {
    return triangulation_.triangulation().geometry().rounded(number(mesh_.origin(edge.h)));
  }
  /// The bridge as a gap that depends only on the walls, not on the direction of the gate. A bridge
  /// between two vertices starts at the first of them in (x, y) order. A foot bridge ends on the line of the first
  /// side, in the order of positions, that lies on its wall.
  [[nodiscard]] exact::Gap canonical_gap(const CellEdge& gate) const;
  /// A number that only one cell has: edges of different cells have different numbers. Each gate has a number of its
  /// own, and so has each piece of a wall that starts at a vertex. A piece that starts at a foot has the number of the
  /// gate before it. All numbers are below key_count().
  [[nodiscard]] std::uint32_t key(const CellEdge& edge) const;
  [[nodiscard]] std::size_t key_count() const {
    return std::size_t{3} * mesh_.face_slots() + 2 * bridges_.foot_slots();
  }

  /// Turns clockwise around the origin of `h`, from the direction of `h` on, to the first wall or bridge. Returns this
  /// wall or bridge, as the edge that starts at the origin of `h`. The cell on the left of the result contains the
  /// positions near the origin of `h` in the directions that the function has passed.
  [[nodiscard]] CellEdge first_clockwise(mesh::HalfEdge h) const;

 private:
  [[nodiscard]] CellEdge next_at_corner(mesh::HalfEdge corner) const;

  const Triangulation& triangulation_;
  const mesh::TriangleMesh& mesh_;
  const Bridges& bridges_;
};

/// A gate, with its length in doubles.
struct MeasuredGate {
  CellEdge edge;
  double length;
};

/// Compares the lengths of two gates exactly. Doubles decide if the lengths differ by more than the rounding errors.
/// Positions decide between gates of equal length, so that the answer does not depend on the order in which a search
/// sees them.
[[nodiscard]] inline bool is_shorter(const Cells& cells, const MeasuredGate& p, const MeasuredGate& q) {
  constexpr double kRoundingMargin = 0x1p-40;
  if (std::abs(p.length - q.length) > kRoundingMargin * std::max(p.length, q.length)) return p.length < q.length;
  const auto order = exact::compare_lengths(cells.gap(p.edge), cells.gap(q.edge));
  if (order != 0) return order < 0;
  const exact::Gap p_gap = cells.canonical_gap(p.edge);
  const exact::Gap q_gap = cells.canonical_gap(q.edge);
  const auto key = [](const exact::Gap& gap) {
    return std::tie(gap.from.x, gap.from.y, gap.a.x, gap.a.y, gap.b.x, gap.b.y);
  };
  return key(p_gap) < key(q_gap);
}

}  // namespace waywright::clearance
