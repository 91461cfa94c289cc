#include "nav/two_core.hpp"

#include <unordered_map>

#include "memory/count.hpp"
#include "nav/point_agent.hpp"

namespace waywright::nav {

using mesh::Face;
using mesh::HalfEdge;

TwoCore::TwoCore(const constraint::ConstrainedTriangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  states_.reserve(memory::with_spare(mesh.face_slots()));
  states_.grow_to(mesh.face_slots(), kAbsent);
  for (std::uint32_t f = 0; f < states_.size(); ++f) {
    if (!triangulation.triangulation().is_in_domain(Face{f})) continue;
    State& state = states_.unrecorded(f);
    state = kCore;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge h{3 * f + i};
      if (PointAgent::can_cross(mesh, h)) state |= passage_bit(h);
    }
  }
  for (std::uint32_t f = 0; f < states_.size(); ++f) {
    peel_from(mesh, Face{f});
    begin();  // empties the log: there is no earlier state to go back to
  }
  states_.release_records();
}

// update() starts with a set of faces that surely contains the core. It peels the set: it removes faces with fewer than
// two passages until no such face is left. The set consists of
// - the old core,
// - every new face, and
// - for each old tree face that is adjacent to a new face: the faces from there up to the core. There is one exception:
//   the passage through which a tree face hangs on a new face does not count. If its tree has no other passage to a new
//   face, it stays a tree.
//
// All faces outside the set are then in trees that hang on the set.
//
// Often only one old tree face is adjacent to the new faces, and the core is far away. Then the climb to the core is
// long and mostly useless, because the new faces only replace other faces that hung on the tree face. So update() first
// peels the new faces as if the tree face were in the core. It climbs only if a cycle is left. There are two
// exceptions: a second tree face or a face of the core is adjacent to the new faces, or the old component of the tree
// face has lost its root or a face of the core. Then a cycle may lead up from the tree face and come back to the new
// faces elsewhere, so update() climbs first. (Otherwise the way up from the tree face ends at a root or a face of the
// core that still exists. If it led through a removed face, it would leave the removed faces at a second tree face or
// at a face of the core.)
TwoCore::Surroundings TwoCore::join_all(const mesh::TriangleMesh& mesh, std::span<const Face> changed,
                                        std::span<const Face> new_faces) {
  states_.grow_to(mesh.face_slots(), kAbsent);
  Surroundings around;
  for (const Face f : changed) write(f, kAbsent);
  for (const Face f : new_faces) write(f, kCore | kNew);
  for (const Face f : new_faces) join(mesh, f, around);
  return around;
}

void TwoCore::finish_update(const mesh::TriangleMesh& mesh, std::span<const Face> new_faces, const Surroundings& around,
                            bool hangs_on_one) {
  to_peel_.assign(new_faces.begin(), new_faces.end());
  if (hangs_on_one) peel(mesh);
  if (around.trees > 0) climb_trees(mesh, new_faces);
  peel(mesh);
  for (const Face f : new_faces) states_.unrecorded(number(f)) = static_cast<State>(states_[number(f)] & ~kNew);
}

void TwoCore::update_in_open_space(const mesh::TriangleMesh& mesh, std::span<const Face> changed,
                                   std::span<const Face> new_faces) {
  states_.grow_to(mesh.face_slots(), kAbsent);
  for (const Face f : changed) write(f, kAbsent);
  for (const Face f : new_faces) write(f, kCore | kPassages);
}

void TwoCore::write(Face f, State state) {
  if ((states_[number(f)] & kNew) == 0) {
    states_.write(number(f), state);
  } else {
    states_.unrecorded(number(f)) = state;  // the log already has the old state
  }
}

void TwoCore::add_passage(HalfEdge h) {
  const Face f = mesh::face(h);
  write(f, states_[number(f)] | passage_bit(h));
}

/// Gives a new face its passages, including one to each adjacent old tree face that does not hang on the new face. The
/// tree face gets the passage in the opposite direction only when climb() takes it into the core.
void TwoCore::join(const mesh::TriangleMesh& mesh, Face f, Surroundings& around) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge h = mesh::half_edge(f, i);
    if (!PointAgent::can_cross(mesh, h)) continue;
    const HalfEdge back = mesh.twin(h);
    const Face other = mesh::face(back);
    if (leads_up(back)) continue;
    add_passage(h);
    if (!is_core(other)) {
      ++around.trees;
      around.tree = other;
    } else if ((states_[number(other)] & kNew) == 0 && !is_core_passage(back)) {
      add_passage(back);
      around.has_core = true;
    }
  }
}

