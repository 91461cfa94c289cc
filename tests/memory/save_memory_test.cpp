#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "waywright/save.hpp"
#include "waywright/world.hpp"

#include "memory/allocations.hpp"
#include "support/random_changes.hpp"

namespace waywright::test {
namespace {

namespace fs = std::filesystem;

/// Returns a world in which the first steps of a script were made, after which it still has undo logs and free slots.
World half_done(const ChangeScript& script, const WorldOptions& options) {
  World world = World::create(script.domain, options).value();
  for (std::size_t i = 0; i < script.steps.size() / 2; ++i) static_cast<void>(world.apply(script.steps[i].changes));
  return world;
}

void expect_sound(const World& world, const std::string& dump) {
  ASSERT_EQ(world.dump(), dump);
  ASSERT_EQ(world.validate().fault, "");
}

constexpr WorldOptions kWithBridges{.keep_bridges = true};

TEST(CloneMemory, RunningOutOfItChangesNothingAndLeaksNothing) {
  for (const WorldOptions& options : {WorldOptions{}, kWithBridges}) {
    const World world = half_done(random_changes(Flavour::lattice, 3, 40, 12), options);
    const std::string dump = world.dump();
    const std::ptrdiff_t live = live_allocations();
    std::size_t n = 1;
    while (!gets_through(n, [&] { static_cast<void>(world.clone()); })) {
      ASSERT_EQ(live_allocations(), live) << n;
      ++n;
    }
    EXPECT_GT(n, 10U);
    expect_sound(world, dump);
  }
}

/// A copy must be able to take an operation back without allocating memory.
TEST(CloneMemory, ACopyTakesBackWhatItCannotFinish) {
  for (const WorldOptions& options : {WorldOptions{}, kWithBridges}) {
    const ChangeScript script = random_changes(Flavour::small, 5, 36, 12);
    const World world = half_done(script, options);
    const std::string dump = world.dump();
    for (std::size_t i = script.steps.size() / 2; i < script.steps.size(); ++i) {
      for (std::size_t n = 1;; ++n) {
        World copy = world.clone();
        const std::size_t before = allocation_count();
        if (gets_through(n, [&] { static_cast<void>(copy.apply(script.steps[i].changes)); })) break;
        ASSERT_EQ(allocation_count(), before + n) << "step " << i;
        ASSERT_NO_FATAL_FAILURE(expect_sound(copy, dump)) << "step " << i << ", allocation " << n;
      }
    }
  }
}

TEST(SaveMemory, RunningOutOfItIsReportedAndLeaksNothing) {
  const World world = half_done(random_changes(Flavour::lattice, 4, 40, 12), {});
  const std::ptrdiff_t live = live_allocations();
  bool is_saved = false;
  for (std::size_t n = 1; !is_saved; ++n) {
    const bool is_through = gets_through(n, [&] {
      std::ostringstream out;
      is_saved = save_world(world, out).ok();
    });
    is_saved = is_saved && is_through;
    ASSERT_EQ(live_allocations(), live) << n;
  }
}

TEST(LoadMemory, RunningOutOfItLeaksNothing) {
  for (const WorldOptions& options : {WorldOptions{}, kWithBridges}) {
    const World world = half_done(random_changes(Flavour::lattice, 6, 40, 12), options);
    std::stringstream stream;
    ASSERT_TRUE(save_world(world, stream).ok());
    const std::ptrdiff_t live = live_allocations();
    std::size_t n = 1;
    for (bool is_through = false; !is_through; ++n) {
      stream.clear();
      stream.seekg(0);
      is_through = gets_through(n, [&] { EXPECT_EQ(load_world(stream).value().items_hash(), world.items_hash()); });
      ASSERT_EQ(live_allocations(), live) << n;
    }
    EXPECT_GT(n, 20U);
  }
}

TEST(SaveMemory, RunningOutOfItLeavesTheOldFile) {
  const fs::path folder = fs::path(testing::TempDir()) / "waywright_save_memory";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string name = (folder / "a.wwb").string();
  const World world = half_done(random_changes(Flavour::lattice, 7, 40, 12), {});
  std::ofstream(name) << "old";
  bool is_saved = false;
  for (std::size_t n = 1; !is_saved; ++n) {
    const bool is_through = gets_through(n, [&] { is_saved = save_world_file(world, name).ok(); });
    is_saved = is_saved && is_through;
    ASSERT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << n;
    if (is_saved) break;
    std::ifstream in(name);
    ASSERT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "old") << n;
  }
  EXPECT_EQ(load_world_file(name).value().items_hash(), world.items_hash());
  fs::remove_all(folder);
}

}  // namespace
}  // namespace waywright::test
