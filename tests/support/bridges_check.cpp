#include "support/bridges_check.hpp"

#include "constraint/constrained_triangulation.hpp"
#include "support/changes_check.hpp"
#include "support/live_items.hpp"
#include "support/random.hpp"
#include "world/layers.hpp"

namespace waywright::test {
namespace {

using Fault = std::optional<std::string>;

/// The layers of a world that keeps bridges.
class WithBridges {
 public:
  WithBridges(const Box& domain, const clearance::SearchLimits& limits)
      : layers_(constraint::ConstrainedTriangulation(domain), {false, true}, limits) {}

  enum class End : std::uint8_t { commit, roll_back };

  void make(const Step& step, const std::vector<ItemId>& ids, End end) {
    layers_.begin({});
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const Change& change = step.changes[i];
      if (change.kind != Change::Kind::insert) layers_.remove(ids[i]);
      if (change.kind != Change::Kind::remove) layers_.insert(change.shape, ids[i]);
    }
    layers_.update();
    if (end == End::commit) {
      layers_.commit();
    } else {
      layers_.roll_back();
    }
  }
  [[nodiscard]] Fault bridges_fault() const {
    const path::Ground ground = layers_.ground();
    return ground.bridges->find_fault(*ground.walls);
  }
  [[nodiscard]] Fault find_fault() const { return layers_.find_fault(); }
  void shrink_to_fit() { layers_.shrink_to_fit(); }

 private:
  Layers layers_;
};

Fault find_first_fault(const ChangeScript& script, std::uint64_t seed, BridgesReport& report) {
  Random random(seed ^ 0x6272696467657321U);
  LiveItems live(script.domain);
  // With small limits, nearly all searches use the tree of walls.
  const bool uses_tree = random.below(2) == 0;
  WithBridges world(script.domain, uses_tree ? clearance::SearchLimits{1, 0, 1} : clearance::SearchLimits{});
  for (std::size_t i = 0; i < script.steps.size(); ++i) {
    const Step& step = script.steps[i];
    const Result<std::vector<ItemId>> ids = live.apply(step);
    if (!ids) continue;
    const std::string name = "step " + std::to_string(i + 1) + ": ";
    if (random.below(8) == 0) {
      ++report.undone;
      world.make(step, *ids, WithBridges::End::roll_back);
      if (const Fault fault = world.bridges_fault()) return name + "undone: " + *fault;
    }
    report.changes += ids->size();
    world.make(step, *ids, WithBridges::End::commit);
    if (const Fault fault = world.bridges_fault()) return name + *fault;
    if (random.below(128) == 0) world.shrink_to_fit();
  }
  return world.find_fault();
}

}  // namespace

BridgesReport check_bridges(const ChangeScript& script, std::uint64_t seed) {
  BridgesReport report;
  report.fault = find_first_fault(script, seed, report);
  return report;
}

std::string report_bridges_failure(const ChangeScript& script, std::uint64_t seed) {
  const ChangeScript small =
      shrink(script, [&](const ChangeScript& less) { return check_bridges(less, seed).fault.has_value(); });
  return check_bridges(small, seed).fault.value_or("fails now and then") + "\nshrunk to " +
         std::to_string(small.steps.size()) + " steps:\n" + to_script(small);
}

}  // namespace waywright::test
