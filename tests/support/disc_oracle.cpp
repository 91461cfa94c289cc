#include "support/disc_oracle.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "support/disc_oracle_grid.hpp"

namespace waywright::test::disc {
namespace {

struct GridWall {
  std::size_t index = 0;  ///< in the list of the caller
  GridPoint a;
  GridPoint b;
};

/// Returns whether the closed segment meets the open disc with the diameter from p to q. Requires: w = 1 for all points
/// but q.
bool meets_disc(const GridWall& wall, const GridPoint& p, const GridPoint& q) {
  // x lies in the disc if (x - p) . (x - q) < 0. Along the wall this is a quadratic function. All values are multiplied
  // by q.w.
  const auto from_q = [&](const GridPoint& x) { return GridPoint{x.x * q.w - q.x, x.y * q.w - q.y, 1}; };
  const GridPoint u = difference(wall.a, p);
  const GridPoint v = from_q(wall.a);
  const Integer at_a = product(u, v);
  if (sign(at_a) < 0) return true;
  if (sign(product(difference(wall.b, p), from_q(wall.b))) < 0) return true;
  const GridPoint e = difference(wall.b, wall.a);
  const Integer slope = product(e, u) * q.w + product(e, v);
  if (sign(slope) >= 0) return false;
  const Integer square = product(e, e) * q.w;
  if (-slope >= 2 * square) return false;
  return slope * slope > 4 * square * at_a;
}

struct GridBridge {
  GridPoint from;
  GridPoint to;
  Bridge bridge;
};

/// Finds all bridges by their definition.
class BridgeFinder {
 public:
  BridgeFinder(const Walls& walls, const Grid& grid) : grid_(grid) {
    for (std::size_t i = 0; i < walls.segments.size(); ++i) {
      const auto& [a, b] = walls.segments[i];
      if (a == b) continue;
      walls_.push_back({i, grid.point(a), grid.point(b)});
      add_end(walls_.back().a, 2 * i);
      add_end(walls_.back().b, 2 * i + 1);
    }
  }

  [[nodiscard]] const std::vector<GridWall>& walls() const { return walls_; }

  std::vector<GridBridge> find() {
    std::vector<GridBridge> found;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      for (std::size_t j = i + 1; j < ends_.size(); ++j) {
        if (is_empty(ends_[i].at, ends_[j].at)) {
          found.push_back(make(ends_[i], ends_[j].at));
          found.back().bridge.to_end = ends_[j].index;
        }
      }
      const std::size_t first = found.size();
      for (const GridWall& wall : walls_) add_foot(ends_[i], wall, first, found);
    }
    return found;
  }

 private:
  struct End {
    GridPoint at;
    std::size_t index = 0;
  };

  void add_end(const GridPoint& at, std::size_t index) {
    if (!is_end(at)) ends_.push_back({at, index});
  }
  [[nodiscard]] bool is_end(const GridPoint& at) const {
    return std::any_of(ends_.begin(), ends_.end(), [&](const End& end) { return compare(end.at, at) == 0; });
  }

  void add_foot(const End& end, const GridWall& wall, std::size_t first, std::vector<GridBridge>& found) {
    const GridPoint d = difference(wall.b, wall.a);
    const GridPoint to_end = difference(end.at, wall.a);
    const Integer t = product(to_end, d);
    const Integer square = product(d, d);
    if (sign(t) <= 0 || t >= square || sign(d.x * to_end.y - d.y * to_end.x) == 0) return;
    const GridPoint foot{wall.a.x * square + t * d.x, wall.a.y * square + t * d.y, square};
    if (!is_empty(end.at, foot) || is_end(foot)) return;
    for (std::size_t i = first; i < found.size(); ++i) {
      if (found[i].bridge.is_foot && compare(found[i].to, foot) == 0) return;
    }
    found.push_back(make(end, foot));
    found.back().bridge.is_foot = true;
    found.back().bridge.to_end = wall.index;
  }

  bool is_empty(const GridPoint& p, const GridPoint& q) {
    // Begins with the wall that was in the last disc: it is often in this one.
    for (std::size_t k = 0; k < walls_.size(); ++k) {
      const std::size_t i = (last_ + k) % walls_.size();
      if (!meets_disc(walls_[i], p, q)) continue;
      last_ = i;
      return false;
    }
    return true;
  }

