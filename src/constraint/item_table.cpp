#include "constraint/item_table.hpp"

#include <algorithm>

namespace waywright::constraint {

ItemTable::ItemTable() { items_.push_back({{}, ItemKind::polygon, {}, {}, {}, {}}); }

std::uint32_t ItemTable::add_item(ItemId id, ItemKind kind) {
  std::uint32_t slot = 0;
  if (free_items_.empty()) {
    slot = static_cast<std::uint32_t>(items_.size());
    items_.push_back({id, kind, {}, {}, {}, {}});
  } else {
    slot = free_items_.back();
    free_items_.pop_back();
    items_[slot].id = id;
    items_[slot].kind = kind;
  }
  slots_.emplace(id, slot);
  largest_id_seen_ = std::max(largest_id_seen_, id);
  return slot;
}

std::uint32_t ItemTable::add_side(const Side& side) {
  std::uint32_t slot = 0;
  if (free_sides_.empty()) {
    slot = static_cast<std::uint32_t>(sides_.size());
    sides_.push_back(side);
  } else {
    slot = free_sides_.back();
    free_sides_.pop_back();
    sides_[slot] = side;
  }
  items_[side.item].sides.push_back(slot);
  return slot;
}

void ItemTable::set_hash(std::uint32_t slot, const ItemHash::Words& hash) {
  items_[slot].hash = hash;
  ItemHash::add_to(hash_, hash);
}

void ItemTable::remove_item(std::uint32_t slot) {
  ItemRecord& record = items_[slot];
  ItemHash::subtract_from(hash_, record.hash);
  slots_.erase(record.id);
  free_sides_.insert(free_sides_.end(), record.sides.begin(), record.sides.end());
  free_items_.push_back(slot);
  record.corners.clear();
  record.ring_ends.clear();
  record.sides.clear();
}

std::vector<ItemId> ItemTable::ids() const {
  std::vector<ItemId> result;
  result.reserve(slots_.size());
  for (const auto& [id, slot] : slots_) result.push_back(id);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace waywright::constraint