void TwoCore::climb_trees(const mesh::TriangleMesh& mesh, std::span<const Face> new_faces) {
  for (const Face f : new_faces) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge h = mesh::half_edge(f, i);
      if (is_core_passage(h) && !is_core_passage(mesh.twin(h))) climb(mesh, mesh.twin(h));
    }
  }
}

/// Takes into the core the face of the half-edge `back`, if it is a tree face, and all faces from there up to the core
/// or to the root. Requires: the face beyond `back` is in the core.
void TwoCore::climb(const mesh::TriangleMesh& mesh, HalfEdge back) {
  for (;;) {
    const Face f = mesh::face(back);
    if (is_core(f)) return add_passage(back);
    const HalfEdge up = towards_core(f);
    if (up == mesh::kNoHalfEdge) {
      write(f, kCore | passage_bit(back));
      return to_peel_.push_back(f);
    }
    write(f, static_cast<State>(kCore | passage_bit(back) | passage_bit(up)));
    back = mesh.twin(up);
  }
}

/// Takes faces with fewer than two passages out of the core until none is left.
void TwoCore::peel(const mesh::TriangleMesh& mesh) {
  while (!to_peel_.empty()) {
    const Face f = to_peel_.back();
    to_peel_.pop_back();
    peel_from(mesh, f);
  }
}

/// Takes a face out of the core if it has fewer than two passages. Then does the same with the face on which it hangs,
/// and so on.
void TwoCore::peel_from(const mesh::TriangleMesh& mesh, Face f) {
  while (is_core(f) && core_degree(f) < 2) {
    if (core_degree(f) == 0) return write(f, kRoot);
    const HalfEdge up = mesh::half_edge(f, static_cast<std::uint32_t>(std::countr_zero(core_passages(f))));
    write(f, tree_state(up));
    const HalfEdge back = mesh.twin(up);
    f = mesh::face(back);
    if (is_core(f)) write(f, static_cast<State>(states_[number(f)] & ~passage_bit(back)));
  }
}

std::optional<std::string> TwoCore::find_difference(const mesh::TriangleMesh& mesh, const TwoCore& other,
                                                    std::span<const Face> faces) const {
  std::unordered_map<std::uint32_t, std::uint32_t> roots;  // maps the roots of `other` to the roots of this
  const std::vector<Face> tops = this->tops(mesh, faces);
  const std::vector<Face> other_tops = other.tops(mesh, faces);
  for (const Face f : faces) {
    const std::string where = "face " + std::to_string(number(f));
    if (is_core(f) != other.is_core(f)) return where + (is_core(f) ? " is not of the core" : " is of the core");
    if ((states_[number(f)] & kPassages) != (other.states_[number(f)] & kPassages))
      return where + " has other passages";
    if (is_core(f)) continue;
    const Face root = tops[number(f)];
    const Face other_root = other_tops[number(f)];
    if (is_core(root) || other.is_core(other_root)) {
      if (towards_core(f) != other.towards_core(f)) return where + " leads elsewhere than towards the core";
    } else if (towards_core(root) != mesh::kNoHalfEdge) {
      return where + " leads round and round";
    } else if (roots.emplace(number(other_root), number(root)).first->second != number(root)) {
      return where + " leads to a second root";
    }
  }
  return std::nullopt;
}

/// Returns, by face slot, the last face of the chain that towards_core() makes from each face: a face of the core or a
/// root. If a chain runs in a circle, the result is a face of that circle.
std::vector<Face> TwoCore::tops(const mesh::TriangleMesh& mesh, std::span<const Face> faces) const {
  constexpr Face kUnknown{0xffffffff};
  std::vector<Face> tops(states_.size(), kUnknown);
  std::vector<Face> chain;
  for (Face f : faces) {
    for (chain.clear(); tops[number(f)] == kUnknown; f = mesh::face(mesh.twin(towards_core(f)))) {
      chain.push_back(f);
      tops[number(f)] = f;
      if (is_core(f) || towards_core(f) == mesh::kNoHalfEdge) break;
    }
    for (const Face below : chain) tops[number(below)] = tops[number(f)];
  }
  return tops;
}

}  // namespace waywright::nav
