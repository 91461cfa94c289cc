#include "svg/queries.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/number_text.hpp"
#include "svg/drawings.hpp"
#include "svg/elements.hpp"

namespace waywright::svg {

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

namespace {

constexpr std::size_t kMostStatuses = 4;  // with more failed paths, their texts would overlap

std::string path_label(const Path& path) { return "path, length " + rounded(path.length); }

/// The answers of World::locate() that have their own mark and colour.
enum class MarkKind : unsigned char { in_face, on_edge, on_vertex, covered };
constexpr std::array<MarkKind, 4> kMarkKinds{MarkKind::in_face, MarkKind::on_edge, MarkKind::on_vertex,
                                             MarkKind::covered};

MarkKind kind_of(const Location& location) {
  if (!location.polygons.empty()) return MarkKind::covered;
  if (location.kind == LocationKind::face) return MarkKind::in_face;
  return location.kind == LocationKind::edge ? MarkKind::on_edge : MarkKind::on_vertex;
}

Ink ink_of(MarkKind kind) {
  constexpr std::array<Ink, 4> kInks{Ink::in_face, Ink::on_edge, Ink::on_vertex, Ink::covered};
  return kInks[static_cast<std::size_t>(kind)];
}

class QueryDrawer {
 public:
  QueryDrawer(const SvgOverlay& overlay, const SvgFrame& frame, const Palette& palette)
      : overlay_(overlay), frame_(frame), palette_(palette), canvas_(overlay, frame, palette) {
    ray_part_ = overlay.rays.size() >= kManyQueries ? 0.6 : 1.0;
    location_part_ = overlay.locations.size() >= 10 * kManyQueries ? 0.6 : 1.0;
  }

  [[nodiscard]] OverlayDrawing draw() {
    canvas_.drawing().clipped = "<g id=\"paths\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    canvas_.drawing().whole = "<g id=\"ends\">\n";
    draw_paths();
    open_groups("rays");
    draw_rays();
    open_groups("failed-paths");
    draw_failed_paths();
    canvas_.drawing().clipped += "</g>\n";
    canvas_.drawing().whole += "</g>\n<g id=\"locations\">\n";
    draw_locations();
    canvas_.drawing().whole += "</g>\n";
    return std::move(canvas_.drawing());
  }

 private:
  void open_groups(const std::string& id) {
    canvas_.drawing().clipped += "</g>\n<g id=\"" + id + "\" stroke-linecap=\"round\">\n";
    canvas_.drawing().whole += "</g>\n<g id=\"" + id + "-ends\">\n";
  }

  /// Draws the line of a path and the marks at its ends. Returns false if the picture shows nothing of it.
  bool draw_path(const Path& path, const Paint& colour) {
    PathData data(frame_);
    data.add_chain(path.points);
    canvas_.add_line(data, colour, canvas_.path_width(), canvas_.hint(path_label(path)));
    const Point& start = path.points.front();
    canvas_.add_ends(start, path.points.back(), canvas_.end_radius(), colour);
    return !data.empty() || canvas_.is_shown(start);
  }

  void draw_paths() {
    std::vector<LegendEntry> one_each;
    std::size_t coloured = 0;
    for (const Path& path : overlay_.paths) {
      if (path.points.empty()) continue;
      const Paint colour{kPathInks[coloured++ % kPathInks.size()]};
      if (draw_path(path, colour)) one_each.push_back({line_sample(palette_, colour, 4.5), path_label(path)});
    }
    if (one_each.empty()) return;
    if (one_each.size() > kPathInks.size()) {
      one_each = {{line_sample(palette_, {kPathInks[0]}, 4.5), counted(one_each.size(), "path", "paths")}};
    }
    canvas_.drawing().entries.insert(canvas_.drawing().entries.end(), one_each.begin(), one_each.end());
    canvas_.add_entries_of_ends();
  }

  void draw_ray(const SvgRay& ray) {
    const Paint colour{Ink::ray};
    const Point& stop = ray.answer.hit ? ray.answer.at : ray.to;
    std::string about = "ray from " + point_text(ray.from) + " to " + point_text(ray.to);
    about += ray.answer.hit ? ", hits " + ids_text(ray.answer.items) + " at " + point_text(stop) : ", hits nothing";
    PathData line(frame_);
    line.add_segment(ray.from, stop);
    canvas_.add_line(line, colour, 2.2 * ray_part_, canvas_.hint(about));
    PathData rest(frame_);
    if (ray.answer.hit && stop != ray.to) rest.add_segment(stop, ray.to);
    if (!rest.empty()) canvas_.add_stroke(rest, colour, 1.8 * ray_part_, R"( stroke-dasharray="0.1 5")");

    const double radius = 4.0 * ray_part_;
    if (canvas_.is_shown(ray.to) && stop != ray.from) {
      canvas_.add_mark(disc_mark(palette_, frame_.to_picture(ray.to), radius, colour, {Ink::page}, 1.5,
                                 canvas_.hint("end " + point_text(ray.to))));
    }
    if (canvas_.is_shown(ray.from)) {
      canvas_.add_mark(disc_mark(palette_, frame_.to_picture(ray.from), radius, {Ink::page}, colour, 2.0 * ray_part_,
                                 canvas_.hint("start " + point_text(ray.from))));
    }
    if (ray.answer.hit && canvas_.is_shown(stop)) {
      canvas_.add_mark(cross_mark(palette_, frame_.to_picture(stop), 5.0 * ray_part_, colour,
                                  canvas_.hint("hit " + point_text(stop) + ": " + ids_text(ray.answer.items))));
    }
  }

