#include "path/disc_optimal.hpp"

#include <algorithm>

#include "path/distance.hpp"

namespace waywright::path {

using clearance::CellEdge;
using mesh::Vertex;

namespace {

/// Two directions that differ by less than this count as equal when the search decides which corners and gates are in
/// view. If a view is too wide, this only costs time. If a disc just fits between two vertices, the tangent between
/// their circles has a length of about the square root of the rounding error, so its direction is uncertain by 2^-26.
constexpr double kSameDirection = 0x1p-23;
/// Allows for rounding: a line may be nearer to a wall than the radius, by at most this fraction of the radius.
constexpr double kNearness = 0x1p-34;

double squared_distance(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double length = squared_length(along);
  const double share = length > 0.0 ? std::clamp(dot(p - a, along) / length, 0.0, 1.0) : 0.0;
  return squared_length(p - lerp(a, b, share));
}

Point unit(const Point& v) {
  const double size = length(v);
  return {v.x / size, v.y / size};
}

}  // namespace

void DiscOptimal::begin(const DiscMap& map, const Point& start, const CellEdge& start_cell, const Point& goal,
                        const CellEdge& goal_cell) {
  map_ = &map;
  start_ = start - map.origin;
  goal_ = goal - map.origin;
  goal_cell_ = goal_cell;
  is_found_ = false;
  roots_.clear();
  nodes_.clear();
  open_.clear();
  stamp_.next(1, reached_);
  reached_.grow_to(std::size_t{2} * map.walls.topology().vertex_slots());
  roots_.push_back({{start_, 0}, mesh::kNoVertex, {1.0, 0.0}, 0.0, start_cell, kNone, 0.0, kNone});
  view_.load(map, start_cell);
  look({0, start_cell, true, true, {1.0, 0.0}, {1.0, 0.0}});
}

bool DiscOptimal::step(std::size_t limit, std::size_t& expansions) {
  while (!open_.empty() && expansions < limit) {
    const std::uint32_t i = open_.pop();
    const Node node = nodes_[i];
    ++expansions;
    if (node.kind == Kind::window) {
      view_.load(*map_, node.edge);
      look({node.root, node.cell, false, false, node.right, node.left});
    } else if (node.kind == Kind::contact) {
      expand_contact(node);
    } else if (is_clear(node.cell, touching_point(roots_[node.root].contact, node.right, map_->radius), goal_,
                        roots_[node.root].vertex, mesh::kNoVertex)) {
      is_found_ = true;
      length_ = node.length;
      last_root_ = node.root;
      last_direction_ = node.right;
      return true;
    }
  }
  return open_.empty();
}

void DiscOptimal::push(double bound, const Node& node) {
  nodes_.push_back(node);
  open_.push(bound, static_cast<std::uint32_t>(nodes_.size() - 1));
}

void DiscOptimal::expand_contact(const Node& node) {
  const Contact contact{map_->walls.triangulation().geometry().rounded(number(node.vertex)) - map_->origin, node.side};
  Reached& reached = reached_[2 * number(node.vertex) + (node.side > 0 ? 1 : 0)];
  if (reached.query != stamp_.value()) reached = {stamp_.value(), kNone};
  if (is_dominated(node, reached.root)) return;
  const Root& before = roots_[node.root];
  if (!is_clear(node.cell, touching_point(before.contact, node.right, map_->radius),
                touching_point(contact, node.right, map_->radius), before.vertex, node.vertex)) {
    return;
  }
  roots_.push_back({contact, node.vertex, node.right, node.length, node.edge, node.root, 0.0, reached.root});
  reached.root = static_cast<std::uint32_t>(roots_.size() - 1);
  turn(reached.root, node.edge);
}

/// Returns whether an earlier path to the contact can also turn to the node's direction, and is then not longer.
bool DiscOptimal::is_dominated(const Node& node, std::uint32_t first) const {
  for (std::uint32_t i = first; i != kNone; i = roots_[i].next) {
    const Root& root = roots_[i];
    const double order = turning_order(root.direction, node.right, node.side);
    const bool is_same = order > 4.0 - kSameDirection;
    if (order > root.reach && !is_same) continue;
    const double length = is_same ? root.length : length_to(root, node.right);
    if (length <= node.length) return true;
  }
  return false;
}

/// Looks from a root into the cells around its vertex, one after the other, in the order in which the path turns
/// through them. Stops at a wall, at a gate that is too narrow, or when the path has turned by 180 degrees.
void DiscOptimal::turn(std::uint32_t root, const CellEdge& first) {
  const int side = roots_[root].contact.side;
  const Point arrival = roots_[root].direction;
  Point from = arrival;
  CellEdge edge = first;
  for (bool goes_on = true; goes_on;) {
    view_.load(*map_, edge);
    const std::size_t last = view_.size() - 1;
    const Point spoke = unit((side > 0 ? view_.from(last) : view_.to(0)) - view_.from(0));
    Point to = side > 0 ? left_of(spoke) : Point{spoke.y, -spoke.x};
    double order = turning_order(arrival, to, side);
    if (order > 4.0 - kSameDirection) {
      order = 0.0;
      to = from;
    }
    if (order > 2.0 || order < roots_[root].reach) {
      order = 2.0;
      to = {-arrival.x, -arrival.y};
      goes_on = false;
    }
    roots_[root].reach = order;
    look({root, edge, true, false, side > 0 ? from : to, side > 0 ? to : from});
    const CellView::Edge& border = view_[side > 0 ? last : 0];
    if (!border.is_passable) return;
    const CellEdge beyond = map_->cells.across(border.edge);
    edge = side > 0 ? beyond : map_->cells.next(beyond);
    from = to;
  }
}

void DiscOptimal::look(const View& view) {
  look_for_goal(view);
  look_for_contacts(view);
  look_through_gates(view);
}

bool DiscOptimal::is_in_view(const View& view, const Point& direction) const {
  if (view.is_full) return true;
  const double order = turning_order(view.right, direction, 1);
  // No view is wider than 180 degrees. In a view of one direction, rounding may have exchanged the bounds.
  const double width = turning_order(view.right, view.left, 1);
  return order <= (width > 3.0 ? 0.0 : width) + kSameDirection || order >= 4.0 - kSameDirection;
}

/// Returns whether the position lies beyond a gate, seen from the cell.
bool DiscOptimal::is_behind(std::size_t gate, const Point& position) const {
  return cross(view_.to(gate) - view_.from(gate), position - view_.from(gate)) < 0.0;
}

/// Returns whether the direction points from a corner of the cell into the cell. If the corner is the end of a wall
/// inside the cell, every direction points into the cell.
bool DiscOptimal::is_in_corner(std::size_t corner, const Point& direction) const {
  const std::size_t before = corner == 0 ? view_.size() - 1 : corner - 1;
  const CellEdge& out = view_[corner].edge;
  const CellEdge& in = view_[before].edge;
  if (!out.is_gate() && !in.is_gate() && out.h == map_->walls.topology().twin(in.h)) return true;
  const Point along = view_.to(corner) - view_.from(corner);
  const double order = turning_order(along, direction, 1);
  const double end = turning_order(along, view_.from(before) - view_.from(corner), 1);
  return order <= end + kSameDirection || order >= 4.0 - kSameDirection;
}

/// Returns whether a corner of the cell is too near to a line from a root.
bool DiscOptimal::is_obstructed(const Root& root, const Point& direction, double length, Vertex target) const {
  const double least = map_->radius * (1.0 - kNearness);
  for (std::size_t i = 0; i < view_.size(); ++i) {
    const Vertex v = view_[i].vertex;
    if (v == mesh::kNoVertex || v == target || v == root.vertex) continue;
    const Point to = view_.from(i) - root.contact.centre;
    const double along = dot(direction, to);
    if (along <= 0.0 || along >= length) continue;
    if (std::abs(cross(direction, to) + root.contact.side * map_->radius) < least) return true;
  }
  return false;
}

void DiscOptimal::look_for_goal(const View& view) {
  bool has_goal = false;
  for (std::size_t i = 0; i < view_.size(); ++i) has_goal = has_goal || view_[i].edge == goal_cell_;
  if (!has_goal) return;
  const Root& root = roots_[view.root];
  if (root.contact.side == 0 && root.contact.centre == goal_) {
    return push(0.0, {Kind::goal, 0, view.root, mesh::kNoVertex, {}, view.cell, {1.0, 0.0}, {1.0, 0.0}, 0.0});
  }
  const auto line = tangent(root.contact, {goal_, 0}, map_->radius);
  if (!line || !is_in_view(view, line->direction)) return;
  if (is_obstructed(root, line->direction, line->length, mesh::kNoVertex)) return;
  const double length = length_to(root, line->direction) + line->length;
  push(length, {Kind::goal, 0, view.root, mesh::kNoVertex, {}, view.cell, line->direction, line->direction, length});
}

void DiscOptimal::look_for_contacts(const View& view) {
  const Root root = roots_[view.root];
  for (std::size_t i = 0; i < view_.size(); ++i) {
    const Vertex v = view_[i].vertex;
    if (v == mesh::kNoVertex || v == root.vertex) continue;
    for (const int side : {1, -1}) {
      const Contact contact{view_.from(i), side};
      const auto line = tangent(root.contact, contact, map_->radius);
      if (!line || !is_in_view(view, line->direction)) continue;
      const Point touching = touching_point(contact, line->direction, map_->radius);
      if (!is_in_corner(i, touching - contact.centre)) continue;
      if (is_obstructed(root, line->direction, line->length, v)) continue;
      const double length = length_to(root, line->direction) + line->length;
      push(length + distance(touching, goal_),
           {Kind::contact, side, view.root, v, view_[i].edge, view.cell, line->direction, line->direction, length});
    }
  }
}

// A cell may lie on both sides of a bridge. A straight line does not cross this bridge twice.
void DiscOptimal::look_through_gates(const View& view) {
  const CellEdge& entry = view_[0].edge;
  for (std::size_t gate = view.is_inside ? 0 : 1; gate < view_.size(); ++gate) {
    const bool is_entry = !view.is_inside && view_[gate].edge == map_->cells.across(entry);
    if (view_[gate].is_passable && !is_entry) look_through(view, gate);
  }
}

/// Offers the window of a gate of the cell. The window contains the directions in view in which a line crosses the gate
/// at a position where the disc is free. On its way to the gate, the line leaves the corners before the gate on its
/// right and the corners after the gate on its left.
void DiscOptimal::look_through(const View& view, std::size_t gate) {
  const Root& root = roots_[view.root];
  const Point along = unit(view_.to(gate) - view_.from(gate));
  const Point right_end = view_.from(gate) + Point{along.x * map_->radius, along.y * map_->radius};
  const Point left_end = view_.to(gate) - Point{along.x * map_->radius, along.y * map_->radius};
  const auto to_right = tangent(root.contact, {right_end, 0}, map_->radius);
  const auto to_left = tangent(root.contact, {left_end, 0}, map_->radius);
  if (!to_right || !to_left) return;
  Point right = to_right->direction;
  Point left = to_left->direction;
  if (cross(right, left) < -kSameDirection) return;
  if (view.is_full) return clip_at_start(view, gate, 0, right, left);
  const View of_gate{view.root, view.cell, true, false, right, left};
  if (cross(view.right, right) < 0.0) right = view.right;
  if (cross(left, view.left) < 0.0) left = view.left;
  for (const Point& bound : {right, left}) {
    if (!is_in_view(view, bound) || !is_in_view(of_gate, bound)) return;
  }
  const std::size_t end = view.is_inside ? view_.size() : view_.size() + 1;
  for (std::size_t i = 1; i <= gate; ++i) close_in(view, gate, i, -1, left, right);
  for (std::size_t i = gate + 1; i < end; ++i) close_in(view, gate, i, 1, right, left);
  if (cross(right, left) >= -kSameDirection) offer(view, gate, right, left);
}

/// Moves a bound of a window inwards, so that lines to the gate do not come too near to a corner of this cell. Ignores
/// a corner that would close the whole window: a line may pass this corner before the other bound becomes valid.
void DiscOptimal::close_in(const View& view, std::size_t gate, std::size_t corner, int side, const Point& other,
                           Point& bound) const {
  const std::size_t i = corner == view_.size() ? 0 : corner;
  const Root& root = roots_[view.root];
  const Vertex v = view_[i].vertex;
  if (v == mesh::kNoVertex || v == root.vertex) return;
  const auto line = tangent(root.contact, {view_.from(i), side}, map_->radius);
  if (!line) return;
  if (side * cross(bound, line->direction) >= 0.0 || side * cross(other, line->direction) < 0.0) return;
  const Point touching = touching_point({view_.from(i), side}, line->direction, map_->radius);
  if (is_behind(gate, touching) || (!view.is_inside && is_behind(0, touching))) return;
  bound = line->direction;
}

/// Replaces the last steps of look_through() if the root is the start. From the start, a line may pass each corner on
/// the left or on the right. So each corner from number `corner` on removes from the window the directions in which the
/// corner is too near to the line. This can divide the window into two.
void DiscOptimal::clip_at_start(const View& view, std::size_t gate, std::size_t corner, const Point& right,
                                const Point& left) {
  const Root& root = roots_[view.root];
  for (std::size_t i = corner; i < view_.size(); ++i) {
    if (view_[i].vertex == mesh::kNoVertex) continue;
    const auto on_left = tangent(root.contact, {view_.from(i), 1}, map_->radius);
    const auto on_right = tangent(root.contact, {view_.from(i), -1}, map_->radius);
    if (!on_left || !on_right) continue;
    if (is_behind(gate, touching_point({view_.from(i), 1}, on_left->direction, map_->radius))) continue;
    if (is_behind(gate, touching_point({view_.from(i), -1}, on_right->direction, map_->radius))) continue;
    if (cross(right, on_right->direction) <= 0.0 || cross(on_left->direction, left) <= 0.0) continue;
    if (dot(right, on_right->direction) < 0.0 && dot(left, on_left->direction) < 0.0) continue;
    if (cross(right, on_left->direction) >= 0.0) clip_at_start(view, gate, i + 1, right, on_left->direction);
    if (cross(on_right->direction, left) >= 0.0) clip_at_start(view, gate, i + 1, on_right->direction, left);
    return;
  }
  if (cross(right, left) >= -kSameDirection) offer(view, gate, right, left);
}

/// Returns whether a line in the given direction, from the root of the view, crosses the gate on its way out of the
/// cell. Without this test, a window that is too wide could make the search go around a vertex without end.
bool DiscOptimal::crosses(const View& view, std::size_t gate, const Point& direction) const {
  const double size = waywright::length(direction);
  if (size < kSameDirection) return true;
  const Point unit_direction{direction.x / size, direction.y / size};
  const Point from = touching_point(roots_[view.root].contact, unit_direction, map_->radius);
  const Point along = view_.to(gate) - view_.from(gate);
  const double across = cross(along, unit_direction);
  if (!(across < 0.0)) return false;
  const double at = cross(along, view_.from(gate) - from) / across;
  const Point position = from + Point{unit_direction.x * at, unit_direction.y * at};
  const double share = dot(position - view_.from(gate), along) / squared_length(along);
  return at > -kSameDirection * waywright::length(along) && share > -kSameDirection && share < 1.0 + kSameDirection &&
         (view.is_inside || !is_behind(0, position));
}

void DiscOptimal::offer(const View& view, std::size_t gate, const Point& right, const Point& left) {
  const Root& root = roots_[view.root];
  if (!crosses(view, gate, right + left)) return;
  const Point& nearest = root.contact.side < 0 ? left : right;
  const Point from = touching_point(root.contact, nearest, map_->radius);
  const double bound = length_to(root, nearest) + distance_via_segment(from, view_.from(gate), view_.to(gate), goal_);
  push(bound, {Kind::window, 0, view.root, mesh::kNoVertex, map_->cells.across(view_[gate].edge), view.cell, right,
               left, 0.0});
}

/// Walks from cell to cell along a straight line. Returns whether the disc is free everywhere on it. The line starts in
/// `cell`. Ignores the walls that end at the two vertices.
bool DiscOptimal::is_clear(const CellEdge& cell, const Point& from, const Point& to, Vertex from_vertex,
                           Vertex to_vertex) {
  const double radius = map_->radius * (1.0 - kNearness);
  const Point along = to - from;
  CellEdge edge = cell;
  CellEdge last;  // the gate through which the line came, seen from the cell before
  for (double progress = -kSameDirection;;) {
    walk_.load(*map_, edge);
    double nearest = HUGE_VAL;
    std::size_t exit = walk_.size();
    for (std::size_t i = 0; i < walk_.size(); ++i) {
      const Point& a = walk_.from(i);
      const Point& b = walk_.to(i);
      const Vertex v = walk_[i].vertex;
      if (v != mesh::kNoVertex && v != from_vertex && v != to_vertex &&
          squared_distance(a, from, to) < radius * radius) {
        return false;
      }
      const Point side = b - a;
      const double before = cross(side, from - a);
      const double after = cross(side, to - a);
      if (!(after < 0.0) || cross(along, a - from) * cross(along, b - from) > 0.0 || walk_[i].edge == last) continue;
      const double at = before / (before - after);
      if (walk_[i].edge.is_gate() ? at > progress && at < nearest && at <= 1.0 : before > 0.0) {
        if (!walk_[i].edge.is_gate()) return false;
        nearest = at;
        exit = i;
      }
    }
    if (exit == walk_.size()) return true;
    if (!walk_[exit].is_passable) return false;
    last = walk_[exit].edge;
    edge = map_->cells.across(last);
    progress = nearest;
  }
}

double DiscOptimal::arc(const Root& root, const Point& direction) const {
  if (root.contact.side == 0) return 0.0;
  const double angle = turning_angle(root.direction, direction, root.contact.side);
  return angle < 2 * kPi - 1.0 ? map_->radius * angle : 0.0;
}

void DiscOptimal::write_path(std::vector<DiscPiece>& pieces) const {
  const std::size_t count = pieces.size();
  Point to = goal_;
  Point direction = last_direction_;
  std::uint32_t after_root = kNone;
  for (std::uint32_t i = last_root_; i != kNone; i = roots_[i].before) {
    const Root& root = roots_[i];
    DiscPiece piece;
    piece.from = touching_point(root.contact, direction, map_->radius) + map_->origin;
    piece.to = to + map_->origin;
    piece.direction = direction;
    if (pieces.size() > count) {
      const DiscPiece& after = pieces.back();
      const Root& next = roots_[after_root];
      piece.centre = next.contact.centre + map_->origin;
      piece.side = arc(next, after.direction) == 0.0 ? 0 : next.contact.side;
      piece.end_direction = after.direction;
    }
    if (pieces.size() > count && direction == pieces.back().direction) {
      pieces.back().from = piece.from;  // the line goes straight on past the contact
    } else {
      pieces.push_back(piece);
    }
    if (arc(root, direction) == 0.0 && root.before != kNone) {
      pieces.back().from = touching_point(root.contact, root.direction, map_->radius) + map_->origin;
    }
    to = touching_point(root.contact, root.direction, map_->radius);
    direction = root.direction;
    after_root = i;
  }
  std::reverse(pieces.begin() + static_cast<std::ptrdiff_t>(count), pieces.end());
}

}  // namespace waywright::path
