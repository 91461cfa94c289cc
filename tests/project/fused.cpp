// Functions for which GCC 12 uses fused instructions despite -ffp-contract=off, if the processor has them.

struct Vector {
  double x;
  double y;
};

Vector turned(const Vector& v, const Vector& direction);
Vector turned(const Vector& v, const Vector& direction) {
  return {v.x * direction.x - v.y * direction.y, v.x * direction.y + v.y * direction.x};
}

Vector scaled_and_moved(const Vector& v, const Vector& by, double scale);
Vector scaled_and_moved(const Vector& v, const Vector& by, double scale) {
  return {v.x * scale - by.y, v.y * scale + by.x};
}
