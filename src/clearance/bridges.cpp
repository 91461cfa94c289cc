#include "clearance/bridges.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "clearance/wall_line.hpp"
#include "memory/count.hpp"

namespace waywright::clearance {

using mesh::Face;
using mesh::HalfEdge;
using mesh::Vertex;

namespace {

/// The value of `acute_` for a face outside the domain. No face of the domain has this value, because at least two of
/// its angles are acute.
constexpr std::uint8_t kNotInDomain = 0;

}  // namespace

/// The destructor rolls the bridges back, unless keep() was called.
class Bridges::Guard {
 public:
  explicit Guard(Bridges& bridges) : bridges_(bridges) { bridges_.begin(); }
  ~Guard() {
    bridges_.region_.clear();
    if (!is_kept_) bridges_.roll_back();
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  void keep() { is_kept_ = true; }

 private:
  Bridges& bridges_;
  bool is_kept_ = false;
};

Bridges::Bridges(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  grow_to_mesh(mesh);
  BridgeFinder finder(triangulation, scratch_);
  const auto for_each_face = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
      if (triangulation.triangulation().is_in_domain(Face{i})) visit(Face{i});
    }
  };
  for_each_face([&](Face f) { note_angles(finder, f); });
  for_each_face([&](Face f) {
    find_at_corners(finder, f);
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      const HalfEdge h{i};
      if (!mesh.is_fixed(h) && h < mesh.twin(h) && may_be_bridge(h, mesh.twin(h)))
        find_at_edge(triangulation, finder, h);
    }
    begin();  // empties the logs: no earlier state exists
  });
  link_new_feet(triangulation);
  begin();
  shrink_to_fit();
}

void Bridges::grow_to_mesh(const mesh::TriangleMesh& mesh) {
  acute_.grow_to(mesh.face_slots());
  corners_.grow_to(std::size_t{3} * mesh.face_slots(), 0);
  walls_.grow_to(std::size_t{3} * mesh.face_slots(), 0);
}

void Bridges::begin() {
  corners_.begin();
  walls_.begin();
  feet_.begin();
  free_feet_before_ = free_feet_;
  before_rebuild_.reset();
}

void Bridges::roll_back() {
  if (before_rebuild_) {
    swap_bridges(*before_rebuild_);
    return before_rebuild_.reset();
  }
  corners_.roll_back();
  walls_.roll_back();
  feet_.roll_back();
  free_feet_ = free_feet_before_;
}

void Bridges::update(const Triangulation& triangulation, const mesh::TouchedFaces& touched,
                     const ChangedWalls& changed) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  Guard guard(*this);
  if (touched.are_most_faces()) {
    rebuild(triangulation);
    guard.keep();
    return;
  }
  region_.begin(triangulation, touched);
  new_feet_.clear();
  grow_to_mesh(mesh);
  BridgeFinder finder(triangulation, scratch_);
  find_in_touched(triangulation, changed, finder);
  find_beyond(triangulation, changed, finder);
  link_new_feet(triangulation);
  guard.keep();
}

/// Rebuilds the bridges. If most faces are touched, this costs less than an update of each touched face.
void Bridges::rebuild(const Triangulation& triangulation) {
  auto rebuilt = std::make_unique<Bridges>(triangulation);
  swap_bridges(*rebuilt);
  before_rebuild_ = std::move(rebuilt);
}

/// Swaps the bridges, without the scratch.
void Bridges::swap_bridges(Bridges& other) {
  std::swap(corners_, other.corners_);
  std::swap(walls_, other.walls_);
  std::swap(feet_, other.feet_);
  std::swap(free_feet_, other.free_feet_);
}

/// Removes three kinds of bridges: along an edge of a touched face, from a corner of such a face, and to a wall that is
/// an edge of such a face. Then finds the first two kinds again. find_beyond() finds the third kind again.
///
/// If the other face of an edge is not touched, the half-edge in that face still says whether the edge was a bridge
/// before the operation. The edge is a bridge now if and only if it was one before, unless a changed wall touches its
/// closed disc.
void Bridges::find_in_touched(const Triangulation& triangulation, const ChangedWalls& changed, BridgeFinder& finder) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto is_in_domain = [&](Face f) { return triangulation.triangulation().is_in_domain(f); };
  for (const Face f : region_.touched().faces()) {
    clear_face(f);
    acute_[number(f)] = kNotInDomain;
    if (is_in_domain(f)) note_angles(finder, f);
  }
  for (const Face f : region_.touched().faces()) {
    if (acute_[number(f)] == kNotInDomain) continue;
    find_at_corners(finder, f);
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      const HalfEdge h{i};
      const HalfEdge twin = mesh.twin(h);
      const bool is_free = !mesh.is_fixed(h);
      if (region_.touched().contains(mesh::face(twin))) {
        // The processor cannot predict these tests, so the code combines them without branches.
        if (is_free & (h < twin) & may_be_bridge(h, twin)) find_at_edge(triangulation, finder, h);
        continue;
      }
      if (!is_free) continue;
      region_.add_border(h);
      if (finder.may_touch(finder.disc_of(h), changed)) {
        find_at_edge(triangulation, finder, h);
      } else {
        set_bridge(h, is_bridge(twin));
      }
    }
  }
}

