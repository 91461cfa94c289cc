#include "clearance/changed_region.hpp"

#include <algorithm>

#include "memory/count.hpp"

namespace waywright::clearance {

using mesh::HalfEdge;

// Which bridges can change. A face is *touched* if the operation has made, rebuilt or freed it. A disc or a circle
// touches a wall if they have a position in common. The region R is the union of the touched faces. Let b be a bridge
// before the operation or after it, but not both, and let its corner or its edge belong to untouched faces only. The
// walls decide alone what a bridge is. So the closed disc D of b touches a wall that the operation has inserted or
// removed, at a position t that is no vertex at which b ends: this wall blocks b in the other state, or b ends on this
// wall. In the state in which b is a bridge, D touches no wall except at the ends of b. Each vertex is the end of a
// wall. So D contains no vertex of an untouched face except the ends of b. Both faces of a changed wall are touched, so
// t lies in the interior of R or, if this wall lies on the border of the domain, on the border of R.
//
// Let w be an end of b that is a vertex, and F the face at w into which b runs or, if b is an edge, the one of its two
// faces that is nearer to t. The segment from w to t lies in D, so it touches no wall before t. Let G be the face at w
// in which it starts. If G is not touched, the segment first meets R at a position q of an edge `border`: strictly
// inside D, and between the ends of that edge. Before q, it crosses only untouched faces and free edges. Then:
//
// 1. The circle of each face T that the segment crosses before q contains q and t strictly inside. The disc D' that
//    touches D at w from inside and has t on its circle contains no vertex except the ends of b, and at most one of
//    these two is a vertex of T left or right of the segment. If t were not strictly inside the circle of T, the circle
//    of T would meet the segment twice up to t. Left of the segment, it would run from one of these two positions to a
//    vertex of T, which is not inside D', and back to the other position. It would do so right of the segment, too. So
//    it would meet the circle of D' at least three times: twice on the left and twice on the right or, if one of the
//    two positions is w, at w, once on the left and once on the right. But two circles have at most two common
//    positions. As t and a position before q are inside the circle, q is, too. So a search finds G: it begins with the
//    face beyond `border`, crosses free edges, and enters an untouched face if a position of `border`, other
//    than its ends, lies strictly inside the circle of the face, and this circle touches a changed wall.
// 2. If G is not F, consider the edges from w to x1, x2, ..., xk between G and F, in this order from t. D contains none
//    of the vertices xi, except xk if b is the edge from w to xk. The edge from w to xi divides D into two pieces. The
//    piece that contains q and t lies in the disc whose diameter is this edge: the circle of D meets the edge at a
//    position p before xi or at xi. Let e be the end, other than w, of the diameter of D through w. It lies in the
//    other piece, and the angle at e between w and p is acute. So the angle between w and p at t is not acute, and at q
//    it is obtuse. If b is the edge from w to xk, its disc is D. No edge between G and F is a wall, because walls do
//    not meet D. So the search, when it leaves a face through an edge whose disc meets `border` and touches a changed
//    wall, goes around both ends of this edge, from one edge to the next, as long as the disc of the next edge also
//    meets `border` and touches a changed wall.
// 3. Suppose that a face at w between the direction of t and F is touched (perhaps G). Go around w from the direction
//    of t to F, and take the last touched face. Let `border` be the one of its two edges at w that is nearer to F, and
//    q a position of this edge near w. The face beyond `border` is the first face of the search. The disc whose
//    diameter is `border` contains t, as in 2, and the search continues around w as in 2.
//
// At a vertex with many edges, 2 and 3 need not go around: BridgeFinder::find_far_bridges() finds the bridges of the
// vertex whose discs touch changed walls. It does not find old bridges that ended on walls that have gone: Bridges
// drops their feet and looks at their corners.
//
// So the search notes all corners of each face whose circle may touch the box of a changed item, each edge whose disc
// may meet `border` and touch such a box, and the corners and edges that it passes when it goes around an end of an
// edge. Let r be the radius of the circle of a face, and 2 s the length of one of its edges. The disc of this edge lies
// in the disc that has the centre of the circle and whose radius is the sum of s and of the square root of r^2 - s^2.
// This sum is at most sqrt(2) r. So before the search enters the first face beyond `border`, it tests the disc of the
// radius sqrt(2) r. If this disc touches no box, there is no search beyond `border`. The code in bridges.cpp adds the
// corners of the bridges that it has removed because they end at touched faces.

void ChangedRegion::begin(const Triangulation& triangulation, const mesh::TouchedFaces& touched) {
  mesh_ = &triangulation.topology();
  touched_ = &touched;
  const std::size_t half_edges = std::size_t{3} * mesh_->face_slots();
  if (is_corner_.size() < half_edges) is_corner_.resize(half_edges);
  if (is_edge_.size() < half_edges) is_edge_.resize(half_edges);
}

void ChangedRegion::collect_beyond(const ChangedWalls& changed, BridgeFinder& finder, BridgeScratch& scratch) {
  const Search search{changed, finder, scratch};
  for (const HalfEdge h : border_) search_beyond(search, h);
}

void ChangedRegion::search_beyond(const Search& search, HalfEdge border) {
  const HalfEdge first = mesh_->twin(border);
  const Disc circle = search.finder.circle_of(first);
  if (!search.may_touch(circle.scaled(0x1.6a09e667f3bcdp+0))) return;  // the square root of 2, rounded up
  const bool is_first_near = search.may_touch(circle);
  if (!is_first_near && search.may_touch(search.finder.disc_of(border))) add_corners({first, mesh::next(first)});
  auto& to_enter = search.scratch.to_enter;
  search.scratch.begin();
  to_enter.clear();
  to_enter.push_back(first);
  while (!to_enter.empty()) {
    const HalfEdge entry = to_enter.back();
    to_enter.pop_back();
    if (!search.scratch.visit(mesh::face(entry))) continue;
    const bool is_circle_near = is_first_near || entry != first;
    if (is_circle_near) add_corners({entry, mesh::next(entry), mesh::previous(entry)});
    for (const HalfEdge exit : {mesh::next(entry), mesh::previous(entry)}) {
      if (mesh_->is_fixed(exit) || is_border(exit)) continue;
      const bool is_disc_near = search.may_be_near(exit, border);
      if (is_disc_near) add_edge(exit);
      if (!is_circle_near && !is_disc_near) continue;
      const HalfEdge beyond = mesh_->twin(exit);
      if (search.may_touch(search.finder.circle_of(beyond)) && search.finder.may_circle_meet(beyond, border)) {
        to_enter.push_back(beyond);
      } else if (is_disc_near) {
        follow_fan(search, beyond, border, true);
        follow_fan(search, beyond, border, false);
      }
    }
  }
}

/// Notes the corners and edges around an end of `h`: from the face of `h` on, counter-clockwise around its origin or
/// clockwise around its target, while the discs of the edges meet the border and touch changed walls. After
/// SearchLimits::spokes edges, visit_hub() finds the bridges of the vertex.
void ChangedRegion::follow_fan(const Search& search, HalfEdge h, HalfEdge border, bool is_counter_clockwise) {
  const mesh::Vertex hub = is_counter_clockwise ? mesh_->origin(h) : mesh_->target(h);
  if (search.finder.starts_no_bridge(hub)) return;
  const std::uint32_t most_spokes = search.finder.limit(&SearchLimits::spokes);
  for (std::uint32_t spokes = 0;; ++spokes) {
    if (spokes == most_spokes && !search.changed.are_all()) return visit_hub(search, hub);
    add_corner(is_counter_clockwise ? h : mesh::next(h));
    const HalfEdge exit = is_counter_clockwise ? mesh::previous(h) : mesh::next(h);
    if (mesh_->is_fixed(exit) || is_border(exit) || !search.may_be_near(exit, border)) return;
    add_edge(exit);
    h = mesh_->twin(exit);
  }
}

/// Notes the corners and edges at a vertex with many edges.
void ChangedRegion::visit_hub(const Search& search, mesh::Vertex w) {
  if (std::find(hubs_.begin(), hubs_.end(), w) != hubs_.end()) return;
  hubs_.push_back(w);
  search.finder.find_far_bridges(
      w, search.changed, [&](HalfEdge h) { add_edge(h); }, [&](HalfEdge corner) { add_corner(corner); });
}

void ChangedRegion::add_corner(HalfEdge corner) {
  if (is_corner_[number(corner)]) return;
  corners_.push_back(corner);
  is_corner_[number(corner)] = true;
}

void ChangedRegion::add_corners(std::initializer_list<HalfEdge> corners) {
  for (const HalfEdge corner : corners) add_corner(corner);
}

void ChangedRegion::add_edge(HalfEdge h) {
  const HalfEdge smaller = std::min(h, mesh_->twin(h));
  if (is_edge_[number(smaller)]) return;
  edges_.push_back(smaller);
  is_edge_[number(smaller)] = true;
}

void ChangedRegion::clear() {
  for (const HalfEdge corner : corners_) is_corner_[number(corner)] = false;
  for (const HalfEdge h : edges_) is_edge_[number(h)] = false;
  border_.clear();
  corners_.clear();
  edges_.clear();
  hubs_.clear();
}

void ChangedRegion::count_memory(MemoryUse& use) const {
  use.bridges += (is_corner_.capacity() + is_edge_.capacity()) / 8;
  memory::count_spare(use, border_, corners_, edges_, hubs_);
}

void ChangedRegion::release() { memory::release(border_, corners_, edges_, hubs_, is_corner_, is_edge_); }

}  // namespace waywright::clearance
