#include "io/svg_query_canvas.hpp"

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "io/svg_marks.hpp"
#include "io/svg_world.hpp"

namespace waywright::io {

namespace {

constexpr std::size_t kMostMarkHints = 50000;  // largest number of marks with a hint

}  // namespace

std::string rounded(double value) {
  std::array<char, 40> digits{};
  return {digits.data(), base::write_rounded(digits.data(), digits.data() + digits.size(), value, 5)};
}

std::string words_of(PathStatus status) {
  std::string words(to_string(status));
  std::replace(words.begin(), words.end(), '-', ' ');
  return words;
}

void count_failure(FailureCounts& counts, PathStatus status) {
  for (std::size_t i = 0; i < kFailures.size(); ++i) counts[i] += status == kFailures[i] ? 1 : 0;
}

QueryCanvas::QueryCanvas(const SvgOverlay& overlay, const SvgFrame& frame, const Palette& palette)
    : frame_(frame), palette_(palette) {
  const std::size_t path_count = overlay.disc_paths.size() + overlay.paths.size() + overlay.failed_paths.size();
  has_hints_ = path_count + overlay.rays.size() + overlay.locations.size() <= kMostMarkHints;
  const bool is_crowded = path_count >= kManyQueries;
  path_width_ = is_crowded ? 2.0 : 4.5;
  end_radius_ = is_crowded ? 4.0 : 8.0;
}

void QueryCanvas::add_stroke(const PathData& data, const Paint& colour, double width, std::string_view attributes) {
  drawing_.clipped += "<path d=\"" + data.text() + "\"";
  palette_.append(drawing_.clipped, {Ink::none}, colour);
  append_attribute(drawing_.clipped, "stroke-width", width);
  drawing_.clipped += attributes;
  drawing_.clipped += "/>";
}

void QueryCanvas::add_line(const PathData& data, const Paint& colour, double width, const std::string& about) {
  if (data.empty()) return;
  drawing_.clipped += "<g>";
  if (!about.empty()) append_hint(drawing_.clipped, about);
  add_stroke(data, {Ink::page}, width * 1.9);
  add_stroke(data, colour, width);
  drawing_.clipped += "</g>\n";
}

void QueryCanvas::add_ends(const Point& start, const Point& goal, double radius, const Paint& colour) {
  if (is_shown(start)) {
    add_mark(disc_mark(palette_, frame_.to_picture(start), radius, {Ink::start}, {Ink::page}, 2.0,
                       hint("start " + point_text(start))));
  }
  if (is_shown(goal)) {
    add_mark(goal_mark(palette_, frame_.to_picture(goal), radius, colour, hint("goal " + point_text(goal))));
  }
}

void QueryCanvas::add_entries_of_ends() {
  const Point centre{14.0, 8.0};
  add_entry({disc_mark(palette_, centre, 7.0, {Ink::start}, {Ink::page}, 2.0), "start"});
  add_entry({goal_mark(palette_, centre, 6.5, {kPathInks[0]}), "goal"});
}

void QueryCanvas::add_failed_path(const SvgFailedPath& failed, double radius) {
  const Paint colour{Ink::failed};
  const std::string reason = words_of(failed.status);
  const std::string ends = " from " + point_text(failed.start) + " to " + point_text(failed.goal);
  PathData data(frame_);
  data.add_segment(failed.start, failed.goal);
  const double width = path_width_ * 0.6;
  if (!data.empty()) {
    drawing_.clipped += "<g>";
    if (has_hints_) append_hint(drawing_.clipped, reason + ends);
    add_stroke(data, {Ink::page}, width * 1.9);
    add_stroke(data, colour, width, R"( stroke-dasharray="7 7")");
    drawing_.clipped += "</g>\n";
  }
  const double start_radius = radius * 0.85;
  if (is_shown(failed.start)) {
    add_mark(disc_mark(palette_, frame_.to_picture(failed.start), start_radius, {Ink::page}, colour, start_radius * 0.4,
                       hint("start " + point_text(failed.start) + ": " + reason)));
  }
  if (is_shown(failed.goal)) {
    add_mark(goal_mark(palette_, frame_.to_picture(failed.goal), radius, colour,
                       hint("goal " + point_text(failed.goal) + ": " + reason)));
  }
  const bool is_blocked = failed.status == PathStatus::start_blocked || failed.status == PathStatus::goal_blocked;
  const Point& blocked = failed.status == PathStatus::start_blocked ? failed.start : failed.goal;
  if (is_blocked && is_shown(blocked)) {
    add_mark(cross_mark(palette_, frame_.to_picture(blocked), radius * 1.25, colour, hint(reason)));
  }
}

void QueryCanvas::add_status(const SvgFailedPath& failed) {
  const Point middle{failed.start.x / 2.0 + failed.goal.x / 2.0, failed.start.y / 2.0 + failed.goal.y / 2.0};
  if (!is_shown(middle)) return;
  const Point start = frame_.to_picture(failed.start);
  const Point goal = frame_.to_picture(failed.goal);
  const Point step =
      goal.x < start.x ? Point{start.x - goal.x, start.y - goal.y} : Point{goal.x - start.x, goal.y - start.y};
  TextMark text{frame_.to_picture(middle), "start", 14.0, {Ink::failed}};
  if (std::abs(step.y) < 0.15 * step.x) {
    text.anchor = "middle";
    text.at.y -= 12.0;
  } else {
    text.at.x += 10.0;
    text.at.y += step.y > 0.0 ? -8.0 : 18.0;
  }
  add_mark(text_mark(palette_, text, words_of(failed.status)));
}

void QueryCanvas::add_failures(const FailureCounts& counts, std::string_view one, std::string_view many) {
  for (std::size_t i = 0; i < kFailures.size(); ++i) {
    if (counts[i] == 0) continue;
    const std::string sample = line_sample(palette_, {Ink::failed}, 2.7, R"( stroke-dasharray="7 6")");
    add_entry({sample, counted(counts[i], one, many) + ", " + words_of(kFailures[i])});
  }
}

}  // namespace waywright::io
