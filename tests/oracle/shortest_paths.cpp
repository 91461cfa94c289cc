#include "oracle/shortest_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "oracle/oracle_impl.hpp"

namespace waywright::oracle {
namespace {

/// A piece of a wall, seen from one of its ends.
struct Spoke {
  std::uint32_t far = 0;  ///< the vertex at its other end
  bool left_free = false;
  bool right_free = false;
};

/// The walls at a vertex, counter-clockwise. Wedge i lies between spoke i and the next spoke.
struct Hub {
  std::vector<Spoke> spokes;
  bool is_end = false;  ///< whether a path may start or end here
};

struct Node {
  std::uint32_t vertex = 0;
  std::uint32_t wedge = 0;
};

/// Returns 0 for rays towards larger y, and for rays along the horizontal line towards larger x; 1 for the others.
int half_of(const ExactPosition& at, const ExactPosition& p) {
  const int above = compare_y(p, at);
  return above > 0 || (above == 0 && compare_x(p, at) > 0) ? 0 : 1;
}

}  // namespace

struct ShortestPaths::Impl {
  Impl(OracleScene given, const std::vector<OraclePoint>& ends)
      : oracle(with_points(std::move(given), ends)), vertices(oracle.arrangement.vertices) {
    hubs.resize(vertices.size());
    for (const OraclePoint& p : ends) hubs[vertex_of(p)].is_end = true;
    collect_spokes();
    collect_nodes();
  }

  /// Returns the scene with the ends as points. They are not walls, but make vertices where there are none.
  static OracleScene with_points(OracleScene scene, const std::vector<OraclePoint>& ends) {
    for (const OraclePoint& p : ends) scene.items.push_back({0, OracleKind::point, {{p}}});
    return scene;
  }

  [[nodiscard]] std::uint32_t vertex_of(OraclePoint p) const {
    const ExactPosition position = oracle.arrangement.grid.point(p);
    const auto found =
        std::lower_bound(vertices.begin(), vertices.end(), position,
                         [](const ExactPosition& a, const ExactPosition& b) { return compare_xy(a, b) < 0; });
    return static_cast<std::uint32_t>(found - vertices.begin());
  }

  [[nodiscard]] bool is_blocked(std::uint32_t vertex) const {
    return std::any_of(oracle.solids.begin(), oracle.solids.end(), [&](const Solid& solid) {
      const RingRelation relation = relation_to_rings(solid, vertices[vertex]);
      return !relation.on_boundary && relation.inside_after;
    });
  }

  /// Returns whether a path can run along a piece of a wall on its left, and whether it can on its right.
  [[nodiscard]] std::pair<bool, bool> is_free_left_and_right(std::uint32_t from, std::uint32_t to) const {
    const bool vertical = compare_x(vertices[from], vertices[to]) == 0;
    const ExactPosition middle = Grid::midpoint(vertices[from], vertices[to]);
    const RingRelation within = relation_to_rings(oracle.domain, middle, vertical);
    bool after = within.inside_after;
    bool before = within.inside_before;
    for (const Solid& solid : oracle.solids) {
      const RingRelation relation = relation_to_rings(solid, middle, vertical);
      after = after && !relation.inside_after;
      before = before && !relation.inside_before;
    }
    // Seen from the smaller end to the larger, "after" is to the left of a piece, but to the right of a vertical one.
    return vertical ? std::pair{before, after} : std::pair{after, before};
  }

  void collect_spokes() {
    for (const OracleConstraint& piece : oracle.arrangement.constraints) {
      const auto [left, right] = is_free_left_and_right(piece.from, piece.to);
      hubs[piece.from].spokes.push_back({piece.to, left, right});
      hubs[piece.to].spokes.push_back({piece.from, right, left});
    }
    for (std::size_t v = 0; v < hubs.size(); ++v) {
      const ExactPosition& at = vertices[v];
      std::sort(hubs[v].spokes.begin(), hubs[v].spokes.end(), [&](const Spoke& a, const Spoke& b) {
        const int a_half = half_of(at, vertices[a.far]);
        const int b_half = half_of(at, vertices[b.far]);
        return a_half != b_half ? a_half < b_half : orientation(at, vertices[a.far], vertices[b.far]) > 0;
      });
    }
  }

  /// Makes a node for every free wedge where a shortest path may start, end, turn or continue straight. If the vertex
  /// is not an end, the wedge must be at least half a turn wide.
  void collect_nodes() {
    for (std::uint32_t v = 0; v < hubs.size(); ++v) {
      const auto& [spokes, is_end] = hubs[v];
      if (spokes.empty() && is_end && !is_blocked(v)) nodes.push_back({v, 0});
      for (std::uint32_t i = 0; i < spokes.size(); ++i) {
        if (!spokes[i].left_free) continue;
        const std::uint32_t next = spokes[(i + 1) % spokes.size()].far;
        const bool wide = spokes.size() == 1 || orientation(vertices[v], vertices[spokes[i].far], vertices[next]) <= 0;
        if (wide || is_end) nodes.push_back({v, i});
      }
    }
    known.assign(nodes.size() * nodes.size(), std::nullopt);
  }

  /// Returns the position, among the spokes of `vertex`, of the piece of wall that leads to `far`, if there is one.
  [[nodiscard]] std::optional<std::uint32_t> spoke_to(std::uint32_t vertex, std::uint32_t far) const {
    const auto& spokes = hubs[vertex].spokes;
    const auto found = std::find_if(spokes.begin(), spokes.end(), [&](const Spoke& s) { return s.far == far; });
    if (found == spokes.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - spokes.begin());
  }

