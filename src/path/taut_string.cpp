#include "path/taut_string.hpp"

#include "path/distance.hpp"

namespace waywright::path {

using exact::Sign;

/// The two strings of the funnel, for the templates for funnels.
struct TautString::Strings {
  using Node = std::size_t;

  template <Sign kString>
  struct Chain {
    [[nodiscard]] bool is_empty() const { return at == end; }
    [[nodiscard]] Node first() const { return kString == Sign::positive ? at - 1 : at + 1; }
    Node take_first() { return at = first(); }
    Node at;
    Node end;
  };

  [[nodiscard]] Node apex() const { return string->apex_; }
  template <Sign kString>
  [[nodiscard]] Node end() const {
    return kString == Sign::positive ? string->left_ : string->right_;
  }
  template <Sign kString>
  [[nodiscard]] Node before(Node node) const {
    return kString == Sign::positive ? node + 1 : node - 1;
  }
  template <Sign kString>
  [[nodiscard]] Chain<kString> from_apex() const {
    return {apex(), end<kString>()};
  }
  [[nodiscard]] Sign orientation(Node p, Node q, const View& v) const {
    return string->geometry_->orientation(string->row_[p], string->row_[q], v);
  }

  const TautString* string;
};

void TautString::begin(const Geometry& geometry, const Point& start, mesh::Vertex left, mesh::Vertex right,
                       std::size_t portal_count) {
  geometry_ = &geometry;
  points_.clear();
  if (row_.size() < 2 * portal_count + 1) row_.resize(2 * portal_count + 1);
  left_ = apex_ = right_ = portal_count;
  row_[apex_] = Geometry::view(start);
  if (!is_at_start(geometry, row_[apex_], left)) row_[--left_] = geometry.view(number(left));
  if (!is_at_start(geometry, row_[apex_], right)) row_[++right_] = geometry.view(number(right));
}

void TautString::move_left(mesh::Vertex v) {
  const View position = geometry_->view(number(v));
  const auto [node, apex] = find_turn<Sign::positive>(Strings{this}, position);
  move_apex_right(apex);
  left_ = node - 1;
  row_[left_] = position;
}

void TautString::move_right(mesh::Vertex v) {
  const View position = geometry_->view(number(v));
  const auto [node, apex] = find_turn<Sign::negative>(Strings{this}, position);
  move_apex_left(apex);
  right_ = node + 1;
  row_[right_] = position;
}

void TautString::end_at(const Point& goal) {
  const std::size_t last = find_last_turn(Strings{this}, Geometry::view(goal));
  move_apex_left(last);
  move_apex_right(last);
  turn_at(row_[apex_]);
  length_ = 0.0;
  for (std::size_t i = 1; i < points_.size(); ++i) length_ += distance(points_[i - 1], points_[i]);
  length_ += distance(points_.back(), goal);
}

/// The two strings of a funnel, for the templates for funnels.
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
