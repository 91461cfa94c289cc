#include "clearance/bridges.hpp"

#include <algorithm>
#include <utility>

#include "clearance/wall_line.hpp"
#include "memory/count.hpp"

namespace waywright::clearance {

using mesh::Face;
using mesh::HalfEdge;
using mesh::Vertex;

namespace {

/// update() never rebuilds the bridges for this many changed faces or fewer, whatever their share of the mesh.
constexpr std::size_t kFewFaces = 1000;

bool is_in_domain(const Bridges::Triangulation& triangulation, HalfEdge h) {
  return !triangulation.triangulation().is_ghost_face(h);
}

}  // namespace

/// Rolls the bridges back when it is destroyed, unless done() was called.
class Bridges::Guard {
 public:
  explicit Guard(Bridges& bridges) : bridges_(bridges) { bridges_.begin(); }
  ~Guard() {
    for (const Face f : bridges_.touched_) bridges_.is_touched_[number(f)] = false;
    for (const Vertex v : bridges_.near_) bridges_.is_near_[number(v)] = false;
    bridges_.touched_.clear();
    bridges_.near_.clear();
    if (!is_done_) bridges_.roll_back();
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  void done() { is_done_ = true; }

 private:
  Bridges& bridges_;
  bool is_done_ = false;
};

Bridges::Bridges(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  grow_to_mesh(mesh);
  BridgeFinder finder(triangulation, scratch_);
  for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
    const HalfEdge h{i};
    if (i % 3 == 0 && !triangulation.triangulation().is_in_domain(mesh::face(h))) {
      i += 2;
      continue;
    }
    find_at_corner(triangulation, finder, h);
    if (!mesh.is_fixed(h) && i < number(mesh.twin(h))) set_bridge(h, finder.is_bridge(h));
    if (mesh.is_fixed(h)) continue;
    if (i < number(mesh.twin(h))) set_bridge(mesh.twin(h), is_bridge(h));
    if (i % 3 == 0) begin();  // empties the logs: there is no earlier state to go back to
  }
  begin();
  shrink_to_fit();
}

void Bridges::grow_to_mesh(const mesh::TriangleMesh& mesh) {
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

void Bridges::update(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  Guard guard(*this);
  collect_touched(triangulation);
  if (touched_.size() > kFewFaces && 2 * touched_.size() > mesh.face_slots()) {
    rebuild(triangulation);
    return guard.done();
  }
  grow_to_mesh(mesh);
  clear_touched();
  BridgeFinder finder(triangulation, scratch_);
  collect_near(triangulation, finder);
  for (const Vertex v : near_) find_at(triangulation, finder, v);
  guard.done();
}

/// Rebuilds the bridges. If most faces changed, this costs less than an update of each changed face.
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

void Bridges::collect_touched(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  if (is_touched_.size() < mesh.face_slots()) is_touched_.resize(mesh.face_slots());
  if (is_near_.size() < mesh.vertex_slots()) is_near_.resize(mesh.vertex_slots());
  mesh.for_each_touched_face([&](Face f, mesh::TriangleMesh::Touch) {
    if (is_touched_[number(f)]) return;
    touched_.push_back(f);
    is_touched_[number(f)] = true;
  });
}

/// Removes three kinds of bridges: along an edge of a touched face, from a corner of such a face, and to a wall that is
/// an edge of such a face.
void Bridges::clear_touched() {
  for (const Face f : touched_) clear_face(f);
}

void Bridges::clear_face(Face f) {
  for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
    const HalfEdge h{i};
    if (const std::uint32_t foot = foot_at(h); foot != kNone) remove_foot(foot);
    while (first_foot_on(h) != kNone) remove_foot(first_foot_on(h));
    write_corner(h, 0);
  }
}

// A bridge appears or vanishes only if its disc, which is empty before or after the change, meets the region R of the
// touched faces. Let q be a position of R in the disc, and w a vertex at which the bridge ends. A smaller disc through
// w and q is empty, too. So if q were a new vertex, the edge from w to q would be Delaunay, and the insertion of q
// would replace a face at w: the circle of a face at w contains q. The faces whose circles contain q and which are
// visible from q are connected. So w is a vertex of R, or a search finds it that starts at an edge e on the border of
// R, enters faces outside R whose circles meet e, and goes on from there.
void Bridges::collect_near(const Triangulation& triangulation, BridgeFinder& finder) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  for (const Face f : touched_) {
    if (!triangulation.triangulation().is_in_domain(f)) continue;
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      const HalfEdge h{i};
      note_near(mesh.origin(h));
      if (!mesh.is_fixed(h) && !is_touched_[number(mesh::face(mesh.twin(h)))]) visit_beyond(triangulation, finder, h);
    }
  }
}

