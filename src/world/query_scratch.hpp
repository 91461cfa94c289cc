#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "waywright/clearance.hpp"
#include "waywright/path.hpp"
#include "waywright/query_context.hpp"

#include "clearance/bridge_lister.hpp"
#include "clearance/disc_passage.hpp"
#include "clearance/near_walls.hpp"
#include "clearance/nearest_fit.hpp"
#include "clearance/widest.hpp"
#include "constraint/canonical.hpp"
#include "constraint/item_queries.hpp"
#include "nav/abstraction.hpp"
#include "path/disc_channel.hpp"
#include "path/disc_ends.hpp"
#include "path/disc_guide.hpp"
#include "path/disc_line.hpp"
#include "path/disc_optimal.hpp"
#include "path/disc_string.hpp"
#include "path/finder.hpp"
#include "path/free_positions.hpp"
#include "path/polyline_walk.hpp"

namespace waywright::detail {

/// The search for the path of a disc. It can continue as long as the world does not change.
struct DiscSearch {
  /// If the disc can move straight from the start to the goal, no stage runs. The stages of `optimal`:
  /// - `guide`: the guide searches for a path of a point agent. If there is none, the disc has no path either. If there
  ///   is a string through its channel, the stage `channel` does not run.
  /// - `channel`: searches for a channel of the disc, and for a string through it. If there is no channel, there is no
  ///   path.
  /// - `distances`: the guide continues, and finds all distances that the search for the shortest path needs. Without a
  ///   string, this stage does not run.
  /// - `shortest`: searches for the shortest path. It leaves out everything that is longer than the string.
  ///
  /// `ta` and `tra` start with the stage `channel`. `tra` needs the stages after it only if it finds no string through
  /// its channel. `ta` also needs them if its budget is not used up.
  enum class Stage { guide, channel, distances, shortest };
  enum class Outcome { running, found, none };

  Point start;
  Point goal;
  Outcome outcome = Outcome::none;
  std::optional<std::chrono::steady_clock::time_point> begun;  ///< set if the query wants or limits the time
  bool wants_time = false;
  std::optional<path::DiscMap> map;  ///< the stages refer to it and to `ends`
  path::DiscEnds ends;
  Stage stage = Stage::channel;
  PathAlgorithm algorithm = PathAlgorithm::optimal;
  PathBudget budget;
  double length = 0.0;             ///< the length of `pieces`; infinity as long as the search has found no path
  clearance::DiscPassage passage;  ///< decides whether there is a path, while the stages search for it
  /// The search looks at `passage` when Path::expansions has reached this number.
  std::size_t next_look = 0;
  path::DiscLine line;
  bool has_guide = false;  ///< false if the two ends lie in one face: then the stages of the guide do not run
  path::DiscGuide guide;
  path::DiscChannel channel;
  path::DiscString string;
  path::DiscOptimal shortest;
  std::vector<path::DiscPiece> pieces;
};

struct QueryScratch {
  nav::ComponentCoverFinder cover_finder;
  constraint::ItemQueryScratch items;
  constraint::CanonicalOrder order;
  constraint::SweptDisc swept_disc;
  clearance::NearWalls near_walls;
  clearance::NearestFit nearest_fit;
  path::FreePositions free_positions;
  std::vector<mesh::HalfEdge> goal_faces;
  clearance::WidestGapFinder widest_gap_finder;
  clearance::WidestGap widest_gap;
  clearance::BridgeLister bridge_lister;
  path::Finder finder;
  DiscSearch disc_search;
  DiscFit fit;
  path::PolylineWalk polyline_walk;
};

}  // namespace waywright::detail