void Bridges::note_angles(const BridgeFinder& finder, Face f) {
  acute_[number(f)] = static_cast<std::uint8_t>(finder.acute_angles(f));
}

/// Finds the foot bridges that start at the corners of a face. Requires: note_angles() was called for the face.
void Bridges::find_at_corners(BridgeFinder& finder, Face f) {
  for (unsigned corners = BridgeFinder::corners_with_foot(acute_[number(f)]); corners != 0; corners &= corners - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(corners));
    find_at_corner(finder, mesh::half_edge(f, i));
  }
}

bool Bridges::may_be_bridge(HalfEdge h, HalfEdge twin) const {
  const auto acute_at_apex = [&](HalfEdge of) {
    constexpr std::uint32_t kPrevious[3] = {2, 0, 1};  // by the number of a half-edge in its face
    const Face f = mesh::face(of);
    return acute_[number(f)] >> kPrevious[mesh::index_in(f, of)];
  };
  return (acute_at_apex(h) & acute_at_apex(twin) & 1) != 0;
}

void Bridges::find_beyond(const Triangulation& triangulation, const ChangedWalls& changed, BridgeFinder& finder) {
  region_.collect_beyond(changed, finder, scratch_);
  for (const HalfEdge corner : region_.corners()) find_at_corner(finder, corner);
  for (const HalfEdge h : region_.edges()) find_at_edge(triangulation, finder, h);
}

void Bridges::clear_face(Face f) {
  const std::uint32_t first = 3 * number(f);
  const std::uint32_t of_corners = corners_[first] | corners_[first + 1] | corners_[first + 2];
  if ((of_corners | walls_[first] | walls_[first + 1] | walls_[first + 2]) == 0) return;
  for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
    if ((corners_[i] | walls_[i]) == 0) continue;
    const HalfEdge h{i};
    if (const std::uint32_t foot = foot_at(h); foot != kNone) remove_foot(foot);
    while (first_foot_on(h) != kNone) {
      const std::uint32_t foot = first_foot_on(h);
      if (!region_.touched().contains(mesh::face(feet_[foot].corner))) region_.add_corner(feet_[foot].corner);
      remove_foot(foot);
    }
    write_corner(h, 0);
  }
}

void Bridges::find_at_corner(BridgeFinder& finder, HalfEdge corner) {
  const HalfEdge wall = finder.find_wall(corner);
  const std::uint32_t old = foot_at(corner);
  if (old != kNone) {
    if (feet_[old].wall == wall) return;
    remove_foot(old);
  }
  if (wall != mesh::kNoHalfEdge) add_foot(corner, wall);
}

void Bridges::find_at_edge(const Triangulation& triangulation, BridgeFinder& finder, HalfEdge h) {
  const bool is_found = finder.is_bridge(h);
  set_bridge(h, is_found);
  set_bridge(triangulation.topology().twin(h), is_found);
}

void Bridges::set_bridge(HalfEdge h, bool is_bridge) {
  const std::uint32_t value = corners_[number(h)];
  write_corner(h, is_bridge ? value | kIsBridge : value & ~kIsBridge);
}

void Bridges::write_corner(HalfEdge h, std::uint32_t value) {
  if (corners_[number(h)] != value) corners_.write(number(h), value);
}

/// Makes a foot bridge. link_new_feet() inserts it into the list of its wall.
void Bridges::add_foot(HalfEdge corner, HalfEdge wall) {
  const Foot added{corner, wall, kNone};
  auto foot = static_cast<std::uint32_t>(feet_.size());
  if (free_feet_.is_empty()) {
    feet_.append(added);
  } else {
    foot = free_feet_.first();
    const std::uint32_t next_free = feet_[foot].next;
    feet_.write(foot, added);
    free_feet_.pop(next_free);
  }
  write_corner(corner, (foot + 1) << 1 | (corners_[number(corner)] & kIsBridge));
  new_feet_.push_back(foot);
}

/// Returns whether a foot comes before another foot on the same wall.
bool Bridges::comes_before(const Triangulation& triangulation, const Foot& foot, const Foot& other) const {
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const auto start_of = [&](const Foot& of) {
    return geometry.rounded(number(triangulation.topology().origin(of.corner)));
  };
  const WallLine line = wall_line(triangulation, foot.wall);
  return exact::dot(start_of(foot), start_of(other), line.from, line.to) == exact::Sign::positive;
}

