#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"

#include "constraint/item_hash.hpp"
#include "mesh/index.hpp"

namespace waywright::constraint {

/// One straight side of an item, from corner to corner: what the edges that lie on it are used by. Its ends are
/// explicit vertices, whatever crosses it.
struct Side {
  std::uint32_t item = 0;  ///< slot in the item table
  mesh::Vertex from{};
  mesh::Vertex to{};
};

/// An item as the mesh holds it.
struct ItemRecord {
  ItemId id;
  ItemKind kind = ItemKind::point;
  std::vector<mesh::Vertex> corners;     ///< ring after ring, points that repeat their predecessor merged
  std::vector<std::uint32_t> ring_ends;  ///< where each ring's corners end
  std::vector<std::uint32_t> sides;      ///< slots in the side table
  ItemHash::Words hash{};
};

/// The live items by id and by slot, and their sides. Slot 0 is the domain itself, under the null id. Items that come
/// and go are logged and can be taken back to the last begin().
class ItemTable {
 public:
  static constexpr std::uint32_t kDomain = 0;

  ItemTable();

  [[nodiscard]] bool contains(ItemId id) const { return slots_.contains(id); }
  /// The slot of a live item. Requires: contains(id).
  [[nodiscard]] std::uint32_t slot(ItemId id) const { return slots_.find(id)->second; }
  [[nodiscard]] const ItemRecord& item(std::uint32_t slot) const { return items_[slot]; }
  [[nodiscard]] ItemRecord& item(std::uint32_t slot) { return items_[slot]; }
  [[nodiscard]] const Side& side(std::uint32_t slot) const { return sides_[slot]; }
  /// The sum of the hashes of the live items and the domain.
  [[nodiscard]] const ItemHash::Words& hash() const { return hash_; }
  /// Live items, the domain left out.
  [[nodiscard]] std::size_t size() const { return slots_.size(); }
  [[nodiscard]] bool has_polygons() const { return polygon_count_ != 0; }

  std::uint32_t add_item(ItemId id, ItemKind kind);
  /// Appends a side to its item.
  std::uint32_t add_side(const Side& side);
  /// Counts an item's hash in. To be called once, when its corners are known.
  void set_hash(std::uint32_t slot, const ItemHash::Words& hash);
  /// Forgets an item. Its slot and its sides' are reused from the next begin() on.
  void remove_item(std::uint32_t slot);

  /// Starts the log anew.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  [[nodiscard]] std::vector<ItemId> ids() const;
  [[nodiscard]] ItemId largest_id_seen() const { return largest_id_seen_; }
  void see(ItemId id) { largest_id_seen_ = std::max(largest_id_seen_, id); }

 private:
  using Slots = std::unordered_map<ItemId, std::uint32_t>;

  struct Undo {
    std::uint32_t slot;
    Slots::node_type removed;  ///< of a removal, the item's entry in `slots_`; of an insertion, empty
  };

  void recycle(std::uint32_t slot);

  std::vector<ItemRecord> items_;
  std::vector<Side> sides_;
  std::vector<std::uint32_t> free_items_;  ///< has room for all
  std::vector<std::uint32_t> free_sides_;  ///< has room for all
  Slots slots_;
  ItemId largest_id_seen_;
  ItemHash::Words hash_{};
  std::size_t polygon_count_ = 0;

  std::vector<Undo> log_;
  ItemId largest_id_before_;
  std::size_t polygon_count_before_ = 0;
  ItemHash::Words hash_before_{};
};

}  // namespace waywright::constraint
