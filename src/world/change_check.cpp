#include "world/change_check.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "world/query_errors.hpp"

namespace waywright {

namespace {

/// A mesh has at most constraint::kMostVertices vertices. This limit leaves more than half of them for crossings. The
/// number of crossings is not known before the change is made. So the operation counts them while it makes them.
constexpr std::size_t kLargestVertexCount = std::size_t{1} << 27;

std::optional<Error> find_arity_error(const Shape& shape) {
  const auto refuse = [](detail::ErrorWords message) { return Error{ErrorCode::bad_shape, std::move(message), {}, 0}; };
  if (shape.kind > ItemKind::polygon) return refuse("the kind of a shape is none of the values of ItemKind");
  if (shape.rings.empty()) return refuse("a shape needs a ring of points");
  for (const PointSpan& ring : shape.rings) {
    if (ring.empty()) return refuse("a ring needs at least one point");
  }
  if (shape.kind == ItemKind::polygon) {
    if (shape.fill > FillRule::nonzero) return refuse("the fill rule of a polygon is none of the values of FillRule");
    return std::nullopt;
  }
  if (shape.rings.size() != 1) return refuse("only a polygon has more than one ring");
  const std::size_t count = shape.rings[0].size();
  if (shape.kind == ItemKind::point && count != 1) return refuse("a point needs exactly one point");
  if (shape.kind == ItemKind::segment && count != 2) return refuse("a segment needs exactly two points");
  return std::nullopt;
}

std::optional<Error> about(ItemId id, std::optional<Error> error) {
  if (error) error->item = id;
  return error;
}

}  // namespace

Error unknown_id_error(ItemId id) {
  return {id.value > ItemId::kLargest ? ErrorCode::bad_id : ErrorCode::unknown_id, {}, id, 0};
}

std::optional<Error> ChangeCheck::add_insertion(const Shape& shape, ItemId& id) {
  if (id.is_null()) id = {largest_.value + 1};
  if (auto error = check_new_id(id)) return error;
  if (auto error = check_shape(id, shape)) return error;
  if (keeps_record_) remember_insertion(id);
  return std::nullopt;
}

std::optional<Error> ChangeCheck::add_removal(ItemId id) {
  if (!is_live(id)) return unknown_id_error(id);
  if (keeps_record_) changed_[id] = false;
  return std::nullopt;
}

std::optional<Error> ChangeCheck::add_replacement(ItemId id, const Shape& shape) {
  if (!is_live(id)) return unknown_id_error(id);
  return check_shape(id, shape);
}

std::optional<Error> ChangeCheck::add_points(const constraint::PointBatch& batch) {
  if (batch.size() == 0) return check_new_id(batch.first);
  const Box& domain = triangulation_.domain();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const ItemId id = batch.id(i);
    const bool is_new_id = id > largest_ && id.value <= ItemId::kLargest;
    if (is_new_id && is_point_of(domain, batch.points[i])) [[likely]]
      continue;
    if (auto error = check_point(i, batch.points[i], id)) return error;
  }
  return about(batch.id(0), add_vertices(batch.size()));
}

std::optional<Error> ChangeCheck::check_point(std::size_t i, const Point& point, ItemId id) const {
  auto error = check_new_id(id);
  if (!error) error = about(id, find_point_error(triangulation_.domain(), point, i));
  if (error) error->index = i;
  return error;
}

std::optional<Error> ChangeCheck::check_new_id(ItemId id) const {
  if (id.is_null() || id.value > ItemId::kLargest) return Error{ErrorCode::bad_id, {}, id, 0};
  if (id <= largest_ && is_live(id)) return Error{ErrorCode::id_in_use, {}, id, 0};
  return std::nullopt;
}

std::optional<Error> ChangeCheck::check_shape(ItemId id, const Shape& shape) {
  if (auto error = find_arity_error(shape)) return about(id, std::move(error));
  const std::span<const Point> points = shape.rings.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (auto error = find_point_error(triangulation_.domain(), points[i], i)) return about(id, std::move(error));
  }
  return about(id, add_vertices(points.size()));
}

std::optional<Error> ChangeCheck::add_vertices(std::size_t count) {
  if (vertex_count_ + count > kLargestVertexCount) {
    Error error{ErrorCode::too_large, {}, {}, 0};
    error.words.limit = kLargestVertexCount;
    return error;
  }
  vertex_count_ += count;
  return std::nullopt;
}

bool ChangeCheck::is_live(ItemId id) const {
  if (keeps_record_) {
    const auto found = changed_.find(id);
    if (found != changed_.end()) return found->second;
    if (std::binary_search(fresh_.begin(), fresh_.end(), id)) return true;
  }
  return triangulation_.items().contains(id);
}

void ChangeCheck::remember_insertion(ItemId id) {
  if (id > largest_) {
    largest_ = id;
    fresh_.push_back(id);
  } else {
    changed_[id] = true;
  }
}

}  // namespace waywright
