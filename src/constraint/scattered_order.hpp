#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "constraint/mix.hpp"

// The order in which an operation inserts or removes many vertices. Along a ring, each vertex is near the previous one,
// which saves time. But if the ring runs beside another wall, the insertion of the next vertex can replace half of the
// edges of the previous vertex, and then the time is quadratic. In random order, the expected number of edges of the
// next vertex is at most the mean of all vertices. The same is true of the sides of a batch and of the edges that they
// cross.

namespace waywright::constraint {

/// Adds up the costs of the vertices or sides that an operation has handled so far. A cost is a number of edges.
class CostWatch {
 public:
  /// `most` is the largest mean cost that the operation accepts: a few times the usual cost.
  explicit CostWatch(std::size_t most) : most_(most) {}

  void add(std::size_t cost) {
    cost_ += cost;
    allowed_ += most_;
  }
  /// Whether the mean cost is high: the operation then handles the rest in scattered order.
  [[nodiscard]] bool is_costly() const { return cost_ > allowed_; }

 private:
  std::size_t most_;
  std::size_t cost_ = 0;
  std::size_t allowed_ = 512;
};

/// Appends the numbers from `begin` to `end` - 1 in scattered order. The order depends only on the arguments. It
/// consists of groups: the first group has about half of the numbers, the second a quarter, and so on. If
/// `largest_last` is true, the groups come in the reverse order. A hash of a number decides to which group it belongs,
/// so each group is as good as a random sample. The numbers of a group ascend, so consecutive numbers of a group are
/// near each other. Source: Amenta, Choi and Rote, *Incremental constructions con BRIO*, SoCG 2003. Cost: linear.
inline void append_scattered(std::uint32_t begin, std::uint32_t end, bool largest_last,
                             std::vector<std::uint32_t>& order) {
  constexpr std::size_t kParts = 24;
  const auto part_of = [&](std::uint32_t i) {
    const std::size_t part = std::min<std::size_t>(static_cast<std::size_t>(std::countr_zero(mix(i))), kParts - 1);
    return largest_last ? kParts - 1 - part : part;
  };
  std::array<std::size_t, kParts + 1> begins{};
  for (std::uint32_t i = begin; i < end; ++i) ++begins[part_of(i) + 1];
  begins[0] = order.size();
  for (std::size_t part = 0; part < kParts; ++part) begins[part + 1] += begins[part];
  order.resize(order.size() + (end - begin));
  for (std::uint32_t i = begin; i < end; ++i) order[begins[part_of(i)]++] = i;
}

}  // namespace waywright::constraint
