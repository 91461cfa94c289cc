#include "waywright/script.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "waywright/scene.hpp"

#include "base/float_environment.hpp"
#include "base/number_text.hpp"
#include "io/script.hpp"
#include "text/text.hpp"

namespace waywright {
namespace {

/// The syntax of a line of a script.
struct Grammar {
  std::string_view word;
  std::string_view usage;
  ScriptLineKind kind;
  ItemKind item = ItemKind::point;  ///< of an insertion: what it inserts
};

constexpr std::array kGrammars{
    Grammar{"point", "point ID X Y", ScriptLineKind::insert, ItemKind::point},
    Grammar{"segment", "segment ID X1 Y1 X2 Y2", ScriptLineKind::insert, ItemKind::segment},
    Grammar{"polyline", "polyline ID N X1 Y1 ... XN YN", ScriptLineKind::insert, ItemKind::polyline},
    Grammar{"polygon", "polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...", ScriptLineKind::insert,
            ItemKind::polygon},
    Grammar{"remove", "remove ID", ScriptLineKind::remove},
    Grammar{"replace", "replace KIND ID ...", ScriptLineKind::replace},
    Grammar{"locate", "locate X Y", ScriptLineKind::locate},
    Grammar{"ray", "ray X1 Y1 X2 Y2 [RADIUS]", ScriptLineKind::ray},
    Grammar{"disc", "disc X Y RADIUS", ScriptLineKind::disc},
    Grammar{"nearest", "nearest X Y RADIUS [goal X2 Y2]", ScriptLineKind::nearest},
    Grammar{"path", "path X1 Y1 X2 Y2 RADIUS [ALGORITHM] [tolerance DISTANCE]", ScriptLineKind::path},
    Grammar{"clear", "clear N X1 Y1 ... XN YN", ScriptLineKind::clear},
    Grammar{"check", "check", ScriptLineKind::check},
    Grammar{"hash", "hash", ScriptLineKind::hash},
    Grammar{"tick", "tick N [HASH]", ScriptLineKind::tick},
    Grammar{"mark", "mark TICK", ScriptLineKind::mark},
    Grammar{"rewind", "rewind TICK", ScriptLineKind::rewind},
};

constexpr std::string_view kHeaderUsage = "waywright 1";
constexpr std::string_view kDomainUsage = "domain X0 Y0 X1 Y1";
constexpr std::string_view kPointCount = "a count of points, 1 or more,";

/// Reads one script. Each function that returns bool returns false after it has stored an error in `error_`, except
/// next_line().
class ScriptParser {
 public:
  ScriptParser(std::string_view text, std::string_view name) : lines_(text), name_(name) {}

  Result<Script> run() {
    if (!read_header() || !read_lines()) return std::move(error_);
    return std::move(script_);
  }

 private:
  bool read_header();
  bool read_lines();
  bool read_line(std::string_view word);
  bool read_domain();
  /// Reads the words after the first one.
  bool read_rest(ScriptLine& line, const Grammar& grammar);
  bool read_insertion(Item& item, ItemKind kind);
  bool read_replacement(Item& item);
  bool read_rings(Shape& shape);
  bool read_ring(Rings& rings);
  bool read_ring(std::string_view count_word, Rings& rings);
  bool read_points(std::uint64_t count, Rings& rings);
  bool read_ray_radius(ScriptLine& line);
  bool read_path_options(ScriptLine& line);
  bool read_goal(ScriptLine& line);
  bool read_tick(ScriptLine& line);
  bool read_mark(ScriptLine& line);
  bool read_rewind(ScriptLine& line);

  /// Moves to the next line that contains a word. Returns false at the end of the text, which is not an error.
  bool next_line(std::string_view& word);
  bool number(double& value);
  /// Reads a bound of the domain. Fails if a world does not accept this coordinate. `bound` is the name of the bound in
  /// the usage.
  bool domain_bound(double& value, std::string_view bound);
  bool point(Point& value) { return number(value.x) && number(value.y); }
  bool id(ItemId& value);
  bool end_of_line();

  /// Stores an error: the parser expected `expected` and found `found`. An empty `found` means the end of the line.
  /// Returns false.
  bool fail(std::string_view expected, std::string_view found);

