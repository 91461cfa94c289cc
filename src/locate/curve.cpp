#include "locate/curve.hpp"

#include <array>
#include <cstddef>

namespace waywright::locate {

namespace {

struct Entry {
  Curve::Key key;
  std::uint32_t given;
};

constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr std::size_t kWorthwhile = 1024;

/// A stable sort by the digit that starts at `bit`.
void sort_by_digit(const std::vector<Entry>& from, std::vector<Entry>& to, int bit) {
  const auto digit = [bit](const Entry& entry) { return entry.key >> bit & (kDigits - 1); };
  std::array<std::uint32_t, kDigits> places{};
  for (const Entry& entry : from) ++places[digit(entry)];
  std::uint32_t next = 0;
  for (std::uint32_t& place : places) {
    const std::uint32_t count = place;
    place = next;
    next += count;
  }
  for (const Entry& entry : from) to[places[digit(entry)]++] = entry;
}

/// Sorts by the key's upper half, which tells apart as many cells as there may be points, and the runs that agree in it
/// by all there is.
void sort_entries(std::vector<Entry>& entries, std::span<const Point> points) {
  const auto before = [&](const Entry& a, const Entry& b) {
    if (a.key != b.key) return a.key < b.key;
    const Point& p = points[a.given];
    const Point& q = points[b.given];
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  };
  if (entries.size() < kWorthwhile) {
    std::sort(entries.begin(), entries.end(), before);
    return;
  }
  constexpr int kLowestBit = 64 - 3 * kDigitBits;
  {
    std::vector<Entry> other(entries.size());
    for (int bit = kLowestBit; bit < 64; bit += kDigitBits) {
      sort_by_digit(entries, other, bit);
      entries.swap(other);
    }
  }
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    for (end = begin + 1; end < entries.size(); ++end) {
      if (entries[end].key >> kLowestBit != entries[begin].key >> kLowestBit) break;
    }
    if (end > begin + 1) {
      std::sort(entries.begin() + static_cast<std::ptrdiff_t>(begin),
                entries.begin() + static_cast<std::ptrdiff_t>(end), before);
    }
  }
}

}  // namespace

SortedPoints sort_along_curve(const Box& box, std::span<const Point> points) {
  const Curve curve(box);
  std::vector<Entry> entries;
  entries.reserve(points.size());
  for (const Point& point : points) entries.push_back({curve.key(point), static_cast<std::uint32_t>(entries.size())});
  sort_entries(entries, points);

  std::size_t distinct = 0;
  const auto is_new = [&](std::size_t i) {
    return i == 0 || entries[i].key != entries[i - 1].key || points[entries[i].given] != points[entries[i - 1].given];
  };
  for (std::size_t i = 0; i < entries.size(); ++i) distinct += is_new(i) ? 1 : 0;
  SortedPoints sorted;
  sorted.points.reserve(distinct);
  sorted.keys.reserve(distinct);
  sorted.ranks.resize(points.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (is_new(i)) {
      sorted.points.push_back(points[entries[i].given]);
      sorted.keys.push_back(entries[i].key);
    }
    sorted.ranks[entries[i].given] = static_cast<std::uint32_t>(sorted.points.size() - 1);
  }
  return sorted;
}

}  // namespace waywright::locate
