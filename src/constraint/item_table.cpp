#include "constraint/item_table.hpp"

#include <algorithm>

#include "base/compiler.hpp"
#include "constraint/item_hash.hpp"

namespace waywright::constraint {

namespace {

constexpr std::size_t kSmallestIndex = 16;

}  // namespace

ItemTable::ItemTable() : index_(kSmallestIndex, kEmpty) {
  items_.push_back(kNone);
  traits_.grow_to(1);
  traits_.make_room(kDomain);
  traits_[kDomain].kind = ItemKind::polygon;
}

void ItemTable::prefetch(ItemId id) const { base::prefetch_to_write(&index_[home_bucket(id)]); }

// If memory runs out, the undo log lists exactly the changes that were made, and every slot is in use or free.
std::uint32_t ItemTable::add_item(ItemId id, ItemKind kind, FillRule fill) {
  if (free_items_.is_empty()) {
    traits_.grow_to(items_.size() + 1);
    items_.push_back(kNone);
    items_.back() = free_items_.push(static_cast<std::uint32_t>(items_.size() - 1));
  }
  const std::uint32_t slot = free_items_.first();
  const bool is_slot_id = id.value == slot;
  if (!is_slot_id) {
    make_room_in_index(1);
    ids_.grow_to(items_.size());
    ids_.make_room(slot);
    ids_[slot] = id;
  }
  const bool is_plain = is_slot_id && kind == ItemKind::point;
  if (!is_plain) traits_.make_room(slot);
  journal_.add({slot, false});
  free_items_.pop(items_[slot]);
  items_[slot] = kNone;
  const FillRule stored_fill = kind == ItemKind::polygon ? fill : FillRule::even_odd;
  if (traits_.has_room(slot)) {
    Traits traits;
    traits.kind = kind;
    traits.fill = stored_fill;
    traits.has_other_id = !is_slot_id;
    traits_[slot] = traits;
  }
  register_item(slot);
  polygon_count_ += kind == ItemKind::polygon ? 1 : 0;
  nonzero_count_ += stored_fill == FillRule::nonzero ? 1 : 0;
  largest_id_seen_ = std::max(largest_id_seen_, id);
  return slot;
}

void ItemTable::set_outline(std::uint32_t item, const Outline& outline) {
  if (kind(item) == ItemKind::point) {
    items_[item] = (items_[item] & kPlain) | number(outline.corners[0]);
  } else {
    add_sides(item, outline);
  }
}

void ItemTable::add_sides(std::uint32_t item, const Outline& outline) {
  const ItemKind kind = this->kind(item);
  const auto& corners = outline.corners;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : outline.ring_ends) {
    const bool returns = kind == ItemKind::polygon || end - begin == 1;
    for (std::uint32_t i = begin; i + 1 < end; ++i)
      add_side(item, corners[i], corners[i + 1], !returns && i + 2 == end);
    if (returns) add_side(item, corners[end - 1], corners[begin], true);
    begin = end;
  }
}

void ItemTable::add_side(std::uint32_t item, mesh::Vertex from, mesh::Vertex to, bool ends_ring) {
  if (free_sides_.is_empty()) {
    sides_.push_back({{}, kNone});
    sides_.back().next = free_sides_.push(static_cast<std::uint32_t>(sides_.size() - 1));
  }
  const std::uint32_t slot = free_sides_.pop(sides_[free_sides_.first()].next & ~kEndsRing);
  std::uint32_t& last = items_[item];
  std::uint32_t next = slot;
  if (last != kNone) {
    std::uint32_t& link = sides_[last].next;
    next = link & ~kEndsRing;
    link = slot | (link & kEndsRing);
  }
  sides_[slot] = {{item, from, to}, ends_ring ? next | kEndsRing : next};
  last = slot;
}

void ItemTable::outline(std::uint32_t item, Outline& outline) const {
  outline.clear();
  for_each_corner(item, [&](mesh::Vertex corner, bool ends_ring) {
    outline.corners.push_back(corner);
    if (ends_ring) outline.ring_ends.push_back(static_cast<std::uint32_t>(outline.corners.size()));
  });
}

void ItemTable::remove_item(std::uint32_t slot, const ItemHash::Words& hash) {
  journal_.add({slot, true});
  unregister_item(slot);
  ItemHash::subtract_from(hash_, hash);
  polygon_count_ -= kind(slot) == ItemKind::polygon ? 1 : 0;
  nonzero_count_ -= fill(slot) == FillRule::nonzero ? 1 : 0;
}

