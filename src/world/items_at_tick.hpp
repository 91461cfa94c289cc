#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "waywright/id.hpp"
#include "waywright/item.hpp"

#include "constraint/constrained_triangulation.hpp"
#include "world/history.hpp"
#include "world/item_shape.hpp"

namespace waywright {

/// The items that a world has now, or had at a tick of its history.
class ItemsAtTick {
 public:
  /// The items of now.
  explicit ItemsAtTick(const constraint::ConstrainedTriangulation& now) : now_(now) {}
  /// The items at a tick. `changed` is the answer of History::changed_since() for this tick.
  ItemsAtTick(const constraint::ConstrainedTriangulation& now, const History& history,
              std::span<const History::ChangedItem> changed)
      : now_(now), history_(&history), changed_(changed) {}

  /// Returns whether the item is one of these items. If it is, writes its shape to `shape`.
  [[nodiscard]] bool find(ItemId id, Shape& shape) const {
    const auto comes_before = [](const History::ChangedItem& item, ItemId other) { return item.id < other; };
    const auto found = std::lower_bound(changed_.begin(), changed_.end(), id, comes_before);
    if (found != changed_.end() && found->id == id) {
      if (!history_->was_live(*found)) return false;
      shape = history_->shape(*found);
      return true;
    }
    if (!now_.items().contains(id)) return false;
    fill_shape(now_, id, shape);
    return true;
  }

  /// Returns the answer of History::version_after(). Requires: changed() contains the item.
  [[nodiscard]] std::optional<std::uint64_t> version_after(const History::ChangedItem& item) const {
    return history_->version_after(item);
  }

  /// The items that have changed since the tick. Empty for the items of now.
  [[nodiscard]] std::span<const History::ChangedItem> changed() const { return changed_; }

 private:
  const constraint::ConstrainedTriangulation& now_;
  const History* history_ = nullptr;
  std::span<const History::ChangedItem> changed_;  ///< ascending by id
};

}  // namespace waywright
