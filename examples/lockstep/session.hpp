#pragma once

// Prediction and rollback: a session plays ticks before all commands are known, and corrects itself when they arrive.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocol.hpp"
#include "simulation.hpp"

namespace lockstep {

/// A machine plays at most this many ticks ahead of the commands that it knows. So no rollback is longer.
constexpr Tick kLongestRollback = 8;
static_assert(kLongestRollback < kRememberedTicks);

/// Counts of what a session has done.
struct Counts {
  std::size_t ticks = 0;  ///< played, including those that were played again
  std::size_t rollbacks = 0;
  std::size_t replayed_ticks = 0;  ///< played again
  Tick longest_rollback = 0;
  std::size_t waits = 0;  ///< frames in which the session could not play, because commands were missing
};

/// Where the states of two machines differ.
struct Desync {
  Tick tick = 0;  ///< the first tick whose state differs
  StateHash ours;
  StateHash theirs;
};

/// What a session knows of another machine.
struct Peer {
  Update last;                    ///< what it sent last
  Tick compared = 0;              ///< the states before this tick were compared with its hashes
  std::vector<StateHash> hashes;  ///< from `compared` on: those that were not compared yet
};

class Session {
 public:
  /// Plays until the tick `end`.
  Session(Simulation simulation, Tick end);

  /// Adds a player's commands for a tick. Ignores them if they are known already, or if the player's commands for the
  /// tick before are not known. If the session has played this tick with other commands, the next call of play() goes
  /// back.
  void add(std::size_t player, Tick tick, const Commands& commands);
  /// Whether play() plays a new tick: whether the session is less than kLongestRollback ahead of the known commands.
  [[nodiscard]] bool can_play() const;
  /// If a prediction was wrong, goes back and plays the same ticks again. Then plays one new tick if can_play().
  void play();
  /// The last state that no command can change any more.
  [[nodiscard]] Tick final_tick() const;
  /// Goes back to the state at a tick, saves it, and plays again. Requires: the session remembers this state, and no
  /// command can change it any more. The next function requires this, too.
  [[nodiscard]] Bytes save(Tick tick);
  /// Returns what differs between the state at a tick and another state, in words. Leaves the session at this tick.
  [[nodiscard]] std::string difference(Tick tick, const Simulation& theirs);

  /// Returns what another machine needs: the commands and hashes that it has not confirmed.
  [[nodiscard]] Update update_for(const Peer& peer) const;
  /// Reads what another machine has sent, and compares hashes.
  void read(const Update& update, Peer& peer);
  /// Whether all ticks are played with the right commands, and all hashes of the other machine were compared.
  [[nodiscard]] bool is_done(const Peer& peer) const { return hashed() > end_ && peer.compared > end_; }

  [[nodiscard]] Tick tick() const { return simulation_.tick(); }  ///< the next tick to play
  [[nodiscard]] Tick end() const { return end_; }
  /// A player's commands are known for all ticks before this one.
  [[nodiscard]] Tick known(std::size_t player) const { return first_ + static_cast<Tick>(known_[player].size()); }
  /// The commands of all players are known for all ticks before this one.
  [[nodiscard]] Tick confirmed() const;
  /// The first state that differs from the state of another machine.
  [[nodiscard]] const std::optional<Desync>& desync() const { return desync_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }

  /// The session calls this function for each tick in order, when the commands of the tick are final and it has been
  /// played with them: with the changes of the world, and the hash of the state after it.
  std::function<void(std::span<const waywright::Change> changes, const StateHash& after)> on_final;
  /// Damages the state at this tick, to show that the machines notice it.
  std::optional<Tick> damage_at;

 private:
  void go_back_to(Tick tick);
  void play_tick();
  void replay();
  void hash_final_states();
  void compare(Peer& peer);
  [[nodiscard]] Commands commands_for(std::size_t player) const;
  /// The hashes of the states before this tick are known.
  [[nodiscard]] Tick hashed() const { return first_ + static_cast<Tick>(hashes_.size()); }

  Simulation simulation_;
  Tick first_;  ///< the tick at which the session began
  Tick end_;
  std::array<std::vector<Commands>, kPlayers> known_;    ///< from the tick first_ on
  std::vector<std::array<Commands, kPlayers>> used_;     ///< with which the ticks from first_ on were played
  std::optional<Tick> first_wrong_;                      ///< the first tick that was played with wrong commands
  std::vector<StateHash> hashes_;                        ///< of the states from first_ to final_tick()
  std::vector<std::vector<waywright::Change>> changes_;  ///< of the ticks from final_tick() on, for on_final
  std::optional<Desync> desync_;
  Counts counts_;
};

}  // namespace lockstep
