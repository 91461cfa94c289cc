#pragma once

#include "waywright/query_context.hpp"

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
  path::Finder finder;
  path::PolylineWalk polyline_walk;
};

}  // namespace waywright::detail
