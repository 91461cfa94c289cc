#pragma once

#include "waywright/path.hpp"

namespace waywright::path {

/// Makes `path` the answer of a search that has not found anything yet. Keeps the memory of its lists.
inline void reset(Path& path) {
  path.status = PathStatus::no_path;
  path.length = 0.0;
  path.lower_bound = 0.0;
  path.agent = {};
  path.points.clear();
  path.pieces.clear();
  path.channel.clear();
  path.expansions = 0;
  path.time = {};
  path.moved_start.reset();
  path.moved_goal.reset();
  path.blockers.clear();
  path.widest.reset();
  path.ends.reset();
}

}  // namespace waywright::path