void Bridges::note_near(Vertex v) {
  if (is_near_[number(v)]) return;
  near_.push_back(v);
  is_near_[number(v)] = true;
}

void Bridges::visit_beyond(const Triangulation& triangulation, BridgeFinder& finder, HalfEdge border) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  auto& to_enter = scratch_.to_enter;
  scratch_.begin();
  to_enter.assign({mesh.twin(border)});
  while (!to_enter.empty()) {
    const HalfEdge entry = to_enter.back();
    to_enter.pop_back();
    if (!scratch_.visit(mesh::face(entry))) continue;
    note_near(mesh.apex(entry));
    for (const HalfEdge exit : {mesh::next(entry), mesh::previous(entry)}) {
      if (mesh.is_fixed(exit)) continue;
      const HalfEdge beyond = mesh.twin(exit);
      if (is_touched_[number(mesh::face(beyond))]) continue;
      if (finder.may_touch(finder.circle_of(beyond), border)) to_enter.push_back(beyond);
    }
  }
}

/// Finds the bridges that start at `v` again. An edge is a candidate only if both of its ends are near.
void Bridges::find_at(const Triangulation& triangulation, BridgeFinder& finder, Vertex v) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  mesh.for_each_outgoing(v, [&](HalfEdge h) {
    if (is_in_domain(triangulation, h)) find_at_corner(triangulation, finder, h);
    const Vertex other = mesh.target(h);
    if (mesh.is_fixed(h) || !is_near_[number(other)] || number(v) > number(other)) return;
    const bool is_one = finder.is_bridge(h);
    set_bridge(h, is_one);
    set_bridge(mesh.twin(h), is_one);
  });
}

void Bridges::find_at_corner(const Triangulation& triangulation, BridgeFinder& finder, HalfEdge corner) {
  const HalfEdge wall = finder.find_wall(corner);
  const std::uint32_t old = foot_at(corner);
  if (old != kNone) {
    if (feet_[old].wall == wall) return;
    remove_foot(old);
  }
  if (wall != mesh::kNoHalfEdge) insert_foot(triangulation, corner, wall);
}

void Bridges::set_bridge(HalfEdge h, bool is_bridge) {
  const std::uint32_t value = corners_[number(h)];
  write_corner(h, is_bridge ? value | kIsBridge : value & ~kIsBridge);
}

void Bridges::write_corner(HalfEdge h, std::uint32_t value) {
  if (corners_[number(h)] != value) corners_.write(number(h), value);
}

/// Inserts a foot bridge into the list of its wall, which is in the order of the feet.
void Bridges::insert_foot(const Triangulation& triangulation, HalfEdge corner, HalfEdge wall) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const auto position_of = [&](Vertex v) { return geometry.rounded(number(v)); };
  const WallLine line = wall_line(triangulation, wall);
  const Point here = position_of(mesh.origin(corner));
  std::uint32_t before = kNone;
  std::uint32_t at = first_foot_on(wall);
  while (at != kNone &&
         exact::dot(position_of(mesh.origin(feet_[at].corner)), here, line.from, line.to) == exact::Sign::positive) {
    before = std::exchange(at, feet_[at].next);
  }
  const std::uint32_t foot = add_foot({corner, wall, at});
  link(wall, before, foot);
  write_corner(corner, (foot + 1) << 1 | (corners_[number(corner)] & kIsBridge));
}

std::uint32_t Bridges::add_foot(const Foot& foot) {
  if (free_feet_.is_empty()) {
    feet_.append(foot);
    return static_cast<std::uint32_t>(feet_.size() - 1);
  }
  const std::uint32_t i = free_feet_.first();
  const std::uint32_t next_free = feet_[i].next;
  feet_.write(i, foot);
  free_feet_.pop(next_free);
  return i;
}

void Bridges::remove_foot(std::uint32_t foot) {
  const Foot removed = feet_[foot];
  std::uint32_t before = kNone;
  for (std::uint32_t at = first_foot_on(removed.wall); at != foot; at = feet_[at].next) before = at;
  link(removed.wall, before, removed.next);
  write_corner(removed.corner, corners_[number(removed.corner)] & kIsBridge);
  free_foot(foot);
}

// Calls write() before push(), because write() may run out of memory.
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
  use.bridges += (is_touched_.capacity() + is_near_.capacity()) / 8;
  memory::count_spare(use, touched_, near_, scratch_.to_enter, scratch_.to_cross);
  use.spare += scratch_.visited.size() * sizeof(std::uint32_t);
}

void Bridges::shrink_to_fit() {
  begin();  // empties the logs
  corners_.shrink_to_fit();
  walls_.shrink_to_fit();
  feet_.shrink_to_fit();
  memory::shrink(is_touched_, is_near_);
  memory::release(touched_, near_);
  scratch_ = {};
}

}  // namespace waywright::clearance
