#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/save.hpp"

#include "base/compiler.hpp"
#include "base/number_text.hpp"
#include "io/crc32c.hpp"
#include "text/file_types.hpp"
#include "text/text.hpp"

// Writes and reads saved worlds. docs/formats.md describes the format.

namespace waywright {

namespace {

constexpr std::uint64_t kSavedWorldVersion = 1;

// The bits of the options.
constexpr std::uint64_t kKeepsAbstraction = 1;
constexpr std::uint64_t kKeepsBridges = 2;

/// The largest number of items of one run: a group of items of one kind whose ids count up by 1.
constexpr std::uint64_t kLargestRun = 4096;

/// The largest number of points of one ring, and of rings of one item: a world accepts no more.
constexpr std::uint64_t kLargestCount = std::uint64_t{1} << 27;

/// The kinds have the same numbers as in the hash of the items: see docs/hashes.md.
enum class SavedKind : std::uint8_t { point, segment, polyline, even_odd_polygon, nonzero_polygon };
constexpr std::uint64_t kSavedKindCount = 5;
/// The kind of a run is in these low bits, the number of its items is above them.
constexpr unsigned kKindBits = 3;

static_assert(sizeof(double) == 8 && std::numeric_limits<double>::is_iec559);

constexpr std::size_t kStep = 8;
using Table = std::array<std::uint32_t, 256>;

/// Returns the tables: in table i, the entry of a byte is the effect of this byte, followed by i zero bytes.
constexpr std::array<Table, kStep> make_tables() {
  constexpr std::uint32_t kReversedPolynomial = 0x82f63b78;
  std::array<Table, kStep> tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t state = byte;
    for (int bit = 0; bit < 8; ++bit) state = (state >> 1) ^ ((state & 1) != 0 ? kReversedPolynomial : 0);
    tables[0][byte] = state;
  }
  for (std::size_t i = 1; i < kStep; ++i) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[i - 1][byte];
      tables[i][byte] = (before >> 8) ^ tables[0][before & 0xff];
    }
  }
  return tables;
}

constexpr std::array<Table, kStep> kTables = make_tables();

}  // namespace

void io::Crc32c::add(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])); };
  std::uint32_t state = state_;
  while (bytes.size() >= kStep) {
    state ^= byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
    state = kTables[7][state & 0xff] ^ kTables[6][state >> 8 & 0xff] ^ kTables[5][state >> 16 & 0xff] ^
            kTables[4][state >> 24] ^ kTables[3][byte(4)] ^ kTables[2][byte(5)] ^ kTables[1][byte(6)] ^
            kTables[0][byte(7)];
    bytes.remove_prefix(kStep);
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) state = (state >> 8) ^ kTables[0][(state ^ byte(i)) & 0xff];
  state_ = state;
}

namespace {

void append_fixed(std::string& bytes, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}

void append_double(std::string& bytes, double value) { append_fixed(bytes, base::bit_cast<std::uint64_t>(value), 8); }

void append_point(std::string& bytes, const Point& p) {
  append_double(bytes, p.x);
  append_double(bytes, p.y);
}

void append_varint(std::string& bytes, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>((value & 0x7f) | 0x80);
  bytes += static_cast<char>(value);
}

SavedKind kind_of(const Shape& shape) {
  switch (shape.kind) {
    case ItemKind::point:
      return SavedKind::point;
    case ItemKind::segment:
      return SavedKind::segment;
    case ItemKind::polyline:
      return SavedKind::polyline;
    case ItemKind::polygon:
      break;
  }
  return shape.fill == FillRule::nonzero ? SavedKind::nonzero_polygon : SavedKind::even_odd_polygon;
}

/// Writes one world to a stream: the header, the runs of items, and the checksum.
class WorldWriter {
 public:
  explicit WorldWriter(std::ostream& out) : out_(out) {}

