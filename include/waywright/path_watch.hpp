#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "waywright/export.hpp"
#include "waywright/owned.hpp"
#include "waywright/path.hpp"

namespace waywright {

/// @addtogroup paths
/// @{

class World;

/// The answer of PathWatch::update: the keys of the paths that the operations since the last update may have blocked or
/// made longer than necessary. The keys of each list ascend. A path can be in two lists. If the world no longer has the
/// boxes of all these operations, the lists contain more paths: see PathWatch::update.
struct PathChanges {
  /// The paths of point agents that are no longer clear: World::is_clear() is false for their points, and an operation
  /// has inserted or removed an item near them. The list contains no path that is clear.
  std::vector<std::uint64_t> blocked;
  /// The paths of discs to which the bounding box of an inserted item is so near that the disc may touch this box. See
  /// World::is_affected().
  std::vector<std::uint64_t> may_be_blocked;
  /// The paths that may be longer than necessary: an operation has removed an item that may have blocked a shorter
  /// path. The list also contains the paths that were not found, but are possible now. No other path has become longer
  /// than necessary, with one exception: see PathWatch.
  std::vector<std::uint64_t> may_be_too_long;

  friend bool operator==(const PathChanges&, const PathChanges&) = default;
};

/// Watches the paths of many agents. After operations, it finds the paths that the agents should search for again. It
/// looks only at paths near the changes. So the cost of update() depends on what has changed, and hardly on the number
/// of paths.
///
/// @code{.cpp}
/// PathWatch watch(world);
/// for (std::size_t i = 0; i < units.size(); ++i) watch.add(i, units[i].path);
/// PathChanges changes;
/// world.insert(house).value();
/// watch.update(world, changes);
/// for (const std::uint64_t i : changes.blocked) {
///   units[i].path = world.find_path(units[i].query).value();
///   watch.add(i, units[i].path);
/// }
/// @endcode
///
/// Only the removal of an item can make a shorter path possible, and only if the shorter path meets the area where the
/// item was. Each position on a shorter path lies in the ellipse whose foci are the start and the goal of the old path,
/// and whose major axis is as long as the old path. So the watch compares the bounding boxes of removed items with this
/// ellipse. A replacement counts as a removal and an insertion. If the search moved an end of the path, the ellipse is
/// larger, and also contains the point at which the query wanted this end. There is one exception, which the watch does
/// not report: if several positions to which a search could move the end are equally near to this point, up to rounding
/// errors, the next search may choose another one of them, and its path may be shorter only for this reason.
///
/// If a path was not found, the watch reports it when the query would find a path now (Path::ends), also if an
/// insertion makes this possible: if it blocks an end, the query moves this end to a free position
/// (PathQuery::end_tolerance). For a point agent, the report is exact. For a disc, the watch decides exactly whether
/// the disc fits at the ends and can move from one to the other. If the radius is so small that a search may find no
/// path although there is one (PathQuery::agent), such a path is reported, too. If you keep the path under its key,
/// the watch reports it again after each later operation, as long as a path is possible. A path that was not found and
/// has no Path::ends counts as infinitely long: the watch reports it after each removal of a segment, polyline or
/// polygon.
///
/// The watch copies the paths. If you move a watch to another object, you may only assign to the first object or
/// destroy it.
/// Threads: a watch belongs to one thread at a time. The constructor and update() read the world: call them only while
/// no other thread changes it.
class WAYWRIGHT_API PathWatch {
 public:
  /// Makes a watch without paths for a world.
  /// Requires: World::attempt() is not asking a question about the world.
  /// Cost: O(1).
  explicit PathWatch(const World& world);
  ~PathWatch();
  PathWatch(PathWatch&&) noexcept;
  PathWatch& operator=(PathWatch&&) noexcept;

  /// Watches a path under a key. If the watch has a path under this key, the new path replaces it. The path must
  /// be the answer of a query (found or not) in the world as it is now, or as it was at the last update(). An older
  /// answer is allowed, too, if the path is not blocked in the world as it was at the last update(). For example, a
  /// game that goes back with World::rewind() can call update() and then add the paths that its units had at that tick.
  /// The next call of update() reports only what the operations after the last update() have changed.
  ///
  /// Requires: if the path is found, it has points or pieces (ManyGoalsQuery::wants_points).
  /// Cost: linear in the points or pieces of the path.
  void add(std::uint64_t key, const Path& path);
  /// Stops watching the path under a key. Returns whether the watch had a path under this key.
  /// Cost: linear in the points or pieces of the path. Allocates nothing.
  bool remove(std::uint64_t key);
  /// Returns whether there is a path under a key.
  /// Cost: O(1).
  [[nodiscard]] bool contains(std::uint64_t key) const;
  /// Returns the number of paths.
  /// Cost: O(1).
  [[nodiscard]] std::size_t size() const;

  /// Finds the paths that may be blocked or longer than necessary because of the operations since the last update, or
  /// since you made the watch. The watch keeps all paths, also the blocked ones, until you replace them with add() or
  /// remove them. A path that stays blocked appears in `changes` again only if a later operation changes something near
  /// it.
  ///
  /// If the world no longer has the boxes of all operations since then (World::changes_since()), or if `world` is a
  /// snapshot that is older than the world at the last update, the watch looks at all paths: it calls World::is_clear()
  /// for each path of a point agent, and lists each path of a disc in PathChanges::may_be_blocked and each path in
  /// PathChanges::may_be_too_long, without a test. It tests each path that was not found.
  /// Requires: `world` is the world for which the watch was made, this world after a move, or a snapshot of it
  /// (WorldSnapshot). World::attempt() is not asking a question about it.
  /// Cost: for each box of the operations since the last update (ChangedBox), a search in a tree; for the pieces of
  /// paths that come near to a box, the cost of World::is_clear(); the answer; and one step for each 64 paths of the
  /// watch. The watch calls World::is_clear() for a whole path in these cases: a piece near a box runs along a wall, or
  /// has a point with the rounded coordinates of a crossing; the path turns where a crossing may have vanished; the
  /// last check found the path blocked; there are more than 8 boxes. For a path that was not found, the watch tests
  /// whether there is a path in these cases: a box is near an end; an operation has removed an item at the border of
  /// the area that the agent cannot leave (if the world keeps its abstraction and the agent is a point: an operation
  /// may have connected two areas); the watch has not tested it yet, or a path was possible at the last test. A test
  /// costs two point locations and, for a disc or without an abstraction, a search through the smaller one of the two
  /// areas. All tests of one update for equal agents share their searches. Allocates nothing if earlier updates
  /// had answers and searches of this size. If memory runs out, `changes` is empty, and you can call update() again.
  void update(const World& world, PathChanges& changes);

 private:
  struct Impl;
  detail::Owned<Impl, detail::kMovedWatch> impl_;
};

/// @}

}  // namespace waywright
