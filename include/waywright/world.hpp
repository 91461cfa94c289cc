#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "waywright/agent.hpp"
#include "waywright/change.hpp"
#include "waywright/clearance.hpp"
#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/hashes.hpp"
#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/job_system.hpp"
#include "waywright/location.hpp"
#include "waywright/memory_use.hpp"
#include "waywright/mesh_snapshot.hpp"
#include "waywright/owned.hpp"
#include "waywright/path.hpp"
#include "waywright/point.hpp"
#include "waywright/query_context.hpp"
#include "waywright/world_options.hpp"
#include "waywright/world_snapshot.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// A world of obstacles that can change between path queries: a dynamic constrained Delaunay triangulation of a closed
/// box. Every decision about the mesh is exact. The domain and the live items alone determine the mesh, in whatever
/// order you inserted the items. No arrangement of items is an error: items may cross, overlap or repeat each other,
/// cross themselves, be collinear or have length zero. The world handles all of this exactly.
///
/// @code{.cpp}
/// World arena = World::create({{0, 0}, {10, 10}}).value();
/// arena.insert_segment({4, 0}, {4, 7}).value();
/// const Path detour = arena.find_path({.start = {1, 1}, .goal = {7, 1}}).value();
/// const std::size_t count = detour.points.size();  // == 3
/// const World copy = arena.clone();
/// arena.insert_segment({2, 4}, {8, 4}).value();
/// const std::size_t before = copy.item_count();  // == 1
/// @endcode
///
/// Most queries have two forms: see QueryContext. If you move a world to another object, you may only assign to the
/// first object or destroy it.
/// Threads: several threads may call const members at once, without a context or each with its own QueryContext. While
/// a thread calls a member that is not const, no other thread may call any member.
/// Exceptions: std::bad_alloc, if memory runs out. An operation then changes nothing.
/// Source: Chen, *Robust Dynamic Constrained Delaunay Triangulation for Pathfinding*, University of Alberta, 2009.
class WAYWRIGHT_API World {
 public:
  /// @name Making a world
  /// You need this group at the start of your program or level, and to copy a world.
  /// @{

  /// Returns an empty world over `domain`: four vertices, two triangles, and four constrained edges with the id 0.
  /// Errors: coordinate_range, bad_domain.
  /// Cost: O(1).
  [[nodiscard]] static Result<World> create(const Box& domain, const WorldOptions& options = {});

  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// Returns an independent copy of the world, with the same domain, options, items, mesh, hashes, version() and
  /// history. It chooses the same ids for later items and gives the same answers. Its memory has no spare capacity. The
  /// copy has no searches (PathSearch), and no context for queries yet. If memory runs out, this world does not change.
  /// Requires: attempt() is not asking a question about this world.
  /// Cost: a copy of memory().total() bytes at most. The function computes no geometry.
  [[nodiscard]] World clone() const;

  /// Returns the domain of the world: its closed box.
  [[nodiscard]] const Box& domain() const;
  /// Returns the options of create(), with the present new_vertex_limit(). Cost: O(1).
  [[nodiscard]] WorldOptions options() const;

  /// @}

  /// @name Changing items
  /// You need this group when an obstacle appears, disappears or moves. Each call is one operation: the world carries
  /// it out completely or, on an error, changes nothing. Item has an example.
  /// @{

  /// Inserts a shape under `id`. If `id` is null, the world chooses the id: the largest id that it has seen, plus 1.
  /// Returns the id. If the function refuses a point, Error::index is the index of this point in the shape, counted
  /// from 0 over all rings.
  /// Errors: coordinate_range, out_of_domain, id_in_use, bad_id, bad_shape, too_large, too_many_vertices.
  /// Cost: for each point, its point location; for each side, the triangles that it crosses; the triangles that change;
  /// and O(log k) for each vertex and each edge that it shares with k other items. With the abstraction, also: the
  /// triangles inside a polygon, except those inside smaller polygons in it; if walls divide an area, the triangles of
  /// the smaller piece. With bridges, also the bridges that change. Source: Chen 2009, sections 3.2, 3.3 and 3.5.
  Result<ItemId> insert(const Shape& shape, ItemId id = {});

