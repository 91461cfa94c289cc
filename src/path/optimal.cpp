#include "path/optimal.hpp"

#include <algorithm>

#include "base/compiler.hpp"
#include "nav/point_agent.hpp"
#include "path/distance.hpp"
#include "path/optimal_cone.hpp"

namespace waywright::path {

using exact::Sign;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// When the search has followed a window over this many faces, it computes the bound of the window again.
constexpr int kFacesBetweenBounds = 8;

}  // namespace

void Optimal::begin(const Triangulation& triangulation, const nav::Abstraction* abstraction, const Start& start,
                    bool wants_channel, LookedAt* looked_at) {
  start_ = start;
  distances_ = nullptr;
  looked_at_ = looked_at;
  windows_ = nullptr;
  core_ = abstraction == nullptr ? nullptr : &abstraction->core();
  components_ = abstraction == nullptr ? nullptr : &abstraction->components();
  mesh_ = &triangulation.topology();
  geometry_ = &triangulation.triangulation().geometry();
  wants_channel_ = wants_channel;
  roots_.clear();
  nodes_.clear();
  open_.clear();
  at_once_.clear();  // not empty if memory ran out in the last search
  trace_count_ = 0;
  goals_.clear();
  goal_faces_.clear();
  goal_bits_ = 0;
  goals_in_components_.clear();
  if (components_ != nullptr) list_components();
  clear_last_query();
}

/// Lists the components of the start's faces, in ascending order, each once.
void Optimal::list_components() {
  for (const mesh::HalfEdge h : start_.faces) {
    goals_in_components_.push_back({components_->component_of(mesh::face(h)), 0});
  }
  std::sort(goals_in_components_.begin(), goals_in_components_.end(),
            [](const GoalsInComponent& p, const GoalsInComponent& q) { return p.component < q.component; });
  const auto is_same = [](const GoalsInComponent& p, const GoalsInComponent& q) { return p.component == q.component; };
  const auto repeated = std::unique(goals_in_components_.begin(), goals_in_components_.end(), is_same);
  goals_in_components_.erase(repeated, goals_in_components_.end());
}

void Optimal::add_goal(const Point& goal, const std::vector<mesh::HalfEdge>& faces) {
  for (const mesh::HalfEdge h : faces) {
    goal_faces_.push_back({mesh::face(h), static_cast<std::uint32_t>(goals_.size())});
    goal_bits_ |= bit_of(mesh::face(h));
    if (core_ != nullptr) count_goal_face(mesh::face(h));
  }
  goals_.push_back({goal, kInfinity, kNone, kNone});
}

void Optimal::start(double known_length) {
  std::sort(goal_faces_.begin(), goal_faces_.end(),
            [](const GoalFace& p, const GoalFace& q) { return p.face != q.face ? p.face < q.face : p.goal < q.goal; });
  known_length_ = known_length;
  update_longest();
  leave_start();
}

/// Computes `longest_`, `longest_count_` and `stop_bound_` from the paths to the goals that the search has found so
/// far.
void Optimal::update_longest() {
  longest_ = 0.0;
  longest_count_ = 0;
  for (const Goal& goal : goals_) {
    const double length = std::min(goal.length, known_length_);
    if (length > longest_) longest_count_ = 0;
    longest_ = std::max(longest_, length);
    if (length == longest_) ++longest_count_;
  }
  stop_bound_ = longest_;
}

template <class Visit>
void Optimal::for_each_goal(mesh::Face f, Visit&& visit) const {
  if (!may_have_goals(f)) return;
  const auto first = std::lower_bound(goal_faces_.begin(), goal_faces_.end(), f,
                                      [](const GoalFace& p, mesh::Face face) { return p.face < face; });
  for (auto at = first; at != goal_faces_.end() && at->face == f; ++at) visit(at->goal);
}

void Optimal::clear_last_query() {
  stamp_.next(1, reached_, goals_below_);
  grow_to_mesh();
}

