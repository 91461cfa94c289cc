#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "waywright/mesh_snapshot.hpp"

#include "base/number_text.hpp"
#include "svg/drawings.hpp"
#include "svg/elements.hpp"
#include "svg/path_data.hpp"

namespace waywright::svg {

namespace {

// The largest numbers of items with hints, and of free edges. A picture with more would be too large for viewers, and
// too dense to read.
constexpr std::size_t kMostItemHints = 50000;
constexpr std::size_t kMostEdges = 300000;

/// The items that the picture shows, grouped by how they are drawn.
struct DrawnItems {
  std::vector<Item> solids;
  std::vector<Item> polylines;  ///< and segments
  std::vector<Item> dots;

  [[nodiscard]] std::size_t count() const { return solids.size() + polylines.size() + dots.size(); }
};

/// Line widths in pixels: wide if there is room, narrow if the mesh is dense.
struct Strokes {
  double mesh = 0.0;
  double solid = 0.0;
  double polyline = 0.0;
  double dot = 0.0;
};

bool is_one_point(PointSpan ring) {
  return std::all_of(ring.begin(), ring.end(), [&](const Point& point) { return point == ring.front(); });
}

void sort_item(Item item, DrawnItems& items) {
  if (item.shape.kind == ItemKind::polygon) {
    items.solids.push_back(std::move(item));
  } else if (is_one_point(item.shape.rings.front())) {
    items.dots.push_back(std::move(item));
  } else {
    items.polylines.push_back(std::move(item));
  }
}

DrawnItems drawn_items(const World& world, const SvgOptions& options) {
  DrawnItems items;
  if (!options.crop) {
    for (Item& item : world.items()) sort_item(std::move(item), items);
    return items;
  }
  const Result<std::vector<ItemId>> ids = world.items_in(*options.crop);
  if (!ids.ok()) return items;
  for (const ItemId id : *ids) {
    Result<Shape> shape = world.shape(id);
    if (shape.ok()) sort_item({id, *std::move(shape)}, items);
  }
  return items;
}

Strokes strokes_for(const World& world, double scale) {
  const Box& domain = world.domain();
  const double area = (domain.max.x - domain.min.x) * (domain.max.y - domain.min.y);
  const double spacing = std::sqrt(area / static_cast<double>(world.vertex_count())) * scale;
  Strokes strokes;
  strokes.mesh = std::clamp(spacing / 24.0, 0.12, 0.8);
  strokes.solid = std::clamp(spacing / 14.0, 0.2, 1.5);
  strokes.polyline = std::clamp(spacing / 7.0, 0.6, 3.2);
  strokes.dot = std::clamp(spacing / 7.0, 0.6, 3.2);
  return strokes;
}

bool is_constrained(const MeshSnapshot& mesh, const std::array<std::uint32_t, 2>& edge) {
  const auto found =
      std::lower_bound(mesh.constraints.begin(), mesh.constraints.end(), edge,
                       [](const MeshSnapshot::ConstrainedEdge& a, const auto& b) { return a.vertices < b; });
  return found != mesh.constraints.end() && found->vertices == edge;
}

/// The drawing of the mesh, if it is not too large.
struct MeshDrawing {
  std::string elements;
  bool is_too_large = false;
};

class WorldDrawer {
 public:
  WorldDrawer(const World& world, const SvgFrame& frame, const SvgOptions& options, const Palette& palette)
      : world_(world),
        frame_(frame),
        options_(options),
        palette_(palette),
        items_(drawn_items(world, options)),
        strokes_(strokes_for(world, frame.scale())),
        has_hints_(options.ids && items_.count() <= kMostItemHints) {}

  [[nodiscard]] WorldDrawing draw() const {
    WorldDrawing drawing;
    const MeshDrawing mesh = draw_mesh();
    drawing.elements = draw_ground() + mesh.elements + draw_solids() + draw_polylines() + draw_dots() + draw_border();
    drawing.entries = entries(mesh.is_too_large);
    return drawing;
  }

