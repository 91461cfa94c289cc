#include "protocol.hpp"

#include <cstring>
#include <memory>
#include <sstream>
#include <utility>

namespace lockstep {

using waywright::Path;
using waywright::PathStatus;
using waywright::Point;

namespace {

class Writer {
 public:
  /// Writes the lowest `size` bytes of a number.
  void number(std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void real(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    number(bits, 8);
  }
  void point(const Point& p) {
    real(p.x);
    real(p.y);
  }
  void raw(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  [[nodiscard]] Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

/// Reads what a Writer has written. After the end of the bytes it returns zeros, and is_ok() is false.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    const auto bytes = raw(size);
    for (std::size_t i = 0; i < bytes.size(); ++i) value |= std::uint64_t{bytes[i]} << (8 * i);
    return value;
  }
  template <class Integer>
  Integer integer() {
    return static_cast<Integer>(number(sizeof(Integer)));
  }
  /// Reads a number of elements, at most `largest`.
  std::size_t count(std::size_t size, std::size_t largest) {
    const auto value = static_cast<std::size_t>(number(size));
    if (value > largest) is_ok_ = false;
    return is_ok_ ? value : 0;
  }
  double real() {
    const std::uint64_t bits = number(8);
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  Point point() {
    const double x = real();
    const double y = real();
    return {x, y};
  }
  std::span<const std::uint8_t> raw(std::size_t size) {
    if (size > rest_.size()) is_ok_ = false;
    if (!is_ok_) return {};
    const auto bytes = rest_.first(size);
    rest_ = rest_.subspan(size);
    return bytes;
  }
  void require(bool condition) { is_ok_ = is_ok_ && condition; }
  [[nodiscard]] std::size_t remaining() const { return rest_.size(); }
  [[nodiscard]] bool is_ok() const { return is_ok_; }
  [[nodiscard]] bool is_at_end() const { return is_ok_ && rest_.empty(); }

 private:
  std::span<const std::uint8_t> rest_;
  bool is_ok_ = true;
};

/// The first two bytes of each packet: a mark of this protocol, and the kind of the packet.
constexpr std::uint8_t kProtocol = 0xc7;
enum class Kind : std::uint8_t { hello, welcome, want, chunk, update };

Writer packet(Kind kind) {
  Writer out;
  out.number(kProtocol, 1);
  out.number(static_cast<std::uint8_t>(kind), 1);
  return out;
}

void write(Writer& out, const Commands& commands) {
  out.number((commands.building ? 1U : 0U) | (commands.destroys ? 2U : 0U) | (commands.order ? 4U : 0U), 1);
  const auto site = [&out](const Commands::Site& at) {
    out.number(at.x, 2);
    out.number(at.y, 2);
  };
  if (commands.building) site(*commands.building);
  if (commands.destroys) out.number(*commands.destroys, 4);
  if (commands.order) {
    out.number(commands.order->squad, 2);
    site(commands.order->to);
  }
}

Commands read_commands(Reader& in) {
  Commands commands;
  const std::size_t parts = in.count(1, 7);
  const auto site = [&in] {
    const auto x = in.integer<std::uint16_t>();
    const auto y = in.integer<std::uint16_t>();
    return Commands::Site{x, y};
  };
  if ((parts & 1) != 0) commands.building = site();
  if ((parts & 2) != 0) commands.destroys = in.integer<Tick>();
  if ((parts & 4) != 0) {
    const auto squad = in.integer<std::uint16_t>();
    commands.order = Commands::Order{squad, site()};
  }
  return commands;
}

Welcome read_welcome(Reader& in) {
  Welcome welcome;
  welcome.settings.agents = static_cast<std::uint32_t>(in.count(4, 1000000));
  welcome.settings.rocks = static_cast<std::uint32_t>(in.count(4, 1000000));
  welcome.settings.queries_per_tick = static_cast<std::uint32_t>(in.count(4, 1000000));
  welcome.end = in.integer<Tick>();
  welcome.tick = in.integer<Tick>();
  welcome.size = static_cast<std::uint32_t>(in.count(4, std::size_t{1} << 28));
  in.require(welcome.tick <= welcome.end);
  return welcome;
}

Update read_update(Reader& in) {
  Update update;
  for (std::size_t player = 0; player < kPlayers; ++player) {
    update.known[player] = in.integer<Tick>();
    update.rows[player].first = in.integer<Tick>();
    const std::size_t count = in.count(1, kCommandsInPacket);
    for (std::size_t i = 0; i < count; ++i) update.rows[player].commands.push_back(read_commands(in));
  }
  update.compared = in.integer<Tick>();
  update.lead = in.integer<std::uint16_t>();
  update.first_hash = in.integer<Tick>();
  const std::size_t count = in.count(1, kHashesInPacket);
  for (std::size_t i = 0; i < count; ++i) {
    StateHash& hash = update.hashes.emplace_back();
    for (std::uint64_t& word : hash.items.words) word = in.number(8);
    hash.agents = in.number(8);
  }
  update.is_done = in.count(1, 1) == 1;
  return update;
}

}  // namespace

Bytes bytes_of(const Hello& hello) {
  Writer out = packet(Kind::hello);
  out.number(hello.plays ? 1 : 0, 1);
  out.number(hello.tick, 4);
  return out.take();
}

Bytes bytes_of(const Welcome& welcome) {
  Writer out = packet(Kind::welcome);
  const Settings& settings = welcome.settings;
  for (const std::uint32_t number :
       {settings.agents, settings.rocks, settings.queries_per_tick, welcome.end, welcome.tick, welcome.size}) {
    out.number(number, 4);
  }
  return out.take();
}

Bytes bytes_of(const Want& want) {
  Writer out = packet(Kind::want);
  out.number(want.chunks.size(), 1);
  for (const std::uint32_t chunk : want.chunks) out.number(chunk, 4);
  return out.take();
}

Bytes bytes_of(const Chunk& chunk) {
  Writer out = packet(Kind::chunk);
  out.number(chunk.index, 4);
  out.number(chunk.bytes.size(), 2);
  out.raw(chunk.bytes);
  return out.take();
}

Bytes bytes_of(const Update& update) {
  Writer out = packet(Kind::update);
  for (std::size_t player = 0; player < kPlayers; ++player) {
    out.number(update.known[player], 4);
    out.number(update.rows[player].first, 4);
    out.number(update.rows[player].commands.size(), 1);
    for (const Commands& commands : update.rows[player].commands) write(out, commands);
  }
  out.number(update.compared, 4);
  out.number(update.lead, 2);
  out.number(update.first_hash, 4);
  out.number(update.hashes.size(), 1);
  for (const StateHash& hash : update.hashes) {
    for (const std::uint64_t word : hash.items.words) out.number(word, 8);
    out.number(hash.agents, 8);
  }
  out.number(update.is_done ? 1 : 0, 1);
  return out.take();
}

std::optional<Packet> read_packet(std::span<const std::uint8_t> bytes) {
  Reader in(bytes);
  Packet packet;
  in.require(in.number(1) == kProtocol);
  switch (static_cast<Kind>(in.count(1, static_cast<std::size_t>(Kind::update)))) {
    case Kind::hello:
      packet.hello.emplace();
      packet.hello->plays = in.count(1, 1) == 1;
      packet.hello->tick = in.integer<Tick>();
      break;
    case Kind::welcome:
      packet.welcome = read_welcome(in);
      break;
    case Kind::want: {
      packet.want.emplace();
      const std::size_t count = in.count(1, kWantedInPacket);
      for (std::size_t i = 0; i < count; ++i) packet.want->chunks.push_back(in.integer<std::uint32_t>());
      break;
    }
    case Kind::chunk: {
      packet.chunk.emplace();
      packet.chunk->index = in.integer<std::uint32_t>();
      const auto content = in.raw(in.count(2, kChunk));
      packet.chunk->bytes.assign(content.begin(), content.end());
      break;
    }
    case Kind::update:
      packet.update = read_update(in);
      break;
  }
  if (!in.is_at_end()) return std::nullopt;
  return packet;
}

Bytes save_game(const Simulation& simulation) {
  Writer out;
  std::ostringstream stream(std::ios::binary);
  save_world(simulation.world(), stream).value();
  const std::string world = stream.str();
  out.number(world.size(), 4);
  for (const char byte : world) out.number(static_cast<std::uint8_t>(byte), 1);
  const State& state = simulation.state();
  out.number(state.random, 8);
  out.number(state.agents.size(), 4);
  for (const Agent& agent : state.agents) {
    for (const Point& p : {agent.position.at, agent.position.heading, agent.post, agent.goal}) out.point(p);
    // Also the position on the path, and the path itself. A path that the agent asked for anew would begin where the
    // agent stands, and rounding could put the agent elsewhere at the next tick.
    out.number(agent.position.segment, 4);
    out.real(agent.position.before);
    out.real(agent.position.distance);
    out.number(agent.path ? agent.path->points.size() : 0, 4);
    if (!agent.path) continue;
    out.real(agent.path->length);
    for (const Point& p : agent.path->points) out.point(p);
  }
  out.number(state.waiting.size(), 4);
  for (const std::uint32_t agent : state.waiting) out.number(agent, 4);
  return out.take();
}

namespace {

Agent read_agent(Reader& in) {
  Agent agent;
  for (Point* const p : {&agent.position.at, &agent.position.heading, &agent.post, &agent.goal}) *p = in.point();
  agent.position.segment = in.integer<std::uint32_t>();
  agent.position.before = in.real();
  agent.position.distance = in.real();
  const std::size_t count = in.count(4, in.remaining() / 16);
  if (count == 0) return agent;
  in.require(agent.position.segment < count);
  Path path;
  path.status = PathStatus::found;
  path.length = in.real();
  for (std::size_t i = 0; i < count; ++i) path.points.push_back(in.point());
  agent.path = std::make_shared<const Path>(std::move(path));
  return agent;
}

}  // namespace

std::optional<Simulation> load_game(const Bytes& bytes, const Settings& settings, Tick tick, std::size_t threads) {
  Reader in(bytes);
  const auto saved = in.raw(in.count(4, bytes.size()));
  std::istringstream stream(std::string(saved.begin(), saved.end()), std::ios::binary);
  auto world = waywright::load_world(stream);
  State state;
  state.random = in.number(8);
  const std::size_t agents = in.count(4, settings.agents);
  for (std::size_t i = 0; i < agents; ++i) state.agents.push_back(read_agent(in));
  const std::size_t waiting = in.count(4, agents);
  for (std::size_t i = 0; i < waiting; ++i) {
    state.waiting.push_back(in.integer<std::uint32_t>());
    in.require(state.waiting.back() < agents);
  }
  if (!world.ok() || !in.is_at_end()) return std::nullopt;
  return Simulation(settings, tick, std::move(world).value(), std::move(state), threads);
}

}  // namespace lockstep
