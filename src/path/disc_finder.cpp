#include "path/disc_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "path/answer.hpp"
#include "path/pieces.hpp"
#include "path/tangent.hpp"

namespace waywright::path {

namespace {

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
constexpr std::size_t kNever = kToTheEnd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// If a path of `ta` is shorter than the string by a smaller share of its length than this, the rounding of its pieces
/// can make it longer than the string.
constexpr double kLeastGain = 0x1p-40;

/// Appends a straight line, and the arc after it, to the answer. `next` is where the arc ends. Leaves out a line
/// without length, and an arc that turns by less than a double can express.
void append(const DiscPiece& piece, double radius, const Point& next, std::vector<PathPiece>& pieces) {
  if (!(piece.from == piece.to)) pieces.push_back({PathPiece::Kind::line, piece.from, piece.to, {}, 0.0, 0.0, 0.0});
  if (piece.turn == kNoTurn) return;
  const Point radial{piece.turn * piece.direction.y, -piece.turn * piece.direction.x};
  const double start_angle = angle_of(radial);
  const double end_angle = start_angle + piece.turn * turning_angle(piece.direction, piece.end_direction, piece.turn);
  if (end_angle != start_angle) {
    pieces.push_back({PathPiece::Kind::arc, piece.to, next, piece.centre, radius, start_angle, end_angle});
  } else if (!pieces.empty()) {
    pieces.back().to = next;
  }
}

}  // namespace

void DiscFinder::begin(const Ground& ground, const PathQuery& query, Path& path) {
  clock_.begin(query);
  reset(path);
  path.agent = query.agent;
  path.ends = {query.start, query.goal, query.end_tolerance, false};
  outcome_ = Outcome::none;
  PathQuery moved = query;
  if (fits_.move_blocked_ends(ground, moved, path)) begin_search(ground, moved);
  if (outcome_ == Outcome::running) return;
  if (outcome_ == Outcome::found) write_path(kInfinity, path);
  clock_.write_time(path);
}

/// Starts the search for a path. Ends it at once if the straight line is the path, or if the ends are not connected.
/// Requires: the disc fits at both ends.
void DiscFinder::begin_search(const Ground& ground, const PathQuery& query) {
  const nav::Abstraction* const known = ground.abstraction_of_walls;
  start_ = query.start;
  goal_ = query.goal;
  map_.emplace(*ground.walls, *ground.bridges, query.agent.radius, query.start,
               known != nullptr ? &known->core() : nullptr);
  ends_.begin(*map_, query.start, query.goal);
  if (known != nullptr && !ends_.are_connected(known->components())) return;
  outcome_ = Outcome::running;
  if (find_straight()) return;
  algorithm_ = query.algorithm;
  length_ = kInfinity;
  passage_.begin(*ground.walls, *ground.bridges, query.start, query.goal, query.agent.radius);
  next_look_ = passage_.may_remember() ? kStepsBeforeMemory : kStepsBeforePassage;
  has_guide_ = !ends_.have_common_face();
  if (algorithm_ == PathAlgorithm::optimal && has_guide_) {
    stage_ = Stage::guide;
    begin_guide();
  } else {
    stage_ = Stage::channel;
    channel_.begin(*map_, ends_);
  }
}

bool DiscFinder::step(std::size_t expansions, Path& path) {
  if (outcome_ != Outcome::running) return true;
  if (!search(saturating_add(path.expansions, expansions), path)) return false;
  if (outcome_ == Outcome::none) {
    path.expansions = 0;
    passage_.find_gap(fits_.near_walls(), widest_);
    if (widest_.is_connected) path.widest = widest_;
  }
  clock_.write_time(path);
  return true;
}

void DiscFinder::find_all(const Ground& ground, const ManyGoalsQuery& query, std::vector<Path>& paths) {
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
    begin(ground, single, path);
    step(kToTheEnd, path);
    path.ends->has_many_goals = true;
    expansions += path.expansions;
    if (!query.wants_points) path.pieces.clear();
  }
  for (Path& path : paths) path.expansions = expansions;
}

/// Continues the search until it has ended, or until `path.expansions` reaches `most`. Returns whether it has ended.
bool DiscFinder::search(std::size_t most, Path& path) {
  while (outcome_ == Outcome::running && path.expansions < most) {
    if (path.expansions >= next_look_) {
      look_at_passage(path);
      continue;
    }
    const std::size_t limit = std::min(most, next_look_);
    switch (stage_) {
      case Stage::guide:
        step_guide(limit, path);
        break;
      case Stage::channel:
        step_channel(limit, path);
        break;
      case Stage::distances:
        step_distances(limit, path);
        break;
      case Stage::shortest:
        step_shortest(limit, path);
        break;
    }
  }
  return outcome_ != Outcome::running;
}

/// Tests the straight line from start to goal. If no wall is near it, it is the path.
bool DiscFinder::find_straight() {
  const DiscLine::End from{{ends_.start(), 0}, mesh::kNoVertex};
  const DiscLine::End to{{ends_.goal(), 0}, mesh::kNoVertex};
  const auto line = tangent(from.pivot, to.pivot, map_->radius);
  if (!line || !line_.is_clear(*map_, from, to, *line, ends_.goal_face())) return false;
  length_ = line->length;
  pieces_.assign({{start_, goal_, {}, 0, line->direction, {}}});
  outcome_ = Outcome::found;
  return true;
}

