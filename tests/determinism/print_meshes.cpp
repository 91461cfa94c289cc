#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include "waywright/world.hpp"

#include "support/live_items.hpp"
#include "support/random_changes.hpp"

/// Lets the worlds of a fixed set of scripts live, always the same, and prints their hashes after every step and their
/// meshes at the end: what must be equal byte for byte on every machine, compiler and optimisation level.
namespace waywright::test {
namespace {

constexpr std::uint64_t kScriptsOfFlavour = 40;
constexpr std::size_t kSteps = 60;
constexpr std::size_t kLiveItems = 25;

bool print_world(Flavour flavour, std::uint64_t seed) {
  const ChangeScript script = random_changes(flavour, seed, kSteps, kLiveItems);
  Result<World> world = World::create(script.domain);
  if (!world) return false;
  std::cout << "script " << to_string(flavour) << ' ' << seed << '\n';
  for (const Step& step : script.steps) {
    const Result<std::vector<ItemId>> done = perform(*world, step);
    std::cout << (done ? "done" : to_string(done.error().code)) << ' ' << to_string(world->items_hash()) << ' '
              << to_string(world->mesh_hash()) << '\n';
  }
  std::cout << world->dump();
  return true;
}

}  // namespace
}  // namespace waywright::test

int main() {
  for (const waywright::test::Flavour flavour : waywright::test::kFlavours) {
    for (std::uint64_t seed = 0; seed < waywright::test::kScriptsOfFlavour; ++seed) {
      if (!waywright::test::print_world(flavour, seed)) return 1;
    }
  }
  std::cout.flush();
  return std::cout.good() ? 0 : 1;
}
