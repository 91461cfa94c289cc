#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/export.hpp"
#include "waywright/id.hpp"
#include "waywright/script.hpp"
#include "waywright/world.hpp"

namespace waywright {

/// @addtogroup scenes
/// @{

/// Writes a replay log: the items of a world, every change that you record, and the hash of the items every few ticks.
/// A replay log is a world script, so `waywright run` reads it, too. `waywright replay LOG` makes the changes again and
/// stops at the first tick whose hash differs. `waywright replay LOG OTHER_LOG` compares the logs of two machines.
///
/// @code{.cpp}
/// std::ostringstream text;
/// ReplayWriter log(text, world, 2);  // a hash every 2 ticks
/// for (int tick = 1; tick <= 4; ++tick) {
///   const std::vector<Change> changes = {Change::insert(Shape::point({1.0 * tick, 5}))};
///   log.record(changes, world.apply(changes).value()).value();
///   log.tick(world).value();
/// }
/// const Script script = parse_script(text.str(), "the log").value();
/// const bool is_same = replay(script).value().is_same;  // == true
/// @endcode
///
/// The log records changes, not calls: each change is one line, also if one call of World::apply made several changes.
class WAYWRIGHT_API ReplayWriter {
 public:
  /// Starts a log: writes the domain and the items that `world` contains now. Writes a hash at each tick whose number
  /// is a multiple of `ticks_per_hash`. The stream must exist as long as this object.
  /// If the stream refuses the bytes, the next call of record() or tick() returns unwritable.
  /// Requires: `ticks_per_hash` is 1 or more, and World::attempt() is not asking a question about the world.
  /// Cost: O(n log n) in the number n of items of the world, and linear in their points.
  ReplayWriter(std::ostream& out, const World& world, std::uint64_t ticks_per_hash = 1);

  /// Records a change that a world has made. The id of the change must not be null: if the world chose the id of an
  /// insertion, set Change::id to it first, or call the function below.
  /// Errors: bad_id, if the id is null or too large: the call has then recorded nothing; unwritable: the log then lacks
  /// lines, so do not continue it.
  /// Cost: linear in the points of the shape.
  Result<void> record(const Change& change);
  /// Records the changes that World::apply has made. `ids` is the answer of that call.
  /// Requires: `ids` has one id for each change.
  /// Errors: as for the function above.
  /// Cost: linear in the points of the shapes.
  Result<void> record(std::span<const Change> changes, std::span<const ItemId> ids);

  /// Ends a tick. Ticks count from 1. If the function writes a hash at this tick, it also flushes the stream, so that
  /// the log is complete up to this tick even if the program crashes later.
  /// Requires: World::attempt() is not asking a question about the world.
  /// Errors: unwritable.
  /// Cost: O(1).
  Result<void> tick(const World& world);
  /// Ends a tick whose hash you have kept: `hash` is the World::items_hash() at the end of the tick. Use this function
  /// in a game with rollback, where a tick becomes final only later.
  /// Errors: unwritable.
  /// Cost: O(1).
  Result<void> tick(const ItemsHash& hash);

  /// Returns the number of the last tick, or 0 before the first tick.
  [[nodiscard]] std::uint64_t last_tick() const { return tick_; }

 private:
  Result<void> write();

  std::ostream* out_;
  std::uint64_t ticks_per_hash_;
  std::uint64_t tick_ = 0;
  std::string text_;  ///< the lines that the object has not written to the stream yet
};

/// The answer of replay().
///
/// @code{.cpp}
/// const Script log = parse_script("waywright 1\ndomain 0 0 9 9\npoint 1 2 2\npoint 1 3 3\ntick 1\n", "log").value();
/// const ReplayResult result = replay(log).value();
/// const bool is_same = result.is_same;      // == false
/// const std::uint32_t line = result.line;   // == 4
/// std::puts(result.refusal->message().c_str());
/// @endcode
struct ReplayResult {
  bool is_same = true;      ///< whether the world accepted all changes and rewinds, and all hashes are equal
  std::uint64_t ticks = 0;  ///< the number of ticks that replay() has replayed
  // The members below are meaningful only if `is_same` is false.
  std::uint64_t tick = 0;        ///< the first tick whose hash differs, or in which the world refused a line
  std::uint64_t last_same = 0;   ///< the last tick before `tick` whose hash is equal, or 0
  std::uint32_t line = 0;        ///< the line of the hash, or of the refused change or rewind, in the script
  ItemsHash expected;            ///< if a hash differs: the hash in the log
  ItemsHash computed;            ///< if a hash differs: the hash of the replayed world
  std::optional<Error> refusal;  ///< why the world refused a change or a rewind, if it did
  /// If a hash differs: the items that changed after tick `last_same`, ascending. If the world refused a change: the
  /// item of this change. If it refused a rewind: empty.
  std::vector<ItemId> changed;
};

/// Makes the changes of a log in a new world, and compares the hash of its items with each hash in the log. Stops at
/// the first difference. Ignores queries. `progress` may be empty. It counts lines of the log.
/// Errors: the errors of World::create(), for the domain.
/// Cost: the cost of the changes. The changes between two lines `tick`, `mark` or `rewind` are one operation.
[[nodiscard]] WAYWRIGHT_API Result<ReplayResult> replay(
    const Script& log, const std::function<void(std::size_t done, std::size_t total)>& progress = {});

/// The first difference between two logs: find_difference() returns it.
struct ReplayDifference {
  /// The kind of a difference.
  enum class Kind : std::uint8_t {
    domain,  ///< the domains differ
    change,  ///< a change, mark or rewind differs, or one log lacks it
    hash,    ///< all changes are equal up to this tick, but its hash differs
    /// One log ends after this tick and the other one continues, or their next ticks have different numbers.
    length,
  };
  Kind kind = Kind::change;
  std::uint64_t tick = 0;        ///< the tick during which the logs begin to differ
  std::uint32_t line = 0;        ///< the line in the first log, or 0 if this log ends before
  std::uint32_t other_line = 0;  ///< the line in the second log, or 0 if this log ends before
  ItemId item;                   ///< if `kind` is change: the item that `line` of the first log changes, or null
  ItemId other_item;             ///< if `kind` is change: the item that `other_line` of the second log changes, or null
  std::vector<ItemId> changed;   ///< if `kind` is hash: the items changed since the last equal hash, ascending
};

/// Compares two logs, change by change and hash by hash. Ignores queries, and the hash of a tick that has no hash in
/// the other log. Returns nothing if the logs do not differ.
///
/// @code{.cpp}
/// const std::string start = "waywright 1\ndomain 0 0 9 9\npoint 1 2 2\ntick 1\n";
/// const Script a = parse_script(start + "remove 1\ntick 2\n", "a").value();
/// const Script b = parse_script(start + "point 2 3 3\ntick 2\n", "b").value();
/// const std::uint64_t tick = find_difference(a, b)->tick;    // == 2
/// const ItemId item = find_difference(a, b)->other_item;     // == 2
/// @endcode
/// Cost: linear in the lines of the logs.
[[nodiscard]] WAYWRIGHT_API std::optional<ReplayDifference> find_difference(const Script& log, const Script& other);

/// @}

}  // namespace waywright
