#include "support/rollback_check.hpp"

#include <algorithm>
#include <vector>

#include "waywright/world.hpp"

#include "support/live_items.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"

namespace waywright::test {

namespace {

constexpr std::size_t kTicks = 8;
constexpr std::size_t kChanges = 10;  ///< of a tick
constexpr std::size_t kLiveItems = 24;

class Game {
 public:
  Game(Flavour flavour, std::uint64_t seed, std::size_t count)
      : script_(random_changes(flavour, seed, kTicks * kChanges * count, kLiveItems)),
        random_(seed),
        world_(World::create(script_.domain, options(seed)).value()),
        straight_(World::create(script_.domain, options(seed)).value()) {
    world_.keep_history(kTicks + 1);
  }

  RollbackReport run() {
    for (std::size_t next = 0; next < script_.steps.size() && report_.fault.empty(); next += kTicks * kChanges) {
      roll_back(next);
      ++report_.rollbacks;
    }
    return report_;
  }

 private:
  static WorldOptions options(std::uint64_t seed) {
    return {.keep_abstraction = seed % 4 != 0, .keep_bridges = seed % 3 == 0};
  }

  void roll_back(std::size_t next) {
    const ItemsHash before = world_.items_hash();
    const std::uint64_t first = world_.mark();
    for (std::size_t tick = 0; tick < kTicks; ++tick) predict(next);
    if (!world_.rewind(first).ok()) return fail("a rewind was refused");
    if (world_.items_hash() != before) return fail("a rewind led to other items");
    if (world_.mesh_hash() != straight_.mesh_hash()) return fail("a rewind led to another mesh");
    for (std::size_t tick = 0; tick < kTicks; ++tick) {
      for (std::size_t i = 0; i < kChanges; ++i) make_in_both(script_.steps[next + tick * kChanges + i]);
      world_.mark();
      if (world_.items_hash() != straight_.items_hash()) return fail("the items differ after a rollback");
    }
    if (world_.mesh_hash() != straight_.mesh_hash()) return fail("the mesh differs after a rollback");
  }

  /// Makes steps that come at about this time, in another order, so that many items and ids are real ones.
  void predict(std::size_t next) {
    const std::size_t upcoming = std::min(kTicks * kChanges, script_.steps.size() - next);
    std::size_t made = 0;
    for (std::size_t i = 0; i < 8 * kChanges && made < kChanges; ++i) {
      const Step& step = script_.steps[next + random_.below(upcoming)];
      if (world_.apply(step.changes).ok()) made += step.changes.size();
    }
    report_.changes += made;
    world_.mark();
  }

  void make_in_both(const Step& step) {
    const Result<std::vector<ItemId>> done = world_.apply(step.changes);
    const Result<std::vector<ItemId>> straight = straight_.apply(step.changes);
    if (done.ok() != straight.ok() || (done && *done != *straight)) fail("the worlds answer differently");
  }

  void fail(const char* fault) {
    if (report_.fault.empty()) report_.fault = fault + (", rollback " + std::to_string(report_.rollbacks));
  }

  ChangeScript script_;
  Random random_;
  World world_, straight_;
  RollbackReport report_;
};

}  // namespace

RollbackReport check_rollbacks(Flavour flavour, std::uint64_t seed, std::size_t count) {
  return Game(flavour, seed, count).run();
}

}  // namespace waywright::test