  [[nodiscard]] GridBridge make(const End& end, const GridPoint& to) const {
    const Integer dx = to.x - end.at.x * to.w;
    const Integer dy = to.y - end.at.y * to.w;
    GridBridge result{end.at, to, {}};
    result.bridge.from = grid_.rational(end.at);
    result.bridge.to = grid_.rational(to);
    result.bridge.squared_length = Grid::quotient(dx * dx + dy * dy, to.w * to.w) * grid_.power(2);
    result.bridge.from_end = end.index;
    return result;
  }

  const Grid& grid_;
  std::vector<GridWall> walls_;
  std::vector<End> ends_;
  std::size_t last_ = 0;
};

/// Sets that can be united.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t j) { parent_[find(i)] = find(j); }

 private:
  std::vector<std::size_t> parent_;
};

/// The value for "no bridge": a wall.
constexpr std::size_t kWall = static_cast<std::size_t>(-1);

/// The arrangement of segments: its vertices, half-edges, cycles of half-edges, and cells. Half-edge 2 k runs from the
/// smaller end of edge k in (x, y) order to the larger one, half-edge 2 k + 1 back.
class Arrangement {
 public:
  /// Adds a wall (bridge = kWall) or a bridge. Requires: the length is positive.
  void add(const GridPoint& p, const GridPoint& q, std::size_t bridge) {
    Segment s{compare(p, q) < 0 ? p : q, compare(p, q) < 0 ? q : p, {}, {}, {}, bridge, {}, {}};
    s.line = Line::through(s.a, s.b);
    s.dx = s.b.x * s.a.w - s.a.x * s.b.w;
    s.dy = s.b.y * s.a.w - s.a.y * s.b.w;
    s.box = {approximate(s.a.x, s.a.w), approximate(s.a.y, s.a.w), approximate(s.b.x, s.b.w),
             approximate(s.b.y, s.b.w)};
    for (const double value : s.box) margin_ = std::max(margin_, std::fabs(value) * 1e-9);
    if (s.box[1] > s.box[3]) std::swap(s.box[1], s.box[3]);
    segments_.push_back(std::move(s));
  }

  void finish() {
    split_all();
    number_vertices();
    make_edges();
    sort_rotations();
    trace_cycles();
    nest();
  }

