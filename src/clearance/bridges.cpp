#include "clearance/bridges.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <tuple>
#include <utility>

#include "clearance/walls.hpp"
#include "memory/count.hpp"

namespace waywright::clearance {

using mesh::Face;
using mesh::HalfEdge;
using mesh::Vertex;

namespace {

/// The value of `acute_` for a face outside the domain. No face of the domain has this value, because at least two of
/// its angles are acute.
constexpr std::uint8_t kNotInDomain = 0;

/// The line of a row, in an order of lines.
std::array<double, 4> line_of(const Feet::Row& row) {
  return {row.line_from.x, row.line_from.y, row.line_to.x, row.line_to.y};
}

}  // namespace

/// The destructor rolls the bridges back, unless keep() was called.
class Bridges::Guard {
 public:
  explicit Guard(Bridges& bridges) : bridges_(bridges) { bridges_.begin(); }
  ~Guard() {
    bridges_.region_.clear();
    for (const Vertex v : bridges_.made_) bridges_.is_made_[number(v)] = false;
    bridges_.made_.clear();
    if (!is_kept_) bridges_.roll_back();
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  void keep() { is_kept_ = true; }

 private:
  Bridges& bridges_;
  bool is_kept_ = false;
};

Bridges::Bridges(const Triangulation& triangulation, const SearchLimits& limits) : limits_(limits) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  grow_to_mesh(mesh);
  BridgeFinder finder(triangulation, scratch_, &tree_, limits_);
  const auto for_each_face = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
      if (triangulation.triangulation().is_in_domain(Face{i})) visit(Face{i});
    }
  };
  for_each_face([&](Face f) { note_angles(finder, f); });
  for_each_face([&](Face f) {
    find_at_corners(triangulation, finder, f);
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      const HalfEdge h{i};
      if (!mesh.is_fixed(h) && h < mesh.twin(h) && may_be_bridge(h, mesh.twin(h)))
        find_at_edge(triangulation, finder, h);
    }
    begin();  // empties the logs: no earlier state exists
  });
  shrink_to_fit();
}

std::uint64_t Bridges::new_state() {
  static std::atomic<std::uint64_t> last = 0;
  return last.fetch_add(1, std::memory_order_relaxed) + 1;
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
  tree_.begin();
  before_rebuild_.reset();
}

void Bridges::roll_back() {
  state_ = new_state();
  if (before_rebuild_) {
    swap_bridges(*before_rebuild_);
    return before_rebuild_.reset();
  }
  corners_.roll_back();
  walls_.roll_back();
  feet_.roll_back();
  tree_.roll_back();
}

void Bridges::update(const Triangulation& triangulation, const mesh::TouchedFaces& touched,
                     const ChangedWalls& changed) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  state_ = new_state();
  Guard guard(*this);
  if (touched.are_most_faces()) {
    rebuild(triangulation);
    guard.keep();
    return;
  }
  region_.begin(triangulation, touched);
  grow_to_mesh(mesh);
  note_made_vertices(mesh);
  loose_feet_.clear();
  loose_rows_.clear();
  for (const Face f : touched.faces()) clear_face(f);
  if (tree_.is_built()) tree_.update(triangulation, touched);
  BridgeFinder finder(triangulation, scratch_, &tree_, limits_);
  keep_feet(triangulation, changed, finder);
  move_rows(triangulation);
  find_in_touched(triangulation, changed, finder);
  find_beyond(triangulation, changed, finder);
  guard.keep();
}

/// Rebuilds the bridges. If most faces are touched, this costs less than an update of each touched face.
void Bridges::rebuild(const Triangulation& triangulation) {
  auto rebuilt = std::make_unique<Bridges>(triangulation, limits_);
  swap_bridges(*rebuilt);
  before_rebuild_ = std::move(rebuilt);
}

/// Swaps the bridges, without the scratch.
void Bridges::swap_bridges(Bridges& other) {
  std::swap(corners_, other.corners_);
  std::swap(walls_, other.walls_);
  std::swap(feet_, other.feet_);
  std::swap(tree_, other.tree_);
}

void Bridges::note_made_vertices(const mesh::TriangleMesh& mesh) {
  if (is_made_.size() < mesh.vertex_slots()) is_made_.resize(mesh.vertex_slots());
  mesh.for_each_touched_vertex([&](Vertex v, mesh::TriangleMesh::Touch touch) {
    if (touch != mesh::TriangleMesh::Touch::made || is_made_[number(v)]) return;
    made_.push_back(v);
    is_made_[number(v)] = true;
  });
}