void Optimal::grow_to_mesh() {
  reached_.grow_to(mesh_->vertex_slots());
  goals_below_.grow_to(mesh_->face_slots());
}

/// Returns the index of a component's entry in the list of components, or the index where it would be.
std::size_t Optimal::index_of(nav::Components::Id component) const {
  const auto comes_before = [](const GoalsInComponent& p, nav::Components::Id id) { return p.component < id; };
  const auto at = std::lower_bound(goals_in_components_.begin(), goals_in_components_.end(), component, comes_before);
  return static_cast<std::size_t>(at - goals_in_components_.begin());
}

/// Counts a goal face in its component, and at each face of the chain that leads from it up to the core.
void Optimal::count_goal_face(mesh::Face f) {
  const nav::Components::Id component = components_->component_of(f);
  const std::size_t at = index_of(component);
  if (at < goals_in_components_.size() && goals_in_components_[at].component == component) {
    ++goals_in_components_[at].count;
  }
  for (;;) {
    look(f);
    if (core_->is_core(f)) return;
    GoalsBelow& below = goals_below_[number(f)];
    if (below.query != stamp_.value()) below = {stamp_.value(), 0};
    ++below.count;
    const mesh::HalfEdge up = core_->towards_core(f);
    if (up == mesh::kNoHalfEdge) return;
    f = mesh::face(mesh_->twin(up));
  }
}

/// Returns how many goal faces lie in the face's component. Requires: this is a component of a start face.
std::uint32_t Optimal::goals_in_component_of(mesh::Face f) const {
  return goals_in_components_[index_of(components_->component_of(f))].count;
}

/// Returns whether no goal face lies beyond `exit`. Requires: `exit` is a passage, but not one between two faces of the
/// core, and its component has a goal. In a tree without a core, the result does not depend on which face is the root.
bool Optimal::leads_to_no_goal(mesh::HalfEdge exit) const {
  const mesh::Face f = mesh::face(exit);
  if (core_->leads_up(exit)) return goals_below(f) != 0 && goals_below(f) == goals_in_component_of(f);
  return goals_below(mesh::face(mesh_->twin(exit))) == 0;
}

// All edges of the start's faces are visible from the start, except the edges on which it lies.
void Optimal::leave_start() {
  roots_.push_back({start_.point, mesh::kNoVertex, kNone, 0.0, 0, 0});
  const locate::LocatedKind kind = start_.kind;
  at_once_bound_ = -1.0;  // no bound is negative, so push() adds no window to `at_once_`
  for (const mesh::HalfEdge h : start_.faces) {
    if (core_ != nullptr && goals_in_component_of(mesh::face(h)) == 0) continue;
    if (kind == locate::LocatedKind::vertex) reached(mesh_->origin(h)).length = 0.0;
    for (const mesh::HalfEdge corner : {h, mesh::next(h), mesh::previous(h)}) see(mesh_->origin(corner), 0);
    for (const mesh::HalfEdge exit : {h, mesh::next(h), mesh::previous(h)}) {
      if (exit == h && kind != locate::LocatedKind::face) continue;
      if (exit == mesh::previous(h) && kind == locate::LocatedKind::vertex) continue;
      if (is_excluded(exit)) continue;
      const mesh::HalfEdge entry = mesh_->twin(exit);
      push({Kind::window, false, entry, 0, 0, mesh_->origin(entry), mesh_->target(entry), kNone});
    }
  }
}

bool Optimal::step(std::size_t limit, std::size_t& expansions) {
  expansions_ = expansions;
  const auto is_done = [&] { return open_.empty() || open_.least_bound() >= stop_bound_; };
  while (!is_done() && expansions_ < limit) {
    at_once_bound_ = open_.least_bound();
    follow(nodes_[open_.pop()]);
    while (!at_once_.empty()) {
      const Node next = at_once_.back();
      at_once_.pop_back();
      follow_window(next);
    }
  }
  expansions = expansions_;
  return is_done();
}

