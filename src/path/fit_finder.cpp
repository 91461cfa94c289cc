#include "path/fit_finder.hpp"

#include <algorithm>
#include <cmath>

#include "clearance/disc_passage.hpp"
#include "path/point_ends.hpp"

namespace waywright::path {

namespace {

/// Returns true only if the disc fits at no position within the tolerance from `end`. If a wall is nearer to the end
/// than the radius minus the tolerance, it is nearer than the radius to each of these positions.
bool is_surely_blocked(const constraint::ConstrainedTriangulation& triangulation, const Point& end, double radius,
                       double tolerance, clearance::NearWalls& near_walls) {
  // If the difference is smaller, a search for a free position is more likely to succeed, so the shortcut is not tried.
  const double difference = std::nextafter(radius - tolerance, 0.0);
  return difference > 0.5 * radius && !near_walls.has_no_nearer_wall(triangulation, end, difference);
}

}  // namespace

void FitFinder::fit(const Ground& ground, const Point& centre, const Agent& agent, DiscFit& fit) {
  const constraint::ItemTable& items = ground.triangulation.items();
  fit.items.clear();
  if (agent.radius > 0.0) {
    slots_.clear();
    near_walls_.find_items(ground.triangulation, centre, agent.radius, slots_);
    for (const std::uint32_t slot : slots_) fit.items.push_back(items.id(slot));
  }
  cover_finder_.use(ground.abstraction);
  const locate::Located located = ground.triangulation.triangulation().locate(centre);
  for (const std::uint32_t slot : cover_finder_.strictly_covering(ground.triangulation, located)) {
    fit.items.push_back(items.id(slot));
  }
  std::sort(fit.items.begin(), fit.items.end());
  fit.items.erase(std::unique(fit.items.begin(), fit.items.end()), fit.items.end());
  fit.fits = fit.items.empty();
}

void FitFinder::find_nearest(const Ground& ground, const NearestFitQuery& query, NearestFit& fit) {
  fit = {};
  if (query.agent.radius > 0.0 && query.goal && !fits(ground, *query.goal, query.agent)) return;
  const auto found = query.agent.radius > 0.0 ? find_nearest_of_disc(ground, query) : find_nearest_free(ground, query);
  if (found) fit = {true, *found, distance(query.point, *found)};
}

/// find_nearest() for a radius above 0. Requires: the disc fits at the goal, if there is one.
std::optional<Point> FitFinder::find_nearest_of_disc(const Ground& ground, const NearestFitQuery& query) {
  cover_finder_.use(ground.abstraction);
  const clearance::NearestFit::Query of_disc{query.point, query.agent.radius, query.limit};
  if (!query.goal) return nearest_fit_.find(ground.triangulation, cover_finder_, near_walls_, of_disc, nullptr);
  const clearance::NearestFit::Goal goal{*ground.walls, *ground.bridges, *find_cell(ground, *query.goal)};
  return nearest_fit_.find(ground.triangulation, cover_finder_, near_walls_, of_disc, &goal);
}

/// find_nearest() for the radius 0.
std::optional<Point> FitFinder::find_nearest_free(const Ground& ground, const NearestFitQuery& query) {
  const constraint::ConstrainedTriangulation& triangulation = ground.triangulation;
  cover_finder_.use(ground.abstraction);
  FreePositions::Connection connection;
  if (query.goal) {
    goal_faces_ = cover_finder_.open_faces(triangulation, triangulation.triangulation().locate(*query.goal));
    if (goal_faces_.empty()) return std::nullopt;
    connection = {&ground.abstraction->components(), &goal_faces_};
  }
  const locate::Located location = triangulation.triangulation().locate(query.point);
  for (const mesh::HalfEdge h : cover_finder_.open_faces(triangulation, location)) {
    if (connection.contains(h)) return query.point;
  }
  if (query.limit == 0.0) return std::nullopt;
  return free_positions_.nearest(triangulation, cover_finder_, query.point, location, query.limit, connection);
}

bool FitFinder::move_blocked_ends(const Ground& ground, PathQuery& query, Path& path) {
  const bool fits_at_goal = fits(ground, query.goal, query.agent);
  const std::optional<Point> goal = fits_at_goal ? std::optional(query.goal) : std::nullopt;
  if (!move_blocked_end(ground, query, true, goal, path)) return false;
  return goal || move_blocked_end(ground, query, false, query.start, path);
}

/// Moves one end if the disc does not fit there. Returns whether the disc fits at this end now. `other` is the other
/// end if the disc fits there, otherwise nothing.
bool FitFinder::move_blocked_end(const Ground& ground, PathQuery& query, bool is_start,
                                 const std::optional<Point>& other, Path& path) {
  Point& end = is_start ? query.start : query.goal;
  if (fits(ground, end, query.agent)) return true;
  const auto moved = find_end(ground, query, end, other);
  if (!moved) {
    path.status = is_start ? PathStatus::start_blocked : PathStatus::goal_blocked;
    path.blockers = blockers();
    return false;
  }
  (is_start ? path.moved_start : path.moved_goal) = MovedEnd{end, *moved};
  end = *moved;
  return true;
}

/// Returns the nearest position to a blocked end, among the positions within the tolerance at which the disc fits. If
/// the disc can move from some of these positions to `other`, returns the nearest of these.
std::optional<Point> FitFinder::find_end(const Ground& ground, const PathQuery& query, const Point& end,
                                         const std::optional<Point>& other) {
  const double tolerance = query.end_tolerance.value_or(default_end_tolerance(ground.triangulation.domain()));
  if (!(tolerance > 0.0)) return std::nullopt;
  if (is_surely_blocked(ground.triangulation, end, query.agent.radius, tolerance, near_walls_)) return std::nullopt;
  NearestFitQuery nearest{end, query.agent, other, tolerance};
  if (other) {
    if (const auto found = find_nearest_of_disc(ground, nearest)) return found;
    nearest.goal.reset();
  }
  return find_nearest_of_disc(ground, nearest);
}

std::vector<FitFinder::Areas> FitFinder::find_areas(const Ground& ground, std::span<const Point> points,
                                                    const Agent& agent) {
  if (agent.radius > 0.0) return find_areas_of_disc(ground, points, agent);
  std::vector<Areas> areas(points.size());
  cover_finder_.use(ground.abstraction);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const locate::Located location = ground.triangulation.triangulation().locate(points[i]);
    for (const mesh::HalfEdge h : cover_finder_.open_faces(ground.triangulation, location)) {
      areas[i].push_back(ground.abstraction->components().component_of(mesh::face(h)));
    }
    std::sort(areas[i].begin(), areas[i].end());
    areas[i].erase(std::unique(areas[i].begin(), areas[i].end()), areas[i].end());
  }
  return areas;
}

std::vector<FitFinder::Areas> FitFinder::find_areas_of_disc(const Ground& ground, std::span<const Point> points,
                                                            const Agent& agent) {
  std::vector<Areas> areas(points.size());
  const clearance::Cells cells(*ground.walls, *ground.bridges);
  std::vector<std::optional<clearance::CellEdge>> cell_of(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (fits(ground, points[i], agent)) cell_of[i] = find_cell(ground, points[i]);
  }
  clearance::DiscReach reach;
  for (std::size_t first = 0; first < points.size(); ++first) {
    if (!cell_of[first] || !areas[first].empty()) continue;
    reach.begin(cells, *cell_of[first], agent.radius);
    for (std::size_t i = first; i < points.size(); ++i) {
      const bool has_no_area = cell_of[i] && areas[i].empty();
      if (has_no_area && reach.is_reached(cells, *cell_of[i])) areas[i].push_back(static_cast<std::uint32_t>(first));
    }
  }
  return areas;
}

}  // namespace waywright::path
