#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/job_system.hpp"
#include "waywright/memory_use.hpp"
#include "waywright/mesh_snapshot.hpp"
#include "waywright/owned.hpp"
#include "waywright/path.hpp"
#include "waywright/point.hpp"
#include "waywright/query_context.hpp"
#include "waywright/ray.hpp"

namespace waywright {

/// One of several changes that World::apply makes together.
struct Change {
  enum class Kind : std::uint8_t { insert, remove, replace };

  Kind kind = Kind::insert;
  ItemId id;    ///< of an insertion: null for one that the world hands out
  Shape shape;  ///< of an insertion or replacement

  [[nodiscard]] static Change insert(Shape shape, ItemId id = {}) { return {Kind::insert, id, std::move(shape)}; }
  [[nodiscard]] static Change remove(ItemId id) { return {Kind::remove, id, {}}; }
  [[nodiscard]] static Change replace(ItemId id, Shape shape) { return {Kind::replace, id, std::move(shape)}; }
};

/// How to insert many items at once.
struct BulkOptions {
  /// So many threads work on it, 1 or more; the calling one is among them. The world is the same with any number. More
  /// than one speeds up a world's first items. Of a job system, so many jobs at a time.
  std::size_t threads = 1;
  /// Called on the calling thread now and then, and at the end, where `done` is `total`; the unit means nothing. It
  /// must not touch the world.
  std::function<void(std::size_t done, std::size_t total)> progress;
  /// Where the other threads come from. Null: the library starts them.
  JobSystem* jobs = nullptr;
};

/// Two hashes of the same items, whatever made them and wherever: equal when the items are, and in practice only then.
/// docs/hashes.md defines both, for others to compute.
struct ItemsHash {
  std::array<std::uint64_t, 2> words{};

  friend bool operator==(const ItemsHash&, const ItemsHash&) = default;
};
struct MeshHash {
  std::array<std::uint8_t, 32> bytes{};

  friend bool operator==(const MeshHash&, const MeshHash&) = default;
};

/// 32 and 64 hexadecimal digits.
[[nodiscard]] WAYWRIGHT_API std::string to_string(const ItemsHash& hash);
[[nodiscard]] WAYWRIGHT_API std::string to_string(const MeshHash& hash);

/// Where a point lies in the mesh.
enum class Place : std::uint8_t { vertex, edge, face };

/// The word the world script prints: `vertex`, `edge`, `face`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(Place place);

/// The answer to World::locate.
struct Location {
  Place at = Place::face;
  /// The corners of the vertex, edge or face (1, 2 or 3 of them), as nearest doubles; a face counter-clockwise. Edge
  /// and face start from the corner that comes first in (x, y) order.
  std::array<Point, 3> corners{};
  std::size_t corner_count = 0;
  /// The polygons that cover the point, their boundary included; ascending.
  std::vector<ItemId> inside;
};

/// What World::validate found.
struct Validation {
  bool ok = true;
  std::string fault;  ///< the first fault; empty when ok
};

/// What a world keeps besides its mesh.
struct WorldOptions {
  /// What searches for paths live on: which faces are joined, by which polygons they are covered, which lie in dead
  /// ends. Without it an operation is cheaper and a world takes 10 bytes less for each vertex, up to 18 where walls
  /// change everywhere, but many a query looks at far more of the mesh, and PathAlgorithm::tra is not supported.
  bool keep_abstraction = true;
};

/// A world of obstacles that changes while agents find their way through it: a dynamic constrained Delaunay
/// triangulation of a closed box, exact in every decision. The live items alone fix the mesh, in whatever order they
/// came. Geometry is never an error: crossing, overlapping, duplicate, collinear, zero-length and self-crossing items
/// are all accepted and handled exactly.
///
/// Each query has two forms. One returns its answer in a new object. The other fills an object that you keep, works in
/// a QueryContext that you keep, and allocates nothing once both have served for an answer as large.
///
/// Threads: const members may run at once, each call with its own QueryContext; no other member meanwhile. A world that
/// has been moved from may only be assigned to or destroyed.
/// Source: Chen, *Robust Dynamic Constrained Delaunay Triangulation for Pathfinding*, University of Alberta, 2009.
class WAYWRIGHT_API World {
 public:
  /// An empty world over the closed box `domain`: four vertices, two triangles, four constrained edges of id 0.
  /// Errors: coordinate_range, bad_domain. Cost: O(1).
  [[nodiscard]] static Result<World> create(const Box& domain, const WorldOptions& options = {});

  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  [[nodiscard]] const Box& domain() const;

