#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "base/compiler.hpp"
#include "locate/curve.hpp"
#include "memory/array.hpp"
#include "memory/count.hpp"
#include "mesh/index.hpp"

namespace waywright::locate {

/// An array of 32-bit numbers. pack() stores the array in a third of the memory if the numbers of each block of 16
/// differ by at most 255. For each block, the array then stores the smallest number in 32 bits and, for each of the 16
/// numbers, the difference from the smallest one in 8 bits. If the numbers of a block differ by more, the block is
/// *wide*: it contains the index of an array of 16 numbers of 32 bits. The same functions change a packed array and a
/// plain one. If so many blocks become wide that the packed array takes more memory than a plain one
/// (at most 84 bytes instead of 64 for 16 numbers), shrink_to_fit() makes it plain again.
class CompactArray {
 public:
  CompactArray() = default;
  /// A plain array of these numbers.
  explicit CompactArray(memory::Array<std::uint32_t>&& values) : values_(std::move(values)), size_(values_.size()) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint32_t operator[](std::size_t i) const {
    if (blocks_.empty()) return values_[i];
    const Block& block = blocks_[i / kBlockSize];
    if ((block.base & kWide) != 0) return wide_[block.base & ~kWide][i % kBlockSize];
    return block.base + block.differences[i % kBlockSize];
  }
  /// Calls visit(number) for `count` numbers from index `i` on. Requires: the numbers lie in one block of 16, which
  /// starts at a multiple of 16.
  template <class Visit>
  void for_each(std::size_t i, std::size_t count, Visit&& visit) const {
    const Block* const block = blocks_.empty() ? nullptr : &blocks_[i / kBlockSize];
    if (block != nullptr && (block->base & kWide) == 0) {
      for (std::size_t k = i % kBlockSize; count > 0; ++k, --count) visit(block->base + block->differences[k]);
    } else {
      for (const std::size_t end = i + count; i < end; ++i) visit((*this)[i]);
    }
  }
  /// Prefetches the memory that operator[] reads.
  WAYWRIGHT_ALWAYS_INLINE void prefetch(std::size_t i) const {
    if (blocks_.empty()) {
      base::prefetch(&values_[i]);
    } else {
      base::prefetch(&blocks_[i / kBlockSize]);
    }
  }

  /// If memory runs out, the array does not change. Cost: O(1), amortised.
  void set(std::size_t i, std::uint32_t value) {
    if (blocks_.empty()) {
      values_[i] = value;
    } else {
      set_in_block(i, value);
    }
  }
  /// Adds `count` copies of a number at the end. If memory runs out, the array does not change. Cost: O(count),
  /// amortised.
  void append(std::size_t count, std::uint32_t value);
  /// Removes the numbers from index `size` on. The array is plain afterwards. Cost: linear.
  void truncate(std::size_t size);

  /// Packs the array, if this saves memory. Requires: the array is plain. Cost: linear.
  void pack();

  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const {
    count(use, part, values_);
    count(use, part, blocks_);
    count(use, part, wide_);
  }
  /// Frees spare memory. Cost: linear.
  void shrink_to_fit();

 private:
  static constexpr std::size_t kBlockSize = 16;
  static constexpr std::uint32_t kWide = 0x80000000;
  static constexpr std::uint32_t kLargestDifference = 255;

  using WideBlock = std::array<std::uint32_t, kBlockSize>;
  /// The number `i` of the block is base + differences[i]. If `base` contains the bit kWide, the other bits are the
  /// index of a wide block instead.
  struct Block {
    std::uint32_t base;
    std::array<std::uint8_t, kBlockSize> differences;
  };

  void set_in_block(std::size_t i, std::uint32_t value);
  void add_block(const std::uint32_t* values, std::size_t count);
  void unpack();
  [[nodiscard]] bool is_smaller_if_plain() const {
    return blocks_.size() * sizeof(Block) + wide_.size() * sizeof(WideBlock) > size_ * sizeof(std::uint32_t);
  }

