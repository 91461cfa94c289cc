#include "support/changes_check.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/item.hpp"
#include "waywright/world.hpp"

#include "oracle/oracle.hpp"
#include "support/live_items.hpp"
#include "support/oracle_adapter.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using Fault = std::optional<std::string>;

std::string name_of(ItemId id) { return "item " + std::to_string(id.value); }

/// All state of a world that a refused step could change.
struct State {
  explicit State(const World& world) : dump(world.dump()), hash(world.items_hash()), ids(world.item_ids()) {}

  std::string dump;
  ItemsHash hash;
  std::vector<ItemId> ids;

  friend bool operator==(const State&, const State&) = default;
};

class ChangesCheck {
 public:
  ChangesCheck(const ChangeScript& script, std::uint64_t seed, const Comparisons& comparisons)
      : script_(script),
        options_{.keep_bridges = seed % 16 == 0},
        random_(seed),
        comparisons_(comparisons),
        live_(script.domain) {}

  ChangesReport run() {
    report_.fault = first_fault();
    return report_;
  }

 private:
  Fault first_fault() {
    Result<World> world = World::create(script_.domain, options_);
    if (!world) return "create: " + world.error().message();
    for (const Step& step : script_.steps) {
      if (const Fault fault = check_step(*world, step)) {
        return "step " + std::to_string(report_.counts.steps) + ": " + *fault;
      }
    }
    return check_mesh(*world, true, true);
  }

  Fault check_step(World& world, const Step& step) {
    ++report_.counts.steps;
    if (step.is_batch) ++report_.counts.batches;
    const Result<std::vector<ItemId>> expected = live_.apply(step);
    if (const Fault fault =
            expected ? check_done(world, step, *expected) : check_refused(world, step, expected.error()))
      return fault;
    ++report_.counts.validations;
    const Validation validation = world.validate();
    if (!validation.ok) return "validate: " + validation.fault;
    const bool with_rebuild = random_.below(1000) < comparisons_.with_rebuild;
    const bool with_oracle = random_.below(1000) < comparisons_.with_oracle;
    return check_mesh(world, with_rebuild, with_oracle);
  }

  Fault check_done(World& world, const Step& step, const std::vector<ItemId>& ids) {
    const Result<std::vector<ItemId>> done = perform(world, step);
    if (!done) return "refused: " + done.error().message();
    if (*done != ids) return "returned wrong ids";
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const Change::Kind kind = step.changes[i].kind;
      ++(kind == Change::Kind::insert   ? report_.counts.insertions
         : kind == Change::Kind::remove ? report_.counts.removals
                                        : report_.counts.replacements);
      if (const Fault fault = check_item(world, ids[i])) return fault;
    }
    std::vector<ItemId> live;
    for (const auto& [id, shape] : live_.items()) live.push_back(id);
    if (world.item_ids() != live || world.item_count() != live.size()) return "wrong items are live";
    return std::nullopt;
  }

  Fault check_item(const World& world, ItemId id) const {
    const auto found = live_.items().find(id);
    const bool is_live = found != live_.items().end();
    if (world.contains(id) != is_live) return "contains is wrong about " + name_of(id);
    const Result<Shape> shape = world.shape(id);
    if (shape.ok() != is_live) return "shape is wrong about whether " + name_of(id) + " is there";
    if (is_live && *shape != merged(found->second)) return "the shape of " + name_of(id) + " is wrong";
    return std::nullopt;
  }

  Fault check_refused(World& world, const Step& step, const Error& expected) {
    ++report_.counts.refusals;
    const State before(world);
    const Result<std::vector<ItemId>> done = perform(world, step);
    const std::string reason(to_string(expected.code));
    if (done) return "not refused, but should be: " + reason;
    if (done.error().code != expected.code) {
      return "refused as " + std::string(to_string(done.error().code)) + ", but should be as " + reason;
    }
    if (State(world) != before) return "a refused step (" + reason + ") changed the world";
    return std::nullopt;
  }

  Fault check_mesh(const World& world, bool with_rebuild, bool with_oracle) {
    if (!with_rebuild && !with_oracle) return std::nullopt;
    const std::string dump = world.dump();
    std::vector<Item> items;
    for (const auto& [id, shape] : live_.items()) items.push_back({id, shape});
    if (with_oracle) {
      ++report_.counts.oracles;
      const oracle::Oracle oracle(oracle::to_oracle(script_.domain, items));
      if (const Fault fault = oracle.check_dump(dump)) return "dump: " + *fault;
    }
    if (!with_rebuild) return std::nullopt;
    ++report_.counts.rebuilds;
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random_.below(i)]);
    Result<World> fresh = World::create(script_.domain);
    if (!fresh) return "create: " + fresh.error().message();
    for (const Item& item : items) {
      if (!fresh->insert(item.shape, item.id)) return "a fresh world refuses " + name_of(item.id);
    }
    if (const Fault fault = find_difference(world, dump, *fresh)) return fault;
    Result<World> copy = World::create(script_.domain);
    if (!copy || !copy->insert_all(world.items())) return "another world refuses the items";
    if (const Fault fault = find_difference(world, dump, *copy)) return "given its items: " + *fault;
    return std::nullopt;
  }

  static Fault find_difference(const World& world, std::string_view dump, const World& fresh) {
    if (fresh.dump() != dump) return "a fresh world has another dump";
    if (fresh.mesh_hash() != world.mesh_hash()) return "a fresh world has another mesh hash";
    if (fresh.items_hash() != world.items_hash()) return "a fresh world has another items hash";
    if (fresh.vertex_count() != world.vertex_count()) return "a fresh world has another vertex count";
    if (fresh.triangle_count() != world.triangle_count()) return "a fresh world has another triangle count";
    if (fresh.snapshot().vertices != world.snapshot().vertices) return "a fresh world has other nearest doubles";
    return std::nullopt;
  }

  const ChangeScript& script_;
  WorldOptions options_;
  Random random_;
  Comparisons comparisons_;
  LiveItems live_;
  ChangesReport report_;
};

