#include "path/free_positions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "exact/doubles.hpp"
#include "exact/filter.hpp"
#include "exact/nearest_on_segment.hpp"
#include "nav/point_agent.hpp"
#include "path/distance.hpp"

namespace waywright::path {

using mesh::HalfEdge;

namespace {

/// A limit at or above this has no effect: no two positions in a domain are so far apart.
constexpr double kNoLimit = 0x1p110;
/// A limit below this is smaller than every distance between a position and a wall on which it does not lie.
constexpr double kLeastLimit = 0x1p-1000;

/// The number of edges at which one call of choose() looks for a free point.
constexpr std::size_t kTries = 8;
/// The largest number of searches for one answer. If the gaps between polygons beyond the nearest edges are too narrow
/// for a point (two doubles), the next search looks farther away.
constexpr std::size_t kRounds = 32;
/// How often nearest_on_ray() halves the distance between a free and a blocked position.
constexpr int kHalvings = 6;

/// Returns the value, or 0 if it is too small for a coordinate.
double coordinate(double value) { return std::abs(value) < kSmallestCoordinate ? 0.0 : value; }

/// Returns coordinate(value) and the two coordinates next to it, ascending.
std::array<double, 3> neighbours(double value) {
  value = coordinate(value);
  return {exact::next_coordinate<double>(value, -1.0), value, exact::next_coordinate<double>(value, 1.0)};
}

}  // namespace

std::optional<Point> FreePositions::nearest(const Triangulation& triangulation, constraint::CoverFinder& cover_finder,
                                            const Point& point, const locate::Located& location, double limit,
                                            const Connection& connection) {
  if (limit < kLeastLimit) return std::nullopt;
  triangulation_ = &triangulation;
  cover_finder_ = &cover_finder;
  point_ = point;
  slack_ = 0x1p-46 * exact::filter::largest_magnitude(triangulation.domain());
  refused_.clear();
  nearest_found_.reset();
  for (std::size_t round = 0; round < kRounds; ++round) {
    const std::size_t refused_before = refused_.size();
    flood(location, limit, connection);
    if (choose(limit, connection)) break;
    if (refused_.size() == refused_before) break;  // there is nothing else within the limit
    if (nearest_found_) limit = std::min(limit, distance(point_, *nearest_found_));
    if (limit < kLeastLimit) break;
  }
  return nearest_found_;
}

/// Collects the edges between covered and open faces that may contain the nearest free position. The straight segment
/// from the point to this position passes only through covered faces. So no edge that this segment crosses is farther
/// from the point than the position.
void FreePositions::flood(const locate::Located& location, double limit, const Connection& connection) {
  stamp_.next(1, marks_);
  marks_.grow_to(triangulation_->topology().face_slots());
  candidates_.clear();
  nearest_ = limit + slack_;
  constraint::faces_at(*triangulation_, location, waiting_);
  for (const HalfEdge h : waiting_) {
    marks_.make_room(number(mesh::face(h)));
    marks_[number(mesh::face(h))] = stamp_.value();
  }
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const HalfEdge face = waiting_[i];
    for (const HalfEdge h : {face, mesh::next(face), mesh::previous(face)}) visit(h, connection);
  }
}

/// Looks at the face beyond `h`. The face of `h` is not open, or the search has reached it across a refused edge.
void FreePositions::visit(HalfEdge h, const Connection& connection) {
  const HalfEdge beyond = triangulation_->topology().twin(h);
  if (triangulation_->triangulation().is_ghost_face(beyond)) return;
  const double distance = distance_to(h);
  if (distance > nearest_ + slack_) return;
  const bool is_wall = !nav::PointAgent::can_cross(triangulation_->topology(), h);
  if (is_wall && !is_refused(h) && is_open(beyond, connection)) {
    nearest_ = std::min(nearest_, distance + slack_);
    return candidates_.push_back({h, distance});
  }
  const auto face = number(mesh::face(beyond));
  marks_.make_room(face);
  if (std::exchange(marks_[face], stamp_.value()) != stamp_.value()) waiting_.push_back(beyond);
}