  memory::Array<std::uint32_t> values_;  ///< empty if the array is packed
  memory::Array<Block> blocks_;          ///< empty if the array is plain
  memory::Array<WideBlock> wide_;
  std::size_t size_ = 0;
};

/// Finds vertices from which a walk can start. The domain consists of square sectors, and each sector remembers a
/// vertex in it or near it. Queries only read the sectors. A remembered vertex is only a hint, because it may have been
/// removed in the meantime.
///
/// The number of sectors grows with the number of vertices, so on evenly distributed vertices a walk is short in a
/// world of any size. These sectors are equal squares, the *top sectors*. If a sector contains many vertices, an
/// operation divides it into four quarters, and may later divide these again. So walks are short on unevenly
/// distributed vertices, too. If a sector is as small as a square of the curve's grid (see Curve), it gets a finer
/// curve of its own (a *zoom*). The division depends on the history of the world, but the result of a search does not.
///
/// Source: Chen 2009, section 3.2.1 (sector-based location). Differences: only operations write to the sectors, queries
/// do not; and the number of sectors is not constant.
class Sectors {
 public:
  explicit Sectors(const Box& domain) : curve_(domain), sectors_(memory::Array<Content>(4, kNone)) {}

  struct Sector {
    std::size_t index;
    int shift;              ///< two keys are in one sector if they differ only in their lowest `shift` bits
    std::uint32_t zoom;     ///< the zoom to whose curve these keys belong, or kNoZoom
    std::uint32_t content;  ///< see Content
  };
  [[nodiscard]] WAYWRIGHT_ALWAYS_INLINE Sector at(const Point& point) const {
    const Sector sector = find(curve_.key(point));
    return is_zoomed(sector.content) ? find_in_zoom(point, sector.content) : sector;
  }
  /// The vertex that the sector remembers, or kNoVertex.
  [[nodiscard]] mesh::Vertex near(const Sector& sector) const { return vertex_of(sector.content); }
  /// Whether a vertex at this squared distance from a point is far away, compared with the size of the point's sector.
  /// If it is, a sector near the point's sector may remember a nearer vertex.
  [[nodiscard]] bool is_far(const Sector& sector, double squared_distance) const {
    const Curve& curve = sector.zoom == kNoZoom ? curve_ : zooms_[sector.zoom].curve;
    return curve.in_squared_widths(squared_distance) > kFar * static_cast<double>(Curve::Key{1} << sector.shift);
  }
  /// For each sector in the block of this sector, calls visit(vertex) for at most one vertex that the sector, or a part
  /// of it, remembers. The block of a top sector is a square of 4 x 4 top sectors, and the block of a quarter is
  /// its group of four quarters.
  template <class Visit>
  void for_each_around(const Sector& sector, Visit&& visit) const {
    const bool is_top = sector.zoom == kNoZoom && sector.shift == top_shift_;
    const std::size_t count = is_top ? std::min(kBlock, top_count()) : 4;
    sectors_.for_each(sector.index & ~(count - 1), count, [&](Content content) {
      const mesh::Vertex v = vertex_of(any_vertex(content));
      if (v != mesh::kNoVertex) visit(v);
    });
  }
  /// Whether both points lie in one sector.
  [[nodiscard]] bool are_in_one(const Point& p, const Point& q) const { return at(p).index == at(q).index; }

  /// Makes all sectors anew, for vertices that are sorted along the curve: `points` and `keys` are the positions and
  /// the keys of the vertices `first`, `first` + 1, and so on. Cost: linear, plus n log n for n vertices in crowded
  /// squares of the curve.
  void fill(std::span<const Point> points, std::span<const Curve::Key> keys, std::uint32_t first);
  /// The sector of `point` then remembers `v`, which lies at that point. `vertex_count` is the number of vertices in
  /// the world. Cost: O(1), amortised.
  void remember(const Point& point, mesh::Vertex v, std::size_t vertex_count);
  /// Prefetches the memory that says which vertex the sector of `point` remembers.
  WAYWRIGHT_ALWAYS_INLINE void prefetch(const Point& point) const {
    sectors_.prefetch(static_cast<std::size_t>(curve_.key(point) >> top_shift_));
  }
  /// Call it when an operation removes the vertex `v` at `point`. If the sector of `point` remembers `v`, it then
  /// remembers `other`.
  void replace(const Point& point, mesh::Vertex v, mesh::Vertex other);
  /// Divides the sector of `point` into four quarters. `vertex_count` is the number of vertices in the world. Cost:
  /// O(1), amortised.
  void divide(const Point& point, std::size_t vertex_count);

