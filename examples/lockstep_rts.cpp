// A lockstep game with rollback: 300 units, and five buildings that are placed or destroyed at every tick. Machines
// send one another only commands, and each command arrives up to 8 ticks late. A machine does not wait: it continues
// with commands that it predicts. If other commands arrive, it goes back to their tick by inverse operations and plays
// forward again. In the end, all machines have the same hash for every tick. docs/guides/lockstep.md explains how.
//
// usage: lockstep_rts [TICKS]
//
// The output depends on TICKS alone (default 600), so machines can be compared. Exits with 1 if any hashes differ.

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "waywright/waywright.hpp"

#include "lockstep/numbers.hpp"

namespace {

using waywright::Change;
using waywright::Item;
using waywright::ItemId;
using waywright::Path;
using waywright::PathAlgorithm;
using waywright::PathPosition;
using waywright::PathQuery;
using waywright::PathStatus;
using waywright::Point;
using waywright::Precision;
using waywright::Shape;
using waywright::World;

using Tick = std::size_t;

constexpr std::size_t kPlayers = 5;     // each places or destroys one building at every tick
constexpr std::size_t kUnits = 300;     // unit i belongs to player i % kPlayers
constexpr Tick kLongestDelay = 8;       // of a packet
constexpr Tick kRow = 8;                // buildings that a player places side by side
constexpr Tick kOpening = 8 * kRow;     // until this tick players only build
constexpr Tick kMeshHashEvery = 100;    // ticks
constexpr double kMapSize = 1200.0;     // metres
constexpr double kStep = 3.0;           // metres that a unit walks in a tick
constexpr double kBuildingSize = 40.0;  // metres, more than the largest
constexpr double kSpacing = 30.0;       // metres from one building of a row to the next
constexpr std::uint64_t kRockIds = 1;   // ids of the map's own items
constexpr std::size_t kRocks = 150;

Point point_of(std::uint64_t number) {
  return {rounded(20 + (kMapSize - 40) * share_of(2 * number)),
          rounded(20 + (kMapSize - 40) * share_of(2 * number + 1))};
}

// ---- The players' commands ----

struct Order {
  std::size_t unit = 0;
  Point goal;

  friend bool operator==(const Order&, const Order&) = default;
};

/// All commands of one player at one tick: the content of a packet.
struct Commands {
  std::optional<Item> building;  ///< to place
  ItemId destroyed;              ///< null for none
  std::vector<Order> orders;

  friend bool operator==(const Commands&, const Commands&) = default;
};

/// The game chooses the ids of its items. Ids that a world chooses would depend on what happened to that world before,
/// for example on a rollback.
ItemId building_id(std::size_t player, Tick tick) { return {std::uint64_t{player + 1} << 32 | (tick + 1)}; }

std::uint64_t number_of(std::size_t player, Tick tick) { return mixed(player * 1000003 + tick) >> 8; }

/// Returns the tick at which a player placed its building number `index`.
Tick tick_of_building(Tick index) { return index < kOpening ? index : index + (index - kOpening) / kRow * kRow + kRow; }

/// Players build in rows. After the opening, they destroy a row of old buildings before they build a row. At every
/// fourth tick they send two units to a goal.
Commands commands_of(std::size_t player, Tick tick) {
  Commands commands;
  const Tick row = tick / kRow;
  if (tick < kOpening || row % 2 == 1) {
    const Point first = point_of(number_of(player, row));
    const double shift = kSpacing * static_cast<double>(tick % kRow);
    const Point centre{first.x, first.y > kMapSize / 2 ? first.y - shift : first.y + shift};
    commands.building = {building_id(player, tick), building_at(centre, number_of(player, row))};
  } else {
    const Tick index = (tick - kOpening) / (2 * kRow) * kRow + tick % kRow;
    commands.destroyed = building_id(player, tick_of_building(index));
  }
  for (std::uint64_t i = 0; (tick + player) % 4 == 0 && i < 2; ++i) {
    const std::uint64_t number = number_of(player, tick) + i;
    const auto index = static_cast<std::size_t>(number % (kUnits / kPlayers));
    commands.orders.push_back({kPlayers * index + player, point_of(number)});
  }
  return commands;
}

/// Predicts the commands of a player whose packet has not arrived: the player continues with what it did at the tick
/// before, and gives no orders.
Commands predicted(const Commands& last, std::size_t player, Tick tick) {
  Commands commands;
  if (last.building) {
    const double offset = last.building->shape.rings[0][0].y > kMapSize / 2 ? -kSpacing : kSpacing;
    commands.building = {building_id(player, tick), translated(last.building->shape, 0, offset)};
  }
  if (!last.destroyed.is_null()) commands.destroyed = {last.destroyed.value + 1};
  return commands;
}

// ---- The game on each machine ----

struct Unit {
  PathPosition position;  ///< position.at is where the unit stands
  Point goal;
  std::shared_ptr<const Path> path;  ///< null if there is none; copies kept for a rollback share it
};

/// Half of the units keep their coordinates as `float`.
Precision precision_of(std::size_t unit) { return unit % 2 == 0 ? Precision::float64 : Precision::float32; }

/// The hash of the state that all machines share. It includes the mesh hash only at every kMeshHashEvery-th tick,
/// because the mesh hash is slow.
struct StateHash {
  waywright::ItemsHash items;
  std::uint64_t units = 0;
  waywright::MeshHash mesh;

