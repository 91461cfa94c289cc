#include "delaunay/triangulation.hpp"

#include <algorithm>
#include <utility>

#include "delaunay/divide_and_conquer.hpp"
#include "memory/count.hpp"

namespace waywright::delaunay {

using mesh::first;
using mesh::next;
using mesh::number;
using mesh::previous;

// DivideAndConquer does not use the sectors. So a job can fill the sectors while DivideAndConquer runs.
Triangulation::Triangulation(const Box& box, const std::array<mesh::Label, 4>& side_labels,
                             locate::SortedPoints&& sorted, const threads::ThreadTeam& team,
                             std::span<const threads::Job> jobs)
    : geometry_(box), sectors_(box), ghost_{DivideAndConquer::kGhost} {
  memory::Array<mesh::TriangleMesh::HalfEdgeRecord> half_edges;
  half_edges.reserve(memory::with_spare(6 * sorted.points.size() - 6));
  half_edges.resize(6 * sorted.points.size() - 6);
  std::vector<threads::Job> all_jobs(jobs.begin(), jobs.end());
  all_jobs.emplace_back([&] { sectors_.fill(sorted.points, sorted.keys, number(vertex_of_rank(0))); });
  DivideAndConquer(geometry_, sorted.points, sorted.keys, half_edges).run(team, all_jobs);
  const std::size_t vertex_count = sorted.points.size() + 1;
  sorted.keys = std::vector<locate::Curve::Key>();  // assigning {} would keep the memory
  sorted.points.push_front(Point{});                // the unused entry of the ghost
  geometry_.set_positions(std::move(sorted.points));
  mesh_ = mesh::TriangleMesh(std::move(half_edges), vertex_count);
  for (std::size_t i = 0; i < 4; ++i) domain_corners_[i] = vertex_of_rank(sorted.ranks[i]);
  fix_border(side_labels);
  begin();
}

// The neighbours of the ghost vertex are the vertices on the border. Clockwise around the ghost vertex means
// counter-clockwise around the domain.
void Triangulation::fix_border(const std::array<mesh::Label, 4>& side_labels) {
  mesh::HalfEdge h = mesh_.find(ghost_, domain_corners_[0]);
  for (std::size_t side = 0; side < 4; ++side) {
    do {
      h = mesh_.previous_around(h);
      mesh_.set_label(next(h), side_labels[side]);
    } while (mesh_.target(h) != domain_corners_[(side + 1) % 4]);
  }
  remember(h);
}

void Triangulation::begin() {
  mesh_.begin();
  geometry_.begin();
  recent_before_ = recent_;
}

void Triangulation::count_memory(MemoryUse& use) const {
  mesh_.count_memory(use);
  geometry_.count_memory(use);
  sectors_.count_memory(use);
  memory::count_spare(use, in_doubt_, unfixed_, star_.spokes, star_.fixed, clockwise_, cavity_edges_, cavity_positions_,
                      triangles_);
  large_cavity_.count_memory(use);
  cavity_filler_.count_memory(use);
}

void Triangulation::shrink_to_fit() {
  mesh_.shrink_to_fit();
  geometry_.shrink_to_fit();
  sectors_.shrink_to_fit();
  memory::release(in_doubt_, unfixed_, star_.spokes, star_.fixed, clockwise_, cavity_edges_, cavity_positions_,
                  triangles_);
  large_cavity_.release();
  cavity_filler_.release();
}

void Triangulation::roll_back() {
  mesh_.roll_back();
  geometry_.roll_back();
  recent_ = recent_before_;
  unfixed_.clear();
}

locate::Located Triangulation::locate(const Point& point) const { return locate(point, hint(point)); }

locate::Located Triangulation::locate(const Point& point, mesh::HalfEdge start) const {
  return locate::walk(mesh_, geometry_, geometry_.view(point), point, mesh::face(start), ghost_);
}

/// Returns a half-edge of a face in the domain, near the point: the half-edge of the last change, or a half-edge at the
/// vertex that the point's sector remembers, whichever is nearer. If both are far away, the function also considers the
/// vertices that the surrounding sectors remember. The remembered vertex can be far away, for example because its slot
/// now belongs to another vertex.
mesh::HalfEdge Triangulation::hint(const Point& point) const {
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
void Triangulation::divide_sector(const Point& point) {
  const mesh::Vertex v = sectors_.near(sectors_.at(point));
  if (v == mesh::kNoVertex || !mesh_.is_live(v)) return;
  if (sectors_.are_in_one(point, geometry_.rounded(number(v)))) sectors_.divide(point, mesh_.vertex_count());
}

/// Returns a half-edge of the face in the domain that is adjacent to the ghost face of `h`.
mesh::HalfEdge Triangulation::twin_in_domain(mesh::HalfEdge h) const {
  while (mesh_.apex(h) != ghost_) h = next(h);
  return mesh_.twin(h);
}

Triangulation::Inserted Triangulation::insert(const Point& point) {
  const locate::Located location = locate(point);
  if (location.steps > kLongWalk) divide_sector(point);
  return insert(point, location);
}

Triangulation::Inserted Triangulation::insert(const Point& point, const locate::Located& location) {
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

mesh::Vertex Triangulation::insert_crossing(mesh::HalfEdge h, mesh::Vertex a, mesh::Vertex b, mesh::Vertex c,
                                            mesh::Vertex d) {
  const mesh::Vertex v = mesh_.add_vertex();
  geometry_.set_crossing(number(v), number(a), number(b), number(c), number(d));
  sectors_.remember(geometry_.rounded(number(v)), v, mesh_.vertex_count());
  in_doubt_.clear();
  for (const mesh::HalfEdge opposite : mesh_.split_edge(h, v)) in_doubt_.push_back(opposite);
  legalise_around_apex();
  return v;
}

mesh::Vertex Triangulation::add_vertex(const Point& point) {
  const mesh::Vertex v = mesh_.add_vertex();
  geometry_.set_position(number(v), point);
  sectors_.remember(point, v, mesh_.vertex_count());
  return v;
}

// Uses a queue, because a chain of flips can be as long as the mesh is large. While an edge waits in the queue, the
// processor fetches the data beyond it. Source: Lawson, *Software for C1 surface interpolation*, 1977.
void Triangulation::legalise_around_apex() {
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

mesh::HalfEdge Triangulation::force_edge(mesh::Vertex u, mesh::Vertex w, const std::vector<mesh::HalfEdge>& crossed,
                                         mesh::Label label) {
  const mesh::HalfEdge edge = cavity_filler_.force_edge(geometry_, mesh_, u, w, crossed, label);
  remember(edge);
  return edge;
}

void Triangulation::remember(mesh::HalfEdge h) { recent_ = is_ghost_face(h) ? twin_in_domain(h) : h; }

void Triangulation::unfix_edge(mesh::HalfEdge h) {
  mesh_.set_label(h, 0);
  unfixed_.push_back(h);
}

void Triangulation::legalise_unfixed() { legalise(geometry_, mesh_, unfixed_); }

// Each step around the vertex waits for memory whose address the previous step has read, so the function goes around
// the vertex in both directions at once. In the meantime it prefetches the data of the neighbours that a removal needs.
// It knows a neighbour as soon as it reads a face: the apex of the face is the next neighbour.
const Triangulation::Star& Triangulation::star(mesh::Vertex v) {
  star_.spokes.clear();
  star_.fixed.clear();
  clockwise_.clear();
  mesh::HalfEdge left = mesh_.outgoing(v);
  mesh::HalfEdge right = left;
  prefetch(mesh_.target(right));
  do {
    if (star_.spokes.size() == kManySpokes && has_crossing(star_.spokes)) break;
    star_.spokes.push_back(left);
    prefetch(mesh_.apex(left));
    prefetch_face_beyond(next(left));
    left = mesh_.next_around(left);
    if (left == right) break;
    right = mesh_.previous_around(right);
    clockwise_.push_back(right);
    prefetch(mesh_.target(right));
    prefetch_face_beyond(next(right));
  } while (left != right);
  star_.spokes.insert(star_.spokes.end(), clockwise_.rbegin(), clockwise_.rend());
  for (std::uint32_t i = 0; i < star_.spokes.size(); ++i) {
    if (mesh_.is_fixed(star_.spokes[i])) star_.fixed.push_back(i);
  }
  return star_;
}

/// Whether more than two of the spokes are fixed.
bool Triangulation::has_crossing(const std::vector<mesh::HalfEdge>& spokes) const {
  return std::count_if(spokes.begin(), spokes.end(), [&](mesh::HalfEdge h) { return mesh_.is_fixed(h); }) > 2;
}

mesh::HalfEdge Triangulation::remove_vertex(const Star& star) {
  return star.fixed.empty() ? remove_free_vertex(star) : remove_vertex_on_line(star);
}

//         w2 ---- w1      The faces around v leave a cavity, which is star-shaped around v. Its border starts
//        /  \   /  |      at w0. The last edge of the border, from w4 to w0, is the base.
//      w3 --- v --- w0
//        \   |    /
//          ---w4--
mesh::HalfEdge Triangulation::remove_free_vertex(const Star& star) {
  const mesh::Vertex v = mesh_.origin(star.spokes[0]);
  collect_cavity(star, 0, 0);
  const mesh::HalfEdge last = cavity_edges_.back();
  cavity_edges_.pop_back();
  const mesh::HalfEdge base = refill_cavity();
  mesh_.close(base, last);
  free_vertex(v, base);
  return mesh::kNoHalfEdge;
}

//          a2 --- a1     v lies on the line from p to q. The edge p - q replaces p - v and v - q. On the left and
//        /   \  /   \    on the right of the line, the faces around v leave a cavity with the edge p - q as its base.
//       p --- v --- q
//        \   / \   /
//          b1 --- b2
mesh::HalfEdge Triangulation::remove_vertex_on_line(const Star& star) {
  const std::size_t to_p = star.fixed[0];
  const std::size_t to_q = star.fixed[1];
  const mesh::Vertex v = mesh_.origin(star.spokes[0]);
  const mesh::Label label = mesh_.label(star.spokes[to_p]);
  collect_cavity(star, to_q, to_p);
  const mesh::HalfEdge left = refill_cavity();
  collect_cavity(star, to_p, to_q);
  const mesh::HalfEdge right = refill_cavity();
  mesh_.link(left, right, label);
  free_vertex(v, left);
  return left;
}

/// Collects the half-edges opposite to a star's vertex in the faces between two spokes, and the positions of their
/// ends. The faces are those from the spoke at index `from`, counter-clockwise, to the spoke at index `to`.
void Triangulation::collect_cavity(const Star& star, std::size_t from, std::size_t to) {
  const std::size_t degree = star.spokes.size();
  const std::size_t count = from < to ? to - from : to + degree - from;
  cavity_edges_.resize(count);
  cavity_positions_.resize(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = from + i < degree ? from + i : from + i - degree;
    cavity_edges_[i] = next(star.spokes[at]);
    cavity_positions_[i] = view(mesh_.origin(cavity_edges_[i]));
  }
  cavity_positions_[count] = view(mesh_.target(cavity_edges_[count - 1]));
}

/// Triangulates a cavity. Its border consists of the edges in `cavity_edges_` and of the base, which runs from the last
/// vertex to the first. Cost: expected linear. The simple method for small cavities takes quadratic time at worst.
mesh::HalfEdge Triangulation::refill_cavity() {
  if (cavity_edges_.size() > kLargeCavity) {
    std::uint64_t seed = 0;
    for (const mesh::HalfEdge h : cavity_edges_) seed = changed_seed(seed, geometry_.rounded(number(mesh_.origin(h))));
    large_cavity_.triangulate(geometry_, std::span(cavity_positions_).first(cavity_edges_.size() + 1), seed,
                              triangles_);
    return mesh_.refill(cavity_edges_, triangles_);
  }
  triangles_.clear();
  triangles_.push_back(triangle_over(0, static_cast<std::uint32_t>(cavity_edges_.size())));
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto [from, apex, to] = triangles_[i];
    if (apex - from > 1) triangles_.push_back(triangle_over(from, apex));
    if (to - apex > 1) triangles_.push_back(triangle_over(apex, to));
  }
  return mesh_.refill(cavity_edges_, triangles_);
}

//           m          Finds the triangle on a base: its apex is the vertex whose circle through the base's ends
//        .     .       contains no other vertex. One circle through these ends is known to contain no vertex of the
//     from ----- to    cavity: the circle of the triangle beyond the base or, for the first base, the circle through v
//        .  n  .       (if v lies on the base, the half-plane beyond the base). Each vertex has its own circle through
//           .          these ends. The apex is the vertex whose circle reaches least far in front of the base. A vertex
//                      beyond the base, or on its line, has a circle that reaches less far in front than the empty
//                      circle; if such a vertex is the candidate, each vertex in front of the base must replace it.
//
// The determinant is the in-circle determinant of the two ends of the base, of the candidate m and of the next vertex
// n. A vertex lies *in front* of the base if it lies where the triangle will be, and *beyond* the base if the line
// through the base separates it from there. The code need not test whether the candidate m lies in front. If m lies in
// front, the determinant is positive for each n in m's circle. If m lies beyond the base, the sign of the determinant
// is reversed: it is positive for each n in front, because n then lies outside m's circle. For n beyond the base, the
// determinant is negative if m lies in front; if m lies beyond it, too, the code may choose either. Ties are decided as
// if one lifted point were lowered by an infinitesimal, and the same argument holds for these points. In a tie, the
// sign of the determinant still decides, except if n is the lowered point. Then n lies in every circle, also in the
// circle of m. So it is impossible that m lies beyond the base and n in front of it.
//
// No edge of the cavity hides a vertex that lies in the circle, because v lies in the circle, and no edge of the cavity
// lay between v and a vertex of the cavity. Source: Devillers, *Vertex removal in two-dimensional Delaunay
// triangulation: speed-up by low degrees optimization*, 2011, which uses decision tables. For vertices of usual
// degrees, this loop needs about as many in-circle tests.
Triangulation::Triangle Triangulation::triangle_over(std::uint32_t from, std::uint32_t to) const {
  const View& a = cavity_positions_[from];
  const View& b = cavity_positions_[to];
  std::uint32_t apex = from + 1;
  for (std::uint32_t i = apex + 1; i < to; ++i) {
    if (circle_contains(geometry_, a, cavity_positions_[apex], b, cavity_positions_[i])) apex = i;
  }
  return {from, apex, to};
}

void Triangulation::free_vertex(mesh::Vertex v, mesh::HalfEdge near) {
  mesh_.free_vertex(v);
  sectors_.replace(geometry_.rounded(number(v)), v, mesh_.origin(near));
  geometry_.clear(number(v));
  remember(near);
}

}  // namespace waywright::delaunay
