#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/compiler.hpp"
#include "clearance/changed_walls.hpp"
#include "clearance/disc.hpp"
#include "clearance/wall_tree.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "constraint/distances.hpp"
#include "exact/gap.hpp"
#include "memory/scratch.hpp"

namespace waywright::clearance {

/// A convex polygon in doubles that contains all positions z that it should contain, relative to a vertex.
class SearchRegion {
 public:
  /// Starts with a box.
  void begin(const Box& box);
  /// Removes positions for which normal . z surely is larger than `limit`. Each coordinate of the normal may be wrong
  /// by `error`, and the limit by 2 `error` times the magnitudes of the coordinates of the normal.
  void clip(const Point& normal, double limit, double error);
  /// A box that contains the polygon.
  [[nodiscard]] const Box& bounds() const { return bounds_; }
  /// Returns false only if the region surely does not contain the position. Each coordinate of `z` may be wrong by
  /// `error`.
  [[nodiscard]] bool may_contain(const Point& z, double error) const;

  void count_memory(MemoryUse& use) const { memory::count_spare(use, corners_, clipped_, half_planes_); }

 private:
  struct HalfPlane {
    Point normal;
    double limit, error;

    [[nodiscard]] double excess(const Point& z) const { return normal.x * z.x + normal.y * z.y - limit; }
  };

  std::vector<Point> corners_;
  std::vector<Point> clipped_;  ///< scratch of clip()
  std::vector<HalfPlane> half_planes_;
  Box bounds_;
};

/// The end of a line from a vertex that may be a bridge: another vertex, or the foot inside a wall.
struct FarEnd {
  mesh::HalfEdge wall;  ///< one of the two half-edges
  mesh::Vertex vertex;  ///< kNoVertex for a foot
  Point position;       ///< relative to the start
  double error;         ///< bounds the error of each coordinate of `position`
};

/// A search from face to face goes on in the tree of walls when it has come this far. As long as there is no tree, the
/// limits are kBeforeTree times as large, so that most worlds never have one.
struct SearchLimits {
  static constexpr std::uint32_t kBeforeTree = 6;

  std::uint32_t faces = 8;   ///< that a disc touches
  std::uint32_t edges = 4;   ///< that a line crosses
  std::uint32_t spokes = 3;  ///< around a vertex
};

/// The scratch of BridgeFinder. Keep the object: later searches use its memory again.
struct BridgeScratch {
  std::vector<mesh::HalfEdge> to_enter;        ///< half-edges through which ChangedRegion enters faces
  std::vector<mesh::HalfEdge> to_test;         ///< half-edges through which the search for walls in a disc enters faces
  memory::ZeroedArray<std::uint32_t> visited;  ///< by face: the number of the last search that visited it
  memory::Stamp stamp;
  SearchRegion region;           ///< contains the ends of the bridges that find_far_ends() looks for
  std::vector<FarEnd> far_ends;  ///< the result of find_far_ends()

  /// Starts a search that visits each face at most once.
  void begin() { stamp.next(1, visited); }
  /// Returns whether this is the search's first visit of the face.
  [[nodiscard]] bool visit(mesh::Face f) { return std::exchange(visited[number(f)], stamp.value()) != stamp.value(); }

  void count_memory(MemoryUse& use) const {
    memory::count_spare(use, to_enter, to_test, far_ends);
    region.count_memory(use);
    use.spare += visited.size() * sizeof(std::uint32_t);
  }
};

/// Finds the bridges of a mesh, one candidate at a time.
///
/// A *bridge* is the shortest connection between two walls at a gap: the segment from a wall vertex to another
/// wall vertex, or from a wall vertex to the foot of its perpendicular strictly inside a wall. The closed disc whose
/// diameter is the bridge touches walls at the two ends of the bridge only. So a bridge crosses no wall, and no other
/// bridge. A disc whose diameter is larger than the bridge cannot have its centre on the bridge.
///
/// Requires: each vertex of the mesh is the end of a wall. Then
/// - a bridge between two vertices is an edge of the mesh, because its disc contains no other vertex, and
/// - at most one bridge that ends inside a wall starts at each corner of a face.
///
/// All decisions are exact. Only explicit vertices are ends of bridges: where two sides cross, the angles between them
/// are less than 180 degrees. But at each end of a bridge, the angles between the bridge and the nearest walls on its
/// left and on its right are at least 90 degrees.
///
/// Source: the bridges are the Gabriel edges (Gabriel and Sokal 1969) of the walls. Edelsbrunner, *The union of balls
/// and its dual shape*, 1995, explains what the bridges say about discs.
class BridgeFinder {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Requires: if the tree is built, it is up to date. Without a tree, find_wall(), is_bridge() and find_far_bridges()
  /// must not be called.
  explicit BridgeFinder(const Triangulation& triangulation, BridgeScratch& scratch, WallTree* tree = nullptr,
                        const SearchLimits& limits = {})
      : scratch_(scratch),
        tree_(tree),
        limits_(limits),
        triangulation_(triangulation),
        mesh_(triangulation.topology()),
        geometry_(triangulation.triangulation().geometry()),
        rounding_(constraint::largest_rounding(triangulation)),
        errors_(rounding_) {
    scratch.visited.grow_to(mesh_.face_slots());
  }

