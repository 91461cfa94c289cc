#pragma once

#include <cstddef>
#include <vector>

#include "waywright/memory_use.hpp"

#include "memory/count.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::mesh {

/// The faces that an operation has touched, each once: also faces that it has freed, and ghost faces. The class leaves
/// out faces of which only labels have changed, because their edges are the same. Keep the object: later operations use
/// its memory again.
///
///     const TouchedFaces::Guard guard(touched);
///     touched.collect(mesh);                     // the operation has changed the mesh, and has not ended
class TouchedFaces {
 public:
  /// The destructor makes the object empty, also if memory ran out in collect().
  class Guard {
   public:
    explicit Guard(TouchedFaces& touched) : touched_(touched) {}
    ~Guard() { touched_.clear(); }
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

   private:
    TouchedFaces& touched_;
  };

  /// Collects the faces. Requires: a Guard exists, and the object is empty. Cost: linear in the edits of the operation.
  void collect(const TriangleMesh& mesh) {
    if (is_touched_.size() < mesh.face_slots()) is_touched_.resize(mesh.face_slots());
    mesh.for_each_touched_face([&](Face f, TriangleMesh::Touch touch) {
      if (touch == TriangleMesh::Touch::relabelled || is_touched_[number(f)]) return;
      faces_.push_back(f);
      is_touched_[number(f)] = true;
    });
    are_most_ = faces_.size() > kFewFaces && 2 * faces_.size() > mesh.face_slots();
    if (!are_most_) return;
    clear();
    memory::release(faces_);
  }

  /// Returns whether the operation has touched most faces of the mesh, and more than kFewFaces. If so, it costs less to
  /// rebuild data about all faces than to update them, and collect() has kept no list: faces() is empty.
  [[nodiscard]] bool are_most_faces() const { return are_most_; }
  /// The touched faces, in the order in which the operation first touched them.
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  [[nodiscard]] bool contains(Face f) const { return is_touched_[number(f)]; }

  void count_memory(MemoryUse& use) const {
    memory::count_spare(use, faces_);
    use.spare += is_touched_.capacity() / 8;
  }
  /// Frees all memory. Requires: the object is empty.
  void release() { memory::release(faces_, is_touched_); }

 private:
  /// If an operation has touched this number of faces or fewer, are_most_faces() is false, also in a small mesh.
  static constexpr std::size_t kFewFaces = 1000;

  void clear() {
    for (const Face f : faces_) is_touched_[number(f)] = false;
    faces_.clear();
  }

  std::vector<Face> faces_;
  std::vector<bool> is_touched_;  ///< by face
  bool are_most_ = false;
};

}  // namespace waywright::mesh