bool FreePositions::is_refused(HalfEdge h) const {
  return std::find(refused_.begin(), refused_.end(), h) != refused_.end();
}

/// Returns the distance from the point to the edge of `h`, in doubles, with an error less than `slack_`.
double FreePositions::distance_to(HalfEdge h) const {
  const exact::Geometry& geometry = triangulation_->triangulation().geometry();
  const Point& a = geometry.rounded(number(triangulation_->topology().origin(h)));
  const Point& b = geometry.rounded(number(triangulation_->topology().target(h)));
  const Point edge{b.x - a.x, b.y - a.y};
  const double squared_length = edge.x * edge.x + edge.y * edge.y;
  if (squared_length <= kNoLength) return distance(point_, a);
  const double share = ((point_.x - a.x) * edge.x + (point_.y - a.y) * edge.y) / squared_length;
  const double clamped = std::clamp(share, 0.0, 1.0);
  return distance(point_, {a.x + clamped * edge.x, a.y + clamped * edge.y});
}

bool FreePositions::is_open(HalfEdge h, const Connection& connection) {
  return !cover_finder_->is_covered(*triangulation_, h) && connection.contains(h);
}

bool FreePositions::Connection::contains(HalfEdge h) const {
  if (components == nullptr) return true;
  const nav::Components::Id own = components->component_of(mesh::face(h));
  return std::any_of(faces->begin(), faces->end(),
                     [&](HalfEdge other) { return components->component_of(mesh::face(other)) == own; });
}

/// Tries the candidates in the order of their exact distances, and sets `nearest_found_`. Returns true if a candidate
/// has a free point next to its nearest position: then the candidates after it are not nearer. Adds the candidates
/// without such a point to `refused_`.
bool FreePositions::choose(double limit, const Connection& connection) {
  std::erase_if(candidates_, [&](const Candidate& candidate) { return candidate.distance > nearest_ + slack_; });
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const exact::Geometry& geometry = triangulation_->triangulation().geometry();
  std::vector<std::pair<exact::NearestOnSegment, HalfEdge>> positions;
  for (const auto& [h, distance] : candidates_) {
    const constraint::Side& side = triangulation_->items().side(triangulation_->uses().any(mesh.label(h)));
    const exact::NearestOnSegment candidate_position(
        point_, geometry.exact(number(mesh.origin(h))), geometry.exact(number(mesh.target(h))),
        geometry.rounded(number(side.from)), geometry.rounded(number(side.to)));
    if (limit >= kNoLimit || candidate_position.is_within(limit)) positions.emplace_back(candidate_position, h);
  }
  // Two edges have equal positions if it is their common vertex. A stable sort keeps them in the order of the flood.
  std::stable_sort(positions.begin(), positions.end(),
                   [](const auto& p, const auto& q) { return exact::NearestOnSegment::compare(p.first, q.first) < 0; });
  for (std::size_t i = 0; i < std::min(positions.size(), kTries); ++i) {
    const Point rounded = positions[i].first.rounded();
    if (const auto found = round_to_free(rounded, connection)) {
      take_nearer(*found);
      return true;
    }
    refused_.push_back(positions[i].second);
    look_in_wedge(positions[i].second, rounded, limit, connection);
  }
  return false;
}

void FreePositions::take_nearer(const Point& found) {
  if (!nearest_found_ || distance(point_, found) < distance(point_, *nearest_found_)) nearest_found_ = found;
}

/// Looks for a free point in the wedge of open faces beyond `h`, at the end of `h` that is nearer to `position`.
/// Updates `nearest_found_`.
void FreePositions::look_in_wedge(HalfEdge h, const Point& position, double limit, const Connection& connection) {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const exact::Geometry& geometry = triangulation_->triangulation().geometry();
  const Point& target = geometry.rounded(number(mesh.target(h)));
  const Point& origin = geometry.rounded(number(mesh.origin(h)));
  const bool is_at_target = distance(position, target) <= distance(position, origin);
  const auto direction = wedge_direction(h, is_at_target);
  if (!direction) return;
  if (const auto found = nearest_on_ray(is_at_target ? target : origin, *direction, limit, connection)) {
    take_nearer(*found);
  }
}

