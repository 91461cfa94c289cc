#pragma once

namespace waywright {

/// A place in the plane. Every finite double is taken exactly as it is; -0.0 means 0.0.
struct Point {
  double x = 0.0;
  double y = 0.0;

  friend bool operator==(const Point&, const Point&) = default;
};

/// A closed axis-aligned box.
struct Box {
  Point min;
  Point max;

  friend bool operator==(const Box&, const Box&) = default;
};

}  // namespace waywright
