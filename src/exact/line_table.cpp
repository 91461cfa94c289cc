#include "exact/line_table.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/compiler.hpp"

namespace waywright::exact {

namespace {

/// Returns 0 or 1.
std::size_t bit_of(const std::array<std::uint64_t, 4>& key, std::uint32_t bit) {
  return static_cast<std::size_t>(key[bit / 64] >> (63 - bit % 64)) & 1;
}

/// Returns the first bit in which the keys differ. Requires: they differ.
std::uint32_t first_difference(const std::array<std::uint64_t, 4>& p, const std::array<std::uint64_t, 4>& q) {
  std::uint32_t word = 0;
  while (p[word] == q[word]) ++word;
  return 64 * word + static_cast<std::uint32_t>(std::countl_zero(p[word] ^ q[word]));
}

}  // namespace

std::size_t LineTable::size() const {
  const auto is_live = [](const Record& record) { return record.uses != kFree; };
  return static_cast<std::size_t>(std::count_if(records_.begin(), records_.end(), is_live));
}

void LineTable::free_unused() {
  for (const Slot line : changed_) {
    if (records_[line].uses == 0) free_line(line);
  }
  changed_.clear();
}

// After the caller has restored the uses, exactly the new lines have no use.
void LineTable::roll_back() {
  while (!changed_.empty()) {
    const Slot line = changed_.back();
    changed_.pop_back();
    if (records_[line].uses == 0) free_line(line);
  }
}

// The sums turn -0.0 into 0.0: the two compare equal, so they must have equal bits.
LineTable::Key LineTable::key_of(const PointPair& points) {
  const auto bits = [](const Point& p) {
    return std::array{base::bit_cast<std::uint64_t>(p.x + 0.0), base::bit_cast<std::uint64_t>(p.y + 0.0)};
  };
  const std::array a = bits(points.a);
  const std::array b = bits(points.b);
  return a < b ? Key{a[0], a[1], b[0], b[1]} : Key{b[0], b[1], a[0], a[1]};
}

/// Returns the line whose key has the same bit as `key` at each fork on the way to it. If a line has this key, it is
/// this line. Requires: the table has a line.
LineTable::Slot LineTable::candidate(const Key& key) const {
  Node node = root_;
  while ((node & kFork) != 0) {
    const Fork& fork = forks_[node & ~kFork];
    node = fork.children[bit_of(key, fork.bit)];
  }
  return node;
}

LineTable::Slot LineTable::find_or_make_in_trie(const PointPair& points) {
  if (root_ == kNone) return make(points);
  const Slot line = candidate(key_of(points));
  return is_line(line, points) ? line : make(points);
}

// If memory runs out, `changed_` lists exactly the new lines, and every record and every fork is in use or free.
LineTable::Slot LineTable::make(const PointPair& points) {
  if (free_records_.is_empty()) {
    records_.push_back({{}, kFree, kNone});
    records_.back().next = free_records_.push(static_cast<Slot>(records_.size() - 1));
  }
  if (forks_.size() < records_.size()) {
    forks_.push_back({0, {kNone, kNone}});
    forks_.back().children[0] = free_forks_.push(static_cast<std::uint32_t>(forks_.size() - 1));
  }
  const Slot line = free_records_.first();
  changed_.push_back(line);
  free_records_.pop(records_[line].next);
  records_[line] = {points, 0, kNone};
  link(line);
  return line;
}

void LineTable::link(Slot line) {
  if (root_ == kNone) {
    root_ = line;
    return;
  }
  const Key key = key_of(records_[line].points);
  const std::uint32_t bit = first_difference(key, key_of(records_[candidate(key)].points));
  Node* at = &root_;
  while ((*at & kFork) != 0 && forks_[*at & ~kFork].bit < bit) {
    Fork& fork = forks_[*at & ~kFork];
    at = &fork.children[bit_of(key, fork.bit)];
  }
  const std::uint32_t added = free_forks_.first();
  free_forks_.pop(forks_[added].children[0]);
  const std::size_t child = bit_of(key, bit);
  forks_[added].bit = bit;
  forks_[added].children[child] = line;
  forks_[added].children[1 - child] = std::exchange(*at, kFork | added);
}

void LineTable::free_line(Slot line) {
  const Key key = key_of(records_[line].points);
  Node* at = &root_;
  Node* fork_at = nullptr;  // the fork above the line
  std::size_t child = 0;
  while ((*at & kFork) != 0) {
    Fork& fork = forks_[*at & ~kFork];
    fork_at = at;
    child = bit_of(key, fork.bit);
    at = &fork.children[child];
  }
  if (fork_at == nullptr) {
    root_ = kNone;
  } else {
    const std::uint32_t removed = *fork_at & ~kFork;
    *fork_at = forks_[removed].children[1 - child];
    forks_[removed].children[0] = free_forks_.push(removed);
  }
  records_[line].uses = kFree;
  records_[line].next = free_records_.push(line);
}

}  // namespace waywright::exact
