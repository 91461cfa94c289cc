#include <utility>

#include "waywright/world.hpp"

#include "path/clear.hpp"
#include "path/tangent.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// Paths for agents with a radius.

namespace waywright {

namespace {

/// Appends a straight line, and the arc after it, to the answer. `next` is where the arc ends.
void append(const path::DiscPiece& piece, double radius, const Point& next, std::vector<PathPiece>& pieces) {
  if (!(piece.from == piece.to)) pieces.push_back({PathPiece::Kind::line, piece.from, piece.to, {}, 0.0, 0.0, 0.0});
  if (piece.turn == 0) return;
  const Point spoke{piece.turn * piece.direction.y, -piece.turn * piece.direction.x};
  const double start_angle = path::angle_of(spoke);
  const double angle = path::turning_angle(piece.direction, piece.end_direction, piece.turn);
  pieces.push_back(
      {PathPiece::Kind::arc, piece.to, next, piece.centre, radius, start_angle, start_angle + piece.turn * angle});
}

}  // namespace

void World::Impl::find_disc_path(const PathQuery& query, detail::QueryScratch& scratch, Path& path) const {
  path::clear(path);
  for (const bool is_start : {true, false}) {
    fit_disc(is_start ? query.start : query.goal, query.radius, scratch, scratch.fit);
    if (scratch.fit.fits) continue;
    path.status = is_start ? PathStatus::start_blocked : PathStatus::goal_blocked;
    path.blockers = scratch.fit.items;
    return;
  }
  const constraint::ExactTriangulation& walls = clearance->walls(triangulation);
  const clearance::Bridges& bridges = clearance->bridges();
  const bool has_abstraction = abstraction && &walls == &triangulation;
  const path::DiscMap map(walls, bridges, query.radius, query.start, has_abstraction ? &abstraction->core() : nullptr);
  path::DiscOptimal& search = scratch.disc_search;
  search.begin(map, query.start, query.goal);
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
