#include "path/funnel.hpp"

namespace waywright::path {

using exact::Sign;

void TautTree::reset(const Geometry& geometry, const Point& start) {
  geometry_ = &geometry;
  nodes_.clear();
  nodes_.push_back({Geometry::view(start), kRoot, 0.0});
}

Sign TautTree::side(std::uint32_t p, std::uint32_t q, const Geometry::View& v) const {
  return geometry_->orientation(nodes_[p].position, nodes_[q].position, v);
}

std::uint32_t TautTree::add(mesh::Vertex v, std::uint32_t parent) {
  const Geometry::View position = geometry_->view(number(v));
  nodes_.push_back({position, parent, nodes_[parent].length + distance(point(parent), {position.x, position.y})});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

// A string of length zero has no direction, so the code could not decide whether the next piece turns left or right. So
// the node of a vertex at the start is the root itself.
std::uint32_t TautTree::add_seen(mesh::Vertex v) {
  return geometry_->order(nodes_[kRoot].position, geometry_->view(number(v))) == 0 ? kRoot : add(v, kRoot);
}

/// Collects the nodes from `end` back to `apex`, without `apex`.
void TautTree::collect(std::uint32_t end, std::uint32_t apex, std::vector<std::uint32_t>& chain) const {
  chain.clear();
  for (; end != apex; end = nodes_[end].parent) chain.push_back(end);
}

//          own end . . . . . v        The string to v leaves its own chain at a corner: the first one, from its own end
//         /              .'           towards the apex, for which v lies outwards of the piece that ends there. If
//       own         . '               there is no such corner, the string follows the other chain from the apex on, as
//      /       . '                    long as v lies beyond the next piece.
//   apex --- other --- other end
std::uint32_t TautTree::bend(const Funnel& funnel, std::uint32_t own_end, std::uint32_t other_end, Sign outwards,
                             const Geometry::View& v) {
  std::uint32_t corner = own_end;
  while (corner != funnel.apex && side(nodes_[corner].parent, corner, v) != outwards) corner = nodes_[corner].parent;
  if (corner != funnel.apex) return corner;
  collect(other_end, funnel.apex, chain_);
  while (!chain_.empty() && side(corner, chain_.back(), v) == -outwards) {
    corner = chain_.back();
    chain_.pop_back();
  }
  return corner;
}

Funnel TautTree::move_left(const Funnel& funnel, mesh::Vertex v) {
  const std::uint32_t corner = bend(funnel, funnel.left, funnel.right, Sign::positive, geometry_->view(number(v)));
  return {apex_after(funnel, corner, funnel.left), add(v, corner), funnel.right};
}

Funnel TautTree::move_right(const Funnel& funnel, mesh::Vertex v) {
  const std::uint32_t corner = bend(funnel, funnel.right, funnel.left, Sign::negative, geometry_->view(number(v)));
  return {apex_after(funnel, corner, funnel.right), funnel.left, add(v, corner)};
}

/// Returns the apex after a bend. The apex moves if the string bends around the other chain.
std::uint32_t TautTree::apex_after(const Funnel& funnel, std::uint32_t corner, std::uint32_t own_end) const {
  for (std::uint32_t node = own_end; node != funnel.apex; node = nodes_[node].parent) {
    if (node == corner) return funnel.apex;
  }
  return corner;
}

std::uint32_t TautTree::last_corner(const Funnel& funnel, const Point& goal) {
  const Geometry::View v = Geometry::view(goal);
  std::uint32_t corner = funnel.apex;
  for (const auto& [end, outwards] :
       {std::pair{funnel.left, Sign::positive}, std::pair{funnel.right, Sign::negative}}) {
    collect(end, funnel.apex, chain_);
    while (!chain_.empty() && side(corner, chain_.back(), v) == outwards) {
      corner = chain_.back();
      chain_.pop_back();
    }
    if (corner != funnel.apex) break;
  }
  return corner;
}

}  // namespace waywright::path