  struct Edge {
    std::size_t low = 0;
    std::size_t high = 0;
    std::size_t segment = 0;
  };

  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  [[nodiscard]] std::size_t bridge_of(const Edge& edge) const { return segments_[edge.segment].bridge; }
  /// Returns the cells left of the half-edges 2 k and 2 k + 1.
  [[nodiscard]] std::pair<std::size_t, std::size_t> cells_at(std::size_t edge) {
    return {cells_.find(cycles_[2 * edge]), cells_.find(cycles_[2 * edge + 1])};
  }
  /// Returns the edges that contain the position.
  [[nodiscard]] std::vector<std::size_t> edges_at(const GridPoint& p) const {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      if (line(k).orientation(p) == 0 && compare(vertices_[edges_[k].low], p) <= 0 &&
          compare(vertices_[edges_[k].high], p) >= 0) {
        result.push_back(k);
      }
    }
    return result;
  }
  /// Returns the cell that contains the position. Requires: no edge contains the position.
  [[nodiscard]] std::size_t cell_of(const GridPoint& p) { return cells_.find(cycle_below(p, kWall)); }
  [[nodiscard]] Sets cells() const { return cells_; }

 private:
  struct Segment {
    GridPoint a;  ///< before b in (x, y) order
    GridPoint b;
    Line line;
    Integer dx;  ///< (dx, dy) is a positive multiple of b - a
    Integer dy;
    std::size_t bridge = kWall;
    std::vector<std::size_t> points;  ///< on it: first indices in points_, then vertices
    std::array<double, 4> box{};      ///< approximate: smallest x and y, largest x and y
  };

  [[nodiscard]] const Line& line(std::size_t edge) const { return segments_[edges_[edge].segment].line; }

  /// Returns true only if two segments have no point in common. The margin is a million times the error of the boxes.
  [[nodiscard]] bool surely_apart(const Segment& s, const Segment& t) const {
    return s.box[0] > t.box[2] + margin_ || t.box[0] > s.box[2] + margin_ || s.box[1] > t.box[3] + margin_ ||
           t.box[1] > s.box[3] + margin_;
  }

  void split_all() {
    for (Segment& s : segments_) {
      for (const GridPoint& p : {s.a, s.b}) {
        s.points.push_back(points_.size());
        points_.push_back(p);
      }
    }
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      for (std::size_t j = i + 1; j < segments_.size(); ++j) {
        if (!surely_apart(segments_[i], segments_[j])) split(segments_[i], segments_[j]);
      }
    }
  }

  void split(Segment& s, Segment& t) {
    const int a = s.line.orientation(t.a);
    const int b = s.line.orientation(t.b);
    if (a * b > 0) return;
    const int c = t.line.orientation(s.a);
    const int d = t.line.orientation(s.b);
    if (c * d > 0) return;
    if (a == 0 && b == 0) {
      split_collinear(s, t);
      split_collinear(t, s);
      return;
    }
    if (a == 0) s.points.push_back(t.points[0]);
    if (b == 0) s.points.push_back(t.points[1]);
    if (c == 0) t.points.push_back(s.points[0]);
    if (d == 0) t.points.push_back(s.points[1]);
    if (a == 0 || b == 0 || c == 0 || d == 0) return;
    s.points.push_back(points_.size());
    t.points.push_back(points_.size());
    points_.push_back(crossing(s.line, t.line));
  }

  /// Adds to s those ends of t that lie on s. Requires: both lie on one line.
  static void split_collinear(Segment& s, const Segment& t) {
    if (compare(s.a, t.a) < 0 && compare(t.a, s.b) < 0) s.points.push_back(t.points[0]);
    if (compare(s.a, t.b) < 0 && compare(t.b, s.b) < 0) s.points.push_back(t.points[1]);
  }

  /// Numbers the vertices in (x, y) order: this is also their order along each segment.
  void number_vertices() {
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return compare(points_[i], points_[j]) < 0; });
    std::vector<std::size_t> vertex_of(points_.size());
    for (const std::size_t i : order) {
      if (vertices_.empty() || compare(vertices_.back(), points_[i]) != 0) vertices_.push_back(points_[i]);
      vertex_of[i] = vertices_.size() - 1;
    }
    for (Segment& s : segments_) {
      for (std::size_t& point : s.points) point = vertex_of[point];
      std::sort(s.points.begin(), s.points.end());
      s.points.erase(std::unique(s.points.begin(), s.points.end()), s.points.end());
    }
  }

  void make_edges() {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> segment_of;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const auto& points = segments_[i].points;
      for (std::size_t k = 1; k < points.size(); ++k) {
        const auto [where, is_new] = segment_of.try_emplace({points[k - 1], points[k]}, i);
        // The walls come first. No bridge overlaps a wall or another bridge: the disc of one would contain the other.
        if (!is_new && segments_[i].bridge != kWall) throw std::logic_error("a bridge overlaps a wall or a bridge");
      }
    }
    for (const auto& [ends, segment] : segment_of) edges_.push_back({ends.first, ends.second, segment});
  }

  [[nodiscard]] std::size_t origin(std::size_t half_edge) const {
    return half_edge % 2 == 0 ? edges_[half_edge / 2].low : edges_[half_edge / 2].high;
  }

  /// Returns whether half-edge g comes before h, counter-clockwise from the direction of x.
  [[nodiscard]] bool turns_before(std::size_t g, std::size_t h) const {
    // A half-edge with an even number has a direction from -90 (excluded) to 90 degrees (included).
    const auto half = [&](std::size_t i) {
      const int up = sign(segments_[edges_[i / 2].segment].dy);
      return i % 2 == 0 ? (up >= 0 ? 0 : 3) : (up > 0 ? 2 : up == 0 ? 2 : 1);
    };
    const int of_g = half(g);
    const int of_h = half(h);
    if (of_g != of_h) return of_g < of_h;
    const Segment& s = segments_[edges_[g / 2].segment];
    const Segment& t = segments_[edges_[h / 2].segment];
    return sign(s.dx * t.dy - s.dy * t.dx) > 0;
  }

  void sort_rotations() {
    rotations_.resize(vertices_.size());
    for (std::size_t h = 0; h < 2 * edges_.size(); ++h) rotations_[origin(h)].push_back(h);
    for (auto& rotation : rotations_) {
      std::sort(rotation.begin(), rotation.end(), [&](std::size_t g, std::size_t h) { return turns_before(g, h); });
    }
  }

  void trace_cycles() {
    std::vector<std::size_t> next(2 * edges_.size());
    for (const auto& rotation : rotations_) {
      for (std::size_t i = 0; i < rotation.size(); ++i) {
        // Clockwise before the twin of the half-edge that arrives.
        next[rotation[i] ^ 1U] = rotation[(i + rotation.size() - 1) % rotation.size()];
      }
    }
    cycles_.assign(next.size(), 0);  // 0 is the unbounded cell
    std::size_t count = 1;
    for (std::size_t h = 0; h < next.size(); ++h) {
      if (cycles_[h] != 0) continue;
      for (std::size_t i = h; cycles_[i] == 0; i = next[i]) cycles_[i] = count;
      ++count;
    }
    cells_ = Sets(count);
  }

  /// Unites the outer cycle of each component of the graph with the cell around the component.
  void nest() {
    Sets components(vertices_.size());
    for (const Edge& edge : edges_) components.unite(edge.low, edge.high);
    component_of_.resize(vertices_.size());
    std::vector<std::size_t> largest(vertices_.size(), 0);
    for (std::size_t v = 0; v < vertices_.size(); ++v) largest[component_of_[v] = components.find(v)] = v;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      // The last vertex of a component in (x, y) order: no half-edge starts between its last one and the direction up.
      if (largest[component_of_[v]] != v) continue;
      cells_.unite(cycles_[rotations_[v].back()], cycle_below(vertices_[v], component_of_[v]));
    }
  }

  /// Returns the cycle that lies directly below the position, right of it by an infinitely small distance. Ignores the
  /// edges of one component.
  [[nodiscard]] std::size_t cycle_below(const GridPoint& p, std::size_t ignored) const {
    std::size_t best = kWall;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      if (component_of_[edges_[k].low] == ignored) continue;
      if (compare_x(vertices_[edges_[k].low], p) > 0 || compare_x(p, vertices_[edges_[k].high]) >= 0) continue;
      if (line(k).orientation(p) > 0 && (best == kWall || is_higher(line(k), line(best), p))) best = k;
    }
    return best == kWall ? 0 : cycles_[2 * best];
  }

  /// Returns whether l is higher than m at the x of p, or directly right of it. Requires: b > 0.
  static bool is_higher(const Line& l, const Line& m, const GridPoint& p) {
    const Integer y_of_l = -(l.a * p.x + l.c * p.w);
    const Integer y_of_m = -(m.a * p.x + m.c * p.w);
    const int by_y = sign(y_of_l * m.b - y_of_m * l.b);
    return by_y != 0 ? by_y > 0 : m.a * l.b > l.a * m.b;
  }

  std::vector<Segment> segments_;
  double margin_ = 0.0;
  std::vector<GridPoint> points_;
  std::vector<GridPoint> vertices_;
  std::vector<Edge> edges_;
  std::vector<std::vector<std::size_t>> rotations_;  ///< the half-edges from each vertex, counter-clockwise
  std::vector<std::size_t> cycles_;                  ///< of each half-edge
  std::vector<std::size_t> component_of_;            ///< of each vertex
  Sets cells_{0};
};