  /// Inserts a point, as insert() does: a vertex that stays as long as the item is live. It is not a wall.
  Result<ItemId> insert_point(Point point, ItemId id = {});
  /// Inserts a segment from `a` to `b`, as insert() does. A segment of length zero acts as a point.
  Result<ItemId> insert_segment(Point a, Point b, ItemId id = {});
  /// Inserts a polyline, as insert() does: an open chain of sides through one or more points.
  Result<ItemId> insert_polyline(PointSpan points, ItemId id = {});
  /// Inserts a solid obstacle of one or more closed rings, as insert() does:
  /// `world.insert_polygon({{2, 2}, {4, 2}, {4, 4}})`. A side connects the last point of a ring to its first point, so
  /// you need not repeat the first point. The fill rule is FillRule::even_odd: a ring in a ring bounds a hole.
  Result<ItemId> insert_polygon(Rings rings, ItemId id = {});

  /// Removes an item. The resulting mesh has exactly the vertices, edges and faces that the mesh of a new world with
  /// the remaining items has.
  /// Errors: unknown_id, bad_id.
  /// Cost: the triangles that the item touches, however large the world is, and the bridges that change. With the
  /// abstraction, also: the triangles of the smaller area, if the removal connects two areas; and for a polygon, the
  /// polygons directly inside it, and the areas there that walls enclose. Source: Chen 2009, sections 3.4 and 3.5.
  Result<void> remove(ItemId id);

  /// Replaces the shape of an item. The item keeps its id. Use it to move an obstacle.
  /// Errors: unknown_id, bad_id, and the errors of insert() for shapes.
  /// Cost: the cost of remove() and the cost of insert().
  Result<void> replace(ItemId id, const Shape& shape);

  /// @}

  /// @name Changing many items at once
  /// You need this group to load a level, or to make several changes as one operation: all of them or, on an error,
  /// none. Item, Change and BulkOptions have examples.
  /// @{

  /// Inserts many items as one operation. Returns the id of each. This is much faster than one call for each item,
  /// especially if the world has no items yet. Error::index is the index of the refused item in `items`.
  /// Errors: the errors of insert().
  /// Cost: O(n log n), the triangles that the sides cross, and the bridges (WorldOptions::keep_bridges).
  /// Source: Guibas and Stolfi 1985 and Dwyer 1987. The function uses their algorithm if the world has no items yet.
  Result<std::vector<ItemId>> insert_all(std::span<const Item> items, const BulkOptions& options = {});

  /// Inserts many points as one operation. The first point has the id `first`, and the id of each further point is one
  /// more. If `first` is null, the world chooses it as insert() does. Returns the id of the first point. Error::index
  /// is the index of the refused point in `points`.
  /// Errors: the errors of insert().
  /// Cost: as for insert_all().
  Result<ItemId> insert_points(PointSpan points, ItemId first = {}, const BulkOptions& options = {});

  /// Makes several changes, one after the other, as one operation. Returns the id of the item of each change.
  /// Error::index is the index of the refused change in `changes`.
  /// Errors: the errors of insert(), remove() and replace().
  /// Cost: the sum of the costs of the changes. Insertions that follow each other are as fast as insert_all().
  Result<std::vector<ItemId>> apply(std::span<const Change> changes);
  /// Calls apply() with changes in braces: `world.apply({Change::remove(7), Change::insert(house, 8)})`.
  Result<std::vector<ItemId>> apply(std::initializer_list<Change> changes) {
    return apply(std::span<const Change>(std::data(changes), changes.size()));
  }

  /// @}

  /// @name Going back and trying out
  /// You need this group for a game with rollback, for the undo of an editor, and to test a change before you make it.
  ///
  /// @code{.cpp}
  /// world.keep_history(8);  // the last 8 ticks
  /// const std::uint64_t tick = world.mark();
  /// world.insert(house).value();
  /// world.remove(1).value();
  /// world.rewind(tick).value();
  /// const bool is_back = world.contains(1) && world.item_count() == 2;  // == true
  /// @endcode
  /// @{

  /// Makes the world keep its last `ticks` ticks from now on. A tick is a state of the world that mark() has named. If
  /// the history has more ticks, the world drops the oldest. With 0, the world drops its history and keeps none.
  /// Cost: O(1), or linear in the size of the history that the world drops.
  void keep_history(std::size_t ticks);

  /// Names the current state of the world. Returns its tick: 1 for the first call, and one more for each further call.
  /// After a rewind, the numbers continue from the tick to which the world went back. While the history has a tick,
  /// each operation also records the ids of the items that it changes, and the shapes that it removes or replaces.
  /// Requires: keep_history() was called with 1 or more.
  /// Cost: amortised O(1). Allocates nothing if the history has had as many ticks and changes before.
  std::uint64_t mark();

