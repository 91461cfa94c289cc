#pragma once

#include "waywright/query_context.hpp"

#include "path/finder.hpp"
#include "path/kept_cover.hpp"
#include "path/polyline_walk.hpp"

namespace waywright::detail {

struct QueryScratch {
  path::KeptCover cover;
  path::Finder finder;
  path::PolylineWalk polyline_walk;
};

}  // namespace waywright::detail
