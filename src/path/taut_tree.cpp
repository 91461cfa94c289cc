#include "path/taut_tree.hpp"

#include "path/funnel.hpp"

namespace waywright::path {

using exact::Sign;

/// The two strings of a funnel, for the functions in `funnel.hpp`.
struct TautTree::Strings {
  using Corner = std::uint32_t;

  struct Chain {
    [[nodiscard]] bool is_empty() const { return nodes->empty(); }
    [[nodiscard]] Corner first() const { return nodes->back(); }
    Corner take_first() {
      const Corner corner = nodes->back();
      nodes->pop_back();
      return corner;
    }
    std::vector<Corner>* nodes;
  };

  [[nodiscard]] Corner apex() const { return funnel->apex; }
  template <Sign kString>
  [[nodiscard]] Corner end() const {
    return kString == Sign::positive ? funnel->left : funnel->right;
  }
  template <Sign kString>
  [[nodiscard]] Corner before(Corner corner) const {
    return tree->nodes_[corner].parent;
  }
  template <Sign kString>
  [[nodiscard]] Chain from_apex() const {
    tree->chain_.clear();
    for (Corner node = end<kString>(); node != apex(); node = before<kString>(node)) tree->chain_.push_back(node);
    return {&tree->chain_};
  }
  [[nodiscard]] Sign orientation(Corner p, Corner q, const Geometry::View& v) const {
    return tree->geometry_->orientation(tree->nodes_[p].position, tree->nodes_[q].position, v);
  }

  TautTree* tree;
  const Funnel* funnel;
};

void TautTree::reset(const Geometry& geometry, const Point& start) {
  geometry_ = &geometry;
  nodes_.clear();
  nodes_.push_back({Geometry::view(start), kRoot, 0.0});
}

std::uint32_t TautTree::add(mesh::Vertex v, std::uint32_t parent) {
  const Geometry::View position = geometry_->view(number(v));
  nodes_.push_back({position, parent, nodes_[parent].length + distance(point(parent), {position.x, position.y})});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

std::uint32_t TautTree::add_seen(mesh::Vertex v) {
  return is_at_start(*geometry_, nodes_[kRoot].position, v) ? kRoot : add(v, kRoot);
}

Funnel TautTree::move_left(const Funnel& funnel, mesh::Vertex v) {
  const auto [corner, apex] = find_turn<Sign::positive>(Strings{this, &funnel}, geometry_->view(number(v)));
  return {apex, add(v, corner), funnel.right};
}

Funnel TautTree::move_right(const Funnel& funnel, mesh::Vertex v) {
  const auto [corner, apex] = find_turn<Sign::negative>(Strings{this, &funnel}, geometry_->view(number(v)));
  return {apex, funnel.left, add(v, corner)};
}

std::uint32_t TautTree::last_corner(const Funnel& funnel, const Point& goal) {
  return find_last_corner(Strings{this, &funnel}, Geometry::view(goal));
}

}  // namespace waywright::path