  /// Brings back the state of the world at a tick, as one operation: the same items with the same shapes, the same next
  /// id, the same mesh and hashes. So every query gives the same answer, and every later operation has the same result.
  /// Afterwards, `tick` is the last tick of the history: the later ticks no longer exist. version() grows by one: for
  /// changes_since(), a rewind is an operation.
  /// Errors: no_history; old_tick, if the history no longer has the tick; unknown_tick, if no mark has this tick.
  /// Error::index is the tick.
  /// Cost: for each item that has changed since the tick, at most one removal and one insertion, however often it has
  /// changed. An item whose shape is as it was at the tick costs only a comparison. The insertions cost as much as
  /// in apply(). If the removed items have most of the corners of the world, the rewind costs as much as a new world.
  Result<void> rewind(std::uint64_t tick);

  /// Makes changes, asks a question about the changed world, and takes the changes back. Returns the answer. `question`
  /// is a function that takes a `const World&` (Change has an example). If it returns a T or a Result<T>, attempt()
  /// returns a Result<T>. If it returns nothing or a Result<void>, attempt() returns a Result<void>.
  ///
  /// Queries in the question see the changed world. Afterwards the world is as before, bit for bit: its items, mesh and
  /// hashes, its next id, its version and its history. Only memory() may be larger. If the question throws an
  /// exception, the world takes the changes back, too. The world asks no question if it refuses a change. version(),
  /// changes_since() and is_affected() do not count the changes, not even in the question. A PathSearch of this world
  /// continues afterwards as if there had been no attempt.
  /// Requires: the question calls no member of this world that is not const, and does not call clone(). It does not
  /// begin or continue a PathSearch, make or update a PathWatch, or use a ReplayWriter of this world.
  /// Errors: the errors of apply() and of the question. Error::index is the index of the refused change in `changes`.
  /// Cost: as apply(), and the question. To take the changes back allocates nothing and costs less than apply().
  /// Threads: no other thread may call any member of this world before the call returns.
  template <class Question>
  auto attempt(std::span<const Change> changes, Question&& question) -> detail::ResultOfAttempt<Question> {
    if (auto begun = begin_attempt(changes); !begun) return begun.error();
    const detail::AttemptGuard guard(*this);
    return detail::ask(question, std::as_const(*this));
  }
  /// Calls attempt() with changes in braces: `world.attempt({Change::remove(7)}, question)`.
  template <class Question>
  auto attempt(std::initializer_list<Change> changes, Question&& question) {
    return attempt(std::span<const Change>(std::data(changes), changes.size()), std::forward<Question>(question));
  }

  /// Returns whether changes would disconnect some of the points. This is true in two cases: the agent can move from
  /// one of the points to another now, but not after the changes; or one of the points is not blocked now, but is
  /// blocked after the changes. The function makes no change. The decision is exact. find_path() may move a blocked
  /// point to a free position, but this function takes each point as it is.
  ///
  /// With the radius 0, a point is blocked if polygons cover all triangles around it. A point agent can move from one
  /// point to another if find_path() finds a path with the PathQuery::end_tolerance 0. With a radius above 0, a point
  /// is blocked if the disc does not fit there (fit_disc()), and a disc can move to another point only through gaps
  /// that are wide enough. Points that are blocked now, and pairs that are not connected now, do not matter. Change has
  /// an example. Error::index is the index of the refused point in `points`, or of the refused change in `changes`.
  /// Errors: the errors of apply(); coordinate_range, out_of_domain, bad_radius; not_supported, if the radius is 0 and
  /// the world does not keep its abstraction; no_bridges, if it is above 0 and the world does not keep its bridges.
  /// Cost: the cost of one attempt(), and two point locations for each point. With a radius above 0, also fit_disc()
  /// for each point and, for each set of points between which the disc can move, a search through all gaps that it can
  /// pass from there, and one step for each of `points`.
  [[nodiscard]] Result<bool> would_disconnect(std::span<const Change> changes, PointSpan points,
                                              const Agent& agent = {});
  /// Does the same for one change: the insertion of a shape.
  [[nodiscard]] Result<bool> would_disconnect(const Shape& shape, PointSpan points, const Agent& agent = {});

  /// @}

  /// @name Snapshots for readers on other threads
  /// You need this group if threads find paths while another thread changes the world. WorldSnapshot has an example.
  /// @{

