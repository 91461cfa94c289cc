#include "support/history_check.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "waywright/save.hpp"
#include "waywright/world.hpp"

#include "support/item_hash_oracle.hpp"
#include "support/live_items.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"
#include "support/saved_world_oracle.hpp"
#include "support/world_internals.hpp"

namespace waywright::test {

namespace {

/// What the world must contain. The dump is that of a new world with these items.
struct Model {
  LiveItems live;
  std::vector<Item> items;
  std::string dump;
  item_hash::Lanes hash;
};

Model model_of(const LiveItems& live, const WorldOptions& options) {
  World fresh = World::create(live.domain(), options).value();
  Model model{live, {}, {}, item_hash::hash_of(live.domain(), live.items())};
  for (const auto& [id, shape] : live.items()) {
    fresh.insert(shape, id).value();
    model.items.push_back({id, merged(shape)});
  }
  model.dump = fresh.dump();
  return model;
}

/// The answers of a world to some queries. They must not depend on how the world came to its items.
struct Answers {
  Answers(const World& world, Flavour flavour, std::uint64_t seed) {
    Random random(seed);
    const Box& domain = world.domain();
    for (int i = 0; i < 3; ++i) {
      PathQuery query{random_point(flavour, domain, random), random_point(flavour, domain, random)};
      for (const double radius : {0.0, (domain.max.x - domain.min.x) / 64}) {
        query.agent.radius = radius;
        if (radius > 0.0 && !world.options().keep_bridges) continue;
        const Path path = world.find_path(query).value();
        points.push_back(path.points);
        numbers.insert(numbers.end(), {path.length, path.lower_bound});
        numbers.push_back(static_cast<double>(path.expansions));
        affected.push_back(world.is_affected(path, world.version() / 2));
      }
      items.push_back(world.items_at(query.start).value());
      numbers.push_back(world.ray(query.start, query.goal).value().at.x);
    }
  }

  std::vector<std::vector<Point>> points;
  std::vector<std::vector<ItemId>> items;
  std::vector<double> numbers;
  std::vector<bool> affected;

  friend bool operator==(const Answers&, const Answers&) = default;
};

/// What a snapshot must have from the world that it was made from, apart from the items.
struct Numbers {
  explicit Numbers(const World& world)
      : version(world.version()), largest(world.largest_id_seen()), limit(world.new_vertex_limit()) {
    for (std::uint64_t since = 0; since <= version; since += 1 + version / 8) {
      const auto changed = world.changes_since(since);
      boxes.push_back(changed ? changed->size() : std::size_t{1} << 20);
      for (std::size_t i = 0; changed && i < changed->size(); i += 7) corners.push_back((*changed)[i].box.min);
    }
  }

  std::uint64_t version;
  ItemId largest;
  std::size_t limit;
  std::vector<std::size_t> boxes;
  std::vector<Point> corners;

  friend bool operator==(const Numbers&, const Numbers&) = default;
};

/// What a snapshot of a tick must have.
struct Tick {
  Model model;
  Numbers numbers;
  Answers answers;
  std::uint64_t seed;
};

struct Held {
  WorldSnapshot snapshot;
  Model model;
  Numbers numbers;
  Answers answers;
  std::uint64_t seed;
};

class RandomHistory {
 public:
  RandomHistory(Flavour flavour, std::uint64_t seed, std::size_t count)
      : flavour_(flavour),
        options_{.keep_abstraction = seed % 5 != 1, .keep_bridges = seed % 3 == 0},
        count_(count),
        kept_ticks_(1 + seed % 6),
        shares_pages_(seed % 2 == 0),
        script_(random_changes(flavour, seed, count, 4 + seed % 20)),
        random_(seed + (static_cast<std::uint64_t>(flavour) << 56)),
        world_(World::create(script_.domain, options_).value()),
        model_(model_of(LiveItems(script_.domain), options_)) {
    world_.keep_history(kept_ticks_);
  }

  HistoryReport run() {
    while (counts_.steps < count_ && fault_.empty()) {
      ++counts_.steps;
      make_step();
      compare();
    }
    while (!held_.empty() && fault_.empty()) compare_and_release();
    return {fault_.empty() ? "" : fault_ + ", step " + std::to_string(counts_.steps), counts_};
  }

 private:
  void make_step() {
    const std::size_t dice = random_.below(100);
    if (dice < 48) return change(random_.chance(20) ? random_step() : script_.steps[next_++ % script_.steps.size()]);
    if (dice < 58) return mark();
    if (dice < 66) return rewind();
    if (dice < 74) return attempt(random_.chance(50) ? random_step() : script_.steps[next_ % script_.steps.size()]);
    if (dice < 79) return publish();
    if (dice < 84) return publish_tick();
    if (dice < 92) return compare_and_release();
    if (dice < 94) return clone();
    if (dice < 96) return save_and_load();
    if (dice < 97) return reserve();
    if (dice < 98) return world_.shrink_to_fit();
    pass_limit();
  }

