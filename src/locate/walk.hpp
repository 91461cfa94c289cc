#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "waywright/point.hpp"

#include "base/compiler.hpp"
#include "exact/position.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::locate {

/// The random numbers of one walk. The seed is the point that the walk searches for, never a clock or a former search.
/// Source: Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014 (SplitMix64).
class Random {
 public:
  explicit Random(const Point& seed)
      : state_(base::bit_cast<std::uint64_t>(seed.x) * 0x9e3779b97f4a7c15u ^ base::bit_cast<std::uint64_t>(seed.y)) {}

  [[nodiscard]] bool coin() {
    if (left_ == 0) refill();
    const bool heads = (bits_ & 1) != 0;
    bits_ >>= 1;
    --left_;
    return heads;
  }

  /// A number from 0 to count - 1. The remainder makes some numbers more likely than others, but far too little to
  /// matter for the choice of a hint. Requires: `count` is not 0.
  [[nodiscard]] std::uint32_t below(std::uint32_t count) {
    refill();
    left_ = 0;
    return static_cast<std::uint32_t>(bits_ % count);
  }

 private:
  void refill() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    bits_ = z ^ (z >> 31);
    left_ = 64;
  }

  std::uint64_t state_;
  std::uint64_t bits_ = 0;
  int left_ = 0;
};

/// The kinds of a location.
enum class LocatedKind : std::uint8_t { vertex, edge, face };

/// The location of a point: at the origin of `h`, on the edge of `h` between its ends, or inside the face of `h`.
struct Located {
  LocatedKind kind = LocatedKind::face;
  mesh::HalfEdge h = mesh::kNoHalfEdge;
  std::size_t steps = 0;  ///< the number of faces that the walk left
};

/// The location of a point in the closed face of `h`, from its orientations relative to `h`, to the next and to the
/// previous half-edge. For a point inside the face, `h` of the result is the first half-edge of the face. Requires: no
/// orientation is negative.
inline Located locate_in_face(mesh::HalfEdge h, exact::Sign h_side, exact::Sign next_side, exact::Sign previous_side) {
  using exact::Sign;
  const mesh::HalfEdge next = mesh::next(h);
  const mesh::HalfEdge previous = mesh::previous(h);
  const bool on_next = next_side == Sign::zero;
  const bool on_previous = previous_side == Sign::zero;
  if (h_side == Sign::zero) {
    if (on_previous) return {LocatedKind::vertex, h, 0};
    return on_next ? Located{LocatedKind::vertex, next, 0} : Located{LocatedKind::edge, h, 0};
  }
  if (on_next) return on_previous ? Located{LocatedKind::vertex, previous, 0} : Located{LocatedKind::edge, next, 0};
  if (on_previous) return {LocatedKind::edge, previous, 0};
  return {LocatedKind::face, mesh::first(mesh::face(h)), 0};
}

/// Locates a point by a test of every face. Requires: `target` lies in the domain; `ghost` is the ghost vertex.
template <class Geometry>
[[nodiscard]] Located search_all(const mesh::TriangleMesh& mesh, const Geometry& geometry,
                                 const typename Geometry::View& target, mesh::Vertex ghost) {
  using exact::Sign;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const mesh::Face f{i};
    if (!mesh.is_live(f)) continue;
    std::array<Sign, 3> signs{};
    mesh::HalfEdge h = mesh::first(f);
    bool inside = true;
    for (Sign& sign : signs) {
      inside = inside && mesh.origin(h) != ghost && mesh.apex(h) != ghost && mesh.target(h) != ghost;
      if (!inside) break;
      sign = geometry.orientation(geometry.view(number(mesh.origin(h))), geometry.view(number(mesh.target(h))), target);
      inside = sign != Sign::negative;
      h = mesh::next(h);
    }
    if (inside) return locate_in_face(mesh::first(f), signs[0], signs[1], signs[2]);
  }
  return {};
}

/// The remembering stochastic walk. It goes from face to face, always across an edge beyond which the target lies. It
/// never tests the edge that it has just crossed. If the target lies beyond both other edges, it chooses one of them at
/// random. So no walk repeats the same cycle of faces forever. If a walk takes more than 16 steps plus 4 for each face,
/// which is extremely unlikely, it ends and search_all() finds the location.
///
/// Cost: 2 orientation tests per face. (With tests in random order, 1.5 tests would be enough on average, but each test
/// would also cost the time of a mispredicted branch.) Source: Chen 2009, section 3.2.1, algorithm 3; Devillers, Pion
/// and Teillaud, *Walking in a triangulation*, 2002. Requires: `start` is no ghost face; `target` lies in the domain,
/// at `seed` or very close to it.
template <class Geometry>
[[nodiscard]] Located walk(const mesh::TriangleMesh& mesh, const Geometry& geometry,
                           const typename Geometry::View& target, const Point& seed, mesh::Face start,
                           mesh::Vertex ghost) {
  using exact::Sign;
  using mesh::HalfEdge;
  using View = typename Geometry::View;
  const auto view = [&](mesh::Vertex v) { return geometry.view(number(v)); };
  Random random(seed);
  const HalfEdge start_edge = mesh::first(start);
  // In a large world, a walk spends most of its time waiting for memory. The code therefore prefetches the data that a
  // step may need before it knows the direction of the step: here the position of the third vertex of the face, and in
  // every step the faces beyond the edges.
  mesh.prefetch(mesh.twin(start_edge));
  if constexpr (requires { geometry.prefetch(0U); }) geometry.prefetch(number(mesh.apex(start_edge)));
  View p = view(mesh.origin(start_edge));
  View q = view(mesh.target(start_edge));
  const Sign start_side = geometry.orientation(p, q, target);
  // `entry` is the half-edge in the current face across which the walk has entered it. It runs from p to q. The target
  // lies left of it or on it.
  HalfEdge entry = start_edge;
  Sign entry_side = start_side;
  if (start_side == Sign::negative) {
    entry = mesh.twin(start_edge);
    entry_side = Sign::positive;
    std::swap(p, q);
  }
  const std::size_t max_steps = 16 + 4 * mesh.face_count();
  for (std::size_t steps = 0; steps < max_steps; ++steps) {
    mesh.prefetch(mesh.twin(mesh::next(entry)));
    mesh.prefetch(mesh.twin(mesh::previous(entry)));
    const View r = view(mesh.apex(entry));
    const Sign next_side = geometry.orientation(q, r, target);
    const Sign previous_side = geometry.orientation(r, p, target);
    const bool is_beyond_next = next_side == Sign::negative;
    const bool is_beyond_previous = previous_side == Sign::negative;
    if (!is_beyond_next && !is_beyond_previous) {
      Located located = locate_in_face(entry, entry_side, next_side, previous_side);
      located.steps = steps;
      return located;
    }
    const bool exits_by_next = is_beyond_next && (!is_beyond_previous || random.coin());
    entry = mesh.twin(exits_by_next ? mesh::next(entry) : mesh::previous(entry));
    (exits_by_next ? p : q) = r;
    entry_side = Sign::positive;
  }
  return search_all(mesh, geometry, target, ghost);
}

}  // namespace waywright::locate
