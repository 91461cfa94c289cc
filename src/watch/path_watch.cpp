#include "waywright/path_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>

#include "waywright/world.hpp"

#include "base/float_environment.hpp"
#include "base/ieee.hpp"
#include "constraint/slot_sets.hpp"
#include "nav/abstraction.hpp"
#include "nav/point_agent.hpp"
#include "path/answer.hpp"
#include "path/fit_finder.hpp"
#include "path/pieces.hpp"
#include "path/point_ends.hpp"
#include "path/polyline_walk.hpp"
#include "watch/box_grid.hpp"
#include "watch/box_tests.hpp"
#include "watch/key_order.hpp"
#include "watch/refusals.hpp"
#include "world/query_errors.hpp"
#include "world/world_impl.hpp"

namespace waywright {

using namespace watch;

namespace {

/// A long straight piece of a path has several boxes, so that the boxes contain few positions that are far from the
/// path. The width of each box is at most this share of the width of the domain, or its height is at most this share of
/// the height of the domain.
constexpr double kLargestShare = 0x1p-6;

/// Calls visit(box) for boxes that together contain all positions that are at most `reach` away from the segment from
/// `a` to `b`.
template <class Visit>
void for_each_box_of_line(const Point& a, const Point& b, double reach, const Box& domain, const Visit& visit) {
  const double wide = std::abs(b.x - a.x) / (kLargestShare * domain.width());
  const double high = std::abs(b.y - a.y) / (kLargestShare * domain.height());
  const auto count = static_cast<int>(std::clamp(std::ceil(std::min(wide, high)), 1.0, 1.0 / kLargestShare));
  Point from = a;
  for (int i = 1; i <= count; ++i) {
    const Point to = lerp(a, b, static_cast<double>(i) / count);
    Box box{from, from};
    box.expand(to);
    visit(box.expanded(reach + slack_of(a, b)));
    from = to;
  }
}

/// One box of a piece of a path. A piece is a segment or an arc. A long segment has several boxes.
struct Piece {
  std::uint32_t slot;   ///< of the path
  std::uint32_t index;  ///< of the segment or arc in the path
  Diagonal diagonal;
};

/// An ellipse of a path.
struct EllipseOfPath {
  Ellipse ellipse;
  std::uint32_t slot;
};

/// The lists of an answer, empty at first. During an update, `blocked` and `may_be_blocked` contain slots. At the end,
/// the update replaces the slots by keys. If memory runs out, the destructor empties the lists.
class Answer {
 public:
  explicit Answer(PathChanges& changes) : changes_(changes) { clear(); }
  ~Answer() {
    if (!is_kept_) clear();
  }
  Answer(const Answer&) = delete;
  Answer& operator=(const Answer&) = delete;

  void keep() { is_kept_ = true; }

 private:
  void clear() {
    changes_.blocked.clear();
    changes_.may_be_blocked.clear();
    changes_.may_be_too_long.clear();
  }

  PathChanges& changes_;
  bool is_kept_ = false;
};

}  // namespace

struct WAYWRIGHT_INTERNAL PathWatch::Impl {
  using Pieces = BoxGrid<Piece>;
  using Ellipses = BoxGrid<EllipseOfPath>;
  using Boxes = std::span<const ChangedBox>;
  using ConstrainedTriangulation = constraint::ConstrainedTriangulation;

  /// What an update reads of each path near a change. Thousands of these fit into the cache.
  struct State {
    std::uint64_t seen_by = 0;  ///< the number of the last update that has checked or reported the path
    bool is_for_disc = false;
    bool is_blocked = false;  ///< whether the last check found it blocked; only for a point agent
  };
  struct Watched {
    std::vector<Point> points;
    std::vector<PathPiece> pieces;  ///< empty for a point agent
    Agent agent;
    std::vector<Pieces::Handle> boxes;  ///< handles in Impl::pieces
    Ellipses::Handle ellipse = 0;       ///< a handle in Impl::ellipses
    bool has_ellipse = false;
    bool is_in_domain = false;  ///< whether all points are points of the domain
  };