// Takes the node by value: the new nodes may move the memory of `nodes_`.
void Optimal::follow(Node node) {
  switch (node.kind) {
    case Kind::window:
      return follow_window(node);
    case Kind::left_turn:
      return make_turn<Kind::left_turn>(node);
    case Kind::right_turn:
      return make_turn<Kind::right_turn>(node);
  }
}

// Not inline: most functions of the search contain a call of this function, but only a guide makes the call.
bool Optimal::can_guide_cross(mesh::HalfEdge h) const { return distances_->can_cross(h); }

//        apex            The window has entered the face across `entry`, from below. Seen by the window, the left end
//       /    \           of `entry` is its origin. If the apex lies outside the cone, the window continues across one
//   origin - target      edge. If the apex lies inside the cone, it divides the window.
template <bool kIsGuide>
void Optimal::follow_window_as(Node window) {
  Cone cone(*this, window);
  for (int faces = 1;; ++faces) {
    ++expansions_;
    const mesh::Face f = mesh::face(window.entry);
    window.trace = traced(window.entry, window.trace);
    if constexpr (kIsGuide) {
      distances_->cross(f, window.entry);
    } else {
      enter(f, window);
    }
    if (may_have_goals(f)) reach_goals(window, cone);
    const mesh::Vertex apex = mesh_->apex(window.entry);
    const Geometry::View position = geometry_->view(number(apex));
    mesh::HalfEdge exit{};
    if (const Sign left = cone.orientation_to_left(position); left != Sign::negative) {
      const bool turn_sees_apex = left == Sign::positive;
      if (window.left == mesh_->origin(window.entry) && note_turn(window, cone, Kind::left_turn, turn_sees_apex))
        return;
      exit = mesh::next(window.entry);
      if (left == Sign::zero) narrow_left(window, cone, apex, window.left_root);
    } else if (const Sign right = cone.orientation_to_right(position); right != Sign::positive) {
      const bool turn_sees_apex = right == Sign::negative;
      if (window.right == mesh_->target(window.entry) && note_turn(window, cone, Kind::right_turn, turn_sees_apex))
        return;
      exit = mesh::previous(window.entry);
      if (right == Sign::zero) narrow_right(window, cone, apex, window.right_root);
    } else {
      exit = mesh::next(window.entry);
      if (is_excluded<kIsGuide>(f, exit)) {
        exit = mesh::previous(window.entry);
        narrow_right(window, cone, apex, root_that_sees(window, position));
      } else if (is_excluded<kIsGuide>(f, mesh::previous(window.entry))) {
        narrow_left(window, cone, apex, root_that_sees(window, position));
      } else {
        return divide(window, cone, apex);
      }
    }
    if (is_excluded<kIsGuide>(f, exit)) return;
    window.entry = mesh_->twin(exit);
    if (faces % kFacesBetweenBounds != 0) continue;
    const Point left = cone.left_direction();
    const Point right = cone.right_direction();
    if (bound(window, left, right) > at_once_bound_) return push(window, left, right);
  }
}

// Inline in both versions of follow_window_as(): otherwise a search for a point agent takes about 1 % more
// instructions.
WAYWRIGHT_ALWAYS_INLINE
void Optimal::narrow_left(Node& window, Cone& cone, mesh::Vertex apex, std::uint32_t root) const {
  see(apex, root);
  window.left_root = root;
  window.left = apex;
  cone.set_left(Cone::ray(*this, root, apex));
}

WAYWRIGHT_ALWAYS_INLINE
void Optimal::narrow_right(Node& window, Cone& cone, mesh::Vertex apex, std::uint32_t root) const {
  see(apex, root);
  window.right_root = root;
  window.right = apex;
  cone.set_right(Cone::ray(*this, root, apex));
}

