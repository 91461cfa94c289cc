#pragma once

#include <cstddef>
#include <optional>
#include <unordered_set>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"
#include "waywright/scene.hpp"

namespace waywright::formats {

/// Collects the items of a file whose items need no id and which need not give a domain.
class SceneBuilder {
 public:
  /// Adds an item. If it has no id, take() gives it one.
  /// Requires: no other item has this id.
  void add(Shape shape, std::optional<ItemId> id = std::nullopt);
  [[nodiscard]] bool is_in_use(ItemId id) const { return ids_.contains(id.value); }

  void set_domain(const Box& domain) { domain_ = domain; }
  void set_y_down(bool y_down) { y_down_ = y_down; }

  /// Returns the scene. Items without an id get the ids that follow the largest id, in the order of the items: without
  /// any id they count from 1. Without a domain, the domain is the box around all points, enlarged like the domain of a
  /// `.poly` file. Throws a Refusal if there is neither an item nor a domain, and if an id would be too large.
  [[nodiscard]] Scene take();

 private:
  void number_items();
  [[nodiscard]] Box domain_around_items() const;

  std::vector<Item> items_;
  std::unordered_set<std::uint64_t> ids_;
  std::uint64_t largest_id_ = 0;
  std::optional<Box> domain_;
  bool y_down_ = false;
};

/// Returns the domain for a box around all points of a file that gives no domain.
[[nodiscard]] Box domain_around(const Box& box);

/// Returns the smallest box that contains `box` and `point`.
[[nodiscard]] Box with_point(const Box& box, const Point& point);

/// Returns the item for a list of points: a segment for two points, otherwise a polyline.
[[nodiscard]] Shape line_of_points(std::vector<Point> points);

}  // namespace waywright::formats
