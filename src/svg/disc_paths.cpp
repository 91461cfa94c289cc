#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "svg/drawings.hpp"
#include "svg/elements.hpp"
#include "svg/path_data.hpp"
#include "svg/queries.hpp"

namespace waywright::svg {

namespace {

constexpr std::string_view kTranslucent = R"( stroke-opacity="0.25")";
constexpr std::string_view kHalo = R"( stroke-opacity="0.55")";
constexpr double kHaloWidth = 9.0;  // around an item that stops a disc
constexpr double kGapWidth = 3.5;
constexpr double kLabelSize = 15.0;
constexpr double kLabelCharacter = 0.58;  // width of a letter, as a fraction of the font size

bool is_drawable(const SvgDiscPath& path) {
  return is_finite(path.query.start) && is_finite(path.query.goal) && std::isfinite(path.query.agent.radius) &&
         path.query.agent.radius > 0.0;
}

std::string label_of(const SvgDiscPath& path) {
  return "path of a disc, radius " + rounded(path.query.agent.radius) + ", length " + rounded(path.answer.length);
}

/// Returns the gap that stops the disc, or null if the answer has none.
const WidestPath* gap_of(const SvgDiscPath& path) {
  const bool has_gap = path.answer.status == PathStatus::no_path && path.answer.widest &&
                       path.answer.widest->is_limited && is_finite(path.answer.widest->from) &&
                       is_finite(path.answer.widest->to);
  return has_gap ? &*path.answer.widest : nullptr;
}

/// Returns the items that stop the disc, ascending.
std::vector<ItemId> obstacles_of(const SvgDiscPath& path) {
  std::vector<ItemId> items = path.answer.blockers;
  if (const WidestPath* const gap = gap_of(path)) {
    std::set_union(gap->from_items.begin(), gap->from_items.end(), gap->to_items.begin(), gap->to_items.end(),
                   std::back_inserter(items));
  }
  return items;
}

bool crosses(const Box& box, Point a, Point b) { return clip_segment(box, a, b); }

class DiscPathDrawer {
 public:
  DiscPathDrawer(const World& world, const SvgOverlay& overlay, const SvgFrame& frame, const Palette& palette)
      : world_(world), overlay_(overlay), frame_(frame), palette_(palette), canvas_(overlay, frame, palette) {
    std::size_t coloured = 0;
    for (const Path& path : overlay.paths) coloured += path.points.empty() ? 0 : 1;
    for (const SvgDiscPath& path : overlay.disc_paths) {
      if (!is_drawable(path)) continue;
      const bool is_found = path.answer.status == PathStatus::found;
      if (is_found) found_.push_back({&path, {kPathInks[coloured++ % kPathInks.size()]}});
      if (!is_found) failed_.push_back(&path);
    }
  }

  [[nodiscard]] OverlayDrawing draw() {
    if (found_.empty() && failed_.empty()) return {};
    open_group("obstacles");
    draw_obstacles();
    next_group("swept-areas");
    for (const Found& found : found_) draw_swept_area(found);
    next_group("disc-paths");
    canvas_.drawing().whole = "<g id=\"disc-ends\">\n";
    for (const Found& found : found_) draw_centre_line(found);
    for (const SvgDiscPath* const failed : failed_) draw_failed(*failed);
    next_group("gaps");
    for (const SvgDiscPath* const failed : failed_) draw_gap(*failed);
    canvas_.drawing().clipped += "</g>\n";
    canvas_.drawing().whole += "</g>\n";
    add_entries();
    return std::move(canvas_.drawing());
  }

 private:
  /// A path that the picture shows, and its colour.
  struct Found {
    const SvgDiscPath* path = nullptr;
    Paint colour;
  };

