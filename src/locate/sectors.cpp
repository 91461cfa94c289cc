#include "locate/sectors.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace waywright::locate {

namespace {

/// Makes room for `count` elements more. The capacity grows by a factor, as for push_back().
template <class Value>
void make_room(memory::Array<Value>& list, std::size_t count) {
  if (list.capacity() - list.size() < count) list.reserve(std::max(2 * list.capacity(), list.size() + count));
}

}  // namespace

// After make_room(), no step allocates. So if memory runs out, the array keeps its size.
void CompactArray::append(std::size_t count, std::uint32_t value) {
  if (blocks_.empty()) {
    values_.resize(size_ + count, value);
    size_ += count;
    return;
  }
  const std::size_t new_blocks = (count + kBlockSize - 1) / kBlockSize;
  make_room(blocks_, new_blocks);
  make_room(wide_, new_blocks + 1);
  for (; count > 0; --count) {
    if (size_ % kBlockSize == 0) blocks_.push_back({value & ~kWide, {}});
    ++size_;
    set_in_block(size_ - 1, value);
  }
}

void CompactArray::truncate(std::size_t size) {
  if (!blocks_.empty()) unpack();
  values_.resize(size);
  size_ = size;
}

void CompactArray::pack() {
  if (values_.empty()) return;
  CompactArray packed;
  packed.size_ = size_;
  packed.blocks_.reserve((size_ + kBlockSize - 1) / kBlockSize);
  for (std::size_t i = 0; i < size_; i += kBlockSize) {
    packed.add_block(&values_[i], std::min(kBlockSize, size_ - i));
    if (packed.is_smaller_if_plain()) return;
  }
  *this = std::move(packed);
}

void CompactArray::add_block(const std::uint32_t* values, std::size_t count) {
  const auto [least, largest] = std::minmax_element(values, values + count);
  if (*largest < kWide && *largest - *least <= kLargestDifference) {
    Block block{*least, {}};
    for (std::size_t i = 0; i < count; ++i) block.differences[i] = static_cast<std::uint8_t>(values[i] - *least);
    blocks_.push_back(block);
  } else {
    WideBlock wide{};
    std::copy(values, values + count, wide.begin());
    wide_.push_back(wide);
    blocks_.push_back({kWide | static_cast<std::uint32_t>(wide_.size() - 1), {}});
  }
}

void CompactArray::set_in_block(std::size_t i, std::uint32_t value) {
  Block& block = blocks_[i / kBlockSize];
  if ((block.base & kWide) == 0) {
    const std::uint32_t difference = value - block.base;  // very large if `value` is less than the base
    if (value < kWide && difference <= kLargestDifference) {
      block.differences[i % kBlockSize] = static_cast<std::uint8_t>(difference);
      return;
    }
    WideBlock wide;
    for (std::size_t k = 0; k < kBlockSize; ++k) wide[k] = block.base + block.differences[k];
    wide_.push_back(wide);
    block.base = kWide | static_cast<std::uint32_t>(wide_.size() - 1);
  }
  wide_[block.base & ~kWide][i % kBlockSize] = value;
}

void CompactArray::shrink_to_fit() {
  if (!blocks_.empty() && is_smaller_if_plain()) unpack();
  shrink(values_, blocks_, wide_);
}

void CompactArray::unpack() {
  memory::Array<std::uint32_t> values;
  values.reserve(size_);
  for (std::size_t i = 0; i < size_; i += kBlockSize) {
    for_each(i, std::min(kBlockSize, size_ - i), [&](std::uint32_t value) { values.push_back(value); });
  }
  *this = CompactArray(std::move(values));
}

namespace {

/// Returns the end of the elements from `begin` on for which `is_in` returns true.
template <class Elements, class IsIn>
std::size_t end_of_range(const Elements& elements, std::size_t begin, IsIn&& is_in) {
  while (begin < elements.size() && is_in(elements[begin])) ++begin;
  return begin;
}

}  // namespace

