#include "formats/scene_builder.hpp"

#include <algorithm>
#include <utility>

#include "base/domain_bounds.hpp"
#include "formats/reader.hpp"

namespace waywright::formats {

void SceneBuilder::add(Shape shape, std::optional<ItemId> id) {
  if (id) ids_.insert(id->value);
  if (id) largest_id_ = std::max(largest_id_, id->value);
  items_.push_back({id.value_or(ItemId{}), std::move(shape)});
}

Scene SceneBuilder::take() {
  if (items_.empty() && !domain_) {
    throw Refusal{.offset = 0, .what = "expected a geometry, found none; a map needs at least one"};
  }
  number_items();
  const Box domain = domain_ ? *domain_ : domain_around_items();
  return {.domain = domain, .items = std::move(items_), .y_down = y_down_};
}

void SceneBuilder::number_items() {
  for (Item& item : items_) {
    if (!item.id.is_null()) continue;
    if (largest_id_ == ItemId::kLargest) {
      throw Refusal{.offset = 0,
                    .what =
                        "no id is left for the items without one, because an item has the largest id, 2^63 - 1; "
                        "give it a smaller one"};
    }
    item.id = ItemId{++largest_id_};
  }
}

Box SceneBuilder::domain_around_items() const {
  const Point first = items_.front().shape.rings.points().front();
  Box box{first, first};
  for (const Item& item : items_) {
    for (const Point& point : item.shape.rings.points()) box = with_point(box, point);
  }
  return domain_around(box);
}

Box domain_around(const Box& box) {
  const base::Bounds bounds = base::domain_bounds({box.min.x, box.min.y, box.max.x, box.max.y}, kLargestCoordinate);
  return {{bounds.min_x, bounds.min_y}, {bounds.max_x, bounds.max_y}};
}

Box with_point(const Box& box, const Point& point) {
  return {{std::min(box.min.x, point.x), std::min(box.min.y, point.y)},
          {std::max(box.max.x, point.x), std::max(box.max.y, point.y)}};
}

Shape line_of_points(std::vector<Point> points) {
  if (points.size() == 2) return Shape::segment(points[0], points[1]);
  return {ItemKind::polyline, {std::move(points)}};
}

}  // namespace waywright::formats