  /// Returns an immutable world with the current state of this world. Other threads can query it while this world
  /// changes. WorldSnapshot describes the replicas. If memory runs out, nothing changes.
  /// Requires: attempt() is not asking a question about this world.
  /// Cost: the function takes the newest replica that serves snapshots of the present and that no reader holds. For
  /// each item that has changed since the version of this replica, it makes at most one removal and one insertion. If
  /// there is no such replica, or if more than 64 + n / 32 items have changed, it costs about as much as clone(), or
  /// less with shared pages. Here n is the number of items that the world had when it made its last snapshot.
  [[nodiscard]] WorldSnapshot publish();
  /// Returns an immutable world with the state of this world at a tick (mark()). This world does not change.
  /// WorldSnapshot has an example. If memory runs out, nothing changes.
  /// Requires: attempt() is not asking a question about this world.
  /// Errors: the errors of rewind().
  /// Cost: n log n in the changes since the tick. The function takes a replica that has served a tick before. For each
  /// item that has changed since the tick or the version of the replica, it makes a comparison and, if the item
  /// differs, at most one removal and one insertion. Without such a replica, it costs about a clone() and a rewind().
  [[nodiscard]] Result<WorldSnapshot> publish(std::uint64_t tick);

  /// @}

  /// @name Limiting operations
  /// You need this group if your program takes shapes from people whom you do not know, for example on a server.
  /// WorldOptions::new_vertex_limit says how a limit protects a program, and has an example.
  /// @{

  /// Sets the largest number of vertices that one operation may make, as WorldOptions::new_vertex_limit describes it.
  /// To limit a single operation, set the limit before it, and kNoVertexLimit after it.
  /// Cost: O(1).
  void set_new_vertex_limit(std::size_t limit);
  /// Returns the largest number of vertices that one operation may make.
  [[nodiscard]] std::size_t new_vertex_limit() const;

  /// @}

  /// @name Reading items
  /// You need this group to save a world, to send it to another machine, or to look up a shape. Item has an example.
  /// @{

  /// Returns the largest id that the world has seen, in an item or in reserve_ids(), or null if it has seen none. If
  /// the world chooses an id, it is this id plus 1. rewind() brings back the largest id seen up to the tick.
  /// Cost: O(1).
  [[nodiscard]] ItemId largest_id_seen() const;
  /// Lets the world continue its ids after `last`, as if it had seen this id. The world never chooses `last` or a
  /// smaller id afterwards, except after a rewind(). You may still insert items under these ids. Does nothing if the
  /// world has seen a larger id. The call is not an operation: it does not change version(). ItemId has an example.
  /// Errors: bad_id.
  /// Cost: O(1).
  Result<void> reserve_ids(ItemId last);

  /// Returns whether a live item has this id. Cost: O(1).
  [[nodiscard]] bool contains(ItemId id) const;
  /// Returns the number of live items. Cost: O(1).
  [[nodiscard]] std::size_t item_count() const;
  /// Returns the ids of all live items, ascending. Cost: O(n log n).
  [[nodiscard]] std::vector<ItemId> item_ids() const;
  /// @copydoc item_ids() const
  void item_ids(std::vector<ItemId>& ids) const;
  /// Returns a copy of the shape of an item as you inserted it, with two exceptions. Of equal consecutive points (in a
  /// polygon, also of the last and the first point of a ring), it has only one. (A segment always has two points.) And
  /// the fill rule of an item that is not a polygon is FillRule::even_odd.
  /// Errors: unknown_id, bad_id.
  /// Cost: linear in the points of the item.
  [[nodiscard]] Result<Shape> shape(ItemId id) const;
  /// @copydoc shape(ItemId) const
  [[nodiscard]] Result<void> shape(ItemId id, Shape& shape) const;

  /// Returns all live items, ascending by id, with shapes as shape() gives them. If you insert them with insert_all()
  /// into a new world over the same domain, the two worlds have the same mesh and give the same answers. The ids of
  /// later items can differ: see reserve_ids().
  /// Cost: O(n log n), and linear in the points of the items.
  [[nodiscard]] std::vector<Item> items() const;
  /// @copydoc items() const
  void items(QueryContext& context, std::vector<Item>& items) const;

  /// @}

  /// @name Locating and asking
  /// You need this group to find out what lies at a point, along a segment or in a box: for a mouse click, a line of
  /// sight or a selection rectangle. Location, CrossedItem and RayHit have examples.
  /// @{

  /// Finds the vertex, edge or face at a point, and the polygons there.
  /// Errors: coordinate_range, out_of_domain.
  /// Cost: a walk through a few triangles, whose number does not depend on the size of the world; and the size of the
  /// answer. Allocates nothing if `context` and `location` have been used before.
  /// Source: the remembering stochastic walk, Chen 2009, section 3.2.1.
  [[nodiscard]] Result<void> locate(Point point, QueryContext& context, Location& location) const;
  /// @copydoc locate(Point, QueryContext&, Location&) const
  [[nodiscard]] Result<Location> locate(Point point) const;

