#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "clearance/changed_walls.hpp"
#include "clearance/disc.hpp"
#include "constraint/exact_triangulation.hpp"
#include "constraint/rounding.hpp"
#include "exact/gap.hpp"
#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"

namespace waywright::clearance {

/// The scratch of BridgeFinder. Keep the object: later searches use its memory again.
struct BridgeScratch {
  /// A vertex, relative to a corner of a face from which a search starts.
  struct Seen {
    Point offset;   ///< from the corner
    double square;  ///< of the distance from the corner
    double error;   ///< see BridgeFinder::seen_from()
    mesh::Vertex vertex;
    std::uint32_t beyond;  ///< bits for the two lines that BridgeFinder::find_wall() describes: 1 for x, 2 for y
  };
  /// An edge that a corner sees, at least in part. The numbers are indices in `seen`.
  struct VisibleEdge {
    mesh::HalfEdge entry;
    std::uint32_t left;  ///< the vertices that bound the part of the edge that the corner sees
    std::uint32_t right;
    std::uint32_t entry_left;  ///< the ends of the edge
    std::uint32_t entry_right;
  };
  /// A vertex near the disc of a candidate.
  struct Around {
    Point offset;   ///< from the centre of the disc
    double square;  ///< of the distance from the centre
  };
  /// A face that the disc of a candidate may meet, beyond the edge of `entry`, a half-edge of this face.
  struct Beyond {
    mesh::HalfEdge entry;
    Around origin;  ///< the ends of the edge
    Around target;
  };

  std::vector<mesh::HalfEdge> to_enter;  ///< half-edges through which a search enters faces
  std::vector<Seen> seen;  ///< by a search from one corner; the first two are x and y of BridgeFinder::find_wall()
  std::vector<VisibleEdge> to_cross;
  std::vector<Beyond> to_clear;
  memory::ZeroedArray<std::uint8_t> acute;     ///< by face: see BridgeFinder::note_angles()
  memory::ZeroedArray<std::uint32_t> visited;  ///< by face: the number of the last search that visited it
  memory::Stamp stamp;

  /// Starts a search that visits each face at most once.
  void begin() { stamp.next(1, visited); }
  /// Returns whether this is the search's first visit of the face.
  [[nodiscard]] bool visit(mesh::Face f) { return std::exchange(visited[number(f)], stamp.value()) != stamp.value(); }
};

/// Finds the bridges of a mesh, one candidate at a time.
///
/// A *bridge* is the shortest connection between two pieces of wall at a gap: the segment from a wall vertex to another
/// wall vertex, or from a wall vertex to the foot of its perpendicular strictly inside a wall. The closed disc whose
/// diameter is the bridge touches walls at the two ends of the bridge only. So a bridge crosses no wall, and no other
/// bridge. A disc whose diameter is larger than the bridge cannot have its centre on the bridge.
///
/// Requires: each vertex of the mesh is the end of a wall. Then
/// - a bridge between two vertices is an edge of the mesh, because the empty disc proves that it is Delaunay, and
/// - at each corner of a face starts at most one bridge that ends inside a wall.
///
/// All decisions are exact. Only explicit vertices are ends of bridges: where two sides cross, the angles between them
/// are less than 180 degrees, and a bridge needs 90 degrees on its left and on its right.
///
/// Source: the bridges are the Gabriel edges (Gabriel and Sokal 1969) of the walls. Edelsbrunner, *The union of balls
/// and its dual shape*, 1995, explains what the bridges say about discs.
class BridgeFinder {
 public:
  using Triangulation = constraint::ExactTriangulation;

  BridgeFinder(const Triangulation& triangulation, BridgeScratch& scratch)
      : scratch_(scratch),
        triangulation_(triangulation),
        mesh_(triangulation.topology()),
        geometry_(triangulation.triangulation().geometry()),
        rounding_(constraint::largest_rounding(triangulation)),
        relative_error_(rounding_ > 0.0 ? 0x1p-20 : 0x1p-48),
        absolute_error_(0x1p25 * rounding_ * rounding_) {
    scratch.acute.grow_to(mesh_.face_slots());
    scratch.visited.grow_to(mesh_.face_slots());
  }

