#include "path/abstraction.hpp"

#include <algorithm>
#include <iterator>

#include "memory/count.hpp"

namespace waywright::path {

using mesh::Face;

/// Takes everything back unless it is told that all went well.
class Abstraction::Guard {
 public:
  explicit Guard(Abstraction& abstraction) : abstraction_(abstraction) {
    abstraction_.components_.begin();
    abstraction_.core_.begin();
  }
  ~Guard() {
    if (is_done_) return;
    abstraction_.components_.roll_back();
    abstraction_.core_.roll_back();
    std::fill(abstraction_.is_touched_.begin(), abstraction_.is_touched_.end(), false);
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  void done() { is_done_ = true; }

 private:
  Abstraction& abstraction_;
  bool is_done_ = false;
};

Abstraction::Abstraction(const Triangulation& triangulation) {
  Guard guard(*this);
  rebuild(triangulation);
  guard.done();
  give_back();
}

void Abstraction::begin() {
  inserted_.clear();
  removed_.clear();
}

// Where most faces changed, a rebuild is cheaper.
void Abstraction::update(const Triangulation& triangulation) {
  Guard guard(*this);
  collect_touched(triangulation);
  const bool is_large = 2 * gone_.size() > triangulation.topology().face_slots();
  if (is_in_the_open(triangulation.topology())) {
    components_.refill(triangulation.topology(), gone_, made_);
    core_.refill(triangulation.topology(), gone_, made_);
  } else if (is_large) {
    rebuild(triangulation);
  } else {
    bring_up_to_date(triangulation, {gone_, made_, removed_, inserted_});
  }
  guard.done();
  if (is_large) give_back();
}

void Abstraction::rebuild(const Triangulation& triangulation) {
  collect_all(triangulation);
  bring_up_to_date(triangulation, {gone_, made_, {}, {}});
}

/// Keeps no log nor scratch as large as the mesh. The log of what is done isn't needed any more.
void Abstraction::give_back() {
  components_.give_back();
  core_.give_back();
  gone_ = std::vector<Face>();
  made_ = std::vector<Face>();
}

void Abstraction::bring_up_to_date(const Triangulation& triangulation, const Components::Changes& changes) {
  components_.update(triangulation, changes);
  core_.update(triangulation.topology(), changes.gone, changes.made);
}

/// The faces that the operation touched, each once, and which polygons it is that came or went for good.
void Abstraction::collect_touched(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  if (is_touched_.size() < mesh.face_slots()) is_touched_.resize(mesh.face_slots());
  gone_.clear();
  mesh.for_each_touched_face([&](Face f, mesh::TriangleMesh::Touch) {
    if (is_touched_[number(f)]) return;
    gone_.push_back(f);
    is_touched_[number(f)] = true;
  });
  for (const Face f : gone_) is_touched_[number(f)] = false;
  collect_made(triangulation);

  std::sort(inserted_.begin(), inserted_.end());
  std::sort(removed_.begin(), removed_.end());
  common_.clear();
  std::set_intersection(inserted_.begin(), inserted_.end(), removed_.begin(), removed_.end(),
                        std::back_inserter(common_));
  const auto is_common = [&](std::uint32_t item) { return std::binary_search(common_.begin(), common_.end(), item); };
  std::erase_if(inserted_, is_common);
  std::erase_if(removed_, is_common);
}

/// Whether all that changed lies among faces that had, and have again, ways over all three of their edges: then they
/// are of one component and of the core, as before.
bool Abstraction::is_in_the_open(const mesh::TriangleMesh& mesh) const {
  if (!inserted_.empty() || !removed_.empty()) return false;
  Components::Label component = Components::kNone;
  for (const Face f : gone_) {
    if (core_.is_absent(f)) continue;
    if (component == Components::kNone) component = components_.of(f);
    if (core_.degree(f) != 3 || components_.of(f) != component) return false;
  }
  return component != Components::kNone && std::all_of(made_.begin(), made_.end(), [&](Face f) {
           const mesh::HalfEdge h = mesh::first(f);
           return !mesh.is_fixed(h) && !mesh.is_fixed(mesh::next(h)) && !mesh.is_fixed(mesh::previous(h));
         });
}

/// All faces, as if none had been there before.
void Abstraction::collect_all(const Triangulation& triangulation) {
  gone_.clear();
  for (std::uint32_t i = 0; i < triangulation.topology().face_slots(); ++i) gone_.push_back(Face{i});
  collect_made(triangulation);
}

void Abstraction::collect_made(const Triangulation& triangulation) {
  made_.clear();
  for (const Face f : gone_) {
    const bool is_in_box =
        triangulation.topology().is_alive(f) && !triangulation.triangulation().is_ghost_face(mesh::first(f));
    if (is_in_box) made_.push_back(f);
  }
}

std::optional<std::string> Abstraction::find_fault(const Triangulation& triangulation) const {
  Abstraction rebuilt(triangulation);
  rebuilt.collect_all(triangulation);
  if (auto fault = components_.find_difference(rebuilt.components_, rebuilt.made_)) return fault;
  return core_.find_difference(triangulation.topology(), rebuilt.core_, rebuilt.made_);
}

void Abstraction::count_memory(MemoryUse& use) const {
  components_.count_memory(use);
  core_.count_memory(use);
  use.abstraction += is_touched_.capacity() / 8;
  memory::count_spare(use, inserted_, removed_, gone_, made_, common_);
}

}  // namespace waywright::path