  explicit Impl(const World& world)
      : domain(world.domain()),
        version(world.version()),
        had_crossings(has_crossings(world)),
        connections(connections_of(world)),
        pieces(domain),
        ellipses(domain),
        refusals(domain) {}

  static bool has_crossings(const World& world) {
    return world.impl_->triangulation().triangulation().geometry().has_constructed();
  }

  /// The state of the components (nav::Abstraction::connections()), or 0 without an abstraction.
  static std::uint64_t connections_of(const World& world) {
    const nav::Abstraction* const abstraction = world.impl_->layers.abstraction();
    return abstraction != nullptr ? abstraction->connections() : 0;
  }

  /// The slot of a new path. If memory runs out while PathWatch::add() adds the path, the destructor removes the path
  /// again.
  class Addition {
   public:
    explicit Addition(Impl& impl) : impl_(impl) {
      if (impl_.free_slots.empty()) {
        // Reserves room for all slots, so that drop() allocates nothing.
        const std::size_t needed = impl_.watched.size() + 1;
        if (impl_.free_slots.capacity() < needed) impl_.free_slots.reserve(2 * needed);
        if (impl_.states.size() < needed) impl_.states.resize(needed);
        impl_.watched.emplace_back();
        impl_.free_slots.push_back(static_cast<std::uint32_t>(impl_.watched.size() - 1));
      }
      impl_.keys.make_room(impl_.free_slots.back());
      slot_ = impl_.free_slots.back();
      impl_.free_slots.pop_back();
    }
    ~Addition() {
      if (!is_kept_) impl_.drop(slot_);
    }
    Addition(const Addition&) = delete;
    Addition& operator=(const Addition&) = delete;

    [[nodiscard]] std::uint32_t slot() const { return slot_; }
    void keep() { is_kept_ = true; }

   private:
    Impl& impl_;
    std::uint32_t slot_ = 0;
    bool is_kept_ = false;
  };

  void add_boxes(std::uint32_t slot);
  void add_box(const Piece& piece, const Box& box);
  void drop(std::uint32_t slot) noexcept;
  void set_blocked(std::uint32_t slot, bool is_blocked) noexcept {
    if (std::exchange(states[slot].is_blocked, is_blocked)) --blocked_count;
    if (is_blocked) ++blocked_count;
  }
  void check(const Piece& piece, const Box& around, const World& world, Boxes boxes, PathChanges& changes);
  void collect_walls(const ConstrainedTriangulation& triangulation, const Box& box);
  [[nodiscard]] bool crosses_wall(const Box& around, Diagonal diagonal) const;
  [[nodiscard]] bool may_lose_crossing(const ChangedBox& changed, Boxes boxes) const;
  [[nodiscard]] static bool turns_in(const Watched& path, const Box& box);
  [[nodiscard]] static bool touches(const Watched& path, std::uint32_t piece, const Box& box);
  [[nodiscard]] bool can_decide_by_stretches(std::uint32_t slot, Boxes boxes) const;
  [[nodiscard]] bool is_clear(std::uint32_t slot, const World& world, Boxes boxes);
  void check_box(const ChangedBox& changed, const World& world, Boxes boxes, PathChanges& changes);
  void check_all(const World& world, PathChanges& changes);
  void check_refusals(const World& world, Boxes boxes, bool all);
  [[nodiscard]] bool has_become_possible(std::uint32_t slot, const World::Impl& world, std::optional<Box>& barrier);
  [[nodiscard]] bool are_in_one_area(std::optional<Box>& barrier);
  [[nodiscard]] bool can_disc_pass(PathQuery& query, bool fits, const World::Impl& world, std::optional<Box>& barrier);

