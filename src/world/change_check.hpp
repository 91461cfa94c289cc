#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "waywright/error.hpp"
#include "waywright/item.hpp"

#include "constraint/batch.hpp"
#include "constraint/constrained_triangulation.hpp"

namespace waywright {

[[nodiscard]] Error unknown_id_error(ItemId id);

/// Checks changes before an operation makes the first of them. It checks each change against the ids and the number of
/// vertices that the world will have after the changes before it. Every function that changes a world uses this class
/// and no other check.
class ChangeCheck {
 public:
  /// Whether the check remembers the changes that it has accepted. This is not necessary for a single change, or for
  /// points whose ids ascend. If the check does not remember them, it allocates nothing.
  enum class Record { no, yes };

  ChangeCheck(const constraint::ConstrainedTriangulation& triangulation, Record record)
      : triangulation_(triangulation),
        keeps_record_(record == Record::yes),
        largest_(triangulation.items().largest_id_seen()),
        vertex_count_(triangulation.topology().vertex_count() - 1) {}

  // Each function returns an error, or nothing if it accepts the change. It replaces a null id by the id that the world
  // will give. The index of the error is the index of the wrong point, or 0.
  [[nodiscard]] std::optional<Error> add_insertion(const Shape& shape, ItemId& id);
  [[nodiscard]] std::optional<Error> add_removal(ItemId id);
  [[nodiscard]] std::optional<Error> add_replacement(ItemId id, const Shape& shape);
  /// The insertion of points under ids that ascend.
  [[nodiscard]] std::optional<Error> add_points(const constraint::PointBatch& batch);

 private:
  [[nodiscard]] std::optional<Error> check_new_id(ItemId id) const;
  [[nodiscard]] std::optional<Error> check_point(std::size_t i, const Point& point, ItemId id) const;
  [[nodiscard]] std::optional<Error> check_shape(ItemId id, const Shape& shape);
  [[nodiscard]] std::optional<Error> add_vertices(std::size_t count);
  [[nodiscard]] bool is_live(ItemId id) const;
  void remember_insertion(ItemId id);

  const constraint::ConstrainedTriangulation& triangulation_;
  bool keeps_record_;
  ItemId largest_;                            ///< the largest id so far, including accepted changes
  std::size_t vertex_count_;                  ///< an upper bound, after the accepted changes, without new crossings
  std::vector<ItemId> fresh_;                 ///< the inserted ids that were larger than all ids before; ascending
  std::unordered_map<ItemId, bool> changed_;  ///< for each other id in a change: whether its item is live now
};

}  // namespace waywright
