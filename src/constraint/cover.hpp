#pragma once

#include <cstdint>
#include <vector>

#include "constraint/exact_triangulation.hpp"
#include "locate/walk.hpp"

namespace waywright::constraint {

/// Which polygons cover a face or a point. An object to keep: its memory serves query after query.
class Cover {
 public:
  Cover() = default;
  virtual ~Cover() = default;
  Cover(Cover&&) noexcept = default;  // GCOVR_EXCL_LINE: std::optional wants it there, and assigns instead
  Cover& operator=(Cover&&) noexcept = default;

  /// The polygons, by slot, that cover the inside of the face of `h`; in no order. This way of finding them goes
  /// through faces to the domain's border and makes them ascend; who keeps them by face knows a better one.
  virtual const std::vector<std::uint32_t>& of_face(const ExactTriangulation& triangulation, mesh::HalfEdge h);

  /// Whether a polygon covers the inside of the face of `h`.
  virtual bool is_covered(const ExactTriangulation& triangulation, mesh::HalfEdge h) {
    return !of_face(triangulation, h).empty();
  }

  /// The polygons, by slot, that cover the place, their boundary included; each once, in no order.
  const std::vector<std::uint32_t>& of_place(const ExactTriangulation& triangulation, const locate::Located& place);

  /// Whether the place lies strictly inside some polygon: covered, and on none of that polygon's sides.
  bool is_strictly_inside(const ExactTriangulation& triangulation, const locate::Located& place);

  /// The polygons, by slot, that have the place strictly inside; each once, in no order.
  const std::vector<std::uint32_t>& strictly_covering(const ExactTriangulation& triangulation,
                                                      const locate::Located& place);

  /// The faces around the place that no polygon covers, each by its half-edge: from the vertex, along the edge or, of
  /// the face itself, the one whose origin comes first in (x, y) order. The order of the faces depends on the mesh's
  /// geometry alone: counter-clockwise around a vertex from its first neighbour, an edge's left side first.
  const std::vector<mesh::HalfEdge>& open_faces(const ExactTriangulation& triangulation, const locate::Located& place);

 private:
  void collect_touching(const ExactTriangulation& triangulation, const locate::Located& place);

  std::vector<std::uint32_t> crossed_;   ///< an entry for each side crossed; then, the polygons around the face at hand
  std::vector<std::uint32_t> touching_;  ///< polygons with a side or corner at the place; ascending
  std::vector<std::uint32_t> covering_;
  std::vector<mesh::HalfEdge> around_;
  std::vector<mesh::HalfEdge> open_;
};

/// The half-edges whose faces meet at the place, in the order that Cover::open_faces describes, ghost faces left out.
void faces_at(const ExactTriangulation& triangulation, const locate::Located& place,
              std::vector<mesh::HalfEdge>& faces);

/// The polygon's winding number around the face of `h`; of an even-odd polygon only its parity counts. The function
/// crosses the same edges as Cover::of_face.
[[nodiscard]] std::int32_t turns_around(const ExactTriangulation& triangulation, mesh::HalfEdge h,
                                        std::uint32_t polygon);

}  // namespace waywright::constraint