  text::LineReader lines_;
  std::string_view name_;
  text::WordReader words_;
  std::string_view usage_;  ///< of the current line
  Script script_;
  std::uint64_t last_mark_ = 0;  ///< the tick of the last mark, or of the last rewind after it
  Error error_;
};

bool ScriptParser::next_line(std::string_view& word) {
  std::string_view line;
  while (lines_.next(line)) {
    words_ = text::WordReader(text::without_comment(line));
    if (words_.next(word)) return true;
  }
  return false;
}

bool ScriptParser::fail(std::string_view expected, std::string_view found) {
  std::string what = "expected ";
  what += expected;
  if (!usage_.empty()) {
    what += " in '";
    what += usage_;
    what += '\'';
  }
  what += ", found ";
  what += found.empty() ? std::string("the end of the line") : text::in_quotes(found);
  error_ = text::error_at(ErrorCode::malformed, name_, lines_.number(), what);
  return false;
}

bool ScriptParser::number(double& value) {
  std::string_view word;
  if (!words_.next(word)) return fail("a number", {});
  const std::optional<double> read = text::read_number(word);
  if (!read) return fail("a number", word);
  value = *read;
  return true;
}

bool ScriptParser::domain_bound(double& value, std::string_view bound) {
  const std::string_view word = words_.peek();
  if (!number(value)) return false;
  std::string expected(bound);
  expected += " to be 0 or of a size from 2^-100 to 2^100";
  return is_in_range(value) || fail(expected, word);
}

bool ScriptParser::id(ItemId& value) {
  constexpr std::string_view kExpected = "an id from 1 to 9223372036854775807";
  std::string_view word;
  if (!words_.next(word)) return fail(kExpected, {});
  const std::optional<ItemId> read = text::read_id(word);
  if (!read) return fail(kExpected, word);
  value = *read;
  return true;
}

bool ScriptParser::end_of_line() {
  std::string_view word;
  return !words_.next(word) || fail("the end of the line", word);
}

bool ScriptParser::read_header() {
  std::string_view word;
  if (!next_line(word)) {
    error_ = text::error_at(ErrorCode::malformed, name_, lines_.number(),
                            "expected the header 'waywright 1', found the end of the text");
    return false;
  }
  if (word != "waywright") return fail("the header 'waywright 1'", word);
  usage_ = kHeaderUsage;
  std::string_view version;
  if (!words_.next(version)) return fail("the format version", {});
  return version == "1" ? end_of_line() : fail("format version 1", version);
}

bool ScriptParser::read_lines() {
  std::string_view word;
  while (next_line(word)) {
    if (!read_line(word)) return false;
  }
  if (script_.domain_line != 0) return true;
  error_ = text::error_at(ErrorCode::malformed, name_, lines_.number(),
                          "expected 'domain X0 Y0 X1 Y1', found the end of the text");
  return false;
}

bool ScriptParser::read_line(std::string_view word) {
  usage_ = {};
  if (word == "domain") return script_.domain_line == 0 ? read_domain() : fail("only one domain", word);
  const auto grammar =
      std::find_if(kGrammars.begin(), kGrammars.end(), [&](const Grammar& g) { return g.word == word; });
  if (grammar == kGrammars.end()) return fail("a word such as 'point' or 'path'", word);
  if (script_.domain_line == 0) return fail("'domain X0 Y0 X1 Y1' before anything else", word);
  usage_ = grammar->usage;
  ScriptLine line;
  line.kind = grammar->kind;
  line.line = static_cast<std::uint32_t>(lines_.number());
  if (!read_rest(line, *grammar) || !end_of_line()) return false;
  script_.lines.push_back(std::move(line));
  return true;
}

bool ScriptParser::read_domain() {
  usage_ = kDomainUsage;
  Box& box = script_.domain;
  if (!domain_bound(box.min.x, "X0") || !domain_bound(box.min.y, "Y0") || !domain_bound(box.max.x, "X1") ||
      !domain_bound(box.max.y, "Y1") || !end_of_line()) {
    return false;
  }
  const auto check = [this](double low, double high) {
    std::string found;
    base::append_number(found, high);
    std::string expected = "a number above ";
    base::append_number(expected, low);
    return low < high || fail(expected, found);
  };
  if (!check(box.min.x, box.max.x) || !check(box.min.y, box.max.y)) return false;
  script_.domain_line = static_cast<std::uint32_t>(lines_.number());
  return true;
}

bool ScriptParser::read_rest(ScriptLine& line, const Grammar& grammar) {
  switch (line.kind) {
    case ScriptLineKind::insert:
      return read_insertion(line.item, grammar.item);
    case ScriptLineKind::remove:
      return id(line.item.id);
    case ScriptLineKind::replace:
      return read_replacement(line.item);
    case ScriptLineKind::locate:
      return point(line.from);
    case ScriptLineKind::ray:
      return point(line.from) && point(line.to) && read_ray_radius(line);
    case ScriptLineKind::disc:
      return point(line.from) && number(line.agent.radius);
    case ScriptLineKind::nearest:
      return point(line.from) && number(line.agent.radius) && read_goal(line);
    case ScriptLineKind::path:
      return point(line.from) && point(line.to) && number(line.agent.radius) && read_path_options(line);
    case ScriptLineKind::clear:
      return read_ring(line.item.shape.rings);
    case ScriptLineKind::tick:
      return read_tick(line);
    case ScriptLineKind::mark:
      return read_mark(line);
    case ScriptLineKind::rewind:
      return read_rewind(line);
    case ScriptLineKind::check:
    case ScriptLineKind::hash:
      break;
  }
  return true;
}

bool ScriptParser::read_insertion(Item& item, ItemKind kind) {
  item.shape.kind = kind;
  if (!id(item.id)) return false;
  if (kind == ItemKind::polygon) return read_rings(item.shape);
  if (kind == ItemKind::polyline) return read_ring(item.shape.rings);
  item.shape.rings.start_ring();
  return read_points(kind == ItemKind::point ? 1 : 2, item.shape.rings);
}

bool ScriptParser::read_replacement(Item& item) {
  constexpr std::string_view kExpected = "'point', 'segment', 'polyline' or 'polygon'";
  std::string_view word;
  if (!words_.next(word)) return fail(kExpected, {});
  const auto grammar = std::find_if(kGrammars.begin(), kGrammars.end(), [&](const Grammar& g) {
    return g.kind == ScriptLineKind::insert && g.word == word;
  });
  if (grammar == kGrammars.end()) return fail(kExpected, word);
  usage_ = grammar->usage;
  return read_insertion(item, grammar->item);
}

bool ScriptParser::read_rings(Shape& shape) {
  std::string_view word;
  if (!words_.next(word)) return fail(kPointCount, {});
  if (word == to_string(FillRule::nonzero)) {
    shape.fill = FillRule::nonzero;
    if (!words_.next(word)) return fail(kPointCount, {});
  }
  if (!read_ring(word, shape.rings)) return false;
  while (words_.next(word)) {
    if (word != "/") return fail("'/' or the end of the line", word);
    if (!read_ring(shape.rings)) return false;
  }
  return true;
}

bool ScriptParser::read_ring(Rings& rings) {
  std::string_view word;
  return words_.next(word) ? read_ring(word, rings) : fail(kPointCount, {});
}

bool ScriptParser::read_ring(std::string_view count_word, Rings& rings) {
  const std::optional<std::uint64_t> count = text::read_unsigned(count_word);
  if (!count || *count == 0) return fail(kPointCount, count_word);
  // A point takes at least two digits and a blank. So a count that is too large for the line does not reserve more
  // memory than the line needs.
  const auto likely_count = static_cast<std::size_t>(std::min<std::uint64_t>(*count, words_.remaining() / 3));
  if (rings.empty()) rings.reserve(likely_count);
  rings.start_ring();
  return read_points(*count, rings);
}

/// Reads points into the last ring.
bool ScriptParser::read_points(std::uint64_t count, Rings& rings) {
  for (std::uint64_t i = 0; i < count; ++i) {
    Point p;
    if (!point(p)) return false;
    rings.add_point(p);
  }
  return true;
}

bool ScriptParser::read_ray_radius(ScriptLine& line) {
  line.has_radius = !words_.peek().empty();
  return !line.has_radius || number(line.agent.radius);
}

bool ScriptParser::read_path_options(ScriptLine& line) {
  std::string_view word;
  if (!words_.next(word)) return true;
  line.algorithm = path_algorithm(word);
  if (line.algorithm && !words_.next(word)) return true;
  if (word != "tolerance") return fail(line.algorithm ? "'tolerance'" : "'optimal', 'ta', 'tra' or 'tolerance'", word);
  return number(line.end_tolerance.emplace());
}

bool ScriptParser::read_goal(ScriptLine& line) {
  std::string_view word;
  if (!words_.next(word)) return true;
  line.has_goal = true;
  return word == "goal" ? point(line.to) : fail("'goal' or the end of the line", word);
}

/// Reads one word of an ItemsHash: 16 hexadecimal digits, as to_string(ItemsHash) writes them.
std::optional<std::uint64_t> read_hash_word(std::string_view digits) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::uint64_t lane = 0;
  for (const char c : digits) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    lane = lane << 4 | digit;
  }
  return lane;
}

