#include "machine.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <ctime>
#include <thread>
#include <utility>

#include "player.hpp"

namespace lockstep {

using Clock = std::chrono::steady_clock;

namespace {

constexpr double kPatience = 10.0;   // seconds without a packet after which a machine gives up
constexpr double kFarewell = 1.0;    // seconds without a packet after which a machine that is done ends
constexpr std::size_t kCatchUp = 4;  // ticks in a frame of a machine that joined late
constexpr std::uint32_t kFramesPerWait = 16;
constexpr std::uint32_t kFramesPerAnswer = 16;  // after which a piece of the saved game counts as lost

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

}  // namespace

void FrameTimes::begin() {
  clock_begin_ = Clock::now();
  cpu_begin_ = std::clock();
}

void FrameTimes::end() {
  elapsed_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - clock_begin_).count());
  cpu_.push_back(1000.0 * static_cast<double>(std::clock() - cpu_begin_) / CLOCKS_PER_SEC);
}

void FrameTimes::print() const {
  for (const auto& [name, values] : {std::pair{"elapsed", &elapsed_}, std::pair{"CPU", &cpu_}}) {
    std::printf("frames: %zu, %s time p50 %.2f ms, p99 %.2f ms, max %.2f ms\n", values->size(), name,
                percentile(*values, 0.5), percentile(*values, 0.99), percentile(*values, 1.0));
  }
}

Machine::Machine(const Options& options) : options_(options), network_(0, options.faults) {}

void Machine::start(Simulation simulation, Tick end) {
  session_.emplace(std::move(simulation), end);
  session_->damage_at = options_.damage_at;
  if (options_.log.empty()) return;
  log_file_.open(options_.log);
  log_ = std::make_unique<waywright::ReplayWriter>(log_file_, session_->simulation().world());
  session_->on_final = [this](std::span<const waywright::Change> changes, const StateHash& after) {
    for (const waywright::Change& change : changes) log_->record(change).value();
    log_->tick(after.items).value();
  };
}

