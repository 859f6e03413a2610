/// Vectors in space.
#pragma once

#include <cstddef>
#include <span>

#include "seiche/simd_clones.hpp"

namespace seiche {

struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;
};

SEICHE_INLINE Vector3 operator+(Vector3 a, Vector3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
SEICHE_INLINE Vector3 operator-(Vector3 a, Vector3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
SEICHE_INLINE Vector3 operator*(double s, Vector3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
SEICHE_INLINE Vector3 operator/(Vector3 a, double s) {
  return {a.x / s, a.y / s, a.z / s};
}
SEICHE_INLINE Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
SEICHE_INLINE double dot(Vector3 a, Vector3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Vector k of many, whose components x come first, then y, then z; and back.
inline Vector3 vector_at(std::span<const double> values, std::size_t k) {
  const std::size_t n = values.size() / 3;
  return {values[k], values[n + k], values[2 * n + k]};
}
inline void put_vector(Vector3 v, std::size_t k, std::span<double> values) {
  const std::size_t n = values.size() / 3;
  values[k] = v.x;
  values[n + k] = v.y;
  values[2 * n + k] = v.z;
}

}  // namespace seiche