  friend bool operator==(const StateHash&, const StateHash&) = default;
};

/// Counts of events on a machine. Rollbacks repeat some events.
struct Counts {
  std::size_t ticks = 0;
  std::size_t rollbacks = 0;
  Tick longest_rollback = 0;
  std::size_t paths = 0;
  std::size_t blocked = 0;  ///< paths that a building has blocked
  std::size_t moved = 0;    ///< units that a building has pushed aside
};

/// Settings in which machines may differ without an effect on the results.
struct MachineOptions {
  std::size_t threads = 1;
  bool asks_is_affected = true;  ///< before is_clear(), which takes longer
};

class Machine {
 public:
  Machine(Tick ticks, const MachineOptions& options);
  /// A machine that joins late. It needs only the items, the units and the packets since then.
  Machine(const Machine& other, const MachineOptions& options);

  /// Receives a packet. If the machine has played that tick with other commands, it will go back to it.
  void receive(std::size_t player, Tick tick, const Commands& commands);
  /// Plays all ticks before `end`, and again those that it played with wrong predictions.
  void play_until(Tick end);

  [[nodiscard]] Tick first_tick() const { return first_tick_; }
  [[nodiscard]] const std::vector<StateHash>& hashes() const { return hashes_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] bool is_right() const { return is_right_; }

 private:
  /// The data that a machine needs to go back to the state before a tick.
  struct Played {
    std::array<Commands, kPlayers> commands;
    std::vector<Change> inverse;
    std::vector<Unit> units_before;
    waywright::ItemsHash items_before;
  };

  void roll_back_to(Tick tick);
  void play();
  Commands commands_for(std::size_t player) const;
  void apply_buildings(Played& played);
  void apply_orders(const Played& played);
  void find_paths(std::uint64_t version_before);
  bool needs_path(std::size_t i, std::uint64_t version_before);
  void take_path(std::size_t i, Path& path);
  void take_hash();

