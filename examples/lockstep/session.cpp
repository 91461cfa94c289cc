#include "session.hpp"

#include <algorithm>
#include <utility>

namespace lockstep {

Session::Session(Simulation simulation, Tick end)
    : simulation_(std::move(simulation)), first_(simulation_.tick()), end_(end) {
  hashes_.push_back(simulation_.hash(first_));
}

void Session::add(std::size_t player, Tick tick, const Commands& commands) {
  if (tick != known(player) || tick >= end_) return;
  known_[player].push_back(commands);
  const bool is_wrong = tick < this->tick() && used_[tick - first_][player] != commands;
  if (is_wrong) first_wrong_ = std::min(first_wrong_.value_or(tick), tick);
}

Tick Session::confirmed() const {
  Tick confirmed = end_;
  for (std::size_t player = 0; player < kPlayers; ++player) confirmed = std::min(confirmed, known(player));
  return confirmed;
}

bool Session::can_play() const { return tick() < end_ && tick() < confirmed() + kLongestRollback; }

void Session::play() {
  if (first_wrong_) {
    const Tick present = tick();
    go_back_to(*first_wrong_);
    while (tick() < present) replay();
  }
  if (can_play()) {
    play_tick();
  } else if (tick() < end_) {
    ++counts_.waits;
  }
  hash_final_states();
}

void Session::go_back_to(Tick tick) {
  ++counts_.rollbacks;
  counts_.longest_rollback = std::max(counts_.longest_rollback, this->tick() - tick);
  simulation_.rewind(tick);
  used_.resize(tick - first_);
  if (on_final) changes_.resize(std::max(tick + 1, hashed()) - hashed());
  first_wrong_.reset();
}

void Session::replay() {
  ++counts_.replayed_ticks;
  play_tick();
}

void Session::play_tick() {
  ++counts_.ticks;
  auto& commands = used_.emplace_back();
  for (std::size_t player = 0; player < kPlayers; ++player) commands[player] = commands_for(player);
  simulation_.play(commands);
  if (damage_at == tick()) simulation_.damage();
  if (on_final) changes_.emplace_back(simulation_.changes().begin(), simulation_.changes().end());
}

/// The commands that are known, or a prediction: the player does nothing. Most commands of a game are "nothing". A game
/// in which players steer something would predict what the player did at the tick before.
Commands Session::commands_for(std::size_t player) const {
  return tick() < known(player) ? known_[player][tick() - first_] : Commands{};
}

Tick Session::final_tick() const {
  const Tick last = std::min(confirmed(), tick());
  return std::min(last, first_wrong_.value_or(last));
}

/// Takes the hashes only of states that no command can change any more. Most states are computed several times.
void Session::hash_final_states() {
  std::size_t count = 0;
  for (; hashed() <= final_tick(); ++count) {
    hashes_.push_back(simulation_.hash(hashed()));
    if (on_final) on_final(changes_[count], hashes_.back());
  }
  if (on_final) changes_.erase(changes_.begin(), changes_.begin() + static_cast<std::ptrdiff_t>(count));
}

Bytes Session::save(Tick tick) {
  const Tick present = this->tick();
  if (tick < present) go_back_to(tick);
  Bytes bytes = save_game(simulation_);
  while (this->tick() < present) replay();
  return bytes;
}

std::string Session::difference(Tick tick, const Simulation& theirs) {
  if (tick < this->tick()) go_back_to(tick);
  return first_difference(simulation_, theirs);
}

Update Session::update_for(const Peer& peer) const {
  Update update;
  for (std::size_t player = 0; player < kPlayers; ++player) {
    update.known[player] = known(player);
    Update::Row& row = update.rows[player];
    row.first = peer.last.known[player];
    for (Tick tick = row.first; tick >= first_ && tick < known(player); ++tick) {
      if (row.commands.size() == kCommandsInPacket) break;
      row.commands.push_back(known_[player][tick - first_]);
    }
  }
  update.compared = peer.compared;
  update.first_hash = peer.last.compared;
  for (Tick tick = update.first_hash; tick >= first_ && tick < hashed(); ++tick) {
    if (update.hashes.size() == kHashesInPacket) break;
    update.hashes.push_back(hashes_[tick - first_]);
  }
  update.is_done = is_done(peer);
  return update;
}

void Session::read(const Update& update, Peer& peer) {
  for (std::size_t player = 0; player < kPlayers; ++player) {
    const Update::Row& row = update.rows[player];
    for (std::size_t i = 0; i < row.commands.size(); ++i)
      add(player, row.first + static_cast<Tick>(i), row.commands[i]);
  }
  for (std::size_t i = 0; i < update.hashes.size(); ++i) {
    const std::size_t next = peer.compared + peer.hashes.size();
    if (update.first_hash + i == next && next <= end_) peer.hashes.push_back(update.hashes[i]);
  }
  // Packets can overtake each other: an older one must not take anything back.
  for (std::size_t player = 0; player < kPlayers; ++player) {
    peer.last.known[player] = std::max(peer.last.known[player], update.known[player]);
  }
  peer.last.compared = std::max(peer.last.compared, update.compared);
  peer.last.lead = update.lead;
  peer.last.is_done = peer.last.is_done || update.is_done;
  compare(peer);
}

/// Compares the states that neither machine will change any more.
void Session::compare(Peer& peer) {
  std::size_t count = 0;
  for (; count < peer.hashes.size() && peer.compared < hashed(); ++count, ++peer.compared) {
    const StateHash& ours = hashes_[peer.compared - first_];
    if (ours == peer.hashes[count] || desync_) continue;
    desync_ = Desync{peer.compared, ours, peer.hashes[count]};
  }
  peer.hashes.erase(peer.hashes.begin(), peer.hashes.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace lockstep