  /// Inserts a shape under `id`, or, when `id` is null, under one more than the largest id this world has seen. Returns
  /// the id. Either the whole shape is inserted or, on an error, nothing has changed.
  /// Errors: coordinate_range, out_of_domain, id_in_use, bad_id, empty_shape, too_large. The error's index counts the
  /// shape's points from 0, over all rings.
  /// Cost: per point, its location; per side, what it crosses.
  /// Source: Chen 2009, sections 3.2 (vertices), 3.3 (constraints), 3.5 (polygons).
  Result<ItemId> insert(const Shape& shape, ItemId id = {});

  // The same for each kind of shape. What comes back, errors and cost are those of insert.

  /// A vertex that stays as long as the item lives; no wall.
  Result<ItemId> insert_point(Point point, ItemId id = {});
  /// A wall from `a` to `b`; of length zero it acts as a point.
  Result<ItemId> insert_segment(Point a, Point b, ItemId id = {});
  /// An open chain of walls through one point or more.
  Result<ItemId> insert_polyline(PointSpan points, ItemId id = {});
  /// A solid obstacle of one closed ring or several: `world.insert_polygon({{2, 2}, {4, 2}, {4, 4}})`. The side from a
  /// ring's last point to its first is implied. The fill rule is even_odd: a ring in a ring is a hole.
  Result<ItemId> insert_polygon(Rings rings, ItemId id = {});

  /// Takes an item out. What remains is, bit for bit, the mesh that a fresh build of the remaining items gives.
  /// Errors: unknown_id, bad_id. Cost: what the item touches, however large the world.
  /// Source: Chen 2009, sections 3.4 and 3.5.
  Result<void> remove(ItemId id);

  /// Puts another shape in an item's place, under its id: what moves an obstacle. Either done or, on an error, nothing
  /// has changed. Errors: unknown_id, and those of insert. Cost: that of remove, and that of insert.
  Result<void> replace(ItemId id, const Shape& shape);

  /// Inserts many items as one operation: all of them or, on an error, none. Returns the id of each. Much faster than
  /// one by one, above all into a world without items. Errors: those of insert; the error's index is the item's
  /// position. Cost: O(n log n), and what the items' sides cross. Source: Guibas and Stolfi 1985, Dwyer 1987 (the
  /// corners of a world's first items).
  Result<std::vector<ItemId>> insert_all(std::span<const Item> items, const BulkOptions& options = {});

  /// The same for points alone, under `first` and one more each, or, when `first` is null, under ids handed out.
  /// Returns the first's id. Errors: those of insert; the error's index is the point's position.
  Result<ItemId> insert_points(PointSpan points, ItemId first = {}, const BulkOptions& options = {});

  /// Makes several changes, one after the other, as one operation: all of them or, on an error, none. Returns the id of
  /// each change's item. Errors: those of the single changes; the error's index is the change's position. Cost: a run
  /// of insertions is as fast as insert_all.
  Result<std::vector<ItemId>> apply(std::span<const Change> changes);
  /// The same for changes in braces: `world.apply({Change::remove(7), Change::insert(shape, 8)})`.
  Result<std::vector<ItemId>> apply(std::initializer_list<Change> changes) {
    return apply(std::span<const Change>(std::data(changes), changes.size()));
  }

  /// Whether an item of that id is alive. Cost: O(1).
  [[nodiscard]] bool contains(ItemId id) const;
  /// The number of live items. Cost: O(1).
  [[nodiscard]] std::size_t item_count() const;
  /// The ids of all live items, ascending. Cost: O(n log n).
  [[nodiscard]] std::vector<ItemId> item_ids() const;
  void item_ids(std::vector<ItemId>& ids) const;
  /// The item's shape as it was inserted, points that repeat their predecessor merged; a copy. Errors: unknown_id.
  /// Cost: linear in its points.
  [[nodiscard]] Result<Shape> shape(ItemId id) const;
  [[nodiscard]] Result<void> shape(ItemId id, Shape& shape) const;

  /// All live items, ascending by id, as shape() gives them. Another world over the same domain that is given them (by
  /// insert_all) is the same in all but the ids that it hands out, which count on from the largest each has seen.
  /// Cost: O(n log n), and their points.
  [[nodiscard]] std::vector<Item> items() const;
  void items(QueryContext& context, std::vector<Item>& items) const;

  /// The vertices of the mesh: the domain's corners, the items', and the crossings. Cost: O(1).
  [[nodiscard]] std::size_t vertex_count() const;
  /// The triangles of the mesh. Cost: linear in the vertices on the domain's border.
  [[nodiscard]] std::size_t triangle_count() const;

