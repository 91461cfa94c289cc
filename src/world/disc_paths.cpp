#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "waywright/world.hpp"

#include "path/ends.hpp"
#include "path/pieces.hpp"
#include "path/reset.hpp"
#include "path/saturating_add.hpp"
#include "path/tangent.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// Paths for agents with a radius.

namespace waywright {

namespace {

using Stage = detail::DiscSearch::Stage;
using Outcome = detail::DiscSearch::Outcome;
using Clock = std::chrono::steady_clock;

/// A search with a budget looks at the budget each time it has made this many steps.
constexpr std::size_t kSlice = 64;

/// If the query remembers a gap that is too narrow for the disc, the search asks whether this gap separates the ends
/// when it has made this many steps. To find the cells of the ends takes as much time as about ten steps.
constexpr std::size_t kStepsBeforeMemory = 32;

/// When the search has made this many steps without finding a path, it begins to look for a reason why there is none.
constexpr std::size_t kStepsBeforePassage = 512;

/// After that, it crosses this many gates for each `kStepsPerLook` steps. So queries that find a path take hardly more
/// time.
constexpr std::size_t kGatesPerLook = 2;
constexpr std::size_t kStepsPerLook = 64;

/// There is no need to look.
constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// If a path of `ta` is shorter than the string by a smaller share of its length than this, the rounding of its pieces
/// can make it longer than the string.
constexpr double kLeastGain = 0x1p-40;

/// Appends a straight line, and the arc after it, to the answer. `next` is where the arc ends. Leaves out a line
/// without length, and an arc that turns by less than a double can express.
void append(const path::DiscPiece& piece, double radius, const Point& next, std::vector<PathPiece>& pieces) {
  if (!(piece.from == piece.to)) pieces.push_back({PathPiece::Kind::line, piece.from, piece.to, {}, 0.0, 0.0, 0.0});
  if (piece.turn == path::kNoTurn) return;
  const Point radial{piece.turn * piece.direction.y, -piece.turn * piece.direction.x};
  const double start_angle = path::angle_of(radial);
  const double end_angle =
      start_angle + piece.turn * path::turning_angle(piece.direction, piece.end_direction, piece.turn);
  if (end_angle != start_angle) {
    pieces.push_back({PathPiece::Kind::arc, piece.to, next, piece.centre, radius, start_angle, end_angle});
  } else if (!pieces.empty()) {
    pieces.back().to = next;
  }
}

/// Writes the path from `disc.pieces`. `lower_bound` is a lower bound of the length of the shortest path.
void write_path(const detail::DiscSearch& disc, double lower_bound, Path& path) {
  const std::vector<path::DiscPiece>& pieces = disc.pieces;
  path.status = PathStatus::found;
  path.pieces.clear();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool is_last = i + 1 == pieces.size();
    append(pieces[i], path.agent.radius, is_last ? disc.goal : pieces[i + 1].from, path.pieces);
  }
  if (path.pieces.empty()) path.pieces.push_back({PathPiece::Kind::line, disc.start, disc.goal, {}, 0.0, 0.0, 0.0});
  path.pieces.front().from = disc.start;
  path.pieces.back().to = disc.goal;
  // The length of the rounded pieces, as Path::at computes it.
  path.length = path::length_of(path.pieces);
  path.lower_bound = std::min(path.length, lower_bound);
}

/// Returns true only if the disc fits at no position within the tolerance from `end`. If a wall is nearer to the end
/// than the radius minus the tolerance, it is nearer than the radius to each of these positions.
bool is_surely_blocked(const constraint::ExactTriangulation& triangulation, const Point& end, double radius,
                       double tolerance, clearance::NearWalls& near_walls) {
  // If the difference is smaller, a search for a free position is more likely to succeed, so the shortcut is not tried.
  const double difference = std::nextafter(radius - tolerance, 0.0);
  return difference > 0.5 * radius && !near_walls.has_no_nearer_wall(triangulation, end, difference);
}

/// Tests the straight line from start to goal. If no wall is near it, writes it as the path and returns true.
bool find_straight(detail::DiscSearch& disc) {
  const path::DiscLine::End from{{disc.ends.start(), 0}, mesh::kNoVertex};
  const path::DiscLine::End to{{disc.ends.goal(), 0}, mesh::kNoVertex};
  const auto line = path::tangent(from.pivot, to.pivot, disc.map->radius);
  if (!line || !disc.line.is_clear(*disc.map, from, to, *line, disc.ends.goal_face())) return false;
  disc.length = line->length;
  disc.pieces.assign({{disc.start, disc.goal, {}, 0, line->direction, {}}});
  disc.outcome = Outcome::found;
  return true;
}

/// Returns whether the search has found a path and its budget is used up.
bool is_over_budget(const detail::DiscSearch& disc, const Path& path) {
  if (disc.algorithm != PathAlgorithm::ta || path.status != PathStatus::found) return false;
  return path.expansions >= disc.budget.expansions || (disc.begun && Clock::now() - *disc.begun >= disc.budget.time);
}

void begin_guide(detail::DiscSearch& disc) { disc.guide.begin(*disc.map, disc.ends, disc.start, disc.goal); }

/// Searches for a string through a channel. Returns false if there is none.
bool find_string(detail::DiscSearch& disc, std::span<const mesh::HalfEdge> exits, mesh::HalfEdge goal_face) {
  if (!disc.string.find(*disc.map, disc.ends, exits, goal_face)) return false;
  disc.string.write_path(disc.pieces);
  // With `tra`, the search ends here, so it needs no limit.
  if (disc.algorithm != PathAlgorithm::tra) disc.length = disc.string.length();
  return true;
}

void begin_shortest(detail::DiscSearch& disc, const path::GuideDistances* distances) {
  disc.stage = Stage::shortest;
  disc.shortest.begin(*disc.map, disc.ends, disc.length, distances);
}

void begin_distances(detail::DiscSearch& disc) {
  disc.stage = Stage::distances;
  disc.guide.continue_to(disc.length);
}

/// Continues the stage `guide`.
void step_guide(detail::DiscSearch& disc, std::size_t limit, Path& path) {
  if (!disc.guide.step(limit, path.expansions)) return;
  if (!disc.guide.is_found()) {
    disc.outcome = Outcome::none;
    return;
  }
  const std::span<const mesh::HalfEdge> exits = disc.guide.collect_exits();
  if (find_string(disc, exits, disc.map->mesh().twin(exits.back()))) return begin_distances(disc);
  disc.stage = Stage::channel;
  disc.channel.begin(*disc.map, disc.ends);
}

/// Continues the stage `channel`. If it finds a string, writes the string as the first path.
void step_channel(detail::DiscSearch& disc, std::size_t limit, Path& path) {
  if (!disc.channel.step(limit, path.expansions)) return;
  if (!disc.channel.is_found()) {
    disc.outcome = Outcome::none;
    return;
  }
  const bool has_string = find_string(disc, disc.channel.exits(), disc.channel.goal_face());
  if (has_string && disc.algorithm != PathAlgorithm::optimal) {
    write_path(disc, distance(disc.start, disc.goal), path);
    if (disc.algorithm == PathAlgorithm::tra || is_over_budget(disc, path)) {
      disc.outcome = Outcome::found;
      return;
    }
    if (disc.has_guide) begin_guide(disc);
  }
  if (has_string && disc.has_guide) return begin_distances(disc);
  begin_shortest(disc, nullptr);
}

/// If a path is known and the budget is used up, ends the search and returns true. Otherwise reduces `limit`, so that
/// the search looks at the budget soon.
bool ends_by_budget(detail::DiscSearch& disc, std::size_t& limit, const Path& path) {
  if (path.status != PathStatus::found) return false;
  if (is_over_budget(disc, path)) disc.outcome = Outcome::found;
  limit = std::min({limit, disc.budget.expansions, path::saturating_add(path.expansions, kSlice)});
  return disc.outcome == Outcome::found;
}

/// Continues the stage `distances`.
void step_distances(detail::DiscSearch& disc, std::size_t limit, Path& path) {
  if (ends_by_budget(disc, limit, path) || !disc.guide.step(limit, path.expansions)) return;
  begin_shortest(disc, &disc.guide.distances());
}

/// Continues the stage `shortest`, until the search or its budget ends or `path.expansions` reaches `limit`. If the
/// search finds a path that is shorter than the string, writes its pieces. With `ta`, the string is in `path` already:
/// the path must then be surely shorter, so that a larger budget never gives a longer path.
void step_shortest(detail::DiscSearch& disc, std::size_t limit, Path& path) {
  if (ends_by_budget(disc, limit, path)) return;
  if (!disc.shortest.step(limit, path.expansions)) {
    path.lower_bound = std::max(path.lower_bound, std::min(path.length, disc.shortest.least_bound()));
    return;
  }
  const bool has_string_in_path = path.status == PathStatus::found;
  const double most = has_string_in_path ? disc.length * (1.0 - kLeastGain) : disc.length;
  if (disc.shortest.is_found() && disc.shortest.length() < most) {
    disc.shortest.write_path(disc.pieces);
    disc.length = disc.shortest.length();
  }
  disc.outcome = std::isinf(disc.length) ? Outcome::none : Outcome::found;
  if (disc.outcome == Outcome::found) write_path(disc, kInfinity, path);
}

/// Looks for a proof that the disc cannot move to the goal. Most searches for a path end before the first look.
void look_at_passage(detail::DiscSearch& disc, clearance::NearWalls& near_walls, const Path& path) {
  if (!std::isinf(disc.length)) {
    disc.next_look = kNever;
  } else if (path.expansions < kStepsBeforePassage) {
    if (disc.passage.remembers_refusal(near_walls)) disc.outcome = Outcome::none;
    disc.next_look = kStepsBeforePassage;
  } else {
    const std::optional<bool> passes = disc.passage.search(near_walls, kGatesPerLook);
    if (passes == false) disc.outcome = Outcome::none;
    disc.next_look = passes ? kNever : path.expansions + kStepsPerLook;
  }
}

/// Continues the search. Returns whether it has ended.
bool step(detail::DiscSearch& disc, std::size_t most, clearance::NearWalls& near_walls, Path& path) {
  while (disc.outcome == Outcome::running && path.expansions < most) {
    if (path.expansions >= disc.next_look) {
      look_at_passage(disc, near_walls, path);
      continue;
    }
    const std::size_t limit = std::min(most, disc.next_look);
    switch (disc.stage) {
      case Stage::guide:
        step_guide(disc, limit, path);
        break;
      case Stage::channel:
        step_channel(disc, limit, path);
        break;
      case Stage::distances:
        step_distances(disc, limit, path);
        break;
      case Stage::shortest:
        step_shortest(disc, limit, path);
        break;
    }
  }
  return disc.outcome != Outcome::running;
}

/// Writes the time since the start of the search, if the query wants it.
void write_time(const detail::DiscSearch& disc, Path& path) {
  if (disc.wants_time) path.time = Clock::now() - *disc.begun;
}

}  // namespace

