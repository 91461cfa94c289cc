#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace waywright::io {

/// A round number on an axis.
struct Tick {
  double place = 0.0;  ///< the nearest double to what the label says
  std::string label;
};

/// How much room labels need: pixels for each character along the axis, or lines of text.
struct TickRoom {
  double pixels_per_unit = 1.0;
  double least_spacing = 70.0;        ///< in pixels
  double pixels_per_character = 0.0;  ///< 0 where labels do not lie along the axis
};

/// Round numbers from `min` to `max`: multiples of 1, 2 or 5 times a power of ten, as close as the room allows. Their
/// labels are all in fixed notation, or all in scientific notation where the others are long and these are shorter.
[[nodiscard]] std::vector<Tick> ticks_between(double min, double max, const TickRoom& room);

/// The largest number of the form 1, 2 or 5 times a power of ten that is no more than `most`: the length of a scale
/// bar.
[[nodiscard]] Tick scale_bar_length(double most);

/// The number of characters of the longest label.
[[nodiscard]] std::size_t longest_label(const std::vector<Tick>& ticks);

}  // namespace waywright::io