/// Empties the entries of a touched face: notes the feet and rows in `loose_feet_` and `loose_rows_`.
void Bridges::clear_face(Face f) {
  const std::uint32_t first = 3 * number(f);
  const std::uint32_t of_corners = corners_[first] | corners_[first + 1] | corners_[first + 2];
  if ((of_corners | walls_[first] | walls_[first + 1] | walls_[first + 2]) == 0) return;
  for (std::uint32_t i = first; i < first + 3; ++i) {
    if (const std::uint32_t foot = foot_at(HalfEdge{i}); foot != kNone) loose_feet_.push_back(foot);
    write_corner(HalfEdge{i}, 0);
    if (walls_[i] == 0) continue;
    const Feet::Row& row = feet_.row(walls_[i] - 1);
    loose_rows_.push_back({row.from, row.to, walls_[i] - 1});
    walls_.write(i, 0);
  }
}

exact::Gap Bridges::gap_of(const Triangulation& triangulation, std::uint32_t foot) const {
  const Feet::Row& row = feet_.row(feet_.row_of(foot));
  const Point& from = triangulation.triangulation().geometry().rounded(number(feet_.foot(foot).from));
  return {from, row.line_from, row.line_to};
}

/// Returns whether the bridge surely exists now as before. If no changed wall touches its closed disc, the disc touches
/// the same walls as before.
bool Bridges::is_kept(const Triangulation& triangulation, const ChangedWalls& changed, const BridgeFinder& finder,
                      std::uint32_t foot) const {
  if (changed.are_all()) return false;
  const exact::Gap gap = gap_of(triangulation, foot);
  return !finder.may_touch(Disc::of_gap(gap.from, gap.a, gap.b), changed);
}

/// Collects the loose feet that stay in `kept_feet_`, and removes the others.
void Bridges::keep_feet(const Triangulation& triangulation, const ChangedWalls& changed, const BridgeFinder& finder) {
  kept_feet_.clear();
  for (const std::uint32_t foot : loose_feet_) {
    const Vertex from = feet_.foot(foot).from;
    if (!is_lost(triangulation.topology(), from) && is_kept(triangulation, changed, finder, foot)) {
      kept_feet_.push_back({from, foot});
    } else {
      remove_foot(foot);
    }
  }
  std::sort(kept_feet_.begin(), kept_feet_.end(),
            [](const KeptFoot& p, const KeptFoot& q) { return std::pair(p.from, p.foot) < std::pair(q.from, q.foot); });
}

/// Gives the loose rows to the walls that exist now. If the two ends of a wall have not changed, the wall has not
/// changed. Otherwise deal_out_feet() looks for the walls on the line of the row.
void Bridges::move_rows(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  std::erase_if(loose_rows_, [&](const LooseRow& loose) { return feet_.row(loose.row).wall == mesh::kNoHalfEdge; });
  if (loose_rows_.empty()) return;
  const auto ends = [](const LooseRow& loose) { return std::pair(loose.from, loose.to); };
  std::sort(loose_rows_.begin(), loose_rows_.end(),
            [&](const LooseRow& p, const LooseRow& q) { return ends(p) < ends(q); });
  for (const Face f : region_.touched().faces()) {
    if (!triangulation.triangulation().is_in_domain(f)) continue;
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      const HalfEdge h{i};
      if (!mesh.is_fixed(h)) continue;
      const std::pair wanted(mesh.origin(h), mesh.target(h));
      const auto at = std::lower_bound(loose_rows_.begin(), loose_rows_.end(), wanted,
                                       [&](const LooseRow& loose, const auto& pair) { return ends(loose) < pair; });
      if (at == loose_rows_.end() || ends(*at) != wanted) continue;
      if (is_lost(mesh, wanted.first) || is_lost(mesh, wanted.second)) continue;
      put_row_on(mesh, at->row, h);
      at->row = kNone;
    }
  }
  lost_rows_.clear();
  for (const LooseRow& loose : loose_rows_) {
    if (loose.row != kNone) lost_rows_.push_back(loose.row);
  }
  if (lost_rows_.empty()) return;
  collect_new_walls(triangulation);
  std::size_t wall = 0;
  for (std::size_t begin = 0; begin < lost_rows_.size();) {
    std::size_t end = begin + 1;
    while (end < lost_rows_.size() && line_of(feet_.row(lost_rows_[begin])) == line_of(feet_.row(lost_rows_[end])))
      ++end;
    std::size_t last_wall = wall;
    while (last_wall < new_walls_.size() && new_walls_[last_wall].row == begin) ++last_wall;
    deal_out_feet(triangulation, {lost_rows_.data() + begin, end - begin},
                  {new_walls_.data() + wall, last_wall - wall});
    wall = last_wall;
    begin = end;
  }
  std::erase_if(kept_feet_, [&](const KeptFoot& kept) {
    return feet_.foot(kept.foot).corner == mesh::kNoHalfEdge;  // drop_tree() has removed it
  });
}

