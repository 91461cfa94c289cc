#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "waywright/world.hpp"

#include "path/clear.hpp"
#include "path/ends.hpp"
#include "path/pieces.hpp"
#include "path/tangent.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// Paths for agents with a radius.

namespace waywright {

namespace {

/// Appends a straight line, and the arc after it, to the answer. `next` is where the arc ends. Leaves out a line
/// without length, and an arc that turns by less than a double can express.
void append(const path::DiscPiece& piece, double radius, const Point& next, std::vector<PathPiece>& pieces) {
  if (!(piece.from == piece.to)) pieces.push_back({PathPiece::Kind::line, piece.from, piece.to, {}, 0.0, 0.0, 0.0});
  if (piece.turn == 0) return;
  const Point spoke{piece.turn * piece.direction.y, -piece.turn * piece.direction.x};
  const double start_angle = path::angle_of(spoke);
  const double end_angle =
      start_angle + piece.turn * path::turning_angle(piece.direction, piece.end_direction, piece.turn);
  if (end_angle != start_angle) {
    pieces.push_back({PathPiece::Kind::arc, piece.to, next, piece.centre, radius, start_angle, end_angle});
  } else if (!pieces.empty()) {
    pieces.back().to = next;
  }
}

/// Writes the answer from `disc.pieces`.
void write_path(detail::DiscSearch& disc, Path& path) {
  const std::vector<path::DiscPiece>& pieces = disc.pieces;
  path.status = PathStatus::found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool is_last = i + 1 == pieces.size();
    append(pieces[i], path.radius, is_last ? disc.goal : pieces[i + 1].from, path.pieces);
  }
  if (path.pieces.empty()) path.pieces.push_back({PathPiece::Kind::line, disc.start, disc.goal, {}, 0.0, 0.0, 0.0});
  path.pieces.front().from = disc.start;
  path.pieces.back().to = disc.goal;
  // The length of the rounded pieces, as Path::at computes it.
  path.length = path::length_of(path.pieces);
  path.lower_bound = disc.stage == detail::DiscSearch::Stage::shortest
                         ? path.length
                         : std::min(path.length, distance(disc.start, disc.goal));
}

/// Starts a stage of the search.
void begin_stage(detail::DiscSearch& disc, detail::DiscSearch::Stage stage) {
  disc.stage = stage;
  disc.is_found = false;
  if (stage == detail::DiscSearch::Stage::channel) {
    disc.channel.begin(*disc.map, disc.start, disc.goal);
  } else {
    disc.shortest.begin(*disc.map, disc.start, disc.goal);
  }
}

/// Continues the stage with the channel. If the stage finds a path, writes its pieces.
void step_channel(detail::DiscSearch& disc, std::size_t limit, std::size_t& expansions) {
  disc.is_stage_done = disc.channel.step(limit, expansions);
  if (!disc.channel.is_found()) return;
  disc.is_found = disc.string.find(*disc.map, disc.start, disc.goal, disc.channel.exits(), disc.channel.goal_face());
  if (disc.is_found) disc.string.write_path(disc.pieces);
}

/// Continues the stage that finds the shortest path. If the stage finds it, writes its pieces.
void step_shortest(detail::DiscSearch& disc, std::size_t limit, std::size_t& expansions) {
  disc.is_stage_done = disc.shortest.step(limit, expansions);
  disc.is_found = disc.shortest.is_found();
  if (disc.is_found) disc.shortest.write_path(disc.pieces);
}

/// Continues the search. Returns whether it has ended.
bool step(detail::DiscSearch& disc, std::size_t limit, std::size_t& expansions) {
  using Stage = detail::DiscSearch::Stage;
  const bool is_channel = disc.stage == Stage::channel;
  is_channel ? step_channel(disc, limit, expansions) : step_shortest(disc, limit, expansions);
  if (!disc.is_stage_done) return false;
  const bool cannot_be_found = is_channel && !disc.channel.is_found();
  if (disc.is_found || disc.is_last_stage || cannot_be_found) return true;
  disc.is_last_stage = true;
  begin_stage(disc, is_channel ? Stage::shortest : Stage::channel);
  return step(disc, limit, expansions);
}

/// Writes the time since the start of the search, if the query wants it.
void write_time(const detail::DiscSearch& disc, Path& path) {
  if (disc.begun) path.time = std::chrono::steady_clock::now() - *disc.begun;
}

}  // namespace

/// Moves the ends at which the disc does not fit. Returns whether it fits at both ends now. If not, writes to `path`
/// which end is blocked.
bool World::Impl::free_disc_ends(PathQuery& query, detail::QueryScratch& scratch, Path& path) const {
  fit_disc(query.goal, query.radius, scratch, scratch.fit);
  const std::optional<Point> goal = scratch.fit.fits ? std::optional(query.goal) : std::nullopt;
  if (!free_disc_end(query, true, goal, scratch, path)) return false;
  return goal || free_disc_end(query, false, query.start, scratch, path);
}