  /// Where `point` lies, and in which polygons. Errors: coordinate_range, out_of_domain. Cost: a walk over a few
  /// triangles, however large the world, and the answer; no memory, once `context` and `location` have been used.
  /// Source: the remembering stochastic walk, Chen 2009, section 3.2.1.
  [[nodiscard]] Result<void> locate(Point point, QueryContext& context, Location& location) const;
  [[nodiscard]] Result<Location> locate(Point point) const;

  /// The items that cover the point, or have a side or corner there; ascending. Errors: coordinate_range,
  /// out_of_domain. Cost: that of locate.
  [[nodiscard]] Result<void> items_at(Point point, QueryContext& context, std::vector<ItemId>& items) const;
  [[nodiscard]] Result<std::vector<ItemId>> items_at(Point point) const;
  /// The items whose sides the segment meets, in order, and where. One that it runs along is told of where that begins;
  /// items met in one place come by ascending id. Errors: coordinate_range, out_of_domain. Cost: the location of
  /// `from`, and the triangles that the segment crosses.
  [[nodiscard]] Result<void> items_crossed(Point from, Point to, QueryContext& context,
                                           std::vector<CrossedItem>& items) const;
  [[nodiscard]] Result<std::vector<CrossedItem>> items_crossed(Point from, Point to) const;
  /// The first wall that the segment touches on its way from `from`, the domain's border included; a start on a wall
  /// touches it. Decided exactly, also where walls meet or the segment runs through a wall's end.
  /// Errors: coordinate_range, out_of_domain. Cost: the location of `from`, and the faces that the segment crosses
  /// before it hits; no memory, once `hit` has been used.
  [[nodiscard]] Result<void> ray(Point from, Point to, RayHit& hit) const;
  [[nodiscard]] Result<RayHit> ray(Point from, Point to) const;
  /// The items that have a point in common with the closed box, which may reach beyond the domain; ascending.
  /// Errors: coordinate_range, bad_domain (where min is beyond max). Cost: the location of a corner, and the triangles
  /// that meet the box.
  [[nodiscard]] Result<void> items_in(const Box& box, QueryContext& context, std::vector<ItemId>& items) const;
  [[nodiscard]] Result<std::vector<ItemId>> items_in(const Box& box) const;

  /// A path from start to goal that never passes a wall nor a point where walls meet; it may touch both. An end
  /// that polygons cover on all sides, so that no way leads from there, is moved if a free place is no farther than
  /// PathQuery::end_tolerance:
  /// to the nearest free place, among those that are joined with the other end if the world keeps its abstraction and
  /// there are any. If walls part the ends, an end that lies beside a wall by no more than rounding
  /// (default_end_tolerance() at most) is moved to its other side, if this joins the ends; this, too, takes a world
  /// that keeps its abstraction. The answer says so (Path::moved_start, Path::moved_goal). Errors: coordinate_range,
  /// out_of_domain, bad_radius, bad_distance, not_supported. Cost: the location of the ends, and the triangles searched
  /// (Path::expansions); no memory, once `context` and `path` have been used for a search as large. Where walls part
  /// the ends no triangle is, if the world keeps its abstraction. Source: Cui, Harabor and Grastien, *Compromise-free
  /// pathfinding on a navigation mesh*, IJCAI 2017 (`optimal`); Demyen and Buro, *Efficient triangulation-based
  /// pathfinding*, AAAI 2006 (`ta`). ARCHITECTURE.md says where we depart from them.
  [[nodiscard]] Result<void> find_path(const PathQuery& query, QueryContext& context, Path& path) const;
  [[nodiscard]] Result<Path> find_path(const PathQuery& query) const;

  /// A path for each query, in their order and each as find_path gives it, found by as many threads as there are
  /// contexts: threads of the job system, or, where that is null, threads that the library starts. Requires: at least
  /// one context. Errors: those of find_path; the error's index is the query's position.
  [[nodiscard]] Result<void> find_paths(std::span<const PathQuery> queries, std::span<QueryContext> contexts,
                                        std::vector<Path>& paths, JobSystem* jobs = nullptr) const;
  /// Requires: `threads` is 1 or more.
  [[nodiscard]] Result<std::vector<Path>> find_paths(std::span<const PathQuery> queries, std::size_t threads,
                                                     JobSystem* jobs = nullptr) const;

  /// The shortest path to each goal, in their order. The expansions of all searches stand in every answer. Errors:
  /// those of find_path; the error's index is 0 for the start and else the goal's position + 1. Cost: of a few goals
  /// that of as many paths; from some hundreds on, one search from the start outwards finds them all, which costs what
  /// lies nearer than the farthest goal, and a little for each.
  [[nodiscard]] Result<void> find_paths_from(const ManyGoalsQuery& query, QueryContext& context,
                                             std::vector<Path>& paths) const;
  [[nodiscard]] Result<std::vector<Path>> find_paths_from(const ManyGoalsQuery& query) const;

