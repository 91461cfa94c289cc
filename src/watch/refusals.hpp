#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "waywright/change.hpp"
#include "waywright/path.hpp"

#include "watch/box_grid.hpp"

namespace waywright::watch {

/// The watched paths of queries that have found no path, and where a change can make a path possible.
///
/// A change can make a path possible in three cases:
/// - It is near an end: then the query may move this end to another position.
/// - It removes a wall of the *barrier*: the border of an area that contains one of the ends, but not the other one.
/// - The class does not know a barrier, because nobody has looked for one, or because a path is already possible.
class Refusals {
 public:
  explicit Refusals(const Box& domain) : domain_(domain), boxes_(domain) {}

  /// What the query said.
  struct Refusal {
    QueryEnds ends;
    Agent agent;
  };

  /// Adds the path of a slot. `tolerance` is the largest distance by which the query moves an end. If memory runs out,
  /// nothing changes.
  void add(std::uint32_t slot, const Refusal& refusal, double tolerance);
  /// Removes the path of a slot, if it has one. Allocates nothing.
  void remove(std::uint32_t slot) noexcept;
  [[nodiscard]] bool is_empty() const { return slots_.empty(); }
  [[nodiscard]] const Refusal& refusal(std::uint32_t slot) const { return entries_[slot].refusal; }

  /// Lists the slots of the paths that changes may have made possible: first those of point agents, then those of discs
  /// with ascending radii. If `all` is true, lists all slots. If `all_points` is true, lists all slots of point agents.
  [[nodiscard]] std::span<const std::uint32_t> list(std::span<const ChangedBox> changes, bool all, bool all_points);
  /// Returns whether the agent fits at both ends without a move, because it did so at the last test and list() has seen
  /// no change near an end.
  [[nodiscard]] bool fits_at_ends(std::uint32_t slot) const {
    return entries_[slot].did_fit && !entries_[slot].is_changed;
  }
  /// Says that a path is possible now.
  void set_possible(std::uint32_t slot) noexcept { forget_barrier(slot); }
  /// Says that no path is possible now. Only the removal of a wall that meets the box can change this, or a change near
  /// an end. Without a box, only a change near an end can change this. `fits` says whether the agent fits at both ends
  /// without a move.
  void set_barrier(std::uint32_t slot, const std::optional<Box>& box, bool fits);

 private:
  enum Index : std::uint8_t { kStart, kGoal, kBarrier, kCount };
  struct BoxOfPath {
    std::uint32_t slot;
    Index index;
  };
  using Boxes = BoxGrid<BoxOfPath>;

  struct Entry {
    Refusal refusal;
    bool is_used = false;
    bool is_decided = false;  ///< whether it is known where a removal makes a path possible
    bool did_fit = false;     ///< whether the agent fitted at both ends at the last test
    bool is_changed = false;  ///< in the list: whether something may have changed near an end
    bool is_listed = false;
    std::uint32_t index = 0;  ///< in `slots_`
    std::optional<Boxes::Handle> boxes[kCount];
  };

  void forget_barrier(std::uint32_t slot) noexcept;
  void put(std::uint32_t slot, bool is_changed);

  Box domain_;
  Boxes boxes_;
  std::vector<Entry> entries_;        ///< by slot
  std::vector<std::uint32_t> slots_;  ///< of all paths
  std::size_t undecided_ = 0;         ///< the number of paths that are not decided
  std::vector<std::uint32_t> listed_;
};

}  // namespace waywright::watch
