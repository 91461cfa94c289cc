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
#include "constraint/box_flood.hpp"
#include "constraint/slot_sets.hpp"
#include "nav/kept_cover.hpp"
#include "path/pieces.hpp"
#include "path/polyline_walk.hpp"
#include "world/box_tree.hpp"
#include "world/ellipse_bucket.hpp"
#include "world/key_sort.hpp"
#include "world/point_error.hpp"
#include "world/world_impl.hpp"

namespace waywright {

namespace {

/// A long straight piece of a path has several boxes, so that the boxes contain few positions that are far from the
/// path. The width of each box is at most this share of the width of the domain, or its height is at most this share of
/// the height of the domain.
constexpr double kLargestShare = 0x1p-6;

double largest_coordinate(const Point& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

/// A bound of the rounding errors of positions, distances and boxes near `a` and `b`.
double slack_of(const Point& a, const Point& b) {
  return 0x1p-45 * std::max(largest_coordinate(a), largest_coordinate(b));
}

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

/// Returns true only if the two segments surely cross, also if each coordinate of their ends is wrong by a rounding
/// error: the ends of each one lie on different sides of the line of the other.
bool surely_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double slack = slack_of(a, b) + slack_of(c, d);
  const auto extent = [](const Point& p) { return std::abs(p.x) + std::abs(p.y); };
  const auto are_apart = [&](const Point& from, const Point& along, const Point& p, const Point& q) {
    const Point to_p = p - from;
    const Point to_q = q - from;
    const double error = 8.0 * slack * (extent(along) + extent(to_p) + extent(to_q) + slack);
    const double at_p = cross(along, to_p);
    const double at_q = cross(along, to_q);
    return std::min(at_p, at_q) < -error && std::max(at_p, at_q) > error;
  };
  return are_apart(a, b - a, c, d) && are_apart(c, d - c, a, b);
}

enum class Diagonal : std::uint8_t { none, rising, falling };

/// Returns false only if the box misses the diagonal of `around`, and all positions whose coordinates differ from it by
/// at most 2 `slack`. Requires: the boxes overlap. A watch calls it for hundreds of boxes of an update, because it
/// reads no path: the paths are rarely in the cache.
bool may_touch_diagonal(const Box& around, Diagonal diagonal, const Box& box, double slack) {
  if (diagonal == Diagonal::none) return true;
  const bool rises = diagonal == Diagonal::rising;
  const Point from{around.min.x, rises ? around.min.y : around.max.y};
  const Point along = Point{around.max.x, rises ? around.max.y : around.min.y} - from;
  const double extent = std::abs(along.x) + std::abs(along.y);
  const double error = extent * (8.0 * slack + 0x1p-48 * (extent + box.width() + box.height()));
  const auto [least, most] =
      std::minmax({cross(along, box.min - from), cross(along, box.max - from),
                   cross(along, Point{box.min.x, box.max.y} - from), cross(along, Point{box.max.x, box.min.y} - from)});
  return least <= error && most >= -error;
}

/// A box that contains the ellipse.
Box bounds_of(const Ellipse& ellipse) {
  constexpr double kBeyondAllDomains = 2 * kLargestCoordinate;
  if (ellipse.length > kBeyondAllDomains) {
    return {{-kBeyondAllDomains, -kBeyondAllDomains}, {kBeyondAllDomains, kBeyondAllDomains}};
  }
  // Half the extent of the ellipse in one axis, if the foci differ by `other` in the other axis.
  const auto half_extent = [&](double other) {
    return 0.5 * std::sqrt(std::max(ellipse.length - other, 0.0) * (ellipse.length + other));
  };
  const Point& start = ellipse.start;
  const Point& goal = ellipse.goal;
  const Point centre = 0.5 * (start + goal);
  const Point across{half_extent(std::abs(goal.y - start.y)), half_extent(std::abs(goal.x - start.x))};
  return Box{centre - across, centre + across}.expanded(ellipse.reach + slack_of(start, goal));
}

/// Returns the ellipse that contains each shorter path. If the search has moved an end, the ellipse also contains each
/// position that is nearer to the end in the query than the moved end is. Suppose that the search has moved the start
/// from `s` to `t`, by the distance d. If a position p is nearer to `s` than `t` is, then p is at most d away from `s`,
/// and at most d + d + length away from the goal. So the sum of the two distances is at most the length of the path
/// plus 3 d, and this is Ellipse::length.
Ellipse ellipse_of(const Path& path) {
  const bool has_points = !path.points.empty();
  if (path.status != PathStatus::found || (!has_points && path.pieces.empty())) return {};
  Ellipse ellipse;
  ellipse.start = has_points ? path.points.front() : path.pieces.front().from;
  ellipse.goal = has_points ? path.points.back() : path.pieces.back().to;
  double moved = 0.0;
  const auto move_back = [&](Point& end, const MovedEnd& moved_end) {
    moved += distance(moved_end.from, moved_end.to);
    end = moved_end.from;
  };
  if (path.moved_start) move_back(ellipse.start, *path.moved_start);
  if (path.moved_goal) move_back(ellipse.goal, *path.moved_goal);
  // The length is a sum of rounded lengths. The last term covers the rounding of up to 4 million turns.
  const double largest = std::max(largest_coordinate(ellipse.start), largest_coordinate(ellipse.goal));
  ellipse.length = path.length + 3.0 * moved + 0x1p-30 * (path.length + largest);
  ellipse.reach = path.radius * (1.0 + 0x1p-30);
  return ellipse;
}

}  // namespace

struct WAYWRIGHT_INTERNAL PathWatch::Impl {
  /// A segment of a path of a point agent, or a piece of a path of a disc.
  struct Part {
    std::uint32_t slot;
    std::uint32_t index;
    Diagonal diagonal;  ///< the part of the segment in a box of the tree is this diagonal of the box
  };
  using Parts = BoxTree<Part>;
  using Reaches = BoxTree<EllipseOfPath, EllipseBucket>;
  using Boxes = std::span<const ChangedBox>;
  using ExactTriangulation = constraint::ExactTriangulation;

