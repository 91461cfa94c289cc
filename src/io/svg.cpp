#include "waywright/svg.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "base/float_environment.hpp"
#include "io/svg_axes.hpp"
#include "io/svg_canvas.hpp"
#include "io/svg_layout.hpp"
#include "io/svg_legend.hpp"
#include "io/svg_overlay.hpp"
#include "io/svg_theme.hpp"
#include "io/svg_world.hpp"

namespace waywright {

namespace {

using io::append_attribute;
using io::append_escaped;
using io::append_pixels;
using io::Ink;
using io::Layout;
using io::LegendEntry;
using io::OverlayDrawing;
using io::Palette;
using io::WorldDrawing;

constexpr double kTitleFont = 22.0;
constexpr double kLeastTitleFont = 11.0;
constexpr double kTitleCharacter = 0.62;  // width of a bold letter, as a fraction of the font size

std::string rectangle(const Box& box) {
  std::string out = "<rect";
  append_attribute(out, "x", box.min.x);
  append_attribute(out, "y", box.min.y);
  append_attribute(out, "width", box.max.x - box.min.x);
  append_attribute(out, "height", box.max.y - box.min.y);
  return out;
}

/// Draws the title on one line. Uses smaller letters for a long title, and shortens it if these would be too small to
/// read.
std::string draw_title(const Layout& layout, const Palette& palette, const std::string& title) {
  if (title.empty()) return {};
  const double room = layout.width - layout.text_left - io::kPageMargin;
  const auto most = static_cast<std::size_t>(room / (kLeastTitleFont * kTitleCharacter));
  const std::string shown = io::shortened(title, most);
  const auto characters = static_cast<double>(io::character_count(shown));
  std::string out = R"(<text id="title" y="38" font-weight="600")";
  append_attribute(out, "x", layout.text_left);
  append_attribute(out, "font-size", std::clamp(room / (characters * kTitleCharacter), kLeastTitleFont, kTitleFont));
  palette.append(out, {Ink::text}, {Ink::none});
  out += '>';
  append_escaped(out, shown);
  return out + "</text>\n";
}

std::string draw_head(const Layout& layout, double height, const Palette& palette, const std::string& title) {
  std::string out = R"(<svg xmlns="http://www.w3.org/2000/svg")";
  append_attribute(out, "width", layout.width);
  append_attribute(out, "height", height);
  out += " viewBox=\"0 0 ";
  append_pixels(out, layout.width);
  out += ' ';
  append_pixels(out, height);
  out += "\" font-family=\"'Segoe UI', 'Helvetica Neue', Arial, sans-serif\">\n";
  if (!title.empty()) {
    io::append_hint(out, title);
    out += '\n';
  }
  out += palette.style();
  out += rectangle({{0.0, 0.0}, {layout.width, height}}) + palette({Ink::page}, {Ink::none}) + "/>\n";
  return out + draw_title(layout, palette, title);
}

/// Defines the area at whose border the map is cut. If the picture shows the whole domain, the area has room for its
/// border.
std::string clip_path(const SvgFrame& frame, bool is_cropped) {
  const double rim = is_cropped ? 0.0 : 1.0;
  const Box& map = frame.map();
  return "<clipPath id=\"map-box\">" +
         rectangle({{map.min.x - rim, map.min.y - rim}, {map.max.x + rim, map.max.y + rim}}) + "/></clipPath>\n";
}

std::string clipped(std::string_view id, const std::string& elements) {
  return "<g id=\"" + std::string(id) + "\" clip-path=\"url(#map-box)\">\n" + elements + "</g>\n";
}

void append_entries(std::vector<LegendEntry>& entries, std::vector<LegendEntry>& more) {
  for (LegendEntry& entry : more) entries.push_back(std::move(entry));
}

}  // namespace

Result<std::string> to_svg(const World& world, const SvgOverlay& overlay, const SvgOptions& options) {
  const base::FloatEnvironment environment;
  const Result<Layout> laid_out = io::lay_out(world.domain(), options);
  if (!laid_out.ok()) return laid_out.error();
  const Layout& layout = *laid_out;
  const SvgFrame& frame = layout.frame;
  const Palette palette(options.theme);

  WorldDrawing drawing = io::draw_world(world, frame, options, palette);
  OverlayDrawing discs = io::draw_disc_paths(world, overlay, frame, palette);
  OverlayDrawing queries = io::draw_queries(overlay, frame, palette);
  OverlayDrawing additions = io::draw_additions(overlay, frame, palette);
  std::vector<LegendEntry> entries = std::move(drawing.entries);
  append_entries(entries, discs.entries);
  append_entries(entries, queries.entries);
  append_entries(entries, additions.entries);
  if (options.axes) io::add_axes_entries(entries, layout, options.y_down, palette);
  double legend_height = 0.0;
  const std::string legend =
      io::legend(entries, palette, layout.width, layout.text_left, layout.legend_top, legend_height);

  std::string out = draw_head(layout, layout.legend_top + legend_height, palette, options.title);
  out += clip_path(frame, options.crop.has_value());
  if (options.axes) out += io::draw_axes(layout, palette);
  out += clipped("map", drawing.elements + discs.clipped + queries.clipped);
  if (options.crop) out += rectangle(frame.map()) + palette({Ink::none}, {Ink::quiet_text}) + "/>\n";
  out += discs.whole;
  out += queries.whole;
  out += clipped("additions", additions.clipped);
  out += additions.whole;
  out += legend;
  return out + "</svg>\n";
}

}  // namespace waywright
