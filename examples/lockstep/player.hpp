#pragma once

// The commands of a player that the computer chooses.

#include "numbers.hpp"
#include "simulation.hpp"

namespace lockstep {

/// The commands of a player at a tick. The players take turns: in each tick, one of them builds or destroys one
/// building. At first they only build. The result of this function need not be the same on all machines, because the
/// commands of a player come from one machine.
inline Commands commands_of(std::size_t player, Tick tick, const Simulation& game) {
  constexpr Tick kOpening = 64;  // buildings that a player places before it destroys the first
  constexpr Tick kTicksPerOrder = 16;
  const double map_size = game.world().domain().max.x;
  const std::uint64_t squads = game.settings().agents / kSquad / kPlayers;  // of a player
  const std::uint64_t number = mixed(1 + player * 1000003 + tick * kPlayers * 1000033);
  const auto coordinate = [&](std::uint64_t i) { return static_cast<std::uint16_t>(map_size * share_of(number + i)); };
  Commands commands;
  const Tick round = tick / kPlayers;
  if (tick % kPlayers == player && (round < kOpening || round % 2 == 0)) {
    commands.building = Commands::Site{coordinate(0), coordinate(1)};
  } else if (tick % kPlayers == player) {
    const Tick index = (round - kOpening) / 2;  // the oldest building that stands
    const Tick built = index < kOpening ? index : 2 * index - kOpening;
    commands.destroys = built * static_cast<Tick>(kPlayers) + static_cast<Tick>(player);
  }
  if (squads != 0 && (tick + 8 * player) % kTicksPerOrder == 0) {
    const auto squad = static_cast<std::uint16_t>(kPlayers * (number % squads) + player);
    commands.order = Commands::Order{squad, {coordinate(2), coordinate(3)}};
  }
  return commands;
}

}  // namespace lockstep
