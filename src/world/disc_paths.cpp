#include <optional>
#include <utility>

#include "waywright/world.hpp"

#include "path/clear.hpp"
#include "path/ends.hpp"
#include "path/tangent.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// Paths for agents with a radius.

namespace waywright {

namespace {

/// Appends a straight line, and the arc after it, to the answer. `next` is where the arc ends.
void append(const path::DiscPiece& piece, double radius, const Point& next, std::vector<PathPiece>& pieces) {
  if (!(piece.from == piece.to)) pieces.push_back({PathPiece::Kind::line, piece.from, piece.to, {}, 0.0, 0.0, 0.0});
  if (piece.side == 0) return;
  const Point spoke{piece.side * piece.direction.y, -piece.side * piece.direction.x};
  const double start_angle = path::angle_of(spoke);
  const double turn = path::turning_angle(piece.direction, piece.end_direction, piece.side);
  pieces.push_back(
      {PathPiece::Kind::arc, piece.to, next, piece.centre, radius, start_angle, start_angle + piece.side * turn});
}

}  // namespace

/// Moves the ends at which the disc does not fit. Returns whether it fits at both ends now. If not, writes to `path`
/// which end is blocked.
bool World::Impl::free_disc_ends(PathQuery& query, detail::QueryScratch& scratch, Path& path) const {
  const auto fits_at = [&](const Point& end) {
    fit_disc(end, query.radius, scratch, scratch.fit);
    return scratch.fit.fits;
  };
  const bool does_goal_fit = fits_at(query.goal);
  for (const bool is_start : {true, false}) {
    Point& end = is_start ? query.start : query.goal;
    if (fits_at(end)) continue;
    const std::optional<Point> other =
        is_start && !does_goal_fit ? std::nullopt : std::optional(is_start ? query.goal : query.start);
    const auto moved = find_disc_end(query, end, other, scratch);
    if (!moved) {
      path.status = is_start ? PathStatus::start_blocked : PathStatus::goal_blocked;
      path.blockers = scratch.fit.items;
      return false;
    }
    (is_start ? path.moved_start : path.moved_goal) = MovedEnd{end, *moved};
    end = *moved;
  }
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

void World::Impl::find_disc_path(PathQuery query, detail::QueryScratch& scratch, Path& path) const {
  path::clear(path);
  if (!free_disc_ends(query, scratch, path)) return;
  const constraint::ExactTriangulation& walls = clearance->walls(triangulation);
  const clearance::Bridges& bridges = clearance->bridges();
  const auto start_cell = scratch.near_walls.find_cell(walls, bridges, query.start);
  const auto goal_cell = scratch.near_walls.find_cell(walls, bridges, query.goal);
  const path::DiscMap map{walls, {walls, bridges}, query.radius, query.start};
  path::DiscOptimal& search = scratch.disc_search;
  search.begin(map, query.start, *start_cell, query.goal, *goal_cell);
  while (!search.step(path.expansions + 1024, path.expansions)) {
  }
  if (!search.is_found()) {
    WidestPath widest;
    widest_path(query.start, query.goal, scratch, widest);
    if (widest.is_connected) path.widest = std::move(widest);
    return;
  }
  path.status = PathStatus::found;
  path.length = path.lower_bound = search.length();
  scratch.disc_pieces.clear();
  search.write_path(scratch.disc_pieces);
  for (std::size_t i = 0; i < scratch.disc_pieces.size(); ++i) {
    const bool is_last = i + 1 == scratch.disc_pieces.size();
    append(scratch.disc_pieces[i], query.radius, is_last ? query.goal : scratch.disc_pieces[i + 1].from, path.pieces);
  }
}

}  // namespace waywright
