#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "waywright/world.hpp"

#include "base/float_environment.hpp"
#include "path/fit_finder.hpp"
#include "world/query_errors.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

// The functions that find out whether changes disconnect points.

namespace waywright {

namespace {

/// The areas of a point: see path::FitFinder::find_areas().
using Areas = std::vector<std::uint32_t>;

bool have_common_area(const Areas& a, const Areas& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](std::uint32_t area) { return std::binary_search(b.begin(), b.end(), area); });
}

Areas common_areas(const Areas& a, const Areas& b) {
  Areas common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common;
}

/// Returns whether two of the points have no area in common, or one of the points belongs to no area.
bool is_any_pair_disconnected(const std::vector<std::size_t>& points, const std::vector<Areas>& areas) {
  Areas common = areas[points.front()];
  for (const std::size_t i : points) common = common_areas(common, areas[i]);
  if (!common.empty()) return false;
  // If a point has only one area, this area is not common to all: so another point does not have it.
  if (std::any_of(points.begin(), points.end(), [&](std::size_t i) { return areas[i].size() < 2; })) return true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (!have_common_area(areas[points[i]], areas[points[j]])) return true;
    }
  }
  return false;
}

/// Returns whether a change disconnects the points: two points had an area in common before the change and have none
/// after it, or a point belonged to an area before and belongs to none after.
bool is_disconnected(const std::vector<Areas>& before, const std::vector<Areas>& after) {
  std::vector<std::pair<std::uint32_t, std::size_t>> in_area;
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (const std::uint32_t area : before[i]) in_area.emplace_back(area, i);
  }
  std::sort(in_area.begin(), in_area.end());
  std::vector<std::size_t> points;
  for (std::size_t begin = 0; begin < in_area.size(); begin += points.size()) {
    points.clear();
    for (std::size_t i = begin; i < in_area.size() && in_area[i].first == in_area[begin].first; ++i) {
      points.push_back(in_area[i].second);
    }
    if (is_any_pair_disconnected(points, after)) return true;
  }
  return false;
}

}  // namespace

Result<bool> World::would_disconnect(std::span<const Change> changes, PointSpan points, const Agent& agent) {
  const base::FloatEnvironment environment;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (auto error = find_point_error(domain(), points[i], i, {"point", i})) return *std::move(error);
  }
  if (auto error = find_agent_error(impl_->layers.kept(), agent)) return *std::move(error);
  if (agent.radius == 0.0 && !impl_->layers.kept().has_abstraction) {
    return Error{ErrorCode::not_supported, "the radius 0 needs a world that keeps its abstraction", {}, 0};
  }
  const SpareContext::Loan context = impl_->spare_context.borrow();
  path::FitFinder& fits = *(*context).scratch_->fits;
  const auto areas = [&] { return fits.find_areas(impl_->ground(), points, agent); };
  const std::vector<Areas> before = areas();
  return attempt(changes, [&](const World&) { return is_disconnected(before, areas()); });
}

Result<bool> World::would_disconnect(const Shape& shape, PointSpan points, const Agent& agent) {
  return would_disconnect(std::array{Change::insert(shape)}, points, agent);
}

}  // namespace waywright
