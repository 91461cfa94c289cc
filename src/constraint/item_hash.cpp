#include "constraint/item_hash.hpp"

#include <bit>

namespace waywright::constraint {

namespace {

// The finaliser of SplitMix64 (Steele, Lea and Flood 2014): a bijection under which every bit depends on every other.
std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

ItemHash::ItemHash(ItemId id, ItemKind kind, std::size_t ring_count) : words_{0, 1} {
  add(id.value);
  add(static_cast<std::uint64_t>(kind));
  add(ring_count);
}

void ItemHash::add(const Point& point) {
  add(std::bit_cast<std::uint64_t>(point.x));
  add(std::bit_cast<std::uint64_t>(point.y));
}

void ItemHash::add(std::uint64_t word) {
  for (std::uint64_t& lane : words_) lane = mix(lane ^ word);
}

void ItemHash::add_to(Words& sum, const Words& item) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += item[i];
}

void ItemHash::subtract_from(Words& sum, const Words& item) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] -= item[i];
}

}  // namespace waywright::constraint