/// Inserts the new feet into the lists of their walls. These lists are in the order of the feet. The function sorts the
/// new feet first, so it goes through each list only once.
void Bridges::link_new_feet(const Triangulation& triangulation) {
  std::sort(new_feet_.begin(), new_feet_.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Foot& p = feet_[a];
    const Foot& q = feet_[b];
    return p.wall != q.wall ? p.wall < q.wall : comes_before(triangulation, p, q);
  });
  HalfEdge wall = mesh::kNoHalfEdge;
  std::uint32_t before = kNone;
  std::uint32_t at = kNone;
  for (const std::uint32_t foot : new_feet_) {
    const Foot added = feet_[foot];
    if (added.wall != wall) {
      wall = added.wall;
      before = kNone;
      at = first_foot_on(wall);
    }
    while (at != kNone && comes_before(triangulation, feet_[at], added)) before = std::exchange(at, feet_[at].next);
    if (at != kNone) feet_.write(foot, {added.corner, wall, at});
    link(wall, before, foot);
    before = foot;
  }
  new_feet_.clear();
}

/// Removes a foot bridge. Requires: link_new_feet() has inserted it into the list of its wall.
void Bridges::remove_foot(std::uint32_t foot) {
  const Foot removed = feet_[foot];
  std::uint32_t before = kNone;
  for (std::uint32_t at = first_foot_on(removed.wall); at != foot; at = feet_[at].next) before = at;
  link(removed.wall, before, removed.next);
  write_corner(removed.corner, corners_[number(removed.corner)] & kIsBridge);
  free_foot(foot);
}

// Calls write() before push(): write() can throw std::bad_alloc, push() cannot.
void Bridges::free_foot(std::uint32_t foot) {
  feet_.write(foot, {mesh::kNoHalfEdge, mesh::kNoHalfEdge, free_feet_.first()});
  (void)free_feet_.push(foot);
}

/// Makes `foot` the successor of `before` in the list of the wall, or the first if `before` is kNone.
void Bridges::link(HalfEdge wall, std::uint32_t before, std::uint32_t foot) {
  if (before == kNone) return walls_.write(number(wall), (foot + 1) & kNone);
  const Foot& at = feet_[before];
  feet_.write(before, {at.corner, at.wall, foot});
}

std::optional<std::string> Bridges::find_fault(const Triangulation& triangulation) const {
  const Bridges rebuilt(triangulation);
  const auto wall_at = [](const Bridges& bridges, HalfEdge h) {
    const std::uint32_t foot = bridges.foot_at(h);
    return foot == kNone ? mesh::kNoHalfEdge : bridges.foot(foot).wall;
  };
  const auto fault_at = [](const char* what, std::uint32_t h) {
    return std::string(what) + " at half-edge " + std::to_string(h) + " differs from a rebuild";
  };
  for (std::uint32_t i = 0; i < 3 * triangulation.topology().face_slots(); ++i) {
    const HalfEdge h{i};
    // If an operation was undone, the mesh may have more slots than the bridges have. These additional slots are free.
    if (!triangulation.triangulation().is_in_domain(mesh::face(h))) continue;
    if (is_bridge(h) != rebuilt.is_bridge(h)) return fault_at("the bridge", i);
    if (wall_at(*this, h) != wall_at(rebuilt, h)) return fault_at("the foot bridge", i);
    std::uint32_t p = first_foot_on(h);
    std::uint32_t q = rebuilt.first_foot_on(h);
    for (; p != kNone && q != kNone; p = foot(p).next, q = rebuilt.foot(q).next) {
      if (foot(p).corner != rebuilt.foot(q).corner) return fault_at("the order of the feet", i);
    }
    if (p != q) return fault_at("the number of feet", i);
  }
  return std::nullopt;
}

void Bridges::count_memory(MemoryUse& use) const {
  corners_.count_memory(use, &MemoryUse::bridges);
  walls_.count_memory(use, &MemoryUse::bridges);
  feet_.count_memory(use, &MemoryUse::bridges);
  region_.count_memory(use);
  memory::count_spare(use, new_feet_, scratch_.to_enter, scratch_.to_test);
  use.spare += acute_.size() + scratch_.visited.size() * sizeof(std::uint32_t);
}

void Bridges::shrink_to_fit() {
  begin();  // empties the logs
  corners_.shrink_to_fit();
  walls_.shrink_to_fit();
  feet_.shrink_to_fit();
  region_.release();
  memory::release(new_feet_);
  acute_ = {};
  scratch_ = {};
}

}  // namespace waywright::clearance
