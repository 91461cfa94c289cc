#include "waywright/point.hpp"

#include "waywright/assert.hpp"

#include "base/float_environment.hpp"
#include "base/number_text.hpp"

namespace waywright {

std::string to_string(const Point& point) {
  const base::FloatEnvironment environment;
  std::string text = "(";
  base::append_number(text, point.x);
  text += ", ";
  base::append_number(text, point.y);
  return text += ')';
}

Box Box::bounding(PointSpan points) {
  WAYWRIGHT_ASSERT(!points.empty(), "Box::bounding: there is no point");
  Box box{points.front(), points.front()};
  for (const Point& point : points) box.expand(point);
  return box;
}

}  // namespace waywright
