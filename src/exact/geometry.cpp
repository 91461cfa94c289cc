#include "exact/geometry.hpp"

#include "exact/predicates.hpp"

namespace waywright::exact {

void Geometry::set_position(std::uint32_t vertex, const Point& point) {
  if (vertex >= positions_.size()) positions_.resize(vertex + 1);
  position_journal_.add({positions_[vertex], vertex});
  positions_[vertex] = point;
}

void Geometry::set_crossing(std::uint32_t vertex, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  const Crossing crossing{rounded(a), rounded(b), rounded(c), rounded(d)};
  const RoundedCrossing rounded = round_to_nearest(crossing);
  set_position(vertex, rounded.nearest);
  if (rounded.is_exact) return;
  lines_of_.grow_to(std::size_t{vertex} + 1);
  lines_of_.make_room(vertex);
  // A side that crosses many others is the first line of many crossings, one after the other.
  recent_line_ = lines_.find_or_make(crossing.ab, recent_line_);
  const Lines lines = {recent_line_, lines_.find_or_make(crossing.cd)};
  lines_journal_.add({{}, vertex});
  lines_.add_uses(lines.one, lines.other);
  lines_of_[vertex] = lines;
  ++constructed_count_;
}

// If memory runs out after the record is made, roll_back() finds the lines unchanged, and this changes nothing.
void Geometry::clear(std::uint32_t vertex) {
  const Lines lines = lines_of(vertex);
  if (lines.one == LineTable::kNone) return;
  lines_journal_.add({lines, vertex});
  lines_.remove_uses(lines.one, lines.other);
  lines_of_[vertex] = {};
  --constructed_count_;
}

void Geometry::begin() {
  position_journal_.begin();
  lines_journal_.begin();
  lines_.begin();
}

void Geometry::roll_back() {
  position_journal_.roll_back([&](const PositionUndo& change) { positions_[change.vertex] = change.position; });
  lines_journal_.roll_back([&](const LinesUndo& change) {
    Lines& lines = lines_of_[change.vertex];
    if (lines.one != LineTable::kNone) {
      lines_.take_back_uses(lines.one, lines.other);
      --constructed_count_;
    }
    lines = change.lines;
    if (lines.one != LineTable::kNone) {
      lines_.add_uses(lines.one, lines.other);
      ++constructed_count_;
    }
  });
  lines_.roll_back();
}

ExactPosition Geometry::exact(const View& view) const {
  const Lines lines = lines_of(view.vertex);
  if (lines.one == LineTable::kNone) return {view.x, view.y};
  return {view.x, view.y, &lines_[lines.one], &lines_[lines.other]};
}

Sign Geometry::finer_orientation(const View& a, const View& b, const View& c) const {
  const bool are_explicit = !has_constructed() || (is_explicit(a) && is_explicit(b) && is_explicit(c));
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
      !has_constructed() || (is_explicit(a) && is_explicit(b) && is_explicit(c) && is_explicit(d));
  if (are_explicit && filter::is_rectangle(a, b, c, d)) {
    ++counts.in_circle.doubles;
    return Sign::zero;
  }
  return detail::finer_in_circle(exact(a), exact(b), exact(c), exact(d));
}

std::strong_ordering Geometry::finer_order(const View& p, const View& q) const { return compare(exact(p), exact(q)); }

}  // namespace waywright::exact
