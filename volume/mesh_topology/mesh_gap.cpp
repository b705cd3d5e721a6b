#include "volume/mesh_topology/mesh_gap.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/grid/vec3.h"

namespace isoloop {
namespace {

constexpr std::uint32_t no_shell = 0xffffffff;

double squared_distance(const Vec3& p, const Box& box) {
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double beyond = std::max({box.low[a] - p[a], p[a] - box.high[a], 0.0});
    sum += beyond * beyond;
  }
  return sum;
}

double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = minus(b, a);
  const Vec3 to_p = minus(p, a);
  const double length = dot(along, along);
  const double share = length > 0.0 ? std::clamp(dot(to_p, along) / length, 0.0, 1.0) : 0.0;
  Vec3 rest{};
  for (std::size_t i = 0; i < 3; ++i) rest[i] = to_p[i] - share * along[i];
  return dot(rest, rest);
}

double squared_distance(const Vec3& p, const std::array<Vec3, 3>& t) {
  const Vec3 u = minus(t[1], t[0]);
  const Vec3 v = minus(t[2], t[0]);
  const Vec3 normal = cross(u, v);
  bool is_over = dot(normal, normal) > 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3& from = t[c];
    const Vec3& to = t[(c + 1) % 3];
    const Vec3 side = minus(to, from);
    const Vec3 to_p = minus(p, from);
    const Vec3 inward = cross(normal, side);
    is_over = is_over && dot(inward, to_p) >= 0.0;
    least = std::min(least, squared_distance_to_segment(p, from, to));
  }
  if (!is_over) return least;
  const double height = dot(normal, minus(p, t[0]));
  return std::min(least, height * height / dot(normal, normal));
}

}  // namespace

std::optional<double> least_gap(const Mesh& mesh, const Shells& shells, const MeshTree& tree,
                                double near) {
  if (shells.list.size() < 2) return std::nullopt;
  std::vector<std::uint32_t> shell_at(mesh.points.size(), no_shell);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t corner : mesh.triangles[t]) shell_at[corner] = shells.of_triangle[t];
  }
  std::atomic<double> least{near * near};
  const auto look_from = [&](std::uint32_t point) {
    const Vec3& p = mesh.points[point];
    const std::uint32_t own = shell_at[point];
    const auto enters = [&](const Box& box, std::uint32_t shell) {
      // A little more than the least so far, so that rounding hides nothing that is less.
      return shell != own && squared_distance(p, box) <= least.load() * (1.0 + 1e-9);
    };
    tree.walk(enters, [&](std::uint32_t t) {
      if (shells.of_triangle[t] == own) return;
      const auto& corners = mesh.triangles[t];
      const double found = squared_distance(
          p, {mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]});
      double before = least.load();
      while (found < before && !least.compare_exchange_weak(before, found)) {
      }
    });
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.points.size(), 256),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t p = range.begin(); p < range.end(); ++p) {
                        if (shell_at[p] != no_shell) look_from(static_cast<std::uint32_t>(p));
                      }
                    });
  if (!(least.load() < near * near)) return std::nullopt;
  return std::sqrt(least.load());
}

}  // namespace isoloop