  /// What an update needs to name a path that may be too long. Thousands of these fit into the cache.
  struct Named {
    std::uint64_t key = 0;
    std::uint64_t too_long_by = 0;  ///< the last update that has found that the path may be too long
  };
  struct Watched {
    std::uint64_t key = 0;
    std::vector<Point> points;
    std::vector<PathPiece> pieces;  ///< empty for a point agent
    double radius = 0.0;
    std::vector<Parts::Handle> boxes;  ///< handles in `parts`
    Reaches::Handle reach = 0;         ///< a handle in `reaches`
    bool has_reach = false;
    bool is_in_domain = false;  ///< whether all points are points of the domain
    bool is_blocked = false;    ///< whether the last check found it blocked; only for a point agent
    std::uint64_t seen_by = 0;  ///< the last update that has found a change on the path
  };

  explicit Impl(const World& world)
      : domain(world.domain()),
        version(world.version()),
        had_crossings(has_crossings(world)),
        parts(domain),
        reaches(domain) {}

  static bool has_crossings(const World& world) {
    return world.impl_->triangulation.triangulation().geometry().has_constructed();
  }

  /// The slot of a new path. If memory runs out while PathWatch::add() adds the path, the destructor removes the path
  /// again.
  class Addition {
   public:
    explicit Addition(Impl& impl) : impl_(impl) {
      if (impl_.free_slots.empty()) {
        // Room for all slots, so that drop() allocates nothing.
        const std::size_t needed = impl_.watched.size() + 1;
        if (impl_.free_slots.capacity() < needed) impl_.free_slots.reserve(2 * needed);
        if (impl_.named.size() < needed) impl_.named.resize(needed);
        impl_.watched.emplace_back();
        impl_.free_slots.push_back(static_cast<std::uint32_t>(impl_.watched.size() - 1));
      }
      slot_ = impl_.free_slots.back();
      impl_.free_slots.pop_back();
    }
    ~Addition() {
      if (!is_done_) impl_.drop(slot_);
    }
    Addition(const Addition&) = delete;
    Addition& operator=(const Addition&) = delete;

    [[nodiscard]] std::uint32_t slot() const { return slot_; }
    void done() { is_done_ = true; }

   private:
    Impl& impl_;
    std::uint32_t slot_ = 0;
    bool is_done_ = false;
  };

