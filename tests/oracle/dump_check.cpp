#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/dump_text.hpp"
#include "oracle/oracle_impl.hpp"

namespace waywright::oracle {
namespace {

using Fault = std::optional<std::string>;
using Triangle = std::array<std::uint32_t, 3>;

std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string words(std::initializer_list<std::uint32_t> indices) {
  std::string text;
  for (const std::uint32_t index : indices) text += (text.empty() ? "" : " ") + std::to_string(index);
  return text;
}

/// Returns the first difference between the lines of a section and the expected lines.
template <class Expected>
Fault compare_lines(std::string_view name, const std::vector<std::string_view>& lines,
                    const std::vector<Expected>& expected) {
  const std::size_t common = std::min(lines.size(), expected.size());
  const auto at = static_cast<std::size_t>(
      std::mismatch(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(common), expected.begin()).first -
      lines.begin());
  if (at == common && lines.size() == expected.size()) return std::nullopt;
  const std::string where = std::string(name) + " " + std::to_string(at);
  if (at == lines.size()) return where + " is missing: expected " + in_quotes(expected[at]);
  std::string fault = where + " is " + in_quotes(lines[at]);
  if (at < expected.size()) fault += ", expected " + in_quotes(expected[at]);
  if (at == expected.size()) fault += ", expected no more";
  const auto elsewhere = std::find(expected.begin(), expected.end(), lines[at]);
  if (elsewhere != expected.end()) fault += " (out of order or twice)";
  return fault;
}

Fault check_vertices(const DumpText& dump, const Arrangement& arrangement) {
  std::vector<std::string> expected;
  for (const ExactPosition& p : arrangement.vertices) expected.push_back(arrangement.grid.text(p));
  const Fault difference = compare_lines("vertex", dump.vertices, expected);
  if (!difference) return std::nullopt;
  for (std::size_t i = 0; i < dump.vertices.size(); ++i) {
    if (const Fault fault = vertex_line_fault(dump.vertices[i])) {
      return "vertex " + std::to_string(i) + " " + in_quotes(dump.vertices[i]) + " " + *fault;
    }
  }
  return difference;
}

Fault check_constraints(const DumpText& dump, const Arrangement& arrangement) {
  std::vector<std::string> expected;
  for (const OracleConstraint& constraint : arrangement.constraints) {
    std::string& line = expected.emplace_back(words({constraint.from, constraint.to}));
    for (const std::uint64_t id : constraint.ids) line += ' ' + std::to_string(id);
  }
  return compare_lines("constraint", dump.constraints, expected);
}

/// An edge of a triangle without direction; `apex` is the opposite corner.
struct Edge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  bool forward = true;  ///< whether the triangle has it from `from` to `to`, so that it lies to the left
  std::uint32_t apex = 0;

  [[nodiscard]] bool same_ends(const Edge& other) const { return from == other.from && to == other.to; }
};

Fault check_triangles(const std::vector<Triangle>& triangles, const Arrangement& arrangement) {
  std::vector<bool> used(arrangement.vertices.size(), false);
  const Triangle* previous = nullptr;
  for (const Triangle& t : triangles) {
    const std::string name = "triangle " + in_quotes(words({t[0], t[1], t[2]}));
    if (t[0] >= t[1] || t[0] >= t[2]) return name + " does not start from its smallest index";
    if (previous != nullptr && t == *previous) return name + " is there twice";
    if (previous != nullptr && t < *previous) return name + " is out of order";
    previous = &t;
    const auto& v = arrangement.vertices;
    if (t[1] == t[2] || orientation(v[t[0]], v[t[1]], v[t[2]]) <= 0) return name + " is not counter-clockwise";
    for (const std::uint32_t index : t) used[index] = true;
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end()) {
    return "vertex " + std::to_string(unused - used.begin()) + " is in no triangle";
  }
  return std::nullopt;
}

std::vector<Edge> edges_of(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b, t[(k + 2) % 3]});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::array{a.from, a.to, std::uint32_t{a.forward}} < std::array{b.from, b.to, std::uint32_t{b.forward}};
  });
  return edges;
}

Fault check_empty_circle(const Edge& right, const Edge& left, const Arrangement& arrangement) {
  const auto& v = arrangement.vertices;
  const int sign = in_circle(v[left.from], v[left.to], v[left.apex], v[right.apex]);
  const std::string name = "edge " + in_quotes(words({left.from, left.to}));
  const std::string apexes = in_quotes(words({left.apex, right.apex}));
  if (sign > 0) return name + " fails the empty-circle test with " + apexes;
  if (sign == 0 && std::min(left.apex, right.apex) < left.from) return name + " breaks the tie rule with " + apexes;
  return std::nullopt;
}

// Every triangle is counter-clockwise. Requires for the argument: apart from the pieces of the domain's sides, each
// edge occurs twice, once in each direction. Then in the sum of cross products these pairs cancel, so the triangles'
// signed areas, and their winding numbers around any point, add up to those of the domain's border. So the triangles
// cover each point of the domain once.
Fault check_edges(const std::vector<Edge>& edges, const Arrangement& arrangement) {
  auto constraint = arrangement.constraints.begin();
  const auto last_constraint = arrangement.constraints.end();
  for (std::size_t i = 0; i < edges.size();) {
    const Edge& edge = edges[i];
    std::size_t count = 1;
    while (i + count < edges.size() && edges[i + count].same_ends(edge)) ++count;
    const std::string name = "edge " + in_quotes(words({edge.from, edge.to}));
    const std::array<std::uint32_t, 2> key{edge.from, edge.to};
    if (constraint != last_constraint && std::array{constraint->from, constraint->to} < key) break;
    const bool constrained = constraint != last_constraint && std::array{constraint->from, constraint->to} == key;
    const bool on_border = constrained && constraint->ids.front() == 0;
    if (count != (on_border ? 1U : 2U)) {
      return name + " is in " + std::to_string(count) + " triangles, " + (on_border ? "on" : "off") +
             " the domain's border";
    }
    if (count == 2 && edge.forward == edges[i + 1].forward)
      return name + " has two triangles on its left, or two on its right";
    if (count == 2 && !constrained) {
      if (const Fault fault = check_empty_circle(edge, edges[i + 1], arrangement)) return fault;
    }
    if (constrained) ++constraint;
    i += count;
  }
  if (constraint == last_constraint) return std::nullopt;
  return "the constrained edge " + in_quotes(words({constraint->from, constraint->to})) + " is no triangle's edge";
}

}  // namespace

Fault Oracle::check_dump(std::string_view text) const {
  std::string fault;
  const auto dump = read_dump(text, fault);
  if (!dump) return fault;
  const Arrangement& arrangement = impl_->arrangement;
  if (const Fault found = check_vertices(*dump, arrangement)) return found;
  if (const Fault found = check_constraints(*dump, arrangement)) return found;
  if (const Fault found = check_triangles(dump->triangles, arrangement)) return found;
  return check_edges(edges_of(dump->triangles), arrangement);
}

}  // namespace waywright::oracle
