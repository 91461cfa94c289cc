#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oracle/oracle_impl.hpp"

namespace waywright::oracle {
namespace {

using Fault = std::optional<std::string>;

/// Whether an agent on a line may be on the left of a wall that lies on the line, and whether it may be on the right of
/// it, seen in the direction of the line. Away from walls, the two are equivalent.
struct LeftRight {
  bool left = true;
  bool right = true;

  [[nodiscard]] bool none() const { return !left && !right; }
};

/// An agent at a point: the point from which it came in a straight line (null at the start), and whether it may be left
/// or right of a wall on that line.
struct State {
  const ExactPosition* from = nullptr;
  const ExactPosition* at = nullptr;
  LeftRight may_be;
};

std::string name_of(const OraclePoint& p) {
  std::array<char, 64> buffer{};
  char* end = std::to_chars(buffer.data(), buffer.data() + 30, p.x).ptr;
  *end++ = ' ';
  end = std::to_chars(end, end + 30, p.y).ptr;
  return "(" + std::string(buffer.data(), end) + ")";
}

class PathCheck {
 public:
  PathCheck(const Arrangement& arrangement, const std::vector<Solid>& solids, const Solid& domain)
      : arrangement_(arrangement), solids_(solids), domain_(domain) {}

  /// Returns the state at the end of a straight piece. If the agent cannot walk the piece, the state is neither left
  /// nor right, and `fault` says why.
  State advance(State state, const ExactPosition& to, std::string& fault) const {
    if (compare_xy(*state.at, to) == 0) return state;
    for (const Wall& wall : arrangement_.walls) {
      if (cross_properly(wall.exact_a, wall.exact_b, *state.at, to)) {
        fault = "passes through a wall of item " + std::to_string(wall.ids.front());
        return {state.from, state.at, {false, false}};
      }
    }
    for (const ExactPosition* next : stops_on(*state.at, to)) {
      const auto walls = walls_at(*state.at);
      if (state.from != nullptr) state.may_be = turn(state, *next, walls);
      if (state.may_be.none()) {
        fault = "passes a point where walls meet, " + name_of(arrangement_.grid.nearest(*state.at));
        return state;
      }
      state.may_be = along(state, *next, walls);
      if (state.may_be.none()) {
        fault = "runs through the inside of a polygon after " + name_of(arrangement_.grid.nearest(*state.at));
        return state;
      }
      state = {state.at, next, state.may_be};
    }
    return state;
  }

 private:
  /// Returns the vertices strictly inside a piece, in its order, and then its end.
  [[nodiscard]] std::vector<const ExactPosition*> stops_on(const ExactPosition& from, const ExactPosition& to) const {
    std::vector<const ExactPosition*> stops;
    const auto [first, last] =
        arrangement_.vertices_between(std::min(from.near_x.lo, to.near_x.lo), std::max(from.near_x.hi, to.near_x.hi));
    for (std::size_t i = first; i < last; ++i) {
      const ExactPosition& v = arrangement_.vertices[i];
      if (on_segment(from, to, v) && compare_xy(v, from) != 0 && compare_xy(v, to) != 0) stops.push_back(&v);
    }
    if (compare_xy(from, to) > 0) std::reverse(stops.begin(), stops.end());
    stops.push_back(&to);
    return stops;
  }

  [[nodiscard]] std::vector<const Wall*> walls_at(const ExactPosition& position) const {
    std::vector<const Wall*> walls;
    for (const Wall& wall : arrangement_.walls) {
      if (on_segment(wall.exact_a, wall.exact_b, position)) walls.push_back(&wall);
    }
    return walls;
  }