  Box domain;
  std::uint64_t version;      ///< the version of the world at the last update
  bool had_crossings;         ///< whether the world had crossings at the last update
  std::uint64_t connections;  ///< connections_of() the world at the last update
  std::uint64_t updates = 0;
  Pieces pieces;
  Ellipses ellipses;  ///< by the bounding boxes of the ellipses
  Refusals refusals;
  std::vector<Watched> watched;
  std::vector<State> states;      ///< by slot
  std::size_t blocked_count = 0;  ///< the number of paths with State::is_blocked
  std::vector<std::uint32_t> free_slots;
  std::unordered_map<std::uint64_t, std::uint32_t> slots;  ///< by key
  KeyOrder keys;                                           ///< the keys of `slots`
  std::vector<std::array<Point, 2>> walls;  ///< some walls that meet the box that check_box() is looking at
  bool has_walls = false;                   ///< whether `walls` is up to date
  constraint::SlotSet seen_faces;
  std::vector<mesh::HalfEdge> faces;
  nav::ComponentCoverFinder cover_finder;
  path::PolylineWalk walk;

  // Scratch of check_refusals().
  path::PointEnds moved_ends;
  std::optional<FaceGraph> face_graph;  ///< set if the areas of `face_areas` belong to the present world
  Areas<FaceGraph> face_areas;
  std::optional<CellGraph> cell_graph;  ///< set if the areas of `cell_areas` belong to the present world
  double radius_of_cells = 0.0;
  Areas<CellGraph> cell_areas;
  path::FitFinder fit_finder;
  Path answer;
};

void PathWatch::Impl::add_box(const Piece& piece, const Box& box) {
  std::vector<Pieces::Handle>& boxes = watched[piece.slot].boxes;
  if (boxes.size() == boxes.capacity()) boxes.reserve(2 * boxes.size() + 4);
  boxes.push_back(pieces.insert(box, piece));
}

/// Adds the boxes of all pieces of a path.
void PathWatch::Impl::add_boxes(std::uint32_t slot) {
  const Watched& path = watched[slot];
  Piece added{slot, 0, Diagonal::none};
  const auto add = [&](const Box& box) { add_box(added, box); };
  if (path.pieces.empty()) {
    if (path.points.size() == 1) for_each_box_of_line(path.points[0], path.points[0], 0.0, domain, add);
    for (; added.index + 1 < path.points.size(); ++added.index) {
      const Point& from = path.points[added.index];
      const Point& to = path.points[added.index + 1];
      const bool rises = (from.x <= to.x) == (from.y <= to.y);
      if (path.is_in_domain) added.diagonal = rises ? Diagonal::rising : Diagonal::falling;
      for_each_box_of_line(from, to, 0.0, domain, add);
    }
    return;
  }
  for (const PathPiece& piece : path.pieces) {
    const double reach = path.agent.radius * (1.0 + 0x1p-40);
    if (piece.kind == PathPiece::Kind::line) {
      for_each_box_of_line(piece.from, piece.to, reach, domain, add);
    } else {
      for_each_box_of_line(piece.centre, piece.centre, reach + piece.radius * (1.0 + 0x1p-40), domain, add);
    }
    ++added.index;
  }
}

/// Frees a slot and removes its boxes. Keeps the memory of its lists.
void PathWatch::Impl::drop(std::uint32_t slot) noexcept {
  Watched& path = watched[slot];
  for (const Pieces::Handle box : path.boxes) pieces.remove(box);
  if (path.has_ellipse) ellipses.remove(path.ellipse);
  refusals.remove(slot);
  set_blocked(slot, false);
  path.has_ellipse = false;
  path.boxes.clear();
  path.points.clear();
  path.pieces.clear();
  free_slots.push_back(slot);
}

/// Checks the path of a point agent, because a changed box may touch `piece`, a piece of this path. Does nothing if
/// this update has already checked the path. `around` is the box of the piece. check_all() passes a piece without a
/// diagonal and an empty box: then the function tests the whole path. Adds the slot of the path to `changes` if the
/// path is blocked. `boxes` are the boxes of all changes since the last update, or empty if the world no longer has
/// them. If the piece surely crosses a wall, the path is blocked. This test finds most blocked paths, and costs less
/// than a walk along the path.
void PathWatch::Impl::check(const Piece& piece, const Box& around, const World& world, Boxes boxes,
                            PathChanges& changes) {
  State& state = states[piece.slot];
  if (std::exchange(state.seen_by, updates) == updates) return;
  const bool is_blocked =
      crosses_wall(around, piece.diagonal) || !watched[piece.slot].is_in_domain || !is_clear(piece.slot, world, boxes);
  set_blocked(piece.slot, is_blocked);
  if (is_blocked) changes.blocked.push_back(piece.slot);
}

/// Sets `walls` to the walls that meet the box, apart from rounding errors. If the box meets many faces, `walls`
/// contains only some of these walls.
void PathWatch::Impl::collect_walls(const ConstrainedTriangulation& triangulation, const Box& box) {
  constexpr std::size_t kMostFaces = 64;
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const mesh::TriangleMesh& mesh = triangulation.topology();
  walls.clear();
  seen_faces.clear();
  faces.clear();
  has_walls = true;
  const auto add_face = [&](mesh::HalfEdge h) {
    if (faces.size() == kMostFaces || triangulation.triangulation().is_ghost_face(h)) return;
    if (seen_faces.insert(number(mesh::face(h)))) faces.push_back(h);
  };
  add_face(triangulation.triangulation().locate(box.min).h);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const mesh::HalfEdge face = faces[i];
    for (const mesh::HalfEdge h : {face, mesh::next(face), mesh::previous(face)}) {
      const Point& from = geometry.rounded(number(mesh.origin(h)));
      const Point& to = geometry.rounded(number(mesh.target(h)));
      if (!probably_meets(from, to, box)) continue;
      if (!nav::PointAgent::can_cross(mesh, h) && h < mesh.twin(h)) walls.push_back({from, to});
      add_face(mesh.twin(h));
    }
  }
}