bool ScriptParser::read_tick(ScriptLine& line) {
  std::string_view word;
  if (!words_.next(word)) return fail("the number of a tick", {});
  const std::optional<std::uint64_t> number = text::read_unsigned(word);
  if (!number) return fail("the number of a tick", word);
  line.tick = *number;
  if (!words_.next(word)) return true;
  constexpr std::size_t kDigitsOfWord = 16;
  if (word.size() != 2 * kDigitsOfWord) return fail("32 hexadecimal digits or the end of the line", word);
  const std::optional<std::uint64_t> first = read_hash_word(word.substr(0, kDigitsOfWord));
  const std::optional<std::uint64_t> second = read_hash_word(word.substr(kDigitsOfWord));
  if (!first || !second) return fail("32 hexadecimal digits or the end of the line", word);
  line.items_hash = ItemsHash{{*first, *second}};
  return true;
}

/// Reads the tick that World::mark() returns here. The script contains this number so that a person who reads the
/// script need not count marks.
bool ScriptParser::read_mark(ScriptLine& line) {
  line.tick = ++last_mark_;
  const std::string expected = "tick " + std::to_string(line.tick) + ", the one after the last mark,";
  std::string_view word;
  if (!words_.next(word)) return fail(expected, {});
  return text::read_unsigned(word) == line.tick || fail(expected, word);
}