  void add_boxes(std::uint32_t slot);
  void add_box(const Part& part, const Box& box);
  void drop(std::uint32_t slot) noexcept;
  void check(const Part& part, const World& world, Boxes boxes, PathChanges& changes);
  void collect_walls(const ExactTriangulation& triangulation, const Box& box);
  [[nodiscard]] bool crosses_wall(std::span<const Point> points) const;
  [[nodiscard]] bool may_lose_crossing(const Watched& path, const ChangedBox& changed, Boxes boxes) const;
  [[nodiscard]] static bool turns_in(const Watched& path, const Box& box);
  [[nodiscard]] bool has_easy_pieces(const Watched& path, Boxes boxes) const;
  [[nodiscard]] bool is_clear(const Watched& path, const World& world, Boxes boxes);
  void check_box(const ChangedBox& changed, const World& world, Boxes boxes, PathChanges& changes);
  void check_all(const World& world, PathChanges& changes);

  Box domain;
  std::uint64_t version;  ///< of the world at the last update
  bool had_crossings;     ///< whether the world had crossings at the last update, or before it
  std::uint64_t updates = 0;
  Parts parts;
  Reaches reaches;  ///< by the bounding boxes of the ellipses
  std::vector<Watched> watched;
  std::vector<Named> named;  ///< by slot
  std::vector<std::uint32_t> free_slots;
  std::unordered_map<std::uint64_t, std::uint32_t> slots;  ///< by key
  std::vector<std::array<Point, 2>> walls;  ///< some walls that meet the box that check_box() is looking at
  bool has_walls = false;                   ///< whether `walls` is up to date
  constraint::SlotSet reached;
  std::vector<mesh::HalfEdge> faces;
  nav::KeptCover cover;
  path::PolylineWalk walk;
  std::vector<std::uint64_t> sort_scratch;
};

void PathWatch::Impl::add_box(const Part& part, const Box& box) {
  std::vector<Parts::Handle>& boxes = watched[part.slot].boxes;
  if (boxes.size() == boxes.capacity()) boxes.reserve(2 * boxes.size() + 4);
  boxes.push_back(parts.insert(box, part));
}

/// Adds the boxes of all parts of a path.
void PathWatch::Impl::add_boxes(std::uint32_t slot) {
  const Watched& path = watched[slot];
  Part part{slot, 0, Diagonal::none};
  const auto add = [&](const Box& box) { add_box(part, box); };
  if (path.pieces.empty()) {
    if (path.points.size() == 1) for_each_box_of_line(path.points[0], path.points[0], 0.0, domain, add);
    for (; part.index + 1 < path.points.size(); ++part.index) {
      const Point& from = path.points[part.index];
      const Point& to = path.points[part.index + 1];
      const bool rises = (from.x <= to.x) == (from.y <= to.y);
      if (path.is_in_domain) part.diagonal = rises ? Diagonal::rising : Diagonal::falling;
      for_each_box_of_line(from, to, 0.0, domain, add);
    }
    return;
  }
  for (const PathPiece& piece : path.pieces) {
    const double reach = path.radius * (1.0 + 0x1p-40);
    if (piece.kind == PathPiece::Kind::line) {
      for_each_box_of_line(piece.from, piece.to, reach, domain, add);
    } else {
      for_each_box_of_line(piece.centre, piece.centre, reach + piece.radius * (1.0 + 0x1p-40), domain, add);
    }
    ++part.index;
  }
}

/// Frees a slot and removes its boxes. Keeps the memory of its lists.
void PathWatch::Impl::drop(std::uint32_t slot) noexcept {
  Watched& path = watched[slot];
  for (const Parts::Handle box : path.boxes) parts.remove(box);
  if (path.has_reach) reaches.remove(path.reach);
  path.has_reach = false;
  path.boxes.clear();
  path.points.clear();
  path.pieces.clear();
  free_slots.push_back(slot);
}

/// Checks a path of a point agent, if a changed box may lie near this part of the path. Adds the path to `changes` if
/// it is blocked. `boxes` are all boxes that have changed, or empty if they are not known. A path that surely crosses a
/// wall is blocked. This is true of most blocked paths, and costs less than a walk along the path.
void PathWatch::Impl::check(const Part& part, const World& world, Boxes boxes, PathChanges& changes) {
  Watched& path = watched[part.slot];
  if (std::exchange(path.seen_by, updates) == updates) return;
  const std::span<const Point> points = path.points;
  const bool is_across = part.index + 1 < points.size() && crosses_wall(points.subspan(part.index, 2));
  path.is_blocked = !path.is_in_domain || is_across || !is_clear(path, world, boxes);
  if (path.is_blocked) changes.blocked.push_back(path.key);
}

/// Sets `walls` to walls that meet the box: to all of them, if the box meets few faces.
void PathWatch::Impl::collect_walls(const ExactTriangulation& triangulation, const Box& box) {
  constexpr std::size_t kMostFaces = 64;
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const mesh::TriangleMesh& mesh = triangulation.topology();
  walls.clear();
  reached.clear();
  has_walls = true;
  std::size_t count = 0;
  const auto reach = [&](mesh::Face f) {
    if (count == kMostFaces || !reached.insert(number(f))) return false;
    ++count;
    return true;
  };
  constraint::faces_at(triangulation, triangulation.triangulation().locate(box.min), faces);
  const mesh::HalfEdge start = faces.front();
  constraint::flood_box(
      triangulation, constraint::BoxTest(box), start, faces, reach, [&](mesh::HalfEdge h, bool meets) {
        if (!meets || !mesh.is_fixed(h) || mesh.twin(h) < h) return;
        walls.push_back({geometry.rounded(number(mesh.origin(h))), geometry.rounded(number(mesh.target(h)))});
      });
}

bool PathWatch::Impl::crosses_wall(std::span<const Point> points) const {
  const auto is_crossed = [&](const auto& wall) { return surely_cross(points[0], points[1], wall[0], wall[1]); };
  return has_walls && std::any_of(walls.begin(), walls.end(), is_crossed);
}

/// Returns whether PolylineWalk::find_piece_state() can decide about the pieces of a path that the boxes touch. It
/// cannot decide if an operation has removed an item where the path turns, because the turn may have been at a crossing
/// that no longer exists.
bool PathWatch::Impl::has_easy_pieces(const Watched& path, Boxes boxes) const {
  constexpr std::size_t kMostBoxes = 8;
  if (path.is_blocked || path.points.size() < 2 || boxes.empty() || boxes.size() > kMostBoxes) return false;
  return std::none_of(boxes.begin(), boxes.end(),
                      [&](const ChangedBox& changed) { return may_lose_crossing(path, changed, boxes); });
}

/// Returns whether a removed item may have been a side of a crossing for which a point of the path stands. The world
/// had no such crossing if it had none at the last update, and no item inserted since then meets the box of the removed
/// item.
bool PathWatch::Impl::may_lose_crossing(const Watched& path, const ChangedBox& changed, Boxes boxes) const {
  if (!changed.is_removal || !turns_in(path, changed.box)) return false;
  const auto may_cross = [&](const ChangedBox& other) { return other.is_insertion && other.box.overlaps(changed.box); };
  return had_crossings || std::any_of(boxes.begin(), boxes.end(), may_cross);
}

/// Returns whether the path turns in the box, or less than rounding errors away from it.
bool PathWatch::Impl::turns_in(const Watched& path, const Box& box) {
  if (path.points.size() < 3) return false;
  return std::any_of(path.points.begin() + 1, path.points.end() - 1,
                     [&](const Point& p) { return box.expanded(slack_of(p, p)).contains(p); });
}

/// Returns whether the path is clear. If it was clear before, it is enough to look at the pieces that a box touches.
bool PathWatch::Impl::is_clear(const Watched& path, const World& world, Boxes boxes) {
  using PieceState = path::PolylineWalk::PieceState;
  const constraint::ExactTriangulation& triangulation = world.impl_->triangulation;
  const std::span<const Point> points = path.points;
  cover.use(world.impl_->kept_abstraction());
  const auto is_touched = [&](std::size_t i) {
    const auto touches = [&](const ChangedBox& box) { return path::may_touch(points.subspan(i, 2), box.box); };
    return std::any_of(boxes.begin(), boxes.end(), touches);
  };
  bool is_sure = has_easy_pieces(path, boxes);
  for (std::size_t first = 0; is_sure && first + 1 < points.size(); ++first) {
    if (!is_touched(first)) continue;
    std::size_t last = first + 1;
    while (last + 1 < points.size() && is_touched(last)) ++last;
    const PieceState state = walk.find_piece_state(triangulation, cover, points, first, last);
    if (state == PieceState::blocked) return false;
    is_sure = state == PieceState::clear;
    first = last;  // the segment after the piece is not touched
  }
  return is_sure || walk.is_clear(triangulation, cover, points);
}

// A removal blocks the path of a point agent only if the path turns at the rounded coordinates of a crossing that no
// longer exists. The removal of an item never blocks a disc.
void PathWatch::Impl::check_box(const ChangedBox& changed, const World& world, Boxes boxes, PathChanges& changes) {
  has_walls = false;
  const double slack = slack_of(domain.min, domain.max);
  parts.for_each_overlapping(changed.box, [&](const Part& part, const Box& around) {
    if (!may_touch_diagonal(around, part.diagonal, changed.box, slack)) return;
    Watched& path = watched[part.slot];
    if (path.seen_by == updates) return;
    if (path.pieces.empty()) {
      const std::span<const Point> points = path.points;
      if (!path::may_touch(points.subspan(part.index, std::min<std::size_t>(points.size(), 2)), changed.box)) return;
      if (!changed.is_insertion && !path.is_blocked && !may_lose_crossing(path, changed, boxes)) return;
      if (changed.is_insertion && !has_walls) collect_walls(world.impl_->triangulation, changed.box);
      return check(part, world, boxes, changes);
    }
    const std::span<const PathPiece> pieces = path.pieces;
    if (!changed.is_insertion || !path::may_touch(pieces.subspan(part.index, 1), path.radius, changed.box)) return;
    path.seen_by = updates;
    changes.may_be_blocked.push_back(path.key);
  });
  if (!changed.is_removal) return;
  reaches.for_each_overlapping(changed.box, [&](std::uint32_t slot) {
    if (std::exchange(named[slot].too_long_by, updates) == updates) return;
    changes.may_be_too_long.push_back(named[slot].key);
  });
}

void PathWatch::Impl::check_all(const World& world, PathChanges& changes) {
  has_walls = false;
  for (const auto& [key, slot] : slots) {
    changes.may_be_too_long.push_back(key);
    if (!watched[slot].pieces.empty()) {
      changes.may_be_blocked.push_back(key);
    } else if (!watched[slot].points.empty()) {
      check({slot, 0, Diagonal::none}, world, {}, changes);
    }
  }
}

PathWatch::PathWatch(const World& world) : impl_(std::make_unique<Impl>(world)) {}
PathWatch::~PathWatch() = default;
PathWatch::PathWatch(PathWatch&&) noexcept = default;
PathWatch& PathWatch::operator=(PathWatch&&) noexcept = default;

void PathWatch::add(std::uint64_t key, const Path& path) {
  const base::FloatEnvironment environment;
  Impl::Addition addition(*impl_);
  Impl::Watched& added = impl_->watched[addition.slot()];
  added.key = key;
  added.points = path.points;
  added.pieces = path.pieces;
  added.radius = path.radius;
  added.seen_by = 0;
  added.is_in_domain = std::all_of(path.points.begin(), path.points.end(),
                                   [&](const Point& p) { return is_point_of(impl_->domain, p); });
  added.is_blocked = false;
  impl_->named[addition.slot()] = {key, 0};
  impl_->add_boxes(addition.slot());
  const Ellipse ellipse = ellipse_of(path);
  added.reach = impl_->reaches.insert(bounds_of(ellipse), {ellipse, addition.slot()});
  added.has_reach = true;
  const auto [found, is_new] = impl_->slots.try_emplace(key, addition.slot());
  // Nothing can fail from here on.
  if (!is_new) impl_->drop(std::exchange(found->second, addition.slot()));
  addition.done();
}

bool PathWatch::remove(std::uint64_t key) {
  const auto found = impl_->slots.find(key);
  if (found == impl_->slots.end()) return false;
  impl_->drop(found->second);
  impl_->slots.erase(found);
  return true;
}

bool PathWatch::contains(std::uint64_t key) const { return impl_->slots.contains(key); }

std::size_t PathWatch::size() const { return impl_->slots.size(); }

void PathWatch::update(const World& world, PathChanges& changes) {
  const base::FloatEnvironment environment;
  changes.blocked.clear();
  changes.may_be_blocked.clear();
  changes.may_be_too_long.clear();
  ++impl_->updates;
  if (const auto boxes = world.changes_since(impl_->version)) {
    for (const ChangedBox& changed : *boxes) impl_->check_box(changed, world, *boxes, changes);
  } else {
    impl_->check_all(world, changes);
  }
  sort_keys(changes.blocked, impl_->sort_scratch);
  sort_keys(changes.may_be_blocked, impl_->sort_scratch);
  sort_keys(changes.may_be_too_long, impl_->sort_scratch);
  impl_->version = world.version();
  impl_->had_crossings = Impl::has_crossings(world);
}

}  // namespace waywright
