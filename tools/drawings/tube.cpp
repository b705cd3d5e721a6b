#include "tools/drawings/tube.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/grid/vec3.h"

namespace isoloop {
namespace {

Vec3 sum(const Vec3& a, const Vec3& b, double factor_b) {
  return {a[0] + factor_b * b[0], a[1] + factor_b * b[1], a[2] + factor_b * b[2]};
}

// `fallback` where `v` has no direction.
Vec3 unit(const Vec3& v, const Vec3& fallback) {
  const double length = std::sqrt(dot(v, v));
  if (!(length > 1e-300)) return fallback;
  return {v[0] / length, v[1] / length, v[2] / length};
}

// A unit vector at right angles to the unit vector `axis`.
Vec3 any_normal(const Vec3& axis) {
  const bool along_x = std::abs(axis[0]) > 0.7;
  return unit(cross(axis, along_x ? Vec3{0, 1, 0} : Vec3{1, 0, 0}), {0, 0, 1});
}

std::vector<Vec3> tangents_of(std::span<const Vec3> polyline) {
  const std::size_t n = polyline.size();
  std::vector<Vec3> tangents(n);
  Vec3 last{1, 0, 0};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3& before = polyline[(i + n - 1) % n];
    const Vec3& after = polyline[(i + 1) % n];
    last = unit(sum(after, before, -1.0), last);
    tangents[i] = last;
  }
  return tangents;
}

// `normal` without its part along `tangent`.
Vec3 carried(const Vec3& normal, const Vec3& tangent) {
  return unit(sum(normal, tangent, -dot(normal, tangent)), any_normal(tangent));
}

}  // namespace

Tube closed_tube(std::span<const Vec3> polyline, double radius) {
  const std::size_t n = polyline.size();
  Tube tube;
  if (n < 2) return tube;
  const std::vector<Vec3> tangents = tangents_of(polyline);
  std::vector<Vec3> normals(n);
  normals[0] = any_normal(tangents[0]);
  for (std::size_t i = 1; i < n; ++i) normals[i] = carried(normals[i - 1], tangents[i]);

  // Carried once round, the first normal comes back turned: spread that turn over all rings.
  const Vec3 arrived = carried(normals[n - 1], tangents[0]);
  const double turn =
      std::atan2(dot(arrived, cross(tangents[0], normals[0])), dot(arrived, normals[0]));

  tube.points.reserve(n * tube_sides);
  tube.triangles.reserve(2 * n * tube_sides);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 binormal = cross(tangents[i], normals[i]);
    const double start = -turn * static_cast<double>(i) / static_cast<double>(n);
    for (std::uint32_t side = 0; side < tube_sides; ++side) {
      const double angle = start + 2.0 * std::numbers::pi * side / tube_sides;
      const Vec3 along_normal = sum(polyline[i], normals[i], radius * std::cos(angle));
      tube.points.push_back(sum(along_normal, binormal, radius * std::sin(angle)));
    }
    const auto ring = static_cast<std::uint32_t>(i * tube_sides);
    const auto next = static_cast<std::uint32_t>((i + 1 == n ? 0 : i + 1) * tube_sides);
    for (std::uint32_t side = 0; side < tube_sides; ++side) {
      const std::uint32_t other = (side + 1) % tube_sides;
      tube.triangles.push_back({ring + side, ring + other, next + other});
      tube.triangles.push_back({ring + side, next + other, next + side});
    }
  }
  return tube;
}

}  // namespace isoloop