bool ScriptParser::read_rewind(ScriptLine& line) {
  const std::string expected =
      last_mark_ == 0 ? "a mark before" : "a tick from 1 to " + std::to_string(last_mark_) + ", the last mark,";
  std::string_view word;
  if (!words_.next(word)) return fail(expected, {});
  const std::optional<std::uint64_t> tick = text::read_unsigned(word);
  if (!tick || *tick == 0 || *tick > last_mark_) return fail(expected, word);
  line.tick = last_mark_ = *tick;
  return true;
}

/// Returns whether a world over `domain` accepts the shape.
bool fits(const Shape& shape, const Box& domain) {
  const auto is_accepted = [&](Point p) {
    return is_in_range(p) && p.x >= domain.min.x && p.x <= domain.max.x && p.y >= domain.min.y && p.y <= domain.max.y;
  };
  const std::span<const Point> points = shape.rings.points();
  return std::all_of(points.begin(), points.end(), is_accepted);
}

/// Follows the changes of a script, and finds out which items are left.
class LiveLines {
 public:
  explicit LiveLines(const Box& domain) : domain_(domain) {}

  void read(const ScriptLine& line) {
    switch (line.kind) {
      case ScriptLineKind::remove:
        if (live_.contains(line.item.id)) set(line.item.id, {});
        break;
      case ScriptLineKind::insert:
        if (fits(line.item.shape, domain_) && !live_.contains(line.item.id)) set(line.item.id, {&line, &line});
        break;
      case ScriptLineKind::replace:
        if (const auto found = live_.find(line.item.id); found != live_.end() && fits(line.item.shape, domain_)) {
          set(line.item.id, {found->second.inserted, &line});
        }
        break;
      case ScriptLineKind::mark:
        marks_.push_back(undo_.size());
        break;
      case ScriptLineKind::rewind:
        rewind(line.tick);
        break;
      default:
        break;
    }
  }
  [[nodiscard]] std::size_t size() const { return live_.size(); }
  /// Returns the line that gave an item its shape, if the item is left and `line` inserted it. Otherwise null.
  [[nodiscard]] const ScriptLine* shaped_after(const ScriptLine& line) const {
    const auto found = live_.find(line.item.id);
    return found != live_.end() && found->second.inserted == &line ? found->second.shaped : nullptr;
  }

