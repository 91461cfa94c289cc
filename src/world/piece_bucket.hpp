#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "world/float_table.hpp"

namespace waywright {

/// Where a straight piece lies in its bounding box: on which diagonal. `none` if it may be anywhere in the box.
enum class Diagonal : std::uint8_t { none, rising, falling };

/// One box of a piece of a path. A piece is a segment or an arc. A long segment has several boxes.
struct Piece {
  std::uint32_t slot;   ///< of the path
  std::uint32_t index;  ///< of the segment or arc in the path
  Diagonal diagonal;
};

/// The entries of a node of BoxTree: pieces of paths with their bounding boxes. for_each_overlapping() calls
/// visit(piece, its bounding box) for each piece that may meet a given box. It first tests floats: see FloatTable.
class PieceBucket {
 public:
  using Value = Piece;
  using Handle = std::uint32_t;

  explicit PieceBucket(const Box& domain) : frame_(domain) {}

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] Handle handle(std::size_t i) const { return entries_[i].handle; }

  /// Adds a piece. If it has a diagonal, the box lies in the domain, apart from rounding errors. If memory runs out,
  /// nothing changes.
  void add(const Box& box, const Piece& piece, Handle handle) {
    floats_.make_room();
    entries_.push_back({box, piece, handle});
    floats_.add(row_of(box, piece.diagonal));
  }
  /// Removes the entry `i`. The last entry takes its place.
  void remove(std::size_t i) {
    floats_.remove(i);
    entries_[i] = entries_.back();
    entries_.pop_back();
  }

  /// Calls visit(piece, its box) for each piece whose box overlaps the given box. Leaves out most pieces whose diagonal
  /// misses the given box, but none whose diagonal is less than rounding errors (FloatFrame::slack()) away.
  template <class Visit>
  void for_each_overlapping(const Box& box, const Visit& visit) const {
    const Floats::Row given = row_of(box, Diagonal::rising);
    const float x = given[kX];
    const float y = given[kY];
    const float width = given[kWidth] + static_cast<float>(FloatFrame::kError);
    const float height = given[kHeight] + static_cast<float>(FloatFrame::kError);
    for (std::size_t i = 0; i < floats_.block_count(); ++i) {
      const Floats::Block& block = floats_.block(i);
      Floats::LaneSet apart = 0;
      for (std::size_t lane = 0; lane < Floats::kLanes; ++lane) {
        // Two boxes overlap if their centres are near enough in both axes. The diagonal meets the given box if they
        // are near enough in the direction perpendicular to it, too.
        const float dx = block[kX][lane] - x;
        const float dy = block[kY][lane] - y;
        const float along_x = block[kWidth][lane];
        const float along_y = block[kHeight][lane];
        const float high = std::abs(along_y);
        apart |= Floats::lane_if_negative(lane, along_x + width - std::abs(dx)) |
                 Floats::lane_if_negative(lane, high + height - std::abs(dy)) |
                 Floats::lane_if_negative(lane, along_x * height + high * width + block[kSlack][lane] -
                                                    std::abs(along_x * dy - along_y * dx));
      }
      Floats::for_each_lane(floats_.used_lanes(i) & ~apart, [&](std::size_t lane) {
        const Entry& entry = entries_[i * Floats::kLanes + lane];
        if (entry.box.overlaps(box)) visit(entry.piece, entry.box);
      });
    }
  }

 private:
  /// The floats of a piece: the centre of its box, half the width and half the height of the box, and a bound of the
  /// rounding errors of the test of the diagonal. The height is negative if the diagonal falls.
  enum Field : std::uint8_t { kX, kY, kWidth, kHeight, kSlack, kFieldCount };
  using Floats = FloatTable<kFieldCount>;

  struct Entry {
    Box box;
    Piece piece;
    Handle handle;
  };

  [[nodiscard]] Floats::Row row_of(const Box& box, Diagonal diagonal) const {
    constexpr double kTiny = 0x1p-40;
    constexpr float kEnough = 0x1p40F;
    const Box relative = frame_.relative(box);
    const Point middle = 0.5 * (relative.min + relative.max);
    const Point half = 0.5 * (relative.max - relative.min);
    const auto slack = static_cast<float>((half.x + half.y) * frame_.slack() + kTiny);
    return {static_cast<float>(middle.x), static_cast<float>(middle.y), static_cast<float>(half.x),
            static_cast<float>(diagonal == Diagonal::falling ? -half.y : half.y),
            diagonal == Diagonal::none ? kEnough : slack};
  }

  FloatFrame frame_;
  Floats floats_;
  std::vector<Entry> entries_;
};

}  // namespace waywright