  /// Notes for each angle of a face whether it is acute: bit i of the entry of `acute` is 0 only if the angle at the
  /// origin of half-edge i of the face is at least 90 degrees.
  void note_angles(mesh::Face f);
  /// The entry of `acute`. Requires: note_angles() was called for this face.
  [[nodiscard]] unsigned acute_angles(mesh::Face f) const { return scratch_.acute[number(f)]; }
  /// Returns false only if no foot bridge starts at corner `i` of a face, 0, 1 or 2, and runs into the face. `acute` is
  /// acute_angles() of the face.
  [[nodiscard]] static bool may_have_foot(unsigned acute, unsigned i) { return (acute | 1U << i) == 7U; }
  /// Returns false only if the edge is no bridge. Requires: note_angles() was called for both faces.
  [[nodiscard]] bool may_be_bridge(mesh::HalfEdge h) const {
    const auto may_be_acute = [&](mesh::HalfEdge at) {
      return (acute_angles(mesh::face(at)) >> (number(at) % 3) & 1U) != 0;
    };
    return may_be_acute(mesh::previous(h)) && may_be_acute(mesh::previous(mesh_.twin(h)));
  }

  /// Returns whether the free edge of `h` is a bridge. Requires: `h` and its twin belong to faces of the domain.
  [[nodiscard]] bool is_bridge(mesh::HalfEdge h);
  /// Looks for the bridge that starts at the origin of `corner`, runs into the face of `corner` and ends inside a wall.
  /// Returns the wall, as a half-edge that has the bridge on its left, or kNoHalfEdge if there is no such bridge.
  [[nodiscard]] mesh::HalfEdge find_wall(mesh::HalfEdge corner);

  /// The disc whose diameter is the edge of `h`.
  [[nodiscard]] Disc disc_of(mesh::HalfEdge h) const {
    return Disc::of_edge(position_of(mesh_.origin(h)), position_of(mesh_.target(h)), rounding_);
  }
  /// The circle through the three vertices of the face of `h`.
  [[nodiscard]] Disc circle_of(mesh::HalfEdge h) const {
    return Disc::of_triangle(position_of(mesh_.origin(h)), position_of(mesh_.target(h)), position_of(mesh_.apex(h)),
                             rounding_);
  }
  /// Returns false only if no position of the edge `border`, without its ends, lies strictly inside the circle of the
  /// face of `h`.
  [[nodiscard]] bool may_circle_meet(mesh::HalfEdge h, mesh::HalfEdge border) const;
  /// Returns false only if no position of the edge `border`, without its ends, lies strictly inside the disc whose
  /// diameter is the edge of `h`. Requires: `border` is another edge.
  [[nodiscard]] bool may_disc_meet(mesh::HalfEdge h, mesh::HalfEdge border) const;
  /// Returns false only if no point of the edge lies in the closed exact disc.
  [[nodiscard]] bool may_touch(const Disc& disc, mesh::HalfEdge h) const {
    return disc.may_touch(position_of(mesh_.origin(h)), position_of(mesh_.target(h)), rounding_);
  }

