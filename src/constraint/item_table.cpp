#include "constraint/item_table.hpp"

#include <algorithm>

namespace waywright::constraint {

ItemTable::ItemTable() { items_.push_back({{}, ItemKind::polygon, {}, {}, {}}); }

std::uint32_t ItemTable::add_item(ItemId id, ItemKind kind) {
  const auto slot = static_cast<std::uint32_t>(items_.size());
  items_.push_back({id, kind, {}, {}, {}});
  slots_.emplace(id, slot);
  largest_id_seen_ = std::max(largest_id_seen_, id);
  return slot;
}

std::uint32_t ItemTable::add_side(const Side& side) {
  const auto slot = static_cast<std::uint32_t>(sides_.size());
  sides_.push_back(side);
  items_[side.item].sides.push_back(slot);
  return slot;
}

std::vector<ItemId> ItemTable::ids() const {
  std::vector<ItemId> result;
  result.reserve(slots_.size());
  for (const auto& [id, slot] : slots_) result.push_back(id);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace waywright::constraint