  void open_group(const std::string& id) {
    canvas_.drawing().clipped += "<g id=\"" + id + "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  }

  void next_group(const std::string& id) {
    canvas_.drawing().clipped += "</g>\n";
    open_group(id);
  }

  [[nodiscard]] double pixels_of(double length) const { return length * frame_.scale(); }

  /// Returns the size of the marks at the ends: small in a small disc, so that the picture shows the disc.
  [[nodiscard]] double end_radius(double radius) const {
    return std::clamp(pixels_of(radius) * 0.4, std::min(3.0, canvas_.end_radius()), canvas_.end_radius());
  }

  void draw_obstacles() {
    std::vector<ItemId> items;
    for (const SvgDiscPath* const failed : failed_) {
      for (const ItemId item : obstacles_of(*failed)) items.push_back(item);
    }
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    for (const ItemId item : items) draw_outline(item);
    has_obstacles_ = !items.empty();
  }

  /// Draws the outline of an item, or the border of the domain for the null id.
  void draw_outline(ItemId id) {
    PathData data(frame_);
    if (id.is_null()) {
      const Box& domain = world_.domain();
      const std::array<Point, 4> border{domain.min, Point{domain.max.x, domain.min.y}, domain.max,
                                        Point{domain.min.x, domain.max.y}};
      data.add_ring(border);
    } else {
      const Result<Shape> shape = world_.shape(id);
      if (!shape.ok()) return;
      for (const PointSpan ring : shape->rings) {
        if (shape->kind == ItemKind::polygon) {
          data.add_ring(ring);
        } else if (ring.size() == 1) {
          data.add_dot(ring.front());
        } else {
          data.add_chain(ring);
        }
      }
    }
    if (!data.empty()) canvas_.add_stroke(data, {Ink::gap}, kHaloWidth, kHalo);
    canvas_.drawing().clipped += "\n";
  }

  /// Adds the pieces of a path, or its only point if it has no pieces.
  static void add_path(PathData& data, const SvgDiscPath& path) {
    data.add_pieces(path.answer.pieces);
    if (path.answer.pieces.empty()) data.add_dot(path.query.start);
  }

  /// Draws a stroke as wide as the disc: with round ends and joins it is the area that the disc covers.
  void draw_swept_area(const Found& found) {
    const double width = 2.0 * pixels_of(found.path->query.agent.radius);
    PathData data(frame_, width);
    add_path(data, *found.path);
    if (data.empty()) return;
    canvas_.add_stroke(data, found.colour, width, kTranslucent);
    canvas_.drawing().clipped += "\n";
    shown_.push_back(found);
  }

  void draw_centre_line(const Found& found) {
    const SvgDiscPath& path = *found.path;
    PathData data(frame_);
    add_path(data, path);
    const double width =
        std::clamp(pixels_of(path.query.agent.radius) * 0.35, 1.2, std::max(canvas_.path_width() * 0.7, 1.2));
    if (!data.empty()) {
      canvas_.drawing().clipped += "<g>";
      const std::string about = canvas_.hint(label_of(path));
      if (!about.empty()) append_hint(canvas_.drawing().clipped, about);
      canvas_.add_stroke(data, found.colour, width);
      canvas_.drawing().clipped += "</g>\n";
    }
    draw_discs(path, found.colour, {});
    const auto [start, goal] = ends_of(path);
    canvas_.add_ends(start, goal, end_radius(path.query.agent.radius), found.colour);
  }

  /// Returns where the path starts and ends. If the search has moved an end, this is the new position.
  [[nodiscard]] static std::pair<Point, Point> ends_of(const SvgDiscPath& path) {
    const Path& answer = path.answer;
    return {answer.moved_start ? answer.moved_start->to : path.query.start,
            answer.moved_goal ? answer.moved_goal->to : path.query.goal};
  }

  /// Draws the disc where the path starts and where it ends.
  void draw_discs(const SvgDiscPath& path, const Paint& colour, std::string_view attributes) {
    const double radius = pixels_of(path.query.agent.radius);
    const auto [start, goal] = ends_of(path);
    for (const Point& end : {start, goal}) {
      const Point centre = frame_.to_picture(end);
      if (!meets(frame_.map(), centre, radius)) continue;
      canvas_.drawing().clipped += disc_outline(centre, radius, colour, attributes) + "\n";
    }
  }

  [[nodiscard]] std::string disc_outline(const Point& centre, double radius, const Paint& colour,
                                         std::string_view attributes) const {
    std::string out = disc_mark(palette_, centre, radius, {Ink::none}, colour, 1.6);
    out.insert(out.size() - 2, attributes);  // before the end of the element, `/>`
    return out;
  }

  void draw_failed(const SvgDiscPath& path) {
    const SvgFailedPath failed{path.query.start, path.query.goal, path.answer.status};
    draw_discs(path, {Ink::failed}, kDashed);
    canvas_.add_failed_path(failed, end_radius(path.query.agent.radius));
    const bool has_room = failed_.size() <= kMostLabels;
    if (has_room && gap_of(path) == nullptr) canvas_.add_status(failed);
    count_failure(failures_, path.answer.status);
  }

  void draw_gap(const SvgDiscPath& path) {
    const WidestPath* const gap = gap_of(path);
    if (gap == nullptr) return;
    ++gap_count_;
    const std::string label = "gap " + rounded(2.0 * gap->radius);
    PathData data(frame_);
    data.add_segment(gap->from, gap->to);
    canvas_.add_line(data, {Ink::gap}, kGapWidth, canvas_.hint(label + ": " + ids_text(obstacles_of(path))));
    const std::array<const std::vector<ItemId>*, 2> items{&gap->from_items, &gap->to_items};
    for (const bool is_start : {true, false}) {
      const Point& end = is_start ? gap->from : gap->to;
      if (!canvas_.is_shown(end)) continue;
      canvas_.add_mark(square_mark(palette_, frame_.to_picture(end), 4.5, {Ink::gap},
                                   canvas_.hint(point_text(end) + ": " + ids_text(*items[is_start ? 0 : 1]))));
    }
    if (failed_.size() <= kMostLabels) add_gap_label(*gap, path, label);
  }

  /// Writes the width beside the middle of the gap, where it covers neither the gap nor the line of the query nor
  /// another label.
  void add_gap_label(const WidestPath& gap, const SvgDiscPath& path, const std::string& label) {
    const Point middle{gap.from.x / 2.0 + gap.to.x / 2.0, gap.from.y / 2.0 + gap.to.y / 2.0};
    if (!canvas_.is_shown(middle)) return;
    const Point at = frame_.to_picture(middle);
    const double width = kLabelSize * kLabelCharacter * static_cast<double>(label.size());
    const auto box_at = [&](double right, double down) {
      const Point centre{at.x + right * (width / 2.0 + 14.0), at.y + down * kLabelSize};
      return Box{{centre.x - width / 2.0, centre.y - kLabelSize * 0.6},
                 {centre.x + width / 2.0, centre.y + kLabelSize * 0.6}};
    };
    const auto is_free = [&](const Box& box) {
      return contains(frame_.map(), box) && !crosses(box, frame_.to_picture(gap.from), frame_.to_picture(gap.to)) &&
             !crosses(box, frame_.to_picture(path.query.start), frame_.to_picture(path.query.goal)) &&
             std::none_of(label_boxes_.begin(), label_boxes_.end(),
                          [&](const Box& other) { return meets(box, other); });
    };
    Box box = box_at(1.0, 0.0);
    for (const double down : {0.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0}) {
      for (const double right : {1.0, -1.0, 0.0}) {
        const Box tried = box_at(right, down);
        if (!is_free(tried)) continue;
        write_label(tried, label);
        return;
      }
    }
    write_label(box, label);
  }

  void write_label(const Box& box, const std::string& label) {
    label_boxes_.push_back(box);
    const Point at{(box.min.x + box.max.x) / 2.0, (box.min.y + box.max.y) / 2.0 + 0.35 * kLabelSize};
    canvas_.add_mark(text_mark(palette_, {at, "middle", kLabelSize, {Ink::gap}}, label));
  }

  [[nodiscard]] std::string path_sample(const Paint& colour) const {
    return area_sample(colour) + line_sample(palette_, colour, 2.5);
  }

  [[nodiscard]] std::string area_sample(const Paint& colour) const {
    return "<path d=\"M7 8H21\" stroke-linecap=\"round\" stroke-width=\"14\"" + palette_({Ink::none}, colour) +
           std::string(kTranslucent) + "/>";
  }

  void add_entries() {
    if (shown_.size() <= kPathInks.size()) {
      for (const Found& found : shown_) canvas_.add_entry({path_sample(found.colour), label_of(*found.path)});
    } else {
      canvas_.add_entry(
          {path_sample(shown_.front().colour), counted(shown_.size(), "path of a disc", "paths of discs")});
    }
    if (!shown_.empty()) {
      canvas_.add_entry({area_sample(shown_.front().colour), "area that the disc covers"});
    }
    canvas_.add_failures(failures_, "failed path of a disc", "failed paths of discs");
    const Paint colour = found_.empty() ? Paint{Ink::failed} : found_.front().colour;
    canvas_.add_entry(
        {disc_outline({14.0, 8.0}, 7.0, colour, found_.empty() ? kDashed : ""), "disc at its start and goal"});
    if (!shown_.empty() && overlay_.paths.empty()) canvas_.add_entries_of_ends();
    if (gap_count_ > 0) add_gap_entry();
    if (has_obstacles_) {
      canvas_.add_entry({line_sample(palette_, {Ink::wall}, 3.2) + line_sample(palette_, {Ink::gap}, kHaloWidth, kHalo),
                         "items that stop the disc"});
    }
  }

  void add_gap_entry() {
    std::string sample = line_sample(palette_, {Ink::gap}, kGapWidth);
    for (const double x : {3.0, 25.0}) sample += square_mark(palette_, {x, 8.0}, 4.0, {Ink::gap});
    const std::string label = gap_count_ > 1 ? "narrowest gap of the widest path" : widest_label();
    canvas_.add_entry({sample, label});
  }

  [[nodiscard]] std::string widest_label() const {
    for (const SvgDiscPath* const failed : failed_) {
      const WidestPath* const gap = gap_of(*failed);
      if (gap == nullptr) continue;
      return "gap " + rounded(2.0 * gap->radius) + " wide: a disc of radius " + rounded(gap->radius) + " fits through";
    }
    return {};
  }

  static constexpr std::string_view kDashed = R"( stroke-dasharray="5 4")";
  static constexpr std::size_t kMostLabels = 4;  // with more failed paths, their texts would overlap

  const World& world_;
  const SvgOverlay& overlay_;
  const SvgFrame& frame_;
  const Palette& palette_;
  QueryCanvas canvas_;
  std::vector<Found> found_;
  std::vector<Found> shown_;  // the elements of `found_` that the picture shows at least partly
  std::vector<const SvgDiscPath*> failed_;
  std::vector<Box> label_boxes_;
  FailureCounts failures_{};
  std::size_t gap_count_ = 0;
  bool has_obstacles_ = false;
};

}  // namespace

OverlayDrawing draw_disc_paths(const World& world, const SvgOverlay& overlay, const SvgFrame& frame,
                               const Palette& palette) {
  return DiscPathDrawer(world, overlay, frame, palette).draw();
}

}  // namespace waywright::svg