  void require(bool is_right, const char* fault) {
    if (!is_right && fault_.empty()) fault_ = fault;
  }

  /// Compares the world with the model.
  void compare() {
    require(world_.items() == model_.items, "the world has other items than the model");
    require(world_.items_hash().words == model_.hash, "the world has another hash than the model");
    require(world_.largest_id_seen() == model_.live.largest(), "the world has another next id than the model");
    require(world_.version() == version_, "the world has another version than the model");
    require(world_.dump() == model_.dump, "the world has another mesh than a new world");
    if (random_.chance(5)) require(world_.validate().fault.empty(), "the world is not valid");
  }

  void change(const Step& step) {
    LiveItems after = model_.live;
    const Result<std::vector<ItemId>> expected = after.apply(step);
    const Result<std::vector<ItemId>> done = perform(world_, step);
    require(done.ok() == expected.ok() && (!done || *done == *expected), "an operation has another result");
    ++counts_.operations;
    if (!expected) {
      ++counts_.refusals;
      return;
    }
    model_ = model_of(after, options_);
    ++version_;
  }

  void mark() {
    require(world_.mark() == last_ + 1, "a mark has another tick");
    ++counts_.marks;
    ++last_;
    const std::uint64_t seed = random_.below(1000);
    ticks_.insert_or_assign(last_, Tick{model_, Numbers(world_), Answers(world_, flavour_, seed), seed});
    if (ticks_.size() > kept_ticks_) ticks_.erase(ticks_.begin());
  }

  /// Returns a tick, mostly one that the history has.
  std::uint64_t random_tick() {
    const std::uint64_t first = ticks_.empty() ? 0 : ticks_.begin()->first;
    return random_.chance(10) ? random_.below(last_ + 2) : first + random_.below(last_ + 1 - first);
  }

  /// Returns whether the history has the tick, and whether the world has refused it if not.
  template <class Value>
  bool has_tick(std::uint64_t tick, const Result<Value>& done) {
    if (ticks_.contains(tick)) {
      require(done.ok(), "the world refused a tick that its history has");
      return done.ok();
    }
    const ErrorCode code = tick == 0 || tick > last_ ? ErrorCode::unknown_tick : ErrorCode::old_tick;
    require(!done && done.error().code == code, "the world did not refuse an unknown tick");
    return false;
  }

  void rewind() {
    const std::uint64_t tick = random_tick();
    if (!has_tick(tick, world_.rewind(tick))) return;
    const auto found = ticks_.find(tick);
    ++counts_.rewinds;
    ++version_;
    last_ = tick;
    model_ = found->second.model;
    ticks_.erase(std::next(found), ticks_.end());
    require(random_.chance(70) || world_.validate().fault.empty(), "the world is not valid after a rewind");
  }

  void attempt(const Step& step) {
    LiveItems after = model_.live;
    const bool is_legal = after.apply({step.changes, true}).ok();
    const bool validates = random_.chance(20);
    const Result<std::string> dump = world_.attempt(step.changes, [&](const World& changed) {
      if (validates) require(changed.validate().fault.empty(), "the world is not valid in an attempt");
      return changed.dump();
    });
    ++counts_.attempts;
    require(dump.ok() == is_legal, "an attempt was refused, or should have been refused");
    if (dump) require(*dump == model_of(after, options_).dump, "an attempt sees another mesh than a new world");
  }

  /// Publishes the present or a tick. In half of the histories, replicas share pages although the worlds are small.
  template <class... Ticks>
  auto published(Ticks... tick) {
    if (shares_pages_) WorldInternals::share_pages(world_);
    const std::size_t before = WorldInternals::sharing_replicas(world_);
    auto snapshot = world_.publish(tick...);
    if (WorldInternals::sharing_replicas(world_) > before) ++counts_.sharing_replicas;
    return snapshot;
  }

  void publish() {
    WorldSnapshot snapshot = published();
    const std::uint64_t seed = random_.below(1000);
    Held held{std::move(snapshot), model_, Numbers(world_), Answers(world_, flavour_, seed), seed};
    ++counts_.snapshots;
    compare(held);
    if (random_.chance(70)) held_.push_back(std::move(held));
  }

  void publish_tick() {
    const std::uint64_t number = random_tick();
    Result<WorldSnapshot> snapshot = published(number);
    if (!has_tick(number, snapshot)) return;
    const Tick& tick = ticks_.at(number);
    Held held{*std::move(snapshot), tick.model, tick.numbers, tick.answers, tick.seed};
    ++counts_.snapshots_of_ticks;
    compare(held);
    if (random_.chance(70)) held_.push_back(std::move(held));
  }