 private:
  [[nodiscard]] std::vector<Point> domain_ring() const {
    const Box& domain = world_.domain();
    return {domain.min, {domain.max.x, domain.min.y}, domain.max, {domain.min.x, domain.max.y}};
  }

  [[nodiscard]] std::string domain_element(std::string_view id, const std::string& style) const {
    PathData data(frame_);
    data.add_ring(domain_ring());
    return "<path id=\"" + std::string(id) + "\"" + style + " d=\"" + data.text() + "\"/>\n";
  }

  [[nodiscard]] std::string draw_ground() const {
    return domain_element("ground", palette_({Ink::ground}, {Ink::none}));
  }

  [[nodiscard]] std::string draw_border() const {
    return domain_element("domain", palette_({Ink::none}, {Ink::wall}) + " stroke-width=\"2\"");
  }

  /// Returns the start tag of a group of strokes, without its `>`.
  [[nodiscard]] std::string open_group(std::string_view id, Ink fill, Ink stroke, double stroke_width) const {
    std::string out = "<g";
    append_attribute(out, "id", id);
    palette_.append(out, {fill}, {stroke});
    append_attribute(out, "stroke-width", stroke_width);
    return out + R"( stroke-linecap="round" stroke-linejoin="round")";
  }

  [[nodiscard]] MeshDrawing draw_mesh() const {
    if (!options_.mesh) return {};
    if (!options_.crop && world_.triangle_count() * 3 / 2 > kMostEdges) return {{}, true};
    const MeshSnapshot mesh = world_.snapshot();
    std::string out = open_group("mesh", Ink::none, Ink::mesh, strokes_.mesh) + ">\n";
    PathData data(frame_);
    std::size_t edge_count = 0;
    for (const auto& triangle : mesh.triangles) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::array<std::uint32_t, 2> edge{triangle[corner], triangle[(corner + 1) % 3]};
        // Both triangles at a free edge list the edge, in opposite directions. The loop draws the edge only for the
        // ascending direction.
        if (edge[0] > edge[1] || is_constrained(mesh, edge)) continue;
        const std::size_t length_before = data.text().size();
        data.add_segment(mesh.vertices[edge[0]], mesh.vertices[edge[1]]);
        if (data.text().size() > length_before && ++edge_count > kMostEdges) return {{}, true};
        append_long(out, data);
      }
    }
    append_rest(out, data);
    return {out + "</g>\n", false};
  }

  /// Ends a path element for many items once it is long, and starts a new one.
  static void append_long(std::string& out, PathData& data) {
    const std::string text = data.take_if_long();
    if (!text.empty()) out += "<path d=\"" + text + "\"/>\n";
  }

  static void append_rest(std::string& out, const PathData& data) {
    if (!data.empty()) out += "<path d=\"" + data.text() + "\"/>\n";
  }

  void append_item(std::string& out, const PathData& data, std::string_view kind, ItemId id,
                   std::string_view attributes = {}) const {
    out += "<path" + std::string(attributes) + " d=\"" + data.text();
    if (!has_hints_) {
      out += "\"/>\n";
      return;
    }
    out += "\">";
    append_hint(out, base::with_number(kind, id.value, ""));
    out += "</path>\n";
  }

  [[nodiscard]] std::string draw_solids() const {
    std::string out =
        open_group("polygons", Ink::solid, Ink::solid_outline, strokes_.solid) + " fill-rule=\"evenodd\">\n";
    for (const Item& item : items_.solids) {
      PathData data(frame_);
      for (const PointSpan ring : item.shape.rings) data.add_ring(ring);
      const bool is_nonzero = item.shape.fill == FillRule::nonzero;
      if (!data.empty()) append_item(out, data, "polygon ", item.id, is_nonzero ? " fill-rule=\"nonzero\"" : "");
    }
    return out + "</g>\n";
  }

