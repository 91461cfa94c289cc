#include <chrono>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "waywright/world.hpp"

#include "path/clear.hpp"
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
  if (piece.side == 0) return;
  const Point spoke{piece.side * piece.direction.y, -piece.side * piece.direction.x};
  const double start_angle = path::angle_of(spoke);
  const double end_angle =
      start_angle + piece.side * path::turning_angle(piece.direction, piece.end_direction, piece.side);
  if (end_angle != start_angle) {
    pieces.push_back({PathPiece::Kind::arc, piece.to, next, piece.centre, radius, start_angle, end_angle});
  } else if (!pieces.empty()) {
    pieces.back().to = next;
  }
}

void append_pieces(detail::DiscSearch& disc, Path& path) {
  std::vector<path::DiscPiece>& pieces = disc.pieces;
  pieces.clear();
  disc.search.write_path(pieces);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool is_last = i + 1 == pieces.size();
    append(pieces[i], path.radius, is_last ? disc.goal : pieces[i + 1].from, path.pieces);
  }
  if (path.pieces.empty()) path.pieces.push_back({PathPiece::Kind::line, disc.start, disc.goal, {}, 0.0, 0.0, 0.0});
  path.pieces.front().from = disc.start;
  path.pieces.back().to = disc.goal;
  // The length of the rounded pieces, as Path::at computes it.
  path.length = path.lower_bound = path::length_of(path.pieces);
}

}  // namespace

/// Returns whether the disc is free at an end. If it is not, writes the reason to the answer.
bool World::Impl::is_end_free(const Point& end, double radius, PathStatus blocked, detail::QueryScratch& scratch,
                              Path& path) const {
  fit_disc(end, radius, scratch, scratch.fit);
  if (scratch.fit.fits) return true;
  path.status = blocked;
  path.blockers = scratch.fit.items;
  return false;
}

/// Prepares searches from a start, for one goal after the other. Requires: the disc is free there.
void World::Impl::set_disc_start(const Point& start, double radius, detail::QueryScratch& scratch) const {
  detail::DiscSearch& disc = scratch.disc_search;
  const constraint::ExactTriangulation& walls = clearance->walls(triangulation);
  const clearance::Bridges& bridges = clearance->bridges();
  disc.start = start;
  disc.map.emplace(path::DiscMap{walls, {walls, bridges}, radius, start});
  disc.start_cell = *scratch.near_walls.find_cell(walls, bridges, start);
}

/// Starts the search for a goal. Requires: the disc is free there.
void World::Impl::begin_disc_search(const Point& goal, detail::QueryScratch& scratch) const {
  detail::DiscSearch& disc = scratch.disc_search;
  disc.goal = goal;
  disc.is_done = false;
  const auto goal_cell = scratch.near_walls.find_cell(disc.map->walls, clearance->bridges(), goal);
  disc.search.begin(*disc.map, disc.start, disc.start_cell, goal, *goal_cell);
}

bool World::Impl::begin_disc_path(const PathQuery& query, detail::QueryScratch& scratch, Path& path) const {
  path::clear(path);
  path.radius = query.radius;
  detail::DiscSearch& disc = scratch.disc_search;
  disc.is_done = true;
  disc.begun.reset();
  if (query.wants_time) disc.begun = std::chrono::steady_clock::now();
  if (!is_end_free(query.start, query.radius, PathStatus::start_blocked, scratch, path) ||
      !is_end_free(query.goal, query.radius, PathStatus::goal_blocked, scratch, path)) {
    return true;
  }
  set_disc_start(query.start, query.radius, scratch);
  begin_disc_search(query.goal, scratch);
  return false;
}

bool World::Impl::step_disc_path(std::size_t limit, detail::QueryScratch& scratch, Path& path) const {
  detail::DiscSearch& disc = scratch.disc_search;
  if (disc.is_done) return true;
  disc.is_done = disc.search.step(limit, path.expansions);
  if (!disc.is_done) return false;
  if (disc.search.is_found()) {
    path.status = PathStatus::found;
    append_pieces(disc, path);
  } else {
    WidestPath widest;
    widest_path(disc.start, disc.goal, scratch, widest);
    if (widest.is_connected) path.widest = std::move(widest);
  }
  if (disc.begun) path.time = std::chrono::steady_clock::now() - *disc.begun;
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
  if (!is_end_free(query.start, query.radius, PathStatus::start_blocked, scratch, paths.front())) {
    for (Path& path : paths) {
      path.status = PathStatus::start_blocked;
      path.blockers = scratch.fit.items;
    }
    return;
  }
  scratch.disc_search.begun.reset();
  set_disc_start(query.start, query.radius, scratch);
  std::size_t expansions = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    Path& path = paths[i];
    if (!is_end_free(query.goals[i], query.radius, PathStatus::goal_blocked, scratch, path)) continue;
    begin_disc_search(query.goals[i], scratch);
    step_disc_path(std::numeric_limits<std::size_t>::max(), scratch, path);
    expansions += path.expansions;
    if (!query.wants_points) path.pieces.clear();
  }
  for (Path& path : paths) path.expansions = expansions;
}

}  // namespace waywright
