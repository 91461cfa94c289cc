#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/point.hpp"
#include "waywright/svg.hpp"

#include "base/float_environment.hpp"
#include "base/number_text.hpp"
#include "svg/drawings.hpp"
#include "svg/elements.hpp"
#include "svg/theme.hpp"
#include "svg/ticks.hpp"

// The page of a picture: where its parts lie, the title, the axes and the legend; and the two public functions.

namespace waywright {

namespace svg {

namespace {

/// Where the map, the title, the ticks and the legend of a picture lie, in pixels from the upper left corner of the
/// picture.
struct Layout {
  SvgFrame frame;             ///< where the map lies, and its scale
  double width = 0.0;         ///< the width of the picture
  double text_left = 0.0;     ///< the left end of the title and of the legend
  double legend_top = 0.0;    ///< the top of the legend: the map and the labels of its ticks lie above it
  std::vector<Tick> x_ticks;  ///< the ticks below the map
  std::vector<Tick> y_ticks;  ///< the ticks on the left of the map
};

constexpr double kPageMargin = 20.0;
constexpr double kTickLength = 5.0;
constexpr double kTickFont = 12.0;
constexpr double kTickCharacter = 7.2;  // the largest width of a digit in the font of the ticks

constexpr double kNarrowest = 240.0;  // least width of a picture, in pixels
constexpr double kWidest = 100000.0;  // largest width of a picture, in pixels
constexpr double kDefaultWidth = 1200.0;
constexpr double kTitleHeight = 58.0;
constexpr double kTallest = 1.5;      // largest height of a map, as a multiple of its width
constexpr double kLeastPanel = 48.0;  // least height of the band that contains the map, in pixels
constexpr double kTickStrip = 24.0;   // height of the labels of x below the map
constexpr double kLeastSpacingX = 70.0;
constexpr double kLeastSpacingY = 48.0;
constexpr double kRoomy = 480.0;  // from this width on, title and legend start at the left border of the map

std::string text_of(const Box& box) {
  std::string text = "(";
  base::append_number(text, box.min.x);
  text += ", ";
  base::append_number(text, box.min.y);
  text += ") to (";
  base::append_number(text, box.max.x);
  text += ", ";
  base::append_number(text, box.max.y);
  return text += ')';
}

std::optional<Error> find_crop_error(const Box& domain, const Box& crop) {
  const auto error = [&](ErrorCode code, const std::string& fault) {
    return Error{code, "the crop box, " + text_of(crop) + "," + fault, {}, 0};
  };
  if (!is_in_range(crop.min) || !is_in_range(crop.max)) {
    return error(ErrorCode::coordinate_range,
                 " has a coordinate that is not finite, beyond +-2^100, or nearer to 0 than 2^-100");
  }
  if (!(crop.min.x < crop.max.x && crop.min.y < crop.max.y)) {
    return error(ErrorCode::bad_domain,
                 " is empty: each coordinate of its first corner must be less than that of its second");
  }
  const bool is_apart = crop.max.x <= domain.min.x || crop.min.x >= domain.max.x || crop.max.y <= domain.min.y ||
                        crop.min.y >= domain.max.y;
  if (is_apart) {
    return error(ErrorCode::out_of_domain, " shows nothing of the domain, " + text_of(domain));
  }
  return std::nullopt;
}

double usable_width(double width) {
  return std::isfinite(width) ? std::clamp(width, kNarrowest, kWidest) : kDefaultWidth;
}

/// Returns how many pixels show one unit of the world, so that the map is not wider than `map_width`. A box may be
/// 2^200 times as long as it is wide. Then its shorter side has almost no pixels, and the map looks like a line.
double scale_for(const Box& shown, double map_width) {
  return std::min(map_width / (shown.max.x - shown.min.x), map_width * kTallest / (shown.max.y - shown.min.y));
}

std::vector<Tick> ticks_of_y(const Box& shown, double scale) {
  return ticks_between(shown.min.y, shown.max.y, {scale, kLeastSpacingY, 0.0});
}

/// Returns the width of the space on the left of the map. The y labels of the widest possible map fit into it.
double left_margin(const Box& shown, const SvgOptions& options, double width) {
  if (!options.axes) return kPageMargin;
  const double widest = width - 2.0 * kPageMargin;
  const auto characters = static_cast<double>(longest_label(ticks_of_y(shown, scale_for(shown, widest))));
  return std::clamp(characters * kTickCharacter + kTickLength + 14.0, kPageMargin, std::max(0.4 * width, kPageMargin));
}

/// Computes the layout of a picture of `domain`, or of the crop box in `options`. The map has the proportions of that
/// box. Errors: the errors of to_svg().
Result<Layout> lay_out(const Box& domain, const SvgOptions& options) {
  const Box shown = options.crop.value_or(domain);
  if (auto error = find_crop_error(domain, shown)) return *std::move(error);

  const double width = usable_width(options.width);
  const double left = left_margin(shown, options, width);
  const double top = options.title.empty() ? kPageMargin : kTitleHeight;
  const double room = width - left - kPageMargin;
  const double scale = scale_for(shown, room);
  const double map_width = (shown.max.x - shown.min.x) * scale;
  const double map_height = (shown.max.y - shown.min.y) * scale;
  const double panel = std::max(map_height, kLeastPanel);
  const Point corner{left + (room - map_width) / 2.0, top + (panel - map_height) / 2.0};

  Layout layout{SvgFrame(shown, corner, scale, options.y_down), width, kPageMargin, top + panel + kPageMargin, {}, {}};
  if (width >= kRoomy) layout.text_left = left;
  if (options.axes) {
    layout.legend_top += kTickStrip;
    layout.x_ticks = ticks_between(shown.min.x, shown.max.x, {scale, kLeastSpacingX, kTickCharacter});
    layout.y_ticks = ticks_of_y(shown, scale);
  }
  return layout;
}

constexpr double kRowHeight = 26.0;
constexpr double kSampleSpace = 8.0;      // between a sample and its label
constexpr double kSpacing = 26.0;         // between entries
constexpr double kLegendCharacter = 7.6;  // width of a wide character; the real fonts are not known here

double entry_width(const LegendEntry& entry) {
  return entry.sample_width + kSampleSpace + static_cast<double>(character_count(entry.label)) * kLegendCharacter +
         kSpacing;
}

/// Returns the position of each entry, in rows that fit the width.
std::vector<Point> arrange(const std::vector<LegendEntry>& entries, double left, double width) {
  std::vector<Point> positions;
  Point next{left, 0.0};
  for (const LegendEntry& entry : entries) {
    const double needed = entry_width(entry) - kSpacing;
    if (next.x > left && next.x + needed > width - kPageMargin) next = {left, next.y + kRowHeight};
    positions.push_back(next);
    next.x += entry_width(entry);
  }
  return positions;
}

/// Returns the legend as one SVG group, in rows that fit the picture's width. Its upper left corner is (`left`, `top`).
/// Writes the height of the legend, including the lower margin, to `height`.
std::string legend(const std::vector<LegendEntry>& entries, const Palette& palette, double width, double left,
                   double top, double& height) {
  height = 0.0;
  std::string out = R"(<g id="legend" font-size="14")" + palette({Ink::quiet_text}, {Ink::none}) + ">\n";
  const std::vector<Point> positions = arrange(entries, left, width);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    out += "<g transform=\"translate(";
    append_pixels(out, positions[i].x);
    out += ' ';
    append_pixels(out, top + positions[i].y);
    out += ")\">";
    out += entries[i].sample;
    out += "<text";
    append_attribute(out, "x", entries[i].sample_width + kSampleSpace);
    append_attribute(out, "y", 13.0);
    out += '>';
    append_escaped(out, entries[i].label);
    out += "</text></g>\n";
    height = positions[i].y + kRowHeight + kPageMargin / 2.0;
  }
  return out + "</g>\n";
}

constexpr double kScaleBar = 120.0;  // largest length in pixels

void append_line(std::string& data, const Point& from, const Point& to) {
  for (const auto& [letter, position] : {std::pair{'M', from}, std::pair{'L', to}}) {
    data += letter;
    append_pixels(data, position.x);
    data += ' ';
    append_pixels(data, position.y);
  }
}

std::string label(const Point& at, std::string_view anchor, const std::string& text) {
  std::string out = "<text";
  append_attribute(out, "x", at.x);
  append_attribute(out, "y", at.y);
  append_attribute(out, "text-anchor", anchor);
  return out + ">" + text + "</text>\n";
}

/// Returns a bar between two end strokes, 16 pixels high.
std::string bar_sample(double length, const Palette& palette) {
  std::string data;
  append_line(data, {1.0, 8.0}, {length + 1.0, 8.0});
  append_line(data, {1.0, 4.0}, {1.0, 12.0});
  append_line(data, {length + 1.0, 4.0}, {length + 1.0, 12.0});
  return "<path id=\"scale-bar\" d=\"" + data + "\" stroke-width=\"1.5\"" + palette({Ink::none}, {Ink::quiet_text}) +
         "/>";
}

/// Returns two arrows from one corner: x to the right, y up or down.
std::string directions_sample(bool y_down, const Palette& palette) {
  const std::string_view data =
      y_down ? "M4 2H19M16 -1L19 2L16 5M4 2V15M1 12L4 15L7 12" : "M4 14H19M16 11L19 14L16 17M4 14V1M1 4L4 1L7 4";
  return "<path d=\"" + std::string(data) +
         "\" stroke-width=\"1.5\" stroke-linecap=\"round\" stroke-linejoin=\"round\"" +
         palette({Ink::none}, {Ink::quiet_text}) + "/>";
}

/// Draws the ticks below and to the left of the map, with their coordinates.
std::string draw_axes(const Layout& layout, const Palette& palette) {
  const Box& map = layout.frame.map();
  const Point& origin = layout.frame.shown().min;
  std::string marks;
  std::string labels;
  for (const Tick& tick : layout.x_ticks) {
    const double x = layout.frame.to_picture({tick.position, origin.y}).x;
    append_line(marks, {x, map.max.y + 1.0}, {x, map.max.y + 1.0 + kTickLength});
    const double half = static_cast<double>(tick.label.size()) * kTickCharacter / 2.0 + 3.0;
    const double middle = std::max(std::min(x, layout.width - half), half);
    labels += label({middle, map.max.y + kTickLength + 14.0}, "middle", tick.label);
  }
  for (const Tick& tick : layout.y_ticks) {
    const double y = layout.frame.to_picture({origin.x, tick.position}).y;
    append_line(marks, {map.min.x - 1.0, y}, {map.min.x - 1.0 - kTickLength, y});
    labels += label({map.min.x - kTickLength - 4.0, y + 4.0}, "end", tick.label);
  }
  std::string out = "<g id=\"axes\"";
  append_attribute(out, "font-size", kTickFont);
  out += palette({Ink::quiet_text}, {Ink::none}) + ">\n<path d=\"" + marks + "\" stroke-width=\"1\"";
  return out + palette({Ink::none}, {Ink::quiet_text}) + "/>\n" + labels + "</g>\n";
}

/// Adds a scale bar, and a sign that shows the direction of y.
void add_axes_entries(std::vector<LegendEntry>& entries, const Layout& layout, bool y_down, const Palette& palette) {
  const double scale = layout.frame.scale();
  const Tick length = scale_bar_length(kScaleBar / scale);
  const double pixels = length.position * scale;
  entries.push_back({bar_sample(pixels, palette), length.label, pixels + 2.0});
  entries.push_back({directions_sample(y_down, palette), y_down ? "y down" : "y up", 20.0});
}

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
  const double room = layout.width - layout.text_left - kPageMargin;
  const auto most = static_cast<std::size_t>(room / (kLeastTitleFont * kTitleCharacter));
  const std::string shown = shortened(title, most);
  const auto characters = static_cast<double>(character_count(shown));
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
    append_hint(out, title);
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

}  // namespace svg

SvgFrame::SvgFrame(const Box& shown, Point corner, double scale, bool y_down)
    : shown_(shown),
      map_{corner, {corner.x + (shown.max.x - shown.min.x) * scale, corner.y + (shown.max.y - shown.min.y) * scale}},
      scale_(scale),
      y_down_(y_down) {}

Point SvgFrame::to_picture(Point point) const {
  const double down = y_down_ ? point.y - shown_.min.y : shown_.max.y - point.y;
  return {map_.min.x + (point.x - shown_.min.x) * scale_, map_.min.y + down * scale_};
}

Point SvgFrame::to_world(Point pixels) const {
  const double down = (pixels.y - map_.min.y) / scale_;
  return {shown_.min.x + (pixels.x - map_.min.x) / scale_, y_down_ ? shown_.min.y + down : shown_.max.y - down};
}

Result<SvgFrame> svg_frame(const Box& domain, const SvgOptions& options) {
  const base::FloatEnvironment environment;
  Result<svg::Layout> layout = svg::lay_out(domain, options);
  if (!layout.ok()) return layout.error();
  return layout->frame;
}

Result<std::string> to_svg(const World& world, const SvgOverlay& overlay, const SvgOptions& options) {
  const base::FloatEnvironment environment;
  const Result<svg::Layout> laid_out = svg::lay_out(world.domain(), options);
  if (!laid_out.ok()) return laid_out.error();
  const svg::Layout& layout = *laid_out;
  const SvgFrame& frame = layout.frame;
  const svg::Palette palette(options.theme);

  svg::WorldDrawing drawing = svg::draw_world(world, frame, options, palette);
  svg::OverlayDrawing discs = svg::draw_disc_paths(world, overlay, frame, palette);
  svg::OverlayDrawing queries = svg::draw_queries(overlay, frame, palette);
  svg::OverlayDrawing additions = svg::draw_additions(overlay, frame, palette);
  std::vector<svg::LegendEntry> entries = std::move(drawing.entries);
  svg::append_entries(entries, discs.entries);
  svg::append_entries(entries, queries.entries);
  svg::append_entries(entries, additions.entries);
  if (options.axes) svg::add_axes_entries(entries, layout, options.y_down, palette);
  double legend_height = 0.0;
  const std::string legend =
      svg::legend(entries, palette, layout.width, layout.text_left, layout.legend_top, legend_height);

  std::string out = svg::draw_head(layout, layout.legend_top + legend_height, palette, options.title);
  out += svg::clip_path(frame, options.crop.has_value());
  if (options.axes) out += svg::draw_axes(layout, palette);
  out += svg::clipped("map", drawing.elements + discs.clipped + queries.clipped);
  if (options.crop) out += svg::rectangle(frame.map()) + palette({svg::Ink::none}, {svg::Ink::quiet_text}) + "/>\n";
  out += discs.whole;
  out += queries.whole;
  out += svg::clipped("additions", additions.clipped);
  out += additions.whole;
  out += legend;
  return out + "</svg>\n";
}

}  // namespace waywright