void DiscFinder::step_guide(std::size_t limit, Path& path) {
  if (!guide_.step(limit, path.expansions)) return;
  if (!guide_.is_found()) {
    outcome_ = Outcome::none;
    return;
  }
  const std::span<const mesh::HalfEdge> exits = guide_.collect_exits();
  if (find_string(exits, map_->mesh().twin(exits.back()))) return begin_distances();
  stage_ = Stage::channel;
  channel_.begin(*map_, ends_);
}

/// If it finds a string, writes the string as the first path.
void DiscFinder::step_channel(std::size_t limit, Path& path) {
  if (!channel_.step(limit, path.expansions)) return;
  if (!channel_.is_found()) {
    outcome_ = Outcome::none;
    return;
  }
  const bool has_string = find_string(channel_.exits(), channel_.goal_face());
  if (has_string && algorithm_ != PathAlgorithm::optimal) {
    write_path(distance(start_, goal_), path);
    if (algorithm_ == PathAlgorithm::tra || is_over_budget(path)) {
      outcome_ = Outcome::found;
      return;
    }
    if (has_guide_) begin_guide();
  }
  if (has_string && has_guide_) return begin_distances();
  begin_shortest(nullptr);
}

/// Searches for a string through a channel. Returns false if there is none.
bool DiscFinder::find_string(std::span<const mesh::HalfEdge> exits, mesh::HalfEdge goal_face) {
  if (!string_.find(*map_, ends_, exits, goal_face)) return false;
  string_.write_path(pieces_);
  // With `tra`, the search ends here, so it needs no limit.
  if (algorithm_ != PathAlgorithm::tra) length_ = string_.length();
  return true;
}

void DiscFinder::begin_distances() {
  stage_ = Stage::distances;
  guide_.continue_to(length_);
}

void DiscFinder::step_distances(std::size_t limit, Path& path) {
  if (ends_by_budget(limit, path) || !guide_.step(limit, path.expansions)) return;
  begin_shortest(&guide_.distances());
}

void DiscFinder::begin_shortest(const GuideDistances* distances) {
  stage_ = Stage::shortest;
  shortest_.begin(*map_, ends_, length_, distances);
}

/// Continues until the search or its budget ends or `path.expansions` reaches `limit`. If the search finds a path that
/// is shorter than the string, writes its pieces. With `ta`, the string is in `path` already: the path must then be
/// surely shorter, so that a larger budget never gives a longer path.
void DiscFinder::step_shortest(std::size_t limit, Path& path) {
  if (ends_by_budget(limit, path)) return;
  if (!shortest_.step(limit, path.expansions)) {
    path.lower_bound = std::max(path.lower_bound, std::min(path.length, shortest_.least_bound()));
    return;
  }
  const bool has_string_in_path = path.status == PathStatus::found;
  const double most = has_string_in_path ? length_ * (1.0 - kLeastGain) : length_;
  if (shortest_.is_found() && shortest_.length() < most) {
    shortest_.write_path(pieces_);
    length_ = shortest_.length();
  }
  outcome_ = std::isinf(length_) ? Outcome::none : Outcome::found;
  if (outcome_ == Outcome::found) write_path(kInfinity, path);
}

/// If a path is known and the budget is used up, ends the search and returns true. Otherwise reduces `limit`, so that
/// the search looks at the budget soon.
bool DiscFinder::ends_by_budget(std::size_t& limit, const Path& path) {
  if (path.status != PathStatus::found) return false;
  if (is_over_budget(path)) outcome_ = Outcome::found;
  limit = std::min(limit, clock_.next_look(path, kSlice));
  return outcome_ == Outcome::found;
}

/// Looks for a proof that the disc cannot move to the goal. Most searches for a path end before the first look.
void DiscFinder::look_at_passage(const Path& path) {
  if (!std::isinf(length_)) {
    next_look_ = kNever;
  } else if (path.expansions < kStepsBeforePassage) {
    if (passage_.remembers_refusal(fits_.near_walls())) outcome_ = Outcome::none;
    next_look_ = kStepsBeforePassage;
  } else {
    const std::optional<bool> passes = passage_.search(fits_.near_walls(), kGatesPerLook);
    if (passes == false) outcome_ = Outcome::none;
    next_look_ = passes ? kNever : path.expansions + kStepsPerLook;
  }
}

/// Writes the path from `pieces_`. `lower_bound` is a lower bound of the length of the shortest path.
void DiscFinder::write_path(double lower_bound, Path& path) const {
  path.status = PathStatus::found;
  path.pieces.clear();
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const bool is_last = i + 1 == pieces_.size();
    append(pieces_[i], path.agent.radius, is_last ? goal_ : pieces_[i + 1].from, path.pieces);
  }
  if (path.pieces.empty()) path.pieces.push_back({PathPiece::Kind::line, start_, goal_, {}, 0.0, 0.0, 0.0});
  path.pieces.front().from = start_;
  path.pieces.back().to = goal_;
  // The length of the rounded pieces, as Path::at computes it.
  path.length = length_of(path.pieces);
  path.lower_bound = std::min(path.length, lower_bound);
}

}  // namespace waywright::path
