#pragma once

#include <span>
#include <vector>

#include "waywright/item.hpp"
#include "waywright/point.hpp"
#include "waywright/scene.hpp"

#include "oracle/oracle.hpp"

namespace waywright::oracle {

[[nodiscard]] inline OraclePoint to_oracle(Point p) { return {p.x, p.y}; }

[[nodiscard]] inline std::vector<OraclePoint> to_oracle(std::span<const Point> points) {
  std::vector<OraclePoint> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back(to_oracle(p));
  return result;
}

[[nodiscard]] inline OracleKind to_oracle(ItemKind kind) {
  switch (kind) {
    case ItemKind::point:
      return OracleKind::point;
    case ItemKind::segment:
      return OracleKind::segment;
    case ItemKind::polyline:
      return OracleKind::polyline;
    case ItemKind::polygon:
      return OracleKind::polygon;
  }
  return OracleKind::point;
}

[[nodiscard]] inline OracleItem to_oracle(const Item& item) {
  OracleItem result{item.id.value, to_oracle(item.shape.kind), {}, item.shape.fill == FillRule::nonzero};
  for (const auto& ring : item.shape.rings) result.rings.push_back(to_oracle(ring));
  return result;
}

[[nodiscard]] inline OracleScene to_oracle(const Box& domain, std::span<const Item> items) {
  OracleScene result{{to_oracle(domain.min), to_oracle(domain.max)}, {}};
  for (const Item& item : items) result.items.push_back(to_oracle(item));
  return result;
}

[[nodiscard]] inline OracleScene to_oracle(const Scene& scene) { return to_oracle(scene.domain, scene.items); }

}  // namespace waywright::oracle