/// Returns true only if the piece surely crosses one of `walls`. The piece runs along a diagonal of the box `around`.
/// Each coordinate of its ends differs from a coordinate of the box by less than twice slack_of() for the domain.
bool PathWatch::Impl::crosses_wall(const Box& around, Diagonal diagonal) const {
  if (!has_walls || diagonal == Diagonal::none) return false;
  const std::array<Point, 2> ends = ends_of(around, diagonal);
  const double slack = 4.0 * slack_of(domain.min, domain.max);
  return std::any_of(walls.begin(), walls.end(),
                     [&](const auto& wall) { return surely_cross(ends[0], ends[1], wall[0], wall[1], slack); });
}

/// Returns whether PolylineWalk::find_stretch_state() can decide about the stretches of a path that the boxes touch. A
/// *stretch* is one straight line of the path, or several that follow each other. Returns false in these cases: the
/// last check has found the path blocked; an operation has removed an item where the path turns, and a crossing may
/// have vanished with this item; the path has fewer than two points; there are no boxes, or many.
bool PathWatch::Impl::can_decide_by_stretches(std::uint32_t slot, Boxes boxes) const {
  constexpr std::size_t kMostBoxes = 8;
  const Watched& path = watched[slot];
  if (states[slot].is_blocked || path.points.size() < 2 || boxes.empty() || boxes.size() > kMostBoxes) return false;
  return std::none_of(boxes.begin(), boxes.end(), [&](const ChangedBox& changed) {
    return may_lose_crossing(changed, boxes) && turns_in(path, changed.box);
  });
}

/// Returns whether a side of a removed item may have gone through a crossing at which a path turns. This is impossible
/// if the world had no crossing at the last update, and no box of an item inserted since then overlaps the box of the
/// removed item.
bool PathWatch::Impl::may_lose_crossing(const ChangedBox& changed, Boxes boxes) const {
  const auto may_cross = [&](const ChangedBox& other) { return other.is_insertion && other.box.overlaps(changed.box); };
  return changed.is_removal && (had_crossings || std::any_of(boxes.begin(), boxes.end(), may_cross));
}

