#include "waywright/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/float_environment.hpp"
#include "base/number_text.hpp"
#include "io/svg_canvas.hpp"
#include "io/svg_legend.hpp"

namespace waywright {

namespace {

using io::append_attribute;
using io::append_escaped;
using io::append_pixels;
using io::Frame;
using io::LegendEntry;
using io::PathData;

// Light greys for what stands, one warm hue for what moves: told apart without colour vision, by lightness and shape.
constexpr std::string_view kPage = "#ffffff";
constexpr std::string_view kGround = "#faf8f3";
constexpr std::string_view kMesh = "#b8c8d6";
constexpr std::string_view kSolid = "#a9b4bf";
constexpr std::string_view kSolidEdge = "#5d6b78";
constexpr std::string_view kWall = "#22303c";
constexpr std::string_view kPoint = "#56789a";
constexpr std::string_view kStart = "#0072b2";
// Okabe and Ito's colours, those that stand out from the greys.
constexpr std::array<std::string_view, 4> kPathColours{"#d55e00", "#0072b2", "#009e73", "#cc79a7"};

constexpr double kTitleHeight = 58.0;
constexpr double kTopMargin = 20.0;
constexpr double kNarrowest = 240.0;
constexpr double kWidest = 100000.0;
constexpr double kDefaultWidth = 1200.0;
constexpr std::size_t kManyPaths = 12;

/// What the world holds, sorted by how it is drawn.
struct Things {
  std::vector<Item> solids;
  std::vector<Item> walls;
  std::vector<Point> dots;
};

/// Line widths in pixels: bold where there is room, fine where the mesh is dense.
struct Strokes {
  double mesh = 0.0;
  double solid = 0.0;
  double wall = 0.0;
  double dot = 0.0;
  double path = 0.0;
  double marker = 0.0;
};

bool is_one_place(PointSpan ring) {
  return std::all_of(ring.begin(), ring.end(), [&](const Point& point) { return point == ring.front(); });
}

void sort_item(Item item, Things& things) {
  if (item.shape.kind == ItemKind::polygon) {
    things.solids.push_back(std::move(item));
    return;
  }
  const PointSpan chain = std::as_const(item).shape.rings.front();
  if (is_one_place(chain)) {
    things.dots.push_back(chain.front());
  } else {
    things.walls.push_back(std::move(item));
  }
}

Things things_of(const World& world) {
  Things things;
  for (Item& item : world.items()) sort_item(std::move(item), things);
  return things;
}

Strokes strokes_for(const Frame& frame, std::size_t vertex_count, std::size_t path_count) {
  const double spacing = std::sqrt(frame.width() * frame.height() / static_cast<double>(vertex_count));
  Strokes strokes;
  strokes.mesh = std::clamp(spacing / 24.0, 0.12, 0.8);
  strokes.solid = std::clamp(spacing / 14.0, 0.2, 1.5);
  strokes.wall = std::clamp(spacing / 7.0, 0.6, 3.2);
  strokes.dot = std::clamp(spacing / 7.0, 0.6, 3.2);
  strokes.path = path_count < kManyPaths ? 4.5 : 2.0;
  strokes.marker = path_count < kManyPaths ? 8.0 : 4.0;
  return strokes;
}

void append_chain(PathData& data, PointSpan chain) {
  data.move_to(chain.front());
  for (std::size_t i = 1; i < chain.size(); ++i) data.line_to(chain[i]);
}

std::string path_element(const PathData& data, std::string_view attributes = {}) {
  return "<path" + std::string(attributes) + " d=\"" + data.text() + "\"/>\n";
}

/// The opening of a group of strokes.
std::string open_group(std::string_view id, std::string_view fill, std::string_view stroke, double stroke_width) {
  std::string out = "<g";
  append_attribute(out, "id", id);
  append_attribute(out, "fill", fill);
  append_attribute(out, "stroke", stroke);
  append_attribute(out, "stroke-width", stroke_width);
  out += R"( stroke-linecap="round" stroke-linejoin="round")";
  return out;
}

bool is_constrained(const MeshSnapshot& mesh, const std::array<std::uint32_t, 2>& edge) {
  const auto found =
      std::lower_bound(mesh.constraints.begin(), mesh.constraints.end(), edge,
                       [](const MeshSnapshot::ConstrainedEdge& a, const auto& b) { return a.vertices < b; });
  return found != mesh.constraints.end() && found->vertices == edge;
}

std::string draw_mesh(const MeshSnapshot& mesh, const Frame& frame, double stroke_width) {
  PathData data(frame);
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::array<std::uint32_t, 2> edge{triangle[corner], triangle[(corner + 1) % 3]};
      // Both neighbours name a free edge, each the other way round: the rising one is drawn.
      if (edge[0] > edge[1] || is_constrained(mesh, edge)) continue;
      data.move_to(mesh.vertices[edge[0]]);
      data.line_to(mesh.vertices[edge[1]]);
    }
  }
  return open_group("mesh", "none", kMesh, stroke_width) + ">\n" + path_element(data) + "</g>\n";
}

