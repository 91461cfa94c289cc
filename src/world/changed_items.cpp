#include "world/changed_items.hpp"

#include <algorithm>

namespace waywright {

void ChangedItems::forget_until(std::uint64_t version) { complete_since_ = std::max(complete_since_, version); }

// If an item has changed after `complete_since_`, the record has an entry for this change already. So no new entry
// needs a version after `complete_since_`, and the entries stay in ascending order.
void ChangedItems::extend_to(std::uint64_t version, std::vector<Entry> changed) {
  drop_forgotten();
  for (Entry& entry : changed) entry.version = std::min(entry.version, complete_since_);
  keep_last(changed);
  entries_.insert(entries_.begin(), changed.begin(), changed.end());
  complete_since_ = version;
}

void ChangedItems::since(std::uint64_t version, std::vector<ItemId>& ids) {
  const auto after = [](std::uint64_t since, const Entry& entry) { return since < entry.version; };
  found_.assign(std::upper_bound(entries_.begin(), entries_.end(), version, after), entries_.end());
  keep_last(found_);
  ids.clear();
  for (const Entry& entry : found_) ids.push_back(entry.id);
}

void ChangedItems::keep_last(std::vector<Entry>& entries) {
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.id != b.id ? a.id < b.id : a.version > b.version; });
  entries.erase(
      std::unique(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.id == b.id; }),
      entries.end());
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.version != b.version ? a.version < b.version : a.id < b.id;
  });
}

void ChangedItems::drop_forgotten() {
  std::erase_if(entries_, [&](const Entry& entry) { return entry.version <= complete_since_; });
}

void ChangedItems::make_room(std::uint64_t version) {
  drop_forgotten();
  keep_last(entries_);
  if (entries_.size() > limit_) {
    complete_since_ = entries_[entries_.size() / 2].version;
    drop_forgotten();
  }
  if (complete_since_ >= version) return;
  if (2 * entries_.size() >= entries_.capacity())
    entries_.reserve(std::max(kSmallestCapacity, 2 * entries_.capacity()));
}

}  // namespace waywright