  /// Finds the items that contain a point: polygons that cover it, and items with a side or corner there. Ids ascend.
  /// Errors: coordinate_range, out_of_domain.
  /// Cost: the cost of locate().
  [[nodiscard]] Result<void> items_at(Point point, QueryContext& context, std::vector<ItemId>& items) const;
  /// @copydoc items_at(Point, QueryContext&, std::vector<ItemId>&) const
  [[nodiscard]] Result<std::vector<ItemId>> items_at(Point point) const;
  /// Finds the items whose sides the segment meets, and the positions where it meets them, in the order from `from` to
  /// `to`. An item occurs once for each position. If the segment runs along a side, CrossedItem::at is the point where
  /// the overlap starts. Items at one position ascend. The border of the domain is not listed.
  /// Errors: coordinate_range, out_of_domain.
  /// Cost: the point location of `from`, and the triangles that the segment crosses.
  [[nodiscard]] Result<void> items_crossed(Point from, Point to, QueryContext& context,
                                           std::vector<CrossedItem>& items) const;
  /// @copydoc items_crossed(Point, Point, QueryContext&, std::vector<CrossedItem>&) const
  [[nodiscard]] Result<std::vector<CrossedItem>> items_crossed(Point from, Point to) const;
  /// Finds the first wall that the agent touches while it moves straight from `from` to `to`: the segment of a point
  /// agent, or a moving disc. The border of the domain is a wall, too. A segment that starts on a wall touches this
  /// wall. RayHit says when a disc touches a wall. The decision is exact, even if several walls meet at the position,
  /// if the segment passes through the end of a wall, or if the disc passes a wall at a distance of exactly the radius.
  /// Errors: coordinate_range, out_of_domain, bad_radius.
  /// Cost: the point location of `from`, and the triangles that the segment crosses before the hit. For a disc, n log n
  /// in the number n of triangles that a disc 1.07 times as large meets before the touch. Allocates nothing if
  /// `context` and `hit` have been used for such a query before. One exception: if the radius is no multiple of 2^-152
  /// and doubles cannot decide, exact arithmetic allocates.
  [[nodiscard]] Result<void> ray(Point from, Point to, const Agent& agent, QueryContext& context, RayHit& hit) const;
  /// @copydoc ray(Point, Point, const Agent&, QueryContext&, RayHit&) const
  [[nodiscard]] Result<RayHit> ray(Point from, Point to, const Agent& agent = {}) const;
  /// Finds the items that have a position in common with a closed box. Ids ascend. The box may reach beyond the domain.
  /// Errors: coordinate_range; bad_domain, if min is beyond max.
  /// Cost: the point location of a corner of the box, and the triangles that meet the box.
  [[nodiscard]] Result<void> items_in(const Box& box, QueryContext& context, std::vector<ItemId>& items) const;
  /// @copydoc items_in(const Box&, QueryContext&, std::vector<ItemId>&) const
  [[nodiscard]] Result<std::vector<ItemId>> items_in(const Box& box) const;

  /// @}

  /// @name Discs
  /// You need this group to find out where a round agent fits, which position is the nearest where it fits, and which
  /// agents fit through the gaps between walls. A disc may touch walls. Like paths, discs ignore items of the kind
  /// point. DiscFit, NearestFit, WidestPath, BridgeList and RayHit have examples.
  /// @{

  /// Finds out whether a disc fits at a position: the centre does not lie strictly inside a polygon, and no constrained
  /// edge is nearer to it than the radius. If the disc does not fit, DiscFit::items says why. The decision is exact.
  /// With the radius 0, only polygons can stop the disc.
  /// Errors: coordinate_range, out_of_domain, bad_radius.
  /// Cost: the point location of the centre, and the triangles within the radius. Allocates nothing if `context` and
  /// `fit` have been used before.
  [[nodiscard]] Result<void> fit_disc(Point centre, const Agent& agent, QueryContext& context, DiscFit& fit) const;
  /// @copydoc fit_disc(Point, const Agent&, QueryContext&, DiscFit&) const
  [[nodiscard]] Result<DiscFit> fit_disc(Point centre, const Agent& agent) const;

