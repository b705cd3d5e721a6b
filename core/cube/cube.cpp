#include "core/cube/cube.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/cube/cube_tunnel.h"

namespace isoloop {
namespace {

using Point = std::array<int, 3>;

constexpr int cube_edge(int axis, int u, int v) { return 4 * axis + u + 2 * v; }

Point corner_position(int corner) { return {corner & 1, corner >> 1 & 1, corner >> 2 & 1}; }

/// Twice the midpoint of a cube edge.
Point edge_position(int edge) {
  const auto [lower, upper] = edge_corners(edge);
  Point p = corner_position(lower);
  for (int a = 0; a < 3; ++a) p[a] += corner_position(upper)[a];
  return p;
}

std::array<std::array<std::uint8_t, 4>, 6> make_face_rings() {
  std::array<std::array<std::uint8_t, 4>, 6> rings{};
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const auto [b, c] = cross_axes(axis);
    const std::array<std::array<int, 2>, 4> walk{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (int i = 0; i < 4; ++i) {
      const auto& [u, v] = walk[i];
      rings[face][face % 2 == 1 ? i : 3 - i] =
          static_cast<std::uint8_t>((face % 2) << axis | u << b | v << c);
    }
  }
  return rings;
}

int edge_between(int corner, int other_corner) {
  const int axis = (corner ^ other_corner) == 1 ? 0 : (corner ^ other_corner) == 2 ? 1 : 2;
  const auto [b, c] = cross_axes(axis);
  return cube_edge(axis, corner >> b & 1, corner >> c & 1);
}

/// Bit i: corner i of the face's ring is inside.
unsigned ring_bits(std::uint8_t inside, int face) {
  unsigned bits = 0;
  for (int i = 0; i < 4; ++i) bits |= (inside >> face_ring(face)[i] & 1U) << i;
  return bits;
}

/// Follows M once round the cube's faces: next[e] is the cut edge that comes after cut edge e.
std::array<int, 12> trace_segments(std::uint8_t inside, std::uint8_t joined) {
  std::array<int, 12> next;
  next.fill(-1);
  for (int face = 0; face < 6; ++face) {
    const auto ring = face_ring(face);
    const auto edge = [&](int i) { return edge_between(ring[i], ring[(i + 1) % 4]); };
    const FaceCut cut = face_cut(ring_bits(inside, face), (joined >> face & 1) != 0);
    for (int s = 0; s < cut.segment_count; ++s)
      next[edge(cut.segments[s][0])] = edge(cut.segments[s][1]);
  }
  return next;
}

std::vector<Polygon> trace_polygons(std::uint8_t inside, std::uint8_t joined) {
  std::array<int, 12> next = trace_segments(inside, joined);
  std::vector<Polygon> polygons;
  for (int start = 0; start < 12; ++start) {
    if (next[start] < 0) continue;
    polygons.emplace_back();
    for (int e = start; next[e] >= 0;) {
      polygons.back().push_back(e);
      e = std::exchange(next[e], -1);
    }
  }
  return polygons;
}

/// Whether two cut edges may be joined by a diagonal. A diagonal within a cube face could be met
/// again in the next cube, and M would have a doubled edge; so a cube may use those between
/// opposite edges of its lower faces and those between adjacent edges of its upper faces only.
/// (Every polygon that occurs has a triangulation under this rule; a test checks all of them.)
bool may_join(int edge, int other_edge) {
  const Point p = edge_position(edge);
  const Point q = edge_position(other_edge);
  const bool opposite = edge / 4 == other_edge / 4;
  for (int a = 0; a < 3; ++a) {
    if (p[a] != q[a] || p[a] == 1) continue;
    const bool upper = p[a] == 2;
    if (upper == opposite) return false;
  }
  return true;
}

/// Parity of the grid line that the edge lies on.
bool on_odd_line(int edge, bool odd_cube) {
  const Point p = corner_position(edge_corners(edge)[0]);
  return ((p[0] + p[1] + p[2]) % 2 != 0) != odd_cube;
}

/// Cost of a diagonal: its squared length between edge midpoints first, then parity: on a flat part
/// of M the diagonals all meet on odd lines, and paths run both ways along them.
int diagonal_cost(int edge, int other_edge, bool odd_cube) {
  if (!may_join(edge, other_edge)) return 100'000;
  const Point p = edge_position(edge);
  const Point q = edge_position(other_edge);
  int squared = 0;
  for (int a = 0; a < 3; ++a) squared += (p[a] - q[a]) * (p[a] - q[a]);
  const int even_ends = static_cast<int>(!on_odd_line(edge, odd_cube)) +
                        static_cast<int>(!on_odd_line(other_edge, odd_cube));
  return 16 * squared + even_ends;
}

/// Triangulation of least cost by the classical recurrence over chords i < m < k.
void triangulate(const Polygon& polygon, bool odd_cube, CubeCut& cut) {
  const int n = static_cast<int>(polygon.size());
  std::array<std::array<int, 12>, 12> cost{};
  std::array<std::array<int, 12>, 12> split{};
  for (int width = 2; width < n; ++width) {
    for (int i = 0, k = width; k < n; ++i, ++k) {
      cost[i][k] = std::numeric_limits<int>::max();
      for (int m = i + 1; m < k; ++m) {
        if (cost[i][m] + cost[m][k] >= cost[i][k]) continue;
        cost[i][k] = cost[i][m] + cost[m][k];
        split[i][k] = m;
      }
      if (width < n - 1) cost[i][k] += diagonal_cost(polygon[i], polygon[k], odd_cube);
    }
  }
  std::vector<std::array<int, 2>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (k - i < 2) continue;
    const int m = split[i][k];
    cut.triangles[cut.triangle_count++] = {static_cast<std::uint8_t>(polygon[i]),
                                           static_cast<std::uint8_t>(polygon[m]),
                                           static_cast<std::uint8_t>(polygon[k])};
    open.push_back({m, k});
    open.push_back({i, m});
  }
}

/// Numbers the cells of each side: corners joined along cube edges or across ambiguous faces.
void number_cells(std::uint8_t inside, std::uint8_t joined, CubeCut& cut) {
  std::array<int, 8> root{0, 1, 2, 3, 4, 5, 6, 7};
  const auto merge = [&](int a, int b) {
    const int from = std::max(root[a], root[b]);
    const int to = std::min(root[a], root[b]);
    std::replace(root.begin(), root.end(), from, to);
  };
  const auto is_inside = [&](int corner) { return (inside >> corner & 1) != 0; };
  for (int edge = 0; edge < 12; ++edge) {
    const auto [a, b] = edge_corners(edge);
    if (is_inside(a) == is_inside(b)) merge(a, b);
  }
  for (int face = 0; face < 6; ++face) {
    if (!is_ambiguous(ring_bits(inside, face))) continue;
    const auto ring = face_ring(face);
    const bool first_pair = is_inside(ring[0]) == ((joined >> face & 1) != 0);
    merge(ring[first_pair ? 0 : 1], ring[first_pair ? 2 : 3]);
  }
  for (int corner = 0; corner < 8; ++corner) {
    std::uint8_t& count = cut.cell_count[is_inside(corner) ? 1 : 0];
    cut.cell_of_corner[corner] =
        root[corner] == corner ? count++ : cut.cell_of_corner[root[corner]];
  }
}

CubeCut make_cut(std::uint8_t inside, const std::vector<Polygon>& polygons, std::uint8_t joined,
                 bool odd) {
  CubeCut cut;
  for (const Polygon& polygon : polygons) {
    ++cut.disc_count;
    triangulate(polygon, odd, cut);
  }
  number_cells(inside, joined, cut);
  cut.hubs = tunnel_hubs(inside, joined, polygons, cut);
  return cut;
}

unsigned key_of(unsigned inside, unsigned joined, bool odd) {
  return inside << 7 | joined << 1 | (odd ? 1U : 0U);
}

/// All cuts, for every choice on the ambiguous faces.
struct CutTable {
  std::vector<CubeCut> cuts;
  std::vector<std::uint16_t> index = std::vector<std::uint16_t>(std::size_t{1} << 15);
  std::unordered_map<unsigned, TunnelCut> tunnels;  // by 8 * key_of() + hub