  /// Returns whether the stream has accepted all bytes.
  bool write(const World& world) {
    add_header(world);
    for (const ItemId id : world.item_ids()) {
      if (!world.shape(id, shape_).ok()) return false;  // never: the world has this item
      add_item(id);
      if (bytes_.size() >= kPiece && !write_bytes()) return false;
    }
    end_run();
    if (!write_bytes()) return false;
    append_fixed(bytes_, checksum_.value(), 4);
    return write_bytes() && out_.flush().good();
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 16;

  void add_header(const World& world) {
    const WorldOptions options = world.options();
    bytes_ += text::kSavedWorldMagic;
    append_fixed(bytes_, kSavedWorldVersion, 2);
    append_point(bytes_, world.domain().min);
    append_point(bytes_, world.domain().max);
    append_fixed(bytes_,
                 (options.keep_abstraction ? kKeepsAbstraction : 0) | (options.keep_bridges ? kKeepsBridges : 0), 4);
    append_fixed(bytes_, world.largest_id_seen().value, 8);
    append_fixed(bytes_, world.item_count(), 8);
    for (const std::uint64_t word : world.items_hash().words) append_fixed(bytes_, word, 8);
  }

  /// Adds the item with the shape `shape_` to the run, or to a new run if it does not belong to this one.
  void add_item(ItemId id) {
    const SavedKind kind = kind_of(shape_);
    const bool continues = run_size_ > 0 && run_size_ < kLargestRun && id.value == last_id_ + 1 && kind == kind_;
    if (!continues) {
      end_run();
      id_step_ = id.value - last_id_;
      kind_ = kind;
    }
    ++run_size_;
    last_id_ = id.value;
    const bool is_polygon = shape_.kind == ItemKind::polygon;
    if (is_polygon) append_varint(counts_, shape_.rings.size());
    if (is_polygon || shape_.kind == ItemKind::polyline) {
      for (const auto& ring : shape_.rings) append_varint(counts_, ring.size());
    }
    for (const Point& p : shape_.rings.points()) append_point(points_, p);
  }

  void end_run() {
    if (run_size_ == 0) return;
    append_varint(bytes_, id_step_);
    append_varint(bytes_, run_size_ << kKindBits | static_cast<std::uint64_t>(kind_));
    bytes_ += counts_;
    bytes_ += points_;
    run_size_ = 0;
    counts_.clear();
    points_.clear();
  }

  bool write_bytes() {
    checksum_.add(bytes_);
    out_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    bytes_.clear();
    return out_.good();
  }

  std::ostream& out_;
  io::Crc32c checksum_;
  std::string bytes_;  ///< not written yet
  Shape shape_;
  std::uint64_t last_id_ = 0;

  // The run under way.
  std::uint64_t run_size_ = 0;
  std::uint64_t id_step_ = 0;  ///< the first id of the run minus the id of the last item before it
  SavedKind kind_ = SavedKind::point;
  std::string counts_;
  std::string points_;
};

}  // namespace

Result<void> save_world(const World& world, std::ostream& out) {
  if (out.good() && WorldWriter(out).write(world)) return {};
  return Error{ErrorCode::unwritable, "the world cannot be saved: the stream accepts no more bytes", {}, 0};
}

/// Points and their ids, which ascend. As long as the ids count up, the object contains only the first of them.
struct LoadedPoints {
  std::vector<Point> points;
  ItemId first;             ///< the id of the first point
  std::vector<ItemId> ids;  ///< empty as long as the ids count up

  /// Adds the ids of the next `size` points, which count up from `first_id`.
  void add_ids(ItemId first_id, std::uint64_t size) {
    if (points.empty()) first = first_id;
    if (ids.empty() && first_id.value == first.value + points.size()) return;
    while (ids.size() < points.size()) ids.push_back({first.value + ids.size()});
    for (std::uint64_t i = 0; i < size; ++i) ids.push_back({first_id.value + i});
  }
  [[nodiscard]] ItemId id(std::size_t i) const { return ids.empty() ? ItemId{first.value + i} : ids[i]; }
  [[nodiscard]] std::optional<Error> insert_into(World& world, const BulkOptions& options) const {
    if (ids.empty()) {
      const Result<ItemId> done = world.insert_points(points, first, options);
      return done.ok() ? std::nullopt : std::optional(done.error());
    }
    const Result<void> done = world.insert_points_as(points, ids, options);
    return done.ok() ? std::nullopt : std::optional(done.error());
  }
};

namespace {

std::uint64_t fixed_at(const char* bytes, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return value;
}

Point point_at(const char* bytes) {
  return {base::bit_cast<double>(fixed_at(bytes, 8)), base::bit_cast<double>(fixed_at(bytes + 8, 8))};
}

/// The items of a file. As long as all items are points, only `points` contains them, which takes less memory.
struct LoadedItems {
  LoadedPoints points;
  std::vector<Item> items;

