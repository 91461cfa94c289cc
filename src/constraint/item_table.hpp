#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "constraint/item_hash.hpp"
#include "memory/array.hpp"
#include "memory/count.hpp"
#include "memory/journal.hpp"
#include "memory/pages.hpp"
#include "mesh/index.hpp"

namespace waywright::constraint {

/// One side of an item: the straight segment from corner to corner. The side is a user of each edge that lies on it.
/// The ends of a side are corners, so they are always explicit vertices.
struct Side {
  std::uint32_t item = 0;  ///< slot in the item table
  mesh::Vertex from{};
  mesh::Vertex to{};
};

/// The corners of an item, ring after ring, and the ends of the rings in this list. Consecutive points that are equal
/// are one corner.
struct Outline {
  std::vector<mesh::Vertex> corners;
  std::vector<std::uint32_t> ring_ends;

  void clear() {
    corners.clear();
    ring_ends.clear();
  }
};

/// The items by id and by slot, and their sides. Slot 0 is the domain itself, with the null id. An undo log records
/// which items are added and removed; roll_back() returns to the last begin().
///
/// The table is compact for worlds of a million points: an item owns no memory of its own. Its sides form a circular
/// list in the table of sides; the item stores the slot of its last side, which links to its first side. If the ids of
/// a world count up, the id of an item is its slot. Other ids are stored in pages, and a hash table with open
/// addressing (the index) finds their slots.
class ItemTable {
 public:
  static constexpr std::uint32_t kDomain = 0;

  ItemTable();

  [[nodiscard]] bool contains(ItemId id) const { return is_in_its_own_slot(id) || index_[bucket_of(id)] != kEmpty; }
  /// The slot of an item. Requires: contains(id).
  [[nodiscard]] std::uint32_t slot(ItemId id) const {
    return is_in_its_own_slot(id) ? static_cast<std::uint32_t>(id.value) : index_[bucket_of(id)];
  }
  [[nodiscard]] ItemId id(std::uint32_t slot) const { return traits(slot).has_other_id ? ids_[slot] : ItemId{slot}; }
  [[nodiscard]] ItemKind kind(std::uint32_t slot) const { return traits(slot).kind; }
  [[nodiscard]] bool is_polygon(std::uint32_t slot) const { return slot != kDomain && kind(slot) == ItemKind::polygon; }
  /// The fill rule of a polygon; even_odd for all other items.
  [[nodiscard]] FillRule fill(std::uint32_t slot) const { return traits(slot).fill; }
  /// Whether the polygon covers a face in which it has this winding number.
  [[nodiscard]] bool covers(std::uint32_t slot, std::int32_t winding_number) const {
    return is_filled(fill(slot), winding_number);
  }
  [[nodiscard]] const Side& side(std::uint32_t slot) const { return sides_[slot].side; }
  /// The sum of the hashes of all items and of the domain.
  [[nodiscard]] const ItemHash::Words& hash() const { return hash_; }
  /// The number of items, without the domain.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool has_polygons() const { return polygon_count_ != 0; }
  /// Whether there is a polygon with the fill rule nonzero.
  [[nodiscard]] bool has_nonzero_polygons() const { return nonzero_count_ != 0; }

  /// Calls visit(side slot) for each side of an item, in order, but for no side of length zero. `visit` must not add a
  /// side.
  template <class Visit>
  void for_each_side(std::uint32_t item, Visit&& visit) const {
    for_each_link(item, [&](std::uint32_t slot) {
      if (side(slot).from != side(slot).to) visit(slot);
    });
  }

  /// Calls visit(corner, ends_ring) for each corner of an item, ring after ring: see Outline.
  template <class Visit>
  void for_each_corner(std::uint32_t item, Visit&& visit) const;
  /// Whether a polygon has one ring. Cost: the number of corners of its first ring.
  [[nodiscard]] bool has_one_ring(std::uint32_t item) const {
    const std::uint32_t last = items_[item];
    std::uint32_t slot = sides_[last].next & ~kEndsRing;
    while ((sides_[slot].next & kEndsRing) == 0) slot = sides_[slot].next;
    return slot == last;
  }
  /// Fills `outline` with the corners of an item. Uses its memory again.
  void outline(std::uint32_t item, Outline& outline) const;

