#pragma once

#include "waywright/query_context.hpp"

#include "constraint/cover.hpp"
#include "path/finder.hpp"

namespace waywright::detail {

struct QueryScratch {
  constraint::Cover cover;
  path::Finder finder;
};

}  // namespace waywright::detail
