#pragma once

#include <cstdint>

namespace waywright::mesh {

// Three types of index, so that the compiler refuses a face where a vertex is needed. The half-edges of the face f are
// 3 f, 3 f + 1 and 3 f + 2, counter-clockwise.
enum class Vertex : std::uint32_t {};
enum class HalfEdge : std::uint32_t {};
enum class Face : std::uint32_t {};

/// The values that mean "no half-edge" and "no vertex".
inline constexpr HalfEdge kNoHalfEdge{0x7fffffff};
inline constexpr Vertex kNoVertex{0xffffffff};

template <class Index>
[[nodiscard]] constexpr std::uint32_t number(Index index) {
  return static_cast<std::uint32_t>(index);
}

[[nodiscard]] constexpr Face face(HalfEdge h) { return Face{number(h) / 3}; }
[[nodiscard]] constexpr HalfEdge first(Face f) { return HalfEdge{number(f) * 3}; }
/// The half-edge `i` of a face, 0, 1 or 2.
[[nodiscard]] constexpr HalfEdge half_edge(Face f, std::uint32_t i) { return HalfEdge{3 * number(f) + i}; }
/// The number `i` with half_edge(f, i) == h. Requires: `h` is a half-edge of `f`. Costs less than face(), which
/// divides.
[[nodiscard]] constexpr std::uint32_t index_in(Face f, HalfEdge h) { return number(h) - 3 * number(f); }
[[nodiscard]] constexpr HalfEdge next(HalfEdge h) {
  return HalfEdge{number(h) % 3 == 2 ? number(h) - 2 : number(h) + 1};
}
[[nodiscard]] constexpr HalfEdge previous(HalfEdge h) {
  return HalfEdge{number(h) % 3 == 0 ? number(h) + 2 : number(h) - 1};
}

}  // namespace waywright::mesh