std::string draw_solids(const std::vector<Item>& solids, const Frame& frame, double stroke_width) {
  std::string out = open_group("solids", kSolid, kSolidEdge, stroke_width) + " fill-rule=\"evenodd\">\n";
  for (const Item& item : solids) {
    PathData data(frame);
    for (const PointSpan& ring : item.shape.rings) {
      append_chain(data, ring);
      data.close();
    }
    const bool is_nonzero = item.shape.fill == FillRule::nonzero;
    out += path_element(data, is_nonzero ? " fill-rule=\"nonzero\"" : "");
  }
  return out + "</g>\n";
}

std::string draw_walls(const std::vector<Item>& walls, const Frame& frame, double stroke_width) {
  std::string out = open_group("walls", "none", kWall, stroke_width) + ">\n";
  for (const Item& item : walls) {
    PathData data(frame);
    append_chain(data, item.shape.rings.front());
    out += path_element(data);
  }
  return out + "</g>\n";
}

std::string circle(const Point& centre, double radius) {
  std::string out = "<circle";
  append_attribute(out, "cx", centre.x);
  append_attribute(out, "cy", centre.y);
  append_attribute(out, "r", radius);
  return out + "/>";
}

std::string draw_dots(const std::vector<Point>& dots, const Frame& frame, double radius) {
  std::string out = "<g id=\"points\"";
  append_attribute(out, "fill", kPoint);
  out += ">\n";
  for (const Point& dot : dots) out += circle(frame.to_pixels(dot), radius) + "\n";
  return out + "</g>\n";
}

/// A disc where the path starts.
std::string start_marker(const Point& centre, double size) {
  std::string out = "<g class=\"start\" stroke=\"#ffffff\" stroke-width=\"2\"";
  append_attribute(out, "fill", kStart);
  return out + ">" + circle(centre, size) + "</g>";
}

/// A target of two rings where it ends.
std::string goal_marker(const Point& centre, double size, std::string_view colour) {
  std::string out = "<g class=\"goal\" stroke=\"#ffffff\" stroke-width=\"2\"";
  append_attribute(out, "fill", colour);
  out += ">" + circle(centre, size * 1.25) + "<g fill=\"#ffffff\" stroke=\"none\">";
  out += circle(centre, size * 0.8) + "</g><g stroke=\"none\">" + circle(centre, size * 0.45) + "</g></g>";
  return out;
}

