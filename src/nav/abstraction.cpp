#include "nav/abstraction.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

#include "memory/count.hpp"
#include "nav/point_agent.hpp"

namespace waywright::nav {

using mesh::Face;

/// The destructor rolls the abstraction back, unless keep() was called.
class Abstraction::Guard {
 public:
  explicit Guard(Abstraction& abstraction) : abstraction_(abstraction) {
    abstraction_.components_.begin();
    abstraction_.core_.begin();
  }
  ~Guard() {
    if (is_kept_) return;
    abstraction_.components_.roll_back();
    abstraction_.core_.roll_back();
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  void keep() { is_kept_ = true; }

 private:
  Abstraction& abstraction_;
  bool is_kept_ = false;
};

Abstraction::Abstraction(const Triangulation& triangulation) : components_(triangulation), core_(triangulation) {}

std::uint64_t Abstraction::new_connections() {
  static std::atomic<std::uint64_t> last = 0;
  return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

void Abstraction::begin() {
  is_updated_ = false;
  inserted_.clear();
  removed_.clear();
}

void Abstraction::update(const Triangulation& triangulation, const mesh::TouchedFaces& touched) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const std::vector<Face>& changed = touched.faces();
  Guard guard(*this);
  was_rebuilt_ = false;
  if (touched.are_most_faces()) {
    rebuild(triangulation);
    is_updated_ = true;
    guard.keep();
    return;
  }
  collect_new_faces(triangulation, touched);
  remove_common_polygons();
  if (is_in_open_space(mesh, touched)) {
    update_.run_in_open_space(components_, mesh, changed, new_faces_);
    core_.update_in_open_space(mesh, changed, new_faces_);
  } else {
    core_.update(mesh, changed, new_faces_, [&](Face f) { return components_.component_of(f); });  // the old ones
    update_.run(components_, triangulation,
                {changed, new_faces_, removed_, inserted_, triangulation.may_have_divided()});
    if (update_.may_have_connected()) connections_ = new_connections();
  }
  is_updated_ = true;
  guard.keep();
}

void Abstraction::commit() {
  is_updated_ = false;
  before_.reset();
}

void Abstraction::roll_back() {
  if (!is_updated_) return;
  if (was_rebuilt_) {
    components_ = std::move(before_->components);
    update_ = std::move(before_->update);
    core_ = std::move(before_->core);
  } else {
    components_.roll_back();
    core_.roll_back();
  }
  commit();
}

/// Rebuilds the abstraction. If most faces changed, this costs less than an update of each changed face.
void Abstraction::rebuild(const Triangulation& triangulation) {
  memory::release(new_faces_);
  before_ = std::make_unique<Replaced>(Replaced{Components(triangulation), {}, TwoCore(triangulation)});
  std::swap(components_, before_->components);
  std::swap(update_, before_->update);
  std::swap(core_, before_->core);
  connections_ = new_connections();
  was_rebuilt_ = true;
}

/// Collects in `new_faces_` the touched faces that now lie in the domain.
void Abstraction::collect_new_faces(const Triangulation& triangulation, const mesh::TouchedFaces& touched) {
  new_faces_.clear();
  std::copy_if(touched.faces().begin(), touched.faces().end(), std::back_inserter(new_faces_),
               [&](Face f) { return triangulation.triangulation().is_in_domain(f); });
}

/// If the operation has inserted a polygon and has then removed it, removes this polygon from `inserted_` and from
/// `removed_`.
void Abstraction::remove_common_polygons() {
  std::sort(inserted_.begin(), inserted_.end());
  std::sort(removed_.begin(), removed_.end());
  common_.clear();
  std::set_intersection(inserted_.begin(), inserted_.end(), removed_.begin(), removed_.end(),
                        std::back_inserter(common_));
  const auto is_common = [&](std::uint32_t item) { return std::binary_search(common_.begin(), common_.end(), item); };
  std::erase_if(inserted_, is_common);
  std::erase_if(removed_, is_common);
}

/// Returns whether the change happened in open space: before it, every touched face that existed had three passages to
/// faces of the two-core, and all these faces belonged to one component. After it, all edges of the faces in
/// `new_faces_` are passages. The new faces then belong to the same component, and each has three passages to faces of
/// the two-core.
bool Abstraction::is_in_open_space(const mesh::TriangleMesh& mesh, const mesh::TouchedFaces& touched) const {
  if (!inserted_.empty() || !removed_.empty()) return false;
  Components::Id component = Components::kNone;
  for (const Face f : touched.faces()) {
    if (core_.is_absent(f)) continue;
    if (component == Components::kNone) component = components_.component_of(f);
    if (core_.core_degree(f) != 3 || components_.component_of(f) != component) return false;
  }
  return component != Components::kNone && std::all_of(new_faces_.begin(), new_faces_.end(), [&](Face f) {
           const mesh::HalfEdge h = mesh::first(f);
           return PointAgent::can_cross(mesh, h) && PointAgent::can_cross(mesh, mesh::next(h)) &&
                  PointAgent::can_cross(mesh, mesh::previous(h));
         });
}

std::optional<std::string> Abstraction::find_fault(const Triangulation& triangulation) const {
  const Abstraction rebuilt(triangulation);
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < triangulation.topology().face_slots(); ++i) {
    if (triangulation.triangulation().is_in_domain(Face{i})) faces.push_back(Face{i});
  }
  if (auto fault = components_.find_difference(rebuilt.components_, faces)) return fault;
  return core_.find_difference(triangulation.topology(), rebuilt.core_, faces);
}

void Abstraction::count_memory(MemoryUse& use) const {
  components_.count_memory(use);
  update_.count_memory(use);
  core_.count_memory(use);
  memory::count_spare(use, inserted_, removed_, new_faces_, common_);
}

void Abstraction::shrink_to_fit() {
  components_.begin();  // empties the logs
  core_.begin();
  components_.shrink_to_fit();
  update_.shrink_to_fit();
  core_.shrink_to_fit();
  memory::release(inserted_, removed_, new_faces_, common_);
}

}  // namespace waywright::nav
