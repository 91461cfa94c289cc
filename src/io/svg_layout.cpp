#include "io/svg_layout.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/float_environment.hpp"
#include "text/text.hpp"

namespace waywright {

namespace io {

namespace {

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
  text::append_number(text, box.min.x);
  text += ", ";
  text::append_number(text, box.min.y);
  text += ") to (";
  text::append_number(text, box.max.x);
  text += ", ";
  text::append_number(text, box.max.y);
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

}  // namespace

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

}  // namespace io

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
  Result<io::Layout> layout = io::lay_out(domain, options);
  if (!layout.ok()) return layout.error();
  return layout->frame;
}

}  // namespace waywright
