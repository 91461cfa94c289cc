#include "exact/line_table.hpp"

#include <algorithm>
#include <utility>

#include "base/bit_cast.hpp"

namespace waywright::exact {

namespace {

std::uint64_t hash_of(const Point& point) {
  std::uint64_t hash = base::bit_cast<std::uint64_t>(point.x) * 0x9e3779b97f4a7c15u;
  hash = ((hash ^ (hash >> 32)) + base::bit_cast<std::uint64_t>(point.y)) * 0xbf58476d1ce4e5b9u;
  hash = (hash ^ (hash >> 32)) * 0x94d049bb133111ebu;
  return hash ^ (hash >> 31);
}

}  // namespace

std::size_t LineTable::size() const {
  const auto is_live = [](const Record& record) { return record.uses != kFree; };
  return static_cast<std::size_t>(std::count_if(records_.begin(), records_.end(), is_live));
}

void LineTable::free_unused() {
  for (const Number line : changed_) {
    if (records_[line].uses == 0) free_line(line);
  }
  changed_.clear();
}

// After the caller has restored the uses, exactly the new lines have no use.
void LineTable::roll_back() {
  while (!changed_.empty()) {
    const Number line = changed_.back();
    changed_.pop_back();
    if (records_[line].uses == 0) free_line(line);
  }
}

// The sum of two hashes does not depend on the order of the two points.
std::size_t LineTable::bucket_of(const PointPair& points) const {
  return static_cast<std::size_t>(hash_of(points.a) + hash_of(points.b)) & (buckets_.size() - 1);
}

LineTable::Number LineTable::find_or_make_by_hash(const PointPair& points) {
  if (buckets_.empty()) return make(points);
  Number line = buckets_[bucket_of(points)];
  while (line != kNone && !is_line(line, points)) line = records_[line].next;
  return line == kNone ? make(points) : line;
}

// If memory runs out, `changed_` lists exactly the new lines, and every record is in use or free.
LineTable::Number LineTable::make(const PointPair& points) {
  if (free_records_.is_empty()) {
    records_.push_back({{}, kFree, kNone});
    records_.back().next = free_records_.push(static_cast<Number>(records_.size() - 1));
  }
  if (buckets_.size() < records_.size()) grow_buckets();
  const Number line = free_records_.first();
  changed_.push_back(line);
  free_records_.pop(records_[line].next);
  records_[line] = {points, 0, kNone};
  link(line);
  return line;
}

void LineTable::free_line(Number line) {
  Record& record = records_[line];
  Number* link = &buckets_[bucket_of(record.points)];
  while (*link != line) link = &records_[*link].next;
  *link = record.next;
  record.uses = kFree;
  record.next = free_records_.push(line);
}

void LineTable::grow_buckets() {
  buckets_ = std::vector<Number>(std::max(kFewestBuckets, 2 * buckets_.size()), kNone);
  for (Number line = 0; line < records_.size(); ++line) {
    if (records_[line].uses != kFree) link(line);
  }
}

void LineTable::link(Number line) {
  Number& first = buckets_[bucket_of(records_[line].points)];
  records_[line].next = std::exchange(first, line);
}

}  // namespace waywright::exact
