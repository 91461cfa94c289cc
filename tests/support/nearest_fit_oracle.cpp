#include "support/nearest_fit_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace waywright::test::disc {
namespace {

struct Vec {
  double x;
  double y;
};

Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y}; }
Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y}; }
Vec operator*(const Vec& a, double f) { return {a.x * f, a.y * f}; }
double product(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y; }
double size(const Vec& a) { return std::sqrt(product(a, a)); }

double distance_to_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec along = b - a;
  const double square = product(along, along);
  const double share = square > 0 ? std::clamp(product(p - a, along) / square, 0.0, 1.0) : 0.0;
  return size(p - a - along * share);
}

/// A line through `at` in a direction of length 1, or a circle of radius r around `at`. Relative to the query's point.
struct Curve {
  bool is_circle;
  Vec at;
  Vec along;
};

class Candidates {
 public:
  Candidates(const Walls& walls, Point point, double r) : r_(r) {
    const auto relative = [&](const Point& p) { return Vec{p.x - point.x, p.y - point.y}; };
    for (const auto& [a, b] : walls.segments) {
      if (a == b) continue;
      const Vec from = relative(a);
      const Vec to = relative(b);
      walls_.emplace_back(from, to);
      const Vec along = (to - from) * (1 / size(to - from));
      const Vec normal = Vec{-along.y, along.x} * r;
      curves_.push_back({false, from + normal, along});
      curves_.push_back({false, from - normal, along});
      curves_.push_back({true, from, {}});
      curves_.push_back({true, to, {}});
      for (const Vec& end : {from, to}) {
        add(end + normal);
        add(end - normal);
      }
    }
    for (const Curve& curve : curves_) add_nearest(curve);
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      for (std::size_t j = i + 1; j < curves_.size(); ++j) add_crossings(curves_[i], curves_[j]);
    }
    std::sort(found_.begin(), found_.end(), [](const Vec& p, const Vec& q) { return product(p, p) < product(q, q); });
  }

  [[nodiscard]] const std::vector<Vec>& sorted() const { return found_; }
  /// Returns false only if a wall is nearer than r by more than the tolerance, a fraction of the sizes of the scene.
  [[nodiscard]] bool may_be_free(const Vec& p, double tolerance) const {
    return std::all_of(walls_.begin(), walls_.end(), [&](const auto& wall) {
      const double scale = r_ + size(p) + size(wall.first) + size(wall.second);
      return distance_to_segment(p, wall.first, wall.second) >= r_ - tolerance * scale;
    });
  }

 private:
  void add(const Vec& p) { found_.push_back(p); }
  void add_nearest(const Curve& curve) {
    if (!curve.is_circle) return add(curve.at - curve.along * product(curve.at, curve.along));
    if (size(curve.at) > 0) return add(curve.at * (1 - r_ / size(curve.at)));
    add({r_, 0});
  }
  void add_crossings(const Curve& p, const Curve& q) {
    if (p.is_circle) return q.is_circle ? add_circles(p.at, q.at) : add_line_and_circle(q, p.at);
    if (q.is_circle) return add_line_and_circle(p, q.at);
    const double across = p.along.x * q.along.y - p.along.y * q.along.x;
    if (across == 0) return;
    const Vec to = q.at - p.at;
    add(p.at + p.along * ((to.x * q.along.y - to.y * q.along.x) / across));
  }
  void add_line_and_circle(const Curve& line, const Vec& centre) {
    const Vec foot = line.at + line.along * product(centre - line.at, line.along);
    const double from = size(centre - foot);
    const double half = std::sqrt(std::max(0.0, (r_ - from) * (r_ + from)));
    if (from > r_ * (1 + 1e-15)) return;
    add(foot + line.along * half);
    add(foot - line.along * half);
  }
  void add_circles(const Vec& p, const Vec& q) {
    const Vec middle = (p + q) * 0.5;
    const double half = size(q - p) / 2;
    if (half == 0 || half > r_ * (1 + 1e-15)) return;
    const double rise = std::sqrt(std::max(0.0, (r_ - half) * (r_ + half)));
    const Vec normal = Vec{p.y - q.y, q.x - p.x} * (1 / (2 * half));
    add(middle + normal * rise);
    add(middle - normal * rise);
  }

  double r_;
  std::vector<std::pair<Vec, Vec>> walls_;
  std::vector<Curve> curves_;
  std::vector<Vec> found_;
};

/// Calls visit() with doubles around a position: the nearest ones, then rings of larger and larger radius.
template <class Visit>
bool visit_around(const Point& point, const Vec& position, Visit&& visit) {
  const double x = point.x + position.x;
  const double y = point.y + position.y;
  const double infinity = HUGE_VAL;
  const auto near = [&](double value) {
    const auto middle = static_cast<double>(value);
    return std::vector<double>{middle, std::nextafter(middle, infinity), std::nextafter(middle, -infinity)};
  };
  bool is_found = false;
  for (const double near_x : near(x)) {
    for (const double near_y : near(y)) is_found = visit(Point{near_x, near_y}) || is_found;
  }
  const double ulp = std::max({std::abs(x), std::abs(y), size(position)}) * 0x1p-53;
  for (double ring = ulp; !is_found && ring < 5e4 * ulp; ring *= 4) {
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        if (std::max(std::abs(i), std::abs(j)) != 4) continue;
        const Point p{static_cast<double>(x + i * ring / 4), static_cast<double>(y + j * ring / 4)};
        is_found = visit(p) || is_found;
      }
    }
  }
  return is_found;
}

double distance_between(const Point& p, const Point& q) { return size({p.x - q.x, p.y - q.y}); }

}  // namespace

std::optional<Point> nearest_fit(const Walls& walls, Point point, double r, const std::function<bool(Point)>& counts) {
  if (fits(walls, point, r) && counts(point)) return point;
  const Candidates candidates(walls, point, r);
  std::optional<Point> best;
  double least = 0;
  std::map<std::pair<double, double>, bool> is_free_at;
  const auto is_point_free = [&](const Point& p) {
    const auto [entry, is_new] = is_free_at.try_emplace({p.x, p.y});
    if (is_new) entry->second = is_in_range(p) && fits(walls, p, r);
    return entry->second;
  };
  for (const Vec& position : candidates.sorted()) {
    if (best && size(position) > least) break;
    if (!candidates.may_be_free(position, 1e-10)) continue;
    visit_around(point, position, [&](const Point& p) {
      const double distance = distance_between(p, point);
      if (best && distance >= least) return false;
      const Vec relative{p.x - point.x, p.y - point.y};
      if (!candidates.may_be_free(relative, 64 * std::numeric_limits<double>::epsilon())) return false;
      if (!is_point_free(p)) return false;
      if (counts(p)) {
        best = p;
        least = distance;
      }
      return true;
    });
  }
  return best;
}

}  // namespace waywright::test::disc
