#include "clearance/changed_region.hpp"

#include <algorithm>

#include "memory/count.hpp"

namespace waywright::clearance {

using mesh::Face;
using mesh::HalfEdge;

// Which bridges can change. The region R is the union of the touched faces. Let b be a bridge before the operation or
// after it, but not both, and let its corner or its edge belong to untouched faces only. If b ends at a wall that has
// changed, the face between b and this wall is touched. Otherwise, a wall blocks b in one state and not in the other.
// This wall lies in R, because all other walls are the same in both states. In the state in which b is a bridge, its
// closed disc D touches no wall except at the ends of b. Each vertex is the end of a wall. So D contains no vertex of
// an untouched face except the ends of b, and no other position of a wall on the border of R. The blocking wall
// therefore does not only touch D at the border of R. In all these cases the open disc D meets the interior of R.
//
// Let w be an end of b that is a vertex, and F the face at w into which b runs or, if b is an edge, one of its two
// faces. Among the positions inside D and R, choose one whose direction from w is as near to the direction of F as
// possible (the direction may differ from the best one by less than the angle of a face). The segment from w to it
// first meets R at a position q of an edge `border`: strictly inside D, and between the ends of that edge. The segment
// crosses only untouched faces and free edges. (If it starts in a touched face, that face is the touched face at w that
// is nearest to F; then q is a position near w on the edge of this face that is nearer to F.) Then:
//
// 1. Each face T that the segment crosses contains q strictly inside its circle. The disc D' that touches D at w from
//    inside and has q on its circle contains no vertex except w, so the vertices of T left and right of the segment lie
//    outside D'. If q were not strictly inside the circle of T, this circle would cut the segment twice between w and
//    q, and the circle of D' twice on the left and twice on the right of the segment. But two circles have at most two
//    common positions. So a search finds the face G at w in which the segment starts: it begins with the face beyond
//    `border`, crosses free edges, and enters an untouched face if its circle meets `border` strictly inside.
// 2. If G is not F, consider the edges from w to x1, x2, ..., xk between G and F, in this order from q. D contains none
//    of the vertices xi, except xk if b is the edge from w to xk. The disc whose diameter is the edge from w to xi
//    contains q strictly inside. If this edge is b, the disc is D. Otherwise, the circle of D meets the edge at a
//    position p before xi. Let v be the other end of b. The diameter of D leads from w to v, so the triangle w p v has
//    a right angle at p and an acute angle at v. The line through w and p separates q from v, and q lies strictly
//    inside D. So the angle at q between w and p is obtuse, and the disc whose diameter leads from w to p contains q
//    strictly inside. This disc lies inside the disc of the edge from w to xi. By the choice of q, no face
//    between G and F is touched, and no edge between them is a wall, because walls do not meet D. So the search, when
//    it leaves a face through an edge whose disc meets `border`, continues around both ends of the edge, as long as the
//    edges' discs meet `border`.
//
// If F is G, then F is a face that the search enters. If b is an edge of F, its disc D meets `border`.
//
// Most of these bridges do not change. The walls decide alone what a bridge is: b changes only if its closed disc
// touches a wall that the operation has inserted or removed. So the search notes only corners and edges for which such
// a disc may touch the box of a changed item. The code in bridges.cpp adds the corners of the bridges that it has
// removed because they end at touched faces.

void ChangedRegion::collect_faces(const Triangulation& triangulation) {
  mesh_ = &triangulation.topology();
  const std::size_t half_edges = std::size_t{3} * mesh_->face_slots();
  if (is_touched_.size() < mesh_->face_slots()) is_touched_.resize(mesh_->face_slots());
  if (is_corner_.size() < half_edges) is_corner_.resize(half_edges);
  if (is_edge_.size() < half_edges) is_edge_.resize(half_edges);
  mesh_->for_each_touched_face([&](Face f, mesh::TriangleMesh::Touch touch) {
    if (touch == mesh::TriangleMesh::Touch::relabelled || is_touched_[number(f)]) return;
    faces_.push_back(f);
    is_touched_[number(f)] = true;
  });
}

void ChangedRegion::collect_beyond(const Triangulation& triangulation, const ChangedWalls& changed,
                                   BridgeFinder& finder, BridgeScratch& scratch) {
  const Search search{changed, finder, scratch};
  for (const Face f : faces_) {
    if (!triangulation.triangulation().is_in_domain(f)) continue;
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      const HalfEdge h{i};
      if (!mesh_->is_fixed(h) && !is_border(h)) search_beyond(search, h);
    }
  }
}

