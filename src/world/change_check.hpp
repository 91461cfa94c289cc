#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/item.hpp"

#include "constraint/exact_triangulation.hpp"

namespace waywright {

[[nodiscard]] Error unknown_id_error(ItemId id);

/// Says what is wrong with changes before any of them is made. Each is checked against the ids and the size that the
/// changes before it will have left. Every function that changes a world asks this class and nothing else.
class ChangeCheck {
 public:
  /// Whether the check remembers the changes that it has accepted. For a single change, and for points under ids that
  /// count up, it need not; then it allocates nothing.
  enum class Record { no, yes };

  ChangeCheck(const constraint::ExactTriangulation& triangulation, Record record)
      : triangulation_(triangulation),
        keeps_record_(record == Record::yes),
        largest_(triangulation.items().largest_id_seen()),
        vertex_count_(triangulation.topology().vertex_count() - 1) {}

  // Each returns what is wrong, and nothing if the change is accepted. A null id becomes the one that the world will
  // give. The error's index is the position of the point that is wrong, or 0.
  [[nodiscard]] std::optional<Error> add_insertion(const Shape& shape, ItemId& id);
  [[nodiscard]] std::optional<Error> add_removal(ItemId id);
  [[nodiscard]] std::optional<Error> add_replacement(ItemId id, const Shape& shape);
  /// The insertion of points under ids that count up from `first`, which is not null.
  [[nodiscard]] std::optional<Error> add_points(std::span<const Point> points, ItemId first);

 private:
  [[nodiscard]] std::optional<Error> check_new_id(ItemId id) const;
  [[nodiscard]] std::optional<Error> check_point(std::size_t i, const Point& point, ItemId id) const;
  [[nodiscard]] std::optional<Error> check_shape(ItemId id, const Shape& shape);
  [[nodiscard]] std::optional<Error> add_vertices(std::size_t count);
  [[nodiscard]] bool is_alive(ItemId id) const;
  void remember_insertion(ItemId id);

  const constraint::ExactTriangulation& triangulation_;
  bool keeps_record_;
  ItemId largest_;                            ///< of all ids, those of the record included
  std::size_t vertex_count_;                  ///< at most, after the changes accepted so far
  std::vector<ItemId> fresh_;                 ///< inserted under an id larger than all before: they ascend
  std::unordered_map<ItemId, bool> changed_;  ///< for each other id that a change named, whether its item is alive now
};

}  // namespace waywright
