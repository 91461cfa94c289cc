#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/item.hpp"
#include "waywright/world.hpp"

#include "support/live_items.hpp"
#include "support/new_vertices.hpp"
#include "support/random_changes.hpp"

/// The checks that every sequence of operations on a world must pass. The fuzz target uses them, and so does the test
/// that replays its corpus.
namespace waywright::test {

/// Reads any bytes as a script. The first byte selects where points lie: on a lattice of 8 x 8, on a lattice of 16 x 16
/// that fills its domain, or at doubles with many digits. It also selects the fill rule: from 64 to 95, every other
/// polygon has the fill rule nonzero; otherwise no polygon has it. Each later point is one byte: half of its bits for
/// x, half for y. After the end all bytes are 0.
class BytesReader {
 public:
  explicit BytesReader(std::string_view bytes) : bytes_(bytes) {
    constexpr std::array<Box, 3> kDomains{
        {{{-1, -2}, {10, 9}}, {{0, 0}, {15, 15}}, {{-0x1p100, -0x1p100}, {0x1p100, 0x1p100}}}};
    const std::size_t first = next();
    manner_ = first % kDomains.size();
    has_nonzero_ = first / 32 == 2;
    script_.domain = kDomains[manner_];
  }

  ChangeScript read() {
    constexpr std::size_t kMostSteps = 60;
    LiveItems live(script_.domain);
    while (at_ < bytes_.size() && script_.steps.size() < kMostSteps) {
      script_.steps.push_back(step(live));
      static_cast<void>(live.apply(script_.steps.back()));
    }
    return std::move(script_);
  }

 private:
  static constexpr std::size_t kMostItems = 10;

  std::size_t next() { return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : 0; }

  double coordinate(std::size_t half) const {
    constexpr std::array<double, 16> kOdd{
        0.0,  0.1,      0.2,     0.3,     1.0,      0x1.0000000000001p0, 1.0 / 3, 2.0 / 3, 0.7, -0.1,
        -1.0, 0x1p-100, 0x1p-52, 0x1p100, -0x1p100, 0x1.fffffffffffffp99};
    if (manner_ == 2) return kOdd[half];
    return static_cast<double>(manner_ == 0 ? half % 8 : half);
  }

  Point point() {
    const std::size_t byte = next();
    return {coordinate(byte / 16), coordinate(byte % 16)};
  }

  Shape shape() {
    const std::size_t byte = next();
    const auto kind = static_cast<ItemKind>(byte % 4);
    const bool is_one_or_two = kind == ItemKind::point || kind == ItemKind::segment;
    const std::size_t count = kind == ItemKind::point ? 1 : kind == ItemKind::segment ? 2 : 1 + byte / 4 % 8;
    const std::size_t ring_count = kind == ItemKind::polygon ? 1 + byte / 32 % 3 : 1;
    Shape result{kind, {}};
    if (has_nonzero_ && kind == ItemKind::polygon && polygon_count_++ % 2 == 0) result.fill = FillRule::nonzero;
    for (std::size_t i = 0; i < ring_count; ++i) {
      result.rings.start_ring();
      for (std::size_t j = 0; j < count; ++j) result.rings.add_point(point());
    }
    // The last point of one shape in eight is outside the domain.
    if (!is_one_or_two && byte / 32 == 7) result.rings.back().back().x = script_.domain.max.x * 2;
    return result;
  }

  Change change(const LiveItems& live, std::size_t byte) {
    const ItemId id{byte / 16};
    const std::size_t count = live.items().size();
    const auto living = [&] {
      return count == 0 ? id : std::next(live.items().begin(), static_cast<std::ptrdiff_t>(id.value % count))->first;
    };
    const std::size_t choice = byte % 16;
    if (choice < 6 && count < kMostItems) {
      ItemId unused{1};
      while (live.items().contains(unused)) ++unused.value;
      return {Change::Kind::insert, unused, shape()};
    }
    if (choice < 11) return {Change::Kind::remove, living(), {}};
    if (choice < 14 || count >= kMostItems) return {Change::Kind::replace, living(), shape()};
    // The id may be in use, unknown or null.
    if (choice == 14) return {Change::Kind::insert, id, shape()};
    return {Change::Kind::remove, id, {}};
  }