Rational square(const Rational& value) { return value * value; }

}  // namespace

Rational squared_distance(const Point& position, const Point& from, const Point& to) {
  const Rational ux = Rational(position.x) - Rational(from.x);
  const Rational uy = Rational(position.y) - Rational(from.y);
  const Rational dx = Rational(to.x) - Rational(from.x);
  const Rational dy = Rational(to.y) - Rational(from.y);
  const Rational along = ux * dx + uy * dy;
  const Rational length = dx * dx + dy * dy;
  if (along <= 0) return square(ux) + square(uy);
  if (along >= length) return square(ux - dx) + square(uy - dy);
  return square(dx * uy - dy * ux) / length;
}

Rational largest_at(const Walls& walls, const Point& start, const Point& goal) {
  std::optional<Rational> least;
  for (const auto& [a, b] : walls.segments) {
    for (const Point& p : {start, goal}) {
      const Rational distance = squared_distance(p, a, b);
      if (!least || distance < *least) least = distance;
    }
  }
  return 4 * *least;
}

bool fits(const Walls& walls, Point position, double r) {
  const Rational least = square(Rational(r));
  return std::all_of(walls.segments.begin(), walls.segments.end(), [&](const auto& wall) {
    return wall.first == wall.second || squared_distance(position, wall.first, wall.second) >= least;
  });
}

struct Connectivity::Cache {
  explicit Cache(Walls list) : walls(std::move(list)), grid(walls), finder(walls, grid), found(finder.find()) {
    for (const GridBridge& bridge : found) bridges.push_back(bridge.bridge);
  }