  /// Finds the nearest point to NearestFitQuery::point, among all points where a disc fits (fit_disc(); for the radius
  /// 0 see NearestFitQuery::agent). With a goal, it is the nearest point from which the disc can move to the goal. The
  /// decisions are exact. NearestFit says how precise the distance is. Error::index is 0 for the point, 1 for the goal.
  /// Errors: coordinate_range, out_of_domain, bad_radius; bad_distance, if the limit is negative or not a number;
  /// no_bridges, if the query has a goal and a radius above 0, and the world does not keep its bridges
  /// (WorldOptions::keep_bridges); not_supported, if the query has a goal and the radius 0, and the world does not keep
  /// its abstraction.
  /// Cost: n log n in the walls that are not farther away than the answer's distance plus the radius, and for each of
  /// them the triangles near the positions where the disc touches it. With a goal and a radius above 0, the function
  /// also searches from gap to gap, from the goal and from each possible answer, until the search from the goal meets
  /// that from the answer. The cost includes the walls and gaps that they reach. Allocates nothing if `context` has
  /// been used for such a query before; if the radius is 0 and the point is blocked, exact arithmetic may allocate.
  [[nodiscard]] Result<void> nearest_fit(const NearestFitQuery& query, QueryContext& context, NearestFit& fit) const;
  /// @copydoc nearest_fit(const NearestFitQuery&, QueryContext&, NearestFit&) const
  [[nodiscard]] Result<NearestFit> nearest_fit(const NearestFitQuery& query) const;

  /// Finds the largest disc that can move from `start` to `goal`, and the gap that stops every larger disc. All
  /// comparisons are exact. The result does not say whether the disc fits at the two ends: fit_disc() says this.
  /// The search ignores the radius of `agent`.
  /// Errors: coordinate_range, out_of_domain; no_bridges, if the world does not keep its bridges.
  /// Cost: two searches, one from each end, move through gaps that are not narrower than the answer, until they meet.
  /// The cost is n log n in the walls and gaps that they reach. Allocates nothing if `context` and `widest` have been
  /// used for such a query before.
  [[nodiscard]] Result<void> widest_path(Point start, Point goal, const Agent& agent, QueryContext& context,
                                         WidestPath& widest) const;
  /// @copydoc widest_path(Point, Point, const Agent&, QueryContext&, WidestPath&) const
  [[nodiscard]] Result<WidestPath> widest_path(Point start, Point goal, const Agent& agent = {}) const;

  /// Lists the bridges, so that a program can draw or inspect them. The list contains a bridge if the straight line
  /// from Bridge::from to Bridge::to has a position in common with the closed box. The box may reach beyond the domain.
  /// Errors: coordinate_range; bad_domain, if min is beyond max; no_bridges, if the world does not keep its bridges.
  /// Cost: the point location of a corner of the box, the triangles that meet the box or a listed bridge, and n log n
  /// in the listed bridges. Allocates nothing if `context` and `list` have been used for such a query before.
  [[nodiscard]] Result<void> bridges(const Box& box, QueryContext& context, BridgeList& list) const;
  /// @copydoc bridges(const Box&, QueryContext&, BridgeList&) const
  [[nodiscard]] Result<BridgeList> bridges(const Box& box) const;

  /// @}

  /// @name Paths
  /// You need this group to move an agent to a goal. Use find_path for one agent, find_paths for many, and
  /// find_paths_from to compare many goals. PathSearch finds a path in slices. PathQuery and Path have examples.
  /// @{

  /// Finds a path from start to goal. It may touch walls and vertices, but it never passes through a wall. At a vertex
  /// with walls, it never passes from one wedge between walls into another. PathQuery::end_tolerance says when the
  /// search moves the start and the goal. If the radius of PathQuery::agent is above 0, the disc's path is in
  /// Path::pieces.
  /// Errors: coordinate_range, out_of_domain, bad_radius, bad_distance; not_supported, if the radius is 0, the
  /// algorithm is `tra`, and the world does not keep its abstraction; no_bridges, if the query has a radius above 0 and
  /// the world does not keep its bridges.
  /// Cost: the point location of both ends, and the triangles that the search enters (Path::expansions). If polygons
  /// block an end, also the covered triangles within the tolerance. If walls separate the ends and the world keeps its
  /// abstraction, the search for a point agent enters no triangle. Allocates nothing if `context` and `path` have been
  /// used for a search of the same size before, except for Path::widest, a blocked end and exact arithmetic.
  /// Source: see PathAlgorithm. ARCHITECTURE.md describes the differences.
  [[nodiscard]] Result<void> find_path(const PathQuery& query, QueryContext& context, Path& path) const;
  /// @copydoc find_path(const PathQuery&, QueryContext&, Path&) const
  [[nodiscard]] Result<Path> find_path(const PathQuery& query) const;

