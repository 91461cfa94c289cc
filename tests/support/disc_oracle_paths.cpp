#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <sstream>
#include <utility>

#include "support/disc_oracle.hpp"

namespace waywright::test::disc {
namespace {

using Real = long double;

constexpr Real kPi = 3.14159265358979323846264338327950288L;
constexpr int kDigits = std::numeric_limits<Real>::digits;
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

struct Vector {
  Real x = 0.0L;
  Real y = 0.0L;

  friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector operator*(Vector a, Real factor) { return {a.x * factor, a.y * factor}; }
};

Real dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
Real cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
Real length_of(Vector a) { return std::hypot(a.x, a.y); }
Vector left_of(Vector a) { return {-a.y, a.x}; }
Vector at_angle(Real angle) { return {std::cos(angle), std::sin(angle)}; }
Real angle_of(Vector a) { return std::atan2(a.y, a.x); }

struct Wall {
  Vector a;
  Vector b;
};

Real distance(Vector p, const Wall& wall) {
  const Vector d = wall.b - wall.a;
  const Real square = dot(d, d);
  if (square == 0.0L) return length_of(p - wall.a);
  const Real along = dot(p - wall.a, d) / square;
  if (along <= 0.0L) return length_of(p - wall.a);
  if (along >= 1.0L) return length_of(p - wall.b);
  return std::fabs(cross(d, p - wall.a)) / std::sqrt(square);
}

Real distance(const Wall& s, const Wall& t) {
  const Real a = cross(s.b - s.a, t.a - s.a);
  const Real b = cross(s.b - s.a, t.b - s.a);
  const Real c = cross(t.b - t.a, s.a - t.a);
  const Real d = cross(t.b - t.a, s.b - t.a);
  if (((a < 0.0L) != (b < 0.0L)) && ((c < 0.0L) != (d < 0.0L))) return 0.0L;
  return std::min({distance(s.a, t), distance(s.b, t), distance(t.a, s), distance(t.b, s)});
}

/// The walls with start as the origin, so that a large distance from (0, 0) costs no digits.
struct Scene {
  Scene(const Walls& list, Point start) : origin(start) {
    for (const auto& [a, b] : list.segments) {
      if (a == b) continue;
      walls.push_back({local(a), local(b)});
      for (const Vector p : {walls.back().a, walls.back().b}) {
        extent = std::max({extent, std::fabs(p.x), std::fabs(p.y)});
      }
    }
  }

  [[nodiscard]] Vector local(Point p) const {
    return {static_cast<Real>(p.x) - static_cast<Real>(origin.x), static_cast<Real>(p.y) - static_cast<Real>(origin.y)};
  }
  [[nodiscard]] Point global(Vector p) const {
    return {static_cast<double>(p.x + static_cast<Real>(origin.x)),
            static_cast<double>(p.y + static_cast<Real>(origin.y))};
  }
  template <class Shape>
  [[nodiscard]] Real clearance(const Shape& shape) const {
    Real least = kInfinity;
    for (const Wall& wall : walls) least = std::min(least, distance(shape, wall));
    return least;
  }

  Point origin;
  std::vector<Wall> walls;
  Real extent = 0.0L;
};

/// The graph of the common tangents of the circles around all ends of walls. Start and goal are circles of radius 0.
class TangentGraph {
 public:
  TangentGraph(const Walls& walls, Point start, Point goal, double r)
      : scene_(walls, start), r_(r), least_(r - (r * kShortestTolerance + std::ldexp(scene_.extent, 6 - kDigits))) {
    circles_.push_back({scene_.local(start), 0.0L, {}, {}});
    circles_.push_back({scene_.local(goal), 0.0L, {}, {}});
    for (const Wall& wall : scene_.walls) {
      for (const Vector end : {wall.a, wall.b}) {
        const auto is_there = [&](const Circle& c) { return c.centre.x == end.x && c.centre.y == end.y; };
        if (std::none_of(circles_.begin() + 2, circles_.end(), is_there)) circles_.push_back({end, r_, {}, {}});
      }
    }
  }

  std::optional<ShortestPath> search() {
    if (!is_clear(circles_[0].centre) || !is_clear(circles_[1].centre)) return std::nullopt;
    if (circles_[0].centre.x == circles_[1].centre.x && circles_[0].centre.y == circles_[1].centre.y) {
      return ShortestPath{};
    }
    nodes_.resize(2);
    for (std::size_t i = 0; i < circles_.size(); ++i) {
      for (std::size_t j = i + 1; j < circles_.size(); ++j) add_tangents(i, j);
    }
    for (std::size_t i = 2; i < circles_.size(); ++i) add_arcs(i);
    return dijkstra();
  }

