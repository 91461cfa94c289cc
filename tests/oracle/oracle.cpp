#include "oracle/oracle.hpp"

#include <algorithm>

#include "oracle/oracle_impl.hpp"

namespace waywright::oracle {

Oracle::Oracle(OracleScene scene) : impl_(std::make_unique<const Impl>(std::move(scene))) {}
Oracle::~Oracle() = default;
Oracle::Oracle(Oracle&&) noexcept = default;
Oracle& Oracle::operator=(Oracle&&) noexcept = default;

ExpectedMesh Oracle::expected() const {
  ExpectedMesh result;
  for (const ExactPosition& p : impl_->arrangement.vertices) result.vertices.push_back(impl_->arrangement.grid.text(p));
  result.constraints = impl_->arrangement.constraints;
  return result;
}

std::size_t Oracle::vertex_count() const { return impl_->arrangement.vertices.size(); }

const std::vector<OraclePoint>& Oracle::nearest_vertices() const { return impl_->arrangement.near_vertices; }

std::size_t Oracle::crossing_count() const { return impl_->arrangement.crossing_count; }

std::size_t Oracle::constraint_count() const { return impl_->arrangement.constraints.size(); }

std::vector<std::uint64_t> Oracle::covering_polygons(OraclePoint point) const {
  const ExactPosition position = impl_->arrangement.grid.point(point);
  std::vector<std::uint64_t> ids;
  for (const Solid& solid : impl_->solids) {
    const RingRelation relation = relation_to_rings(solid, position);
    if (relation.on_boundary || relation.inside_after) ids.push_back(solid.id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

bool Oracle::strictly_inside(OraclePoint point) const {
  const ExactPosition position = impl_->arrangement.grid.point(point);
  return std::any_of(impl_->solids.begin(), impl_->solids.end(), [&](const Solid& solid) {
    const RingRelation relation = relation_to_rings(solid, position);
    return !relation.on_boundary && relation.inside_after;
  });
}

ExpectedMesh expected_vertices_and_constraints(const OracleScene& scene) { return Oracle(scene).expected(); }

std::optional<std::string> check_dump(const OracleScene& scene, std::string_view dump) {
  return Oracle(scene).check_dump(dump);
}

std::vector<std::uint64_t> covering_polygons(const OracleScene& scene, OraclePoint point) {
  return Oracle(scene).covering_polygons(point);
}

bool strictly_inside(const OracleScene& scene, OraclePoint point) { return Oracle(scene).strictly_inside(point); }

std::optional<std::string> check_path(const OracleScene& scene, const std::vector<OraclePoint>& points) {
  return Oracle(scene).check_path(points);
}

}  // namespace waywright::oracle
