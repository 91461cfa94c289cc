#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "waywright/point.hpp"

#include "locate/walk.hpp"
#include "mesh/triangle_mesh.hpp"

// The three strategies for the start of a walk that Chen 2009 compares (section 3.2.1). Pass one to locate_by(). The
// library itself uses another one: locate/sectors.hpp.

namespace waywright::bench {

/// The data from which a strategy chooses a start: a triangulated box, the points of its vertices, and the ghost
/// vertex.
template <class Geometry>
struct Ground {
  const mesh::TriangleMesh& mesh;
  const Geometry& geometry;
  mesh::Vertex ghost;

  [[nodiscard]] bool is_inside(mesh::HalfEdge h) const {
    return mesh.origin(h) != ghost && mesh.target(h) != ghost && mesh.apex(h) != ghost;
  }
  /// Returns whether `h`, which was stored earlier, now represents a face in the box.
  [[nodiscard]] bool contains(mesh::HalfEdge h) const {
    return h != mesh::kNoHalfEdge && mesh.is_live(mesh::face(h)) && is_inside(h);
  }
  /// Returns a face in the box that touches the box's border.
  [[nodiscard]] mesh::HalfEdge face_at_border() const { return mesh.twin(mesh::next(mesh.outgoing(ghost))); }
  /// Returns a face in the box that has `v` as a corner. Requires: `v` is live and is not the ghost.
  [[nodiscard]] mesh::HalfEdge at(mesh::Vertex v) const {
    mesh::HalfEdge h = mesh.outgoing(v);
    while (!is_inside(h)) h = mesh.next_around(h);
    return h;
  }
};

/// Starts at the face where the last search ended.
class LastFace {
 public:
  template <class Geometry>
  [[nodiscard]] mesh::HalfEdge start(const Ground<Geometry>& ground, const Point&) const {
    return ground.contains(last_) ? last_ : ground.face_at_border();
  }
  void found(const Point&, mesh::HalfEdge h) { last_ = h; }

 private:
  mesh::HalfEdge last_ = mesh::kNoHalfEdge;
};

/// Jump and walk: starts at the vertex nearest to the point among n^(1/3) random vertices of n. The point is the seed.
/// Source: Mücke, Saias and Zhu, *Fast randomized point location without preprocessing in two- and three-dimensional
/// Delaunay triangulations*, 1996.
class CubeRootSampling {
 public:
  template <class Geometry>
  [[nodiscard]] mesh::HalfEdge start(const Ground<Geometry>& ground, const Point& point) const {
    const std::size_t vertex_count = ground.mesh.vertex_count();
    locate::Random random(point);
    mesh::HalfEdge nearest = ground.face_at_border();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t tries = 0; tries * tries * tries < vertex_count; ++tries) {
      const mesh::Vertex v{random.below(ground.mesh.vertex_slots())};
      if (!ground.mesh.is_live(v) || v == ground.ghost) continue;
      const Point at = ground.geometry.rounded(number(v));
      const double squared = (at.x - point.x) * (at.x - point.x) + (at.y - point.y) * (at.y - point.y);
      if (squared >= least) continue;
      least = squared;
      nearest = ground.at(v);
    }
    return nearest;
  }
  void found(const Point&, mesh::HalfEdge) {}
};

/// A grid of 16 x 16 sectors over the box. Each sector remembers the face where the last search in it ended. If that
/// face no longer exists, starts at the face where the last search in the whole box ended.
class SectorsOfSearches {
 public:
  explicit SectorsOfSearches(const Box& box) : box_(box) { sectors_.fill(mesh::kNoHalfEdge); }

  template <class Geometry>
  [[nodiscard]] mesh::HalfEdge start(const Ground<Geometry>& ground, const Point& point) const {
    const mesh::HalfEdge remembered = sectors_[sector(point)];
    if (ground.contains(remembered)) return remembered;
    return ground.contains(last_) ? last_ : ground.face_at_border();
  }
  void found(const Point& point, mesh::HalfEdge h) {
    sectors_[sector(point)] = h;
    last_ = h;
  }

 private:
  static constexpr std::size_t kRowLength = 16;

  [[nodiscard]] static std::size_t step(double at, double from, double to) {
    const double scaled = (at - from) / (to - from) * double{kRowLength};
    return std::min(static_cast<std::size_t>(std::max(scaled, 0.0)), kRowLength - 1);
  }
  [[nodiscard]] std::size_t sector(const Point& point) const {
    return step(point.y, box_.min.y, box_.max.y) * kRowLength + step(point.x, box_.min.x, box_.max.x);
  }

  Box box_;
  std::array<mesh::HalfEdge, kRowLength * kRowLength> sectors_;
  mesh::HalfEdge last_ = mesh::kNoHalfEdge;
};

/// Locates `point` by a walk from the face that `strategy` chooses, and then reports the face where the walk ended to
/// the strategy.
/// Requires: `point` lies in the box.
template <class Strategy, class Geometry>
[[nodiscard]] locate::Located locate_by(Strategy& strategy, const Ground<Geometry>& ground, const Point& point) {
  const mesh::HalfEdge start = strategy.start(ground, point);
  const locate::Located location =
      locate::walk(ground.mesh, ground.geometry, ground.geometry.view(point), point, mesh::face(start), ground.ghost);
  strategy.found(point, location.h);
  return location;
}

}  // namespace waywright::bench