  /// Returns what remains possible when the agent turns at a point towards another point. Seen from the point, the area
  /// to the left of the agent is the angle counter-clockwise from the outgoing to the incoming direction. No wall may
  /// lie in that angle.
  static LeftRight turn(const State& state, const ExactPosition& next, const std::vector<const Wall*>& walls) {
    const ExactPosition& at = *state.at;
    const ExactPosition& in = *state.from;
    const bool back = orientation(at, in, next) == 0 && same_direction(at, in, next);
    bool left_open = true;
    bool right_open = true;
    for (const Wall* wall : walls) {
      for (const ExactPosition* end : {&wall->exact_a, &wall->exact_b}) {
        if (compare_xy(*end, at) == 0) continue;
        if (back) {
          const bool elsewhere = orientation(at, in, *end) != 0 || !same_direction(at, in, *end);
          left_open = right_open = left_open && !elsewhere;
        } else {
          left_open = left_open && !in_angle(at, next, *end, in);
          right_open = right_open && !in_angle(at, in, *end, next);
        }
      }
    }
    const LeftRight before = state.may_be;
    const LeftRight kept{before.left && left_open, before.right && right_open};
    // If the agent turns back, left and right are exchanged. If it goes around the end of a wall, it is then right of
    // the wall instead of left, or the reverse.
    return back ? LeftRight{before.right || kept.left, before.left || kept.right} : kept;
  }

  /// Returns where the agent can be between two stops of a piece.
  [[nodiscard]] LeftRight along(const State& state, const ExactPosition& next,
                                const std::vector<const Wall*>& walls) const {
    const bool walled = std::any_of(walls.begin(), walls.end(),
                                    [&](const Wall* wall) { return on_segment(wall->exact_a, wall->exact_b, next); });
    const bool vertical = compare_x(*state.at, next) == 0;
    const ExactPosition middle = Grid::midpoint(*state.at, next);
    // "After" is above or, if the piece is vertical, to the right.
    bool free_after = relation_to_rings(domain_, middle, vertical).inside_after;
    bool free_before = relation_to_rings(domain_, middle, vertical).inside_before;
    for (const Solid& solid : solids_) {
      const RingRelation relation = relation_to_rings(solid, middle, vertical);
      free_after = free_after && !relation.inside_after;
      free_before = free_before && !relation.inside_before;
    }
    const bool after_is_left = vertical ? compare_y(*state.at, next) > 0 : compare_x(*state.at, next) < 0;
    const LeftRight free{after_is_left ? free_after : free_before, after_is_left ? free_before : free_after};
    if (walled) return {state.may_be.left && free.left, state.may_be.right && free.right};
    return {free.left, free.right};
  }

  const Arrangement& arrangement_;
  const std::vector<Solid>& solids_;
  const Solid& domain_;
};

/// Returns the exact points that a point of a path may stand for: the point itself, or crossings that are not pairs of
/// doubles and round to it.
std::vector<const ExactPosition*> possible_positions(const Arrangement& arrangement, const OraclePoint& p,
                                                     const ExactPosition& exact, bool is_end) {
  std::vector<const ExactPosition*> result{&exact};
  if (is_end) return result;
  const auto [first, last] = arrangement.vertices_between(p.x, p.x);
  for (std::size_t i = first; i < last; ++i) {
    const ExactPosition& v = arrangement.vertices[i];
    if (arrangement.near_vertices[i] == p && !v.is_double()) result.push_back(&v);
  }
  return result;
}

}  // namespace

Fault Oracle::check_path(const std::vector<OraclePoint>& points) const {
  if (points.empty()) return "the path has no points";
  const OracleBox& box = impl_->scene.domain;
  std::vector<ExactPosition> exact;
  for (const OraclePoint& p : points) {
    if (!(p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y)) {
      return "the path leaves the domain at " + name_of(p);
    }
    exact.push_back(impl_->arrangement.grid.point(p));
  }
  if (strictly_inside(points.front())) return "the path starts inside a polygon";
  const PathCheck check(impl_->arrangement, impl_->solids, impl_->domain);
  std::vector<State> states{{nullptr, &exact.front(), {}}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    std::vector<State> next_states;
    std::string fault;
    for (const ExactPosition* position :
         possible_positions(impl_->arrangement, points[i], exact[i], i + 1 == points.size())) {
      for (const State& state : states) {
        std::string reason;
        const State next = check.advance(state, *position, reason);
        if (!next.may_be.none()) next_states.push_back(next);
        // The last meaning is the likeliest, so its reason is the best one.
        if (next.may_be.none()) fault = reason;
      }
    }
    if (next_states.empty()) return "piece " + std::to_string(i) + " of the path " + fault;
    states = std::move(next_states);
  }
  return std::nullopt;
}

}  // namespace waywright::oracle
