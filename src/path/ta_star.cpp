#include "path/ta_star.hpp"

#include <algorithm>

#include "locate/walk.hpp"

namespace waywright::path {

namespace {

/// The length of the shortest way from p to q that touches the segment from a to b.
double distance_by_way_of(const Point& p, const Point& a, const Point& b, const Point& q) {
  const auto side = [&](const Point& r) { return (b.x - a.x) * (r.y - a.y) - (b.y - a.y) * (r.x - a.x); };
  const double p_side = side(p);
  double q_side = side(q);
  Point image = q;
  if ((p_side > 0.0 && q_side > 0.0) || (p_side < 0.0 && q_side < 0.0)) {
    // q lies on p's side: its mirror image beyond the segment is as far from every point of it.
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double scale = 2.0 * q_side / (dx * dx + dy * dy);
    image = {q.x + dy * scale, q.y - dx * scale};
    q_side = -q_side;
  }
  const auto turn = [&](const Point& r) { return (image.x - p.x) * (r.y - p.y) - (image.y - p.y) * (r.x - p.x); };
  const double a_turn = turn(a);
  const double b_turn = turn(b);
  if ((a_turn >= 0.0 && b_turn <= 0.0) || (a_turn <= 0.0 && b_turn >= 0.0)) return distance(p, image);
  return std::min(distance(p, a) + distance(a, q), distance(p, b) + distance(b, q));
}

}  // namespace

void TaStar::find(const PathQuery& query, Path& path) {
  path.length = 0.0;
  path.points.clear();
  path.expansions = 0;
  if (!prepare(query, path)) return;
  mark_goal_faces();
  for (const mesh::HalfEdge h : scratch_.start_faces) {
    if (scratch_.is_goal[number(mesh::face(h))] == scratch_.query) {
      is_found_ = true;
      best_corner_ = TautTree::kRoot;
      best_length_ = distance(query.start, query.goal);
    }
  }
  if (!is_found_) {
    for (const mesh::HalfEdge h : scratch_.start_faces) leave_start_face(h);
  }
  while (!scratch_.open.empty()) {
    const SearchNode node = scratch_.nodes[pop()];
    if (is_found_ && node.bound >= best_length_) break;
    std::uint32_t& entered = scratch_.entered[number(node.entry)];
    if (entered == scratch_.query) continue;
    entered = scratch_.query;
    ++path.expansions;
    if (scratch_.is_goal[number(mesh::face(node.entry))] == scratch_.query) {
      arrive(node);
    } else {
      leave(node);
    }
  }
  path.status = is_found_ ? PathStatus::found : PathStatus::no_path;
  if (is_found_) write_path(path);
}

/// Whether there is anything to search: both ends free, and open faces around them.
bool TaStar::prepare(const PathQuery& query, Path& path) {
  const auto& delaunay = triangulation_.triangulation();
  const locate::Located start = delaunay.locate(query.start);
  const locate::Located goal = delaunay.locate(query.goal);
  goal_ = query.goal;
  is_found_ = false;
  scratch_.nodes.clear();
  scratch_.open.clear();
  if (scratch_.cover.is_strictly_inside(triangulation_, start)) {
    path.status = PathStatus::start_blocked;
    return false;
  }
  if (scratch_.cover.is_strictly_inside(triangulation_, goal)) {
    path.status = PathStatus::goal_blocked;
    return false;
  }
  scratch_.start_faces = scratch_.cover.open_faces(triangulation_, start);
  scratch_.goal_faces = scratch_.cover.open_faces(triangulation_, goal);
  scratch_.tree.reset(delaunay.geometry(), query.start);
  if (query.start == query.goal) {
    path.status = PathStatus::found;
    path.points = {query.start, query.goal};
    return false;
  }
  return true;
}

void TaStar::mark_goal_faces() {
  if (++scratch_.query == 0) {  // the count went once around: forget all marks
    std::fill(scratch_.entered.begin(), scratch_.entered.end(), 0);
    std::fill(scratch_.is_goal.begin(), scratch_.is_goal.end(), 0);
    scratch_.query = 1;
  }
  if (scratch_.is_goal.size() < mesh_.face_slots()) {
    scratch_.is_goal.resize(mesh_.face_slots(), 0);
    scratch_.entered.resize(std::size_t{3} * mesh_.face_slots(), 0);
  }
  for (const mesh::HalfEdge h : scratch_.goal_faces) scratch_.is_goal[number(mesh::face(h))] = scratch_.query;
}

// Seen from inside the face, an edge's left end is its target.
void TaStar::leave_start_face(mesh::HalfEdge h) {
  for (const mesh::HalfEdge exit : {h, mesh::next(h), mesh::previous(h)}) {
    if (mesh_.is_fixed(exit)) continue;
    const std::uint32_t left = scratch_.tree.add_seen(mesh_.target(exit));
    const std::uint32_t right = scratch_.tree.add_seen(mesh_.origin(exit));
    open(exit, {TautTree::kRoot, left, right});
  }
}

//          c             The face was entered across `entry` from below: its left end is the edge's origin, its right
//          end
//        /   \           the target. Going on across target - c moves the left end to c, across c - origin the right
//        end.
//      /       \.
//  origin --> target
void TaStar::leave(const SearchNode& node) {
  const mesh::Vertex apex = mesh_.apex(node.entry);
  const mesh::HalfEdge beyond_target = mesh::next(node.entry);
  const mesh::HalfEdge beyond_origin = mesh::previous(node.entry);
  if (!mesh_.is_fixed(beyond_target)) open(beyond_target, scratch_.tree.move_left(node.funnel, apex));
  if (!mesh_.is_fixed(beyond_origin)) open(beyond_origin, scratch_.tree.move_right(node.funnel, apex));
}

void TaStar::open(mesh::HalfEdge exit, const Funnel& funnel) {
  const mesh::HalfEdge entry = mesh_.twin(exit);
  if (scratch_.entered[number(entry)] == scratch_.query) return;
  scratch_.nodes.push_back({entry, funnel, bound(funnel)});
  scratch_.open.push_back(static_cast<std::uint32_t>(scratch_.nodes.size() - 1));
  std::push_heap(scratch_.open.begin(), scratch_.open.end(),
                 [&](std::uint32_t i, std::uint32_t j) { return comes_later(i, j); });
}

std::uint32_t TaStar::pop() {
  std::pop_heap(scratch_.open.begin(), scratch_.open.end(),
                [&](std::uint32_t i, std::uint32_t j) { return comes_later(i, j); });
  const std::uint32_t top = scratch_.open.back();
  scratch_.open.pop_back();
  return top;
}

/// Nodes of equal bound come in the order in which they were opened, which the mesh's geometry alone decides.
bool TaStar::comes_later(std::uint32_t i, std::uint32_t j) const {
  const double a = scratch_.nodes[i].bound;
  const double b = scratch_.nodes[j].bound;
  return a > b || (a == b && i > j);
}

void TaStar::arrive(const SearchNode& node) {
  const std::uint32_t corner = scratch_.tree.last_corner(node.funnel, goal_);
  const double length = scratch_.tree.length(corner) + distance(scratch_.tree.point(corner), goal_);
  if (is_found_ && length >= best_length_) return;
  is_found_ = true;
  best_length_ = length;
  best_corner_ = corner;
}

double TaStar::bound(const Funnel& funnel) const {
  const TautTree& tree = scratch_.tree;
  return tree.length(funnel.apex) +
         distance_by_way_of(tree.point(funnel.apex), tree.point(funnel.left), tree.point(funnel.right), goal_);
}

void TaStar::write_path(Path& path) const {
  const TautTree& tree = scratch_.tree;
  path.length = best_length_;
  path.points.push_back(goal_);
  for (std::uint32_t node = best_corner_;; node = tree.parent(node)) {
    if (tree.point(node) != path.points.back()) path.points.push_back(tree.point(node));
    if (node == TautTree::kRoot) break;
  }
  std::reverse(path.points.begin(), path.points.end());
}

}  // namespace waywright::path
