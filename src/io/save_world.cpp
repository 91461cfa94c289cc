#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/save.hpp"

#include "base/bit_cast.hpp"
#include "io/crc32c.hpp"
#include "io/saved_world.hpp"

namespace waywright {
namespace {

using io::SavedKind;

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
    bytes_ += io::kSavedWorldMagic;
    append_fixed(bytes_, io::kSavedWorldVersion, 2);
    append_point(bytes_, world.domain().min);
    append_point(bytes_, world.domain().max);
    append_fixed(
        bytes_, (options.keep_abstraction ? io::kKeepsAbstraction : 0) | (options.keep_bridges ? io::kKeepsBridges : 0),
        4);
    append_fixed(bytes_, world.largest_id_seen().value, 8);
    append_fixed(bytes_, world.item_count(), 8);
    for (const std::uint64_t word : world.items_hash().words) append_fixed(bytes_, word, 8);
  }

  /// Adds the item with the shape `shape_` to the run, or to a new run if it does not belong to this one.
  void add_item(ItemId id) {
    const SavedKind kind = kind_of(shape_);
    const bool continues = run_size_ > 0 && run_size_ < io::kLargestRun && id.value == last_id_ + 1 && kind == kind_;
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
    append_varint(bytes_, run_size_ << io::kKindBits | static_cast<std::uint64_t>(kind_));
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

}  // namespace waywright