/// Returns whether the path turns in the box, or less than rounding errors away from it.
bool PathWatch::Impl::turns_in(const Watched& path, const Box& box) {
  if (path.points.size() < 3) return false;
  return std::any_of(path.points.begin() + 1, path.points.end() - 1,
                     [&](const Point& p) { return box.expanded(slack_of(p, p)).contains(p); });
}

/// Returns whether a piece of the path may touch the box.
bool PathWatch::Impl::touches(const Watched& path, std::uint32_t piece, const Box& box) {
  const std::span<const Point> points = path.points;
  return path::may_touch(points.subspan(piece, std::min<std::size_t>(points.size(), 2)), 0.0, box);
}

/// Returns whether the path is clear. If it was clear before, it is enough to look at the stretches that a box touches.
bool PathWatch::Impl::is_clear(std::uint32_t slot, const World& world, Boxes boxes) {
  using StretchState = path::PolylineWalk::StretchState;
  const constraint::ConstrainedTriangulation& triangulation = world.impl_->triangulation();
  const std::span<const Point> points = watched[slot].points;
  cover_finder.use(world.impl_->layers.abstraction());
  const auto is_touched = [&](std::size_t i) {
    const auto touches = [&](const ChangedBox& box) { return path::may_touch(points.subspan(i, 2), 0.0, box.box); };
    return std::any_of(boxes.begin(), boxes.end(), touches);
  };
  bool is_sure = can_decide_by_stretches(slot, boxes);
  for (std::size_t first = 0; is_sure && first + 1 < points.size(); ++first) {
    if (!is_touched(first)) continue;
    std::size_t last = first + 1;
    while (last + 1 < points.size() && is_touched(last)) ++last;
    const StretchState state = walk.find_stretch_state(triangulation, cover_finder, points, first, last);
    if (state == StretchState::blocked) return false;
    is_sure = state == StretchState::clear;
    first = last;  // no box touches the segment after the stretch
  }
  return is_sure || walk.is_clear(triangulation, cover_finder, points);
}

// A removal blocks the path of a point agent only if the path turns at the rounded coordinates of a crossing that no
// longer exists. The removal of an item never blocks a disc. For most paths near a change, the function does not read
// the points.
void PathWatch::Impl::check_box(const ChangedBox& changed, const World& world, Boxes boxes, PathChanges& changes) {
  has_walls = false;
  const double slack = slack_of(domain.min, domain.max);
  const bool may_lose = may_lose_crossing(changed, boxes);
  const bool may_change = changed.is_insertion || may_lose || blocked_count != 0;
  const auto look_at = [&](const Piece& piece, const Box& around) {
    if (!may_touch_diagonal(around, piece.diagonal, changed.box, slack)) return;
    State& state = states[piece.slot];
    if (state.seen_by == updates) return;
    const Watched& path = watched[piece.slot];
    if (state.is_for_disc) {
      const std::span<const PathPiece> all = path.pieces;
      if (!changed.is_insertion || !path::may_touch(all.subspan(piece.index, 1), path.agent.radius, changed.box))
        return;
      state.seen_by = updates;
      return changes.may_be_blocked.push_back(piece.slot);
    }
    const bool is_checked = changed.is_insertion || state.is_blocked;
    if (!is_checked && !(may_lose && turns_in(path, changed.box))) return;
    if (piece.diagonal == Diagonal::none && !touches(path, piece.index, changed.box)) return;
    if (changed.is_insertion && !has_walls) collect_walls(world.impl_->triangulation(), changed.box);
    check(piece, around, world, boxes, changes);
  };
  if (may_change) pieces.for_each_overlapping(changed.box, look_at);
  if (!changed.is_removal) return;
  ellipses.for_each_overlapping(changed.box, [&](const EllipseOfPath& path, const Box&) {
    if (may_meet(path.ellipse, changed.box)) keys.mark(path.slot);
  });
}