  CutTable() {
    for (unsigned inside = 0; inside < 256; ++inside) {
      unsigned ambiguous = 0;
      for (int face = 0; face < 6; ++face)
        if (is_ambiguous(ring_bits(static_cast<std::uint8_t>(inside), face)))
          ambiguous |= 1U << face;
      for (unsigned joined = 0; joined < 64; ++joined)
        for (const bool odd : {false, true}) {
          if ((joined & ambiguous) == joined)
            add(static_cast<std::uint8_t>(inside), static_cast<std::uint8_t>(joined), odd);
          else
            index[key_of(inside, joined, odd)] = index[key_of(inside, joined & ambiguous, odd)];
        }
    }
  }

  void add(std::uint8_t inside, std::uint8_t joined, bool odd) {
    const unsigned key = key_of(inside, joined, odd);
    const std::vector<Polygon> polygons = trace_polygons(inside, joined);
    index[key] = static_cast<std::uint16_t>(cuts.size());
    const CubeCut& cut = cuts.emplace_back(make_cut(inside, polygons, joined, odd));
    for (const std::uint8_t hub : cut.hubs)
      tunnels.emplace(8 * key + hub, drill_tunnel(inside, polygons, cut, hub));
  }
};

const CutTable& table() {
  static const CutTable cuts;
  return cuts;
}

/// Whether a b > c d, exactly: where the rounded products are equal the remainders tell. a and b
/// are not negative; c and d are negative.
bool is_larger_product(double a, double b, double c, double d) {
  if (a == 0 || b == 0) return false;
  int exponent = 0;  // of a b over c d, mantissas apart, whose products lie within a factor of 4
  const auto mantissa = [&](double value, int sign) {
    int own = 0;
    const double scaled = std::frexp(value, &own);
    exponent += sign * own;
    return scaled;
  };
  b = mantissa(b, 1);
  c = mantissa(c, -1);
  d = mantissa(d, -1);
  a = mantissa(a, 1);
  a = std::ldexp(a, std::clamp(exponent, -4, 4));
  const double ab = a * b;
  const double cd = c * d;
  return ab != cd ? ab > cd : std::fma(a, b, -ab) > std::fma(c, d, -cd);
}

}  // namespace

