#include "world/history.hpp"

#include <algorithm>
#include <limits>

namespace waywright {

void History::keep(std::size_t ticks) {
  drop_uncommitted();
  limit_ = ticks;
  if (limit_ != 0) return drop_oldest();
  marks_.drop_before(marks_.end());
  entries_.drop_before(entries_.end());
  ring_sizes_.drop_before(ring_sizes_.end());
  points_.drop_before(points_.end());
  shrink_to_fit();
}

History::Tick History::mark(std::uint64_t version, ItemId largest_id) {
  drop_uncommitted();
  marks_.push_back({entries_.end(), version, largest_id});
  drop_oldest();
  return marks_.end();
}

void History::drop_oldest() {
  if (marks_.end() - marks_.begin() <= limit_) return;
  marks_.drop_before(marks_.end() - limit_);
  const std::uint64_t first = marks_[marks_.begin()].first_entry;
  const bool is_empty = first == entries_.end();
  ring_sizes_.drop_before(is_empty ? ring_sizes_.end() : entries_[first].first_ring);
  points_.drop_before(is_empty ? points_.end() : entries_[first].first_point);
  entries_.drop_before(first);
}

void History::begin() { drop_uncommitted(); }

void History::commit() { committed_ = {entries_.end(), ring_sizes_.end(), points_.end()}; }

void History::truncate(const Ends& ends) {
  entries_.truncate(ends.entries);
  ring_sizes_.truncate(ends.ring_sizes);
  points_.truncate(ends.points);
}

/// If the ids of inserted items count up, as in a bulk load, only the first of these items takes memory.
void History::add_insertion(ItemId id) {
  if (!is_recording()) return;
  if (entries_.end() > committed_.entries) {
    Entry& last = entries_[entries_.end() - 1];
    const bool is_next = !last.was_live && last.id.value + last.count == id.value;
    if (is_next && last.count < std::numeric_limits<std::uint32_t>::max()) {
      ++last.count;
      return;
    }
  }
  entries_.push_back({id, ring_sizes_.end(), points_.end(), 1, ItemKind::point, FillRule::even_odd, false});
}

void History::add_removal(ItemId id, ItemKind kind, FillRule fill) {
  entries_.push_back({id, ring_sizes_.end(), points_.end(), 1, kind, fill, true});
}

void History::add_ring() { ring_sizes_.push_back(0); }

void History::add_point(const Point& point) {
  points_.push_back(point);
  ++ring_sizes_[ring_sizes_.end() - 1];
}

std::optional<Error> History::find_error(Tick tick) const {
  if (!is_kept()) {
    return Error{ErrorCode::no_history, "the world keeps no history: call keep_history() before mark()", {}, tick};
  }
  if (tick == 0 || tick > marks_.end()) {
    return Error{ErrorCode::unknown_tick,
                 "no mark has this tick: mark() has not returned it, or a rewind has dropped it",
                 {},
                 tick};
  }
  if (tick <= marks_.begin()) {
    return Error{
        ErrorCode::old_tick, "the history no longer has this tick: pass more ticks to keep_history()", {}, tick};
  }
  return std::nullopt;
}

std::uint64_t History::version(Tick tick) const { return marks_[tick - 1].version; }

ItemId History::largest_id(Tick tick) const { return marks_[tick - 1].largest_id; }

std::vector<History::ChangedItem> History::changed_since(Tick tick) {
  drop_uncommitted();
  std::vector<ChangedItem> found;
  for (std::uint64_t i = marks_[tick - 1].first_entry; i != entries_.end(); ++i) {
    for (std::uint32_t k = 0; k < entries_[i].count; ++k) found.push_back({{entries_[i].id.value + k}, i, i});
  }
  std::sort(found.begin(), found.end(),
            [](const ChangedItem& a, const ChangedItem& b) { return a.id != b.id ? a.id < b.id : a.entry < b.entry; });
  // The first entry of an item contains its state at the tick.
  std::size_t count = 0;
  for (const ChangedItem& item : found) {
    if (count != 0 && found[count - 1].id == item.id) {
      found[count - 1].last_entry = item.entry;
    } else {
      found[count++] = item;
    }
  }
  found.resize(count);
  return found;
}

std::optional<std::uint64_t> History::version_after(const ChangedItem& item) const {
  std::uint64_t first = marks_.begin();
  for (std::uint64_t end = marks_.end(); first != end;) {
    const std::uint64_t middle = first + (end - first) / 2;
    if (marks_[middle].first_entry > item.last_entry) {
      end = middle;
    } else {
      first = middle + 1;
    }
  }
  if (first == marks_.end()) return std::nullopt;
  return marks_[first].version;
}

void History::return_to(Tick tick) {
  const std::uint64_t first = marks_[tick - 1].first_entry;
  if (first != entries_.end()) truncate({first, entries_[first].first_ring, entries_[first].first_point});
  commit();
  marks_.truncate(tick);
}

// A world keeps a segment of length zero as one corner.
Shape History::shape(const ChangedItem& item) const {
  const Entry& entry = entries_[item.entry];
  const bool is_last = item.entry + 1 == entries_.end();
  const std::uint64_t ring_end = is_last ? ring_sizes_.end() : entries_[item.entry + 1].first_ring;
  Shape shape{entry.kind, {}, entry.fill};
  std::uint64_t point = entry.first_point;
  for (std::uint64_t ring = entry.first_ring; ring != ring_end; ++ring) {
    shape.rings.start_ring();
    for (std::uint32_t i = 0; i < ring_sizes_[ring]; ++i) shape.rings.add_point(points_[point++]);
  }
  const bool is_one_point = shape.kind == ItemKind::segment && shape.rings.points().size() == 1;
  if (is_one_point) shape.rings.add_point(shape.rings[0][0]);
  return shape;
}

void History::count_memory(MemoryUse& use) const {
  marks_.count_memory(use, &MemoryUse::history);
  entries_.count_memory(use, &MemoryUse::history);
  ring_sizes_.count_memory(use, &MemoryUse::history);
  points_.count_memory(use, &MemoryUse::history);
}

void History::shrink_to_fit() {
  marks_.shrink_to_fit();
  entries_.shrink_to_fit();
  ring_sizes_.shrink_to_fit();
  points_.shrink_to_fit();
}

}  // namespace waywright