  /// How far a path query may move a blocked end if it does not say: 2^-20, about a millionth, of the largest
  /// coordinate of the domain. It allows for places computed in steps of `float` arithmetic. In a domain that is much
  /// larger than what it holds, give queries a tolerance of their own. Cost: none.
  [[nodiscard]] double default_end_tolerance() const;

  /// Whether a point agent can walk along a polyline: the question that find_path answers with such a polyline. It may
  /// touch walls and vertices and may run along walls; it must not pass through a wall, the inside of a polygon, or a
  /// point where walls meet. Decided exactly. A corner whose coordinates are those of a crossing of walls, rounded,
  /// stands for that crossing, too, because paths name crossings so. False if there are no points. Errors:
  /// coordinate_range, out_of_domain; the error's index is the point's position. Cost: the location of the first point,
  /// and the triangles that the polyline crosses; no memory, once `context` has been used for a polyline as long.
  ///
  ///     if (!world.is_clear(unit.path.points).value()) unit.path = world.find_path(unit.query).value();
  [[nodiscard]] Result<bool> is_clear(std::span<const Point> points, QueryContext& context) const;
  [[nodiscard]] Result<bool> is_clear(std::span<const Point> points) const;
  /// The same of the straight way between two places: whether the agent can go it. In contrast to ray(), a touch is no
  /// hit.
  [[nodiscard]] Result<bool> is_clear(const Point& from, const Point& to, QueryContext& context) const;
  [[nodiscard]] Result<bool> is_clear(const Point& from, const Point& to) const;

  /// Whether a polyline meets the bounding box of a segment, polyline or polygon that an operation after version
  /// `since` has inserted, removed or replaced. If not, the polyline is as clear as it was then. Also true if the world
  /// does not know: it keeps the boxes of at least the last 2,048 such items, and one box for the items of an operation
  /// beyond 256. Cost: the boxes times the points, a few comparisons each; no memory.
  ///
  ///     const std::uint64_t before = world.version();
  ///     world.insert(building).value();
  ///     for (Unit& unit : units) {
  ///       if (world.is_affected(unit.path.points, before) && !world.is_clear(unit.path.points).value()) replan(unit);
  ///     }
  [[nodiscard]] bool is_affected(std::span<const Point> points, std::uint64_t since) const;
  /// Which of many paths is_affected() is true of: their positions, ascending.
  void find_affected(std::span<const Path> paths, std::uint64_t since, std::vector<std::size_t>& affected) const;

  /// Goes up by one with every operation that is carried out, and with no other. Cost: none.
  [[nodiscard]] std::uint64_t version() const;

  /// The memory that the world holds, by what it is for. It does not count what the allocator adds to each piece, nor
  /// the context that the world keeps once a query without a context has been made: about 16 bytes for each face, as
  /// much as a QueryContext of yours. Cost: O(1).
  [[nodiscard]] MemoryUse memory() const;
  /// Gives back most of the memory that memory() calls spare, and the world's own context for queries. Call it if
  /// memory is short, after a level has been loaded or many items have been removed. The next operations allocate their
  /// scratch again. No answer and no hash depends on it. Cost: linear in the mesh; for a moment, the memory of one more
  /// array.
  void shrink_to_fit();

  /// Checks everything there is to check, exactly: links, orientation, cover, constrained edges against the items, the
  /// empty circle and its ties on every free edge, what is kept for paths against a rebuild. Cost: linear in the mesh,
  /// with exact arithmetic throughout.
  [[nodiscard]] Validation validate() const;

  /// The mesh in canonical order. Cost: O(n log n).
  [[nodiscard]] MeshSnapshot snapshot() const;
  void snapshot(QueryContext& context, MeshSnapshot& snapshot) const;
  /// The hash of the domain and the live items, kept up by every operation. Cost: none.
  [[nodiscard]] ItemsHash items_hash() const;
  /// The SHA-256 of the dump's bytes. Cost: the dump's.
  [[nodiscard]] MeshHash mesh_hash() const;

  /// The mesh as canonical text with exact rational coordinates: equal for equal sets of live items.
  [[nodiscard]] std::string dump() const;

 private:
  friend class PathSearch;
  struct Impl;
  class Operation;
  explicit World(std::unique_ptr<Impl> impl);
  detail::Owned<Impl, detail::kMovedWorld> impl_;
};

}  // namespace waywright