 private:
  struct Live {
    const ScriptLine* inserted = nullptr;
    const ScriptLine* shaped = nullptr;  ///< the line of the insertion, or of the last replacement after it
  };

  /// Changes an item and records how to take this back. If `now.inserted` is null, the item does not exist afterwards.
  void set(ItemId id, const Live& now) {
    const auto found = live_.find(id);
    if (!marks_.empty()) undo_.emplace_back(id, found == live_.end() ? Live{} : found->second);
    put(id, now);
  }
  void put(ItemId id, const Live& now) {
    if (now.inserted == nullptr) {
      live_.erase(id);
    } else {
      live_[id] = now;
    }
  }
  void rewind(std::uint64_t tick) {
    if (tick == 0 || tick > marks_.size()) return;  // the parser has refused such a line
    marks_.resize(static_cast<std::size_t>(tick));
    for (; undo_.size() > marks_.back(); undo_.pop_back()) put(undo_.back().first, undo_.back().second);
  }

  const Box& domain_;
  std::unordered_map<ItemId, Live> live_;
  std::vector<std::pair<ItemId, Live>> undo_;  ///< since the first mark
  std::vector<std::size_t> marks_;             ///< the length of `undo_` at each mark
};

}  // namespace

std::string_view to_string(const ScriptLine& line) {
  if (line.kind == ScriptLineKind::insert) return to_string(line.item.shape.kind);
  const auto grammar =
      std::find_if(kGrammars.begin(), kGrammars.end(), [&](const Grammar& g) { return g.kind == line.kind; });
  return grammar == kGrammars.end() ? std::string_view{} : grammar->word;
}

Result<Script> parse_script(std::string_view text, std::string_view name) {
  const base::FloatEnvironment environment;
  if (auto error = text::skip_byte_order_mark(text, name)) return *std::move(error);
  return ScriptParser(text, name).run();
}

Scene scene_of(const Script& script) {
  const base::FloatEnvironment environment;
  LiveLines live(script.domain);
  for (const ScriptLine& line : script.lines) live.read(line);
  Scene scene{.domain = script.domain, .items = {}, .y_down = false};
  scene.items.reserve(live.size());
  for (const ScriptLine& line : script.lines) {
    if (line.kind != ScriptLineKind::insert) continue;
    if (const ScriptLine* const shaped = live.shaped_after(line)) scene.items.push_back(shaped->item);
  }
  return scene;
}

namespace {

void append_coordinates(std::string& out, Point point) {
  out += ' ';
  base::append_number(out, point.x);
  out += ' ';
  base::append_number(out, point.y);
}

/// Appends the points of a ring. Writes their number before them if `with_count` is true.
void append_ring(std::string& out, PointSpan ring, bool with_count) {
  if (with_count) {
    out += ' ';
    base::append_unsigned(out, ring.size());
  }
  for (const Point point : ring) append_coordinates(out, point);
}

}  // namespace

void io::append_item(std::string& out, ItemId id, const Shape& shape) {
  const ItemKind kind = shape.kind;
  const bool with_count = kind == ItemKind::polyline || kind == ItemKind::polygon;
  out += to_string(kind);
  out += ' ';
  base::append_unsigned(out, id.value);
  if (kind == ItemKind::polygon && shape.fill == FillRule::nonzero) {
    out += ' ';
    out += to_string(FillRule::nonzero);
  }
  std::string_view separator;
  for (const PointSpan& ring : shape.rings) {
    out += separator;
    append_ring(out, ring, with_count);
    separator = " /";
  }
  out += '\n';
}

void io::append_header(std::string& out, const Box& domain) {
  out += "waywright 1\ndomain";
  append_coordinates(out, domain.min);
  append_coordinates(out, domain.max);
  out += '\n';
}

std::string to_script(const Scene& scene) {
  const base::FloatEnvironment environment;
  std::string out;
  io::append_header(out, scene.domain);
  for (const Item& item : scene.items) io::append_item(out, item.id, item.shape);
  return out;
}

}  // namespace waywright