 private:
  struct Event {
    Real angle = 0.0L;  ///< from 0 to 2 pi
    std::size_t node = 0;
  };
  struct Circle {
    Vector centre;
    Real radius = 0.0L;
    std::vector<Event> forwards;   ///< where a path that turns counter-clockwise arrives or leaves
    std::vector<Event> backwards;  ///< the same for clockwise paths
  };
  struct Link {
    std::size_t to = 0;
    Real length = 0.0L;
    std::size_t circle = 0;  ///< of an arc; 0: a straight piece
    Real start = 0.0L;       ///< the start angle of an arc
    Real turn = 0.0L;        ///< the signed angle of an arc
    Wall line{};             ///< a straight piece
  };

  [[nodiscard]] bool is_clear(Vector p) const { return scene_.clearance(p) >= least_; }
  [[nodiscard]] bool is_clear(const Wall& line) const {
    return std::all_of(scene_.walls.begin(), scene_.walls.end(),
                       [&](const Wall& wall) { return distance(line, wall) >= least_; });
  }

  static Real normal_angle(Real angle) {
    while (angle < 0.0L) angle += 2.0L * kPi;
    while (angle >= 2.0L * kPi) angle -= 2.0L * kPi;
    return angle;
  }

  /// Adds the tangents between two circles. A path turns around circle i counter-clockwise (rotation = 1) or clockwise
  /// (-1).
  void add_tangents(std::size_t i, std::size_t j) {
    for (const int rotation_i : {1, -1}) {
      if (i < 2 && rotation_i < 0) continue;
      for (const int rotation_j : {1, -1}) {
        if (j < 2 && rotation_j < 0) continue;
        add_tangent(i, rotation_i, j, rotation_j);
      }
    }
  }

  void add_tangent(std::size_t i, int rotation_i, std::size_t j, int rotation_j) {
    const Circle& from = circles_[i];
    const Circle& to = circles_[j];
    // centre j - centre i = along u + across left_of(u), for the direction u of the tangent.
    const Vector between = to.centre - from.centre;
    const Real square = dot(between, between);
    if (square == 0.0L) return;
    const Real across = rotation_j * to.radius - rotation_i * from.radius;
    const Real rest = square - across * across;
    if (rest < 0.0L && std::sqrt(square) < std::fabs(across) - (r_ - least_)) return;
    const Real along = std::sqrt(std::max(rest, 0.0L));
    const Vector u = (between * along - left_of(between) * across) * (1.0L / square);
    const Wall line{from.centre - left_of(u) * (rotation_i * from.radius),
                    to.centre - left_of(u) * (rotation_j * to.radius)};
    if (!is_clear(line)) return;
    add_link(node_at(i, rotation_i, line.a), node_at(j, rotation_j, line.b), {0, along, 0, 0.0L, 0.0L, line});
    add_link(node_at(j, -rotation_j, line.b), node_at(i, -rotation_i, line.a),
             {0, along, 0, 0.0L, 0.0L, {line.b, line.a}});
  }

  std::size_t node_at(std::size_t circle, int rotation, Vector at) {
    if (circle < 2) return circle;
    Circle& c = circles_[circle];
    nodes_.emplace_back();
    (rotation > 0 ? c.forwards : c.backwards).push_back({normal_angle(angle_of(at - c.centre)), nodes_.size() - 1});
    return nodes_.size() - 1;
  }

  void add_link(std::size_t from, std::size_t to, Link link) {
    link.to = to;
    nodes_[from].push_back(link);
  }

  /// Adds the arcs between consecutive tangents of a circle on which no wall is nearer than r.
  void add_arcs(std::size_t circle) {
    Circle& c = circles_[circle];
    std::vector<Real> cuts = cuts_of(c);
    for (const auto* events : {&c.forwards, &c.backwards}) {
      for (const Event& event : *events) cuts.push_back(event.angle);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    if (cuts.empty()) return;
    // blocked[k]: how many of the arcs before cut k are blocked. The last arc goes past the angle 0.
    std::vector<std::size_t> blocked{0};
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      const Real end = k + 1 < cuts.size() ? cuts[k + 1] : cuts[0] + 2.0L * kPi;
      const bool is_blocked = !is_clear(c.centre + at_angle((cuts[k] + end) / 2.0L) * c.radius);
      blocked.push_back(blocked.back() + (is_blocked ? 1 : 0));
    }
    const auto blocked_at = [&](Real angle) {
      return blocked[static_cast<std::size_t>(std::lower_bound(cuts.begin(), cuts.end(), angle) - cuts.begin())];
    };
    for (const int rotation : {1, -1}) {
      auto& events = rotation > 0 ? c.forwards : c.backwards;
      std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.angle < b.angle; });
      for (std::size_t k = 0; events.size() > 1 && k < events.size(); ++k) {
        const Event& a = events[k];
        const Event& b = events[(k + 1) % events.size()];
        const bool is_last = k + 1 == events.size();
        const std::size_t between = is_last ? blocked.back() - blocked_at(a.angle) + blocked_at(b.angle)
                                            : blocked_at(b.angle) - blocked_at(a.angle);
        if (between != 0) continue;
        const Real turn = b.angle - a.angle + (is_last ? 2.0L * kPi : 0.0L);
        const Event& first = rotation > 0 ? a : b;
        const Event& second = rotation > 0 ? b : a;
        add_link(first.node, second.node, {0, turn * c.radius, circle, first.angle, rotation * turn, {}});
        // Rounding may exchange two tangents that touch the circle at the same point.
        if (turn < 1e-13L) add_link(second.node, first.node, {0, 0.0L, circle, second.angle, 0.0L, {}});
      }
    }
  }