  Tick tick_ = 0;  ///< the next tick to play
  Tick first_tick_ = 0;
  World world_ = World::create({{0, 0}, {kMapSize, kMapSize}}).value();
  std::vector<Unit> units_{kUnits};
  std::vector<std::array<std::optional<Commands>, kPlayers>> packets_;  ///< by tick
  std::deque<Played> played_;                                           ///< the last ticks
  Tick first_wrong_ = std::numeric_limits<Tick>::max();  ///< the first tick played with other commands than it should
  std::vector<StateHash> hashes_;                        ///< after each tick
  MachineOptions options_;
  Counts counts_;
  bool is_right_ = true;
  std::vector<waywright::QueryContext> contexts_;
  std::vector<std::size_t> asking_;  ///< the units that need a path
  std::vector<PathQuery> queries_;
  std::vector<Path> paths_;
};

Machine::Machine(Tick ticks, const MachineOptions& options)
    : packets_(ticks), hashes_(ticks), options_(options), contexts_(options.threads) {
  std::vector<Item> rocks;
  for (std::size_t i = 0; i < kRocks; ++i) {
    const Point position = point_of(1000000 + i);
    rocks.push_back({kRockIds + i, building_at(position, i)});
    // Every third rock is a fence, which is a wall without thickness.
    const Point middle{kMapSize / 2, kMapSize / 2};
    const Point end{middle.x + 0.8 * (position.x - middle.x), middle.y + 0.9 * (position.y - middle.y)};
    if (i % 3 == 0) rocks.back().shape = Shape::segment(position, end);
  }
  world_.insert_all(rocks).value();
  for (std::size_t i = 0; i < kUnits; ++i) units_[i].position.at = units_[i].goal = point_of(2000000 + i);
}

Machine::Machine(const Machine& other, const MachineOptions& options)
    : tick_(other.tick_),
      first_tick_(other.tick_),
      units_(other.units_),
      packets_(other.packets_),
      hashes_(other.hashes_.size()),
      options_(options),
      contexts_(options.threads) {
  world_.insert_all(other.world_.items()).value();
}

void Machine::receive(std::size_t player, Tick tick, const Commands& commands) {
  if (tick < first_tick_) return;
  packets_[tick][player] = commands;
  if (tick >= tick_) return;
  const Played& played = played_[played_.size() - (tick_ - tick)];
  if (played.commands[player] != commands) first_wrong_ = std::min(first_wrong_, tick);
}

void Machine::play_until(Tick end) {
  if (first_wrong_ < tick_) roll_back_to(first_wrong_);
  first_wrong_ = std::numeric_limits<Tick>::max();
  while (tick_ < end) play();
}

void Machine::roll_back_to(Tick tick) {
  ++counts_.rollbacks;
  counts_.longest_rollback = std::max(counts_.longest_rollback, tick_ - tick);
  for (; tick_ > tick; --tick_) {
    Played& played = played_.back();
    world_.apply(played.inverse).value();
    is_right_ = is_right_ && world_.items_hash() == played.items_before;
    units_ = std::move(played.units_before);
    played_.pop_back();
  }
}

void Machine::play() {
  ++counts_.ticks;
  Played& played = played_.emplace_back();
  if (played_.size() > kLongestDelay + 1) played_.pop_front();
  for (std::size_t player = 0; player < kPlayers; ++player) played.commands[player] = commands_for(player);
  played.units_before = units_;
  played.items_before = world_.items_hash();

  const std::uint64_t version_before = world_.version();
  apply_buildings(played);
  apply_orders(played);
  find_paths(version_before);
  for (std::size_t i = 0; i < kUnits; ++i) {
    Unit& unit = units_[i];
    if (unit.path) unit.position = unit.path->advance(unit.position, kStep, precision_of(i));
  }
  take_hash();
  ++tick_;
}

Commands Machine::commands_for(std::size_t player) const {
  if (packets_[tick_][player]) return *packets_[tick_][player];
  if (played_.size() < 2) return {};
  return predicted(played_[played_.size() - 2].commands[player], player, tick_);
}

/// Carries out what can be carried out. This depends on the state alone, so all machines agree on it.
void Machine::apply_buildings(Played& played) {
  std::vector<Change> changes;
  for (const Commands& commands : played.commands) {
    if (const auto& building = commands.building; building && !world_.contains(building->id)) {
      changes.push_back(Change::insert(building->shape, building->id));
      played.inverse.push_back(Change::remove(building->id));
    }
    if (world_.contains(commands.destroyed)) {
      changes.push_back(Change::remove(commands.destroyed));
      played.inverse.push_back(Change::insert(world_.shape(commands.destroyed).value(), commands.destroyed));
    }
  }
  std::reverse(played.inverse.begin(), played.inverse.end());
  world_.apply(changes).value();
}

void Machine::apply_orders(const Played& played) {
  for (const Commands& commands : played.commands) {
    for (const Order& order : commands.orders) {
      units_[order.unit].goal = order.goal;
      units_[order.unit].path = nullptr;
    }
  }
}

/// Whether a unit asks for a path at this tick.
bool Machine::needs_path(std::size_t i, std::uint64_t version_before) {
  Unit& unit = units_[i];
  const bool is_there = unit.path && unit.position.distance >= unit.path->length;
  if (is_there) unit.goal = point_of(number_of(i, tick_));
  if (is_there || !unit.path || (tick_ + i) % 64 == 0) return true;
  // What lies behind the unit does not matter. The rest of its path was clear at the tick before.
  const auto rest = std::span(unit.path->points).subspan(unit.position.segment);
  if (options_.asks_is_affected && !world_.is_affected(rest, version_before)) return false;
  const bool is_blocked = !world_.is_clear(rest, {}, contexts_[0]).value();
  counts_.blocked += is_blocked ? 1 : 0;
  return is_blocked;
}

void Machine::find_paths(std::uint64_t version_before) {
  constexpr std::array kAlgorithms = {PathAlgorithm::optimal, PathAlgorithm::tra, PathAlgorithm::ta};
  asking_.clear();
  queries_.clear();
  for (std::size_t i = 0; i < kUnits; ++i) {
    if (!needs_path(i, version_before)) continue;
    asking_.push_back(i);
    // If a building covers a unit or a goal, the library moves that end to the nearest free position. The budget counts
    // triangles: a budget of time would make the answer depend on the clock.
    queries_.push_back({.start = units_[i].position.at,
                        .goal = units_[i].goal,
                        .algorithm = kAlgorithms[i % kAlgorithms.size()],
                        .budget = {.expansions = 500},
                        .end_tolerance = kBuildingSize});
  }
  world_.find_paths(queries_, contexts_, paths_).value();
  counts_.paths += paths_.size();
  for (std::size_t k = 0; k < asking_.size(); ++k) take_path(asking_[k], paths_[k]);
}

void Machine::take_path(std::size_t i, Path& path) {
  Unit& unit = units_[i];
  unit.path = nullptr;
  if (path.status != PathStatus::found) {
    unit.goal = point_of(number_of(i, tick_));  // the unit tries another goal at the next tick
    return;
  }
  counts_.moved += path.moved_start ? 1 : 0;
  unit.path = std::make_shared<const Path>(std::move(path));
  unit.position = unit.path->at(0, precision_of(i));
}

void Machine::take_hash() {
  StateHash& hash = hashes_[tick_];
  hash = {world_.items_hash(), 0, {}};
  for (const Unit& unit : units_) {
    for (const double coordinate : {unit.position.at.x, unit.position.at.y}) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &coordinate, sizeof bits);
      hash.units = mixed(hash.units ^ bits);
    }
  }
  if ((tick_ + 1) % kMeshHashEvery == 0) hash.mesh = world_.mesh_hash();
}

