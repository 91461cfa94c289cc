#include "simulation.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "numbers.hpp"

namespace lockstep {

using waywright::Change;
using waywright::Item;
using waywright::ItemId;
using waywright::Path;
using waywright::PathAlgorithm;
using waywright::PathStatus;
using waywright::Point;
using waywright::Shape;
using waywright::World;

namespace {

constexpr double kSquare = 52.0;        // metres: each square of the map has a rock
constexpr double kStep = 0.25;          // metres that an agent walks in a tick
constexpr double kPatrol = 96.0;        // metres from an agent's post to its goals, in each axis
constexpr double kEndTolerance = 40.0;  // metres by which a search may move a blocked end: more than any obstacle
constexpr double kBorder = 2.0;         // metres between the border of the map and all goals

/// The number of squares of the map in each axis.
std::uint32_t squares_of(const Settings& settings) {
  std::uint32_t squares = 1;
  while (squares * squares < settings.rocks) ++squares;
  return squares;
}

/// A hexagon in its cell.
Item rock(std::uint32_t index, std::uint32_t squares) {
  constexpr std::array<Point, 6> kCorners = {{{8, 0}, {4, 7}, {-4, 7}, {-8, 0}, {-4, -7}, {4, -7}}};
  const double size = 1.0 + share_of(3 * index);
  const Point centre{kSquare * (0.4 + 0.2 * share_of(3 * index + 1) + index % squares),
                     kSquare * (0.4 + 0.2 * share_of(3 * index + 2) + static_cast<double>(index / squares))};
  std::vector<Point> ring;
  for (const Point& corner : kCorners) {
    ring.push_back({rounded(centre.x + size * corner.x), rounded(centre.y + size * corner.y)});
  }
  return {std::uint64_t{index} + 1, Shape::polygon(ring)};
}

World new_world(const Settings& settings) {
  const std::uint32_t squares = squares_of(settings);
  World world = World::create({{0, 0}, {kSquare * squares, kSquare * squares}}).value();
  std::vector<Item> rocks;
  for (std::uint32_t i = 0; i < settings.rocks; ++i) rocks.push_back(rock(i, squares));
  world.insert_all(rocks).value();
  return world;
}

std::uint64_t bits_of(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

Simulation::Simulation(const Settings& settings, std::size_t threads)
    : Simulation(settings, 0, new_world(settings), {}, threads) {
  const double width = map_size();
  state_.agents.resize(settings.agents);
  for (std::size_t i = 0; i < state_.agents.size(); ++i) {
    Agent& agent = state_.agents[i];
    const std::uint64_t squad = 1000000 + 2 * (i / kSquad);
    agent.post = inside(width * share_of(squad), width * share_of(squad + 1));
    choose_goal(agent);
    agent.position.at = agent.goal;  // agents start where they could have walked to
    choose_goal(agent);
    state_.waiting.push_back(static_cast<std::uint32_t>(i));
  }
  answer_queries(state_.waiting.size());
  remember();
}

Simulation::Simulation(const Settings& settings, Tick tick, World world, State state, std::size_t threads)
    : settings_(settings),
      tick_(tick),
      world_(std::move(world)),
      state_(std::move(state)),
      first_tick_(tick),
      remembered_(kRememberedTicks),
      contexts_(threads) {
  world_.keep_history(kRememberedTicks);
  first_mark_ = world_.mark();
  remember();
}

/// Remembers the state at the present tick. The copy reuses the memory of the state that it replaces.
void Simulation::remember() {
  Remembered& now = remembered_[tick_ % kRememberedTicks];
  now.state = state_;
  now.items = world_.items_hash();
}

Tick Simulation::oldest_tick() const {
  return std::max(first_tick_, tick_ < kRememberedTicks ? 0 : tick_ - kRememberedTicks + 1);
}

/// Goes back: the world by its own history, everything else by a copy. The copies of the later ticks are now wrong.
/// When the machine plays these ticks again, it overwrites them.
void Simulation::rewind(Tick tick) {
  if (tick == tick_) return;
  world_.rewind(first_mark_ + (tick - first_tick_)).value();
  state_ = remembered_[tick % kRememberedTicks].state;
  tick_ = tick;
}

void Simulation::play(std::span<const Commands, kPlayers> commands) {
  const std::uint64_t version_before = world_.version();
  build(commands);
  give_orders(commands);
  stop_blocked_agents(version_before);
  answer_queries(settings_.queries_per_tick);
  move_agents();
  ++tick_;
  world_.mark();
  remember();
}

/// Carries out what can be carried out. That depends on the state alone: another machine may have built and taken back
/// other buildings in the meantime.
void Simulation::build(std::span<const Commands, kPlayers> commands) {
  changes_.clear();
  for (std::size_t player = 0; player < kPlayers; ++player) {
    if (const auto& site = commands[player].building) {
      const ItemId id = building_id(player, tick_);
      const Point centre = inside(site->x, site->y);
      // 20 metres from the border, so that the whole building lies on the map.
      const Point moved{std::clamp(centre.x, 20.0, map_size() - 20), std::clamp(centre.y, 20.0, map_size() - 20)};
      changes_.push_back(Change::insert(building_at(moved, id.value), id));
    }
    if (const auto& built = commands[player].destroys) {
      const ItemId id = building_id(player, *built);
      if (world_.contains(id)) changes_.push_back(Change::remove(id));
    }
  }
  if (!changes_.empty()) world_.apply(changes_).value();
}

/// Gives each agent of a squad a new post. Agent number i belongs to squad i / kSquad. The first squad belongs to the
/// first player, the second squad to the second player, the third to the first, and so on.
void Simulation::give_orders(std::span<const Commands, kPlayers> commands) {
  for (std::size_t player = 0; player < kPlayers; ++player) {
    const auto& order = commands[player].order;
    if (!order || order->squad % kPlayers != player) continue;
    for (std::size_t i = order->squad * kSquad; i < (order->squad + 1) * kSquad && i < state_.agents.size(); ++i) {
      Agent& agent = state_.agents[i];
      agent.post = inside(order->to.x, order->to.y);
      choose_goal(agent);
      if (agent.path) state_.waiting.push_back(static_cast<std::uint32_t>(i));
      agent.path = nullptr;
    }
  }
}

/// Stops the agents whose path a new building blocks, and lets them wait for a new path. Only is_clear() decides, whose
/// answer depends on the items alone. is_affected() may also be true because of a rollback: it only saves work.
void Simulation::stop_blocked_agents(std::uint64_t version_before) {
  if (world_.version() == version_before) return;
  for (std::size_t i = 0; i < state_.agents.size(); ++i) {
    Agent& agent = state_.agents[i];
    if (!agent.path) continue;
    const auto rest = std::span(agent.path->points).subspan(agent.position.segment);
    if (!world_.is_affected(rest, version_before) || world_.is_clear(rest, {}, contexts_[0]).value()) continue;
    agent.path = nullptr;
    state_.waiting.push_back(static_cast<std::uint32_t>(i));
  }
}

/// Finds the paths of the first agents in the queue, at most `limit`. A limit on the number of queries, and not on the
/// time, gives the same result on a slow machine.
void Simulation::answer_queries(std::size_t limit) {
  const std::size_t count = std::min(limit, state_.waiting.size());
  const auto end = state_.waiting.begin() + static_cast<std::ptrdiff_t>(count);
  queries_.clear();
  for (auto i = state_.waiting.begin(); i != end; ++i) {
    const Agent& agent = state_.agents[*i];
    // `tra` takes a fraction of the time of a search for the shortest path.
    queries_.push_back({.start = agent.position.at,
                        .goal = agent.goal,
                        .algorithm = PathAlgorithm::tra,
                        .end_tolerance = kEndTolerance});
  }
  world_.find_paths(queries_, contexts_, paths_).value();
  std::vector<std::uint32_t> again;
  for (std::size_t k = 0; k < count; ++k) {
    Agent& agent = state_.agents[state_.waiting[k]];
    if (paths_[k].status == PathStatus::found) {
      agent.path = std::make_shared<const Path>(std::move(paths_[k]));
      agent.position = agent.path->at(0);
    } else {
      choose_goal(agent);
      again.push_back(state_.waiting[k]);
    }
  }
  state_.waiting.erase(state_.waiting.begin(), end);
  state_.waiting.insert(state_.waiting.end(), again.begin(), again.end());
}

void Simulation::move_agents() {
  for (std::size_t i = 0; i < state_.agents.size(); ++i) {
    Agent& agent = state_.agents[i];
    if (!agent.path) continue;
    agent.position = agent.path->advance(agent.position, kStep);
    if (agent.position.distance < agent.path->length) continue;
    agent.path = nullptr;
    choose_goal(agent);
    state_.waiting.push_back(static_cast<std::uint32_t>(i));
  }
}

void Simulation::choose_goal(Agent& agent) {
  // Two statements: a compiler may evaluate the arguments of a call in any order.
  const double x = agent.post.x + kPatrol * (2 * next_share() - 1);
  const double y = agent.post.y + kPatrol * (2 * next_share() - 1);
  agent.goal = inside(x, y);
}

/// At least 0 and below 1.
double Simulation::next_share() { return share_of(state_.random++); }

/// The nearest point that has some distance from the border of the map.
Point Simulation::inside(double x, double y) const {
  return {rounded(std::clamp(x, kBorder, map_size() - kBorder)), rounded(std::clamp(y, kBorder, map_size() - kBorder))};
}

void Simulation::damage() {
  state_.agents[state_.agents.size() / 2].position.at.x += 0x1p-20;
  remember();
}

StateHash Simulation::hash(Tick tick) const {
  const auto& [state, items] = remembered_[tick % kRememberedTicks];
  std::uint64_t sum = mixed(state.random);
  const auto add = [&sum](std::uint64_t number) { sum = mixed(sum ^ number); };
  for (const Agent& agent : state.agents) {
    for (const double value : {agent.position.at.x, agent.position.at.y, agent.goal.x, agent.goal.y})
      add(bits_of(value));
    add(agent.path ? bits_of(agent.path->length) : 0);
  }
  for (const std::uint32_t agent : state.waiting) add(agent);
  return {items, sum};
}

namespace {

std::string first_item_that_differs(const World& ours, const World& theirs) {
  const std::vector<Item> a = ours.items();
  const std::vector<Item> b = theirs.items();
  const auto [in_a, in_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  const bool is_in_a = in_a != a.end() && (in_b == b.end() || in_a->id <= in_b->id);
  const bool is_in_b = in_b != b.end() && (in_a == a.end() || in_b->id <= in_a->id);
  const ItemId id = is_in_a ? in_a->id : in_b->id;
  const char* const how = is_in_a && is_in_b ? " has another shape"
                          : is_in_a          ? " exists only here"
                                             : " is missing here";
  return "item " + std::to_string(id.value) + how;
}

std::string words_of(const Agent& agent) {
  return "at " + to_string(agent.position.at) + ", goal " + to_string(agent.goal) + ", path of length " +
         (agent.path ? std::to_string(agent.path->length) : "none");
}

}  // namespace

std::string first_difference(const Simulation& ours, const Simulation& theirs) {
  if (ours.world().items_hash() != theirs.world().items_hash()) {
    return first_item_that_differs(ours.world(), theirs.world());
  }
  const State& a = ours.state();
  const State& b = theirs.state();
  for (std::size_t i = 0; i < std::min(a.agents.size(), b.agents.size()); ++i) {
    const std::string here = words_of(a.agents[i]);
    const std::string there = words_of(b.agents[i]);
    const Point& at = a.agents[i].position.at;
    if (here == there && at == b.agents[i].position.at) continue;
    return "agent " + std::to_string(i) + " is here " + here + "; there " + there;
  }
  return a.waiting != b.waiting ? "the queue of the agents that wait for a path" : "the state of the random numbers";
}

}  // namespace lockstep