  /// Returns all angles of the circle where the clearance may become less than r, and some more.
  [[nodiscard]] std::vector<Real> cuts_of(const Circle& c) const {
    std::vector<Real> cuts;
    const auto cut_around = [&](Vector direction, Real ratio) {
      const Real middle = angle_of(direction);
      const Real half = std::acos(std::clamp(ratio, -1.0L, 1.0L));
      for (const Real angle : {middle - half, middle, middle + half}) cuts.push_back(normal_angle(angle));
    };
    for (const Wall& wall : scene_.walls) {
      for (const Vector end : {wall.a, wall.b}) {
        const Vector to_end = end - c.centre;
        const Real far = length_of(to_end);
        // The circles of radius r around both ends cross at an angle whose cosine is half the distance by r.
        if (far > 0.0L && far <= 2.0L * r_ * (1.0L + 1e-9L)) cut_around(to_end, far / (2.0L * r_));
      }
      const Vector d = wall.b - wall.a;
      const Vector normal = left_of(d) * (1.0L / length_of(d));
      const Real height = dot(wall.a - c.centre, normal);  // of the wall's line above the centre
      for (const Real offset : {height - r_, height + r_}) {
        if (std::fabs(offset) <= r_ * (1.0L + 1e-9L)) cut_around(normal, offset / r_);
      }
    }
    return cuts;
  }

  [[nodiscard]] std::optional<ShortestPath> dijkstra() const {
    std::vector<Real> distances(nodes_.size(), kInfinity);
    std::vector<std::pair<std::size_t, const Link*>> before(nodes_.size());
    using Entry = std::pair<Real, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    distances[0] = 0.0L;
    queue.emplace(0.0L, 0);
    while (!queue.empty()) {
      const auto [length, node] = queue.top();
      queue.pop();
      if (length > distances[node]) continue;
      if (node == 1) break;
      for (const Link& link : nodes_[node]) {
        if (length + link.length >= distances[link.to]) continue;
        distances[link.to] = length + link.length;
        before[link.to] = {node, &link};
        queue.emplace(distances[link.to], link.to);
      }
    }
    if (distances[1] == kInfinity) return std::nullopt;
    std::vector<const Link*> links;
    for (std::size_t node = 1; node != 0; node = before[node].first) links.push_back(before[node].second);
    std::reverse(links.begin(), links.end());
    return path_of(links, distances[1]);
  }

  [[nodiscard]] ShortestPath path_of(const std::vector<const Link*>& links, Real length) const {
    ShortestPath path;
    path.length = static_cast<double>(length);
    for (std::size_t i = 0; i < links.size(); ++i) {
      const Link& link = *links[i];
      if (link.circle == 0) {
        const Piece piece = Piece::line(scene_.global(link.line.a), scene_.global(link.line.b));
        if (link.length > 0.0L && !(piece.from == piece.to)) path.pieces.push_back(piece);
        continue;
      }
      Real turn = link.turn;
      for (; i + 1 < links.size() && links[i + 1]->circle == link.circle; ++i) turn += links[i + 1]->turn;
      if (turn == 0.0L) continue;
      path.pieces.push_back(Piece::arc(scene_.global(circles_[link.circle].centre), static_cast<double>(r_),
                                       static_cast<double>(link.start), static_cast<double>(link.start + turn)));
    }
    return path;
  }

  Scene scene_;
  Real r_;
  Real least_;  ///< the smallest clearance of a piece
  std::vector<Circle> circles_;
  std::vector<std::vector<Link>> nodes_;  ///< the links from each node; node 0 is the start, node 1 the goal
};

// The check of paths

struct Arc {
  Vector centre;
  Real radius = 0.0L;
  Real start = 0.0L;
  Real end = 0.0L;