// ---- The network ----

/// Returns the delay of a packet in ticks: none for the player's own packet, short on machine 0 and long on machine 2.
Tick delay_of(std::size_t machine, std::size_t player, Tick tick) {
  if (machine == player) return 0;
  constexpr std::array<Tick, 3> kShortest = {1, 3, 6};
  return kShortest[machine] + static_cast<Tick>(number_of(machine * kPlayers + player, tick) % 3);
}

/// Gives a machine the packets that arrive at tick `now`.
void deliver(Machine& machine, std::size_t index, Tick now, Tick ticks) {
  for (Tick tick = now < kLongestDelay ? 0 : now - kLongestDelay; tick <= now && tick < ticks; ++tick) {
    for (std::size_t player = 0; player < kPlayers; ++player) {
      if (tick + delay_of(index, player, tick) == now) machine.receive(player, tick, commands_of(player, tick));
    }
  }
}

bool is_same(const Machine& machine, const Machine& reference) {
  for (Tick tick = machine.first_tick(); tick < machine.hashes().size(); ++tick) {
    if (machine.hashes()[tick] == reference.hashes()[tick]) continue;
    std::printf("tick %zu: the machines differ\n", tick);
    return false;
  }
  return machine.is_right() && machine.world().validate().ok;
}

void print(const char* name, const Machine& machine) {
  const Counts& counts = machine.counts();
  std::printf("%s: %zu ticks played, %zu rollbacks of up to %zu ticks, %zu paths, %zu blocked, %zu moved\n", name,
              counts.ticks, counts.rollbacks, counts.longest_rollback, counts.paths, counts.blocked, counts.moved);
}

}  // namespace

int main(int argc, char** argv) {
  const Tick ticks = argc > 1 ? static_cast<Tick>(std::strtoull(argv[1], nullptr, 10)) : 600;
  // The server waits for all packets, so it never goes back. It also differs in every setting that should not matter.
  Machine server(ticks, {.threads = 2, .asks_is_affected = false});
  std::vector<Machine> machines;
  for (std::size_t i = 0; i < 3; ++i) machines.emplace_back(ticks, MachineOptions{});
  std::optional<Machine> late;

  for (Tick now = 0; now <= ticks + kLongestDelay; ++now) {
    for (std::size_t i = 0; i < machines.size(); ++i) {
      deliver(machines[i], i, now, ticks);
      machines[i].play_until(std::min(now + 1, ticks));
    }
    if (now < ticks) {
      for (std::size_t player = 0; player < kPlayers; ++player) server.receive(player, now, commands_of(player, now));
    }
    server.play_until(now < kLongestDelay ? 0 : std::min(now - kLongestDelay + 1, ticks));
    if (now == ticks / 2) late.emplace(server, MachineOptions{});
    if (late) {
      deliver(*late, 2, now, ticks);
      late->play_until(std::min(now + 1, ticks));
    }
  }

  bool is_right = server.world().validate().ok;
  print("server ", server);
  const std::array names = {"near   ", "far    ", "farther"};
  for (std::size_t i = 0; i < machines.size(); ++i) {
    print(names[i], machines[i]);
    is_right = is_same(machines[i], server) && is_right;
  }
  print("late   ", *late);
  is_right = is_same(*late, server) && is_right;

  std::uint64_t all = 0;
  for (const StateHash& hash : server.hashes()) {
    for (const std::uint64_t word : hash.items.words) all = mixed(all ^ word);
    for (const std::uint8_t byte : hash.mesh.bytes) all = mixed(all ^ byte);
    all = mixed(all ^ hash.units);
  }
  std::printf("tick %zu: %zu items %s, mesh %s, units %016" PRIx64 ", all ticks %016" PRIx64 "\n", ticks,
              server.world().item_count(), to_string(server.world().items_hash()).c_str(),
              to_string(server.world().mesh_hash()).c_str(), server.hashes().back().units, all);
  std::puts(is_right ? "all machines agree" : "MACHINES DIFFER");
  return is_right ? 0 : 1;
}
