#include "world/change_log.hpp"

#include <algorithm>

namespace waywright {

void TouchLog::note_mesh(const constraint::ConstrainedTriangulation& triangulation) {
  const bool is_wanted = searches_.load(std::memory_order_relaxed) != 0 && entries_.size() <= kLongest;
  if (!is_wanted || !add_touched_faces(triangulation)) {
    entries_.clear();
    return note_everything();
  }
  if (entries_.capacity() - entries_.size() < kSpare) entries_.reserve(2 * entries_.size() + kSpare);
}

// A search that looks at a face reads that face and the faces that share a vertex with it. So each face that shares a
// vertex with a live touched face counts as touched, too.
bool TouchLog::add_touched_faces(const constraint::ConstrainedTriangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto add = [&](mesh::Face f) {
    if (entries_.size() <= kLongest) entries_.push_back({version_ + 1, f});
  };
  mesh.for_each_touched_face([&](mesh::Face f, mesh::TriangleMesh::Touch) {
    add(f);
    if (entries_.size() > kLongest || !mesh.is_live(f)) return;
    for (const mesh::HalfEdge h : {mesh::first(f), mesh::next(mesh::first(f)), mesh::previous(mesh::first(f))}) {
      if (mesh.origin(h) == triangulation.triangulation().ghost()) continue;
      mesh.for_each_outgoing(mesh.origin(h), [&](mesh::HalfEdge around) { add(mesh::face(around)); });
    }
  });
  return entries_.size() <= kLongest;
}

void TouchLog::note_abstraction(const nav::Abstraction& abstraction) {
  if (complete_since_ > version_) return;  // everything counts as touched already
  const bool has_list = abstraction.for_each_changed_face([&](mesh::Face f) {
    if (entries_.size() < entries_.capacity()) {
      entries_.push_back({version_ + 1, f});
    } else {
      note_everything();
    }
  });
  if (!has_list) note_everything();
}

void TouchLog::shrink_to_fit() {
  if (searches_.load(std::memory_order_relaxed) == 0) {
    entries_.clear();
    complete_since_ = version_;
  }
  memory::shrink(entries_);
}

bool TouchLog::has_touched(const path::LookedAt& looked_at, std::uint64_t since) const {
  if (since < complete_since_) return true;
  const auto after = [](std::uint64_t version, const Entry& entry) { return version < entry.version; };
  const auto first = std::upper_bound(entries_.begin(), entries_.end(), since, after);
  return std::any_of(first, entries_.end(), [&](const Entry& entry) { return looked_at.has(entry.face); });
}

}  // namespace waywright
