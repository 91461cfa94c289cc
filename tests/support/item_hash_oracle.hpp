#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

/// The hash of the items as docs/hashes.md defines it. Shares no code with the library.
namespace waywright::test::item_hash {

using Lanes = std::array<std::uint64_t, 2>;

inline std::uint64_t step_of_splitmix(std::uint64_t z) {
  z = z + 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

inline Lanes hash_of_words(const std::vector<std::uint64_t>& words) {
  Lanes lanes{0, 1};
  for (const std::uint64_t word : words) {
    lanes = {step_of_splitmix(lanes[0] ^ word), step_of_splitmix(lanes[1] ^ word)};
  }
  return lanes;
}

inline std::uint64_t bits(double value) {
  if (value == 0.0) return 0;
  std::uint64_t word = 0;
  std::memcpy(&word, &value, sizeof(word));
  return word;
}

/// Returns the words that docs/hashes.md defines for an item, computed from the points as the user gave them.
inline std::vector<std::uint64_t> words_of(ItemId id, const Shape& shape) {
  std::uint64_t kind = 3;
  if (shape.kind == ItemKind::point) kind = 0;
  if (shape.kind == ItemKind::segment) kind = 1;
  if (shape.kind == ItemKind::polyline) kind = 2;
  if (shape.kind == ItemKind::polygon && shape.fill == FillRule::nonzero) kind = 4;
  std::vector<std::uint64_t> words{id.value, kind, shape.rings.size()};
  for (const PointSpan& ring : shape.rings) {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> points;
    for (const Point& p : ring) {
      const std::pair point{bits(p.x), bits(p.y)};
      if (points.empty() || points.back() != point) points.push_back(point);
    }
    if (kind >= 3 && points.size() > 1 && points.front() == points.back()) points.pop_back();
    words.push_back(points.size());
    for (const auto& [x, y] : points) words.insert(words.end(), {x, y});
  }
  return words;
}

inline void add(Lanes& sum, const Lanes& lanes) { sum = {sum[0] + lanes[0], sum[1] + lanes[1]}; }

/// Returns the hash of a world over `domain` with these items.
inline Lanes hash_of(const Box& domain, const std::map<ItemId, Shape>& items) {
  const auto& [low, high] = domain;
  Lanes sum = hash_of_words(words_of({}, {ItemKind::polygon, {{low, {high.x, low.y}, high, {low.x, high.y}}}}));
  for (const auto& [id, shape] : items) add(sum, hash_of_words(words_of(id, shape)));
  return sum;
}

}  // namespace waywright::test::item_hash
