#pragma once

#include <cstddef>
#include <memory>

#include "exact/geometry.hpp"
#include "thesis/double_arithmetic.hpp"
#include "thesis/interval_arithmetic.hpp"
#include "thesis/rational_arithmetic.hpp"
#include "workloads.hpp"

namespace waywright::bench {

/// The counts that all correct meshes of one workload have in common.
struct MeshCounts {
  std::size_t vertices = 0;
  std::size_t fixed_edges = 0;

  friend bool operator==(const MeshCounts&, const MeshCounts&) = default;
};

/// The library's triangulation over some geometry. It performs a workload's updates as a World does.
class Triangulated {
 public:
  virtual ~Triangulated() = default;

  virtual void insert(const Item& item) = 0;
  virtual void update(const Update& update) = 0;

  [[nodiscard]] virtual MeshCounts counts() const = 0;
  /// Returns whether links are consistent and no face is inverted. For a mesh with rounded crossings, uses the rounded
  /// points.
  [[nodiscard]] virtual bool is_planar() const = 0;
};

/// Returns the triangulation of an empty domain over this geometry.
template <class Geometry>
[[nodiscard]] std::unique_ptr<Triangulated> triangulate(const Box& domain);

template <>
[[nodiscard]] std::unique_ptr<Triangulated> triangulate<exact::Geometry>(const Box& domain);
template <>
[[nodiscard]] std::unique_ptr<Triangulated> triangulate<DoubleGeometry>(const Box& domain);
template <>
[[nodiscard]] std::unique_ptr<Triangulated> triangulate<IntervalGeometry>(const Box& domain);
template <>
[[nodiscard]] std::unique_ptr<Triangulated> triangulate<RationalGeometry>(const Box& domain);

}  // namespace waywright::bench