  /// The limit at present of a search that has one of the members of SearchLimits as its limit.
  [[nodiscard]] std::uint32_t limit(std::uint32_t SearchLimits::*member) const {
    return limits_.*member * (tree_->is_built() ? 1 : SearchLimits::kBeforeTree);
  }

  /// Returns whether surely no bridge starts at the vertex: it is a corner of the domain, or a crossing.
  [[nodiscard]] bool starts_no_bridge(mesh::Vertex v) const {
    const auto& corners = triangulation_.triangulation().domain_corners();
    return !is_explicit(v) || std::find(corners.begin(), corners.end(), v) != corners.end();
  }

  /// Returns one bit for each angle of a face. Bit i is 0 only if the angle at the origin of half-edge i of the face is
  /// at least 90 degrees.
  [[nodiscard]] unsigned acute_angles(mesh::Face f) const;
  /// Returns one bit for each corner of a face. Bit i is 0 only if no foot bridge starts at the origin of half-edge i
  /// and runs into the face: then the angle at another corner is at least 90 degrees. `acute` is acute_angles() of the
  /// face.
  [[nodiscard]] static unsigned corners_with_foot(unsigned acute) {
    constexpr unsigned kAll = 7;
    if (acute == kAll) return kAll;
    const unsigned others = kAll & ~acute;
    return (others & (others - 1)) == 0 ? others : 0;
  }

  /// Returns whether the free edge of `h` is a bridge. Requires: `h` and its twin belong to faces of the domain.
  [[nodiscard]] bool is_bridge(mesh::HalfEdge h);
  /// Looks for the bridge that starts at the origin of `corner`, runs into the face of `corner` and ends inside a wall.
  /// Requires: corners_with_foot() has the corner.
  /// Returns the wall, as a half-edge that has the bridge on its left; kNoHalfEdge if there is no such bridge; or
  /// kTooFar after SearchLimits::edges edges. Then one of the next two functions finds the wall.
  [[nodiscard]] mesh::HalfEdge find_wall(mesh::HalfEdge corner);
  static constexpr mesh::HalfEdge kTooFar{number(mesh::kNoHalfEdge) - 1};
  /// As find_wall(), by a search in the tree.
  [[nodiscard]] mesh::HalfEdge find_far_wall(mesh::HalfEdge corner);
  /// Returns whether the bridge ends on this wall.
  [[nodiscard]] bool is_far_wall(mesh::HalfEdge corner, mesh::HalfEdge wall);
  /// Returns whether the foot of the gap lies strictly inside `wall`, and the gap runs from the origin of `corner` into
  /// its face. Requires: `wall` has the origin of `corner` on its left, and no wall crosses the gap.
  [[nodiscard]] bool has_foot_on(const exact::Gap& gap, mesh::HalfEdge corner, mesh::HalfEdge wall) const;
  /// Calls on_edge(h) or on_corner(h) for each bridge that starts at `w`, exists before or after the operation, ends on
  /// a wall that exists now, and whose disc touches a changed wall; and for some that do not exist. Requires: there are
  /// boxes of changed walls (ChangedWalls::are_all() is false). Cost: a search in the tree, one more for each position
  /// that is left, and for each foot among them the edges of `w`.
  template <class OnEdge, class OnCorner>
  void find_far_bridges(mesh::Vertex w, const ChangedWalls& changed, OnEdge&& on_edge, OnCorner&& on_corner) {
    find_far_ends(w, mesh::kNoHalfEdge, &changed);
    for (const FarEnd& end : scratch_.far_ends) {
      if (!is_far_bridge(w, end, changed)) continue;
      if (end.vertex != mesh::kNoVertex) {
        const mesh::HalfEdge h = mesh_.find(w, end.vertex);
        if (h != mesh::kNoHalfEdge && !mesh_.is_fixed(h)) on_edge(h);
        continue;
      }
      const mesh::HalfEdge wall = wall_facing(end.wall, w);
      mesh_.for_each_outgoing(w, [&](mesh::HalfEdge h) {
        if (triangulation_.triangulation().is_ghost_face(h)) return;
        if (has_foot_on(gap_to_wall(h, wall), h, wall)) on_corner(h);
      });
    }
  }