  /// Makes room for `count` more items, whose ids are id_of(i) for i below `count`.
  template <class IdOf>
  void reserve(std::size_t count, IdOf&& id_of) {
    std::size_t index_entries = 0;
    for (std::size_t i = 0; i < count; ++i) index_entries += id_of(i).value != items_.size() + i ? 1 : 0;
    const std::size_t needed = items_.size() + count;
    // Many small batches must not copy the array each time: so a capacity that is too small grows by at least half.
    if (needed > items_.capacity())
      items_.reserve(std::max(memory::with_spare(needed), items_.capacity() + items_.capacity() / 2));
    make_room_in_index(index_entries);
  }
  /// Prefetches the bucket at which the search for an id will start. The id will soon be added.
  void prefetch(ItemId id) const;
  /// Prefetches what contains(id) reads first.
  WAYWRIGHT_ALWAYS_INLINE void prefetch_record(ItemId id) const {
    if (id.value < items_.size()) base::prefetch_to_write(&items_[static_cast<std::size_t>(id.value)]);
    prefetch(id);
  }
  /// Prefetches the sides of an item, or some of them. Requires: the item is not a point.
  WAYWRIGHT_ALWAYS_INLINE void prefetch_sides(std::uint32_t item) const {
    base::prefetch_to_write(&sides_[items_[item]]);
  }
  /// Adds an item and returns its slot. Requires: no item has this id.
  std::uint32_t add_item(ItemId id, ItemKind kind, FillRule fill);
  /// Sets the corners and sides of an item. Call it once for each item.
  void set_outline(std::uint32_t item, const Outline& outline);
  /// Adds the hash of an item, or the sum of the hashes of several items. Add the hash of each item once.
  void add_hash(const ItemHash::Words& hash) { ItemHash::add_to(hash_, hash); }
  /// Removes an item and its hash. The next begin() frees its slot and the slots of its sides.
  void remove_item(std::uint32_t slot, const ItemHash::Words& hash);

  /// Empties the undo log.
  void begin();
  /// Undoes all changes since begin(). Allocates nothing.
  void roll_back();

  /// Fills `result` with the ids of all items, ascending. Uses its memory again.
  void ids(std::vector<ItemId>& result) const;
  [[nodiscard]] std::vector<ItemId> ids() const {
    std::vector<ItemId> result;
    ids(result);
    return result;
  }
  [[nodiscard]] ItemId largest_id_seen() const { return largest_id_seen_; }
  void mark_used(ItemId id) { largest_id_seen_ = std::max(largest_id_seen_, id); }
  /// Sets the largest id seen. roll_back() restores the old one. Requires: no item has a larger id.
  void set_largest_id_seen(ItemId id) { largest_id_seen_ = id; }

  void count_memory(MemoryUse& use) const {
    memory::count(use, &MemoryUse::items, items_);
    traits_.count_memory(use, &MemoryUse::items);
    memory::count(use, &MemoryUse::items, sides_);
    memory::count(use, &MemoryUse::items, index_);
    ids_.count_memory(use, &MemoryUse::items);
    journal_.count_memory(use);
  }
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() {
    memory::shrink(items_, sides_, index_);
    ids_.shrink_to_fit();
    traits_.shrink_to_fit();
    journal_.release();
  }

 private:
  static constexpr std::uint32_t kEmpty = 0;  ///< marks an empty bucket: the index never contains slot 0, the domain
  static constexpr std::uint32_t kNone = memory::FreeList::kEnd;
  static constexpr std::uint32_t kEndsRing = 0x80000000;

  /// Set in the record of a *plain* item: a live point whose slot is its id. No
  /// function reads the traits of a plain item.
  static constexpr std::uint32_t kPlain = 0x80000000;

  /// What the table stores of an item that is not plain, beside its record. Traits{} are the traits of a plain item
  /// that an operation has removed.
  struct Traits {
    ItemKind kind : 4 = ItemKind::point;
    FillRule fill : 2 = FillRule::even_odd;
    bool has_other_id : 1 = false;  ///< its id is not its slot
    bool is_live : 1 = false;       ///< false for the domain, too
  };
  struct Link {
    Side side;  ///< for a ring with one corner: `from` and `to` are this corner
    /// The next side of the item; after the last side, the first one. The bit kEndsRing marks the last side of a ring.
    std::uint32_t next = kNone;
  };
  struct Undo {
    std::uint32_t slot;
    bool is_removal;
  };