void Bridges::put_row_on(const mesh::TriangleMesh& mesh, std::uint32_t row, HalfEdge wall) {
  Feet::Row changed = feet_.row(row);
  changed.wall = wall;
  changed.from = mesh.origin(wall);
  changed.to = mesh.target(wall);
  feet_.set_row(row, changed);
  walls_.write(number(wall), row + 1);
}

/// Sorts `lost_rows_`, and collects in `new_walls_` the walls of touched faces that have no row but a side on the line
/// of a lost row.
void Bridges::collect_new_walls(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  std::sort(lost_rows_.begin(), lost_rows_.end(), [&](std::uint32_t p, std::uint32_t q) {
    return std::pair(line_of(feet_.row(p)), p) < std::pair(line_of(feet_.row(q)), q);
  });
  new_walls_.clear();
  for (const Face f : region_.touched().faces()) {
    if (!triangulation.triangulation().is_in_domain(f)) continue;
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      const HalfEdge h{i};
      if (!mesh.is_fixed(h) || walls_[i] != 0) continue;
      bool is_found = false;
      triangulation.for_each_side(h, [&](const constraint::Side& side) {
        if (is_found) return;
        const WallLine line = wall_line(triangulation, h, side);
        const std::array wanted = {line.from.x, line.from.y, line.to.x, line.to.y};
        const auto at =
            std::lower_bound(lost_rows_.begin(), lost_rows_.end(), wanted,
                             [&](std::uint32_t row, const auto& values) { return line_of(feet_.row(row)) < values; });
        is_found = at != lost_rows_.end() && line_of(feet_.row(*at)) == wanted;
        if (is_found) new_walls_.push_back({static_cast<std::size_t>(at - lost_rows_.begin()), h});
      });
    }
  }
  std::sort(new_walls_.begin(), new_walls_.end(), [&](const NewWall& p, const NewWall& q) {
    if (p.row != q.row) return p.row < q.row;
    const Feet::Row& row = feet_.row(lost_rows_[p.row]);
    const bool is_up = std::tie(row.line_from.x, row.line_from.y) < std::tie(row.line_to.x, row.line_to.y);
    const Vertex from = mesh.origin((is_up ? p : q).wall);
    const Vertex to = mesh.origin((is_up ? q : p).wall);
    return geometry.order(geometry.view(number(from)), geometry.view(number(to))) < 0;
  });
}

/// Gives the feet of the rows on one line to the walls on this line. Drops the feet that lie on no wall.
void Bridges::deal_out_feet(const Triangulation& triangulation, std::span<std::uint32_t> rows,
                            std::span<const NewWall> walls) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const Feet::Row line = feet_.row(rows.front());
  const auto start_of = [&](std::uint32_t foot) { return geometry.rounded(number(feet_.foot(foot).from)); };
  std::sort(rows.begin(), rows.end(), [&](std::uint32_t p, std::uint32_t q) {
    return p != q && exact::dot(start_of(feet_.row(p).root), start_of(feet_.row(q).root), line.line_from,
                                line.line_to) == exact::Sign::positive;
  });
  std::uint32_t tree = 0;
  for (const std::uint32_t row : rows) tree = feet_.join(tree, feet_.take(row));
  const auto take_before = [&](Vertex v) {
    const Feet::Parts parts = feet_.split(tree, [&](std::uint32_t foot) {
      return exact::dot(start_of(foot), geometry.exact(number(v)), line.line_from, line.line_to) ==
             exact::Sign::positive;
    });
    tree = parts.after;
    return parts.before;
  };
  for (const NewWall& wall : walls) {
    drop_tree(take_before(mesh.origin(wall.wall)));
    const std::uint32_t on_wall = take_before(mesh.target(wall.wall));
    if (on_wall == 0) continue;
    put_row_on(mesh, feet_.add_row({wall.wall, {}, {}, on_wall - 1, line.line_from, line.line_to}), wall.wall);
  }
  drop_tree(tree);
}