using Fails = std::function<bool(const ChangeScript&)>;

/// Removes smaller and smaller runs from a list that belongs to `whole`, as long as `whole` still fails.
template <class Whole, class WholeFails, class List>
void shrink_list(Whole& whole, const WholeFails& fails, const List& list_of, std::size_t least) {
  for (std::size_t run = list_of(whole).size(); run > 0; run /= 2) {
    for (std::size_t first = 0; first < list_of(whole).size();) {
      Whole less = whole;
      auto& list = list_of(less);
      const std::size_t last = std::min(first + run, list.size());
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(first), list.begin() + static_cast<std::ptrdiff_t>(last));
      if (list.size() >= least && fails(less)) {
        whole = std::move(less);
      } else {
        first += run;
      }
    }
  }
}

void shrink_points(ChangeScript& script, const Fails& fails, std::size_t s, std::size_t c) {
  const ItemKind kind = script.steps[s].changes[c].shape.kind;
  if (kind == ItemKind::point || kind == ItemKind::segment) return;
  using RingLists = std::vector<std::vector<Point>>;
  RingLists rings = script.steps[s].changes[c].shape.rings;
  if (rings.empty()) return;
  const auto fails_with = [&](const RingLists& less) {
    ChangeScript changed = script;
    changed.steps[s].changes[c].shape.rings = less;
    return fails(changed);
  };
  shrink_list(rings, fails_with, std::identity(), 1);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    shrink_list(
        rings, fails_with, [&](RingLists & less) -> auto& { return less[r]; }, 1);
  }
  script.steps[s].changes[c].shape.rings = rings;
}

}  // namespace

ChangeCounts& ChangeCounts::operator+=(const ChangeCounts& other) {
  steps += other.steps;
  refusals += other.refusals;
  batches += other.batches;
  insertions += other.insertions;
  removals += other.removals;
  replacements += other.replacements;
  validations += other.validations;
  rebuilds += other.rebuilds;
  oracles += other.oracles;
  return *this;
}

ChangesReport check_changes(const ChangeScript& script, std::uint64_t seed, const Comparisons& comparisons) {
  return ChangesCheck(script, seed, comparisons).run();
}

ChangeScript shrink(ChangeScript script, const Fails& fails) {
  shrink_list(
      script, fails, [](ChangeScript & changed) -> auto& { return changed.steps; }, 0);
  for (std::size_t s = 0; s < script.steps.size(); ++s) {
    const std::size_t least = script.steps[s].is_batch ? 0 : 1;
    shrink_list(
        script, fails, [&](ChangeScript & changed) -> auto& { return changed.steps[s].changes; }, least);
    for (std::size_t c = 0; c < script.steps[s].changes.size(); ++c) shrink_points(script, fails, s, c);
  }
  return script;
}

std::string report_failure(const ChangeScript& script, const std::string& name, std::uint64_t seed) {
  // A comparison with a new world after every step finds most faults earlier than random comparisons do.
  constexpr Comparisons kAlways{1000, 1000};
  const Comparisons comparisons = check_changes(script, seed, {1000, 0}).fault ? Comparisons{1000, 0} : kAlways;
  const ChangeScript small = shrink(
      script, [&](const ChangeScript& less) { return check_changes(less, seed, comparisons).fault.has_value(); });
  const std::string text = to_script(small);
  const auto file = std::filesystem::temp_directory_path() / ("waywright-" + name + ".wws");
  std::ofstream(file, std::ios::binary) << text;
  const Fault fault = check_changes(small, seed, comparisons).fault;
  return name + ": " + (fault ? *fault : "fails now and then") + "\nshrunk to " + std::to_string(small.steps.size()) +
         " steps, " + file.string() + ":\n" + text;
}

}  // namespace waywright::test
