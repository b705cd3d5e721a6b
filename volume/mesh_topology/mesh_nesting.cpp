#include "volume/mesh_topology/mesh_nesting.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>

#include <tbb/parallel_for.h>

#include "volume/mesh_topology/mesh_crossing.h"

namespace isoloop {
namespace {

constexpr std::size_t along_x = 0;

/// Numbers that no model is likely to be made of, so that a ray from there meets no edge.
constexpr std::array<std::array<double, 3>, 4> weights{{{0.4142135, 0.3241593, 0.2616272},
                                                        {0.1732051, 0.5671433, 0.2596516},
                                                        {0.2236068, 0.2302585, 0.5461347},
                                                        {0.6180339, 0.1303577, 0.2516084}}};

Vec3 point_in(const Mesh& mesh, std::size_t triangle, const std::array<double, 3>& weight) {
  Vec3 point{};
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t a = 0; a < 3; ++a) {
      point[a] += weight[c] * mesh.points[mesh.triangles[triangle][c]][a];
    }
  }
  return point;
}

/// Where the ray from `from` along x crosses the triangle: 1 if it leads out of the side that the
/// triangle's normal looks to, -1 if in, 0 if it passes by; nothing where doubles cannot tell.
std::optional<int> crossing(const Mesh& mesh, std::size_t triangle, const Vec3& from) {
  std::array<Vec3, 3> p{};
  for (std::size_t c = 0; c < 3; ++c) p[c] = mesh.points[mesh.triangles[triangle][c]];
  std::array<int, 3> turns{};
  for (std::size_t c = 0; c < 3; ++c) turns[c] = turn(p[c], p[(c + 1) % 3], from, along_x);
  const auto has = [&](int sign) { return std::count(turns.begin(), turns.end(), sign) > 0; };
  if (has(1) && has(-1)) return 0;
  if (has(0)) return std::nullopt;
  const int side = side_of_plane(p[0], p[1], p[2], from);
  if (side == 0) return std::nullopt;
  return side == turns[0] ? 0 : turns[0];  // beyond the triangle, if its normal looks to the ray
}

/// Triangles of one shell from which rays may start, with their areas as seen along x: the largest.
using Starts = std::array<std::pair<double, std::uint32_t>, 8>;

std::vector<Starts> starts_of(const Mesh& mesh, const Shells& shells) {
  std::vector<Starts> starts(shells.list.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    const Vec3& a = mesh.points[corners[0]];
    const Vec3& b = mesh.points[corners[1]];
    const Vec3& c = mesh.points[corners[2]];
    const double area = std::abs((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]));
    Starts& largest = starts[shells.of_triangle[t]];
    if (!(area > largest.back().first)) continue;
    largest.back() = {area, static_cast<std::uint32_t>(t)};
    for (std::size_t i = largest.size() - 1; i > 0 && largest[i].first > largest[i - 1].first;
         --i) {
      std::swap(largest[i], largest[i - 1]);
    }
  }
  return starts;
}

/// How often each shell that it crosses winds round the ray's start, but for triangle `own`.
struct RayResult {
  std::vector<std::pair<std::uint32_t, int>> ways{};  // shell and way of each crossing, by shell
  bool is_clear = true;                               // doubles could tell everywhere
};

RayResult cast_ray(const Mesh& mesh, const Shells& shells, const MeshTree& tree, const Vec3& from,
                   std::uint32_t own) {
  RayResult result;
  const auto enters = [&](const Box& box, std::uint32_t) {
    return box.high[0] >= from[0] && box.low[1] <= from[1] && from[1] <= box.high[1] &&
           box.low[2] <= from[2] && from[2] <= box.high[2];
  };
  tree.walk(enters, [&](std::uint32_t triangle) {
    if (triangle == own || !enters(box_of(mesh, triangle), 0)) return;
    const std::optional<int> way = crossing(mesh, triangle, from);
    if (!way) {
      result.is_clear = false;
    } else if (*way != 0) {
      result.ways.emplace_back(shells.of_triangle[triangle], *way);
    }
  });
  std::sort(result.ways.begin(), result.ways.end());
  return result;
}

/// From the crossings of a ray that starts on triangle `own` of the shell.
std::optional<WindingAt> winding_at(const Mesh& mesh, const RayResult& ray, std::uint32_t shell,
                                    std::uint32_t own, bool modulo_2) {
  WindingAt at;
  int of_own = 0;
  for (const auto& [other, way] : ray.ways) (other == shell ? of_own : at.around) += way;
  if (modulo_2) {
    const auto crossings = std::count_if(ray.ways.begin(), ray.ways.end(),
                                         [&](const auto& one) { return one.first != shell; });
    at.around = static_cast<int>(crossings % 2);
    at.within = 1 - at.around;
    return at;
  }
  // The ray leaves its own triangle to the side that is in front of it, or behind it.
  const auto& t = mesh.triangles[own];
  const int own_turn = turn(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], along_x);
  if (own_turn == 0) return std::nullopt;
  const int in_front = own_turn > 0 ? of_own : of_own - 1;
  if (in_front != 0 && in_front != -1) return std::nullopt;
  at.within = at.around + (in_front == 0 ? 1 : -1);
  return at;
}

}  // namespace

std::optional<std::vector<WindingAt>> windings_at(const Mesh& mesh, const Shells& shells,
                                                  const MeshTree& tree) {
  const bool modulo_2 = !std::all_of(shells.list.begin(), shells.list.end(),
                                     [](const Shell& shell) { return shell.is_oriented; });
  const std::vector<Starts> starts = starts_of(mesh, shells);
  std::vector<WindingAt> windings(shells.list.size());
  std::atomic<bool> all_known{true};
  tbb::parallel_for(std::size_t{0}, windings.size(), [&](std::size_t s) {
    const auto shell = static_cast<std::uint32_t>(s);
    for (const auto& [area, start] : starts[s]) {
      if (!(area > 0.0)) continue;
      for (const auto& weight : weights) {
        const RayResult ray = cast_ray(mesh, shells, tree, point_in(mesh, start, weight), start);
        if (!ray.is_clear) continue;
        const std::optional<WindingAt> found = winding_at(mesh, ray, shell, start, modulo_2);
        if (!found) continue;
        windings[s] = *found;
        return;
      }
    }
    all_known = false;
  });
  if (!all_known) return std::nullopt;
  return windings;
}

}  // namespace isoloop
