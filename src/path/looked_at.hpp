#pragma once

#include <cstdint>

#include "memory/pages.hpp"
#include "memory/scratch.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::path {

/// The faces that a search has looked at. A change of the mesh concerns the search only if it touches one of them.
class LookedAt {
 public:
  /// Forgets all faces. `face_slots` is the mesh's number of slots for faces.
  void clear(std::uint32_t face_slots) {
    stamp_.next(1, marks_);
    marks_.grow_to(face_slots);
    is_all_ = false;
  }
  /// Records that the search has looked at every face.
  void look_at_all() { is_all_ = true; }
  void look(mesh::Face f) {
    marks_.make_room(number(f));
    marks_[number(f)] = stamp_.value();
  }
  /// Makes room for faces that were added to the mesh after the last clear().
  void grow_to(std::uint32_t face_slots) { marks_.grow_to(face_slots); }
  [[nodiscard]] bool has(mesh::Face f) const {
    return is_all_ || (marks_.has_room(number(f)) && marks_[number(f)] == stamp_.value());
  }

 private:
  memory::Pages<std::uint32_t> marks_;  ///< by face: the search that looked at it last
  memory::Stamp stamp_;
  bool is_all_ = false;
};

}  // namespace waywright::path
