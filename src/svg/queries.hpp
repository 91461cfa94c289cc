#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "waywright/path.hpp"
#include "waywright/svg.hpp"

#include "svg/drawings.hpp"
#include "svg/elements.hpp"
#include "svg/path_data.hpp"
#include "svg/theme.hpp"

namespace waywright::svg {

inline constexpr std::array<Ink, 4> kPathInks{Ink::path_1, Ink::path_2, Ink::path_3, Ink::path_4};
inline constexpr std::size_t kManyQueries = 12;  // from this number on, marks and lines are small

/// Returns a number with at most five significant digits.
[[nodiscard]] std::string rounded(double value);

/// Returns the status in words, such as `no path`.
[[nodiscard]] std::string words_of(PathStatus status);

/// The statuses of queries without a path, and the number of queries with each.
inline constexpr std::array<PathStatus, 3> kFailures{PathStatus::no_path, PathStatus::start_blocked,
                                                     PathStatus::goal_blocked};
using FailureCounts = std::array<std::size_t, kFailures.size()>;
void count_failure(FailureCounts& counts, PathStatus status);

/// The drawing of queries so far, and what all of them share: the transform, the colours, the widths of lines and the
/// sizes of marks.
class QueryCanvas {
 public:
  QueryCanvas(const SvgOverlay& overlay, const SvgFrame& frame, const Palette& palette);

  [[nodiscard]] const SvgFrame& frame() const { return frame_; }
  [[nodiscard]] const Palette& palette() const { return palette_; }
  [[nodiscard]] double path_width() const { return path_width_; }
  [[nodiscard]] double end_radius() const { return end_radius_; }
  /// Returns the text, or an empty one if there are too many hints.
  [[nodiscard]] std::string hint(std::string text) const { return has_hints_ ? std::move(text) : std::string(); }
  [[nodiscard]] bool is_shown(const Point& position) const { return contains(frame_.shown(), position); }

  [[nodiscard]] OverlayDrawing& drawing() { return drawing_; }
  void add_mark(const std::string& mark) { drawing_.whole += mark + "\n"; }
  void add_entry(LegendEntry entry) { drawing_.entries.push_back(std::move(entry)); }
  void add_stroke(const PathData& data, const Paint& colour, double width, std::string_view attributes = {});
  /// Adds a line with a rim in the page's colour.
  void add_line(const PathData& data, const Paint& colour, double width, const std::string& about);

  /// Adds the marks at the ends of a path.
  void add_ends(const Point& start, const Point& goal, double radius, const Paint& colour);
  /// Adds the entries of both marks.
  void add_entries_of_ends();

  /// Adds the dashed line of a query without a path, and the marks at its ends. `radius` is the size of the marks.
  void add_failed_path(const SvgFailedPath& failed, double radius);
  /// Writes the status beside the middle of the line, where the line leaves room.
  void add_status(const SvgFailedPath& failed);
  /// Adds an entry for each status with a count above 0.
  void add_failures(const FailureCounts& counts, std::string_view one, std::string_view many);

 private:
  const SvgFrame& frame_;
  const Palette& palette_;
  OverlayDrawing drawing_;
  bool has_hints_ = true;
  double path_width_ = 0.0;
  double end_radius_ = 0.0;
};

}  // namespace waywright::svg