  /// Adds an item to `items`.
  void add(ItemId id, Shape shape) {
    if (!points.points.empty()) move_points();
    items.push_back({id, std::move(shape)});
  }
  /// Moves `points` to `items`.
  void move_points() {
    items.reserve(items.size() + points.points.size());
    for (std::size_t i = 0; i < points.points.size(); ++i) {
      items.push_back({points.id(i), Shape::point(points.points[i])});
    }
    points = {};
  }
};

/// Reads one world from a stream. Each function that returns bool returns false after it has stored an error in
/// `error_`.
class WorldReader {
 public:
  explicit WorldReader(std::istream& in) : in_(in) {}

  Result<World> read(const BulkOptions& options) {
    if (!read_header() || !read_items() || !read_checksum()) return std::move(error_);
    Result<World> world = World::create(domain_, options_);
    if (!world.ok()) return refused(world.error());
    if (!fill(*world, options)) return std::move(error_);
    return world;
  }

 private:
  bool read_header();
  bool read_options();
  bool read_items();
  bool read_run(std::uint64_t remaining);
  /// Reads the numbers of rings and of points of the run's items into `ring_counts_` and `point_counts_`.
  bool read_counts(std::uint64_t run_size, SavedKind kind);
  bool read_points_of_run(ItemId first, std::uint64_t run_size);
  bool read_shape(std::uint64_t item);
  bool read_checksum();
  bool fill(World& world, const BulkOptions& options);

  bool read_bytes(char* bytes, std::size_t size) {
    if (size > filled_ - used_) return read_more(bytes, size);
    std::memcpy(bytes, buffer_.data() + used_, size);
    used_ += size;
    offset_ += size;
    return true;
  }
  bool read_more(char* bytes, std::size_t size);
  /// Reads bytes from the stream. Returns how many it has read.
  std::size_t read_stream(char* bytes, std::size_t size);
  bool read_fixed(std::uint64_t& value, std::size_t size);
  bool read_varint(std::uint64_t& value);
  bool read_count(std::uint64_t& value);
  bool read_point(Point& point);
  /// Calls visit(point) for each of the next `count` points.
  template <class Visit>
  bool read_points(std::uint64_t count, Visit&& visit);

  /// Stores an error. Returns false.
  bool fail(ErrorCode code, std::string_view what) {
    std::string message = base::with_number("byte ", offset_, ": ");
    message += what;
    error_ = Error{.code = code, .words = std::move(message), .item = {}, .index = offset_};
    return false;
  }
  bool fail(std::string_view what) { return fail(ErrorCode::malformed, what); }
  /// Returns the error for a world that refuses the domain or an item of the file.
  static Error refused(const Error& error) {
    return {ErrorCode::malformed, "the saved world is not valid: " + error.message(), error.item, 0};
  }

  static constexpr std::size_t kPointSize = 16;

  std::istream& in_;
  std::uint64_t offset_ = 0;         ///< the number of bytes that the reader has used
  std::array<char, 4096> buffer_{};  ///< bytes from `used_` to `filled_` were read in advance
  std::size_t used_ = 0;
  std::size_t filled_ = 0;
  std::uint64_t unread_items_ = 0;  ///< the number of items whose points the reader has not begun
  io::Crc32c checksum_;
  Error error_;

  Box domain_;
  WorldOptions options_;
  std::uint64_t largest_id_seen_ = 0;
  std::uint64_t item_count_ = 0;
  ItemsHash hash_;
  std::uint64_t last_id_ = 0;
  LoadedItems items_;

