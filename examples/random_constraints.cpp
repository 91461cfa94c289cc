// Inserts random segments with ids that the program chooses, as the second test program of Chen's thesis (appendix)
// does. Then removes all segments again.

#include <cstdint>
#include <cstdio>
#include <random>

#include "waywright/waywright.hpp"

int main() {
  constexpr std::uint64_t kSegments = 100;
  waywright::World world = waywright::World::create({{-8000, -8000}, {8000, 8000}}).value();
  std::mt19937 random(2009);
  const auto coordinate = [&] { return static_cast<double>(random() % 16001) - 8000; };
  const std::string empty = world.dump();

  for (std::uint64_t id = 1; id <= kSegments; ++id) {
    const waywright::Point from{coordinate(), coordinate()};
    const waywright::Point to{coordinate(), coordinate()};
    world.insert_segment(from, to, {id}).value();
  }
  std::printf("%zu segments make %zu vertices, their crossings among them\n", world.item_count(), world.vertex_count());
  const bool is_valid = world.validate().ok;

  for (std::uint64_t id = 1; id <= kSegments; ++id) world.remove({id}).value();
  const bool is_restored = world.dump() == empty;
  std::printf("without them the world is %s\n", is_restored ? "what it was, bit for bit" : "not what it was");
  return is_valid && is_restored ? 0 : 1;
}
