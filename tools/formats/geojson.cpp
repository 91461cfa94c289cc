#include "formats/geojson.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "formats/geojson_coordinates.hpp"
#include "formats/scene_builder.hpp"

namespace waywright::formats {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kDeepest = 64;  // of collections in collections
constexpr std::string_view kGeometries[] = {"Point",   "MultiPoint",   "LineString",        "MultiLineString",
                                            "Polygon", "MultiPolygon", "GeometryCollection"};
constexpr const char* kGeometryNames =
    "Point, MultiPoint, LineString, MultiLineString, Polygon, MultiPolygon or GeometryCollection";

bool is_geometry(std::string_view type) {
  return std::find(std::begin(kGeometries), std::end(kGeometries), type) != std::end(kGeometries);
}

/// An iterator over the text that stores how far the JSON parser has read: the parser does not say it.
class TextIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  TextIterator(const char* at, const char*& reached) : at_(at), reached_(&reached) {}

  reference operator*() const { return *at_; }
  TextIterator& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  TextIterator operator++(int) {
    TextIterator old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const TextIterator& a, const TextIterator& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  const char** reached_;
};

/// What the next value in the text is.
enum class Role : unsigned char {
  root,
  features,  ///< the array; `feature` is one element
  feature,
  geometries,  ///< the array; `member` is one element
  member,
  geometry,  ///< of a feature
  type,
  coordinates,
  id,
  properties,
  property,  ///< the property `waywright`
  own,       ///< the member `waywright` of the whole file
  domain,
  y_down,
  bound,  ///< one number of the domain
  other,  ///< a value without a meaning
};

/// An array or object of the text that is not complete yet.
struct Frame {
  Role role = Role::other;
  std::size_t offset = 0;   ///< where it starts
  Role next = Role::other;  ///< of the value that follows
  std::vector<Role> seen;   ///< the members so far
  std::string type;
  std::optional<Coordinates> coordinates;
  std::size_t coordinates_offset = 0;
  std::vector<Shape> shapes;  ///< of a geometry or feature
  std::optional<ItemId> id;
  std::string kind;  ///< the property `waywright`
  std::size_t kind_offset = 0;
};

/// Receives the events of the JSON parser. The parser calls it with the names that nlohmann/json documents.
class GeoJsonReader {
 public:
  GeoJsonReader(std::string_view text, const char* const& reached, const ReadProgress& progress)
      : text_(text), reached_(reached), progress_(progress) {}

  [[nodiscard]] Scene take() { return builder_.take(); }

  bool null();
  bool boolean(bool value);
  bool number_integer(Json::number_integer_t value);
  bool number_unsigned(Json::number_unsigned_t value);
  bool number_float(Json::number_float_t value, const std::string& word);
  bool string(std::string& value);
  bool binary(Json::binary_t& /*value*/) { return true; }  // no JSON text has such values
  bool start_object(std::size_t /*size*/);
  bool key(std::string& name);
  bool end_object();
  bool start_array(std::size_t /*size*/);
  bool end_array();
  bool parse_error(std::size_t /*offset*/, const std::string& /*token*/, const Json::exception& error);

 private:
  /// The offset of the last character that the parser has read, or of the one before it.
  [[nodiscard]] std::size_t offset() const {
    const auto read = static_cast<std::size_t>(reached_ - text_.data());
    return read == 0 ? 0 : read - 1;
  }
  [[nodiscard]] Role next_role() const { return frames_.empty() ? Role::root : frames_.back().next; }
  /// Returns whether the value belongs to no member that the reader knows.
  [[nodiscard]] bool is_skipped() const { return skipped_ > 0 || next_role() == Role::other; }
  void add_number(double value, std::string_view word);
  bool refuse_value(std::string_view found) const;
  void begin(Role role, Role next);
  [[nodiscard]] Role role_of(Role frame, std::string_view name) const;
  void end_geometry(Frame& frame);
  void end_feature(Frame& frame);
  void end_root(Frame& frame);
  /// Throws a Refusal unless an object has the member that contains its geometry, and no such member of other types.
  void check_members(const Frame& frame) const;
  void set_domain(const Frame& frame);
  void add_items(std::vector<Shape>& shapes, std::optional<ItemId> id);