  void count_memory(MemoryUse& use) const {
    sectors_.count_memory(use, &MemoryUse::sectors);
    memory::count(use, &MemoryUse::sectors, zooms_);
  }
  void shrink_to_fit() {
    sectors_.shrink_to_fit();
    memory::shrink(zooms_);
  }

 private:
  /// The content of a sector: the vertex that it remembers. If kDivided is set: the index of the first of its four
  /// quarters, which are in the order of the curve. If kZoomed is set, too: the index of the sector's zoom.
  using Content = std::uint32_t;
  static constexpr Content kDivided = 0x80000000;
  static constexpr Content kZoomed = 0x40000000;
  static constexpr Content kNone = 0x7fffffff;
  static constexpr std::size_t kVerticesPerSector = 3;
  static constexpr std::size_t kCrowd = 8;  ///< fill() divides a sector with more vertices than this
  static constexpr std::size_t kBlock = 16;
  static constexpr double kFar = 9.0;  ///< squared: three times the width of the sector
  static constexpr int kKeyBits = 64;
  static constexpr std::uint32_t kNoZoom = 0xffffffff;
  static constexpr std::uint32_t kMaxDepth = 12;  ///< of a zoom: see Zoom::depth

  /// The curve of a sector that is as small as a square of the grid, and the index of the first of the sector's four
  /// quarters. The width of the squares of this curve's grid is 2^-32 of the width of the sector.
  struct Zoom {
    Curve curve;
    std::uint32_t first;
    std::uint32_t depth;  ///< the number of zooms that contain this one
  };

  [[nodiscard]] static bool is_divided(Content content) { return (content & (kDivided | kZoomed)) == kDivided; }
  [[nodiscard]] static bool is_zoomed(Content content) { return content >= (kDivided | kZoomed); }
  [[nodiscard]] const Zoom& zoom_of(Content content) const { return zooms_[content & ~(kDivided | kZoomed)]; }

  [[nodiscard]] Sector find(Curve::Key key) const {
    return find_quarter(key, static_cast<std::size_t>(key >> top_shift_), top_shift_, kNoZoom);
  }
  [[nodiscard]] Sector find_quarter(Curve::Key key, std::size_t index, int shift, std::uint32_t zoom) const {
    Content content = sectors_[index];
    while (is_divided(content)) {
      shift -= 2;
      index = (content & ~kDivided) + static_cast<std::size_t>(key >> shift & 3);
      content = sectors_[index];
    }
    return {index, shift, zoom, content};
  }
  [[nodiscard]] Sector find_in_zoom(const Point& point, Content zoomed) const;
  void add_zoom(const Point& point, const Sector& sector);
  [[nodiscard]] std::size_t top_count() const { return std::size_t{1} << (kKeyBits - top_shift_); }
  [[nodiscard]] static mesh::Vertex vertex_of(Content content) {
    return content == kNone ? mesh::kNoVertex : mesh::Vertex{content};
  }
  [[nodiscard]] Content any_vertex(Content content) const;
  void grow();
  /// A point of a crowded square: its vertex, and its key on the curve of a zoom.
  struct Entry {
    Curve::Key key;
    std::uint32_t vertex;
  };
  void fill_sector(std::size_t index, int shift, std::span<const Point> points, std::span<const Curve::Key> keys,
                   std::uint32_t first);
  void fill_zoom(const Sector& sector, std::span<const Point> points, std::uint32_t first, std::span<Entry> entries);
  void fill_quarter(const Sector& sector, std::span<const Point> points, std::uint32_t first, std::span<Entry> entries);

  Curve curve_;
  int top_shift_ = kKeyBits - 2;
  std::vector<Zoom> zooms_;
  CompactArray sectors_;  ///< the top sectors along the curve, then groups of four quarters at multiples of 4
};

}  // namespace waywright::locate
