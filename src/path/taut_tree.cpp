#include "path/taut_tree.hpp"

#include "path/funnel.hpp"

namespace waywright::path {

using exact::Sign;

/// The two strings of a funnel, for the functions in `funnel.hpp`.
struct TautTree::Strings {
  using Node = std::uint32_t;

  struct Chain {
    [[nodiscard]] bool is_empty() const { return nodes->empty(); }
    [[nodiscard]] Node first() const { return nodes->back(); }
    Node take_first() {
      const Node node = nodes->back();
      nodes->pop_back();
      return node;
    }
    std::vector<Node>* nodes;
  };

  [[nodiscard]] Node apex() const { return funnel->apex; }
  template <Sign kString>
  [[nodiscard]] Node end() const {
    return kString == Sign::positive ? funnel->left : funnel->right;
  }
  template <Sign kString>
  [[nodiscard]] Node before(Node node) const {
    return tree->nodes_[node].parent;
  }
  template <Sign kString>
  [[nodiscard]] Chain from_apex() const {
    tree->chain_.clear();
    for (Node node = end<kString>(); node != apex(); node = before<kString>(node)) tree->chain_.push_back(node);
    return {&tree->chain_};
  }
  [[nodiscard]] Sign orientation(Node p, Node q, const Geometry::View& v) const {
    return tree->geometry_->orientation(tree->nodes_[p].position, tree->nodes_[q].position, v);
  }

  TautTree* tree;
  const Funnel* funnel;
};

void TautTree::reset(const Geometry& geometry, const Point& start) {
  geometry_ = &geometry;
  nodes_.clear();
  nodes_.push_back({Geometry::view(start), kStart, 0.0});
}

std::uint32_t TautTree::add(mesh::Vertex v, std::uint32_t parent) {
  const Geometry::View position = geometry_->view(number(v));
  nodes_.push_back({position, parent, nodes_[parent].length + distance(point(parent), {position.x, position.y})});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

std::uint32_t TautTree::add_visible_from_start(mesh::Vertex v) {
  return is_at_start(*geometry_, nodes_[kStart].position, v) ? kStart : add(v, kStart);
}

Funnel TautTree::move_left(const Funnel& funnel, mesh::Vertex v) {
  const auto [node, apex] = find_turn<Sign::positive>(Strings{this, &funnel}, geometry_->view(number(v)));
  return {apex, add(v, node), funnel.right};
}

Funnel TautTree::move_right(const Funnel& funnel, mesh::Vertex v) {
  const auto [node, apex] = find_turn<Sign::negative>(Strings{this, &funnel}, geometry_->view(number(v)));
  return {apex, funnel.left, add(v, node)};
}

std::uint32_t TautTree::last_turn(const Funnel& funnel, const Point& goal) {
  return find_last_turn(Strings{this, &funnel}, Geometry::view(goal));
}

}  // namespace waywright::path