  /// Returns whether a path along a piece of a wall, on its left or on its right, leads from a node's wedge into
  /// another node's wedge.
  [[nodiscard]] bool are_connected_along_wall(const Node& u, std::uint32_t spoke_u, const Node& v,
                                              std::uint32_t spoke_v) const {
    const auto before = [&](const Node& node, std::uint32_t spoke) {
      const auto count = static_cast<std::uint32_t>(hubs[node.vertex].spokes.size());
      return (spoke + count - 1) % count;
    };
    return (u.wedge == spoke_u && v.wedge == before(v, spoke_v)) ||
           (u.wedge == before(u, spoke_u) && v.wedge == spoke_v);
  }

  [[nodiscard]] const ExactPosition& wedge_end(const Node& node, std::uint32_t which) const {
    const auto& spokes = hubs[node.vertex].spokes;
    return vertices[spokes[(node.wedge + which) % spokes.size()].far];
  }

  /// Returns whether a straight line towards a vertex lies in the node's wedge and may belong to a shortest path that
  /// passes through the node. It cannot if the two walls of the wedge lie left and right of the line: then the path
  /// could be pulled tighter at the node. An end of a path always may. Requires: no wall leads to the vertex.
  [[nodiscard]] bool may_leave(const Node& node, std::uint32_t towards) const {
    const auto& [spokes, is_end] = hubs[node.vertex];
    if (spokes.size() < 2) return true;
    const ExactPosition& at = vertices[node.vertex];
    const ExactPosition& first = wedge_end(node, 0);
    const ExactPosition& last = wedge_end(node, 1);
    if (!in_angle(at, first, vertices[towards], last)) return false;
    return is_end || orientation(at, vertices[towards], first) * orientation(at, vertices[towards], last) >= 0;
  }

  /// Returns whether no wall crosses or touches the open segment between two vertices.
  [[nodiscard]] bool is_clear(std::uint32_t u, std::uint32_t v) const {
    const ExactPosition& p = vertices[u];
    const ExactPosition& q = vertices[v];
    for (const Wall& wall : oracle.arrangement.walls) {
      if (cross_properly(wall.exact_a, wall.exact_b, p, q)) return false;
    }
    for (std::uint32_t w = std::min(u, v) + 1; w < std::max(u, v); ++w) {
      if (!hubs[w].spokes.empty() && on_segment(p, q, vertices[w])) return false;
    }
    return true;
  }

  [[nodiscard]] bool are_connected(const Node& u, const Node& v) const {
    if (u.vertex == v.vertex) return false;
    if (const auto spoke_u = spoke_to(u.vertex, v.vertex)) {
      return are_connected_along_wall(u, *spoke_u, v, *spoke_to(v.vertex, u.vertex));
    }
    return may_leave(u, v.vertex) && may_leave(v, u.vertex) && is_clear(u.vertex, v.vertex);
  }

  [[nodiscard]] bool sees(std::size_t u, std::size_t v) {
    std::optional<bool>& answer = known[std::min(u, v) * nodes.size() + std::max(u, v)];
    if (!answer) answer = are_connected(nodes[u], nodes[v]);
    return *answer;
  }

  [[nodiscard]] long double distance(std::size_t u, std::size_t v) const {
    const OraclePoint& p = oracle.arrangement.near_vertices[nodes[u].vertex];
    const OraclePoint& q = oracle.arrangement.near_vertices[nodes[v].vertex];
    return std::hypot(static_cast<long double>(p.x) - static_cast<long double>(q.x),
                      static_cast<long double>(p.y) - static_cast<long double>(q.y));
  }

  [[nodiscard]] ShortestPath search(std::uint32_t start, std::uint32_t goal) {
    constexpr long double kFar = std::numeric_limits<long double>::infinity();
    std::vector<long double> reached(nodes.size(), kFar);
    std::vector<bool> done(nodes.size(), false);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].vertex == start) reached[i] = 0.0L;
    }
    for (;;) {
      std::size_t nearest = nodes.size();
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!done[i] && reached[i] < (nearest < nodes.size() ? reached[nearest] : kFar)) nearest = i;
      }
      if (nearest == nodes.size()) return {OracleStatus::no_path, 0.0};
      if (nodes[nearest].vertex == goal) return {OracleStatus::found, static_cast<double>(reached[nearest])};
      done[nearest] = true;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (done[i]) continue;
        const long double length = reached[nearest] + distance(nearest, i);
        if (length < reached[i] && sees(nearest, i)) reached[i] = length;
      }
    }
  }

  OracleParts oracle;
  const std::vector<ExactPosition>& vertices;
  std::vector<Hub> hubs;  ///< by vertex
  std::vector<Node> nodes;
  std::vector<std::optional<bool>> known;  ///< for two nodes, the smaller first: whether one sees the other
};

ShortestPaths::ShortestPaths(OracleScene scene, const std::vector<OraclePoint>& ends)
    : impl_(std::make_unique<Impl>(std::move(scene), ends)) {}
ShortestPaths::~ShortestPaths() = default;
ShortestPaths::ShortestPaths(ShortestPaths&&) noexcept = default;
ShortestPaths& ShortestPaths::operator=(ShortestPaths&&) noexcept = default;

ShortestPath ShortestPaths::between(OraclePoint start, OraclePoint goal) {
  const std::uint32_t from = impl_->vertex_of(start);
  const std::uint32_t to = impl_->vertex_of(goal);
  if (impl_->is_blocked(from)) return {OracleStatus::start_blocked, 0.0};
  if (impl_->is_blocked(to)) return {OracleStatus::goal_blocked, 0.0};
  if (from == to) return {OracleStatus::found, 0.0};
  return impl_->search(from, to);
}

}  // namespace waywright::oracle
