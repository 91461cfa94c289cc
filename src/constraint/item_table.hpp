#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/memory_use.hpp"

#include "constraint/item_hash.hpp"
#include "memory/count.hpp"
#include "memory/free_list.hpp"
#include "memory/journal.hpp"
#include "memory/pages.hpp"
#include "mesh/index.hpp"

namespace waywright::constraint {

/// One straight side of an item, from corner to corner: what the edges that lie on it are used by. Its ends are
/// explicit vertices, whatever crosses it.
struct Side {
  std::uint32_t item = 0;  ///< slot in the item table
  mesh::Vertex from{};
  mesh::Vertex to{};
};

/// An item's corners, ring after ring, points that repeat their predecessor merged; and where each ring's corners end.
struct Outline {
  std::vector<mesh::Vertex> corners;
  std::vector<std::uint32_t> ring_ends;

  void clear() {
    corners.clear();
    ring_ends.clear();
  }
};

/// The live items by id and by slot, and their sides. Slot 0 is the domain itself, under the null id. Items that come
/// and go are logged and can be taken back to the last begin().
///
/// Worlds of a million points are why this is lean: an item owns no memory of its own. Its sides run in a ring through
/// the table of sides, from the last, which the item knows, to the first. Where ids count up, an item's id is its slot;
/// the others' ids are kept in pages, and their slots are found in an open table.
class ItemTable {
 public:
  static constexpr std::uint32_t kDomain = 0;

  ItemTable();

  [[nodiscard]] bool contains(ItemId id) const { return is_in_its_own_slot(id) || index_[position(id)] != kEmpty; }
  /// The slot of a live item. Requires: contains(id).
  [[nodiscard]] std::uint32_t slot(ItemId id) const {
    return is_in_its_own_slot(id) ? static_cast<std::uint32_t>(id.value) : index_[position(id)];
  }
  [[nodiscard]] ItemId id(std::uint32_t slot) const { return items_[slot].is_slot_id ? ItemId{slot} : ids_[slot]; }
  [[nodiscard]] ItemKind kind(std::uint32_t slot) const { return items_[slot].kind; }
  [[nodiscard]] bool is_polygon(std::uint32_t slot) const {
    return slot != kDomain && items_[slot].kind == ItemKind::polygon;
  }
  /// Of anything but a polygon, even_odd.
  [[nodiscard]] FillRule fill(std::uint32_t slot) const { return items_[slot].fill; }
  /// Whether a polygon of that slot covers what its rings turn around so often.
  [[nodiscard]] bool covers(std::uint32_t slot, std::int32_t turns) const {
    return fill(slot) == FillRule::even_odd ? turns % 2 != 0 : turns != 0;
  }
  [[nodiscard]] const Side& side(std::uint32_t slot) const { return sides_[slot].side; }
  /// The sum of the hashes of the live items and the domain.
  [[nodiscard]] const ItemHash::Words& hash() const { return hash_; }
  /// Live items, the domain left out.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool has_polygons() const { return polygon_count_ != 0; }
  /// Whether any polygon's fill rule is nonzero.
  [[nodiscard]] bool has_nonzero_polygons() const { return nonzero_count_ != 0; }

  /// Calls visit(side slot) for each of an item's sides that has a length, in order. No side may be added meanwhile.
  template <class Visit>
  void for_each_side(std::uint32_t item, Visit&& visit) const {
    for_each_link(item, [&](std::uint32_t slot) {
      if (side(slot).from != side(slot).to) visit(slot);
    });
  }

  /// Calls visit(corner, ends_ring) for each corner of an item, ring after ring: see Outline.
  template <class Visit>
  void for_each_corner(std::uint32_t item, Visit&& visit) const;
  /// Fills `outline`, for its memory.
  void outline(std::uint32_t item, Outline& outline) const;

  /// Makes room for so many more items, of the ids id_of(i) for i below that.
  template <class IdOf>
  void reserve(std::size_t count, IdOf&& id_of) {
    std::size_t elsewhere = 0;
    for (std::size_t i = 0; i < count; ++i) elsewhere += id_of(i).value != items_.size() + i ? 1 : 0;
    items_.reserve(items_.size() + count);
    make_room_in_index(elsewhere);
  }
  /// Has the place of an id fetched that is soon to be added.
  void prefetch(ItemId id) const;
  /// Requires: no item has that id.
  std::uint32_t add_item(ItemId id, ItemKind kind, FillRule fill);
  /// Gives an item its corners and sides. To be called once.
  void set_outline(std::uint32_t item, const Outline& outline);
  /// Counts in the hash of an item, or the sum of several. To be called once for each, when its corners are known.
  void add_hash(const ItemHash::Words& hash) { ItemHash::add_to(hash_, hash); }
  /// Forgets an item and its hash. Its slot and its sides' are reused from the next begin() on.
  void remove_item(std::uint32_t slot, const ItemHash::Words& hash);

