#include "locate/curve.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "base/compiler.hpp"
#include "memory/count.hpp"

namespace waywright::locate {

namespace {

struct Entry {
  Curve::Key key;
  std::uint32_t input_index;
};

constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr int kLowestBit = 64 - 3 * kDigitBits;
constexpr std::size_t kSmallestRadixSort = 1024;
constexpr std::size_t kPrefetchDistance = 16;

/// Sorts stably by the digit that starts at `bit`. Each thread counts and moves the entries of its own range. Of
/// entries with the same digit, the entries of threads with lower numbers come first.
void sort_by_digit(const std::vector<Entry>& from, std::vector<Entry>& to, int bit, const threads::ThreadTeam& team) {
  const auto digit = [bit](const Entry& entry) { return static_cast<std::size_t>(entry.key >> bit & (kDigits - 1)); };
  std::vector<std::array<std::uint32_t, kDigits>> offsets(team.threads());
  team.for_each_range(from.size(), [&](std::size_t t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++offsets[t][digit(from[i])];
  });
  std::uint32_t next = 0;
  for (std::size_t d = 0; d < kDigits; ++d) {
    for (auto& offsets_of_thread : offsets) next += std::exchange(offsets_of_thread[d], next);
  }
  team.for_each_range(from.size(), [&](std::size_t t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) to[offsets[t][digit(from[i])]++] = from[i];
  });
}

/// The first index from `at` on at which a run starts, or `end`. A run is a maximal range of entries whose keys agree
/// in all bits from `bit` on.
std::size_t start_of_run(const std::vector<Entry>& entries, std::size_t at, std::size_t end, int bit) {
  while (at > 0 && at < end && entries[at].key >> bit == entries[at - 1].key >> bit) ++at;
  return at;
}

/// Sorts by the upper bits of the keys, which distinguish more squares than there can be points, and then sorts each
/// run of entries with equal upper bits by the whole key and by (x, y).
void sort_entries(std::vector<Entry>& entries, std::span<const Point> points, const threads::ThreadTeam& team) {
  const auto before = [&](const Entry& a, const Entry& b) {
    if (a.key != b.key) return a.key < b.key;
    const Point& p = points[a.input_index];
    const Point& q = points[b.input_index];
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  };
  if (entries.size() < kSmallestRadixSort) {
    std::sort(entries.begin(), entries.end(), before);
    return;
  }
  {
    std::vector<Entry> other(entries.size());
    for (int bit = kLowestBit; bit < 64; bit += kDigitBits) {
      sort_by_digit(entries, other, bit, team);
      entries.swap(other);
    }
  }
  // Found before any thread moves an entry, because a thread must not read entries that another thread moves.
  std::vector<std::size_t> starts;
  for (std::size_t t = 0; t <= team.threads(); ++t) {
    starts.push_back(start_of_run(entries, team.start_of_range(entries.size(), t), entries.size(), kLowestBit));
  }
  team.run([&](std::size_t t) {
    const std::size_t last = starts[t + 1];
    for (std::size_t begin = starts[t]; begin < last;) {
      const std::size_t end = start_of_run(entries, begin + 1, last, kLowestBit);
      const auto first = entries.begin() + static_cast<std::ptrdiff_t>(begin);
      if (end > begin + 1) std::sort(first, first + static_cast<std::ptrdiff_t>(end - begin), before);
      begin = end;
    }
  });
}

}  // namespace

SortedPoints sort_along_curve(const Box& box, std::span<const Point> points, const threads::ThreadTeam& team) {
  const Curve curve(box);
  std::vector<Entry> entries(points.size());
  team.for_each_range(points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) entries[i] = {curve.key(points[i]), static_cast<std::uint32_t>(i)};
  });
  sort_entries(entries, points, team);

  const auto is_new = [&](std::size_t i) {
    return i == 0 || entries[i].key != entries[i - 1].key ||
           points[entries[i].input_index] != points[entries[i - 1].input_index];
  };
  std::vector<std::size_t> distinct(team.threads() + 1);
  team.for_each_range(entries.size(), [&](std::size_t t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) distinct[t + 1] += is_new(i) ? 1 : 0;
  });
  for (std::size_t t = 0; t < team.threads(); ++t) distinct[t + 1] += distinct[t];
  SortedPoints sorted;
  sorted.points.reserve(memory::with_spare(distinct.back() + 1));
  sorted.points.resize(distinct.back());
  sorted.keys.resize(distinct.back());
  sorted.ranks.resize(points.size());
  team.for_each_range(entries.size(), [&](std::size_t t, std::size_t begin, std::size_t end) {
    std::size_t next = distinct[t];
    for (std::size_t i = begin; i < end; ++i) {
      if (i + kPrefetchDistance < end) {
        const std::uint32_t ahead = entries[i + kPrefetchDistance].input_index;
        base::prefetch(&points[ahead]);
        base::prefetch_to_write(&sorted.ranks[ahead]);
      }
      if (is_new(i)) {
        sorted.points[next] = points[entries[i].input_index];
        sorted.keys[next] = entries[i].key;
        ++next;
      }
      sorted.ranks[entries[i].input_index] = static_cast<std::uint32_t>(next - 1);
    }
  });
  return sorted;
}

}  // namespace waywright::locate