void ItemTable::begin() {
  journal_.for_each([&](const Undo& change) {
    if (change.is_removal) free_slots(change.slot);
  });
  journal_.begin();
  largest_id_before_ = largest_id_seen_;
  hash_before_ = hash_;
  polygon_count_before_ = polygon_count_;
  nonzero_count_before_ = nonzero_count_;
}

// There is room for an id that returns to the index, because the index had as many entries before.
void ItemTable::roll_back() {
  journal_.roll_back([&](const Undo& change) {
    if (change.is_removal) {
      register_item(change.slot);
    } else {
      unregister_item(change.slot);
      free_slots(change.slot);
    }
  });
  largest_id_seen_ = largest_id_before_;
  hash_ = hash_before_;
  polygon_count_ = polygon_count_before_;
  nonzero_count_ = nonzero_count_before_;
}

/// Frees the slot of an item and the slots of its sides, which form a circular list.
void ItemTable::free_slots(std::uint32_t slot) {
  std::uint32_t& record = items_[slot];
  if (kind(slot) != ItemKind::point && record != kNone) {
    const std::uint32_t first = sides_[record].next & ~kEndsRing;
    sides_[record].next = free_sides_.push(first);  // the whole circular list
  }
  record = free_items_.push(slot);
}

void ItemTable::register_item(std::uint32_t slot) {
  ++size_;
  if (!traits_.has_room(slot)) {
    items_[slot] |= kPlain;
    return;
  }
  Traits& traits = traits_[slot];
  traits.is_live = true;
  if (!traits.has_other_id) {
    if (traits.kind == ItemKind::point) items_[slot] |= kPlain;
    return;
  }
  index_[empty_bucket_for(ids_[slot])] = slot;
  ++index_size_;
}

// If the item is plain, its traits (if there is room for them) are Traits{}, except that `is_live` may be true.
void ItemTable::unregister_item(std::uint32_t slot) {
  --size_;
  items_[slot] &= ~kPlain;
  if (!traits_.has_room(slot)) return;
  traits_[slot].is_live = false;
  if (!traits_[slot].has_other_id) return;
  erase_from_index(ids_[slot]);
  --index_size_;
}

void ItemTable::ids(std::vector<ItemId>& result) const {
  result.clear();
  result.reserve(size_);
  for (std::uint32_t slot = 0; slot < items_.size(); ++slot) {
    if (is_live(slot)) result.push_back(id(slot));
  }
  std::sort(result.begin(), result.end());
}

// Linear probing. A removal moves later entries to earlier buckets, so that no search stops too early.
// Source: Knuth, *The Art of Computer Programming* 3, 6.4, algorithms L and R.
std::size_t ItemTable::home_bucket(ItemId id) const {
  return static_cast<std::size_t>((mix(id.value) >> 32) * index_.size() >> 32);
}

std::size_t ItemTable::bucket_of(ItemId id) const {
  std::size_t bucket = home_bucket(id);
  while (index_[bucket] != kEmpty && ids_[index_[bucket]] != id) bucket = next_bucket(bucket);
  return bucket;
}

// Reads no ids, because the ids of the entries are at unrelated addresses in memory.
std::size_t ItemTable::empty_bucket_for(ItemId id) const {
  std::size_t bucket = home_bucket(id);
  while (index_[bucket] != kEmpty) bucket = next_bucket(bucket);
  return bucket;
}

void ItemTable::make_room_in_index(std::size_t count) {
  const std::size_t needed = (3 * (index_size_ + count) + 1) / 2;
  if (needed <= index_.size()) return;
  memory::Array<std::uint32_t> larger(std::max(needed, 2 * index_.size()), kEmpty);
  index_.swap(larger);
  for (const std::uint32_t slot : larger) {
    if (slot != kEmpty) index_[empty_bucket_for(ids_[slot])] = slot;
  }
}

void ItemTable::erase_from_index(ItemId id) {
  std::size_t empty = bucket_of(id);
  for (std::size_t bucket = next_bucket(empty); index_[bucket] != kEmpty; bucket = next_bucket(bucket)) {
    if (probe_distance(home_bucket(ids_[index_[bucket]]), bucket) < probe_distance(empty, bucket)) continue;
    index_[empty] = index_[bucket];
    empty = bucket;
  }
  index_[empty] = kEmpty;
}

}  // namespace waywright::constraint