void PathWatch::Impl::check_all(const World& world, PathChanges& changes) {
  has_walls = false;
  for (const auto& [key, slot] : slots) {
    if (watched[slot].has_ellipse) keys.mark(slot);
    if (states[slot].is_for_disc) {
      changes.may_be_blocked.push_back(slot);
    } else if (!watched[slot].points.empty()) {
      check({slot, 0, Diagonal::none}, {}, world, {}, changes);
    }
  }
}

/// Marks the keys of the paths that were not found and are possible now.
void PathWatch::Impl::check_refusals(const World& world, Boxes boxes, bool all) {
  if (refusals.is_empty() || (boxes.empty() && !all)) return;
  face_graph.reset();
  cell_graph.reset();
  const bool may_have_connected = connections_of(world) != connections;
  for (const std::uint32_t slot : refusals.list(boxes, all, may_have_connected)) {
    std::optional<Box> barrier;
    if (has_become_possible(slot, *world.impl_, barrier)) {
      refusals.set_possible(slot);
      keys.mark(slot);
    } else {
      const bool has_answer = refusals.refusal(slot).agent.radius > 0.0 && barrier;
      refusals.set_barrier(slot, barrier, has_answer && !answer.moved_start && !answer.moved_goal);
    }
  }
}

/// Returns whether the query of a path that was not found now finds a path. The answer is exact for point agents. For
/// discs it is true if a path exists. If the answer is false, `barrier` is the argument of Refusals::set_barrier(). For
/// a point agent in a world with an abstraction it is empty, because connections_of() says when the answer may change.
bool PathWatch::Impl::has_become_possible(std::uint32_t slot, const World::Impl& world, std::optional<Box>& barrier) {
  const Refusals::Refusal& refusal = refusals.refusal(slot);
  const QueryEnds& asked = refusal.ends;
  if (refusal.agent.radius > 0.0) {
    if (!world.layers.kept().has_bridges) return true;  // the path is not an answer of this world
    PathQuery query{
        .start = asked.start, .goal = asked.goal, .agent = refusal.agent, .end_tolerance = asked.end_tolerance};
    return can_disc_pass(query, refusals.fits_at_ends(slot), world, barrier);
  }
  moved_ends.set_start(world.triangulation(), world.layers.abstraction(), asked.start, asked.end_tolerance);
  if (asked.has_many_goals) moved_ends.move_blocked_start();
  const std::optional<PathStatus> known = moved_ends.find_status_without_search(asked.goal);
  if (known) return known == PathStatus::found;
  if (world.layers.kept().has_abstraction) return true;
  if (!face_graph)
    face_areas.begin(face_graph.emplace(world.triangulation()), world.triangulation().topology().face_slots());
  return are_in_one_area(barrier);
}

/// Returns whether a face at the start is connected with a face at the goal.
bool PathWatch::Impl::are_in_one_area(std::optional<Box>& barrier) {
  Box enclosed;
  for (const mesh::HalfEdge start : moved_ends.start_faces()) {
    for (const mesh::HalfEdge goal : moved_ends.goal_faces()) {
      if (face_areas.are_connected(start, goal, enclosed)) return true;
      if (!barrier) barrier = enclosed;
      barrier->expand(enclosed.min);
      barrier->expand(enclosed.max);
    }
  }
  return false;
}

/// Returns whether the disc fits at both ends, after the query has moved them, and can move from one to the other.
/// `fits` says that it is known to fit without a move.
bool PathWatch::Impl::can_disc_pass(PathQuery& query, bool fits, const World::Impl& world,
                                    std::optional<Box>& barrier) {
  const path::Ground ground = world.ground();
  path::reset(answer);
  if (!fits && !fit_finder.move_blocked_ends(ground, query, answer)) return false;
  const auto start = fit_finder.find_cell(ground, query.start);
  const auto goal = fit_finder.find_cell(ground, query.goal);
  if (!start || !goal) return true;
  if (!cell_graph || radius_of_cells != query.agent.radius) {
    radius_of_cells = query.agent.radius;
    cell_graph.emplace(*ground.walls, *ground.bridges, query.agent.radius);
    cell_areas.begin(*cell_graph, cell_graph->key_count());
  }
  Box enclosed;
  if (cell_areas.are_connected(*start, *goal, enclosed)) return true;
  // After each removal, the query may prefer another position for an end that it has moved.
  const bool has_moved = answer.moved_start || answer.moved_goal;
  barrier = has_moved ? domain : enclosed;
  return false;
}

