#include "support/random_changes.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>

#include "waywright/item.hpp"
#include "waywright/scene.hpp"

#include "support/random.hpp"

namespace waywright::test {
namespace {

enum class Season : std::uint8_t { growth, churn, decline };

class ChangeMaker {
 public:
  ChangeMaker(Flavour flavour, std::uint64_t seed, std::size_t live_count)
      : random_(seed ^ 0x6368616e67657321U),
        rules_(seed ^ 0x72756c6573212121U),
        limit_(std::max<std::size_t>(live_count, 1)),
        pool_(random_scene(flavour, seed, 2 * limit_)),
        has_sparse_ids_(random_.chance(20)),
        live_(pool_.domain) {}

  ChangeScript make(std::size_t step_count) {
    ChangeScript result{pool_.domain, {}};
    while (result.steps.size() < step_count) {
      turn_season();
      Step step = random_.chance(4) ? wrong_step() : next_step();
      // The script also contains steps that must be refused. The checks expect that.
      static_cast<void>(live_.apply(step));
      result.steps.push_back(std::move(step));
    }
    return result;
  }

 private:
  void turn_season() {
    const std::size_t count = live_.items().size();
    if (season_ == Season::growth && count >= limit_) season_ = Season::churn;
    if (season_ == Season::churn && random_.below(2 * limit_) == 0) season_ = Season::decline;
    if (season_ == Season::decline && (count == 0 || random_.below(4 * limit_) == 0)) season_ = Season::growth;
  }

  Step next_step() {
    if (!random_.chance(12)) return {{next_change(live_)}, false};
    Step step{{}, true};
    LiveItems after = live_;
    for (std::size_t count = random_.below(7); count > 0; --count) {
      step.changes.push_back(next_change(after));
      static_cast<void>(after.apply({{step.changes.back()}, false}));
    }
    return step;
  }

  Change next_change(const LiveItems& live) {
    const std::size_t dice = random_.below(100);
    const std::size_t inserts = season_ == Season::growth ? 75 : season_ == Season::churn ? 38 : 6;
    const std::size_t replaces = season_ == Season::growth ? 12 : season_ == Season::churn ? 24 : 6;
    if (live.items().empty() || (dice < inserts && live.items().size() < limit_)) return insertion(live);
    const ItemId id = choose(live);
    if (dice < inserts + replaces) {
      const Shape& old = remember(live.items().at(id));
      return {Change::Kind::replace, id, random_.chance(30) ? dragged(old) : fresh_shape()};
    }
    remember(live.items().at(id));
    return {Change::Kind::remove, id, {}};
  }

  Change insertion(const LiveItems& live) {
    if (random_.chance(3)) return {Change::Kind::insert, {}, fresh_shape()};
    ItemId id = some_id();
    while (live.items().contains(id)) id = some_id();
    return {Change::Kind::insert, id, fresh_shape()};
  }

  /// Returns one of few ids, not many more than items can be live, so that each id is used again and again.
  ItemId some_id() {
    const std::uint64_t number = 1 + random_.below(2 * limit_ + 1);
    if (!has_sparse_ids_) return {number};
    return {number == 1 ? ItemId::kLargest : (number * 0x9e3779b97f4a7c15U) >> (1 + number % 40)};
  }

  /// Returns a live item: any, or the one of a few that touches the shape that changed last.
  ItemId choose(const LiveItems& live) {
    const auto any = [&] {
      return std::next(live.items().begin(), static_cast<std::ptrdiff_t>(random_.below(live.items().size())));
    };
    auto chosen = any();
    for (int tries = random_.chance(60) ? 6 : 0; tries > 0 && !are_near(chosen->second, last_); --tries) chosen = any();
    return chosen->first;
  }

  static bool are_near(const Shape& a, const Shape& b) {
    if (b.rings.empty()) return true;
    return Box::bounding(a.rings.points()).overlaps(Box::bounding(b.rings.points()));
  }

  /// Stores the shape, so that it can be inserted again later.
  const Shape& remember(const Shape& shape) {
    last_ = shape;
    removed_shapes_[next_removed_++ % removed_shapes_.size()] = shape;
    return last_;
  }

  Shape fresh_shape() {
    const Shape& removed_shape = removed_shapes_[random_.below(removed_shapes_.size())];
    if (random_.chance(25) && !removed_shape.rings.empty()) return last_ = removed_shape;
    const Shape& other = pool_.items[random_.below(pool_.items.size())].shape;
    return last_ = random_.chance(15) ? dragged(other) : other;
  }