  /// Returns false only if no point of the box lies in the closed exact disc.
  [[nodiscard]] bool may_touch(const Disc& disc, const Box& box) const { return disc.may_touch(box, rounding_); }
  /// Returns false only if no changed wall touches the closed exact disc.
  [[nodiscard]] bool may_touch(const Disc& disc, const ChangedWalls& changed) const {
    if (changed.are_all()) return true;
    const auto& boxes = changed.boxes();
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return may_touch(disc, box); });
  }

  /// The first function returns the gap of a bridge along an edge. The second one returns the gap of a bridge from the
  /// origin of `corner` to its foot inside `wall`.
  [[nodiscard]] exact::Gap gap_along(mesh::HalfEdge h) const {
    const Point& to = position_of(mesh_.target(h));
    return {position_of(mesh_.origin(h)), to, to};
  }
  [[nodiscard]] exact::Gap gap_to_wall(mesh::HalfEdge corner, mesh::HalfEdge wall) const;

 private:
  /// A gap that may be a bridge.
  struct Candidate {
    exact::Gap gap;
    mesh::Vertex from;
    mesh::Vertex to;  ///< kNoVertex if the gap ends at a foot
    Disc disc;
    double limit;  ///< the square of a radius that is larger than the disc's: see may_touch()

    /// Returns false only if the segment from an end to `v` contains no position strictly inside the exact disc. Each
    /// coordinate of `v` may be wrong by `rounding`.
    [[nodiscard]] bool may_enter_from(mesh::Vertex end, const Point& v, double rounding) const {
      return end == from ? disc.may_enter(v, rounding) : !Disc::is_surely_not_acute(v, gap.a, gap.from, rounding);
    }
  };

  [[nodiscard]] const Point& position_of(mesh::Vertex v) const { return geometry_.rounded(number(v)); }
  [[nodiscard]] bool is_explicit(mesh::Vertex v) const { return geometry_.is_explicit(number(v)); }
  /// Says where `v` lies relative to a gap that ends at a foot on the line from a to b: positive if `v` is farther
  /// along this line than the foot, zero if it lies on the line of the gap, negative otherwise.
  [[nodiscard]] exact::Sign side_of_foot(const exact::Gap& gap, mesh::Vertex v) const;
  [[nodiscard]] bool has_foot_on(const exact::Gap& gap, mesh::HalfEdge corner, mesh::HalfEdge wall) const;
  [[nodiscard]] bool is_blocked_by(const exact::Gap& gap, mesh::HalfEdge wall) const;
  /// Returns whether a vertex, which is not an end of the candidate, surely lies in the closed disc.
  [[nodiscard]] bool is_blocked_by(const Candidate& candidate, mesh::Vertex v) const {
    return v != candidate.from && v != candidate.to && is_explicit(v) && candidate.disc.surely_contains(position_of(v));
  }
  [[nodiscard]] Candidate candidate_of(const exact::Gap& gap, mesh::Vertex from, mesh::Vertex to) const {
    const Disc disc = Disc::of_gap(gap.from, gap.a, gap.b);
    const double radius = (disc.radius + 8.0 * rounding_) * (1.0 + 0x1p-20);
    return {gap, from, to, disc, radius * radius};
  }
  [[nodiscard]] BridgeScratch::Around around(const Candidate& candidate, mesh::Vertex v) const {
    const Point offset = position_of(v) - candidate.disc.origin - candidate.disc.centre;
    return {offset, offset.x * offset.x + offset.y * offset.y};
  }
  /// Returns false only if no point of the segment from `p` to `q` lies in the closed exact disc. The distance of the
  /// segment is wrong by at most 2^-48 of the distances of `p` and `q` and of the radius, plus 4 * rounding_. (r +
  /// 2^-48 d)^2 is less than (1 + 2^-21) r^2 + 2^-74 d^2, so the limit of the candidate and the term below cover this
  /// error.
  [[nodiscard]] static bool may_touch(const Candidate& candidate, const BridgeScratch::Around& p,
                                      const BridgeScratch::Around& q) {
    const Point along = q.offset - p.offset;
    const double at_p = p.offset.x * along.x + p.offset.y * along.y;
    const double at_q = q.offset.x * along.x + q.offset.y * along.y;
    const double limit = candidate.limit + 0x1p-60 * (p.square + q.square);
    if (!((at_p < 0.0) & (at_q > 0.0))) return !(std::min(p.square, q.square) > limit);
    const double cross = p.offset.x * along.y - p.offset.y * along.x;
    return !(cross * cross > limit * (along.x * along.x + along.y * along.y));
  }
  [[nodiscard]] bool is_clear(const Candidate& candidate);
  [[nodiscard]] bool is_clear_in(const Candidate& candidate, const BridgeScratch::Beyond& beyond);
  [[nodiscard]] bool is_clear_at(const Candidate& candidate, mesh::HalfEdge h, const BridgeScratch::Around& origin,
                                 const BridgeScratch::Around& target);
  [[nodiscard]] bool enter(const Candidate& candidate, mesh::HalfEdge h, const BridgeScratch::Around& origin,
                           const BridgeScratch::Around& target);
  /// Returns whether the angle at `v` between `p` and `q` is surely at least 90 degrees.
  [[nodiscard]] bool is_not_acute(mesh::Vertex p, mesh::Vertex v, mesh::Vertex q) const {
    return Disc::is_surely_not_acute(position_of(p), position_of(v), position_of(q), rounding_);
  }
  /// What the search of find_wall() decides at the apex of the face beyond a visible edge: which of the two edges of
  /// the apex a bridge may cross, and whether the apex lies right of the left bound of the visible part, and left of
  /// its right bound.
  struct Choice {
    bool crosses_left;
    bool crosses_right;
    bool sees_left;
    bool sees_right;
  };
  [[nodiscard]] mesh::HalfEdge cross(mesh::HalfEdge corner, const Point& from, BridgeScratch::VisibleEdge& visible);
  [[nodiscard]] mesh::HalfEdge go_on(mesh::HalfEdge corner, const BridgeScratch::Seen& apex, Choice choice,
                                     BridgeScratch::VisibleEdge& visible);
  [[nodiscard]] bool is_bridge_to(mesh::HalfEdge corner, mesh::HalfEdge wall);
  /// The errors of two vertices together bound the error of their cross product, and of the difference between their
  /// dot product and a square. Each coordinate of an offset may be wrong by r = 2 * rounding_, and by half an ulp. So a
  /// product of two vertices is wrong by at most r (|p| + |q|) + 2 r^2, where |p| is the sum of two magnitudes, and by
  /// 2^-49 (p^2 + q^2). Because 2 r |p| is at most 2^-22 |p|^2 + 2^22 r^2, and |p|^2 at most 2 p^2, all errors together
  /// are at most 2^-20 (p^2 + q^2) + 2^24 r^2.
  [[nodiscard]] BridgeScratch::Seen seen_from(const Point& corner, mesh::Vertex v) const {
    const Point offset = position_of(v) - corner;
    const double square = offset.x * offset.x + offset.y * offset.y;
    return {offset, square, relative_error_ * square + absolute_error_, v, 0};
  }
  /// Returns whether the angle at `v` between the corner and `p` is surely at least 90 degrees. If c is the corner,
  /// then (c - v) . (p - v) = (v - c)^2 - (v - c) . (p - c).
  [[nodiscard]] static bool is_not_acute(const BridgeScratch::Seen& v, const BridgeScratch::Seen& p) {
    return v.offset.x * p.offset.x + v.offset.y * p.offset.y - v.square >= v.error + p.error;
  }
  /// The bits of `v` for the two lines that find_wall() describes: whether it surely lies beyond the line or on it.
  [[nodiscard]] std::uint32_t beyond_lines(const BridgeScratch::Seen& v) const {
    return std::uint32_t{is_not_acute(scratch_.seen[0], v)} | std::uint32_t{is_not_acute(scratch_.seen[1], v)} << 1;
  }
  /// Returns false only if the angle between the corner and `q` at `p`, or the angle between the corner and `p` at `q`,
  /// is at least 90 degrees.
  [[nodiscard]] static bool may_cross(const BridgeScratch::Seen& p, const BridgeScratch::Seen& q) {
    const double dot = p.offset.x * q.offset.x + p.offset.y * q.offset.y;
    return !(dot - std::min(p.square, q.square) >= p.error + q.error);
  }
  /// Returns whether, as seen from the corner at `w`, `p` lies strictly left of `q`.
  [[nodiscard]] bool is_left_of(mesh::Vertex w, const BridgeScratch::Seen& p, const BridgeScratch::Seen& q) const {
    const double cross = q.offset.x * p.offset.y - q.offset.y * p.offset.x;
    if (std::abs(cross) > p.error + q.error) return cross > 0.0;
    const auto view = [&](mesh::Vertex v) { return geometry_.view(number(v)); };
    return geometry_.orientation(view(w), view(q.vertex), view(p.vertex)) == exact::Sign::positive;
  }

  BridgeScratch& scratch_;
  const Triangulation& triangulation_;
  const mesh::TriangleMesh& mesh_;
  const exact::Geometry& geometry_;
  double rounding_;
  double relative_error_;  ///< see seen_from()
  double absolute_error_;
};

}  // namespace waywright::clearance
