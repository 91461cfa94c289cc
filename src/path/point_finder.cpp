#include "path/point_finder.hpp"

#include <algorithm>
#include <limits>

#include "path/answer.hpp"

namespace waywright::path {

namespace {

/// The search reads the clock each time it has entered this many triangles.
constexpr std::size_t kSlice = 256;

/// For this number of goals or more, one search without a heuristic finds the paths to all of them. For fewer goals,
/// each goal has its own search, with a heuristic. In a world of some hundreds of obstacles, the two methods cost the
/// same at about this number.
constexpr std::size_t kManyGoals = 256;

}  // namespace

void PointFinder::begin(const Ground& ground, const PathQuery& query, Path& path, LookedAt* looked_at) {
  triangulation_ = &ground.triangulation;
  abstraction_ = ground.abstraction;
  looked_at_ = looked_at;
  query_ = query;
  clock_.begin(query);
  reset(path);
  path.ends = {query.start, query.goal, query.end_tolerance, false};
  ends_.set_start(*triangulation_, abstraction_, query.start, query.end_tolerance);
  const std::optional<PathStatus> known = ends_.find_status_without_search(query.goal);
  ends_.write_ends(known.value_or(PathStatus::no_path), path);
  is_searched_ = !known.has_value();
  is_done_ = !is_searched_;
  is_proving_ = false;
  if (looked_at != nullptr) look_at_ends();
  if (is_done_) {
    path.status = *known;
    if (path.status == PathStatus::found) write_straight(query.wants_channel, path);
    finish(path);
  } else if (query.algorithm == PathAlgorithm::ta) {
    ta_.begin(*triangulation_, ends_, looked_at);
  } else if (query.algorithm == PathAlgorithm::tra) {
    tra_.begin(*triangulation_, *abstraction_, ends_);
  } else {
    begin_optimal(std::numeric_limits<double>::infinity());
  }
}

/// Records that the search has looked at the faces that the location of the ends has read. In three cases the function
/// does not know each of these faces. It then records that the search has looked at every face: the search is already
/// done; an end was moved; the algorithm is `tra`, which records no faces.
void PointFinder::look_at_ends() {
  looked_at_->clear(triangulation_->topology().face_slots());
  if (is_done_ || ends_.has_moved() || query_.algorithm == PathAlgorithm::tra) return looked_at_->look_at_all();
  for (const mesh::HalfEdge h : ends_.start_faces()) looked_at_->look(mesh::face(h));
  for (const mesh::HalfEdge h : ends_.goal_faces()) looked_at_->look(mesh::face(h));
  for (const mesh::HalfEdge h : ends_.crossed_before_stop()) {
    looked_at_->look(mesh::face(h));
    looked_at_->look(mesh::face(triangulation_->topology().twin(h)));
  }
}

void PointFinder::grow_to_mesh() {
  looked_at_->grow_to(triangulation_->topology().face_slots());
  if (is_done_) return;
  if (query_.algorithm == PathAlgorithm::optimal || is_proving_) return optimal_.grow_to_mesh();
  if (query_.algorithm == PathAlgorithm::ta) ta_.grow_to_mesh();
}

void PointFinder::write_straight(bool wants_channel, Path& path) const {
  path.length = distance(ends_.start(), ends_.goal());
  path.lower_bound = path.length;
  path.points.push_back(ends_.start());
  path.points.push_back(ends_.goal());
  path.expansions = ends_.crossed().size();
  if (!wants_channel) return;
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const exact::Geometry& geometry = triangulation_->triangulation().geometry();
  const auto position_of = [&](mesh::Vertex v) { return geometry.rounded(number(v)); };
  for (const mesh::HalfEdge h : ends_.crossed()) {
    path.channel.push_back({position_of(mesh.target(h)), position_of(mesh.origin(h))});
  }
}

void PointFinder::begin_optimal(double known_length) {
  optimal_.begin(*triangulation_, abstraction_, search_start(), query_.wants_channel, looked_at_);
  optimal_.add_goal(ends_.goal(), ends_.goal_faces());
  optimal_.start(known_length);
}

bool PointFinder::step(std::size_t expansions, Path& path) {
  const std::size_t limit = saturating_add(path.expansions, expansions);
  while (!is_done_ && path.expansions < limit) {
    is_done_ = search(limit, path);
    if (is_done_) finish(path);
  }
  return is_done_;
}

bool PointFinder::search(std::size_t limit, Path& path) {
  if (query_.algorithm == PathAlgorithm::optimal) return search_optimal(limit, path);
  if (query_.algorithm == PathAlgorithm::tra) {
    tra_.find(path);
    if (query_.wants_channel && path.status == PathStatus::found) tra_.write_channel(path);
    return true;
  }
  if (clock_.is_over(path)) return true;
  const std::size_t slice = std::min(limit, clock_.next_look(path, kSlice));
  return is_proving_ ? search_optimal(slice, path) : search_ta(slice, path);
}

/// `ta` enters each half-edge only once, so its best path need not be the shortest. When `ta` has followed all
/// channels, `optimal` searches for a shorter path. It either finds the shortest path, or proves that the path of `ta`
/// is the shortest.
bool PointFinder::search_ta(std::size_t limit, Path& path) {
  if (!ta_.step(limit, path)) return false;
  if (path.status != PathStatus::found || path.lower_bound >= path.length) return true;
  ta_bound_ = path.lower_bound;
  if (query_.wants_channel) ta_.write_channel(path);
  begin_optimal(path.length);
  is_proving_ = true;
  return false;
}

bool PointFinder::search_optimal(std::size_t limit, Path& path) {
  if (!optimal_.step(limit, path.expansions)) {
    if (is_proving_) path.lower_bound = std::max(ta_bound_, std::min(optimal_.least_bound(), path.length));
    return false;
  }
  if (optimal_.is_found(0)) {
    optimal_.write_path(0, true, path);
    if (query_.wants_channel) optimal_.write_channel(0, path);
  } else if (is_proving_) {
    path.lower_bound = path.length;
  }
  return true;
}

void PointFinder::find_all(const Ground& ground, const ManyGoalsQuery& query, std::vector<Path>& paths) {
  triangulation_ = &ground.triangulation;
  abstraction_ = ground.abstraction;
  paths.resize(query.goals.size());
  pending_goals_.clear();
  std::size_t expansions = 0;
  ends_.set_start(*triangulation_, abstraction_, query.start, query.end_tolerance);
  ends_.move_blocked_start();
  for (std::size_t i = 0; i < paths.size(); ++i) {
    reset(paths[i]);
    paths[i].ends = {query.start, query.goals[i], query.end_tolerance, true};
    const std::optional<PathStatus> known = ends_.find_status_without_search(query.goals[i]);
    ends_.write_ends(known.value_or(PathStatus::no_path), paths[i]);
    if (known) {
      paths[i].status = *known;
      if (*known == PathStatus::found) write_straight(false, paths[i]);
      if (!query.wants_points) paths[i].points.clear();
      continue;
    }
    if (pending_goals_.empty()) optimal_.begin(*triangulation_, abstraction_, search_start(), false);
    optimal_.add_goal(ends_.goal(), ends_.goal_faces());
    pending_goals_.push_back(i);
    if (paths.size() < kManyGoals) find_pending_paths(query.wants_points, expansions, paths);
  }
  find_pending_paths(query.wants_points, expansions, paths);
  for (Path& path : paths) path.expansions = expansions;
}

/// Finds the paths to all goals that were added since the last call.
void PointFinder::find_pending_paths(bool wants_points, std::size_t& expansions, std::vector<Path>& paths) {
  if (pending_goals_.empty()) return;
  optimal_.start();
  while (!optimal_.step(kToTheEnd, expansions)) {
  }
  for (std::size_t goal = 0; goal < pending_goals_.size(); ++goal) {
    if (optimal_.is_found(goal)) optimal_.write_path(goal, wants_points, paths[pending_goals_[goal]]);
  }
  pending_goals_.clear();
}

void PointFinder::finish(Path& path) const {
  if (query_.wants_channel && is_searched_ && query_.algorithm == PathAlgorithm::ta && !is_proving_ &&
      path.status == PathStatus::found) {
    ta_.write_channel(path);
  }
  clock_.write_time(path);
}

}  // namespace waywright::path