/// Does this for one end. `other` is the other end, if the disc fits there.
bool World::Impl::free_disc_end(PathQuery& query, bool is_start, const std::optional<Point>& other,
                                detail::QueryScratch& scratch, Path& path) const {
  Point& end = is_start ? query.start : query.goal;
  fit_disc(end, query.radius, scratch, scratch.fit);
  if (scratch.fit.fits) return true;
  const auto moved = find_disc_end(query, end, other, scratch);
  if (!moved) {
    path.status = is_start ? PathStatus::start_blocked : PathStatus::goal_blocked;
    path.blockers = scratch.fit.items;
    return false;
  }
  (is_start ? path.moved_start : path.moved_goal) = MovedEnd{end, *moved};
  end = *moved;
  return true;
}

/// Returns the position nearest to a blocked end where the disc fits. If the disc gets from some of the positions
/// within the tolerance to `other`, returns the nearest of these.
std::optional<Point> World::Impl::find_disc_end(const PathQuery& query, const Point& end,
                                                const std::optional<Point>& other,
                                                detail::QueryScratch& scratch) const {
  const double tolerance = query.end_tolerance.value_or(path::default_end_tolerance(triangulation.domain()));
  if (!(tolerance > 0.0)) return std::nullopt;
  NearestFitQuery nearest{end, query.radius, other, tolerance};
  if (other) {
    if (const auto found = nearest_fit_of_disc(nearest, scratch)) return found;
    nearest.goal.reset();
  }
  return nearest_fit_of_disc(nearest, scratch);
}

/// Prepares searches from a start, for one goal after the other. Requires: the disc is free there.
void World::Impl::set_disc_start(const Point& start, double radius, detail::QueryScratch& scratch) const {
  detail::DiscSearch& disc = scratch.disc_search;
  const constraint::ExactTriangulation& walls = clearance->walls(triangulation);
  const bool has_abstraction = abstraction && &walls == &triangulation;
  disc.start = start;
  disc.map.emplace(walls, clearance->bridges(), radius, start, has_abstraction ? &abstraction->core() : nullptr);
}

/// Starts the search for a goal. Requires: the disc is free there.
void World::Impl::begin_disc_search(const Point& goal, PathAlgorithm algorithm, detail::QueryScratch& scratch) const {
  detail::DiscSearch& disc = scratch.disc_search;
  disc.goal = goal;
  disc.is_done = false;
  disc.is_last_stage = false;
  using Stage = detail::DiscSearch::Stage;
  begin_stage(disc, algorithm == PathAlgorithm::tra ? Stage::channel : Stage::shortest);
}

bool World::Impl::begin_disc_path(const PathQuery& query, detail::QueryScratch& scratch, Path& path) const {
  path::clear(path);
  path.radius = query.radius;
  detail::DiscSearch& disc = scratch.disc_search;
  disc.is_done = true;
  disc.begun.reset();
  if (query.wants_time) disc.begun = std::chrono::steady_clock::now();
  PathQuery freed = query;
  if (!free_disc_ends(freed, scratch, path)) {
    write_time(disc, path);
    return true;
  }
  set_disc_start(freed.start, query.radius, scratch);
  begin_disc_search(freed.goal, query.algorithm, scratch);
  return false;
}

bool World::Impl::step_disc_path(std::size_t limit, detail::QueryScratch& scratch, Path& path) const {
  detail::DiscSearch& disc = scratch.disc_search;
  if (disc.is_done) return true;
  disc.is_done = step(disc, limit, path.expansions);
  if (!disc.is_done) return false;
  if (disc.is_found) {
    write_path(disc, path);
  } else {
    WidestPath widest;
    widest_path(disc.start, disc.goal, scratch, widest);
    if (widest.is_connected) path.widest = std::move(widest);
  }
  write_time(disc, path);
  return true;
}

void World::Impl::find_disc_paths_from(const ManyGoalsQuery& query, detail::QueryScratch& scratch,
                                       std::vector<Path>& paths) const {
  paths.resize(query.goals.size());
  for (Path& path : paths) {
    path::clear(path);
    path.radius = query.radius;
  }
  if (paths.empty()) return;
  PathQuery freed{.start = query.start, .goal = {}, .radius = query.radius, .end_tolerance = query.end_tolerance};
  if (!free_disc_end(freed, true, std::nullopt, scratch, paths.front())) {
    for (Path& path : paths) {
      path.status = PathStatus::start_blocked;
      path.blockers = scratch.fit.items;
    }
    return;
  }
  scratch.disc_search.begun.reset();
  set_disc_start(freed.start, query.radius, scratch);
  const std::optional<MovedEnd> moved_start = paths.front().moved_start;
  std::size_t expansions = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    Path& path = paths[i];
    path.moved_start = moved_start;
    freed.goal = query.goals[i];
    if (!free_disc_end(freed, false, freed.start, scratch, path)) continue;
    begin_disc_search(freed.goal, PathAlgorithm::optimal, scratch);
    step_disc_path(std::numeric_limits<std::size_t>::max(), scratch, path);
    expansions += path.expansions;
    if (!query.wants_points) path.pieces.clear();
  }
  for (Path& path : paths) path.expansions = expansions;
}

}  // namespace waywright