void Optimal::divide(const Node& window, const Cone& cone, mesh::Vertex apex) {
  const std::uint32_t root = root_that_sees(window, geometry_->view(number(apex)));
  see(apex, root);
  const Point to_apex = position_of(apex) - roots_[root].point;
  Node right = window;
  right.entry = mesh_->twin(mesh::next(window.entry));
  right.left_root = root;
  right.left = apex;
  Node left = window;
  left.entry = mesh_->twin(mesh::previous(window.entry));
  left.right_root = root;
  left.right = apex;
  push(left, cone.left_direction(), to_apex);
  push(right, to_apex, cone.right_direction());
}

void Optimal::reach_goals(const Node& window, const Cone& cone) {
  for_each_goal(mesh::face(window.entry), [&](std::uint32_t goal) {
    const Geometry::View position = Geometry::view(goals_[goal].point);
    if (cone.orientation_to_left(position) == Sign::positive || cone.orientation_to_right(position) == Sign::negative)
      return;
    store_path(goal, root_that_sees(window, position), window.trace);
  });
}

void Optimal::store_path(std::uint32_t goal, std::uint32_t root, std::uint32_t trace) {
  Goal& at = goals_[goal];
  const double length = roots_[root].length + distance(roots_[root].point, at.point);
  if (length >= std::min(at.length, known_length_)) return;
  const bool was_longest = std::min(at.length, known_length_) >= longest_;
  at.length = length;
  at.root = root;
  at.trace = trace;
  if (distances_ != nullptr) {
    if (longest_ == kInfinity) stop_bound_ = length;
    return;
  }
  if (was_longest && --longest_count_ == 0) update_longest();
}

//          apex          The picture shows a left turn: the cone's left ray touches v, the entry's left end. The
//        /    \          face's apex lies on the ray or to its left. A path that turns left at v, around the walls,
//       /      \         can reach the area left of the ray. No wall at v lies to the right of the path, because the
//   v -------- target    cone has passed there. If v has no walls, there is nothing to turn around.
//
// Let the far edge be the edge of the face opposite to v. Returns whether the window waits in the new node until the
// search makes the turn. Beyond the far edge, the window and the new root's window lie beside each other, and then move
// on as one bundle.
bool Optimal::note_turn(const Node& window, const Cone& cone, Kind kind, bool turn_sees_apex) {
  const bool is_left = kind == Kind::left_turn;
  const mesh::HalfEdge near_edge = is_left ? mesh::previous(window.entry) : mesh::next(window.entry);
  const mesh::HalfEdge far_edge = is_left ? mesh::next(window.entry) : mesh::previous(window.entry);
  const bool turn_sees_passage = turn_sees_apex && !is_excluded(far_edge);
  if (!turn_sees_passage && is_excluded(near_edge)) {
    bool is_at_goal = false;
    for_each_goal(mesh::face(window.entry), [&](std::uint32_t) { is_at_goal = true; });
    if (!is_at_goal) return false;
  }
  const mesh::Vertex v = is_left ? window.left : window.right;
  const Point& at = position_of(v);
  const Root& root = roots_[is_left ? window.left_root : window.right_root];
  const double length = root.length + distance(root.point, at);
  const double least = length + bound_from(at);
  if (least >= longest_) return false;
  Reached& reached_before = reached(v);
  if (length >= reached_before.length) return false;
  reached_before.length = length;
  reached_before.spoke = is_left ? window.entry : mesh_->twin(window.entry);
  nodes_.push_back(window);
  nodes_.back().kind = kind;
  nodes_.back().has_window = turn_sees_passage && can_wait(window, cone, kind, least);
  open_.push(least, static_cast<std::uint32_t>(nodes_.size() - 1));
  return nodes_.back().has_window;
}

