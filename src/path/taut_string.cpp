#include "path/taut_string.hpp"

#include "path/distance.hpp"
#include "path/funnel.hpp"

namespace waywright::path {

using exact::Sign;

/// The two strings of the funnel, for the functions in `funnel.hpp`.
struct TautString::Strings {
  using Node = std::size_t;

  template <Sign kString>
  struct Chain {
    [[nodiscard]] bool is_empty() const { return at == end; }
    [[nodiscard]] Node first() const { return kString == Sign::positive ? at - 1 : at + 1; }
    Node take_first() { return at = first(); }
    Node at;
    Node end;
  };

  [[nodiscard]] Node apex() const { return string->apex_; }
  template <Sign kString>
  [[nodiscard]] Node end() const {
    return kString == Sign::positive ? string->left_ : string->right_;
  }
  template <Sign kString>
  [[nodiscard]] Node before(Node node) const {
    return kString == Sign::positive ? node + 1 : node - 1;
  }
  template <Sign kString>
  [[nodiscard]] Chain<kString> from_apex() const {
    return {apex(), end<kString>()};
  }
  [[nodiscard]] Sign orientation(Node p, Node q, const View& v) const {
    return string->geometry_->orientation(string->row_[p], string->row_[q], v);
  }

  const TautString* string;
};

void TautString::begin(const Geometry& geometry, const Point& start, mesh::Vertex left, mesh::Vertex right,
                       std::size_t portal_count) {
  geometry_ = &geometry;
  points_.clear();
  if (row_.size() < 2 * portal_count + 1) row_.resize(2 * portal_count + 1);
  left_ = apex_ = right_ = portal_count;
  row_[apex_] = Geometry::view(start);
  if (!is_at_start(geometry, row_[apex_], left)) row_[--left_] = geometry.view(number(left));
  if (!is_at_start(geometry, row_[apex_], right)) row_[++right_] = geometry.view(number(right));
}

void TautString::move_left(mesh::Vertex v) {
  const View position = geometry_->view(number(v));
  const auto [node, apex] = find_turn<Sign::positive>(Strings{this}, position);
  move_apex_right(apex);
  left_ = node - 1;
  row_[left_] = position;
}

void TautString::move_right(mesh::Vertex v) {
  const View position = geometry_->view(number(v));
  const auto [node, apex] = find_turn<Sign::negative>(Strings{this}, position);
  move_apex_left(apex);
  right_ = node + 1;
  row_[right_] = position;
}

void TautString::end_at(const Point& goal) {
  const std::size_t last = find_last_turn(Strings{this}, Geometry::view(goal));
  move_apex_left(last);
  move_apex_right(last);
  turn_at(row_[apex_]);
  length_ = 0.0;
  for (std::size_t i = 1; i < points_.size(); ++i) length_ += distance(points_[i - 1], points_[i]);
  length_ += distance(points_.back(), goal);
}

}  // namespace waywright::path