PathWatch::PathWatch(const World& world) : impl_(std::make_unique<Impl>(world)) {
  WAYWRIGHT_ASSERT(!world.impl_->attempt, kInAttempt);
}
PathWatch::~PathWatch() = default;
PathWatch::PathWatch(PathWatch&&) noexcept = default;
PathWatch& PathWatch::operator=(PathWatch&&) noexcept = default;

void PathWatch::add(std::uint64_t key, const Path& path) {
  WAYWRIGHT_ASSERT(path.status != PathStatus::found || !path.points.empty() || !path.pieces.empty(),
                   "PathWatch::add: the path is found, but has no points: set ManyGoalsQuery::wants_points");
  const base::FloatEnvironment environment;
  Impl::Addition addition(*impl_);
  Impl::Watched& added = impl_->watched[addition.slot()];
  added.points = path.points;
  added.pieces = path.pieces;
  added.agent = path.agent;
  added.is_in_domain = std::all_of(path.points.begin(), path.points.end(),
                                   [&](const Point& p) { return is_point_of(impl_->domain, p); });
  impl_->states[addition.slot()] = {0, !path.pieces.empty(), false};
  impl_->add_boxes(addition.slot());
  const bool has_ends =
      path.ends && is_point_of(impl_->domain, path.ends->start) && is_point_of(impl_->domain, path.ends->goal);
  if (path.status != PathStatus::found && has_ends) {
    const double tolerance = path.ends->end_tolerance.value_or(path::default_end_tolerance(impl_->domain));
    impl_->refusals.add(addition.slot(), {*path.ends, path.agent}, tolerance);
  } else {
    const Ellipse ellipse = ellipse_of(path);
    added.ellipse = impl_->ellipses.insert(bounds_of(ellipse), {ellipse, addition.slot()});
    added.has_ellipse = true;
  }
  const auto [found, is_new] = impl_->slots.try_emplace(key, addition.slot());
  // Nothing can fail from here on.
  if (is_new) {
    impl_->keys.add(addition.slot(), key);
  } else {
    impl_->keys.move(found->second, addition.slot());
    impl_->drop(std::exchange(found->second, addition.slot()));
  }
  addition.keep();
}

bool PathWatch::remove(std::uint64_t key) {
  const auto found = impl_->slots.find(key);
  if (found == impl_->slots.end()) return false;
  impl_->keys.remove(found->second);
  impl_->drop(found->second);
  impl_->slots.erase(found);
  return true;
}

bool PathWatch::contains(std::uint64_t key) const { return impl_->slots.contains(key); }

std::size_t PathWatch::size() const { return impl_->slots.size(); }

void PathWatch::update(const World& world, PathChanges& changes) {
  WAYWRIGHT_ASSERT(!world.impl_->attempt, kInAttempt);
  const base::FloatEnvironment environment;
  Answer answer(changes);
  ++impl_->updates;
  impl_->keys.clear_marks();
  if (const auto boxes = world.changes_since(impl_->version)) {
    for (const ChangedBox& changed : *boxes) impl_->check_box(changed, world, *boxes, changes);
    impl_->check_refusals(world, *boxes, false);
  } else {
    impl_->check_all(world, changes);
    impl_->check_refusals(world, {}, true);
  }
  impl_->keys.take_marked(changes.may_be_too_long);
  impl_->keys.replace_by_keys(changes.blocked);
  impl_->keys.replace_by_keys(changes.may_be_blocked);
  answer.keep();
  impl_->version = world.version();
  impl_->had_crossings = Impl::has_crossings(world);
  impl_->connections = Impl::connections_of(world);
}

}  // namespace waywright
