#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "waywright/svg.hpp"

namespace waywright::svg {

/// The use of a colour in the theme.
enum class Ink : std::uint8_t {
  none,
  page,
  ground,
  mesh,
  solid,
  solid_outline,
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
  gap,
  caller,
};

/// A colour of the theme, or a colour of the caller if `own` is not empty. `own` may contain any bytes.
struct Paint {
  Ink ink = Ink::none;
  std::string_view own = {};
};

/// Writes colours as attributes, which every program understands. For SvgTheme::automatic it also writes classes. The
/// style sheet uses them to select the dark colours.
class Palette {
 public:
  explicit Palette(SvgTheme theme) : theme_(theme) {}

  /// Appends ` fill="..." stroke="..."` and the classes of both.
  void append(std::string& out, const Paint& fill, const Paint& stroke) const;
  [[nodiscard]] std::string operator()(const Paint& fill, const Paint& stroke) const;

  /// Returns the style sheet, or an empty text if the theme needs none.
  [[nodiscard]] std::string style() const;

 private:
  [[nodiscard]] std::string_view value(Ink ink) const;

  SvgTheme theme_;
};

}  // namespace waywright::svg
