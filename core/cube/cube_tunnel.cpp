#include "core/cube/cube_tunnel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace isoloop {
namespace {

using Point = std::array<int, 3>;

bool is_inside(std::uint8_t inside, int corner) { return (inside >> corner & 1) != 0; }

int end_on(std::uint8_t inside, int cube_edge, bool on_inside) {
  const auto [lower, upper] = edge_corners(cube_edge);
  return is_inside(inside, lower) == on_inside ? lower : upper;
}

bool lies_on(int cube_edge, int axis, int offset) {
  const auto [lower, upper] = edge_corners(cube_edge);
  return (lower >> axis & 1) == offset && (upper >> axis & 1) == offset;
}

/// Whether some ambiguous face joins the corners on which it sees the ends of the hub's diagonal.
bool is_cast_joined(std::uint8_t inside, std::uint8_t joined, int hub) {
  for (int face = 0; face < 6; ++face) {
    const auto ring = face_ring(face);
    unsigned bits = 0;
    for (unsigned i = 0; i < 4; ++i) bits |= (is_inside(inside, ring[i]) ? 1U : 0U) << i;
    const int axis = face / 2;
    const int cast = (hub & ~(1 << axis)) | (face % 2) << axis;
    if (is_ambiguous(bits) && is_inside(inside, cast) == ((joined >> face & 1) != 0)) return true;
  }
  return false;
}

/// The cell of the hub's side at the corner across the cube: at itself or at all its neighbours.
std::optional<int> far_cell(std::uint8_t inside, const CubeCut& cut, int hub) {
  const int far = 7 - hub;
  if (is_inside(inside, far) == is_inside(inside, hub)) return cut.cell_of_corner[far];
  const int cell = cut.cell_of_corner[far ^ 1];
  for (int a = 0; a < 3; ++a) {
    const int corner = far ^ 1 << a;
    if (is_inside(inside, corner) != is_inside(inside, hub) || cut.cell_of_corner[corner] != cell)
      return std::nullopt;
  }
  return cell;
}

/// The curves that a tube from `hub` would join, the hub's own first: those between the two cells
/// at the ends of the diagonal and one cell of the other side.
std::optional<std::array<std::size_t, 2>> curves_at(std::uint8_t inside,
                                                    const std::vector<Polygon>& polygons,
                                                    const CubeCut& cut, int hub) {
  const bool side = is_inside(inside, hub);
  const int from = cut.cell_of_corner[hub];
  const std::optional<int> to = far_cell(inside, cut, hub);
  if (!to || *to == from) return std::nullopt;
  const auto cell = [&](std::size_t p, bool on_inside) {
    return cut.cell_of_corner[end_on(inside, polygons[p].front(), on_inside)];
  };
  for (std::size_t p = 0; p < polygons.size(); ++p)
    for (std::size_t q = 0; q < polygons.size(); ++q)
      if (cell(p, side) == from && cell(q, side) == *to && cell(p, !side) == cell(q, !side))
        return std::array{p, q};
  return std::nullopt;
}

/// Ten times twice the place of a vertex in the cube, the box between the roots being small.
Point place_of(int vertex, int hub) {
  Point place{};
  if (vertex < first_ring_vertex) {
    for (const int corner : edge_corners(vertex))
      for (int a = 0; a < 3; ++a) place[a] += 10 * (corner >> a & 1);
  } else {
    const int corner = hub ^ 1 << (vertex - first_ring_vertex);
    for (int a = 0; a < 3; ++a) place[a] = (corner >> a & 1) != 0 ? 12 : 8;
  }
  return place;
}

int squared_distance(int vertex, int other_vertex, int hub) {
  const Point p = place_of(vertex, hub);
  const Point q = place_of(other_vertex, hub);
  int squared = 0;
  for (int a = 0; a < 3; ++a) squared += (p[a] - q[a]) * (p[a] - q[a]);
  return squared;
}

void add_triangle(CubeCut& cut, int a, int b, int c) {
  cut.triangles[cut.triangle_count++] = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                                         static_cast<std::uint8_t>(c)};
}