std::string draw_paths(const std::vector<Path>& paths, const Frame& frame, const Strokes& strokes) {
  std::string out = "<g id=\"paths\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  std::string markers;
  std::size_t drawn = 0;
  for (const Path& path : paths) {
    if (path.points.empty()) continue;
    const std::string_view colour = kPathColours[drawn++ % kPathColours.size()];
    PathData data(frame);
    append_chain(data, path.points);
    out += "<g class=\"path\">";
    for (const bool casing : {true, false}) {
      out += "<path";
      append_attribute(out, "stroke", casing ? kPage : colour);
      append_attribute(out, "stroke-width", strokes.path * (casing ? 1.9 : 1.0));
      append_attribute(out, "d", data.text());
      out += "/>";
    }
    out += "</g>\n";
    markers += start_marker(frame.to_pixels(path.points.front()), strokes.marker) + "\n";
    markers += goal_marker(frame.to_pixels(path.points.back()), strokes.marker, colour) + "\n";
  }
  return out + "</g>\n<g id=\"ends\">\n" + markers + "</g>\n";
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

std::string rounded(double value) {
  std::array<char, 40> digits{};
  return {digits.data(), base::write_rounded(digits.data(), digits.data() + digits.size(), value, 5)};
}

std::string line_sample(std::string_view colour, double stroke_width) {
  std::string out = "<path d=\"M1 8H27\" fill=\"none\" stroke-linecap=\"round\"";
  append_attribute(out, "stroke", colour);
  append_attribute(out, "stroke-width", stroke_width);
  return out + "/>";
}

std::string solid_sample() {
  std::string out = "<path d=\"M3 4L12 1L26 3L25 15L7 15Z\" stroke-width=\"1.5\" stroke-linejoin=\"round\"";
  append_attribute(out, "fill", kSolid);
  append_attribute(out, "stroke", kSolidEdge);
  return out + "/>";
}

std::string dot_sample() {
  std::string out = "<g";
  append_attribute(out, "fill", kPoint);
  return out + ">" + circle({14.0, 8.0}, 3.2) + "</g>";
}

/// Each path with its length; of more than there are colours, how many.
void add_path_entries(std::vector<LegendEntry>& entries, const std::vector<Path>& paths) {
  std::vector<LegendEntry> one_each;
  std::size_t count = 0;
  for (const Path& path : paths) {
    if (path.points.empty()) continue;
    const std::string_view colour = kPathColours[count++ % kPathColours.size()];
    one_each.push_back({line_sample(colour, 4.5), "path, length " + rounded(path.length)});
  }
  if (count == 0) return;
  if (count <= kPathColours.size()) {
    entries.insert(entries.end(), one_each.begin(), one_each.end());
  } else {
    entries.push_back({line_sample(kPathColours[0], 4.5), counted(count, "path", "paths")});
  }
  entries.push_back({start_marker({14.0, 8.0}, 7.0), "start"});
  entries.push_back({goal_marker({14.0, 8.0}, 6.5, kPathColours[0]), "goal"});
}

std::vector<LegendEntry> entries_for(const Things& things, const std::vector<Path>& paths, bool with_mesh,
                                     std::size_t triangle_count) {
  std::vector<LegendEntry> entries;
  const auto add = [&](std::size_t count, std::string sample, std::string_view one, std::string_view many) {
    if (count > 0) entries.push_back({std::move(sample), counted(count, one, many)});
  };
  add(things.solids.size(), solid_sample(), "solid", "solids");
  add(things.walls.size(), line_sample(kWall, 3.2), "wall", "walls");
  add(things.dots.size(), dot_sample(), "point", "points");
  if (with_mesh) add(triangle_count, line_sample(kMesh, 1.2), "triangle", "triangles");
  add_path_entries(entries, paths);
  return entries;
}

std::string draw_rectangle(double x, double y, double width, double height, std::string_view style) {
  std::string out = "<rect";
  append_attribute(out, "x", x);
  append_attribute(out, "y", y);
  append_attribute(out, "width", width);
  append_attribute(out, "height", height);
  return out + std::string(style) + "/>\n";
}

std::string draw_head(double width, double height, std::string_view title) {
  std::string out = R"(<svg xmlns="http://www.w3.org/2000/svg")";
  append_attribute(out, "width", width);
  append_attribute(out, "height", height);
  out += " viewBox=\"0 0 ";
  append_pixels(out, width);
  out += ' ';
  append_pixels(out, height);
  out += "\" font-family=\"'Segoe UI', 'Helvetica Neue', Arial, sans-serif\">\n";
  if (!title.empty()) {
    out += "<title>";
    append_escaped(out, title);
    out += "</title>\n";
  }
  out += draw_rectangle(0.0, 0.0, width, height, " fill=\"" + std::string(kPage) + "\"");
  if (title.empty()) return out;
  out += R"(<text id="title" x="20" y="38" font-size="22" font-weight="600" fill="#22303c">)";
  append_escaped(out, title);
  return out + "</text>\n";
}

double usable_width(double width) {
  return std::isfinite(width) ? std::clamp(width, kNarrowest, kWidest) : kDefaultWidth;
}

}  // namespace

std::string to_svg(const World& world, const std::vector<Path>& paths, const SvgOptions& options) {
  const base::FloatEnvironment environment;
  const double width = usable_width(options.width);
  const Frame frame(world.domain(), width, options.title.empty() ? kTopMargin : kTitleHeight, options.y_down);
  const Things things = things_of(world);
  const Strokes strokes = strokes_for(frame, world.vertex_count(), paths.size());
  const auto entries = entries_for(things, paths, options.mesh, world.triangle_count());

  std::string out = draw_head(width, frame.bottom() + legend_height(entries, width), options.title);
  const auto map_box = [&](std::string_view style) {
    return draw_rectangle(frame.left(), frame.top(), frame.width(), frame.height(), style);
  };
  out += map_box(" fill=\"" + std::string(kGround) + "\"");
  if (options.mesh) out += draw_mesh(world.snapshot(), frame, strokes.mesh);
  out += draw_solids(things.solids, frame, strokes.solid);
  out += draw_walls(things.walls, frame, strokes.wall);
  out += draw_dots(things.dots, frame, strokes.dot);
  out += map_box(" fill=\"none\" stroke=\"" + std::string(kWall) + "\" stroke-width=\"2\"");
  out += draw_paths(paths, frame, strokes);
  out += io::legend(entries, width, frame.bottom());
  return out + "</svg>\n";
}

}  // namespace waywright