/// Returns whether the window may wait for the turn whose bound is `least`: the window's own bound at the far edge is
/// not smaller and, if the window is a bundle, its roots after the first are turns in the same direction as the new
/// root.
bool Optimal::can_wait(const Node& window, const Cone& cone, Kind kind, double least) const {
  const bool is_left = kind == Kind::left_turn;
  if (is_left ? window.left_root < window.right_root : window.right_root < window.left_root) return false;
  Node beyond = window;
  beyond.entry = mesh_->twin(is_left ? mesh::next(window.entry) : mesh::previous(window.entry));
  return bound(beyond, cone.left_direction(), cone.right_direction()) >= least;
}

/// If the search drops a turn, pushes the window that waits in it across the far edge.
void Optimal::push_waiting(const Node& turn) {
  if (!turn.has_window) return;
  Node window = turn;
  window.entry = mesh_->twin(turn.kind == Kind::left_turn ? mesh::next(turn.entry) : mesh::previous(turn.entry));
  window.kind = Kind::window;
  window.has_window = false;
  push(window);
}

/// Returns the entry of `v`. It contains the length of the shortest path to `v` so far: infinity if there is none yet,
/// minus infinity if no path can turn at `v`.
Optimal::Reached& Optimal::reached(mesh::Vertex v) {
  Reached& entry = reached_[number(v)];
  if (entry.query == stamp_.value()) return entry;
  entry = {has_walls(v) ? kInfinity : -kInfinity, stamp_.value(), mesh::kNoHalfEdge};
  return entry;
}

bool Optimal::has_walls(mesh::Vertex v) const {
  const mesh::HalfEdge start = mesh_->outgoing(v);
  mesh::HalfEdge h = start;
  do {
    if (!nav::PointAgent::can_cross(*mesh_, h)) return true;
    h = mesh_->next_around(h);
  } while (h != start);
  return false;
}

std::uint32_t Optimal::add_root(mesh::Vertex v, std::uint32_t before) {
  const Point& at = position_of(v);
  const Root& last = roots_[before];
  const Root& middle = roots_[last.jump];
  // Each root stores one jump to an earlier root. If the jump of the last root and the next jump from there are equally
  // long, the new root jumps to the end of the second one. So a walk back along n roots takes about log n steps.
  const bool joins = last.depth - middle.depth == middle.depth - roots_[middle.jump].depth;
  const std::uint32_t jump = joins ? middle.jump : before;
  roots_.push_back({at, v, before, last.length + distance(last.point, at), last.depth + 1, jump});
  return static_cast<std::uint32_t>(roots_.size() - 1);
}