  /// Returns the arrangement of the walls and the bridges for which `is_wanted` holds.
  Arrangement& arrangement(const std::function<bool(const Bridge&)>& is_wanted) {
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (is_wanted(bridges[i])) wanted.push_back(i);
    }
    const auto [where, is_new] = arrangements.try_emplace(wanted);
    if (is_new) {
      for (const GridWall& wall : finder.walls()) where->second.add(wall.a, wall.b, kWall);
      for (const std::size_t i : wanted) where->second.add(found[i].from, found[i].to, i);
      where->second.finish();
    }
    return where->second;
  }

  Walls walls;
  Grid grid;
  BridgeFinder finder;
  std::vector<GridBridge> found;
  std::vector<Bridge> bridges;
  std::map<std::vector<std::size_t>, Arrangement> arrangements;
};

Connectivity::Connectivity(Walls walls) : cache_(std::make_unique<Cache>(std::move(walls))) {}
Connectivity::~Connectivity() = default;
Connectivity::Connectivity(Connectivity&&) noexcept = default;
Connectivity& Connectivity::operator=(Connectivity&&) noexcept = default;

const std::vector<Bridge>& Connectivity::bridges() const { return cache_->bridges; }

bool Connectivity::fits(Point position, double r) const { return disc::fits(cache_->walls, position, r); }

bool Connectivity::connected(Point start, Point goal, double r) const {
  if (!fits(start, r) || !fits(goal, r)) return false;
  const Rational limit = 4 * square(Rational(r));
  Arrangement& arrangement = cache_->arrangement([&](const Bridge& bridge) { return bridge.squared_length < limit; });
  const GridPoint from = cache_->grid.point(start);
  const GridPoint to = cache_->grid.point(goal);
  if (!arrangement.edges_at(from).empty() || !arrangement.edges_at(to).empty()) {
    throw std::logic_error("a position where the disc fits lies on a wall or a blocking bridge");
  }
  return arrangement.cell_of(from) == arrangement.cell_of(to);
}

std::optional<Widest> Connectivity::widest(Point start, Point goal) const {
  Arrangement& arrangement = cache_->arrangement([](const Bridge&) { return true; });
  Sets cells = arrangement.cells();
  // Unites the cells around each end, and keeps one of them.
  std::array<std::size_t, 2> ends{};
  for (const std::size_t i : {0U, 1U}) {
    const GridPoint at = cache_->grid.point(i == 0 ? start : goal);
    const std::vector<std::size_t> edges = arrangement.edges_at(at);
    if (edges.empty()) {
      ends.at(i) = arrangement.cell_of(at);
      continue;
    }
    ends.at(i) = arrangement.cells_at(edges.front()).first;
    for (const std::size_t edge : edges) {
      if (arrangement.bridge_of(arrangement.edges()[edge]) == kWall) return std::nullopt;
      cells.unite(ends.at(i), arrangement.cells_at(edge).first);
      cells.unite(ends.at(i), arrangement.cells_at(edge).second);
    }
  }
  if (cells.find(ends[0]) == cells.find(ends[1])) return Widest{};
  std::vector<std::pair<std::size_t, std::size_t>> crossings;  // bridge and edge
  for (std::size_t k = 0; k < arrangement.edges().size(); ++k) {
    const std::size_t bridge = arrangement.bridge_of(arrangement.edges()[k]);
    if (bridge != kWall) crossings.emplace_back(bridge, k);
  }
  const auto& bridges = cache_->bridges;
  std::sort(crossings.begin(), crossings.end(), [&](const auto& a, const auto& b) {
    return bridges[a.first].squared_length > bridges[b.first].squared_length;
  });
  for (const auto& [bridge, edge] : crossings) {
    const auto [left, right] = arrangement.cells_at(edge);
    cells.unite(left, right);
    if (cells.find(ends[0]) == cells.find(ends[1])) return Widest{true, bridges[bridge].squared_length};
  }
  return std::nullopt;
}

std::vector<Bridge> bridges(const Walls& walls) { return Connectivity(walls).bridges(); }

bool connected(const Walls& walls, Point start, Point goal, double r) {
  return Connectivity(walls).connected(start, goal, r);
}

std::optional<Widest> widest_squared_diameter(const Walls& walls, Point start, Point goal) {
  return Connectivity(walls).widest(start, goal);
}

}  // namespace waywright::test::disc
