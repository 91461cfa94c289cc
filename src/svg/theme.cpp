#include "svg/theme.hpp"

#include <array>
#include <cstddef>

#include "svg/elements.hpp"

namespace waywright::svg {

namespace {

struct Colours {
  Ink ink;
  std::string_view name;
  std::string_view light;
  std::string_view dark;
};

// Greys for the world, bright colours for what moves in it. Lightness and shape distinguish them without colour vision.
// Paths have those colours of Okabe and Ito that stand out from the greys, and lighter ones in the dark theme.
constexpr std::array<Colours, 23> kColours{{
    {Ink::none, "none", "none", "none"},
    {Ink::page, "page", "#ffffff", "#12171d"},
    {Ink::ground, "ground", "#faf8f3", "#1b222a"},
    {Ink::mesh, "mesh", "#b8c8d6", "#3a4a59"},
    {Ink::solid, "solid", "#a9b4bf", "#4b5865"},
    {Ink::solid_outline, "solid-outline", "#5d6b78", "#8796a5"},
    {Ink::wall, "wall", "#22303c", "#e3e9ee"},
    {Ink::point, "point", "#56789a", "#8fb0d0"},
    {Ink::text, "text", "#22303c", "#e6ebf0"},
    {Ink::quiet_text, "quiet-text", "#3b4650", "#b4c0cb"},
    {Ink::start, "start", "#0072b2", "#56b4e9"},
    {Ink::path_1, "path-1", "#d55e00", "#ff9145"},
    {Ink::path_2, "path-2", "#0072b2", "#56b4e9"},
    {Ink::path_3, "path-3", "#009e73", "#2fc498"},
    {Ink::path_4, "path-4", "#cc79a7", "#e39ac4"},
    {Ink::ray, "ray", "#6a3d9a", "#b9a0f0"},
    {Ink::failed, "failed", "#b3123a", "#ff6b81"},
    {Ink::in_face, "in-face", "#00856f", "#35d0b0"},
    {Ink::on_edge, "on-edge", "#b87a00", "#f2c14e"},
    {Ink::on_vertex, "on-vertex", "#22303c", "#e3e9ee"},
    {Ink::covered, "covered", "#c1121f", "#ff6b6b"},
    {Ink::gap, "gap", "#b87a00", "#f2c14e"},
    {Ink::caller, "caller", "#0b7285", "#66d9e8"},
}};

const Colours& colours_of(Ink ink) { return kColours[static_cast<std::size_t>(ink)]; }

static_assert([] {
  for (std::size_t i = 0; i < kColours.size(); ++i) {
    if (static_cast<std::size_t>(kColours[i].ink) != i) return false;
  }
  return true;
}());

void append_rule(std::string& out, char letter, std::string_view property, const Colours& colours) {
  out += '.';
  out += letter;
  out += '-';
  out += colours.name;
  out += '{';
  out += property;
  out += ':';
  out += colours.dark;
  out += '}';
}

bool has_class(const Paint& paint) { return paint.own.empty() && paint.ink != Ink::none; }

void append_colour(std::string& out, std::string_view name, std::string_view own, std::string_view themed) {
  out += ' ';
  out += name;
  out += "=\"";
  if (own.empty()) {
    out += themed;
  } else {
    append_escaped(out, own);
  }
  out += '"';
}

}  // namespace

std::string_view Palette::value(Ink ink) const {
  return theme_ == SvgTheme::dark ? colours_of(ink).dark : colours_of(ink).light;
}

void Palette::append(std::string& out, const Paint& fill, const Paint& stroke) const {
  if (theme_ == SvgTheme::automatic && (has_class(fill) || has_class(stroke))) {
    out += " class=\"";
    if (has_class(fill)) out.append("f-").append(colours_of(fill.ink).name);
    if (has_class(fill) && has_class(stroke)) out += ' ';
    if (has_class(stroke)) out.append("s-").append(colours_of(stroke.ink).name);
    out += '"';
  }
  append_colour(out, "fill", fill.own, value(fill.ink));
  append_colour(out, "stroke", stroke.own, value(stroke.ink));
}

std::string Palette::operator()(const Paint& fill, const Paint& stroke) const {
  std::string out;
  append(out, fill, stroke);
  return out;
}

std::string Palette::style() const {
  if (theme_ != SvgTheme::automatic) return {};
  std::string out = "<style>@media (prefers-color-scheme:dark){";
  for (const Colours& colours : kColours) {
    if (colours.ink == Ink::none) continue;
    append_rule(out, 'f', "fill", colours);
    append_rule(out, 's', "stroke", colours);
  }
  return out + "}</style>\n";
}

}  // namespace waywright::svg