/// Returns a vector of length 1 that points into the wedge of open faces beyond the wall `h`, between this wall and the
/// next one around its target (`is_at_target`) or its origin. Returns nothing if the rounded coordinates of two
/// vertices are equal, or if rounding errors hide the direction.
std::optional<Point> FreePositions::wedge_direction(HalfEdge h, bool is_at_target) const {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  const exact::Geometry& geometry = triangulation_->triangulation().geometry();
  // The half-edges below start at the vertex. The open face lies left of `first` if the vertex is the target of `h`.
  const HalfEdge first = is_at_target ? mesh.twin(h) : h;
  HalfEdge last = first;
  do {
    last = is_at_target ? mesh.next_around(last) : mesh.previous_around(last);
  } while (last != first && nav::PointAgent::can_cross(mesh, last));
  const Point& vertex = geometry.rounded(number(mesh.origin(first)));
  const Point from = geometry.rounded(number(mesh.target(first))) - vertex;
  const Point to = geometry.rounded(number(mesh.target(last))) - vertex;
  if (squared_length(from) == 0.0 || squared_length(to) == 0.0) return std::nullopt;
  const double side = is_at_target ? 1.0 : -1.0;
  const bool is_narrow = side * cross(from, to) > 0.0;
  const Point middle =
      is_narrow ? from * (1.0 / length(from)) + to * (1.0 / length(to)) : Point{-side * from.y, side * from.x};
  if (squared_length(middle) == 0.0) return std::nullopt;
  return middle * (1.0 / length(middle));
}

/// Returns a free point on a ray, rounded, that is about as near to the apex as possible. Returns nothing if it finds
/// none, or if the point is farther than `limit` from the point of the query.
std::optional<Point> FreePositions::nearest_on_ray(const Point& apex, const Point& direction, double limit,
                                                   const Connection& connection) {
  const auto at = [&](double length) {
    return Point{coordinate(apex.x + length * direction.x), coordinate(apex.y + length * direction.y)};
  };
  const double unit = 0x1p-53 * std::max({std::abs(apex.x), std::abs(apex.y), kSmallestCoordinate});
  double blocked = 0.0;
  double free = unit;
  for (;; blocked = free, free *= 2.0) {
    const Point next = at(free);
    if (distance(point_, next) > limit || !is_in_domain(next)) return std::nullopt;
    if (is_free(next, connection)) break;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (blocked + free);
    (is_free(at(middle), connection) ? free : blocked) = middle;
  }
  return at(free);
}

/// Returns the free point that is nearest to `rounded`, among `rounded` and the eight points around it.
std::optional<Point> FreePositions::round_to_free(const Point& rounded, const Connection& connection) {
  std::array<Point, 9> around;
  std::size_t count = 0;
  for (const double x : neighbours(rounded.x)) {
    for (const double y : neighbours(rounded.y)) around[count++] = {x, y};
  }
  const auto squared_distance = [&](const Point& p) {
    const double dx = p.x - rounded.x;
    const double dy = p.y - rounded.y;
    return dx * dx + dy * dy;
  };
  std::sort(around.begin(), around.end(), [&](const Point& p, const Point& q) {
    const double p_distance = squared_distance(p);
    const double q_distance = squared_distance(q);
    if (p_distance != q_distance) return p_distance < q_distance;
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  });
  const auto found = std::find_if(around.begin(), around.end(), [&](const Point& p) { return is_free(p, connection); });
  if (found == around.end()) return std::nullopt;
  return *found;
}

bool FreePositions::is_in_domain(const Point& point) const {
  return triangulation_->domain().contains(point) && is_in_range(point);
}

bool FreePositions::is_free(const Point& point, const Connection& connection) {
  if (!is_in_domain(point)) return false;
  constraint::faces_at(*triangulation_, triangulation_->triangulation().locate(point), waiting_);
  return std::any_of(waiting_.begin(), waiting_.end(), [&](HalfEdge h) { return is_open(h, connection); });
}

}  // namespace waywright::path
