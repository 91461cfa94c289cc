#pragma once

#include <cstdint>

#include "mesh/triangle_mesh.hpp"
#include "path/sight.hpp"

namespace waywright::path {

/// A channel that a search has followed to the goal, or to a face where it has a choice.
struct ChannelNode {
  static constexpr std::uint32_t kNone = 0xffffffff;

  mesh::HalfEdge exit;   ///< the half-edge through which the channel left the face of the node before
  mesh::HalfEdge entry;  ///< the half-edge through which it entered this node's face
  std::uint32_t before;  ///< the index of the node before, or kNone: the channel comes from a start face
  Sight sight;
};

}  // namespace waywright::path