/// Joins two closed curves, each directed as on the border of the band between them, by the band of
/// triangles whose cross edges are shortest. Step (i, k) of the way round is the cross edge from
/// vertex i of `left` to the k-th before `start` of `right`; none is taken twice.
void add_band(const Polygon& left, const Polygon& right, int hub, CubeCut& cut) {
  const int n = static_cast<int>(left.size());
  const int m = static_cast<int>(right.size());
  constexpr int never = std::numeric_limits<int>::max() / 2;
  const auto at = [&](int start, int i, int k) {
    return std::pair(left[i % n], right[(start + 2 * m - k) % m]);
  };
  int least = never;
  std::vector<std::array<int, 3>> best;
  for (int start = 0; start < m; ++start) {
    std::array<std::array<int, 14>, 14> cost{};
    for (int i = 0; i <= n; ++i)
      for (int k = 0; k <= m; ++k) {
        const auto [l, r] = at(start, i, k);
        const bool corner = (i == 0 && k == m) || (i == n && k == 0);
        const int before =
            i + k == 0 ? 0
                       : std::min(i > 0 ? cost[i - 1][k] : never, k > 0 ? cost[i][k - 1] : never);
        cost[i][k] = corner || before == never ? never : before + squared_distance(l, r, hub);
      }
    if (cost[n][m] >= least) continue;
    least = cost[n][m];
    best.clear();
    for (int i = n, k = m; i + k > 0;) {
      const auto [l, r] = at(start, i, k);
      if (i > 0 && (k == 0 || cost[i - 1][k] <= cost[i][k - 1])) {
        --i;
        best.push_back({left[i], l, r});
      } else {
        --k;
        best.push_back({r, at(start, i, k).second, l});
      }
    }
  }
  for (const auto& [a, b, c] : best) add_triangle(cut, a, b, c);
}

/// The ring, directed like the curve at the hub.
Polygon ring_round(int hub, bool side) {
  Polygon ring{first_ring_vertex, first_ring_vertex + 1, first_ring_vertex + 2};
  const bool even = std::popcount(static_cast<unsigned>(hub)) % 2 == 0;
  if (even != side) std::reverse(ring.begin(), ring.end());
  return ring;
}

void join_cells(std::uint8_t inside, int corner, int other_corner, CubeCut& cut) {
  const int a = cut.cell_of_corner[corner];
  const int b = cut.cell_of_corner[other_corner];
  const bool side = is_inside(inside, corner);
  for (int c = 0; c < 8; ++c) {
    std::uint8_t& cell = cut.cell_of_corner[c];
    if (is_inside(inside, c) != side) continue;
    if (cell == std::max(a, b))
      cell = static_cast<std::uint8_t>(std::min(a, b));
    else if (cell > std::max(a, b))
      --cell;
  }
  --cut.cell_count[side ? 1 : 0];
}

/// A shortest way along cube edges between corners of one side: all corners on it.
std::vector<int> way_between(std::uint8_t inside, int from, int to) {
  std::vector<std::vector<int>> ways{{from}};
  for (std::size_t next = 0; next < ways.size(); ++next) {
    const std::vector<int> way = ways[next];
    if (way.back() == to) return way;
    if (way.size() == 8) continue;
    for (int a = 0; a < 3; ++a) {
      const int corner = way.back() ^ 1 << a;
      if (is_inside(inside, corner) != is_inside(inside, from)) continue;
      ways.push_back(way);
      ways.back().push_back(corner);
    }
  }
  return {};
}

int edge_between(int corner, int other_corner) {
  int edge = 0;
  while (edge_corners(edge) !=
         std::array{std::min(corner, other_corner), std::max(corner, other_corner)})
    ++edge;
  return edge;
}

/// Whether two vertices are joined by an edge of the cut's triangles.
bool are_joined(const CubeCut& cut, int vertex, int other_vertex) {
  return std::any_of(cut.triangles.begin(), cut.triangles.begin() + cut.triangle_count,
                     [&](const auto& t) {
                       return std::find(t.begin(), t.end(), vertex) != t.end() &&
                              std::find(t.begin(), t.end(), other_vertex) != t.end();
                     });
}

/// The triangles at `hub` from the one that holds `from` to the one that holds `to`, as corners.
std::vector<CubeWall::TriangleCorner> sector(const CubeCut& cut, int hub, int from, int to) {
  std::vector<CubeWall::TriangleCorner> found;
  std::set<int> seen;
  for (int rim = from; rim != to;) {
    int next = -1;
    for (int t = 0; t < cut.triangle_count && next < 0; ++t) {
      const auto& corners = cut.triangles[t];
      for (int i = 0; i < 3; ++i) {
        if (corners[i] != hub || seen.count(t) > 0) continue;
        const int b = corners[(i + 1) % 3];
        const int c = corners[(i + 2) % 3];
        if (b != rim && c != rim) continue;
        seen.insert(t);
        found.push_back({static_cast<std::uint8_t>(t), static_cast<std::uint8_t>(i)});
        next = b == rim ? c : b;
        break;
      }
    }
    rim = next;
  }
  return found;
}

