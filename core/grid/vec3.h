// Arithmetic of points and directions in space.
#pragma once

#include <cmath>

#include "core/grid/grid.h"

namespace isoloop {

inline Vec3 plus(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

inline Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// At right angles to both, as the third finger of the right hand.
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The length; finite wherever it is a double.
inline double norm(const Vec3& a) { return std::hypot(a[0], a[1], a[2]); }

}  // namespace isoloop