  void compare(const Held& held) {
    const World& world = *held.snapshot;
    require(world.items() == held.model.items, "a snapshot has other items");
    require(world.items_hash().words == held.model.hash, "a snapshot has another hash");
    require(world.dump() == held.model.dump, "a snapshot has another mesh");
    require(Numbers(world) == held.numbers, "a snapshot has other numbers or changed boxes");
    require(Answers(world, flavour_, held.seed) == held.answers, "a snapshot has other answers");
    require(world.validate().fault.empty(), "a snapshot is not valid");
  }

  void compare_and_release() {
    if (held_.empty()) return;
    std::swap(held_[random_.below(held_.size())], held_.back());
    const Held held = std::move(held_.back());
    held_.pop_back();
    const WorldSnapshot copy = held.snapshot;
    compare({copy, held.model, held.numbers, held.answers, held.seed});
    ++counts_.comparisons;
  }

  /// Continues with a copy. It has the same history, and no snapshots.
  void clone() {
    world_ = world_.clone();
    ++counts_.clones;
  }

  /// Continues with the world that a saved world gives. Its history is empty, and its version starts again.
  void save_and_load() {
    std::stringstream file;
    const std::uint32_t flags = (options_.keep_abstraction ? 1U : 0U) | (options_.keep_bridges ? 2U : 0U);
    const LiveItems& live = model_.live;
    require(save_world(world_, file).ok(), "a world could not be saved");
    require(file.str() == saved_world::bytes_of({live.domain(), flags, live.largest().value, live.items()}),
            "a saved world has other bytes than docs/formats.md defines");
    Result<World> loaded = load_world(file);
    if (!loaded) return require(false, "a saved world could not be loaded");
    world_ = *std::move(loaded);
    world_.keep_history(kept_ticks_);
    version_ = world_.version();
    last_ = 0;
    ticks_.clear();
    ++counts_.saves;
  }

  void reserve() {
    const ItemId id{model_.live.largest().value / 2 + random_.below(3)};
    if (id.is_null() || id.value > ItemId::kLargest) return;
    require(world_.reserve_ids(id).ok(), "an id could not be reserved");
    model_.live.reserve(id);
  }

  /// Makes an operation that the limit for new vertices stops in the middle, unless its vertices exist already.
  void pass_limit() {
    const Point a = script_.domain.min;
    const Point b = script_.domain.max;
    const Change insertion = Change::insert(Shape::segment(a + (b - a) * 0.3125, a + (b - a) * 0.4375));
    const Step step{std::vector<Change>(3, insertion), true};
    world_.set_new_vertex_limit(1);
    LiveItems after = model_.live;
    const bool is_legal = after.apply(step).ok();
    const Result<std::vector<ItemId>> done = perform(world_, step);
    world_.set_new_vertex_limit(kNoVertexLimit);
    ++counts_.operations;
    if (!done) {
      ++counts_.refusals;
      return require(!is_legal || done.error().code == ErrorCode::too_many_vertices, "an operation has another error");
    }
    require(is_legal, "an operation was not refused");
    model_ = model_of(after, options_);
    ++version_;
  }

  /// Inserts again, removes and replaces items that are live: the script does not know what rewinds have brought back.
  Step random_step() {
    Step step{{}, true};
    const auto& items = model_.live.items();
    if (items.empty()) return step;
    const auto any = [&] { return std::next(items.begin(), static_cast<std::ptrdiff_t>(random_.below(items.size()))); };
    for (std::size_t count = random_.below(6); count > 0; --count) {
      switch (random_.below(3)) {
        case 0:
          step.changes.push_back(Change::insert(any()->second));
          break;
        case 1:
          step.changes.push_back(Change::remove(any()->first));
          break;
        default:
          step.changes.push_back(Change::replace(any()->first, any()->second));
      }
    }
    return step;
  }

  Flavour flavour_;
  WorldOptions options_;
  std::size_t count_;
  std::size_t kept_ticks_;
  bool shares_pages_;
  ChangeScript script_;
  std::size_t next_ = 0;  ///< the next step of the script
  Random random_;
  World world_;
  Model model_;
  std::uint64_t version_ = 0;
  std::uint64_t last_ = 0;  ///< the last tick
  std::map<std::uint64_t, Tick> ticks_;
  std::vector<Held> held_;
  HistoryCounts counts_;
  std::string fault_;  ///< the first fault
};

}  // namespace

HistoryCounts& HistoryCounts::operator+=(const HistoryCounts& other) {
  steps += other.steps;
  operations += other.operations;
  refusals += other.refusals;
  marks += other.marks;
  rewinds += other.rewinds;
  attempts += other.attempts;
  snapshots += other.snapshots;
  snapshots_of_ticks += other.snapshots_of_ticks;
  comparisons += other.comparisons;
  sharing_replicas += other.sharing_replicas;
  clones += other.clones;
  saves += other.saves;
  return *this;
}

HistoryReport check_history(Flavour flavour, std::uint64_t seed, std::size_t count) {
  return RandomHistory(flavour, seed, count).run();
}

}  // namespace waywright::test
