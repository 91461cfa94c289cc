#pragma once

// The definitions of Triangulation's members, for the source files that instantiate it.

#include <utility>

#include "delaunay/divide_and_conquer.hpp"
#include "delaunay/remove_vertex.inl"
#include "delaunay/triangulation.hpp"
#include "memory/count.hpp"

namespace waywright::delaunay {

using mesh::first;
using mesh::next;
using mesh::number;
using mesh::previous;

// DivideAndConquer does not use the sectors. So a job can fill the sectors while DivideAndConquer runs.
template <class Geometry>
Triangulation<Geometry>::Triangulation(const Box& box, const std::array<mesh::Label, 4>& side_labels,
                                       locate::SortedPoints&& sorted, const threads::ThreadTeam& team,
                                       std::span<const threads::Job> jobs)
    : geometry_(box), sectors_(box), ghost_{DivideAndConquer<Geometry>::kGhost} {
  memory::Array<mesh::TriangleMesh::HalfEdgeRecord> half_edges;
  half_edges.reserve(memory::with_spare(6 * sorted.points.size() - 6));
  half_edges.resize(6 * sorted.points.size() - 6);
  std::vector<threads::Job> all_jobs(jobs.begin(), jobs.end());
  all_jobs.emplace_back([&] { sectors_.fill(sorted.points, sorted.keys, number(vertex_of_rank(0))); });
  DivideAndConquer<Geometry>(geometry_, sorted.points, sorted.keys, half_edges).run(team, all_jobs);
  const std::size_t vertex_count = sorted.points.size() + 1;
  sorted.keys = std::vector<locate::Curve::Key>();  // assigning {} would keep the memory
  sorted.points.push_front(Point{});                // the unused entry of the ghost
  set_positions(std::move(sorted.points));
  mesh_ = mesh::TriangleMesh(std::move(half_edges), vertex_count);
  for (std::size_t i = 0; i < 4; ++i) domain_corners_[i] = vertex_of_rank(sorted.ranks[i]);
  fix_border(side_labels);
  begin();
}

template <class Geometry>
void Triangulation<Geometry>::set_positions(memory::Array<Point>&& points) {
  if constexpr (requires { geometry_.set_positions(std::move(points)); }) {
    geometry_.set_positions(std::move(points));
  } else {
    for (std::uint32_t v = 0; v < points.size(); ++v) geometry_.set_position(v, points[v]);
  }
}

// The neighbours of the ghost vertex are the vertices on the border. Clockwise around the ghost vertex means
// counter-clockwise around the domain.
template <class Geometry>
void Triangulation<Geometry>::fix_border(const std::array<mesh::Label, 4>& side_labels) {
  mesh::HalfEdge h = mesh_.find(ghost_, domain_corners_[0]);
  for (std::size_t side = 0; side < 4; ++side) {
    do {
      h = mesh_.previous_around(h);
      mesh_.set_label(next(h), side_labels[side]);
    } while (mesh_.target(h) != domain_corners_[(side + 1) % 4]);
  }
  remember(h);
}

template <class Geometry>
void Triangulation<Geometry>::begin() {
  mesh_.begin();
  geometry_.begin();
  recent_before_ = recent_;
}

template <class Geometry>
void Triangulation<Geometry>::count_memory(MemoryUse& use) const {
  mesh_.count_memory(use);
  if constexpr (requires { geometry_.count_memory(use); }) geometry_.count_memory(use);
  sectors_.count_memory(use);
  memory::count_spare(use, in_doubt_, unfixed_, star_.spokes, star_.fixed, clockwise_, cavity_edges_, cavity_positions_,
                      triangles_);
  large_cavity_.count_memory(use);
  cavity_filler_.count_memory(use);
}

template <class Geometry>
void Triangulation<Geometry>::shrink_to_fit() {
  mesh_.shrink_to_fit();
  if constexpr (requires { geometry_.shrink_to_fit(); }) geometry_.shrink_to_fit();
  sectors_.shrink_to_fit();
  memory::release(in_doubt_, unfixed_, star_.spokes, star_.fixed, clockwise_, cavity_edges_, cavity_positions_,
                  triangles_);
  large_cavity_.release();
  cavity_filler_.release();
}

template <class Geometry>
void Triangulation<Geometry>::roll_back() {
  mesh_.roll_back();
  geometry_.roll_back();
  recent_ = recent_before_;
  unfixed_.clear();
}

template <class Geometry>
locate::Located Triangulation<Geometry>::locate(const Point& point) const {
  return locate(point, hint(point));
}

template <class Geometry>
locate::Located Triangulation<Geometry>::locate(const Point& point, mesh::HalfEdge start) const {
  return locate::walk(mesh_, geometry_, geometry_.view(point), point, mesh::face(start), ghost_);
}

/// Returns a half-edge of a face in the domain, near the point: the half-edge of the last change, or a half-edge at the
/// vertex that the point's sector remembers, whichever is nearer. If both are far away, the function also considers the
/// vertices that the surrounding sectors remember. The remembered vertex can be far away, for example because its slot
/// now belongs to another vertex.
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::hint(const Point& point) const {
  const auto squared_distance = [&](mesh::Vertex from) {
    const Point& position = geometry_.rounded(number(from));
    return (position.x - point.x) * (position.x - point.x) + (position.y - point.y) * (position.y - point.y);
  };
  mesh::Vertex nearest = mesh_.origin(recent_);
  double least = squared_distance(nearest);
  const auto consider = [&](mesh::Vertex v) {
    if (!mesh_.is_live(v)) return;
    const double distance = squared_distance(v);
    if (distance >= least) return;
    nearest = v;
    least = distance;
  };
  const locate::Sectors::Sector sector = sectors_.at(point);
  const mesh::Vertex v = sectors_.near(sector);
  if (v != mesh::kNoVertex) consider(v);
  if (sectors_.is_far(sector, least)) sectors_.for_each_around(sector, consider);
  if (nearest == mesh_.origin(recent_)) return recent_;
  const mesh::HalfEdge h = mesh_.outgoing(nearest);
  return is_ghost_face(h) ? twin_in_domain(h) : h;
}

/// Divides the point's sector after a long walk, if the vertex that the sector remembers lies in the sector. If a walk
/// from this vertex is long, the sector contains many vertices.
template <class Geometry>
void Triangulation<Geometry>::divide_sector(const Point& point) {
  const mesh::Vertex v = sectors_.near(sectors_.at(point));
  if (v == mesh::kNoVertex || !mesh_.is_live(v)) return;
  if (sectors_.are_in_one(point, geometry_.rounded(number(v)))) sectors_.divide(point, mesh_.vertex_count());
}

/// Returns a half-edge of the face in the domain that is adjacent to the ghost face of `h`.
template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::twin_in_domain(mesh::HalfEdge h) const {
  while (mesh_.apex(h) != ghost_) h = next(h);
  return mesh_.twin(h);
}

template <class Geometry>
typename Triangulation<Geometry>::Inserted Triangulation<Geometry>::insert(const Point& point) {
  const locate::Located location = locate(point);
  if (location.steps > kLongWalk) divide_sector(point);
  return insert(point, location);
}

template <class Geometry>
typename Triangulation<Geometry>::Inserted Triangulation<Geometry>::insert(const Point& point,
                                                                           const locate::Located& location) {
  if (location.kind == locate::LocatedKind::vertex) {
    remember(location.h);
    return {mesh_.origin(location.h), false, mesh::kNoHalfEdge};
  }
  // In a large world, an insertion spends most of its time waiting for memory. So the code first prefetches the
  // adjacent faces, and then makes the vertex.
  for (const mesh::HalfEdge h : {location.h, next(location.h), previous(location.h)}) prefetch_face_beyond(h);
  const mesh::Vertex v = add_vertex(point);
  const bool splits_fixed_edge = location.kind == locate::LocatedKind::edge && mesh_.is_fixed(location.h);
  const mesh::Vertex end = mesh_.origin(location.h);
  in_doubt_.clear();
  if (location.kind == locate::LocatedKind::face) {
    for (const mesh::HalfEdge h : mesh_.split_face(mesh::face(location.h), v)) in_doubt_.push_back(h);
  } else {
    for (const mesh::HalfEdge h : mesh_.split_edge(location.h, v)) {
      if (!is_ghost_face(h)) in_doubt_.push_back(h);
    }
  }
  legalise_around_apex();
  remember(mesh_.outgoing(v));
  return {v, true, splits_fixed_edge ? mesh_.find(v, end) : mesh::kNoHalfEdge, in_doubt_.size()};
}

template <class Geometry>
mesh::Vertex Triangulation<Geometry>::insert_crossing(mesh::HalfEdge h, mesh::Vertex a, mesh::Vertex b, mesh::Vertex c,
                                                      mesh::Vertex d) {
  const mesh::Vertex v = mesh_.add_vertex();
  geometry_.set_crossing(number(v), number(a), number(b), number(c), number(d));
  sectors_.remember(geometry_.rounded(number(v)), v, mesh_.vertex_count());
  in_doubt_.clear();
  for (const mesh::HalfEdge opposite : mesh_.split_edge(h, v)) in_doubt_.push_back(opposite);
  legalise_around_apex();
  return v;
}

template <class Geometry>
mesh::Vertex Triangulation<Geometry>::add_vertex(const Point& point) {
  const mesh::Vertex v = mesh_.add_vertex();
  geometry_.set_position(number(v), point);
  sectors_.remember(point, v, mesh_.vertex_count());
  return v;
}

// Uses a queue, because a chain of flips can be as long as the mesh is large. While an edge waits in the queue, the
// processor fetches the data beyond it. Source: Lawson, *Software for C1 surface interpolation*, 1977.
template <class Geometry>
void Triangulation<Geometry>::legalise_around_apex() {
  for (const mesh::HalfEdge h : in_doubt_) prefetch_apex_beyond(h);
  const View apex = view(mesh_.apex(in_doubt_.front()));
  for (std::size_t i = 0; i < in_doubt_.size(); ++i) {
    const mesh::HalfEdge h = in_doubt_[i];
    if (i + 1 < in_doubt_.size()) prefetch_apex_beyond(in_doubt_[i + 1]);
    if (mesh_.is_fixed(h) || delaunay::is_legal(geometry_, mesh_, h, apex)) continue;
    const auto flipped = mesh_.flip(h);
    for (const mesh::HalfEdge edge : {h, flipped.opposite}) {
      prefetch_face_beyond(edge);
      in_doubt_.push_back(edge);
    }
  }
}

template <class Geometry>
mesh::HalfEdge Triangulation<Geometry>::force_edge(mesh::Vertex u, mesh::Vertex w,
                                                   const std::vector<mesh::HalfEdge>& crossed, mesh::Label label) {
  const mesh::HalfEdge edge = cavity_filler_.force_edge(geometry_, mesh_, u, w, crossed, label);
  remember(edge);
  return edge;
}

template <class Geometry>
void Triangulation<Geometry>::remember(mesh::HalfEdge h) {
  recent_ = is_ghost_face(h) ? twin_in_domain(h) : h;
}

}  // namespace waywright::delaunay
