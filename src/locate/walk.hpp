#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "exact/sign.hpp"
#include "locate/random.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::locate {

enum class Spot : std::uint8_t { vertex, edge, face };

/// Where a point lies: at the origin of `h`, inside the edge of `h`, or inside the face of `h`.
struct Located {
  Spot spot = Spot::face;
  mesh::HalfEdge h = mesh::kNoHalfEdge;
  std::size_t steps = 0;  ///< faces that a walk left to get there
};

namespace detail {

/// `signs` say where the point lies to the sides first(f), next, previous of the face; none is negative.
inline Located spot_in_face(mesh::Face f, const std::array<exact::Sign, 3>& signs) {
  using exact::Sign;
  const mesh::HalfEdge ab = mesh::first(f);
  const std::array<mesh::HalfEdge, 3> sides = {ab, mesh::next(ab), mesh::previous(ab)};
  for (std::size_t i = 0; i < 3; ++i) {
    if (signs[i] != Sign::zero) continue;
    if (signs[(i + 2) % 3] == Sign::zero) return {Spot::vertex, sides[i], 0};
    if (signs[(i + 1) % 3] != Sign::zero) return {Spot::edge, sides[i], 0};
  }
  return {Spot::face, ab, 0};
}

}  // namespace detail

/// Asks every face. Requires: `target` lies in the triangulated box; `ghost` is the vertex beyond it.
template <class Geometry>
[[nodiscard]] Located search_all(const mesh::TriangleMesh& mesh, const Geometry& geometry,
                                 const typename Geometry::View& target, mesh::Vertex ghost) {
  using exact::Sign;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const mesh::Face f{i};
    if (!mesh.is_alive(f)) continue;
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
    if (inside) return detail::spot_in_face(f, signs);
  }
  return {};
}

/// The remembering stochastic walk: from face to face across an edge that has the target beyond it, never asking about
/// the edge just crossed and taking the other two in random order, so that no walk goes round for ever. One that is
/// unlucky beyond all likelihood gives way to search_all.
///
/// Requires: `start` is no ghost face; `target`, at `seed` or nearly so, lies in the triangulated box.
/// Cost: 1.5 orientation tests a face on average.
/// Source: Chen 2009, section 3.2.1, algorithm 3; Devillers, Pion and Teillaud, *Walking in a triangulation*, 2002.
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
  // In a large world, most of a walk is waiting for memory. So what a step may need is fetched before it is known which
  // way it goes: here the place of the third corner, and always the faces beyond.
  mesh.prefetch(mesh.twin(start_edge));
  if constexpr (requires { geometry.prefetch(0U); }) geometry.prefetch(number(mesh.apex(start_edge)));
  View p = view(mesh.origin(start_edge));
  View q = view(mesh.target(start_edge));
  const Sign start_side = geometry.orientation(p, q, target);
  // `entry` is the side of the current face, from p to q, across which the walk came; the target lies on its left, or
  // on it.
  HalfEdge entry = start_edge;
  Sign entry_side = start_side;
  if (start_side == Sign::negative) {
    entry = mesh.twin(start_edge);
    entry_side = Sign::positive;
    std::swap(p, q);
  }
  const std::size_t patience = 16 + 4 * mesh.face_count();
  for (std::size_t steps = 0; steps < patience; ++steps) {
    mesh.prefetch(mesh.twin(mesh::next(entry)));
    mesh.prefetch(mesh.twin(mesh::previous(entry)));
    const View r = view(mesh.apex(entry));
    const auto side_of = [&](bool is_next) { return geometry.orientation(is_next ? q : r, is_next ? r : p, target); };
    const bool next_first = !random.coin();
    const Sign one_side = side_of(next_first);
    bool exits_by_next = next_first;
    if (one_side != Sign::negative) {
      const Sign other_side = side_of(!next_first);
      if (other_side != Sign::negative) {
        std::array<Sign, 3> signs{};
        signs[number(entry) % 3] = entry_side;
        signs[number(mesh::next(entry)) % 3] = next_first ? one_side : other_side;
        signs[number(mesh::previous(entry)) % 3] = next_first ? other_side : one_side;
        Located located = detail::spot_in_face(mesh::face(entry), signs);
        located.steps = steps;
        return located;
      }
      exits_by_next = !next_first;
    }
    entry = mesh.twin(exits_by_next ? mesh::next(entry) : mesh::previous(entry));
    (exits_by_next ? p : q) = r;
    entry_side = Sign::positive;
  }
  return search_all(mesh, geometry, target, ghost);
}

}  // namespace waywright::locate
