#include "formats/wavefront_obj.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/number_text.hpp"
#include "formats/scene_builder.hpp"

namespace waywright::formats {

namespace {

/// The statements that say nothing about points, lines and faces.
constexpr std::string_view kIgnored[] = {"vt",     "vn",       "o",        "g",          "s",        "mg",
                                         "usemtl", "mtllib",   "usemap",   "maplib",     "lod",      "bevel",
                                         "call",   "c_interp", "d_interp", "shadow_obj", "trace_obj"};

class ObjReader {
 public:
  ObjReader(std::string_view text, const ReadProgress& progress) : text_(text), progress_(progress) {}

  Scene read();

 private:
  /// Moves to the next statement: a line, and the lines that a `\` at its end continues. Returns false at the end.
  bool next_statement();
  void read_statement();
  void read_vertex(text::WordReader& words);
  void check_height(double height);
  /// Returns the vertices that the other words of the statement name.
  [[nodiscard]] std::vector<Point> read_elements(text::WordReader& words, std::string_view element, std::size_t least);
  [[nodiscard]] const Point& vertex_of(std::string_view word) const;

  std::string_view text_;
  const ReadProgress& progress_;
  std::size_t start_ = 0;  ///< the offset of the statement
  std::size_t next_ = 0;   ///< the offset behind the statement
  std::string statement_;
  std::vector<Point> vertices_;
  double height_ = 0.0;  ///< the z of all vertices
  SceneBuilder builder_;
};

Scene ObjReader::read() {
  while (next_statement()) {
    read_statement();
    if (progress_) progress_(next_, text_.size());
  }
  return builder_.take();
}

bool ObjReader::next_statement() {
  statement_.clear();
  start_ = next_;
  while (next_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', next_), text_.size());
    std::string_view line = text_.substr(next_, end - next_);
    next_ = std::min(end + 1, text_.size());
    if (line.ends_with('\r')) line.remove_suffix(1);
    const bool is_continued = line.ends_with('\\');
    if (is_continued) line.remove_suffix(1);
    statement_ += line;
    if (!is_continued) return true;
    statement_ += ' ';
  }
  return start_ < next_;
}

void ObjReader::read_statement() {
  text::WordReader words(text::without_comment(statement_));
  std::string_view keyword;
  if (!words.next(keyword)) return;
  if (keyword == "v") return read_vertex(words);
  if (keyword == "p") {
    for (const Point& point : read_elements(words, "a point", 1)) builder_.add(Shape::point(point));
    return;
  }
  if (keyword == "l") return builder_.add(line_of_points(read_elements(words, "a line", 2)));
  if (keyword == "f" || keyword == "fo") {
    return builder_.add({ItemKind::polygon, {read_elements(words, "a face", 3)}});
  }
  if (std::find(std::begin(kIgnored), std::end(kIgnored), keyword) != std::end(kIgnored)) return;
  refuse(start_, "a statement v, p, l or f, or one without geometry, such as vn, g or usemtl",
         text::in_quotes(keyword) + "; replace curves and surfaces by polylines and faces");
}

void ObjReader::read_vertex(text::WordReader& words) {
  std::vector<double> numbers;
  std::string_view word;
  while (words.next(word)) {
    const std::optional<double> number = text::read_number(word);
    if (!number) refuse(start_, "a coordinate, a decimal number such as -1.5 or 2e3", text::in_quotes(word));
    // Only the first three numbers are coordinates: a weight or a colour may follow.
    numbers.push_back(numbers.size() < 3 ? checked_coordinate(*number, word, start_) : *number);
  }
  if (numbers.size() < 2 || numbers.size() > 7) {
    refuse(start_, "2 to 7 numbers in a vertex: x, y, and perhaps z and a weight or a colour",
           std::to_string(numbers.size()));
  }
  check_height(numbers.size() > 2 ? numbers[2] : 0.0);
  vertices_.push_back({numbers[0], numbers[1]});
}

void ObjReader::check_height(double height) {
  if (vertices_.empty()) height_ = height;
  if (height == height_) return;
  const auto text_of = [](double value) {
    std::string text;
    base::append_number(text, value);
    return text;
  };
  refuse(start_, "the z of the vertices above, " + text_of(height_),
         text_of(height) + "; a map has only x and y: project the model onto a plane of constant z first");
}

std::vector<Point> ObjReader::read_elements(text::WordReader& words, std::string_view element, std::size_t least) {
  std::vector<Point> points;
  std::string_view word;
  while (words.next(word)) points.push_back(vertex_of(word));
  if (points.size() < least) {
    refuse(start_,
           "at least " + std::to_string(least) + (least == 1 ? " vertex in " : " vertices in ") + std::string(element),
           std::to_string(points.size()));
  }
  return points;
}

const Point& ObjReader::vertex_of(std::string_view word) const {
  const std::string_view digits = word.substr(0, word.find('/'));
  std::int64_t index = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, fault] = std::from_chars(digits.data(), end, index);
  const auto count = static_cast<std::int64_t>(vertices_.size());
  if (fault == std::errc{} && stop == end) {
    if (index >= 1 && index <= count) return vertices_[static_cast<std::size_t>(index - 1)];
    if (index <= -1 && index >= -count) return vertices_[static_cast<std::size_t>(count + index)];
  }
  refuse(start_, "the number of a vertex above, 1 to " + std::to_string(count) + " or -1 to -" + std::to_string(count),
         text::in_quotes(word));
}

}  // namespace

Result<Scene> parse_wavefront_obj(std::string_view text, std::string_view name, const ReadProgress& progress) {
  return read_scene_text(text, name, [&](std::string_view read) { return ObjReader(read, progress).read(); });
}

}  // namespace waywright::formats
