#include <algorithm>

#include "path/components.hpp"

// The components of a mesh that nothing is known of yet. They are found in place: until they are numbered, a face's
// label is that of a face before it in its set, or the first face's own.

namespace waywright::path {

using mesh::Face;
using mesh::HalfEdge;

Components::Components(const Triangulation& triangulation) : labels_(triangulation.topology().face_slots(), kNone) {
  join_faces(triangulation);
  number_components();
  if (triangulation.items().has_polygons()) cover_components(triangulation);
  begin();
}

/// Source: Galler and Fischer, *An improved equivalence algorithm*, CACM 1964.
void Components::join_faces(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!triangulation.triangulation().is_in_box(Face{f})) continue;
    labels_[f] = f;
    for (std::uint32_t side = 0; side < 3; ++side) {
      const HalfEdge h{3 * f + side};
      const Face other = mesh::face(mesh.twin(h));
      if (number(other) < f && !mesh.is_fixed(h)) unite(labels_, f, number(other));
    }
  }
}

void Components::number_components() {
  for (std::uint32_t f = 0; f < labels_.size(); ++f) {
    if (labels_[f] == kNone) continue;
    const bool is_first = labels_[f] == f;
    labels_[f] = is_first ? add_record({}) : labels_[labels_[f]];
    ++records_[labels_[f]].size;
  }
}

/// From beyond the box inwards.
void Components::cover_components(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const std::vector<Door> doors = find_doors(mesh);
  std::vector<bool> is_known(records_.size());
  std::vector<Label> known = {kNone};
  const auto comes_before = [](const Door& door, Label component) { return door.component < component; };
  for (std::size_t i = 0; i < known.size(); ++i) {
    auto door = std::lower_bound(doors.begin(), doors.end(), known[i], comes_before);
    for (; door != doors.end() && door->component == known[i]; ++door) {
      const Label beyond = of(mesh::face(mesh.twin(door->h)));
      if (is_known[beyond]) continue;
      is_known[beyond] = true;
      records_[beyond].cover = cover_beyond(triangulation, door->h, {});
      known.push_back(beyond);
    }
  }
}

std::vector<Components::Door> Components::find_doors(const mesh::TriangleMesh& mesh) const {
  std::vector<Door> doors;
  for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
    const HalfEdge h{i};
    if (!mesh.is_alive(mesh::face(h)) || !mesh.is_fixed(h)) continue;
    const Label beyond = of(mesh::face(mesh.twin(h)));
    if (beyond != kNone && beyond != of(mesh::face(h))) doors.push_back({of(mesh::face(h)), h});
  }
  std::sort(doors.begin(), doors.end(), [](const Door& a, const Door& b) { return a.component < b.component; });
  return doors;
}

}  // namespace waywright::path
