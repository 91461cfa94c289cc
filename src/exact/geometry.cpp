#include "exact/geometry.hpp"

namespace waywright::exact {

void Geometry::place(std::uint32_t vertex, const Point& point) {
  grow_to(vertex);
  log(vertex);
  places_[vertex] = {point, kExplicit};
}

void Geometry::place_crossing(std::uint32_t vertex, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                              std::uint32_t d) {
  grow_to(vertex);
  const Crossing crossing{nearest(a), nearest(b), nearest(c), nearest(d)};
  const RoundedCrossing rounded = round_to_nearest(crossing);
  log(vertex);
  places_[vertex] = {rounded.nearest, rounded.is_exact ? kExplicit : add_crossing(crossing)};
}

void Geometry::clear(std::uint32_t vertex) {
  if (places_[vertex].crossing == kExplicit) return;
  left_crossings_.push_back(places_[vertex].crossing);
  log(vertex);
  places_[vertex].crossing = kExplicit;
}

void Geometry::begin() {
  log_.clear();
  free_crossings_.insert(free_crossings_.end(), left_crossings_.begin(), left_crossings_.end());
  left_crossings_.clear();
}

void Geometry::roll_back() {
  for (; !log_.empty(); log_.pop_back()) {
    const Undo& change = log_.back();
    Place& place = places_[change.vertex];
    if (place.crossing != kExplicit) free_crossings_.push_back(place.crossing);
    place = change.place;
  }
  left_crossings_.clear();
}

void Geometry::grow_to(std::uint32_t vertex) {
  if (vertex >= places_.size()) places_.resize(vertex + std::size_t{1});
}

void Geometry::log(std::uint32_t vertex) { log_.push_back({vertex, places_[vertex]}); }

std::uint32_t Geometry::add_crossing(const Crossing& crossing) {
  if (free_crossings_.empty()) {
    if (crossings_.size() == crossings_.capacity()) crossings_.reserve(2 * crossings_.size() + 1);
    free_crossings_.reserve(crossings_.capacity());
    crossings_.push_back(crossing);
    return static_cast<std::uint32_t>(crossings_.size() - 1);
  }
  const std::uint32_t slot = free_crossings_.back();
  free_crossings_.pop_back();
  crossings_[slot] = crossing;
  return slot;
}

}  // namespace waywright::exact