/// The neighbour of a curve's vertex on the face of its cube edge that comes last in the sense of
/// rotation from axis b to c of cross_axes() about that edge.
int last_neighbour(const Polygon& polygon, int vertex) {
  const int axis = vertex / 4;
  const auto [b, c] = cross_axes(axis);
  const int at_b = vertex & 1;
  const int at_c = vertex >> 1 & 1;
  const std::size_t at =
      static_cast<std::size_t>(std::find(polygon.begin(), polygon.end(), vertex) - polygon.begin());
  const int after = polygon[(at + 1) % polygon.size()];
  const int before = polygon[(at + polygon.size() - 1) % polygon.size()];
  const bool last_is_across_b = at_b == at_c;
  return (last_is_across_b ? lies_on(after, b, at_b) : lies_on(after, c, at_c)) ? after : before;
}

CubeWall build_wall(std::uint8_t inside, const Polygon& left, const Polygon& right, int hub,
                    const CubeCut& cut) {
  const bool side = is_inside(inside, hub);
  using Cost = std::tuple<std::size_t, int>;
  Cost least{std::numeric_limits<std::size_t>::max(), 0};
  CubeWall wall;
  std::vector<int> way;
  for (const int u : left)
    for (int r = first_ring_vertex; r < first_ring_vertex + ring_size; ++r)
      for (const int v : right) {
        if (!are_joined(cut, u, r) || !are_joined(cut, r, v)) continue;
        const std::vector<int> corners =
            way_between(inside, end_on(inside, u, !side), end_on(inside, v, !side));
        if (corners.empty()) continue;
        const Cost cost{corners.size(), squared_distance(u, r, hub) + squared_distance(r, v, hub)};
        if (cost >= least) continue;
        least = cost;
        way = corners;
        wall.on_m = {static_cast<std::uint8_t>(u), static_cast<std::uint8_t>(r),
                     static_cast<std::uint8_t>(v)};
      }
  const auto& [u, r, v] = wall.on_m;
  wall.edges.push_back(u);
  for (std::size_t i = 0; i < way.size(); ++i) {
    wall.corners.push_back(static_cast<std::uint8_t>(way[i]));
    wall.edges.push_back(
        i + 1 < way.size() ? static_cast<std::uint8_t>(edge_between(way[i], way[i + 1])) : v);
  }
  const auto add_beyond = [&](const std::vector<CubeWall::TriangleCorner>& corners) {
    wall.beyond.insert(wall.beyond.end(), corners.begin(), corners.end());
  };
  add_beyond(sector(cut, u, last_neighbour(left, u), r));
  add_beyond(sector(cut, r, u, v));
  add_beyond(sector(cut, v, last_neighbour(right, v), r));
  return wall;
}

}  // namespace

InplaceVector<std::uint8_t, 2> tunnel_hubs(std::uint8_t inside, std::uint8_t joined,
                                           const std::vector<Polygon>& polygons,
                                           const CubeCut& cut) {
  InplaceVector<std::uint8_t, 2> hubs;
  for (int hub = 0; hub < 8; ++hub) {
    if (is_cast_joined(inside, joined, hub)) continue;
    const auto curves = curves_at(inside, polygons, cut, hub);
    if (!curves) continue;
    const auto [p, q] = *curves;
    if (std::pair(polygons[p].size(), p) < std::pair(polygons[q].size(), q))
      hubs.push_back(static_cast<std::uint8_t>(hub));
  }
  return hubs;
}

TunnelCut drill_tunnel(std::uint8_t inside, const std::vector<Polygon>& polygons,
                       const CubeCut& plain, int hub) {
  const auto [p, q] = *curves_at(inside, polygons, plain, hub);
  TunnelCut tunnel;
  CubeCut& cut = tunnel.cut;
  cut = plain;
  cut.hubs = {};
  cut.triangle_count = 0;
  cut.disc_count = static_cast<std::uint8_t>(plain.disc_count - 2);
  int next = 0;
  for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon) {
    const int count = static_cast<int>(polygons[polygon].size()) - 2;
    for (int t = next; t < next + count; ++t)
      if (polygon != p && polygon != q) cut.triangles[cut.triangle_count++] = plain.triangles[t];
    next += count;
  }
  const bool side = is_inside(inside, hub);
  const Polygon ring = ring_round(hub, side);
  add_band(polygons[p], {ring.rbegin(), ring.rend()}, hub, cut);
  add_band(ring, polygons[q], hub, cut);
  join_cells(inside, hub, end_on(inside, polygons[q].front(), side), cut);
  tunnel.wall = build_wall(inside, polygons[p], polygons[q], hub, cut);
  return tunnel;
}

}  // namespace isoloop
