#include "waywright/replay.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "base/float_environment.hpp"
#include "base/number_text.hpp"
#include "io/script.hpp"

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

/// The items that may have changed since the last tick with an equal hash. (In a replay, the hash is equal in the log
/// and in the world; in a comparison, in both logs.) These are the items that a change names, and the items that have
/// changed between a mark and a rewind to it.
class ChangedSinceHash {
 public:
  void add(ItemId id) {
    ids_.push_back(id);
    if (!marks_.empty()) after_marks_.push_back(id);
  }
  [[nodiscard]] bool has_mark(std::uint64_t tick) const { return tick != 0 && tick <= marks_.size(); }
  void mark() { marks_.push_back(after_marks_.size()); }
  /// Requires: has_mark(tick).
  void rewind(std::uint64_t tick) {
    const auto count = static_cast<std::size_t>(tick);
    const auto first = after_marks_.begin() + static_cast<std::ptrdiff_t>(marks_[count - 1]);
    ids_.insert(ids_.end(), first, after_marks_.end());
    after_marks_.erase(first, after_marks_.end());
    marks_.resize(count);
  }
  /// Forgets the items. Call this function at a tick with an equal hash.
  void clear() { ids_.clear(); }
  /// Returns the items in ascending order, each once.
  [[nodiscard]] std::vector<ItemId> take() {
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
    return std::move(ids_);
  }

 private:
  std::vector<ItemId> ids_;
  std::vector<ItemId> after_marks_;  ///< of all changes since the first mark, without those that were taken back
  std::vector<std::size_t> marks_;   ///< by tick - 1: the size of `after_marks_` at the mark
};

/// Makes the changes of one log in a world.
class Replayer {
 public:
  explicit Replayer(World& world) : world_(world) {}

  /// Handles a line. Returns whether the log and the world still agree.
  bool step(const ScriptLine& line) {
    if (is_change(line)) {
      changes_.push_back(change_of(line));
      lines_.push_back(line.line);
      changed_.add(line.item.id);
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
    if (line.kind == ScriptLineKind::mark) {
      changed_.mark();
      static_cast<void>(world_.mark());
      return true;
    }
    const Result<void> done = world_.rewind(line.tick);
    if (done.ok()) {
      changed_.rewind(line.tick);
    } else {
      result_.is_same = false;
      result_.tick = result_.tick + 1;
      result_.line = line.line;
      result_.refusal = done.error();
    }
    return done.ok();
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
      result_.changed = changed_.take();
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
  std::vector<Change> changes_;       ///< since the last tick, mark or rewind
  std::vector<std::uint32_t> lines_;  ///< of `changes_`
  ChangedSinceHash changed_;          ///< since the last hash
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
  static bool is_change_or_history(const ScriptLine* line) {
    return line != nullptr && (is_change(*line) || is_of_history(*line));
  }

  /// Compares two lines. Each one is a change, a mark, a rewind or a tick, or null at the end of a log. If they differ,
  /// stores the difference and returns true.
  bool differ(const ScriptLine* a, const ScriptLine* b) {
    if (is_change_or_history(a) || is_change_or_history(b)) {
      if (a != nullptr && b != nullptr && a->kind == b->kind && a->item == b->item && a->tick == b->tick) {
        note(*a);
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

  /// Notes the change, mark or rewind of a line that both logs contain.
  void note(const ScriptLine& line) {
    if (is_change(line)) changed_.add(line.item.id);
    if (line.kind == ScriptLineKind::mark) changed_.mark();
    if (line.kind == ScriptLineKind::rewind && changed_.has_mark(line.tick)) changed_.rewind(line.tick);
  }

  bool store(ReplayDifference::Kind kind, std::uint64_t tick, const ScriptLine* a, const ScriptLine* b) {
    difference_.kind = kind;
    difference_.tick = tick;
    difference_.line = a == nullptr ? 0 : a->line;
    difference_.other_line = b == nullptr ? 0 : b->line;
    if (is_change_or_history(a)) difference_.item = a->item.id;
    if (is_change_or_history(b)) difference_.other_item = b->item.id;
    if (kind == ReplayDifference::Kind::hash) difference_.changed = changed_.take();
    return true;
  }

  const Script& log_;
  const Script& other_;
  std::size_t i_ = 0;
  std::size_t j_ = 0;
  std::uint64_t tick_ = 0;
  ChangedSinceHash changed_;  ///< since the last tick at which both logs have a hash
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

ReplayWriter::ReplayWriter(std::ostream& out, const World& world, std::uint64_t ticks_per_hash)
    : out_(&out), ticks_per_hash_(ticks_per_hash) {
  const base::FloatEnvironment environment;
  WAYWRIGHT_ASSERT(ticks_per_hash >= 1, "ReplayWriter: `ticks_per_hash` is 0");
  io::append_header(text_, world.domain());
  Shape shape;
  for (const ItemId id : world.item_ids()) {
    if (world.shape(id, shape).ok()) io::append_item(text_, id, shape);
  }
  static_cast<void>(write());  // the next call reports a failure
}

Result<void> ReplayWriter::record(const Change& change) { return record({&change, 1}, {&change.id, 1}); }

Result<void> ReplayWriter::record(std::span<const Change> changes, std::span<const ItemId> ids) {
  const base::FloatEnvironment environment;
  WAYWRIGHT_ASSERT(changes.size() == ids.size(), "ReplayWriter::record: there must be one id for each change");
  text_.clear();
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (ids[i].is_null() || ids[i].value > ItemId::kLargest) return Error{ErrorCode::bad_id, {}, ids[i], i};
    if (changes[i].kind == Change::Kind::remove) {
      text_ += base::with_number("remove ", ids[i].value, "\n");
      continue;
    }
    if (changes[i].kind == Change::Kind::replace) text_ += "replace ";
    io::append_item(text_, ids[i], changes[i].shape);
  }
  return write();
}

Result<void> ReplayWriter::tick(const World& world) { return tick(world.items_hash()); }

Result<void> ReplayWriter::tick(const ItemsHash& hash) {
  const std::uint64_t tick = tick_ + 1;
  text_ = base::with_number("tick ", tick, "");
  const bool has_hash = tick % ticks_per_hash_ == 0;
  if (has_hash) text_ += " " + to_string(hash);
  text_ += '\n';
  tick_ = tick;  // no memory is needed from here on
  auto written = write();
  if (has_hash) out_->flush();
  return written.ok() && !out_->good() ? write() : written;
}

Result<void> ReplayWriter::write() {
  out_->write(text_.data(), static_cast<std::streamsize>(text_.size()));
  text_.clear();
  if (out_->good()) return {};
  return Error{ErrorCode::unwritable, "the replay log cannot be written: the stream accepts no more bytes", {}, 0};
}

}  // namespace waywright