/// Removes feet that lie on no wall any more, and looks again at their corners.
void Bridges::drop_tree(std::uint32_t tree) {
  if (tree == 0) return;
  feet_.free_tree(tree, [&](HalfEdge corner) {
    if (region_.touched().contains(mesh::face(corner))) return;
    write_corner(corner, corners_[number(corner)] & kIsBridge);
    region_.add_corner(corner);
  });
}

/// Gives the corner the kept foot whose bridge runs into its face, if there is one.
void Bridges::adopt(const Triangulation& triangulation, const BridgeFinder& finder, HalfEdge corner) {
  const Vertex from = triangulation.topology().origin(corner);
  if (from < kept_feet_.front().from || kept_feet_.back().from < from) return;
  auto at = std::lower_bound(kept_feet_.begin(), kept_feet_.end(), from,
                             [](const KeptFoot& kept, Vertex v) { return kept.from < v; });
  for (; at != kept_feet_.end() && at->from == from; ++at) {
    if (at->foot == kNone || !finder.has_foot_on(gap_of(triangulation, at->foot), corner, wall_of(at->foot))) continue;
    const std::uint32_t foot = std::exchange(at->foot, kNone);
    feet_.set_corner(foot, corner);
    write_corner(corner, (foot + 1) << 1 | (corners_[number(corner)] & kIsBridge));
    return;
  }
}

