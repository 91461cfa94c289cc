#pragma once

#include "waywright/query_context.hpp"

#include "path/finder.hpp"
#include "path/kept_cover.hpp"

namespace waywright::detail {

struct QueryScratch {
  path::KeptCover cover;
  path::Finder finder;
};

}  // namespace waywright::detail
