#include "tests/oracles/cube_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isoloop::testing {
namespace {

__extension__ using Wide = __int128;
using Point = std::array<std::int64_t, 3>;
using Triangle = std::array<Point, 3>;

int sign(Wide number) { return number > 0 ? 1 : number < 0 ? -1 : 0; }

std::array<Wide, 3> normal_of(const Triangle& t) {
  std::array<Wide, 3> normal{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const std::size_t c = (a + 2) % 3;
    normal[a] = Wide{t[1][b] - t[0][b]} * (t[2][c] - t[0][c]) -
                Wide{t[1][c] - t[0][c]} * (t[2][b] - t[0][b]);
  }
  return normal;
}

/// On which side of the triangle's plane the point lies.
int side_of(const Triangle& t, const Point& p) {
  const std::array<Wide, 3> normal = normal_of(t);
  Wide sum = 0;
  for (std::size_t a = 0; a < 3; ++a) sum += normal[a] * (p[a] - t[0][a]);
  return sign(sum);
}

/// The same in the plane across `axis`: on which side of the line from p to q the point r lies.
int turn(const Point& p, const Point& q, const Point& r, std::size_t axis) {
  const std::size_t b = (axis + 1) % 3;
  const std::size_t c = (axis + 2) % 3;
  return sign(Wide{q[b] - p[b]} * (r[c] - p[c]) - Wide{q[c] - p[c]} * (r[b] - p[b]));
}

/// Of a segment in the triangle's own plane.
bool meets_in_plane(const Triangle& t, const Point& p, const Point& q) {
  const std::array<Wide, 3> normal = normal_of(t);
  const std::size_t axis = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  const int around = sign(normal[axis]);
  // Apart if a side of the triangle, or the segment, has all of the other on its far side.
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& from = t[i];
    const Point& to = t[(i + 1) % 3];
    if (turn(from, to, p, axis) * around < 0 && turn(from, to, q, axis) * around < 0) return false;
  }
  const auto at = [&](std::size_t i) { return turn(p, q, t[i], axis); };
  return std::max({at(0), at(1), at(2)}) >= 0 && std::min({at(0), at(1), at(2)}) <= 0;
}

/// Whether the segment and the triangle have a point in common.
bool meets(const Triangle& t, const Point& p, const Point& q) {
  const int before = side_of(t, p);
  const int after = side_of(t, q);
  if (before == 0 && after == 0) return meets_in_plane(t, p, q);
  if (before * after > 0) return false;
  std::array<int, 3> turns{};
  for (std::size_t i = 0; i < 3; ++i) turns[i] = side_of({p, q, t[i]}, t[(i + 1) % 3]);
  return std::min({turns[0], turns[1], turns[2]}) >= 0 ||
         std::max({turns[0], turns[1], turns[2]}) <= 0;
}

using Corners = std::array<std::uint8_t, 3>;

bool has(const Corners& triangle, std::uint8_t vertex) {
  return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
}

/// Triangles with a common edge overlap if they lie in one plane, on one side of that edge.
bool fold(const Triangle& t, const Triangle& u, const Point& apex) {
  if (side_of(t, apex) != 0) return false;
  const std::array<Wide, 3> n = normal_of(t);
  const std::array<Wide, 3> m = normal_of(u);
  for (std::size_t a = 0; a < 3; ++a)
    if (n[a] != 0) return sign(n[a]) != sign(m[a]);  // both are directed like M
  return true;
}

template <class At>
bool cross(const Corners& a, const Corners& b, const At& at) {
  const auto shared =
      std::count_if(a.begin(), a.end(), [&](auto vertex) { return has(b, vertex); });
  const Triangle t{at(a[0]), at(a[1]), at(a[2])};
  const Triangle u{at(b[0]), at(b[1]), at(b[2])};
  if (shared > 1) {
    const auto apex =
        std::find_if(b.begin(), b.end(), [&](auto vertex) { return !has(a, vertex); });
    return apex == b.end() || fold(t, u, at(*apex));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    if (!has(b, a[i]) && !has(b, a[k]) && meets(u, t[i], t[k])) return true;
    if (!has(a, b[i]) && !has(a, b[k]) && meets(t, u[i], u[k])) return true;
  }
  return false;
}

}  // namespace

CubeVertices vertices_of(const CornerLevels& levels, const CornerLevels& tunnel_levels,
                         const LevelCut& cut, double least_share) {
  CubeVertices vertices{};
  for (int edge = 0; edge < first_ring_vertex; ++edge) {
    const auto [lower, upper] = edge_corners(edge);
    if ((levels[lower] >= 0) == (levels[upper] >= 0)) continue;
    for (int a = 0; a < 3; ++a) vertices[edge][a] = lower >> a & 1;
    vertices[edge][edge / 4] =
        std::clamp(levels[lower] / (levels[lower] - levels[upper]), least_share, 1 - least_share);
  }
  if (!cut.hub) return vertices;
  const auto ring = tunnel_ring(tunnel_levels, *cut.hub, least_share);
  std::copy(ring.begin(), ring.end(), vertices.begin() + first_ring_vertex);
  return vertices;
}

bool lie_within(const CubeVertices& vertices, const LevelCut& cut, double least_share) {
  const auto keeps_off = [&](double share) {
    return share >= least_share && share <= 1 - least_share;
  };
  for (int t = 0; t < cut.cut->triangle_count; ++t)
    for (const std::uint8_t vertex : cut.cut->triangles[t]) {
      const Vec3& point = vertices[vertex];
      const bool within = vertex < first_ring_vertex
                              ? keeps_off(point[vertex / 4])
                              : std::all_of(point.begin(), point.end(), keeps_off);
      if (!within) return false;
    }
  return true;
}

TriangleFaults triangle_faults(const CubeVertices& vertices, const LevelCut& cut, bool odd) {
  const auto inside = static_cast<std::uint8_t>(cut.inside);
  const auto joined = static_cast<std::uint8_t>(cut.joined);
  const CubeCut& drawn =
      cut.hub ? tunnel_cut(inside, joined, odd, *cut.hub).cut : cube_cut(inside, joined, odd);
  const auto at = [&](std::uint8_t vertex) {
    Point point{};
    for (std::size_t a = 0; a < 3; ++a)
      point[a] = std::llround(std::ldexp(vertices[vertex][a], 30));
    return point;
  };
  TriangleFaults faults;
  for (int t = 0; t < drawn.triangle_count; ++t) {
    const Corners& a = drawn.triangles[t];
    if (normal_of({at(a[0]), at(a[1]), at(a[2])}) == std::array<Wide, 3>{}) ++faults.without_area;
    for (int u = t + 1; u < drawn.triangle_count; ++u)
      if (cross(a, drawn.triangles[u], at)) ++faults.crossings;
  }
  return faults;
}

}  // namespace isoloop::testing