//           apex   .       The picture shows a left turn: the path has come to v, the entry's left end, from below, and
//            |  \ .        turns left around the walls there. The dotted line is the straight continuation of the path
//            |  . \        beyond v. From v, the path sees the piece of the face's far edge between this line and the
//            | .    \      apex. It also sees the far edges of the next faces around v, up to the walls. The picture of
//   walls -- v -- target   a right turn is the mirror image.
template <Optimal::Kind kTurn>
void Optimal::make_turn(const Node& turn) {
  constexpr bool kIsLeft = kTurn == Kind::left_turn;
  constexpr Sign kInwards = kIsLeft ? Sign::positive : Sign::negative;
  // For a right turn, the directions are mirrored.
  const auto far = [](mesh::HalfEdge h) { return kIsLeft ? mesh::next(h) : mesh::previous(h); };
  const auto near = [](mesh::HalfEdge h) { return kIsLeft ? mesh::previous(h) : mesh::next(h); };
  const mesh::Vertex v = kIsLeft ? turn.left : turn.right;
  const std::uint32_t root = add_root(v, kIsLeft ? turn.left_root : turn.right_root);
  if (roots_[root].length > reached(v).length) return push_waiting(turn);
  ++expansions_;
  const mesh::HalfEdge far_edge = far(turn.entry);
  const mesh::Vertex apex = mesh_->apex(turn.entry);
  Node window{Kind::window, false, mesh_->twin(far_edge), root, root, kContinuation, kContinuation, turn.trace};
  (kIsLeft ? window.left : window.right) = apex;
  enter(mesh::face(turn.entry), window);
  const Cone cone(*this, window);
  const auto orientation_to_continuation = [&](const Geometry::View& position) {
    return kIsLeft ? cone.orientation_to_right(position) : cone.orientation_to_left(position);
  };
  const Sign side_of_apex = orientation_to_continuation(geometry_->view(number(apex)));
  const bool turn_sees_apex = side_of_apex == kInwards;
  if (side_of_apex != -kInwards) see(apex, root);
  for_each_goal(mesh::face(turn.entry), [&](std::uint32_t goal) {
    const bool is_seen = orientation_to_continuation(Geometry::view(goals_[goal].point)) != -kInwards;
    if (is_seen) store_path(goal, root, turn.trace);
  });
  if (turn_sees_apex && !is_excluded(far_edge)) {
    if (turn.has_window) {
      (kIsLeft ? window.right_root : window.left_root) = kIsLeft ? turn.right_root : turn.left_root;
      (kIsLeft ? window.right : window.left) = kIsLeft ? turn.right : turn.left;
    }
    push(window);
  }
  std::uint32_t trace = turn.trace;
  for (mesh::HalfEdge h = turn.entry; !is_excluded(near(h));) {
    h = mesh_->twin(near(h));
    trace = traced(h, trace);
    ++expansions_;
    const mesh::HalfEdge exit = far(h);
    const mesh::HalfEdge entry = mesh_->twin(exit);
    Node beyond{Kind::window, false, entry, root, root, mesh_->origin(entry), mesh_->target(entry), trace};
    enter(mesh::face(h), beyond);
    if (distances_ != nullptr) distances_->cross(mesh::face(h), h);
    see(mesh_->apex(h), root);
    for_each_goal(mesh::face(h), [&](std::uint32_t goal) { store_path(goal, root, trace); });
    if (is_excluded(exit)) continue;
    push(beyond);
  }
}

void Optimal::push(const Node& window) {
  const Cone cone(*this, window);
  push(window, cone.left_direction(), cone.right_direction());
}

void Optimal::push(const Node& window, const Point& left, const Point& right) {
  const double least = bound(window, left, right);
  if (least >= longest_ || is_dominated(window, window.entry) || is_dominated(window, mesh_->twin(window.entry)))
    return;
  if (least <= at_once_bound_) {
    at_once_.push_back(window);
    return;
  }
  nodes_.push_back(window);
  open_.push(least, static_cast<std::uint32_t>(nodes_.size() - 1));
}

Optimal::Geometry::View Optimal::view(const Root& root) const {
  return root.vertex == mesh::kNoVertex ? Geometry::view(root.point) : geometry_->view(number(root.vertex));
}

void Optimal::grow_traces() { traces_.resize(std::max(std::size_t{256}, 2 * traces_.size())); }

void Optimal::write_path(std::size_t goal, bool wants_points, Path& path) const {
  const Goal& at = goals_[goal];
  path.status = PathStatus::found;
  path.length = at.length;
  path.lower_bound = at.length;
  path.points.clear();
  if (!wants_points) return;
  path.points.push_back(at.point);
  for (std::uint32_t root = at.root; root != kNone; root = roots_[root].before) {
    if (roots_[root].point != path.points.back()) path.points.push_back(roots_[root].point);
  }
  std::reverse(path.points.begin(), path.points.end());
}

void Optimal::write_channel(std::size_t goal, Path& path) const {
  path.channel.clear();
  for_each_portal(goal, [&](mesh::HalfEdge entry) {
    path.channel.push_back({position_of(mesh_->origin(entry)), position_of(mesh_->target(entry))});
  });
  std::reverse(path.channel.begin(), path.channel.end());
}

}  // namespace waywright::path
