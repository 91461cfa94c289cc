#include "constraint/item_hash.hpp"

#include "base/bit_cast.hpp"
#include "constraint/mix.hpp"

namespace waywright::constraint {

ItemHash::ItemHash(ItemId id, ItemKind kind, FillRule fill, std::size_t ring_count) : words_{0, 1} {
  constexpr std::uint64_t kNonzeroPolygon = 4;
  const bool is_nonzero = kind == ItemKind::polygon && fill == FillRule::nonzero;
  add(id.value);
  add(is_nonzero ? kNonzeroPolygon : static_cast<std::uint64_t>(kind));
  add(ring_count);
}

void ItemHash::add(const Point& point) {
  add(base::bit_cast<std::uint64_t>(point.x));
  add(base::bit_cast<std::uint64_t>(point.y));
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