/// Finds the bridges along the edges of the touched faces, and the foot bridges from the corners of these faces.
///
/// If the other face of an edge is not touched, the half-edge in that face still says whether the edge was a bridge
/// before the operation. The edge is a bridge now if and only if it was one before, unless a changed wall touches its
/// closed disc.
void Bridges::find_in_touched(const Triangulation& triangulation, const ChangedWalls& changed, BridgeFinder& finder) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto is_in_domain = [&](Face f) { return triangulation.triangulation().is_in_domain(f); };
  for (const Face f : region_.touched().faces()) {
    acute_[number(f)] = kNotInDomain;
    if (!is_in_domain(f)) continue;
    note_angles(finder, f);
    if (!kept_feet_.empty()) {
      for_each_corner_with_foot(f, [&](HalfEdge corner) { adopt(triangulation, finder, corner); });
    }
  }
  for (const Face f : region_.touched().faces()) {
    if (acute_[number(f)] == kNotInDomain) continue;
    find_at_corners(triangulation, finder, f);
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
void Bridges::find_at_corners(const Triangulation& triangulation, BridgeFinder& finder, Face f) {
  for_each_corner_with_foot(f, [&](HalfEdge corner) {
    if (foot_at(corner) == kNone) find_at_corner(triangulation, finder, corner);
  });
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
  for (const HalfEdge corner : region_.corners()) {
    const Face f = mesh::face(corner);
    const unsigned corners = BridgeFinder::corners_with_foot(finder.acute_angles(f));
    if ((corners >> mesh::index_in(f, corner) & 1) == 0) continue;  // no bridge starts there, before and after
    const std::uint32_t foot = foot_at(corner);
    if (foot != kNone && is_kept(triangulation, changed, finder, foot)) continue;
    find_at_corner(triangulation, finder, corner);
  }
  for (const HalfEdge h : region_.edges()) find_at_edge(triangulation, finder, h);
}

/// Finds the wall of a foot bridge that crosses many edges. Often the bridges of neighbours end on the same wall.
HalfEdge Bridges::find_far_wall(const mesh::TriangleMesh& mesh, BridgeFinder& finder, HalfEdge corner) const {
  HalfEdge last = mesh::kNoHalfEdge;
  for (const HalfEdge edge : {corner, mesh::next(corner), mesh::previous(corner)}) {
    const HalfEdge twin = mesh.twin(edge);
    for (const HalfEdge near : {edge, twin, mesh::next(twin), mesh::previous(twin)}) {
      const std::uint32_t foot = foot_at(near);
      if (foot == kNone || std::exchange(last, wall_of(foot)) == wall_of(foot)) continue;
      if (finder.is_far_wall(corner, last)) return last;
    }
  }
  return finder.find_far_wall(corner);
}

void Bridges::find_at_corner(const Triangulation& triangulation, BridgeFinder& finder, HalfEdge corner) {
  HalfEdge wall = finder.find_wall(corner);
  if (wall == BridgeFinder::kTooFar) wall = find_far_wall(triangulation.topology(), finder, corner);
  const std::uint32_t old = foot_at(corner);
  if (old != kNone) {
    if (wall_of(old) == wall) return;
    remove_foot(old);
    write_corner(corner, corners_[number(corner)] & kIsBridge);
  }
  if (wall != mesh::kNoHalfEdge) add_foot(triangulation, corner, wall);
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

/// Makes a foot bridge.
void Bridges::add_foot(const Triangulation& triangulation, HalfEdge corner, HalfEdge wall) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const std::uint32_t foot = feet_.add(corner, mesh.origin(corner));
  write_corner(corner, (foot + 1) << 1 | (corners_[number(corner)] & kIsBridge));
  if (walls_[number(wall)] == 0) {
    const WallLine line = wall_line(triangulation, wall);
    const std::uint32_t row = feet_.add_row({wall, mesh.origin(wall), mesh.target(wall), foot, line.from, line.to});
    walls_.write(number(wall), row + 1);
    return;
  }
  const std::uint32_t row = walls_[number(wall)] - 1;
  const Feet::Row line = feet_.row(row);
  const auto start_of = [&](std::uint32_t of) { return geometry.rounded(number(feet_.foot(of).from)); };
  feet_.insert(row, foot, [&](std::uint32_t other) {
    return exact::dot(start_of(other), start_of(foot), line.line_from, line.line_to) == exact::Sign::positive;
  });
}

/// Takes a foot out of its row, but not out of its corner. If the wall of the row is not known yet, because the
/// operation has touched its face, no wall has the row.
void Bridges::remove_foot(std::uint32_t foot) {
  const HalfEdge wall = feet_.row(feet_.row_of(foot)).wall;
  const std::uint32_t empty = feet_.remove(foot);
  if (empty != kNone && walls_[number(wall)] == empty + 1) walls_.write(number(wall), 0);
}

std::optional<std::string> Bridges::find_fault(const Triangulation& triangulation) const {
  const Bridges rebuilt(triangulation);
  const auto wall_at = [](const Bridges& bridges, HalfEdge h) {
    const std::uint32_t foot = bridges.foot_at(h);
    return foot == kNone ? mesh::kNoHalfEdge : bridges.wall_of(foot);
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
    for (; p != kNone && q != kNone; p = next_foot(p), q = rebuilt.next_foot(q)) {
      if (corner_of(p) != rebuilt.corner_of(q)) return fault_at("the order of the feet", i);
    }
    if (p != q) return fault_at("the number of feet", i);
    const std::uint32_t foot = foot_at(h);
    const mesh::TriangleMesh& mesh = triangulation.topology();
    if (foot != kNone && (corner_of(foot) != h || feet_.foot(foot).from != mesh.origin(h)))
      return fault_at("the foot", i);
    if (number(h) >= walls_.size() || walls_[i] == 0) continue;
    const Feet::Row& row = feet_.row(walls_[i] - 1);
    if (row.wall != h || row.from != mesh.origin(h) || row.to != mesh.target(h)) return fault_at("the row", i);
  }
  if (!feet_.is_valid()) return "the trees of the feet are wrong";
  return tree_.find_fault(triangulation);
}

void Bridges::count_memory(MemoryUse& use) const {
  corners_.count_memory(use, &MemoryUse::bridges);
  walls_.count_memory(use, &MemoryUse::bridges);
  feet_.count_memory(use);
  tree_.count_memory(use);
  region_.count_memory(use);
  memory::count_spare(use, made_, loose_feet_, loose_rows_, lost_rows_, new_walls_, kept_feet_);
  use.spare += acute_.size() + is_made_.capacity() / 8;
  scratch_.count_memory(use);
}

void Bridges::shrink_to_fit() {
  state_ = new_state();  // the numbers of slots may have changed
  begin();               // empties the logs
  corners_.shrink_to_fit();
  walls_.shrink_to_fit();
  feet_.shrink_to_fit();
  tree_.shrink_to_fit();
  region_.release();
  memory::release(made_, is_made_, loose_feet_, loose_rows_, lost_rows_, new_walls_, kept_feet_);
  acute_ = {};
  scratch_ = {};
}

}  // namespace waywright::clearance
