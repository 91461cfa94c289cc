#include "locate/sectors.hpp"

#include <algorithm>
#include <utility>

namespace waywright::locate {

/// The sector of a point in a zoomed sector, or in a zoom within this zoom, and so on.
Sectors::Sector Sectors::find_in_zoom(const Point& point, std::size_t index) const {
  for (;;) {
    const std::uint32_t i = sectors_[index] & ~(kDivided | kZoomed);
    const Curve::Key key = zooms_[i].curve.nearest_key(point);
    constexpr int kShift = kKeyBits - 2;
    const Sector sector = find_quarter(key, zooms_[i].first + static_cast<std::size_t>(key >> kShift), kShift, i);
    if (!is_zoomed(sectors_[sector.index])) return sector;
    index = sector.index;
  }
}

void Sectors::remember(const Point& point, mesh::Vertex v, std::size_t vertex_count) {
  if (vertex_count > kVerticesPerSector * whole_count()) grow();
  sectors_[at(point).index] = number(v);
}

void Sectors::replace(const Point& point, mesh::Vertex v, mesh::Vertex other) {
  Cell& cell = sectors_[at(point).index];
  if (cell == number(v)) cell = number(other);
}

// A sector stays divided after most of its vertices have been removed. If there are many more quarters than vertices,
// most divided sectors are no longer crowded. Then this function first makes all sectors whole again; later calls
// divide the sectors that are still crowded.
void Sectors::divide(const Point& point, std::size_t vertex_count) {
  const std::size_t quarters = sectors_.size() - whole_count();
  if (quarters > 4 * vertex_count + whole_count()) {
    for (std::size_t i = 0; i < whole_count(); ++i) sectors_[i] = any_vertex(sectors_[i]);
    sectors_.resize(whole_count());
    zooms_.clear();
  }
  const Sector sector = at(point);
  if (sector.shift == 0) return add_zoom(point, sector);
  const Cell cell = sectors_[sector.index];
  const auto first = static_cast<Cell>(sectors_.size());
  sectors_.insert(sectors_.end(), 4, cell);
  sectors_[sector.index] = first | kDivided;
}

void Sectors::add_zoom(const Point& point, const Sector& sector) {
  const std::uint32_t depth = sector.zoom == kNoZoom ? 0 : zooms_[sector.zoom].depth + 1;
  if (depth > kMaxDepth) return;
  const Curve& curve = sector.zoom == kNoZoom ? curve_ : zooms_[sector.zoom].curve;
  const Box box = curve.cell_box(curve.nearest_key(point));
  if (!(box.min.x < box.max.x && box.min.y < box.max.y)) return;
  const auto index = static_cast<Cell>(zooms_.size());
  zooms_.push_back({Curve(box), static_cast<std::uint32_t>(sectors_.size()), depth});
  const Cell cell = sectors_[sector.index];
  sectors_.insert(sectors_.end(), 4, cell);
  sectors_[sector.index] = index | kDivided | kZoomed;
}

Sectors::Cell Sectors::any_vertex(Cell cell) const {
  while ((cell & kDivided) != 0) cell = sectors_[is_zoomed(cell) ? zoom_of(cell).first : cell & ~kDivided];
  return cell;
}

// Replaces every whole sector by four: by its quarters if it is divided, otherwise by four sectors that remember the
// same vertex.
void Sectors::grow() {
  std::vector<Cell> finer;
  finer.reserve(4 * sectors_.size());
  const std::size_t count = whole_count();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      finer.push_back(is_divided(sectors_[i]) ? sectors_[(sectors_[i] & ~kDivided) + quarter] : sectors_[i]);
    }
  }
  // After the new whole sectors come the quarters of the divided ones. The loop also visits the entries that it
  // appends.
  for (std::size_t i = 0; i < finer.size(); ++i) {
    if ((finer[i] & kDivided) == 0) continue;
    std::size_t old = finer[i] & ~kDivided;
    if (is_zoomed(finer[i])) {
      Zoom& zoom = zooms_[finer[i] & ~(kDivided | kZoomed)];
      old = zoom.first;
      zoom.first = static_cast<std::uint32_t>(finer.size());
    } else {
      finer[i] = static_cast<Cell>(finer.size()) | kDivided;
    }
    for (std::size_t quarter = 0; quarter < 4; ++quarter) finer.push_back(sectors_[old + quarter]);
  }
  sectors_ = std::move(finer);
  whole_shift_ -= 2;
}

void Sectors::fill(std::span<const Curve::Key> keys, std::uint32_t first) {
  int shift = kKeyBits - 2;
  while (shift > 2 && keys.size() > kVerticesPerSector << (kKeyBits - shift)) shift -= 2;
  whole_shift_ = shift;
  sectors_.assign(whole_count(), kNone);
  auto begin = keys.begin();
  for (std::size_t i = 0; i < whole_count(); ++i) {
    const auto end = std::find_if(begin, keys.end(), [&](Curve::Key key) { return key >> shift != i; });
    const auto passed = static_cast<std::size_t>(begin - keys.begin());
    fill_sector(i, shift, {begin, end}, first + static_cast<std::uint32_t>(passed));
    begin = end;
  }
}

// An empty sector remembers the last vertex before it along the curve.
void Sectors::fill_sector(std::size_t index, int shift, std::span<const Curve::Key> keys, std::uint32_t first) {
  if (keys.size() <= kCrowd || shift == 0) {
    sectors_[index] = first + static_cast<Cell>(keys.size() / 2) - (keys.empty() ? 1 : 0);
    return;
  }
  const std::size_t quarters = sectors_.size();
  sectors_.resize(quarters + 4);
  sectors_[index] = static_cast<Cell>(quarters) | kDivided;
  auto begin = keys.begin();
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const auto end =
        std::find_if(begin, keys.end(), [&](Curve::Key key) { return (key >> (shift - 2) & 3) != quarter; });
    const auto passed = static_cast<std::size_t>(begin - keys.begin());
    fill_sector(quarters + quarter, shift - 2, {begin, end}, first + static_cast<std::uint32_t>(passed));
    begin = end;
  }
}

}  // namespace waywright::locate