  Step step(const LiveItems& live) {
    const std::size_t byte = next();
    if (byte % 16 != 15 || byte / 16 >= 8) return {{change(live, byte)}, false};
    Step batch{{}, true};
    LiveItems after = live;
    for (std::size_t count = byte / 16; count > 0; --count) {
      batch.changes.push_back(change(after, next()));
      static_cast<void>(after.apply({{batch.changes.back()}, false}));
    }
    return batch;
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t manner_ = 0;
  bool has_nonzero_ = false;
  std::size_t polygon_count_ = 0;
  ChangeScript script_;
};

/// Tries the step with a limit of one vertex fewer than it makes, and then sets the limit to what it makes. The step
/// makes the same vertices in `counted`. Returns what is wrong, or an empty string.
inline std::string fault_of_limit(World& world, World& counted, const Step& step) {
  const std::size_t made = count_new_vertices(counted, step);
  world.set_new_vertex_limit(made);
  if (made == 0) return "";
  world.set_new_vertex_limit(made - 1);
  const WorldState before(world);
  const Result<std::vector<ItemId>> done = perform(world, step);
  if (done || done.error().code != ErrorCode::too_many_vertices) return "not refused by its limit";
  if (!(WorldState(world) == before)) return "a step beyond its limit changed the world";
  world.set_new_vertex_limit(made);
  return "";
}

/// What a world was at a tick.
struct FuzzedTick {
  std::uint64_t tick;
  ItemsHash hash;
  std::string dump;
};

/// Returns what is wrong with an attempt to make the changes of a step. Empty if nothing is.
inline std::string fault_of_attempt(World& world, const Step& step) {
  const ItemsHash hash = world.items_hash();
  const Result<std::string> answer =
      world.attempt(step.changes, [](const World& changed) { return changed.validate().fault; });
  if (answer && !answer->empty()) return "validate in an attempt: " + *answer;
  return world.items_hash() == hash ? "" : "an attempt changed the items hash";
}

/// Returns what is wrong with a rewind. Empty if nothing is.
inline std::string fault_of_rewind(World& world, const FuzzedTick& to) {
  if (const Result<void> done = world.rewind(to.tick); !done) return "rewind: " + done.error().message();
  if (world.items_hash() != to.hash) return "a rewind brought another items hash";
  if (world.dump() != to.dump) return "a rewind brought another dump";
  const Validation validation = world.validate();
  return validation.ok ? "" : "validate after a rewind: " + validation.fault;
}

/// A snapshot that a reader holds, and what the world was when it was made.
struct HeldSnapshot {
  WorldSnapshot snapshot;
  std::string dump;

  /// Returns what is wrong with the snapshot. Empty if nothing is.
  [[nodiscard]] std::string fault() const {
    if (snapshot->dump() != dump) return "a snapshot has another dump";
    const Validation validation = snapshot->validate();
    return validation.ok ? "" : "validate of a snapshot: " + validation.fault;
  }
};

/// Returns what is wrong with a world after a step, or what is wrong with the step's result. Empty if nothing is.
/// `counted` is a world with the same items.
inline std::string fault_of_step(World& world, World& counted, LiveItems& live, const Step& step) {
  const Result<std::vector<ItemId>> expected = live.apply(step);
  if (expected) {
    if (std::string fault = fault_of_limit(world, counted, step); !fault.empty()) return fault;
  }
  const std::string before = expected ? std::string() : world.dump();
  const ItemsHash hash = world.items_hash();
  const Result<std::vector<ItemId>> done = perform(world, step);
  if (done.ok() != expected.ok()) return done ? "not refused" : "refused: " + done.error().message();
  if (!done && done.error().code != expected.error().code) return "refused as " + done.error().message();
  if (!done && (world.dump() != before || world.items_hash() != hash)) return "a refused step changed the world";
  if (done && *done != *expected) return "wrong ids returned";
  const Validation validation = world.validate();
  return validation.ok ? "" : "validate: " + validation.fault;
}

/// Checks that every step gives the expected result and leaves a valid mesh, that an attempt to make it leaves the
/// world as it was, that the last mesh equals the mesh of a new world, that snapshots stay as they are while the world
/// changes, and that rewinds bring back earlier ticks. Returns the first fault.
inline std::string fault_of_operations(std::string_view bytes) {
  const ChangeScript script = BytesReader(bytes).read();
  Result<World> world = World::create(script.domain, {.keep_bridges = true});
  if (!world) return world.error().message();
  World counted = World::create(script.domain, {.keep_abstraction = false}).value();
  LiveItems live(script.domain);
  std::vector<FuzzedTick> ticks;
  std::vector<HeldSnapshot> held;
  world->keep_history(1 + script.steps.size());
  for (std::size_t i = 0; i < script.steps.size(); ++i) {
    if (i % 4 == 0) ticks.push_back({world->mark(), world->items_hash(), world->dump()});
    world->set_new_vertex_limit(kNoVertexLimit);
    std::string fault = fault_of_attempt(*world, script.steps[i]);
    if (fault.empty()) fault = fault_of_step(*world, counted, live, script.steps[i]);
    if (i % 2 == 0) {
      held.push_back({world->publish(), world->dump()});
      const FuzzedTick& tick = ticks[i * 7 % ticks.size()];
      Result<WorldSnapshot> past = world->publish(tick.tick);
      if (!past) return "publish of a tick: " + past.error().message();
      held.push_back({*std::move(past), tick.dump});
      if (fault.empty() && held.size() > 2) fault = held[held.size() - 3].fault();
      // The readers release most snapshots after four further steps, and hold the others until the end.
      if (held.size() > 2 && i % 8 != 0) held.erase(held.end() - 3);
    }
    if (!fault.empty()) return "step " + std::to_string(i + 1) + ": " + fault;
  }
  Result<World> fresh = World::create(script.domain);
  for (auto item = live.items().rbegin(); item != live.items().rend(); ++item) {
    if (!fresh->insert(item->second, item->first)) return "a fresh world refuses an item";
  }
  if (fresh->dump() != world->dump()) return "a fresh world has another dump";
  if (fresh->items_hash() != world->items_hash()) return "a fresh world has another items hash";
  for (; !ticks.empty(); ticks.resize(ticks.size() / 2)) {
    if (const std::string fault = fault_of_rewind(*world, ticks.back()); !fault.empty()) return fault;
    held.push_back({world->publish(), world->dump()});
  }
  for (const HeldSnapshot& snapshot : held) {
    if (const std::string fault = snapshot.fault(); !fault.empty()) return fault;
  }
  return "";
}

}  // namespace waywright::test