  template <class Visit>
  void for_each_link(std::uint32_t item, Visit&& visit) const {
    if (kind(item) == ItemKind::point) return;
    const std::uint32_t last = items_[item];
    std::uint32_t slot = last;
    do {
      slot = sides_[slot].next & ~kEndsRing;
      visit(slot);
    } while (slot != last);
  }
  void add_sides(std::uint32_t item, const Outline& outline);
  void add_side(std::uint32_t item, mesh::Vertex from, mesh::Vertex to, bool ends_ring);
  void free_slots(std::uint32_t slot);
  /// Marks the item of a slot as live, counts it and, if its slot is not its id, adds it to the index.
  /// unregister_item() does the opposite.
  void register_item(std::uint32_t slot);
  void unregister_item(std::uint32_t slot);

  /// The traits of a live item, of the domain or of an item that this operation has removed.
  [[nodiscard]] WAYWRIGHT_ALWAYS_INLINE Traits traits(std::uint32_t slot) const {
    return (items_[slot] & kPlain) == 0 && traits_.has_room(slot) ? traits_[slot] : Traits{};
  }
  [[nodiscard]] bool is_live(std::uint32_t slot) const {
    return (items_[slot] & kPlain) != 0 || (traits_.has_room(slot) && traits_[slot].is_live);
  }
  /// Whether an item has this id and its slot has the same number. The index does not contain such an item.
  [[nodiscard]] bool is_in_its_own_slot(ItemId id) const {
    if (id.value >= items_.size()) return false;
    const auto slot = static_cast<std::uint32_t>(id.value);
    return (items_[slot] & kPlain) != 0 || (is_live(slot) && !traits_[slot].has_other_id);
  }
  /// The bucket of the index with the slot of this id, or the empty bucket at which the search for the id ends.
  [[nodiscard]] std::size_t bucket_of(ItemId id) const;
  /// The empty bucket for an id that is not in the index.
  [[nodiscard]] std::size_t empty_bucket_for(ItemId id) const;
  /// The bucket at which the search for an id starts.
  [[nodiscard]] std::size_t home_bucket(ItemId id) const;
  [[nodiscard]] std::size_t next_bucket(std::size_t bucket) const {
    return bucket + 1 == index_.size() ? 0 : bucket + 1;
  }
  /// The number of buckets from `from` to `to`, onwards through the index.
  [[nodiscard]] std::size_t probe_distance(std::size_t from, std::size_t to) const {
    return to >= from ? to - from : to + index_.size() - from;
  }
  void make_room_in_index(std::size_t count);
  void erase_from_index(ItemId id);

  /// The records, by slot. For a point: its corner, and kPlain if the item is plain. For other items: the slot of their
  /// last side. For a free slot: the next free slot.
  memory::Array<std::uint32_t> items_;
  memory::Pages<Traits> traits_;  ///< by slot. A page without values contains only plain items and free slots.
  memory::Pages<ItemId> ids_;     ///< by slot, for items whose slot is not their id
  memory::Array<Link> sides_;
  memory::FreeList free_items_;         ///< linked by `items_`
  memory::FreeList free_sides_;         ///< linked by Link::next
  memory::Array<std::uint32_t> index_;  ///< slots of items whose slot is not their id; at most two thirds are in use
  std::size_t index_size_ = 0;
  std::size_t size_ = 0;
  ItemId largest_id_seen_;
  ItemHash::Words hash_{};
  std::size_t polygon_count_ = 0;
  std::size_t nonzero_count_ = 0;  ///< the number of polygons with the fill rule nonzero

  memory::Journal<Undo> journal_;
  ItemId largest_id_before_;
  std::size_t polygon_count_before_ = 0;
  std::size_t nonzero_count_before_ = 0;
  ItemHash::Words hash_before_{};
};

template <class Visit>
void ItemTable::for_each_corner(std::uint32_t item, Visit&& visit) const {
  const ItemKind kind = this->kind(item);
  if (kind == ItemKind::point) return visit(mesh::Vertex{items_[item] & ~kPlain}, true);
  for_each_link(item, [&](std::uint32_t slot) {
    const auto& [side, next] = sides_[slot];
    const bool ends_ring = (next & kEndsRing) != 0;
    const bool has_open_end = ends_ring && kind != ItemKind::polygon && side.from != side.to;
    visit(side.from, ends_ring && !has_open_end);
    if (has_open_end) visit(side.to, true);
  });
}

}  // namespace waywright::constraint