  /// Returns the shape with one of its corners moved to a corner of another shape and, sometimes, with the other fill
  /// rule.
  Shape dragged(Shape shape) {
    const MutablePointSpan ring = shape.rings[random_.below(shape.rings.size())];
    const Shape& other = pool_.items[random_.below(pool_.items.size())].shape;
    ring[random_.below(ring.size())] = other.rings[0][random_.below(other.rings[0].size())];
    const bool is_even_odd = shape.fill == FillRule::even_odd;
    if (rules_.chance(30) && shape.kind == ItemKind::polygon)
      shape.fill = is_even_odd ? FillRule::nonzero : FillRule::even_odd;
    return shape;
  }

  Change wrong_change(const LiveItems& live) {
    ItemId unused = some_id();
    while (live.items().contains(unused)) unused = some_id();
    const std::size_t dice = random_.below(5);
    if (dice == 0) return {Change::Kind::remove, unused, {}};
    if (dice == 1) return {Change::Kind::replace, unused, fresh_shape()};
    Shape shape = fresh_shape();
    if (dice == 2 && !live.items().empty()) return {Change::Kind::insert, choose(live), std::move(shape)};
    // The last point is wrong, so that a world could have inserted all the others before it finds out.
    const Box& domain = pool_.domain;
    Point& wrong = shape.rings.back().back();
    wrong = dice == 3 ? Point{domain.min.x, std::numeric_limits<double>::quiet_NaN()}
                      : Point{domain.max.x + (domain.max.x - domain.min.x), domain.min.y};
    if (live.items().empty() || random_.chance(50)) return {Change::Kind::insert, unused, std::move(shape)};
    return {Change::Kind::replace, choose(live), std::move(shape)};
  }

  Step wrong_step() {
    if (random_.chance(50)) return {{wrong_change(live_)}, false};
    Step step{{}, true};
    LiveItems after = live_;
    for (std::size_t count = 1 + random_.below(4); count > 0; --count) {
      step.changes.push_back(next_change(after));
      static_cast<void>(after.apply({{step.changes.back()}, false}));
    }
    step.changes.push_back(wrong_change(after));
    return step;
  }

  Random random_;
  Random rules_;  ///< for fill rules only; nothing else depends on it
  std::size_t limit_;
  Scene pool_;
  bool has_sparse_ids_;
  LiveItems live_;
  Season season_ = Season::growth;
  Shape last_;
  std::array<Shape, 8> removed_shapes_;
  std::size_t next_removed_ = 0;
};

/// Returns the line of a world script that inserts the item.
std::string insertion_line(ItemId id, const Shape& shape) {
  const std::string script = to_script(Scene{{{0, 0}, {1, 1}}, {{id, shape}}, false});
  const std::size_t start = script.rfind('\n', script.size() - 2) + 1;
  return script.substr(start);
}

std::string line_of(const Change& change, ItemId id) {
  if (change.kind == Change::Kind::remove) return "remove " + std::to_string(id.value) + "\n";
  const std::string insertion = insertion_line(id, change.shape);
  return change.kind == Change::Kind::replace ? "replace " + insertion : insertion;
}

}  // namespace

ChangeScript random_changes(Flavour flavour, std::uint64_t seed, std::size_t step_count, std::size_t live_count) {
  return ChangeMaker(flavour, seed, live_count).make(step_count);
}

ChangeScript changes_of(const Script& script) {
  ChangeScript result{script.domain, {}};
  for (const ScriptLine& operation : script.lines) {
    const ItemId id = operation.item.id;
    if (operation.kind == ScriptLineKind::insert) {
      result.steps.push_back({{{Change::Kind::insert, id, operation.item.shape}}, false});
    } else if (operation.kind == ScriptLineKind::remove) {
      result.steps.push_back({{{Change::Kind::remove, id, {}}}, false});
    } else if (operation.kind == ScriptLineKind::replace) {
      result.steps.push_back({{{Change::Kind::replace, id, operation.item.shape}}, false});
    }
  }
  return result;
}

std::string to_script(const ChangeScript& changes) {
  std::string script = to_script(Scene{changes.domain, {}, false});
  LiveItems live(changes.domain);
  for (const Step& step : changes.steps) {
    const Result<std::vector<ItemId>> ids = live.apply(step);
    if (step.is_batch) script += "# a batch of " + std::to_string(step.changes.size()) + "\n";
    if (!ids) script += "# refused: " + std::string(to_string(ids.error().code)) + "\n";
    for (std::size_t i = 0; ids && i < step.changes.size(); ++i) script += line_of(step.changes[i], (*ids)[i]);
  }
  return script;
}

}  // namespace waywright::test