  // Of a run: for each item the number of its rings, and for each ring the number of its points.
  Shape shape_;
  std::vector<std::uint64_t> ring_counts_;
  std::vector<std::uint64_t> point_counts_;
  std::size_t next_ring_ = 0;
};

std::size_t WorldReader::read_stream(char* bytes, std::size_t size) {
  in_.read(bytes, static_cast<std::streamsize>(size));
  const auto count = static_cast<std::size_t>(in_.gcount());
  checksum_.add({bytes, count});
  return count;
}

// To read one byte from a stream takes about as long as to read many. So the function reads bytes in advance, but never
// a byte after the items: each item that the reader has not begun takes 16 bytes or more.
bool WorldReader::read_more(char* bytes, std::size_t size) {
  const std::size_t kept = filled_ - used_;
  std::memcpy(bytes, buffer_.data() + used_, kept);
  used_ = filled_ = 0;
  const std::size_t missing = size - kept;
  std::size_t count = 0;
  if (missing >= buffer_.size()) {
    count = read_stream(bytes + kept, missing);
  } else {
    const auto sure = static_cast<std::size_t>(std::min<std::uint64_t>(unread_items_, buffer_.size() / kPointSize));
    filled_ = read_stream(buffer_.data(), std::max(missing, kPointSize * sure));
    count = used_ = std::min(missing, filled_);
    std::memcpy(bytes + kept, buffer_.data(), count);
  }
  offset_ += kept + count;
  if (count == missing) return true;
  if (in_.bad()) return fail(ErrorCode::unreadable, "the stream cannot be read any further");
  return fail("expected more bytes of the saved world, found the end");
}

bool WorldReader::read_fixed(std::uint64_t& value, std::size_t size) {
  std::array<char, 8> bytes{};
  if (!read_bytes(bytes.data(), size)) return false;
  value = fixed_at(bytes.data(), size);
  return true;
}

bool WorldReader::read_varint(std::uint64_t& value) {
  value = 0;
  for (unsigned shift = 0; shift < 64; shift += 7) {
    std::uint64_t byte = 0;
    if (!read_fixed(byte, 1)) return false;
    const std::uint64_t bits = byte & 0x7f;
    if (bits << shift >> shift != bits) return fail("a number is above 2^64 - 1");
    value |= bits << shift;
    if (byte != bits) continue;
    return bits != 0 || shift == 0 || fail("a number has more bytes than it needs");
  }
  return fail("a number has more than 10 bytes");
}

bool WorldReader::read_count(std::uint64_t& value) {
  if (!read_varint(value)) return false;
  return (value >= 1 && value <= kLargestCount) || fail("a number of points or rings is not from 1 to 2^27");
}

bool WorldReader::read_point(Point& point) {
  return read_points(1, [&](const Point& p) { point = p; });
}

// Reads in small pieces, so that a wrong count takes no memory.
template <class Visit>
bool WorldReader::read_points(std::uint64_t count, Visit&& visit) {
  std::array<char, 4096> bytes;  // NOLINT(cppcoreguidelines-pro-type-member-init): read_bytes fills it
  while (count > 0) {
    const auto piece = static_cast<std::size_t>(std::min<std::uint64_t>(count, bytes.size() / kPointSize));
    if (!read_bytes(bytes.data(), piece * kPointSize)) return false;
    for (std::size_t i = 0; i < piece; ++i) visit(point_at(bytes.data() + i * kPointSize));
    count -= piece;
  }
  return true;
}

bool WorldReader::read_header() {
  std::array<char, text::kSavedWorldMagic.size()> magic{};
  if (!in_.good()) return fail(ErrorCode::unreadable, "the stream cannot be read");
  if (!read_bytes(magic.data(), magic.size())) return false;
  if (std::string_view(magic.data(), magic.size()) != text::kSavedWorldMagic) {
    return fail("a saved world starts with 'WWORLD', and these bytes do not");
  }
  std::uint64_t version = 0;
  if (!read_fixed(version, 2)) return false;
  if (version != kSavedWorldVersion) {
    const std::string what = base::with_number("the saved world has version ", version, " of the format");
    return fail(ErrorCode::not_supported, what + "; this version of Waywright reads version 1");
  }
  return read_point(domain_.min) && read_point(domain_.max) && read_options() && read_fixed(largest_id_seen_, 8) &&
         read_fixed(item_count_, 8) && read_fixed(hash_.words[0], 8) && read_fixed(hash_.words[1], 8);
}

bool WorldReader::read_options() {
  std::uint64_t bits = 0;
  if (!read_fixed(bits, 4)) return false;
  if (bits > (kKeepsAbstraction | kKeepsBridges)) return fail("the options have an unknown bit");
  options_.keep_abstraction = (bits & kKeepsAbstraction) != 0;
  options_.keep_bridges = (bits & kKeepsBridges) != 0;
  return true;
}

bool WorldReader::read_items() {
  if (largest_id_seen_ > ItemId::kLargest) return fail("the largest id is above 2^63 - 1");
  unread_items_ = item_count_;
  while (unread_items_ > 0) {
    if (!read_run(unread_items_)) return false;
  }
  return true;
}

bool WorldReader::read_run(std::uint64_t remaining) {
  std::uint64_t id_step = 0;
  std::uint64_t size_and_kind = 0;
  if (!read_varint(id_step) || !read_varint(size_and_kind)) return false;
  const std::uint64_t size = size_and_kind >> kKindBits;
  const std::uint64_t kind = size_and_kind & ((1U << kKindBits) - 1);
  if (size < 1 || size > kLargestRun) return fail("the number of items of a run is not from 1 to 4096");
  if (size > remaining) return fail("a run has more items than are left");
  if (kind >= kSavedKindCount) return fail("an item has an unknown kind");
  if (id_step < 1) return fail("the ids do not ascend");
  const std::uint64_t ids_left = largest_id_seen_ - last_id_;
  if (id_step > ids_left || size - 1 > ids_left - id_step) return fail("an id is above the largest id");
  const ItemId first{last_id_ + id_step};
  last_id_ = first.value + (size - 1);
  return read_counts(size, static_cast<SavedKind>(kind)) && read_points_of_run(first, size);
}

bool WorldReader::read_counts(std::uint64_t run_size, SavedKind kind) {
  constexpr std::array kKinds{ItemKind::point, ItemKind::segment, ItemKind::polyline, ItemKind::polygon,
                              ItemKind::polygon};
  shape_.kind = kKinds[static_cast<std::size_t>(kind)];
  shape_.fill = kind == SavedKind::nonzero_polygon ? FillRule::nonzero : FillRule::even_odd;
  ring_counts_.clear();
  point_counts_.clear();
  next_ring_ = 0;
  if (shape_.kind == ItemKind::point || shape_.kind == ItemKind::segment) return true;
  for (std::uint64_t item = 0; item < run_size; ++item) {
    std::uint64_t rings = 1;
    if (shape_.kind == ItemKind::polygon && !read_count(rings)) return false;
    ring_counts_.push_back(rings);
    for (std::uint64_t ring = 0; ring < rings; ++ring) {
      std::uint64_t points = 0;
      if (!read_count(points)) return false;
      point_counts_.push_back(points);
    }
  }
  return true;
}

bool WorldReader::read_points_of_run(ItemId first, std::uint64_t run_size) {
  if (shape_.kind == ItemKind::point && items_.items.empty()) {
    unread_items_ -= run_size;
    std::vector<Point>& points = items_.points.points;
    items_.points.add_ids(first, run_size);
    return read_points(run_size, [&](const Point& p) { points.push_back(p); });
  }
  for (std::uint64_t item = 0; item < run_size; ++item) {
    --unread_items_;
    if (!read_shape(item)) return false;
    items_.add({first.value + item}, std::move(shape_));
  }
  return true;
}

/// Reads the points of an item of the run into `shape_`.
bool WorldReader::read_shape(std::uint64_t item) {
  const auto add_point = [&](const Point& p) { shape_.rings.add_point(p); };
  shape_.rings = {};
  if (ring_counts_.empty()) {
    const std::uint64_t count = shape_.kind == ItemKind::point ? 1 : 2;
    shape_.rings.reserve(static_cast<std::size_t>(count));
    shape_.rings.start_ring();
    return read_points(count, add_point);
  }
  for (std::uint64_t ring = 0; ring < ring_counts_[static_cast<std::size_t>(item)]; ++ring) {
    const std::uint64_t count = point_counts_[next_ring_++];
    if (ring == 0) shape_.rings.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(count, 64)));
    shape_.rings.start_ring();
    if (!read_points(count, add_point)) return false;
  }
  return true;
}

bool WorldReader::read_checksum() {
  const std::uint64_t expected = checksum_.value();
  std::uint64_t found = 0;
  if (!read_fixed(found, 4)) return false;
  return found == expected || fail("the checksum is wrong: the saved world was altered after it was written");
}

bool WorldReader::fill(World& world, const BulkOptions& options) {
  std::optional<Error> error;
  if (!items_.points.points.empty()) {
    error = items_.points.insert_into(world, options);
  } else if (!items_.items.empty()) {
    const Result<std::vector<ItemId>> done = world.insert_all(items_.items, options);
    if (!done.ok()) error = done.error();
  }
  if (error) {
    error_ = refused(*error);
    return false;
  }
  if (largest_id_seen_ > 0 && !world.reserve_ids({largest_id_seen_}).ok()) return fail("the largest id is not valid");
  return world.items_hash() == hash_ || fail("the hash of the items is wrong: the saved world was altered");
}

}  // namespace

Result<World> load_world(std::istream& in, const BulkOptions& options) { return WorldReader(in).read(options); }

}  // namespace waywright