int Machine::run() {
  auto next_frame = Clock::now();
  for (;;) {
    times_.begin();
    network_.begin_frame();
    Address from;
    while (const auto packet = network_.receive(from)) handle(from, *packet);
    const std::size_t before = session_ ? session_->counts().ticks : 0;
    if (session_ && !session_->desync()) play();
    send();
    const bool has_played = session_ && session_->counts().ticks != before;
    if (has_played) times_.end();
    if (is_over()) break;
    if (options_.rate != 0) {
      next_frame = std::max(next_frame + std::chrono::nanoseconds(1000000000 / options_.rate), Clock::now());
      std::this_thread::sleep_until(next_frame);
    } else if (!has_played) {
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
  }
  network_.flush();
  if (!session_) {
    std::puts("there was no game to join");
    return 2;
  }
  print_report();
  if (session_->desync()) {
    explain_desync(*session_->desync());
    return 1;
  }
  if (session_->tick() == session_->end() && session_->final_tick() == session_->end()) return 0;
  std::puts("the other machine is silent");
  return 2;
}

/// Plays a tick. A machine that joined late plays several, until it is as far as the others.
void Machine::play() {
  if (must_wait() || is_too_fast()) return;
  play_tick();
  for (std::size_t i = 0; i < kCatchUp && session_->confirmed() > session_->tick() + kLongestRollback; ++i) play_tick();
}

void Machine::play_tick() {
  const auto me = player();
  if (me && session_->can_play()) {
    session_->add(*me, session_->tick(), commands_of(*me, session_->tick(), session_->simulation()));
  }
  session_->play();
}

/// Whether this machine should wait for a frame because it is ahead of its partner. Otherwise only one of the two would
/// predict and roll back. This changes when ticks are played, but not their results.
bool Machine::is_too_fast() {
  const Remote* const other = partner();
  if (other == nullptr || !other->has_game) return false;
  const std::size_t their_player = *player() == 0 ? 1 : 0;
  const double lead = static_cast<double>(session_->tick()) - static_cast<double>(session_->known(their_player));
  lead_ = (15.0 * lead_ + std::max(lead, 0.0)) / 16.0;
  if (++since_wait_ < kFramesPerWait || lead_ - other->peer.last.lead / 16.0 < 2.0) return false;
  since_wait_ = 0;
  return true;
}

void Machine::send_update(const Remote& remote) {
  Update update = session_->update_for(remote.peer);
  update.lead = static_cast<std::uint16_t>(16.0 * lead_);
  network_.send(remote.address, bytes_of(update));
}

bool Machine::is_silent(const Remote& remote, double seconds) const {
  return std::chrono::duration<double>(Clock::now() - remote.heard).count() > seconds;
}

bool Machine::has_finished(const Remote& remote) const {
  if (is_silent(remote, kPatience)) return true;
  return session_ && session_->is_done(remote.peer) && (remote.peer.last.is_done || is_silent(remote, kFarewell));
}

void Machine::explain_desync(const Desync& desync) {
  std::printf("DESYNC at tick %" PRIu32 ": the %s differ\n", desync.tick,
              desync.ours.items != desync.theirs.items ? "items" : "agents");
}

void Machine::print_report() {
  const Counts& counts = session_->counts();
  const Simulation& simulation = session_->simulation();
  const State& state = simulation.state();
  std::printf("field: %zu triangles, %zu agents, of which %zu wait for a path\n", simulation.world().triangle_count(),
              state.agents.size(), state.waiting.size());
  std::printf("ticks: %zu, of which played again: %zu, in %zu rollbacks of up to %" PRIu32
              " ticks; frames without a tick: %zu\n",
              counts.ticks, counts.replayed_ticks, counts.rollbacks, counts.longest_rollback, counts.waits);
  const Network::Counts& packets = network_.counts();
  std::printf("packets sent: %zu, of which lost: %zu, late: %zu\n", packets.sent, packets.lost, packets.late);
  times_.print();
  const StateHash hash = simulation.hash(simulation.tick());
  std::printf("final: tick %" PRIu32 ", items %s, agents %016" PRIx64 ", mesh %s\n", simulation.tick(),
              to_string(hash.items).c_str(), hash.agents, to_string(simulation.world().mesh_hash()).c_str());
}

// ---- The host ----

Host::Host(const Options& options) : Machine(options) {
  std::printf("port %d\n", int{network_.port()});
  std::fflush(stdout);
  start(Simulation(options_.settings, options_.threads), options_.ticks);
}

Remote* Host::find(const Address& address) {
  const auto found =
      std::find_if(guests_.begin(), guests_.end(), [&](const Remote& guest) { return guest.address == address; });
  return found == guests_.end() ? nullptr : &*found;
}

const Remote* Host::partner() const {
  const auto found = std::find_if(guests_.begin(), guests_.end(), [](const Remote& guest) { return guest.plays; });
  return found == guests_.end() ? nullptr : &*found;
}

/// At half time, waits for the machines that join late.
bool Host::must_wait() const {
  return session_->final_tick() >= options_.ticks / 2 && guests_.size() < std::size_t{options_.watchers} + 1;
}

void Host::handle(const Address& from, const Packet& packet) {
  Remote* guest = find(from);
  if (packet.hello && guest == nullptr) {
    const bool is_full = packet.hello->plays ? partner() != nullptr : session_->final_tick() < options_.ticks / 2;
    if (is_full || guests_.size() > options_.watchers) return;
    guest = &guests_.emplace_back();
    guest->address = from;
    guest->plays = packet.hello->plays;
  }
  if (guest == nullptr) return;
  guest->heard = Clock::now();
  if (packet.hello) welcome(*guest, *packet.hello);
  if (packet.want) send_chunks(*guest, *packet.want);
  if (!packet.update) return;
  guest->has_game = true;
  session_->read(*packet.update, guest->peer);
}

/// Saves the game for a guest. The guest gets a state that no command can change any more, and then all commands since.
void Host::welcome(Remote& guest, const Hello& hello) {
  const Tick wanted = hello.tick == Hello::kLatest ? session_->final_tick() : hello.tick;
  const bool is_again = !guest.saved.empty() && (hello.tick == Hello::kLatest || hello.tick == guest.saved_tick);
  if (!is_again) {
    if (wanted < session_->simulation().oldest_tick() || wanted > session_->final_tick()) return;
    guest.saved = session_->save(wanted);
    guest.saved_tick = wanted;
    if (hello.tick == Hello::kLatest) guest.peer.compared = wanted;
  }
  network_.send(guest.address, bytes_of(Welcome{options_.settings, options_.ticks, guest.saved_tick,
                                                static_cast<std::uint32_t>(guest.saved.size())}));
}

void Host::send_chunks(const Remote& guest, const Want& want) {
  for (const std::uint32_t index : want.chunks) {
    const std::size_t begin = std::size_t{index} * kChunk;
    if (begin >= guest.saved.size()) continue;
    const std::size_t end = std::min(begin + kChunk, guest.saved.size());
    const auto at = [&](std::size_t i) { return guest.saved.begin() + static_cast<std::ptrdiff_t>(i); };
    network_.send(guest.address, bytes_of(Chunk{index, Bytes(at(begin), at(end))}));
  }
}

void Host::send() {
  for (const Remote& guest : guests_) {
    if (guest.has_game) send_update(guest);
  }
}

bool Host::is_over() {
  if (session_->desync()) {
    // The guests have some seconds to fetch the state.
    if (!desync_seen_) desync_seen_ = Clock::now();
    if (Clock::now() - *desync_seen_ > std::chrono::seconds(3)) return true;
    return std::all_of(guests_.begin(), guests_.end(),
                       [this](const Remote& guest) { return is_silent(guest, kFarewell); });
  }
  if (guests_.size() < std::size_t{options_.watchers} + 1) return false;
  return std::all_of(guests_.begin(), guests_.end(), [this](const Remote& guest) { return has_finished(guest); });
}

// ---- A guest ----

Guest::Guest(const Options& options) : Machine(options) {
  host_.address = local_address(options_.join);
  host_.heard = Clock::now();
}

std::optional<std::size_t> Guest::player() const {
  return options_.watches ? std::nullopt : std::optional<std::size_t>(1);
}

void Guest::handle(const Address& from, const Packet& packet) {
  if (from != host_.address) return;
  host_.heard = Clock::now();
  const bool is_wanted = wanted_ == Hello::kLatest || (packet.welcome && packet.welcome->tick == wanted_);
  if (packet.welcome && !welcome_ && is_wanted) {
    welcome_ = packet.welcome;
    saved_.assign(welcome_->size, 0);
    has_chunk_.assign((welcome_->size + kChunk - 1) / kChunk, false);
    patience_.assign(has_chunk_.size(), 0);
  }
  if (packet.chunk && welcome_ && !fetched_) take(*packet.chunk);
  if (packet.update && session_) {
    host_.has_game = true;
    session_->read(*packet.update, host_.peer);
  }
}

void Guest::take(const Chunk& chunk) {
  const std::size_t begin = std::size_t{chunk.index} * kChunk;
  if (begin >= saved_.size() || chunk.bytes.size() != std::min(kChunk, saved_.size() - begin)) return;
  std::copy(chunk.bytes.begin(), chunk.bytes.end(), saved_.begin() + static_cast<std::ptrdiff_t>(begin));
  has_chunk_[chunk.index] = true;
  if (!std::all_of(has_chunk_.begin(), has_chunk_.end(), [](bool has) { return has; })) return;
  fetched_ = load_game(saved_, welcome_->settings, welcome_->tick, options_.threads);
  if (!fetched_ || session_) return;
  std::printf("joined at tick %" PRIu32 " with %zu bytes\n", welcome_->tick, saved_.size());
  host_.peer.compared = welcome_->tick;
  for (Tick& known : host_.peer.last.known) known = welcome_->tick;
  start(*std::move(fetched_), welcome_->end);
}

/// Asks for the saved game, or for the pieces of it that have not arrived.
void Guest::ask() {
  if (!welcome_) return network_.send(host_.address, bytes_of(Hello{!options_.watches, wanted_}));
  Want want;
  for (std::uint32_t i = 0; i < has_chunk_.size() && want.chunks.size() < kWantedInPacket; ++i) {
    if (has_chunk_[i] || patience_[i]-- != 0) continue;
    patience_[i] = kFramesPerAnswer;
    want.chunks.push_back(i);
  }
  if (!want.chunks.empty()) network_.send(host_.address, bytes_of(want));
}

void Guest::send() {
  if (session_ && session_->desync() && wanted_ == Hello::kLatest) {
    wanted_ = session_->desync()->tick;
    welcome_.reset();
    fetched_.reset();
  }
  if (!session_ || (session_->desync() && !fetched_)) ask();
  if (session_) send_update(host_);
}

bool Guest::is_over() {
  if (session_ && session_->desync()) return fetched_ || is_silent(host_, kFarewell);
  return has_finished(host_);
}

void Guest::explain_desync(const Desync& desync) {
  Machine::explain_desync(desync);
  if (!fetched_ || desync.tick < session_->simulation().oldest_tick()) return;
  std::printf("the first difference: %s\n", session_->difference(desync.tick, *fetched_).c_str());
}

}  // namespace lockstep
