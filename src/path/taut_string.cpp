#include "path/taut_string.hpp"

#include "path/distance.hpp"

namespace waywright::path {

using exact::Sign;

// A string of length zero has no direction, so the code could not decide whether the next piece turns left or right. So
// a vertex at the start is not added: it is the apex itself.
void TautString::begin(const Geometry& geometry, const Point& start, mesh::Vertex left, mesh::Vertex right,
                       std::size_t portal_count) {
  geometry_ = &geometry;
  corners_.clear();
  if (row_.size() < 2 * portal_count + 1) row_.resize(2 * portal_count + 1);
  left_ = apex_ = right_ = portal_count;
  row_[apex_] = Geometry::view(start);
  if (!is_at_start(left)) row_[--left_] = geometry.view(number(left));
  if (!is_at_start(right)) row_[++right_] = geometry.view(number(right));
}

bool TautString::is_at_start(mesh::Vertex v) const {
  return geometry_->order(row_[apex_], geometry_->view(number(v))) == 0;
}

//        left end . . . . . v       The new string to v leaves the left string at a corner: the first one, from the
//       /               .'          left end towards the apex, for which v lies to the left of the piece that ends
//      .            . '             there. If there is no such corner, the new string follows the right string from the
//     /        . '                  apex on, as long as v lies to the right of the next piece.
//   apex --- . --- right end
void TautString::move_left(mesh::Vertex v) {
  const View position = geometry_->view(number(v));
  while (left_ < apex_ && geometry_->orientation(row_[left_ + 1], row_[left_], position) != Sign::positive) ++left_;
  if (left_ == apex_) {
    while (apex_ < right_ && geometry_->orientation(row_[apex_], row_[apex_ + 1], position) == Sign::negative) {
      turn_at(row_[apex_++]);
    }
    left_ = apex_;
  }
  row_[--left_] = position;
}

/// The mirror image of move_left().
void TautString::move_right(mesh::Vertex v) {
  const View position = geometry_->view(number(v));
  while (right_ > apex_ && geometry_->orientation(row_[right_ - 1], row_[right_], position) != Sign::negative) --right_;
  if (right_ == apex_) {
    while (apex_ > left_ && geometry_->orientation(row_[apex_], row_[apex_ - 1], position) == Sign::positive) {
      turn_at(row_[apex_--]);
    }
    right_ = apex_;
  }
  row_[++right_] = position;
}

void TautString::end_at(const Point& goal) {
  const View position = Geometry::view(goal);
  const std::size_t first = apex_;
  while (apex_ > left_ && geometry_->orientation(row_[apex_], row_[apex_ - 1], position) == Sign::positive) {
    turn_at(row_[apex_--]);
  }
  if (apex_ == first) {
    while (apex_ < right_ && geometry_->orientation(row_[apex_], row_[apex_ + 1], position) == Sign::negative) {
      turn_at(row_[apex_++]);
    }
  }
  turn_at(row_[apex_]);
  length_ = 0.0;
  for (std::size_t i = 1; i < corners_.size(); ++i) length_ += distance(corners_[i - 1], corners_[i]);
  length_ += distance(corners_.back(), goal);
}

}  // namespace waywright::path