/// The sector of a point in a zoomed sector, or in a zoom within this zoom, and so on.
Sectors::Sector Sectors::find_in_zoom(const Point& point, Content zoomed) const {
  for (;;) {
    const std::uint32_t i = zoomed & ~(kDivided | kZoomed);
    const Curve::Key key = zooms_[i].curve.nearest_key(point);
    constexpr int kShift = kKeyBits - 2;
    const Sector sector = find_quarter(key, zooms_[i].first + static_cast<std::size_t>(key >> kShift), kShift, i);
    if (!is_zoomed(sector.content)) return sector;
    zoomed = sector.content;
  }
}

void Sectors::remember(const Point& point, mesh::Vertex v, std::size_t vertex_count) {
  if (vertex_count > kVerticesPerSector * top_count()) grow();
  sectors_.set(at(point).index, number(v));
}

void Sectors::replace(const Point& point, mesh::Vertex v, mesh::Vertex other) {
  const Sector sector = at(point);
  if (sector.content == number(v)) sectors_.set(sector.index, number(other));
}

// A sector stays divided after most of its vertices have been removed. If there are many more quarters than vertices,
// most divided sectors are no longer crowded. Then this function first removes all quarters and zooms; later calls
// divide the sectors that are still crowded.
void Sectors::divide(const Point& point, std::size_t vertex_count) {
  const std::size_t quarters = sectors_.size() - top_count();
  if (quarters > 4 * vertex_count + top_count()) {
    for (std::size_t i = 0; i < top_count(); ++i) sectors_.set(i, any_vertex(sectors_[i]));
    sectors_.truncate(top_count());
    zooms_.clear();
  }
  const Sector sector = at(point);
  if (sector.shift == 0) return add_zoom(point, sector);
  const auto first = static_cast<Content>(sectors_.size());
  sectors_.append(4, sector.content);
  sectors_.set(sector.index, first | kDivided);
}

void Sectors::add_zoom(const Point& point, const Sector& sector) {
  const std::uint32_t depth = sector.zoom == kNoZoom ? 0 : zooms_[sector.zoom].depth + 1;
  if (depth > kMaxDepth) return;
  const Curve& curve = sector.zoom == kNoZoom ? curve_ : zooms_[sector.zoom].curve;
  const Box box = curve.box_of(curve.nearest_key(point));
  if (!(box.min.x < box.max.x && box.min.y < box.max.y)) return;
  const auto index = static_cast<Content>(zooms_.size());
  zooms_.push_back({Curve(box), static_cast<std::uint32_t>(sectors_.size()), depth});
  const Content content = sectors_[sector.index];
  sectors_.append(4, content);
  sectors_.set(sector.index, index | kDivided | kZoomed);
}

Sectors::Content Sectors::any_vertex(Content content) const {
  while ((content & kDivided) != 0)
    content = sectors_[is_zoomed(content) ? zoom_of(content).first : content & ~kDivided];
  return content;
}

// Replaces every top sector by four: by its quarters if it is divided, otherwise by four sectors that remember the
// same vertex.
void Sectors::grow() {
  memory::Array<Content> finer;
  finer.reserve(4 * sectors_.size());
  const std::size_t count = top_count();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      finer.push_back(is_divided(sectors_[i]) ? sectors_[(sectors_[i] & ~kDivided) + quarter] : sectors_[i]);
    }
  }
  // After the new top sectors come the quarters of the divided ones. The loop also visits the entries that it
  // appends.
  for (std::size_t i = 0; i < finer.size(); ++i) {
    if ((finer[i] & kDivided) == 0) continue;
    std::size_t old = finer[i] & ~kDivided;
    if (is_zoomed(finer[i])) {
      Zoom& zoom = zooms_[finer[i] & ~(kDivided | kZoomed)];
      old = zoom.first;
      zoom.first = static_cast<std::uint32_t>(finer.size());
    } else {
      finer[i] = static_cast<Content>(finer.size()) | kDivided;
    }
    for (std::size_t quarter = 0; quarter < 4; ++quarter) finer.push_back(sectors_[old + quarter]);
  }
  sectors_ = CompactArray(std::move(finer));
  top_shift_ -= 2;
}

