#pragma once

#include "waywright/query_context.hpp"

#include "clearance/near_walls.hpp"
#include "clearance/widest_gap.hpp"
#include "constraint/canonical.hpp"
#include "constraint/item_queries.hpp"
#include "nav/kept_cover.hpp"
#include "path/finder.hpp"
#include "path/polyline_walk.hpp"

namespace waywright::detail {

struct QueryScratch {
  nav::KeptCover cover;
  constraint::ItemQueryScratch items;
  constraint::CanonicalOrder order;
  clearance::NearWalls near_walls;
  clearance::WidestGapFinder widest_gap_finder;
  clearance::WidestGap widest_gap;
  path::Finder finder;
  path::PolylineWalk polyline_walk;
};

}  // namespace waywright::detail