void ChangedRegion::search_beyond(const Search& search, HalfEdge border) {
  auto& to_enter = search.scratch.to_enter;
  search.scratch.begin();
  to_enter.assign({mesh_->twin(border)});
  while (!to_enter.empty()) {
    const HalfEdge entry = to_enter.back();
    to_enter.pop_back();
    if (!search.scratch.visit(mesh::face(entry))) continue;
    if (search.may_change_foot_bridges(entry)) {
      for (const HalfEdge corner : {entry, mesh::next(entry), mesh::previous(entry)}) add_corner(corner);
    }
    for (const HalfEdge exit : {mesh::next(entry), mesh::previous(entry)}) {
      if (mesh_->is_fixed(exit) || is_border(exit)) continue;
      const HalfEdge beyond = mesh_->twin(exit);
      const bool is_disc_near = search.finder.may_disc_meet(exit, border);
      if (is_disc_near) note_edge(search, exit);
      if (search.finder.may_circle_meet(beyond, border)) {
        to_enter.push_back(beyond);
      } else if (is_disc_near) {
        follow_fan(search, beyond, border, true);
        follow_fan(search, beyond, border, false);
      }
    }
  }
}

/// Notes the corners and edges around an end of `h`: from the face of `h` on, counter-clockwise around its origin or
/// clockwise around its target, while the discs of the edges meet the border.
void ChangedRegion::follow_fan(const Search& search, HalfEdge h, HalfEdge border, bool is_counter_clockwise) {
  for (;;) {
    if (search.may_change_foot_bridges(h)) add_corner(is_counter_clockwise ? h : mesh::next(h));
    const HalfEdge exit = is_counter_clockwise ? mesh::previous(h) : mesh::next(h);
    if (mesh_->is_fixed(exit) || is_border(exit) || !search.finder.may_disc_meet(exit, border)) return;
    note_edge(search, exit);
    h = mesh_->twin(exit);
  }
}

bool ChangedRegion::Search::may_change_foot_bridges(HalfEdge h) const {
  return changed.are_all() || finder.may_foot_bridge_touch(h, changed.boxes());
}

void ChangedRegion::add_corner(HalfEdge corner) {
  if (is_corner_[number(corner)]) return;
  corners_.push_back(corner);
  is_corner_[number(corner)] = true;
}

void ChangedRegion::note_edge(const Search& search, HalfEdge h) {
  const HalfEdge smaller = std::min(h, mesh_->twin(h));
  if (is_edge_[number(smaller)]) return;
  if (!search.changed.are_all() && !search.finder.may_disc_touch(h, search.changed.boxes())) return;
  edges_.push_back(smaller);
  is_edge_[number(smaller)] = true;
}

void ChangedRegion::clear() {
  for (const Face f : faces_) is_touched_[number(f)] = false;
  for (const HalfEdge corner : corners_) is_corner_[number(corner)] = false;
  for (const HalfEdge h : edges_) is_edge_[number(h)] = false;
  faces_.clear();
  corners_.clear();
  edges_.clear();
}

void ChangedRegion::count_memory(MemoryUse& use) const {
  use.bridges += (is_touched_.capacity() + is_corner_.capacity() + is_edge_.capacity()) / 8;
  memory::count_spare(use, faces_, corners_, edges_);
}

void ChangedRegion::release() { memory::release(faces_, corners_, edges_, is_touched_, is_corner_, is_edge_); }

}  // namespace waywright::clearance