/// Moves the ends at which the disc does not fit. Returns whether it fits at both ends now. If not, writes to `path`
/// which end is blocked.
bool World::Impl::move_blocked_disc_ends(PathQuery& query, detail::QueryScratch& scratch, Path& path) const {
  fit_disc(query.goal, query.agent, scratch, scratch.fit);
  const std::optional<Point> goal = scratch.fit.fits ? std::optional(query.goal) : std::nullopt;
  if (!move_blocked_disc_end(query, true, goal, scratch, path)) return false;
  return goal || move_blocked_disc_end(query, false, query.start, scratch, path);
}

/// Moves one end if the disc does not fit there. Returns whether the disc fits at this end now. `other` is the other
/// end if the disc fits there, otherwise nothing.
bool World::Impl::move_blocked_disc_end(PathQuery& query, bool is_start, const std::optional<Point>& other,
                                        detail::QueryScratch& scratch, Path& path) const {
  Point& end = is_start ? query.start : query.goal;
  fit_disc(end, query.agent, scratch, scratch.fit);
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

/// Returns the nearest position to a blocked end, among the positions within the tolerance at which the disc fits. If
/// the disc can move from some of these positions to `other`, returns the nearest of these.
std::optional<Point> World::Impl::find_disc_end(const PathQuery& query, const Point& end,
                                                const std::optional<Point>& other,
                                                detail::QueryScratch& scratch) const {
  const double tolerance = query.end_tolerance.value_or(path::default_end_tolerance(triangulation.domain()));
  if (!(tolerance > 0.0)) return std::nullopt;
  if (is_surely_blocked(triangulation, end, query.agent.radius, tolerance, scratch.near_walls)) return std::nullopt;
  NearestFitQuery nearest{end, query.agent, other, tolerance};
  if (other) {
    if (const auto found = nearest_fit_of_disc(nearest, scratch)) return found;
    nearest.goal.reset();
  }
  return nearest_fit_of_disc(nearest, scratch);
}

/// Starts the search for a path. Ends it at once if the straight line is the path, or if the ends are not connected.
/// Requires: the disc fits at both ends.
void World::Impl::begin_disc_search(const PathQuery& query, detail::QueryScratch& scratch) const {
  detail::DiscSearch& disc = scratch.disc_search;
  const constraint::ExactTriangulation& walls = mesh_of_discs();
  const nav::Abstraction* const known = kept_abstraction_for_discs();
  disc.start = query.start;
  disc.goal = query.goal;
  disc.map.emplace(walls, clearance->bridges(), query.agent.radius, query.start,
                   known != nullptr ? &known->core() : nullptr);
  disc.ends.begin(*disc.map, query.start, query.goal);
  if (known != nullptr && !disc.ends.are_connected(known->components())) {
    disc.outcome = Outcome::none;
    return;
  }
  disc.outcome = Outcome::running;
  if (find_straight(disc)) return;
  disc.algorithm = query.algorithm;
  disc.budget = query.budget;
  disc.length = kInfinity;
  disc.passage.begin(walls, clearance->bridges(), clearance->state(), query.start, query.goal, query.agent.radius);
  disc.next_look = disc.passage.may_remember() ? kStepsBeforeMemory : kStepsBeforePassage;
  disc.has_guide = !disc.ends.have_common_face();
  if (disc.algorithm == PathAlgorithm::optimal && disc.has_guide) {
    disc.stage = Stage::guide;
    begin_guide(disc);
  } else {
    disc.stage = Stage::channel;
    disc.channel.begin(*disc.map, disc.ends);
  }
}

bool World::Impl::begin_disc_path(const PathQuery& query, detail::QueryScratch& scratch, Path& path) const {
  path::reset(path);
  path.agent = query.agent;
  path.ends = {query.start, query.goal, query.end_tolerance, false};
  detail::DiscSearch& disc = scratch.disc_search;
  disc.outcome = Outcome::none;
  disc.begun.reset();
  disc.wants_time = query.wants_time;
  if (query.wants_time || query.budget.time != std::chrono::nanoseconds::max()) disc.begun = Clock::now();
  PathQuery moved = query;
  if (!move_blocked_disc_ends(moved, scratch, path)) {
    write_time(disc, path);
    return true;
  }
  begin_disc_search(moved, scratch);
  if (disc.outcome == Outcome::running) return false;
  if (disc.outcome == Outcome::found) write_path(disc, kInfinity, path);
  write_time(disc, path);
  return true;
}

bool World::Impl::step_disc_path(std::size_t limit, detail::QueryScratch& scratch, Path& path) const {
  detail::DiscSearch& disc = scratch.disc_search;
  if (disc.outcome != Outcome::running) return true;
  if (!step(disc, limit, scratch.near_walls, path)) return false;
  if (disc.outcome == Outcome::none) {
    path.expansions = 0;
    disc.passage.find_gap(scratch.near_walls, scratch.widest_gap);
    if (scratch.widest_gap.is_connected) write_widest(scratch.widest_gap, path.widest.emplace());
  }
  write_time(disc, path);
  return true;
}

void World::Impl::find_disc_paths_from(const ManyGoalsQuery& query, detail::QueryScratch& scratch,
                                       std::vector<Path>& paths) const {
  paths.resize(query.goals.size());
  PathQuery single{.start = query.start,
                   .goal = {},
                   .agent = query.agent,
                   .algorithm = PathAlgorithm::optimal,
                   .end_tolerance = query.end_tolerance};
  std::size_t expansions = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    Path& path = paths[i];
    single.goal = query.goals[i];
    if (!begin_disc_path(single, scratch, path)) {
      step_disc_path(std::numeric_limits<std::size_t>::max(), scratch, path);
    }
    path.ends->has_many_goals = true;
    expansions += path.expansions;
    if (!query.wants_points) path.pieces.clear();
  }
  for (Path& path : paths) path.expansions = expansions;
}

}  // namespace waywright