void Sectors::fill(std::span<const Point> points, std::span<const Curve::Key> keys, std::uint32_t first) {
  int shift = kKeyBits - 2;
  while (shift > 2 && keys.size() > kVerticesPerSector << (kKeyBits - shift)) shift -= 2;
  top_shift_ = shift;
  sectors_ = CompactArray(memory::Array<Content>(top_count(), kNone));
  zooms_.clear();
  std::size_t begin = 0;
  for (std::size_t i = 0; i < top_count(); ++i) {
    const std::size_t end = end_of_range(keys, begin, [&](Curve::Key key) { return key >> shift == i; });
    const std::size_t count = end - begin;
    const auto first_here = first + static_cast<std::uint32_t>(begin);
    fill_sector(i, shift, points.subspan(begin, count), keys.subspan(begin, count), first_here);
    begin = end;
  }
  sectors_.pack();
}

// An empty sector remembers the last vertex before it along the curve.
void Sectors::fill_sector(std::size_t index, int shift, std::span<const Point> points, std::span<const Curve::Key> keys,
                          std::uint32_t first) {
  if (keys.size() <= kCrowd || shift == 0) {
    sectors_.set(index, first + static_cast<Content>(keys.size() / 2) - (keys.empty() ? 1 : 0));
    if (keys.size() <= kCrowd) return;
    std::vector<Entry> entries(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) entries[i].vertex = first + static_cast<std::uint32_t>(i);
    return fill_zoom({index, shift, kNoZoom, sectors_[index]}, points, first, entries);
  }
  const std::size_t quarters = sectors_.size();
  sectors_.append(4, kNone);
  sectors_.set(index, static_cast<Content>(quarters) | kDivided);
  std::size_t begin = 0;
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const std::size_t end =
        end_of_range(keys, begin, [&](Curve::Key key) { return (key >> (shift - 2) & 3) == quarter; });
    const std::size_t count = end - begin;
    const auto first_here = first + static_cast<std::uint32_t>(begin);
    fill_sector(quarters + quarter, shift - 2, points.subspan(begin, count), keys.subspan(begin, count), first_here);
    begin = end;
  }
}

/// Gives a crowded square of a curve a zoom, and divides the sectors of the zoom. `points` are the positions of the
/// vertices from `first`; `entries` are the vertices in the square, without keys.
void Sectors::fill_zoom(const Sector& sector, std::span<const Point> points, std::uint32_t first,
                        std::span<Entry> entries) {
  const std::size_t zooms = zooms_.size();
  add_zoom(points[entries.front().vertex - first], sector);
  if (zooms_.size() == zooms) return;  // the square is as small as doubles allow
  const std::size_t quarters = zooms_.back().first;
  const Curve curve = zooms_.back().curve;
  for (Entry& entry : entries) entry.key = curve.nearest_key(points[entry.vertex - first]);
  const auto comes_before = [](const Entry& p, const Entry& q) {
    return p.key != q.key ? p.key < q.key : p.vertex < q.vertex;
  };
  std::sort(entries.begin(), entries.end(), comes_before);
  constexpr int kShift = kKeyBits - 2;
  std::size_t begin = 0;
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const std::size_t end =
        end_of_range(entries, begin, [&](const Entry& entry) { return entry.key >> kShift == quarter; });
    fill_quarter({quarters + quarter, kShift, static_cast<std::uint32_t>(zooms), kNone}, points, first,
                 entries.subspan(begin, end - begin));
    begin = end;
  }
}

/// Fills a sector of a zoom. `entries` are the vertices in the sector. Divides the sector if it is crowded. If it has
/// no vertices, it keeps the vertex of the sector around it.
void Sectors::fill_quarter(const Sector& sector, std::span<const Point> points, std::uint32_t first,
                           std::span<Entry> entries) {
  if (entries.empty()) return;
  sectors_.set(sector.index, entries[entries.size() / 2].vertex);
  if (entries.size() <= kCrowd) return;
  if (sector.shift == 0) return fill_zoom(sector, points, first, entries);
  const std::size_t quarters = sectors_.size();
  sectors_.append(4, sectors_[sector.index]);
  sectors_.set(sector.index, static_cast<Content>(quarters) | kDivided);
  const int shift = sector.shift - 2;
  std::size_t begin = 0;
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const std::size_t end =
        end_of_range(entries, begin, [&](const Entry& entry) { return (entry.key >> shift & 3) == quarter; });
    fill_quarter({quarters + quarter, shift, sector.zoom, kNone}, points, first, entries.subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace waywright::locate
