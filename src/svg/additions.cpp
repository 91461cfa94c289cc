#include <algorithm>
#include <cmath>
#include <string>

#include "svg/drawings.hpp"
#include "svg/elements.hpp"
#include "svg/path_data.hpp"

namespace waywright::svg {

namespace {

constexpr double kLeastRadius = 3.0;    // of a disc, in pixels
constexpr double kLetter = 0.58;        // width of a letter, as a fraction of the font size
constexpr double kLabelDistance = 8.0;  // pixels between a disc and its label

Paint paint_of(const std::string& colour, Ink otherwise) { return {otherwise, colour}; }

/// Returns the value, limited to the range, or `least` if it is not a number.
double within(double value, double least, double most) { return value >= least ? std::min(value, most) : least; }

std::string draw_polyline(const SvgPolyline& line, const SvgFrame& frame, const Palette& palette) {
  PathData data(frame);
  data.add_chain(line.points);
  if (data.empty()) return {};
  const double width = within(line.width, 0.1, 60.0);
  std::string out = "<path d=\"" + data.text() + "\"";
  palette.append(out, {Ink::none}, paint_of(line.colour, Ink::caller));
  append_attribute(out, "stroke-width", width);
  if (line.dashed) {
    std::string dashes;
    append_pixels(dashes, width * 3.0);
    append_attribute(out, "stroke-dasharray", dashes);
  }
  if (line.hint.empty()) return out + "/>\n";
  out += '>';
  append_hint(out, line.hint);
  return out + "</path>\n";
}

std::string draw_disc(const SvgDisc& disc, const SvgFrame& frame, const Palette& palette) {
  const Point centre = frame.to_picture(disc.centre);
  const double radius = within(disc.radius * frame.scale(), kLeastRadius, 1e7);
  if (!is_finite(centre) || !meets(frame.map(), centre, radius)) return {};
  return disc_mark(palette, centre, radius, paint_of(disc.colour, Ink::caller), {Ink::page}, 1.5, disc.hint) + "\n";
}

std::string draw_label(const SvgLabel& label, const SvgFrame& frame, const Palette& palette) {
  if (!contains(frame.shown(), label.at) || label.text.empty()) return {};
  const double size = within(label.size, 4.0, 200.0);
  TextMark text{frame.to_picture(label.at), "start", size, paint_of(label.colour, Ink::text)};
  const double distance = kLabelDistance + within(label.radius * frame.scale(), 0.0, 1e7);
  const double room = distance + kLetter * size * static_cast<double>(character_count(label.text));
  const Box& map = frame.map();
  const bool is_left = text.at.x + room > map.max.x && text.at.x - room >= map.min.x;
  if (is_left) text.anchor = "end";
  text.at.x += is_left ? -distance : distance;
  text.at.y += 0.35 * size;
  return text_mark(palette, text, label.text) + "\n";
}

}  // namespace

OverlayDrawing draw_additions(const SvgOverlay& overlay, const SvgFrame& frame, const Palette& palette) {
  OverlayDrawing drawing;
  drawing.clipped = "<g id=\"polylines\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (const SvgPolyline& line : overlay.polylines) drawing.clipped += draw_polyline(line, frame, palette);
  drawing.clipped += "</g>\n<g id=\"discs\">\n";
  for (const SvgDisc& disc : overlay.discs) drawing.clipped += draw_disc(disc, frame, palette);
  drawing.clipped += "</g>\n";
  if (!overlay.elements.empty()) drawing.clipped += "<g id=\"elements\">" + overlay.elements + "</g>\n";
  drawing.whole = "<g id=\"labels\">\n";
  for (const SvgLabel& label : overlay.labels) drawing.whole += draw_label(label, frame, palette);
  drawing.whole += "</g>\n";
  for (const SvgKey& key : overlay.keys) {
    const Paint colour = paint_of(key.colour, Ink::caller);
    drawing.entries.push_back({disc_mark(palette, {14.0, 8.0}, 6.0, colour, {Ink::none}, 0.0), key.text});
  }
  return drawing;
}

}  // namespace waywright::svg