  /// Finds a path for each query, in the order of the queries. Each path is the path that find_path() gives, at the
  /// same cost. The function uses at most 256 threads, at most one for each context, and at most one for each query:
  /// threads of the job system or, if `jobs` is null, threads that the function starts. Error::index is the index of
  /// the refused query in `queries`.
  /// Requires: at least one context.
  /// Errors: the errors of find_path().
  [[nodiscard]] Result<void> find_paths(std::span<const PathQuery> queries, std::span<QueryContext> contexts,
                                        std::vector<Path>& paths, JobSystem* jobs = nullptr) const;
  /// Finds a path for each query on `threads` threads, with new contexts. Errors and costs are the same.
  /// Requires: `threads` is 1 or more.
  [[nodiscard]] Result<std::vector<Path>> find_paths(std::span<const PathQuery> queries, std::size_t threads,
                                                     JobSystem* jobs = nullptr) const;

  /// Finds the shortest path to each goal, in the order of the goals. In each answer, Path::expansions is the sum over
  /// all searches. Error::index is 0 for the start, and i + 1 for goal number i, counted from 0.
  /// Errors: the errors of find_path().
  /// Cost: ManyGoalsQuery says when one search finds all paths.
  [[nodiscard]] Result<void> find_paths_from(const ManyGoalsQuery& query, QueryContext& context,
                                             std::vector<Path>& paths) const;
  /// @copydoc find_paths_from(const ManyGoalsQuery&, QueryContext&, std::vector<Path>&) const
  [[nodiscard]] Result<std::vector<Path>> find_paths_from(const ManyGoalsQuery& query) const;

  /// Returns the default of PathQuery::end_tolerance: 2^-20 of the largest magnitude of a coordinate of the domain.
  /// Cost: O(1).
  [[nodiscard]] double default_end_tolerance() const;

  /// @}

  /// @name Following changes
  /// You need this group after a change of the world, to find out which paths agents can still walk along. Call
  /// is_affected() first, which is cheap. Then call is_clear() for the affected paths of point agents. For an affected
  /// path of a disc, call find_path() again. ChangedBox and PathWatch have examples.
  /// @{

  /// Returns whether a point agent can walk along a polyline, for example the points of a Path. The function does not
  /// support discs yet: their radius must be 0. The agent may touch walls and vertices and may walk along walls. It
  /// must not pass through a wall, through the interior of a polygon, or at a vertex from one wedge between walls into
  /// another. The decision is exact. If there are no points, the result is false. Path::points says how the function
  /// treats a path that turns at a crossing of two sides. Error::index is the index of the refused point in `points`.
  /// Errors: coordinate_range, out_of_domain, bad_radius; not_supported, if the radius is above 0.
  /// Cost: the point location of the first point, and the triangles that the polyline crosses. Allocates nothing if
  /// `context` has been used for a polyline of the same length before.
  [[nodiscard]] Result<bool> is_clear(std::span<const Point> points, const Agent& agent, QueryContext& context) const;
  /// @copydoc is_clear(std::span<const Point>, const Agent&, QueryContext&) const
  [[nodiscard]] Result<bool> is_clear(std::span<const Point> points, const Agent& agent = {}) const;
  /// Returns whether a point agent can walk along the straight segment between two points, as for a polyline of two
  /// points. A segment that only touches a wall is clear, although ray() reports a hit for it.
  [[nodiscard]] Result<bool> is_clear(const Point& from, const Point& to, const Agent& agent,
                                      QueryContext& context) const;
  /// @copydoc is_clear(const Point&, const Point&, const Agent&, QueryContext&) const
  [[nodiscard]] Result<bool> is_clear(const Point& from, const Point& to, const Agent& agent = {}) const;

