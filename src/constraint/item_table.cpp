#include "constraint/item_table.hpp"

#include <algorithm>

namespace waywright::constraint {

namespace {

/// Adds a free slot to a table. The list of free slots always has room for all of the table's.
template <class Entry>
void make_room(std::vector<Entry>& table, std::vector<std::uint32_t>& free_slots) {
  if (table.size() == table.capacity()) table.reserve(2 * table.size() + 1);
  free_slots.reserve(table.capacity());
  table.push_back({});
  free_slots.push_back(static_cast<std::uint32_t>(table.size() - 1));
}

}  // namespace

ItemTable::ItemTable() { items_.push_back({{}, ItemKind::polygon, {}, {}, {}, {}}); }

// Where memory runs out, what is logged is what was done, and every slot is in use or free.
std::uint32_t ItemTable::add_item(ItemId id, ItemKind kind) {
  if (free_items_.empty()) make_room(items_, free_items_);
  const std::uint32_t slot = free_items_.back();
  log_.push_back({slot, {}});
  free_items_.pop_back();
  items_[slot].id = id;
  items_[slot].kind = kind;
  slots_.emplace(id, slot);
  polygon_count_ += kind == ItemKind::polygon ? 1 : 0;
  largest_id_seen_ = std::max(largest_id_seen_, id);
  return slot;
}

std::uint32_t ItemTable::add_side(const Side& side) {
  if (free_sides_.empty()) make_room(sides_, free_sides_);
  const std::uint32_t slot = free_sides_.back();
  items_[side.item].sides.push_back(slot);
  free_sides_.pop_back();
  sides_[slot] = side;
  return slot;
}

void ItemTable::set_hash(std::uint32_t slot, const ItemHash::Words& hash) {
  items_[slot].hash = hash;
  ItemHash::add_to(hash_, hash);
}

void ItemTable::remove_item(std::uint32_t slot) {
  log_.push_back({slot, {}});
  log_.back().removed = slots_.extract(items_[slot].id);
  ItemHash::subtract_from(hash_, items_[slot].hash);
  polygon_count_ -= items_[slot].kind == ItemKind::polygon ? 1 : 0;
}

void ItemTable::begin() {
  for (const Undo& change : log_) {
    if (!change.removed.empty()) recycle(change.slot);
  }
  log_.clear();
  largest_id_before_ = largest_id_seen_;
  hash_before_ = hash_;
  polygon_count_before_ = polygon_count_;
}

// An entry that goes back into the table finds room there: the table has held as many before.
void ItemTable::roll_back() {
  for (; !log_.empty(); log_.pop_back()) {
    Undo& change = log_.back();
    if (!change.removed.empty()) {
      slots_.insert(std::move(change.removed));
    } else {
      slots_.erase(items_[change.slot].id);
      recycle(change.slot);
    }
  }
  largest_id_seen_ = largest_id_before_;
  hash_ = hash_before_;
  polygon_count_ = polygon_count_before_;
}

void ItemTable::recycle(std::uint32_t slot) {
  ItemRecord& record = items_[slot];
  for (const std::uint32_t side : record.sides) free_sides_.push_back(side);
  record.corners.clear();
  record.ring_ends.clear();
  record.sides.clear();
  free_items_.push_back(slot);
}

std::vector<ItemId> ItemTable::ids() const {
  std::vector<ItemId> result;
  result.reserve(slots_.size());
  for (const auto& [id, slot] : slots_) result.push_back(id);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace waywright::constraint