  /// Draws one element for each polyline. If polylines have no hints, it draws one element for many, which takes far
  /// less room.
  [[nodiscard]] std::string draw_polylines() const {
    std::string out = open_group("lines", Ink::none, Ink::wall, strokes_.polyline) + ">\n";
    PathData all(frame_);
    for (const Item& item : items_.polylines) {
      const PointSpan chain = item.shape.rings.front();
      if (!has_hints_) {
        all.add_chain(chain);
        append_long(out, all);
        continue;
      }
      PathData data(frame_);
      data.add_chain(chain);
      const bool is_segment = item.shape.kind == ItemKind::segment;
      if (!data.empty()) append_item(out, data, is_segment ? "segment " : "polyline ", item.id);
    }
    append_rest(out, all);
    return out + "</g>\n";
  }

  [[nodiscard]] std::string draw_dots() const {
    if (!has_hints_) return draw_dots_together();
    std::string out = "<g id=\"points\"" + palette_({Ink::point}, {Ink::none}) + ">\n";
    for (const Item& item : items_.dots) {
      std::string dot = circle(frame_.to_picture(item.shape.rings.front().front()), strokes_.dot);
      dot.erase(dot.size() - 2);  // removes the end of the element, `/>`
      out += dot + '>';
      append_hint(out, base::with_number(std::string(to_string(item.shape.kind)) + " ", item.id.value, ""));
      out += "</circle>\n";
    }
    return out + "</g>\n";
  }

  /// Draws one element for many points.
  [[nodiscard]] std::string draw_dots_together() const {
    PathData all(frame_);
    std::string out = open_group("points", Ink::none, Ink::point, 2.0 * strokes_.dot) + ">\n";
    for (const Item& item : items_.dots) {
      all.add_dot(item.shape.rings.front().front());
      append_long(out, all);
    }
    append_rest(out, all);
    return out + "</g>\n";
  }

  [[nodiscard]] std::string solid_sample() const {
    return "<path d=\"M3 4L12 1L26 3L25 15L7 15Z\" stroke-width=\"1.5\" stroke-linejoin=\"round\"" +
           palette_({Ink::solid}, {Ink::solid_outline}) + "/>";
  }

  [[nodiscard]] std::string dot_sample() const {
    return "<g" + palette_({Ink::point}, {Ink::none}) + ">" + circle({14.0, 8.0}, 3.2) + "</g>";
  }

  /// Returns the text of the entry for the mesh. It has the number of triangles only if the picture shows the whole
  /// world: for a crop, counting them would take a search.
  [[nodiscard]] std::string mesh_text(bool is_too_large) const {
    const std::string text = options_.crop ? "mesh" : counted(world_.triangle_count(), "triangle", "triangles");
    return is_too_large ? text + ", too many edges to draw" : text;
  }

  [[nodiscard]] std::vector<LegendEntry> entries(bool is_too_large) const {
    std::vector<LegendEntry> entries;
    const auto add = [&](std::size_t count, std::string sample, std::string_view one, std::string_view many) {
      if (count > 0) entries.push_back({std::move(sample), counted(count, one, many)});
    };
    add(items_.solids.size(), solid_sample(), "polygon", "polygons");
    add(items_.polylines.size(), line_sample(palette_, {Ink::wall}, 3.2), "polyline", "polylines");
    add(items_.dots.size(), dot_sample(), "point", "points");
    if (options_.mesh) entries.push_back({line_sample(palette_, {Ink::mesh}, 1.2), mesh_text(is_too_large)});
    return entries;
  }

  const World& world_;
  const SvgFrame& frame_;
  const SvgOptions& options_;
  const Palette& palette_;
  DrawnItems items_;
  Strokes strokes_;
  bool has_hints_;
};

}  // namespace

WorldDrawing draw_world(const World& world, const SvgFrame& frame, const SvgOptions& options, const Palette& palette) {
  return WorldDrawer(world, frame, options, palette).draw();
}

}  // namespace waywright::svg
