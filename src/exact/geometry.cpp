#include "exact/geometry.hpp"

#include "exact/predicates.hpp"

namespace waywright::exact {

void Geometry::set_position(std::uint32_t vertex, const Point& point) {
  while (vertex >= positions_.size()) positions_.emplace_back();  // nearly always adds at most one entry
  log(vertex);
  positions_[vertex] = point;
  if (vertex < crossing_of_.size()) crossing_of_[vertex] = kExplicit;
}

void Geometry::set_crossing(std::uint32_t vertex, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  const Crossing crossing{rounded(a), rounded(b), rounded(c), rounded(d)};
  const RoundedCrossing rounded = round_to_nearest(crossing);
  set_position(vertex, rounded.nearest);
  if (rounded.is_exact) return;
  while (vertex >= crossing_of_.size()) crossing_of_.push_back(kExplicit);
  crossing_of_[vertex] = add_crossing(crossing);
}

void Geometry::clear(std::uint32_t vertex) {
  if (is_explicit(vertex)) return;
  dropped_crossings_.push_back(crossing_of_[vertex]);
  log(vertex);
  crossing_of_[vertex] = kExplicit;
}

void Geometry::begin() {
  journal_.begin();
  free_crossings_.insert(free_crossings_.end(), dropped_crossings_.begin(), dropped_crossings_.end());
  dropped_crossings_.clear();
}

void Geometry::roll_back() {
  journal_.roll_back([&](const Undo& change) {
    positions_[change.vertex] = change.position;
    if (change.vertex >= crossing_of_.size()) return;
    std::uint32_t& crossing = crossing_of_[change.vertex];
    if (crossing != kExplicit) free_crossings_.push_back(crossing);
    crossing = change.crossing;
  });
  dropped_crossings_.clear();
}

ExactPoint Geometry::exact(const View& view) const {
  const std::uint32_t crossing = crossing_of(view.vertex);
  return {view.x, view.y, crossing == kExplicit ? nullptr : &crossings_[crossing]};
}

Sign Geometry::finer_orientation(const View& a, const View& b, const View& c) const {
  const bool are_explicit = crossing_of_.empty() || (is_explicit(a) && is_explicit(b) && is_explicit(c));
  if (are_explicit && filter::is_flat(a, b, c)) {
    ++counts.orientation.doubles;
    return Sign::zero;
  }
  if (const Sign sign = filter::coarse::orientation(a, b, c); sign != Sign::zero) {
    ++counts.orientation.doubles;
    return sign;
  }
  return detail::finer_orientation(exact(a), exact(b), exact(c));
}

Sign Geometry::finer_in_circle(const View& a, const View& b, const View& c, const View& d) const {
  const bool are_explicit =
      crossing_of_.empty() || (is_explicit(a) && is_explicit(b) && is_explicit(c) && is_explicit(d));
  if (are_explicit && filter::is_rectangle(a, b, c, d)) {
    ++counts.in_circle.doubles;
    return Sign::zero;
  }
  return detail::finer_in_circle(exact(a), exact(b), exact(c), exact(d));
}

std::strong_ordering Geometry::finer_order(const View& p, const View& q) const { return compare(exact(p), exact(q)); }

std::uint32_t Geometry::add_crossing(const Crossing& crossing) {
  if (free_crossings_.empty()) {
    if (free_crossings_.capacity() == crossings_.size()) free_crossings_.reserve(2 * crossings_.size() + 1);
    crossings_.push_back(crossing);
    return static_cast<std::uint32_t>(crossings_.size() - 1);
  }
  const std::uint32_t slot = free_crossings_.back();
  free_crossings_.pop_back();
  crossings_[slot] = crossing;
  return slot;
}

}  // namespace waywright::exact
