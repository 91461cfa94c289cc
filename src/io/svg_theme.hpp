#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "waywright/svg.hpp"

namespace waywright::io {

/// What a colour of the theme is for.
enum class Ink : std::uint8_t {
  none,
  page,
  ground,
  mesh,
  solid,
  solid_edge,
  wall,
  point,
  text,
  quiet_text,
  start,
  path_1,
  path_2,
  path_3,
  path_4,
  ray,
  failed,
  in_face,
  on_edge,
  on_vertex,
  covered,
  caller,
};

/// A colour of the theme or, where `own` is not empty, one of the caller's, any bytes.
struct Paint {
  Ink ink = Ink::none;
  std::string_view own = {};
};

/// Writes colours: as attributes, which every program reads, and for SvgTheme::automatic also as classes, by which a
/// style sheet makes them dark.
class Palette {
 public:
  explicit Palette(SvgTheme theme) : theme_(theme) {}

  /// ` fill="..." stroke="..."`, and the classes of both.
  void append(std::string& out, const Paint& fill, const Paint& stroke) const;
  [[nodiscard]] std::string operator()(const Paint& fill, const Paint& stroke) const;

  /// The style sheet; empty for a theme that needs none.
  [[nodiscard]] std::string style() const;

 private:
  [[nodiscard]] std::string_view value(Ink ink) const;

  SvgTheme theme_;
};

}  // namespace waywright::io