std::span<const std::uint8_t, 4> face_ring(int face) {
  static const std::array<std::array<std::uint8_t, 4>, 6> rings = make_face_rings();
  return rings[face];
}

FaceCut face_cut(unsigned ring_inside, bool joined) {
  const auto is_inside = [&](int i) { return (ring_inside >> (i % 4) & 1U) != 0; };
  const bool forward = !is_ambiguous(ring_inside) || joined;
  FaceCut cut;
  for (int leave = 0; leave < 4; ++leave) {
    if (!is_inside(leave) || is_inside(leave + 1)) continue;
    int enter = forward ? leave + 1 : leave + 3;
    while (is_inside(enter) || !is_inside(enter + 1)) ++enter;
    cut.segments[cut.segment_count++] = {static_cast<std::uint8_t>(enter % 4),
                                         static_cast<std::uint8_t>(leave)};
  }
  return cut;
}

std::array<int, 2> edge_corners(int cube_edge) {
  const int axis = cube_edge / 4;
  const auto [b, c] = cross_axes(axis);
  const int lower = (cube_edge & 1) << b | (cube_edge >> 1 & 1) << c;
  return {lower, lower | 1 << axis};
}

const CubeCut& cube_cut(std::uint8_t inside, std::uint8_t joined, bool odd) {
  return table().cuts[table().index[key_of(inside, joined, odd)]];
}

const TunnelCut& tunnel_cut(std::uint8_t inside, std::uint8_t joined, bool odd, int hub) {
  return table().tunnels.at(8 * key_of(inside, joined, odd) + static_cast<unsigned>(hub));
}

bool inside_is_joined(const std::array<double, 4>& level) {
  const int first = level[0] >= 0 ? 0 : 1;
  const double in = level[first] * level[first + 2];
  const double out = level[1 - first] * level[3 - first];
  if (in != out) return in > out;
  return is_larger_product(level[first], level[first + 2], level[1 - first], level[3 - first]);
}

}  // namespace isoloop