  [[nodiscard]] Vector at(Real angle) const { return centre + at_angle(angle) * radius; }
  /// Returns whether the arc contains the point of the circle at the angle.
  [[nodiscard]] bool contains(Real angle) const {
    const Real low = std::min(start, end);
    const Real high = std::max(start, end);
    angle += std::ceil((low - angle) / (2.0L * kPi)) * 2.0L * kPi;
    return angle <= high;
  }
};

/// Returns the distance from an arc to a wall. It is 0 if the circle crosses the wall within the arc. Otherwise the
/// nearest point of the arc is one of its ends, or lies in the direction of an end of the wall, or in the direction
/// perpendicular to the wall.
Real distance(const Arc& arc, const Wall& wall) {
  Real least = std::min(distance(arc.at(arc.start), wall), distance(arc.at(arc.end), wall));
  const auto try_angle = [&](Real angle) {
    if (arc.contains(angle)) least = std::min(least, distance(arc.at(angle), wall));
  };
  try_angle(angle_of(wall.a - arc.centre));
  try_angle(angle_of(wall.b - arc.centre));
  const Vector d = wall.b - wall.a;
  const Vector normal = left_of(d) * (1.0L / length_of(d));
  const Real height = dot(wall.a - arc.centre, normal);
  try_angle(angle_of(normal));
  try_angle(angle_of(normal) + kPi);
  if (std::fabs(height) < arc.radius) {
    const Real half = std::acos(height / arc.radius);
    try_angle(angle_of(normal) + half);
    try_angle(angle_of(normal) - half);
  }
  return least;
}

std::string text(Vector p) {
  std::ostringstream out;
  out.precision(17);
  out << '(' << p.x << ", " << p.y << ')';
  return out.str();
}

}  // namespace

Piece Piece::line(Point from, Point to) {
  Piece piece;
  piece.from = from;
  piece.to = to;
  return piece;
}

Piece Piece::arc(Point centre, double radius, double start_angle, double end_angle) {
  Piece piece;
  piece.is_arc = true;
  piece.centre = centre;
  piece.radius = radius;
  piece.start_angle = start_angle;
  piece.end_angle = end_angle;
  return piece;
}

std::optional<ShortestPath> shortest_path(const Walls& walls, Point start, Point goal, double r) {
  return TangentGraph(walls, start, goal, r).search();
}

std::optional<double> shortest(const Walls& walls, Point start, Point goal, double r) {
  const std::optional<ShortestPath> path = shortest_path(walls, start, goal, r);
  return path ? std::optional(path->length) : std::nullopt;
}

PathReport check_path(const Walls& walls, Point start, Point goal, double r, const std::vector<Piece>& pieces) {
  const Scene scene(walls, start);
  Real largest = std::max({std::fabs(start.x), std::fabs(start.y), std::fabs(goal.x), std::fabs(goal.y)});
  for (const auto& [a, b] : walls.segments) {
    for (const double value : {a.x, a.y, b.x, b.y}) largest = std::max<Real>(largest, std::fabs(value));
  }
  const Real rounding = std::ldexp(largest, -50);
  const Vector end = scene.local(goal);
  const Real near = std::max(scene.extent, length_of(end)) * 1e-9L + rounding;
  const Real least = r * (1.0L - 1e-9L) - rounding;
  PathReport report;
  const auto add_fault = [&](std::size_t piece, const std::string& fault) {
    if (report.fault.empty()) report.fault = "piece " + std::to_string(piece) + ": " + fault;
  };
  Vector at{};
  Real length = 0.0L;
  Real clearance = scene.clearance(at);
  if (clearance < least) add_fault(0, "the start is not free");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    const Wall line{scene.local(piece.from), scene.local(piece.to)};
    const Arc arc{scene.local(piece.centre), piece.radius, piece.start_angle, piece.end_angle};
    const Vector begin = piece.is_arc ? arc.at(arc.start) : line.a;
    const Real own = piece.is_arc ? scene.clearance(arc) : scene.clearance(line);
    if (!(length_of(begin - at) <= near))
      add_fault(i, "begins at " + text(begin) + " from the start, not at " + text(at));
    if (!(own >= least)) add_fault(i, "has the clearance " + std::to_string(static_cast<double>(own / r)) + " r");
    clearance = std::min(clearance, own);
    length += piece.is_arc ? std::fabs(arc.end - arc.start) * arc.radius : length_of(line.b - line.a);
    at = piece.is_arc ? arc.at(arc.end) : line.b;
  }
  if (!(length_of(end - at) <= near))
    add_fault(pieces.size(), "the path ends at " + text(at) + " from the start, not at the goal");
  report.length = static_cast<double>(length);
  report.clearance = static_cast<double>(clearance);
  return report;
}

}  // namespace waywright::test::disc