  /// The disc whose diameter is the edge of `h`.
  [[nodiscard]] Disc disc_of(mesh::HalfEdge h) const {
    return Disc::of_edge(position_of(mesh_.origin(h)), position_of(mesh_.target(h)), rounding_);
  }
  /// The circle through the three vertices of the face of `h`. Its origin is the vertex opposite to the longest edge:
  /// from there, the vectors to the other two are short, and the centre is as exact as possible.
  [[nodiscard]] Disc circle_of(mesh::HalfEdge h) const {
    const Point& a = position_of(mesh_.origin(h));
    const Point& b = position_of(mesh_.target(h));
    const Point& c = position_of(mesh_.apex(h));
    const auto square = [](const Point& p, const Point& q) {
      return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
    };
    const double ab = square(a, b);
    const double bc = square(b, c);
    const double ca = square(c, a);
    if (bc >= ab && bc >= ca) return Disc::of_triangle(a, b, c, rounding_);
    return ca >= ab ? Disc::of_triangle(b, c, a, rounding_) : Disc::of_triangle(c, a, b, rounding_);
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
    return changed.are_all() || changed.is_any([&](const Box& box) { return may_touch(disc, box); });
  }

  /// Returns the gap of a bridge along an edge.
  [[nodiscard]] exact::Gap gap_along(mesh::HalfEdge h) const {
    const Point& to = position_of(mesh_.target(h));
    return {position_of(mesh_.origin(h)), to, to};
  }
  /// Returns the gap of a bridge from the origin of `corner` to its foot inside `wall`.
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
      if (to == mesh::kNoVertex) return disc.may_enter(v, rounding);
      const bool is_from = end == from;
      return !Disc::is_surely_not_acute(v, is_from ? gap.from : gap.a, is_from ? gap.a : gap.from, rounding);
    }
  };

  /// A vertex near the disc of a candidate.
  struct NearVertex {
    Point offset;   ///< the vector from the centre of the disc to the vertex
    double square;  ///< the square of the vertex's distance from the centre
    mesh::Vertex vertex;
    bool is_end;  ///< whether the vertex is an end of the candidate
  };

  /// Returns false only if the box of the wall and the other box have no position in common.
  [[nodiscard]] bool may_overlap(const Box& box, mesh::HalfEdge wall) const {
    const Point& p = position_of(mesh_.origin(wall));
    const Point& q = position_of(mesh_.target(wall));
    return std::min(p.x, q.x) <= box.max.x + rounding_ && std::max(p.x, q.x) >= box.min.x - rounding_ &&
           std::min(p.y, q.y) <= box.max.y + rounding_ && std::max(p.y, q.y) >= box.min.y - rounding_;
  }
  [[nodiscard]] const Point& position_of(mesh::Vertex v) const { return geometry_.rounded(number(v)); }
  [[nodiscard]] bool is_explicit(mesh::Vertex v) const { return geometry_.is_explicit(number(v)); }
  /// Says where `v` lies relative to a gap that ends at a foot on the line from a to b: positive if `v` is farther
  /// along this line than the foot, zero if it lies on the line of the gap, negative otherwise.
  [[nodiscard]] exact::Sign side_of_foot(const exact::Gap& gap, mesh::Vertex v) const;
  [[nodiscard]] bool is_blocked_by(const exact::Gap& gap, mesh::HalfEdge wall) const;
  /// Returns whether a vertex, which is not an end of the candidate, surely lies in the closed disc.
  [[nodiscard]] bool is_blocked_by(const Candidate& candidate, mesh::Vertex v) const {
    return v != candidate.from && v != candidate.to && is_explicit(v) && candidate.disc.surely_contains(position_of(v));
  }
  /// Makes a candidate. Let c be the vector from the origin of its disc to the centre, and t the number in the code.
  /// Then the radius of the disc is at most |c| + t - 8 rounding_. The limit of the candidate is larger than
  /// (|c| + t)^2 (1 + 2^-20)^2, because 2 |c| t is at most 2^-20 c^2 + 2^20 t^2.
  [[nodiscard]] Candidate candidate_of(const exact::Gap& gap, mesh::Vertex from, mesh::Vertex to) const {
    const Disc disc = Disc::of_gap(gap.from, gap.a, gap.b);
    const double square = disc.centre.x * disc.centre.x + disc.centre.y * disc.centre.y;
    const double t = 4.0 * disc.error + 8.0 * rounding_;
    return {gap, from, to, disc, square * (1.0 + 0x1p-18) + 0x1p21 * t * t};
  }
  [[nodiscard]] NearVertex near_vertex(const Candidate& candidate, mesh::Vertex v) const {
    const Point offset = position_of(v) - candidate.disc.origin - candidate.disc.centre;
    return {offset, offset.x * offset.x + offset.y * offset.y, v, v == candidate.from || v == candidate.to};
  }
  /// Returns false only if no point of the segment from `p` to `q` lies in the closed exact disc. The distance of the
  /// segment from the centre is wrong by at most 4 * rounding_, plus 2^-48 of the distances of `p` and `q` and of the
  /// radius. Let r be the radius and d the sum of the two distances. Then (r + 2^-48 d)^2 is less than (1 + 2^-21) r^2
  /// + 2^-74 d^2. So the limit of the candidate and the last term of `limit` below cover this error.
  [[nodiscard]] static bool may_touch(const Candidate& candidate, const NearVertex& p, const NearVertex& q) {
    const Point along = q.offset - p.offset;
    const double at_p = p.offset.x * along.x + p.offset.y * along.y;
    const double at_q = q.offset.x * along.x + q.offset.y * along.y;
    const double limit = candidate.limit + 0x1p-60 * (p.square + q.square);
    const double cross = p.offset.x * along.y - p.offset.y * along.x;
    // The processor cannot predict these tests, so the code combines them without branches.
    const bool is_between = (at_p < 0.0) & (at_q > 0.0);
    const bool is_line_far = cross * cross > limit * (along.x * along.x + along.y * along.y);
    const bool are_ends_far = std::min(p.square, q.square) > limit;
    const bool is_far = (is_between & is_line_far) | (!is_between & are_ends_far);
    return !is_far;
  }
  /// Returns false only if the edge from `p` to `q` contains no position of the closed disc, except an end of the
  /// candidate. An edge at an end of the candidate contains a position strictly inside the disc, or no position of the
  /// disc except the end.
  [[nodiscard]] WAYWRIGHT_ALWAYS_INLINE bool may_enter(const Candidate& candidate, const NearVertex& p,
                                                       const NearVertex& q) const {
    if (p.is_end) return candidate.may_enter_from(p.vertex, position_of(q.vertex), rounding_);
    if (q.is_end) return candidate.may_enter_from(q.vertex, position_of(p.vertex), rounding_);
    return may_touch(candidate, p, q);
  }
  [[nodiscard]] bool is_clear_beyond(const Candidate& candidate, mesh::HalfEdge entry);
  /// Returns whether the angle at `v` between `p` and `q` is surely at least 90 degrees.
  [[nodiscard]] bool is_not_acute(mesh::Vertex p, mesh::Vertex v, mesh::Vertex q) const {
    return Disc::is_surely_not_acute(position_of(p), position_of(v), position_of(q), rounding_);
  }
  void begin_candidate() {
    scratch_.begin();
    face_count_ = 0;
    face_limit_ = limit(&SearchLimits::faces);
    is_surely_clear_ = false;
  }
  [[nodiscard]] bool is_clear_of_all_walls(const Candidate& candidate, const ChangedWalls* ignored);
  [[nodiscard]] mesh::HalfEdge follow_diameter(mesh::HalfEdge corner) const;
  void find_far_ends(mesh::Vertex w, mesh::HalfEdge corner, const ChangedWalls* ignored);
  void exclude_beyond(const Point& p, double error = 0.0);
  void exclude_side(const Point& p);
  void offer_far_wall(mesh::Vertex w, mesh::HalfEdge wall, bool is_ignored);
  [[nodiscard]] bool is_far_bridge(mesh::Vertex w, const FarEnd& end, const ChangedWalls& changed);
  [[nodiscard]] mesh::HalfEdge wall_facing(mesh::HalfEdge wall, mesh::Vertex w) const;
  [[nodiscard]] exact::Sign side_of_diameter(mesh::HalfEdge corner, mesh::HalfEdge entry) const;
  [[nodiscard]] bool is_bridge_to(mesh::HalfEdge corner, mesh::HalfEdge wall);

  BridgeScratch& scratch_;
  WallTree* tree_;
  SearchLimits limits_;
  const Triangulation& triangulation_;
  const mesh::TriangleMesh& mesh_;
  const exact::Geometry& geometry_;
  double rounding_;
  Diameter::Errors errors_;
  std::uint32_t face_count_ = 0;  ///< the faces that the search in the disc of the present candidate has visited
  std::uint32_t face_limit_ = 0;
  bool is_surely_clear_ = false;  ///< whether the tree says that no wall touches this disc
};

}  // namespace waywright::clearance