  /// Returns whether a polyline meets the bounding box of a segment, polyline or polygon that an operation after
  /// version `since` has inserted or removed (ChangedBox). For a disc that moves along the polyline, the function
  /// returns whether it may touch the box. (A radius that is not above 0 counts as 0.) If the result is false and the
  /// polyline was clear at that version, it is still clear. If changes_since() returns nothing for that version, the
  /// result is true. Cost: a few comparisons for each pair of a box and a point. Allocates nothing.
  [[nodiscard]] bool is_affected(std::span<const Point> points, std::uint64_t since, const Agent& agent = {}) const;
  /// Returns whether a path is affected by the operations after version `since`. For a point agent, this is
  /// is_affected() of Path::points. For a disc, the function returns whether the bounding box of an inserted or removed
  /// item comes so near to Path::pieces that the disc may touch the box: see ChangedBox. If the result is false and the
  /// path was valid for its agent at that version, it is still valid.
  /// After a removal, a path that is not affected may be longer than necessary. A path that was not found is never
  /// affected: search again for it. If ManyGoalsQuery::wants_points was false, each box affects a found path.
  /// Cost: a few comparisons for each pair of a box and a piece. Allocates nothing.
  [[nodiscard]] bool is_affected(const Path& path, std::uint64_t since) const;
  /// Replaces the content of `affected` by the indices of the paths for which is_affected() is true, ascending.
  void find_affected(std::span<const Path> paths, std::uint64_t since, std::vector<std::size_t>& affected) const;

  /// Returns the regions that the operations after version `since` have changed, the oldest first: see ChangedBox.
  /// Returns nothing if the world no longer has all boxes since that version, or if `since` is above version(). The
  /// answer is valid until you call a member that is not const. PathWatch reads these boxes for many paths at once.
  /// Cost: O(log n) in the boxes that the world keeps. Allocates nothing.
  [[nodiscard]] std::optional<std::span<const ChangedBox>> changes_since(std::uint64_t since) const;

  /// Returns the number of operations that the world has carried out. Each successful operation adds one. Cost: O(1).
  [[nodiscard]] std::uint64_t version() const;

  /// @}

  /// @name Mesh and hashes
  /// You need this group to draw or inspect the mesh, to compare worlds on different machines, and in tests.
  /// MeshSnapshot, ItemsHash and Validation have examples.
  /// @{

  /// Returns the number of vertices of the mesh: the corners of the domain, the corners of items, and the crossings.
  /// Cost: O(1).
  [[nodiscard]] std::size_t vertex_count() const;
  /// Returns the number of triangles of the mesh.
  /// Cost: linear in the vertices on the border of the domain.
  [[nodiscard]] std::size_t triangle_count() const;
  /// Returns a copy of the mesh in canonical order. Cost: O(n log n).
  [[nodiscard]] MeshSnapshot snapshot() const;
  /// @copydoc snapshot() const
  void snapshot(QueryContext& context, MeshSnapshot& snapshot) const;
  /// Returns the mesh as canonical text with exact rational coordinates. Worlds with equal domains and equal live items
  /// have equal dumps. Cost: O(n log n), with exact arithmetic.
  [[nodiscard]] std::string dump() const;
  /// Returns the hash of the domain and the live items. Every operation updates the hash. Cost: O(1).
  [[nodiscard]] ItemsHash items_hash() const;
  /// Returns the SHA-256 of the bytes of dump(). Cost: the cost of dump().
  [[nodiscard]] MeshHash mesh_hash() const;
  /// Checks the whole world, exactly: see Validation. Cost: linear in the mesh, with exact arithmetic throughout.
  [[nodiscard]] Validation validate() const;

  /// @}

  /// @name Memory
  /// You need this group if memory is short. MemoryUse has an example.
  /// @{

  /// Returns the memory of the world, by purpose. MemoryUse says what the result does not include.
  /// Cost: does not depend on the number of items.
  [[nodiscard]] MemoryUse memory() const;
  /// Frees most of the spare memory (MemoryUse::spare), and the world's own context for queries. The next operations
  /// allocate their scratch again. The call changes no answer and no hash.
  /// Cost: linear in the mesh. While it runs, it needs memory for a copy of one array at a time. If no item needs the
  /// second mesh any more (WorldOptions::keep_bridges), the function frees this mesh and needs memory for new bridges.
  void shrink_to_fit();

  /// @}

 private:
  friend class PathSearch;
  friend class PathWatch;
  friend class detail::AttemptGuard<World>;
  friend struct LoadedPoints;    // of load_world()
  friend struct WorldInternals;  // of the tests
  struct Impl;
  class Operation;

  explicit World(std::unique_ptr<Impl> impl);
  [[nodiscard]] Result<void> begin_attempt(std::span<const Change> changes);  // leaves the operation open
  void end_attempt() noexcept;
  /// insert_points() with ids that ascend, one for each point.
  [[nodiscard]] Result<void> insert_points_as(PointSpan points, std::span<const ItemId> ids,
                                              const BulkOptions& options);

  detail::Owned<Impl, detail::kMovedWorld> impl_;
};

/// @}

}  // namespace waywright
