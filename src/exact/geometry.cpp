#include "exact/geometry.hpp"

namespace waywright::exact {

void Geometry::place(std::uint32_t vertex, const Point& point) { set(vertex, point, kExplicit); }

void Geometry::place_crossing(std::uint32_t vertex, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                              std::uint32_t d) {
  const Crossing crossing{points_[a], points_[b], points_[c], points_[d]};
  const RoundedCrossing rounded = round_to_nearest(crossing);
  if (rounded.is_exact) return place(vertex, rounded.nearest);
  std::uint32_t slot = 0;
  if (free_crossings_.empty()) {
    slot = static_cast<std::uint32_t>(crossings_.size());
    crossings_.push_back(crossing);
  } else {
    slot = free_crossings_.back();
    free_crossings_.pop_back();
    crossings_[slot] = crossing;
  }
  set(vertex, rounded.nearest, slot);
}

void Geometry::clear(std::uint32_t vertex) {
  if (crossing_of_[vertex] == kExplicit) return;
  free_crossings_.push_back(crossing_of_[vertex]);
  crossing_of_[vertex] = kExplicit;
}

void Geometry::set(std::uint32_t vertex, const Point& point, std::uint32_t crossing) {
  if (vertex >= points_.size()) {
    points_.resize(vertex + std::size_t{1});
    crossing_of_.resize(vertex + std::size_t{1}, kExplicit);
  }
  points_[vertex] = point;
  crossing_of_[vertex] = crossing;
}

}  // namespace waywright::exact
