#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "memory/journal.hpp"

namespace waywright::watch {

/// A set of boxes, each with a value. The set finds its boxes that overlap a given box.
///
/// The set has levels. The grid of level k divides the domain into 2^k x 2^k cells. A box belongs to the last level
/// whose cells are at least twice as wide and as high as the box, and there to the cell that contains its lower left
/// corner. So it reaches into no other cells than this one and its neighbours on the right and above. Boxes that are
/// too large for level 1, or begin outside the domain, belong to level 0. A box that is much smaller than the cells of
/// the last level belongs to this level.
///
/// Source: Ulrich, *Loose octrees*, in Game Programming Gems, 2000. Difference: a grid for each level instead of a
/// tree.
template <class Value>
class BoxGrid {
 public:
  using Handle = std::uint32_t;

  explicit BoxGrid(const Box& domain) : domain_(domain) {}

  /// Adds a box with a value. Returns a handle for remove(). If memory runs out, the set does not change.
  Handle insert(const Box& box, const Value& value) {
    if (free_handles_.is_empty()) {
      places_.push_back({});
      places_.back().index = free_handles_.push(static_cast<std::uint32_t>(places_.size() - 1));
    }
    const std::size_t level = level_of(box);
    const std::uint32_t key = key_of(level, column(level, box.min.x), row(level, box.min.y));
    Cell& cell = levels_[level][key];
    cell.make_room();
    // Nothing can fail from here on.
    const Handle handle = free_handles_.pop(places_[free_handles_.first()].index);
    places_[handle] = {static_cast<std::uint32_t>(level), key, static_cast<std::uint32_t>(cell.boxes.size())};
    cell.boxes.push_back(box);
    cell.entries.push_back({value, handle});
    return handle;
  }

  /// Removes a box. Allocates nothing.
  void remove(Handle handle) {
    const Place place = places_[handle];
    const auto at = levels_[place.level].find(place.key);
    Cell& cell = at->second;
    cell.boxes[place.index] = cell.boxes.back();
    cell.entries[place.index] = cell.entries.back();
    places_[cell.entries[place.index].handle].index = place.index;
    cell.boxes.pop_back();
    cell.entries.pop_back();
    if (cell.boxes.empty()) levels_[place.level].erase(at);
    places_[handle].index = free_handles_.push(handle);
  }

  /// Calls visit(value, its box) for each box that overlaps `box`, in no particular order. Boxes overlap if they have a
  /// point in common. Allocates nothing. `visit` must not change the set.
  template <class Visit>
  void for_each_overlapping(const Box& box, const Visit& visit) const {
    for (std::size_t level = 0; level < kLevels; ++level) {
      const Cells& cells = levels_[level];
      if (cells.empty()) continue;
      const std::uint32_t left = column(level, box.min.x) - (column(level, box.min.x) == 0 ? 0 : 1);
      const std::uint32_t low = row(level, box.min.y) - (row(level, box.min.y) == 0 ? 0 : 1);
      const std::uint32_t right = column(level, box.max.x);
      const std::uint32_t high = row(level, box.max.y);
      if (std::size_t{right - left + 1} * (high - low + 1) > cells.size()) {
        for (const auto& [key, cell] : cells) cell.for_each_overlapping(box, visit);
        continue;
      }
      for (std::uint32_t y = low; y <= high; ++y) {
        for (std::uint32_t x = left; x <= right; ++x) {
          const auto at = cells.find(key_of(level, x, y));
          if (at != cells.end()) at->second.for_each_overlapping(box, visit);
        }
      }
    }
  }

 private:
  static constexpr std::size_t kLevels = 13;

  struct Entry {
    Value value;
    Handle handle;
  };
  struct Cell {
    std::vector<Box> boxes;      ///< a list of its own, because a search reads all of them
    std::vector<Entry> entries;  ///< of the same boxes

    void make_room() {
      if (boxes.size() == boxes.capacity()) boxes.reserve(2 * boxes.size() + 2);
      if (entries.size() == entries.capacity()) entries.reserve(2 * entries.size() + 2);
    }
    template <class Visit>
    void for_each_overlapping(const Box& box, const Visit& visit) const {
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].overlaps(box)) visit(entries[i].value, boxes[i]);
      }
    }
  };
  using Cells = std::unordered_map<std::uint32_t, Cell>;
  /// Where the box of a handle is.
  struct Place {
    std::uint32_t level;
    std::uint32_t key;
    std::uint32_t index;  ///< in the cell; of a free handle: the next free one
  };

  [[nodiscard]] std::size_t level_of(const Box& box) const {
    if (!domain_.contains(box.min)) return 0;
    const double share = std::max(box.width() / domain_.width(), box.height() / domain_.height());
    std::size_t level = 0;
    for (double cell = 0.5; level + 1 < kLevels && 2.0 * share <= cell; cell *= 0.5) ++level;
    return level;
  }
  /// The column of the cell that contains a coordinate; the nearest column if it lies outside the domain. Each step
  /// rounds monotonically, so a larger coordinate never has a smaller column.
  [[nodiscard]] std::uint32_t column(std::size_t level, double x) const {
    return cell_at(level, (x - domain_.min.x) / domain_.width());
  }
  [[nodiscard]] std::uint32_t row(std::size_t level, double y) const {
    return cell_at(level, (y - domain_.min.y) / domain_.height());
  }
  [[nodiscard]] static std::uint32_t cell_at(std::size_t level, double share) {
    const auto count = static_cast<double>(1U << level);
    return static_cast<std::uint32_t>(std::clamp(share * count, 0.0, count - 1.0));
  }
  [[nodiscard]] static std::uint32_t key_of(std::size_t level, std::uint32_t x, std::uint32_t y) {
    return y << level | x;
  }

  Box domain_;
  std::array<Cells, kLevels> levels_;
  std::vector<Place> places_;      ///< by handle
  memory::FreeList free_handles_;  ///< linked by Place::index
};

}  // namespace waywright::watch
