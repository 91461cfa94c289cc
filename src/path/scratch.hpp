#pragma once

#include <cstdint>
#include <vector>

#include "constraint/cover.hpp"
#include "path/funnel.hpp"

namespace waywright::path {

/// A channel that the search has followed to the edge of a face.
struct SearchNode {
  mesh::HalfEdge entry;  ///< the edge by which the channel comes into the face, as a half-edge of that face
  Funnel funnel;
  double bound = 0.0;  ///< no path from start to goal along this channel is shorter
};

/// What a path query needs besides the world: kept from one to the next for its memory, never for what is in it.
struct Scratch {
  constraint::Cover cover;
  std::vector<mesh::HalfEdge> start_faces;
  std::vector<mesh::HalfEdge> goal_faces;
  std::vector<SearchNode> nodes;
  std::vector<std::uint32_t> open;     ///< a heap of positions in `nodes`
  std::vector<std::uint32_t> entered;  ///< by half-edge: the query that entered a face by it last
  std::vector<std::uint32_t> is_goal;  ///< by face: the query that has its goal there
  std::uint32_t query = 0;
  TautTree tree;
};

}  // namespace waywright::path