  void draw_rays() {
    std::size_t drawn = 0;
    std::size_t hits = 0;
    for (const SvgRay& ray : overlay_.rays) {
      if (!is_finite(ray.from) || !is_finite(ray.to)) continue;
      draw_ray(ray);
      ++drawn;
      hits += ray.answer.hit ? 1 : 0;
    }
    if (drawn == 0) return;
    const Paint colour{Ink::ray};
    const std::string sample = "<path d=\"M5 8H23\"" + palette_({Ink::none}, colour) + " stroke-width=\"2.2\"/>" +
                               disc_mark(palette_, {5.0, 8.0}, 4.0, {Ink::page}, colour, 2.0) +
                               disc_mark(palette_, {23.0, 8.0}, 4.0, colour, {Ink::none}, 0.0);
    canvas_.add_entry({sample, counted(drawn, "ray", "rays")});
    if (hits > 0) {
      canvas_.add_entry({cross_mark(palette_, {14.0, 8.0}, 5.0, colour), counted(hits, "hit", "hits")});
    }
  }

  void draw_failed_paths() {
    FailureCounts counts{};
    for (const SvgFailedPath& failed : overlay_.failed_paths) {
      if (!is_finite(failed.start) || !is_finite(failed.goal)) continue;
      canvas_.add_failed_path(failed, canvas_.end_radius());
      if (overlay_.failed_paths.size() <= kMostStatuses) canvas_.add_status(failed);
      count_failure(counts, failed.status);
    }
    canvas_.add_failures(counts, "failed path", "failed paths");
  }

  [[nodiscard]] std::string position_mark(LocationKind at, const Point& pixels, double part, const Paint& colour,
                                          const std::string& about) const {
    if (at == LocationKind::edge) return square_mark(palette_, pixels, 5.0 * part, colour, about);
    if (at == LocationKind::vertex) return diamond_mark(palette_, pixels, 7.0 * part, colour, about);
    return disc_mark(palette_, pixels, 5.5 * part, colour, {Ink::page}, 1.5, about);
  }

  void draw_locations() {
    std::array<std::size_t, kMarkKinds.size()> counts{};
    for (const SvgLocation& located : overlay_.locations) {
      if (!canvas_.is_shown(located.at)) continue;
      const MarkKind kind = kind_of(located.answer);
      std::string about = point_text(located.at) + ": " + std::string(to_string(located.answer.kind));
      if (kind == MarkKind::covered) about += ", inside " + ids_text(located.answer.polygons);
      canvas_.add_mark(position_mark(located.answer.kind, frame_.to_picture(located.at), location_part_, {ink_of(kind)},
                                     canvas_.hint(about)));
      ++counts[static_cast<std::size_t>(kind)];
    }
    add_location_entries(counts);
  }

  void add_location_entries(const std::array<std::size_t, kMarkKinds.size()>& counts) {
    constexpr std::array<std::string_view, 4> kWords{" in a face", " on an edge", " on a vertex", " in polygons"};
    constexpr std::array<LocationKind, 4> kKinds{LocationKind::face, LocationKind::edge, LocationKind::vertex,
                                                 LocationKind::face};
    for (const MarkKind kind : kMarkKinds) {
      const auto i = static_cast<std::size_t>(kind);
      if (counts[i] == 0) continue;
      std::string label = counted(counts[i], "located point", "located points");
      label += kWords[i];
      canvas_.add_entry({position_mark(kKinds[i], {14.0, 8.0}, 1.0, {ink_of(kind)}, {}), label});
    }
  }

  const SvgOverlay& overlay_;
  const SvgFrame& frame_;
  const Palette& palette_;
  QueryCanvas canvas_;
  double ray_part_ = 1.0;       // size of the marks and lines of rays, as a fraction of the full size
  double location_part_ = 1.0;  // size of the marks of located points, as a fraction of the full size
};

}  // namespace

OverlayDrawing draw_queries(const SvgOverlay& overlay, const SvgFrame& frame, const Palette& palette) {
  return QueryDrawer(overlay, frame, palette).draw();
}

}  // namespace waywright::svg
