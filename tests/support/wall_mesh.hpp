#pragma once

#include <cstdint>
#include <optional>

#include "clearance/bridges.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "nav/two_core.hpp"
#include "support/disc_scenes.hpp"

namespace waywright::test {

/// The triangulation of the walls of a scene, with its bridges and its two-core.
class WallMesh {
 public:
  explicit WallMesh(const disc::NamedScene& scene) : walls_(scene.domain) {
    constraint::ConstrainedTriangulation::UndoGuard operation(walls_);
    std::uint64_t id = 0;
    for (const auto& [a, b] : scene.walls.segments) {
      if (!(a == b)) walls_.insert(Shape::segment(a, b), ItemId{++id});
    }
    operation.commit();
    bridges_.emplace(walls_);
    core_.emplace(walls_);
  }

  [[nodiscard]] const constraint::ConstrainedTriangulation& walls() const { return walls_; }
  [[nodiscard]] const clearance::Bridges& bridges() const { return *bridges_; }
  [[nodiscard]] const nav::TwoCore& core() const { return *core_; }
  [[nodiscard]] Point position(mesh::Vertex v) const { return walls_.triangulation().geometry().rounded(number(v)); }

 private:
  constraint::ConstrainedTriangulation walls_;
  std::optional<clearance::Bridges> bridges_;
  std::optional<nav::TwoCore> core_;
};

}  // namespace waywright::test