  std::string_view text_;
  const char* const& reached_;
  const ReadProgress& progress_;
  std::vector<Frame> frames_;
  std::size_t skipped_ = 0;  ///< the number of open arrays and objects without a meaning
  std::vector<double> bounds_;
  SceneBuilder builder_;
};

const char* expected_of(Role role) {
  switch (role) {
    case Role::root:
      return "a GeoJSON object";
    case Role::features:
      return "an array of features";
    case Role::feature:
      return "a Feature";
    case Role::geometries:
      return "an array of geometries";
    case Role::type:
      return "a text, the type of the object";
    case Role::coordinates:
      return "an array of coordinates";
    case Role::id:
      return "a number or a text, the id of the feature";
    case Role::properties:
      return "an object, the properties of the feature";
    case Role::property:
      return "one of the texts point, segment, polyline, polygon, polygon nonzero, path, triangle and edge";
    case Role::own:
      return "an object, such as {\"domain\":[0,0,10,10]}";
    case Role::domain:
    case Role::bound:
      return "an array of four numbers, the domain";
    case Role::y_down:
      return "true or false";
    default:
      return "a geometry";
  }
}

bool GeoJsonReader::refuse_value(std::string_view found) const { refuse(offset(), expected_of(next_role()), found); }

bool GeoJsonReader::null() {
  const Role role = next_role();
  // A feature may have no geometry and no properties.
  return is_skipped() || role == Role::geometry || role == Role::properties || refuse_value("null");
}

bool GeoJsonReader::boolean(bool value) {
  if (is_skipped()) return true;
  if (next_role() != Role::y_down) return refuse_value(value ? "true" : "false");
  builder_.set_y_down(value);
  return true;
}

bool GeoJsonReader::number_integer(Json::number_integer_t value) {
  if (!is_skipped()) add_number(static_cast<double>(value), std::to_string(value));
  return true;
}

bool GeoJsonReader::number_unsigned(Json::number_unsigned_t value) {
  if (is_skipped()) return true;
  if (next_role() == Role::id) {
    // Any other id may be a name in another program, and becomes no id of an item.
    if (value > 0 && value <= ItemId::kLargest) frames_.back().id = ItemId{value};
    return true;
  }
  add_number(static_cast<double>(value), std::to_string(value));
  return true;
}

bool GeoJsonReader::number_float(Json::number_float_t value, const std::string& word) {
  // The parser's own conversion depends on the C library.
  if (!is_skipped()) add_number(text::read_number(word).value_or(value), word);
  return true;
}

void GeoJsonReader::add_number(double value, std::string_view word) {
  const Role role = next_role();
  if (role == Role::id) return;
  if (role == Role::bound) {
    bounds_.push_back(checked_coordinate(value, word, offset()));
    return;
  }
  if (role != Role::coordinates || !frames_.back().coordinates) {
    refuse_value("the number " + std::string(word));
    return;
  }
  frames_.back().coordinates->add_number(checked_coordinate(value, word, offset()), offset());
}

bool GeoJsonReader::string(std::string& value) {
  if (is_skipped()) return true;
  switch (next_role()) {
    case Role::type:
      frames_.back().type = std::move(value);
      return true;
    case Role::property:
      frames_[frames_.size() - 2].kind = std::move(value);
      frames_[frames_.size() - 2].kind_offset = offset();
      return true;
    case Role::id:
      return true;
    default:
      return refuse_value("the text " + text::in_quotes(value));
  }
}

void GeoJsonReader::begin(Role role, Role next) {
  Frame& frame = frames_.emplace_back();
  frame.role = role;
  frame.offset = offset();
  frame.next = next;
}

bool GeoJsonReader::start_object(std::size_t /*size*/) {
  if (is_skipped()) {
    ++skipped_;
    return true;
  }
  const Role role = next_role();
  switch (role) {
    case Role::root:
    case Role::feature:
    case Role::geometry:
    case Role::member:
    case Role::properties:
    case Role::own:
      if (frames_.size() > 2 * kDeepest) {
        throw Refusal{.offset = offset(), .what = "collections lie in collections more than 64 deep; flatten them"};
      }
      begin(role, Role::other);
      return true;
    default:
      return refuse_value("an object");
  }
}

Role GeoJsonReader::role_of(Role frame, std::string_view name) const {
  struct Member {
    std::string_view name;
    Role role;
  };
  static constexpr Member kOfObjects[] = {{"type", Role::type},
                                          {"coordinates", Role::coordinates},
                                          {"geometries", Role::geometries},
                                          {"geometry", Role::geometry},
                                          {"properties", Role::properties},
                                          {"features", Role::features},
                                          {"id", Role::id}};
  if (frame == Role::properties) return name == kOwnMember ? Role::property : Role::other;
  if (frame == Role::own) return name == "domain" ? Role::domain : name == "y_down" ? Role::y_down : Role::other;
  if (frame == Role::root && name == kOwnMember) return Role::own;
  for (const Member& member : kOfObjects) {
    if (member.name == name) return member.role;
  }
  return Role::other;
}

bool GeoJsonReader::key(std::string& name) {
  if (skipped_ > 0) return true;
  Frame& frame = frames_.back();
  frame.next = role_of(frame.role, name);
  if (frame.next == Role::other) return true;
  if (std::find(frame.seen.begin(), frame.seen.end(), frame.next) != frame.seen.end()) {
    refuse(offset(), "one member " + text::in_quotes(name) + " in an object", "a second one");
  }
  frame.seen.push_back(frame.next);
  return true;
}

bool GeoJsonReader::start_array(std::size_t /*size*/) {
  if (is_skipped()) {
    ++skipped_;
    return true;
  }
  switch (next_role()) {
    case Role::features:
      begin(Role::features, Role::feature);
      return true;
    case Role::geometries:
      begin(Role::geometries, Role::member);
      return true;
    case Role::domain:
      begin(Role::domain, Role::bound);
      return true;
    case Role::coordinates: {
      Frame& frame = frames_.back();
      if (!frame.coordinates) {
        frame.coordinates.emplace();
        frame.coordinates_offset = offset();
      }
      frame.coordinates->open_array(offset());
      return true;
    }
    default:
      return refuse_value("an array");
  }
}

bool GeoJsonReader::end_array() {
  if (skipped_ > 0) {
    --skipped_;
    return true;
  }
  Frame& frame = frames_.back();
  if (frame.next == Role::coordinates) {
    frame.coordinates->close_array(offset());
    return true;
  }
  if (frame.role == Role::domain) set_domain(frame);
  std::vector<Shape> shapes = std::move(frame.shapes);
  frames_.pop_back();
  frames_.back().shapes.insert(frames_.back().shapes.end(), std::make_move_iterator(shapes.begin()),
                               std::make_move_iterator(shapes.end()));
  return true;
}

void GeoJsonReader::set_domain(const Frame& frame) {
  const bool is_box = bounds_.size() == 4 && bounds_[0] < bounds_[2] && bounds_[1] < bounds_[3];
  if (!is_box) {
    refuse(frame.offset, "a domain of four numbers: min x, min y, max x, max y, each min below its max",
           bounds_.size() == 4 ? "a box without area" : std::to_string(bounds_.size()) + " numbers");
  }
  builder_.set_domain({{bounds_[0], bounds_[1]}, {bounds_[2], bounds_[3]}});
}

bool GeoJsonReader::end_object() {
  if (skipped_ > 0) {
    --skipped_;
    return true;
  }
  Frame frame = std::move(frames_.back());
  const bool is_object = frame.role != Role::properties && frame.role != Role::own;
  if (is_object && frame.type.empty()) refuse(frame.offset, "a member 'type' in the object", "none");
  switch (frame.role) {
    case Role::feature:
      end_feature(frame);
      break;
    case Role::geometry:
    case Role::member:
      end_geometry(frame);
      break;
    case Role::root:
      end_root(frame);
      break;
    default:
      break;
  }
  frames_.pop_back();
  if (frames_.empty()) return true;
  Frame& parent = frames_.back();
  if (frame.role == Role::geometry || frame.role == Role::member) {
    parent.shapes.insert(parent.shapes.end(), std::make_move_iterator(frame.shapes.begin()),
                         std::make_move_iterator(frame.shapes.end()));
  }
  return true;
}

void GeoJsonReader::check_members(const Frame& frame) const {
  struct Member {
    Role role;
    const char* name;
  };
  static constexpr Member kMembers[] = {{Role::features, "features"},
                                        {Role::geometry, "geometry"},
                                        {Role::geometries, "geometries"},
                                        {Role::coordinates, "coordinates"}};
  const Role needed = frame.type == "FeatureCollection"    ? Role::features
                      : frame.type == "Feature"            ? Role::geometry
                      : frame.type == "GeometryCollection" ? Role::geometries
                                                           : Role::coordinates;
  for (const auto& [role, name] : kMembers) {
    const bool has = std::find(frame.seen.begin(), frame.seen.end(), role) != frame.seen.end();
    if (has == (role == needed)) continue;
    const std::string member = "member '" + std::string(name) + "' in a " + frame.type;
    refuse(frame.offset, (has ? "no " : "a ") + member, has ? "one" : "none");
  }
}

void GeoJsonReader::end_geometry(Frame& frame) {
  if (!is_geometry(frame.type)) {
    refuse(frame.offset, std::string("a geometry of type ") + kGeometryNames,
           "the type " + text::in_quotes(frame.type));
  }
  check_members(frame);
  if (frame.type == "GeometryCollection") return;  // its members have appended their shapes
  frame.coordinates->append_shapes(frame.type, frame.coordinates_offset, frame.shapes);
}

/// Gives the shape the kind that the property `waywright` names. Returns false if no shape like this has this kind.
bool set_kind(Shape& shape, std::string_view kind) {
  const bool is_line = shape.kind == ItemKind::segment || shape.kind == ItemKind::polyline;
  if (kind == "polyline" && is_line) {
    shape.kind = ItemKind::polyline;
    return true;
  }
  if (kind == "polygon nonzero" && shape.kind == ItemKind::polygon) {
    shape.fill = FillRule::nonzero;
    return true;
  }
  return kind == to_string(shape.kind);
}

void GeoJsonReader::end_feature(Frame& frame) {
  if (frame.type != "Feature") {
    refuse(frame.offset, "an object of type Feature in the features", "the type " + text::in_quotes(frame.type));
  }
  check_members(frame);
  if (frame.kind == "path" || frame.kind == "triangle" || frame.kind == "edge") return;
  for (Shape& shape : frame.shapes) {
    if (frame.kind.empty() || set_kind(shape, frame.kind)) continue;
    refuse(frame.kind_offset,
           "a property 'waywright' that fits the geometry, such as '" + std::string(to_string(shape.kind)) + "'",
           text::in_quotes(frame.kind) + "; change it or remove it");
  }
  if (frame.id && !frame.shapes.empty() && builder_.is_in_use(*frame.id)) {
    refuse(frame.offset, "an id that no feature above has",
           std::to_string(frame.id->value) + "; give the feature another id, or remove it");
  }
  add_items(frame.shapes, frame.id);
}

void GeoJsonReader::add_items(std::vector<Shape>& shapes, std::optional<ItemId> id) {
  for (Shape& shape : shapes) builder_.add(std::move(shape), std::exchange(id, std::nullopt));
  shapes.clear();
  if (progress_) progress_(offset(), text_.size());
}

void GeoJsonReader::end_root(Frame& frame) {
  if (frame.type == "FeatureCollection") return check_members(frame);
  if (frame.type == "Feature") return end_feature(frame);
  if (!is_geometry(frame.type)) {
    refuse(frame.offset, std::string("an object of type FeatureCollection, Feature, ") + kGeometryNames,
           "the type " + text::in_quotes(frame.type));
  }
  end_geometry(frame);
  add_items(frame.shapes, std::nullopt);
}

bool GeoJsonReader::parse_error(std::size_t /*offset*/, const std::string& /*token*/, const Json::exception& error) {
  constexpr std::size_t kLongest = 200;
  std::string what = error.what();
  // The message starts with the name of the exception and with a line and column, which the Refusal gives, too.
  const std::size_t column = what.find("column ");
  const std::size_t start = column == std::string::npos ? what.find("] ") : what.find(": ", column);
  if (start != std::string::npos) what.erase(0, start + 2);
  if (what.size() > kLongest) what.replace(kLongest, std::string::npos, "...");
  throw Refusal{.offset = offset(), .what = "the JSON text cannot be read: " + what};
}

}  // namespace

Result<Scene> parse_geojson(std::string_view text, std::string_view name, const ReadProgress& progress) {
  return read_scene_text(text, name, [&](std::string_view read) {
    const char* reached = read.data();
    GeoJsonReader reader(read, reached, progress);
    const char* const end = read.data() + read.size();
    Json::sax_parse(TextIterator(read.data(), reached), TextIterator(end, reached), &reader);
    return reader.take();
  });
}

}  // namespace waywright::formats