  /// Starts the log anew.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  /// Of the live items, ascending. Fills `result`, for its memory.
  void ids(std::vector<ItemId>& result) const;
  [[nodiscard]] std::vector<ItemId> ids() const {
    std::vector<ItemId> result;
    ids(result);
    return result;
  }
  [[nodiscard]] ItemId largest_id_seen() const { return largest_id_seen_; }
  void see(ItemId id) { largest_id_seen_ = std::max(largest_id_seen_, id); }

  void count_memory(MemoryUse& use) const {
    memory::count(use, &MemoryUse::items, items_);
    memory::count(use, &MemoryUse::items, sides_);
    memory::count(use, &MemoryUse::items, index_);
    ids_.count_memory(use, &MemoryUse::items);
    journal_.count_memory(use);
  }
  /// Gives back spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() {
    memory::shrink(items_, sides_, index_);
    ids_.shrink_to_fit();
    journal_.release();
  }

 private:
  static constexpr std::uint32_t kEmpty = 0;  ///< in the index, where the domain never is
  static constexpr std::uint32_t kNone = memory::FreeList::kEnd;
  static constexpr std::uint32_t kEndsRing = 0x80000000;

  struct Record {
    /// Of a point, its corner; of anything else, its last side, by slot; of a free slot, the next free one.
    std::uint32_t place = kNone;
    ItemKind kind = ItemKind::point;
    bool is_slot_id = true;
    bool is_alive = false;  ///< never the domain
    FillRule fill = FillRule::even_odd;
  };
  struct Link {
    Side side;                   ///< of no length where a ring has one corner
    std::uint32_t next = kNone;  ///< the item's next side, after the last the first; with kEndsRing, the last of a ring
  };
  struct Undo {
    std::uint32_t slot;
    bool is_removal;
  };

  template <class Visit>
  void for_each_link(std::uint32_t item, Visit&& visit) const {
    if (items_[item].kind == ItemKind::point) return;
    const std::uint32_t last = items_[item].place;
    std::uint32_t slot = last;
    do {
      slot = sides_[slot].next & ~kEndsRing;
      visit(slot);
    } while (slot != last);
  }
  void add_side(std::uint32_t item, mesh::Vertex from, mesh::Vertex to, bool ends_ring);
  void recycle(std::uint32_t slot);
  /// Makes the item of a slot one that is found by its id.
  void enter(std::uint32_t slot);
  void leave(std::uint32_t slot);

  /// Whether a live item is in the slot that its id names: then the index doesn't have it.
  [[nodiscard]] bool is_in_its_own_slot(ItemId id) const {
    if (id.value >= items_.size()) return false;
    const Record& record = items_[static_cast<std::size_t>(id.value)];
    return record.is_alive && record.is_slot_id;
  }
  /// Where the index has an id, or the gap where it isn't.
  [[nodiscard]] std::size_t position(ItemId id) const;
  /// The gap for an id that the index doesn't have.
  [[nodiscard]] std::size_t gap_for(ItemId id) const;
  [[nodiscard]] std::size_t home(ItemId id) const;
  [[nodiscard]] std::size_t place_after(std::size_t at) const { return at + 1 == index_.size() ? 0 : at + 1; }
  [[nodiscard]] std::size_t way_round(std::size_t from, std::size_t to) const {
    return to >= from ? to - from : to + index_.size() - from;
  }
  void make_room_in_index(std::size_t count);
  void erase_from_index(ItemId id);

  std::vector<Record> items_;
  memory::Pages<ItemId> ids_;  ///< by slot, of items whose slot is another
  std::vector<Link> sides_;
  memory::FreeList free_items_;       ///< linked by Record::place
  memory::FreeList free_sides_;       ///< linked by Link::next
  std::vector<std::uint32_t> index_;  ///< slots that aren't their items' ids; at most two thirds are in use
  std::size_t index_size_ = 0;
  std::size_t size_ = 0;
  ItemId largest_id_seen_;
  ItemHash::Words hash_{};
  std::size_t polygon_count_ = 0;
  std::size_t nonzero_count_ = 0;  ///< of the polygons

  memory::Journal<Undo> journal_;
  ItemId largest_id_before_;
  std::size_t polygon_count_before_ = 0;
  std::size_t nonzero_count_before_ = 0;
  ItemHash::Words hash_before_{};
};

template <class Visit>
void ItemTable::for_each_corner(std::uint32_t item, Visit&& visit) const {
  const ItemKind kind = items_[item].kind;
  if (kind == ItemKind::point) return visit(mesh::Vertex{items_[item].place}, true);
  for_each_link(item, [&](std::uint32_t slot) {
    const auto& [side, next] = sides_[slot];
    const bool ends_ring = (next & kEndsRing) != 0;
    const bool has_open_end = ends_ring && kind != ItemKind::polygon && side.from != side.to;
    visit(side.from, ends_ring && !has_open_end);
    if (has_open_end) visit(side.to, true);
  });
}

}  // namespace waywright::constraint
