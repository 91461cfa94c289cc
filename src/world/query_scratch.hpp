#pragma once

#include <vector>

#include "waywright/clearance.hpp"
#include "waywright/query_context.hpp"

#include "clearance/near_walls.hpp"
#include "clearance/nearest_fit.hpp"
#include "clearance/widest_gap.hpp"
#include "constraint/canonical.hpp"
#include "constraint/item_queries.hpp"
#include "nav/kept_cover.hpp"
#include "path/disc_optimal.hpp"
#include "path/finder.hpp"
#include "path/free_positions.hpp"
#include "path/polyline_walk.hpp"

namespace waywright::detail {

struct QueryScratch {
  nav::KeptCover cover;
  constraint::ItemQueryScratch items;
  constraint::CanonicalOrder order;
  clearance::NearWalls near_walls;
  clearance::NearestFit nearest_fit;
  path::FreePositions free_positions;
  std::vector<mesh::HalfEdge> goal_faces;
  clearance::WidestGapFinder widest_gap_finder;
  clearance::WidestGap widest_gap;
  path::Finder finder;
  path::DiscOptimal disc_search;
  std::vector<path::DiscPiece> disc_pieces;
  DiscFit fit;
  path::PolylineWalk polyline_walk;
};

}  // namespace waywright::detail
