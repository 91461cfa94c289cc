#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace waywright::svg {

/// A round number on an axis.
struct Tick {
  double position = 0.0;  ///< the double nearest to the number in the label
  std::string label;
};

/// The room that labels need: pixels for each character along the axis, or for lines of text.
struct TickRoom {
  double pixels_per_unit = 1.0;
  double least_spacing = 70.0;        ///< in pixels
  double pixels_per_character = 0.0;  ///< 0 if labels do not lie along the axis
};

/// Returns round numbers from `min` to `max`: multiples of 1, 2 or 5 times a power of ten, as dense as the room allows.
/// All labels have fixed notation, or all have scientific notation if the fixed labels are long and the scientific ones
/// shorter.
[[nodiscard]] std::vector<Tick> ticks_between(double min, double max, const TickRoom& room);

/// Returns the largest number that is at most `most` and has the form 1, 2 or 5 times a power of ten: the length of a
/// scale bar.
[[nodiscard]] Tick scale_bar_length(double most);

/// The number of characters of the longest label.
[[nodiscard]] std::size_t longest_label(const std::vector<Tick>& ticks);

}  // namespace waywright::svg
