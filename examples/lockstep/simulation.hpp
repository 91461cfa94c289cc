#pragma once

// The game: everything that all machines must compute alike. It knows nothing of the network, the clock or predictions.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waywright/waywright.hpp"

namespace lockstep {

using Tick = std::uint32_t;

constexpr std::size_t kPlayers = 2;
constexpr Tick kRememberedTicks = 32;  ///< a simulation can go back this far
constexpr std::size_t kSquad = 32;     ///< agents that an order sends off together

/// The settings of a game. All machines must have the same; the host sends its settings to those who join.
struct Settings {
  std::uint32_t agents = 3200;
  std::uint32_t rocks = 1500;           ///< hexagons, which make most of the mesh
  std::uint32_t queries_per_tick = 16;  ///< the largest number of path queries in a tick
};

/// What a player does in one tick. Coordinates are whole metres, so that a packet needs few bytes.
struct Commands {
  struct Site {
    std::uint16_t x = 0;
    std::uint16_t y = 0;

    friend bool operator==(const Site&, const Site&) = default;
  };
  struct Order {
    std::uint16_t squad = 0;
    Site to;

    friend bool operator==(const Order&, const Order&) = default;
  };

  std::optional<Site> building;  ///< where to place a building
  std::optional<Tick> destroys;  ///< the tick at which the player placed the building that it now destroys
  std::optional<Order> order;

  friend bool operator==(const Commands&, const Commands&) = default;
};

/// The id of the building that a player places at a tick. The game chooses the ids: an id that the world chooses would
/// depend on what the world has seen, also on buildings that were predicted and never built.
inline waywright::ItemId building_id(std::size_t player, Tick tick) {
  return {(std::uint64_t{player} + 1) << 32 | (tick + 1)};
}

/// An agent. `path` is shared: a copy of the state for a rollback costs no copy of the path, and no path ever changes.
struct Agent {
  waywright::PathPosition position;  ///< position.at is where the agent stands
  waywright::Point post;             ///< the agent patrols around this point
  waywright::Point goal;
  std::shared_ptr<const waywright::Path> path;  ///< null while the agent waits for its turn to ask for one
};

/// The state of the game besides the world. Whatever a later tick reads must be here, or in the world. Otherwise a
/// machine that went back would continue differently from a machine that did not.
struct State {
  std::uint64_t random = 0;            ///< the state of the generator of random numbers
  std::vector<Agent> agents;           ///< in a fixed order
  std::vector<std::uint32_t> waiting;  ///< the agents without a path, in the order in which they will ask
};

/// The hash of the whole state.
struct StateHash {
  waywright::ItemsHash items;
  std::uint64_t agents = 0;  ///< of State

  friend bool operator==(const StateHash&, const StateHash&) = default;
};

/// A game, with its last kRememberedTicks states. A tick is counted from 0; "the state at a tick" is the state before
/// that tick is played.
class Simulation {
 public:
  /// A new game, at tick 0. `threads` is the number of threads for path queries. It has no effect on the results.
  Simulation(const Settings& settings, std::size_t threads);
  /// A game that continues a saved one, for a machine that joins late.
  Simulation(const Settings& settings, Tick tick, waywright::World world, State state, std::size_t threads);

  /// Plays one tick with the commands of all players.
  void play(std::span<const Commands, kPlayers> commands);
  /// Goes back to the state at an earlier tick. Requires: oldest_tick() <= `tick` <= this->tick().
  void rewind(Tick tick);

  [[nodiscard]] Tick tick() const { return tick_; }  ///< the next tick to play
  [[nodiscard]] Tick oldest_tick() const;
  /// The hash of the state at a tick. Requires: oldest_tick() <= `tick` <= this->tick().
  /// Cost: linear in the agents. The world knows its own hash.
  [[nodiscard]] StateHash hash(Tick tick) const;
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const waywright::World& world() const { return world_; }
  [[nodiscard]] const State& state() const { return state_; }
  /// The changes of the world that the last tick made.
  [[nodiscard]] std::span<const waywright::Change> changes() const { return changes_; }
  /// Damages the state, to show that the machines notice it.
  void damage();

 private:
  void remember();
  void build(std::span<const Commands, kPlayers> commands);
  void give_orders(std::span<const Commands, kPlayers> commands);
  void stop_blocked_agents(std::uint64_t version_before);
  void answer_queries(std::size_t limit);
  void move_agents();
  void choose_goal(Agent& agent);
  double next_share();
  [[nodiscard]] waywright::Point inside(double x, double y) const;
  [[nodiscard]] double map_size() const { return world_.domain().max.x; }

  Settings settings_;
  Tick tick_ = 0;
  waywright::World world_;
  State state_;
  Tick first_tick_ = 0;
  std::uint64_t first_mark_ = 0;  ///< World::mark() of the state at first_tick_
  struct Remembered {
    State state;
    waywright::ItemsHash items;
  };
  std::vector<Remembered> remembered_;  ///< the state at tick t is element t % kRememberedTicks
  // What follows is scratch: no tick reads what another tick has written there.
  std::vector<waywright::QueryContext> contexts_;
  std::vector<waywright::Change> changes_;
  std::vector<waywright::PathQuery> queries_;
  std::vector<waywright::Path> paths_;
};

/// Returns the first item or agent that differs between two games at the same tick, in words.
[[nodiscard]] std::string first_difference(const Simulation& ours, const Simulation& theirs);

}  // namespace lockstep
