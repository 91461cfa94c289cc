#include <algorithm>
#include <unordered_map>

#include "nav/components.hpp"
#include "nav/two_core.hpp"

// Compares a maintained abstraction with one that was built from scratch.

namespace waywright::nav {

using mesh::Face;

std::optional<std::string> Components::find_difference(const Components& other, std::span<const Face> faces) const {
  if (count() != other.count()) return "the abstraction has another number of components";
  std::unordered_map<Id, Id> names;
  std::vector<std::uint32_t> cover;
  std::vector<std::uint32_t> other_cover;
  for (const Face f : faces) {
    const auto [name, is_new] = names.emplace(component_of(f), other.component_of(f));
    const std::string where = "face " + std::to_string(number(f));
    if (name->second != other.component_of(f)) return where + " is in another component";
    if (!is_new) continue;
    if (size(component_of(f)) != other.size(other.component_of(f)))
      return "the component of " + where + " has another size";
    cover.clear();
    other_cover.clear();
    for_each_cover(f, [&](std::uint32_t item) { cover.push_back(item); });
    other.for_each_cover(f, [&](std::uint32_t item) { other_cover.push_back(item); });
    std::sort(cover.begin(), cover.end());
    std::sort(other_cover.begin(), other_cover.end());
    if (cover != other_cover) return "the component of " + where + " is covered by other polygons";
  }
  // There are as many names as components, so no two components share a name.
  if (names.size() != count()) return "the abstraction misses a component";
  return std::nullopt;
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
