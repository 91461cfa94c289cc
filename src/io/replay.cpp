#include "waywright/replay.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace waywright {
namespace {

bool is_change(const ScriptLine& line) {
  return line.kind == ScriptLineKind::insert || line.kind == ScriptLineKind::remove ||
         line.kind == ScriptLineKind::replace;
}

/// Returns whether a line is a mark or a rewind.
bool is_of_history(const ScriptLine& line) {
  return line.kind == ScriptLineKind::mark || line.kind == ScriptLineKind::rewind;
}

Change change_of(const ScriptLine& line) {
  if (line.kind == ScriptLineKind::remove) return Change::remove(line.item.id);
  if (line.kind == ScriptLineKind::replace) return Change::replace(line.item.id, line.item.shape);
  return Change::insert(line.item.shape, line.item.id);
}

void sort_ids(std::vector<ItemId>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// Makes the changes of one log in a world.
class Replayer {
 public:
  explicit Replayer(World& world) : world_(world) {}

  /// Handles a line. Returns whether the log and the world still agree.
  bool step(const ScriptLine& line) {
    if (is_change(line)) {
      changes_.push_back(change_of(line));
      lines_.push_back(line.line);
      changed_.push_back(line.item.id);
      return true;
    }
    if (is_of_history(line)) return mark_or_rewind(line);
    return line.kind != ScriptLineKind::tick || end_tick(line);
  }
  /// Makes the changes after the last tick.
  bool finish() { return apply_changes(result_.tick + 1); }
  ReplayResult take_result() { return std::move(result_); }

 private:
  /// Marks the present state of the world, or brings back a marked state.
  bool mark_or_rewind(const ScriptLine& line) {
    if (!apply_changes(result_.tick + 1)) return false;
    if (line.kind == ScriptLineKind::mark) return world_.mark() != 0;
    return world_.rewind(line.tick).ok();
  }

  bool end_tick(const ScriptLine& line) {
    if (!apply_changes(line.tick)) return false;
    ++result_.ticks;
    result_.tick = line.tick;
    if (!line.items_hash) return true;
    result_.line = line.line;
    result_.expected = *line.items_hash;
    result_.computed = world_.items_hash();
    result_.is_same = result_.expected == result_.computed;
    if (result_.is_same) {
      result_.last_same = line.tick;
      changed_.clear();
    } else {
      result_.changed = std::move(changed_);
      sort_ids(result_.changed);
    }
    return result_.is_same;
  }

  bool apply_changes(std::uint64_t tick) {
    const auto done = world_.apply(changes_);
    if (!done.ok()) {
      const auto refused = static_cast<std::size_t>(done.error().index);
      result_.is_same = false;
      result_.tick = tick;
      result_.line = lines_[refused];
      result_.changed = {changes_[refused].id};
      result_.refusal = done.error();
    }
    changes_.clear();
    lines_.clear();
    return done.ok();
  }

  World& world_;
  ReplayResult result_;
  std::vector<Change> changes_;       ///< since the last tick
  std::vector<std::uint32_t> lines_;  ///< of `changes_`
  std::vector<ItemId> changed_;       ///< since the last hash
};

/// Finds the first difference between two logs.
class Comparison {
 public:
  Comparison(const Script& log, const Script& other) : log_(log), other_(other) {}

  std::optional<ReplayDifference> run() {
    if (!(log_.domain == other_.domain)) {
      difference_ = {ReplayDifference::Kind::domain, 0, log_.domain_line, other_.domain_line, {}, {}, {}};
      return difference_;
    }
    for (;; ++i_, ++j_) {
      skip_queries(log_, i_);
      skip_queries(other_, j_);
      const ScriptLine* const a = line_at(log_, i_);
      const ScriptLine* const b = line_at(other_, j_);
      if (a == nullptr && b == nullptr) return std::nullopt;
      if (differ(a, b)) return difference_;
    }
  }

 private:
  static void skip_queries(const Script& log, std::size_t& i) {
    while (i < log.lines.size() && !is_change(log.lines[i]) && !is_of_history(log.lines[i]) &&
           log.lines[i].kind != ScriptLineKind::tick) {
      ++i;
    }
  }
  static const ScriptLine* line_at(const Script& log, std::size_t i) {
    return i < log.lines.size() ? &log.lines[i] : nullptr;
  }
  /// A mark or a rewind counts as a change that has no item.
  static bool is_a_change(const ScriptLine* line) {
    return line != nullptr && (is_change(*line) || is_of_history(*line));
  }

  /// Compares two lines, which are changes or ticks; null is the end of a log. Stores the difference.
  bool differ(const ScriptLine* a, const ScriptLine* b) {
    if (is_a_change(a) || is_a_change(b)) {
      if (a != nullptr && b != nullptr && a->kind == b->kind && a->item == b->item && a->tick == b->tick) {
        if (is_change(*a)) changed_.push_back(a->item.id);
        return false;
      }
      return store(ReplayDifference::Kind::change, tick_ + 1, a, b);
    }
    if (a == nullptr || b == nullptr || a->tick != b->tick) return store(ReplayDifference::Kind::length, tick_, a, b);
    tick_ = a->tick;
    if (!a->items_hash || !b->items_hash) return false;
    if (*a->items_hash != *b->items_hash) return store(ReplayDifference::Kind::hash, tick_, a, b);
    changed_.clear();
    return false;
  }

  bool store(ReplayDifference::Kind kind, std::uint64_t tick, const ScriptLine* a, const ScriptLine* b) {
    difference_.kind = kind;
    difference_.tick = tick;
    difference_.line = a == nullptr ? 0 : a->line;
    difference_.other_line = b == nullptr ? 0 : b->line;
    if (is_a_change(a)) difference_.item = a->item.id;
    if (is_a_change(b)) difference_.other_item = b->item.id;
    if (kind == ReplayDifference::Kind::hash) difference_.changed = std::move(changed_);
    sort_ids(difference_.changed);
    return true;
  }

  const Script& log_;
  const Script& other_;
  std::size_t i_ = 0;
  std::size_t j_ = 0;
  std::uint64_t tick_ = 0;
  std::vector<ItemId> changed_;  ///< since the last hash in both logs
  ReplayDifference difference_;
};

}  // namespace

Result<ReplayResult> replay(const Script& log,
                            const std::function<void(std::size_t done, std::size_t total)>& progress) {
  Result<World> world = World::create(log.domain);
  if (!world.ok()) return world.error();
  const auto marks = std::count_if(log.lines.begin(), log.lines.end(),
                                   [](const ScriptLine& line) { return line.kind == ScriptLineKind::mark; });
  world->keep_history(static_cast<std::size_t>(marks));
  Replayer replayer(*world);
  for (std::size_t i = 0; i < log.lines.size(); ++i) {
    if (progress) progress(i, log.lines.size());
    if (!replayer.step(log.lines[i])) return replayer.take_result();
  }
  static_cast<void>(replayer.finish());
  return replayer.take_result();
}

std::optional<ReplayDifference> find_difference(const Script& log, const Script& other) {
  return Comparison(log, other).run();
}

}  // namespace waywright
