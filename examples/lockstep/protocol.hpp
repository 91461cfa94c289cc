#pragma once

// The bytes that machines send each other. All numbers are little-endian, whatever the processor. A reader trusts no
// byte: a packet that is too short, too long or out of range is refused as a whole.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "simulation.hpp"

namespace lockstep {

using Bytes = std::vector<std::uint8_t>;

/// A packet is at most this large, so that no network divides it.
constexpr std::size_t kLargestPacket = 1400;
constexpr std::size_t kChunk = 1200;           ///< bytes of a saved game in one packet
constexpr std::size_t kCommandsInPacket = 32;  ///< of each player
constexpr std::size_t kHashesInPacket = 16;
constexpr std::size_t kWantedInPacket = 64;

/// From a machine that wants a saved game: it joins, or its state differs from the host's.
struct Hello {
  static constexpr Tick kLatest = 0xffffffff;

  bool plays = false;   ///< as the second player; otherwise it only watches
  Tick tick = kLatest;  ///< the state that it wants
};
/// From the host: what the machine needs before it can fetch the saved game.
struct Welcome {
  Settings settings;
  Tick end = 0;            ///< the tick at which the game ends
  Tick tick = 0;           ///< of the saved game
  std::uint32_t size = 0;  ///< of the saved game, in bytes
};
/// The answer to a welcome: the pieces of the saved game that have not arrived.
struct Want {
  std::vector<std::uint32_t> chunks;
};
/// From the host: a piece of the saved game.
struct Chunk {
  std::uint32_t index = 0;
  Bytes bytes;
};
/// Between machines that play, once in each frame. It repeats everything that the receiver has not confirmed. So a lost
/// packet needs no answer: the next one contains what it contained.
struct Update {
  /// The commands of a player for consecutive ticks.
  struct Row {
    Tick first = 0;
    std::vector<Commands> commands;
  };
  std::array<Tick, kPlayers> known{};  ///< the sender has the player's commands for all ticks before this one
  std::array<Row, kPlayers> rows;
  Tick compared = 0;       ///< the sender has compared the hashes of all states before this tick
  std::uint16_t lead = 0;  ///< by how many ticks the sender is ahead of the receiver's commands on average, times 16
  Tick first_hash = 0;
  std::vector<StateHash> hashes;  ///< of consecutive states, which no command can change any more
  bool is_done = false;           ///< the sender has played and compared everything
};

[[nodiscard]] Bytes bytes_of(const Hello& hello);
[[nodiscard]] Bytes bytes_of(const Welcome& welcome);
[[nodiscard]] Bytes bytes_of(const Want& want);
[[nodiscard]] Bytes bytes_of(const Chunk& chunk);
[[nodiscard]] Bytes bytes_of(const Update& update);

/// The content of a packet: one of the members.
struct Packet {
  std::optional<Hello> hello;
  std::optional<Welcome> welcome;
  std::optional<Want> want;
  std::optional<Chunk> chunk;
  std::optional<Update> update;
};
/// Returns the content of a packet, or nothing if it is malformed.
[[nodiscard]] std::optional<Packet> read_packet(std::span<const std::uint8_t> bytes);

/// The saved game at the present tick: the world as World saves it, and the rest of the state.
[[nodiscard]] Bytes save_game(const Simulation& simulation);
/// Returns the saved game as a simulation, or nothing if the bytes are malformed.
[[nodiscard]] std::optional<Simulation> load_game(const Bytes& bytes, const Settings& settings, Tick tick,
                                                  std::size_t threads);

}  // namespace lockstep
