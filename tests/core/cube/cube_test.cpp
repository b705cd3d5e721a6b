#include "core/cube/cube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

using DirectedEdge = std::pair<int, int>;  // cube edges that carry its ends

unsigned ring_bits(unsigned inside, int face) {
  unsigned bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= (inside >> face_ring(face)[i] & 1U) << i;
  return bits;
}

int edge_between(int corner, int other_corner) {
  for (int edge = 0; edge < 12; ++edge) {
    const auto ends = edge_corners(edge);
    if (std::minmax(corner, other_corner) == std::minmax(ends[0], ends[1])) return edge;
  }
  return -1;
}

/// Visits every cut: 256 corner signs, each choice on the ambiguous faces, both parities.
void for_each_cut(const std::function<void(unsigned, unsigned, const CubeCut&)>& visit) {
  for (unsigned inside = 0; inside < 256; ++inside)
    for (unsigned joined = 0; joined < 64; ++joined) {
      bool is_choice = true;
      for (int face = 0; face < 6; ++face)
        if ((joined >> face & 1U) != 0 && !is_ambiguous(ring_bits(inside, face))) is_choice = false;
      if (!is_choice) continue;
      for (const bool odd : {false, true})
        visit(inside, joined,
              cube_cut(static_cast<std::uint8_t>(inside), static_cast<std::uint8_t>(joined), odd));
    }
}

/// Visits every cut with a tunnel.
void for_each_tunnel(
    const std::function<void(unsigned, unsigned, const CubeCut&, int, const TunnelCut&)>& visit) {
  for_each_cut([&](unsigned inside, unsigned joined, const CubeCut& plain) {
    for (const bool odd : {false, true})
      for (const int hub : plain.hubs)
        visit(inside, joined, plain, hub,
              tunnel_cut(static_cast<std::uint8_t>(inside), static_cast<std::uint8_t>(joined), odd,
                         hub));
  });
}

/// The segments of M on the cube's six faces, directed.
std::set<DirectedEdge> face_segments(unsigned inside, unsigned joined) {
  std::set<DirectedEdge> segments;
  for (int face = 0; face < 6; ++face) {
    const auto ring = face_ring(face);
    const FaceCut cut = face_cut(ring_bits(inside, face), (joined >> face & 1U) != 0);
    const auto edge = [&](int i) { return edge_between(ring[i], ring[(i + 1) % 4]); };
    for (int s = 0; s < cut.segment_count; ++s)
      segments.emplace(edge(cut.segments[s][0]), edge(cut.segments[s][1]));
  }
  return segments;
}

std::map<DirectedEdge, int> directed_edges(const CubeCut& cut) {
  std::map<DirectedEdge, int> count;
  for (int t = 0; t < cut.triangle_count; ++t)
    for (int i = 0; i < 3; ++i) ++count[{cut.triangles[t][i], cut.triangles[t][(i + 1) % 3]}];
  return count;
}

TEST(Cube, EveryPatchEndsInTheFaceSegmentsAndNowhereElse) {
  int cuts = 0;
  for_each_cut([&](unsigned inside, unsigned joined, const CubeCut& cut) {
    ++cuts;
    std::set<DirectedEdge> border;
    for (const auto& [edge, count] : directed_edges(cut)) {
      EXPECT_EQ(count, 1) << "a directed edge occurs twice";
      if (directed_edges(cut).count({edge.second, edge.first}) == 0) border.insert(edge);
    }
    EXPECT_EQ(border, face_segments(inside, joined)) << inside << " " << joined;
  });
  EXPECT_GT(cuts, 2 * 256);
}

TEST(Cube, SaddlesOfFacesAreDecidedExactly) {
  const double up = std::nextafter(1.0, 2.0);
  const double twice_up = std::nextafter(up, 2.0);
  // up * up = 1 * twice_up + (up - 1)^2: as doubles the products are equal.
  EXPECT_TRUE(inside_is_joined({up, -1.0, up, -twice_up}));
  EXPECT_FALSE(inside_is_joined({1.0, -up, twice_up, -up}));
  EXPECT_FALSE(inside_is_joined({up, -up, up, -up})) << "a tie";
  for (const double tiny : {1e-200, 1e-310}) {  // whose products are 0 as doubles
    EXPECT_TRUE(inside_is_joined({2 * tiny, -tiny, 2 * tiny, -tiny}));
    EXPECT_TRUE(inside_is_joined({-tiny, 1e-200, -tiny, 2e-200}));
    EXPECT_FALSE(inside_is_joined({-2 * tiny, tiny, -2 * tiny, tiny}));
    EXPECT_FALSE(inside_is_joined({tiny, -tiny, tiny, -tiny})) << "a tie";
    EXPECT_FALSE(inside_is_joined({0.0, -tiny, 5.0, -tiny}));
  }
}

TEST(Cube, EveryPatchIsADisc) {
  for_each_cut([&](unsigned inside, unsigned joined, const CubeCut& cut) {
    std::set<int> vertices;
    std::set<DirectedEdge> edges;
    for (int t = 0; t < cut.triangle_count; ++t)
      for (int i = 0; i < 3; ++i) {
        const int a = cut.triangles[t][i];
        const int b = cut.triangles[t][(i + 1) % 3];
        vertices.insert(a);
        edges.insert(std::minmax(a, b));
      }
    const auto euler =
        static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + cut.triangle_count;
    EXPECT_EQ(euler, cut.disc_count) << inside << " " << joined;
  });
}

TEST(Cube, ATunnelsPatchesEndInTheFaceSegmentsAndNowhereElse) {
  int tunnels = 0;
  for_each_tunnel(
      [&](unsigned inside, unsigned joined, const CubeCut& plain, int, const TunnelCut& tunnel) {
        ++tunnels;
        std::set<DirectedEdge> border;
        std::set<int> vertices;
        const auto edges = directed_edges(tunnel.cut);
        for (const auto& [edge, count] : edges) {
          EXPECT_EQ(count, 1) << "a directed edge occurs twice";
          vertices.insert(edge.first);
          if (edges.count({edge.second, edge.first}) == 0) border.insert(edge);
        }
        EXPECT_EQ(border, face_segments(inside, joined)) << inside << " " << joined;
        const auto undirected = (edges.size() + border.size()) / 2;
        EXPECT_EQ(static_cast<int>(vertices.size()) - static_cast<int>(undirected) +
                      tunnel.cut.triangle_count,
                  plain.disc_count - 2)
            << "two discs become an annulus";
      });
  EXPECT_EQ(tunnels, 4 * 160);  // both parities, twice: for_each_cut() runs through both
}

TEST(Cube, ATunnelJoinsTwoCellsOfItsHubsSide) {
  for_each_tunnel(
      [&](unsigned inside, unsigned, const CubeCut& plain, int hub, const TunnelCut& tunnel) {
        const unsigned side = inside >> hub & 1U;
        EXPECT_EQ(tunnel.cut.cell_count[side] + 1, plain.cell_count[side]);
        EXPECT_EQ(tunnel.cut.cell_count[1 - side], plain.cell_count[1 - side]);
        std::map<int, std::set<int>> parts;  // of the hub's side, as before
        for (unsigned c = 0; c < 8; ++c) {
          if ((inside >> c & 1U) == side)
            parts[tunnel.cut.cell_of_corner[c]].insert(plain.cell_of_corner[c]);
          else
            EXPECT_EQ(tunnel.cut.cell_of_corner[c], plain.cell_of_corner[c]);
        }
        EXPECT_EQ(parts.size(), tunnel.cut.cell_count[side]);
        EXPECT_EQ(parts[tunnel.cut.cell_of_corner[hub]].size(), 2U);
      });
}

TEST(Cube, ACubeWithRoomForATunnelHasBothSidesOnEveryFace) {
  for_each_tunnel([&](unsigned inside, unsigned, const CubeCut&, int, const TunnelCut&) {
    for (int face = 0; face < 6; ++face) {
      EXPECT_NE(ring_bits(inside, face), 0U) << "the grid may end at this face";
      EXPECT_NE(ring_bits(inside, face), 15U);
    }
  });
}

TEST(Cube, AWallLeadsFromCurveToCurveOnTheOtherSide) {
  for_each_tunnel(
      [&](unsigned inside, unsigned joined, const CubeCut&, int hub, const TunnelCut& tunnel) {
        const CubeWall& wall = tunnel.wall;
        const unsigned torus = 1U - (inside >> hub & 1U);
        ASSERT_EQ(wall.edges.count, wall.corners.count + 1);
        ASSERT_GE(wall.corners.count, 1U);
        EXPECT_EQ(wall.edges[0], wall.on_m[0]);
        EXPECT_EQ(wall.edges[wall.edges.count - 1], wall.on_m[2]);
        for (std::size_t i = 0; i < wall.corners.count; ++i) {
          EXPECT_EQ(inside >> wall.corners[i] & 1U, torus);
          for (const int edge : {wall.edges[i], wall.edges[i + 1]}) {
            const auto ends = edge_corners(edge);
            EXPECT_TRUE(ends[0] == wall.corners[i] || ends[1] == wall.corners[i]);
          }
        }
        // Its two ends lie on different curves of the annulus.
        std::map<int, int> next;
        for (const auto& [from, to] : face_segments(inside, joined)) next[from] = to;
        for (int at = next.at(wall.on_m[0]); at != wall.on_m[0]; at = next.at(at))
          EXPECT_NE(at, wall.on_m[2]);
        const auto edges = directed_edges(tunnel.cut);
        for (const int end : {wall.on_m[0], wall.on_m[2]})
          EXPECT_EQ(edges.count({end, wall.on_m[1]}) + edges.count({wall.on_m[1], end}), 2U);
      });
}

TEST(Cube, AWallPartsTheTrianglesAtItsVertices) {
  // Neighbours in the fan at a vertex of the wall lie on different sides exactly across the wall;
  // on a grid edge the far side is that of the face that comes last round it.
  for_each_tunnel([&](unsigned, unsigned, const CubeCut&, int, const TunnelCut& tunnel) {
    const CubeCut& cut = tunnel.cut;
    const CubeWall& wall = tunnel.wall;
    for (std::size_t k = 0; k < 3; ++k) {
      const int hub = wall.on_m[k];
      std::map<int, std::vector<bool>> sides_of_rim;  // by the fan's rim vertices
      for (int t = 0; t < cut.triangle_count; ++t)
        for (int i = 0; i < 3; ++i) {
          if (cut.triangles[t][i] != hub) continue;
          const bool beyond =
              std::any_of(wall.beyond.begin(), wall.beyond.end(),
                          [&](const auto& at) { return at.triangle == t && at.corner == i; });
          for (const int step : {1, 2})
            sides_of_rim[cut.triangles[t][(i + step) % 3]].push_back(beyond);
        }
      const auto on_wall = [&](int rim) {
        return k == 1 ? rim == wall.on_m[0] || rim == wall.on_m[2] : rim == wall.on_m[1];
      };
      for (const auto& entry : sides_of_rim) {
        const int rim = entry.first;
        const std::vector<bool>& sides = entry.second;
        if (sides.size() == 2) {
          EXPECT_EQ(sides[0] != sides[1], on_wall(rim));
          continue;
        }
        ASSERT_NE(k, 1U);
        // A segment on a face at the grid edge. Its direction across the edge's axis:
        const int axis = hub / 4;
        const auto [b, c] = cross_axes(axis);
        const auto shared = [&](int a) {
          const auto here = edge_corners(hub);
          const auto there = edge_corners(rim);
          return (here[0] >> a & 1) == (there[0] >> a & 1) &&
                 (here[0] >> a & 1) == (there[1] >> a & 1);
        };
        const int quadrant_b = hub & 1;
        const int quadrant_c = hub >> 1 & 1;
        // Rotating from b to c within the quadrant, the face met last runs along c where the cube
        // lies on the same side along both axes, else along b.
        const bool last = quadrant_b == quadrant_c ? shared(b) : shared(c);
        EXPECT_EQ(sides[0], last);
      }
    }
  });
}

TEST(Cube, NeighboursAgreeOnTheSegmentsOfTheirCommonFace) {
  for (unsigned bits = 0; bits < 16; ++bits)
    for (const bool joined : {false, true}) {
      const FaceCut here = face_cut(bits, joined);
      // The neighbour sees the ring the other way round: its corner i is our corner 3 - i.
      unsigned mirrored = 0;
      for (unsigned i = 0; i < 4; ++i) mirrored |= (bits >> (3 - i) & 1U) << i;
      const FaceCut there = face_cut(mirrored, joined);
      std::set<DirectedEdge> mine;
      std::set<DirectedEdge> reversed;
      const auto our_edge = [](int i) { return (6 - i) % 4; };
      for (int s = 0; s < here.segment_count; ++s)
        mine.emplace(here.segments[s][0], here.segments[s][1]);
      for (int s = 0; s < there.segment_count; ++s)
        reversed.emplace(our_edge(there.segments[s][1]), our_edge(there.segments[s][0]));
      EXPECT_EQ(mine, reversed) << bits;
    }
}

TEST(Cube, NoTwoCubesShareADiagonal) {
  // Diagonals between edges of one face: those that a cube below may draw on its upper face and
  // those that a cube above may draw on its lower face, in the face's own terms.
  for (int axis = 0; axis < 3; ++axis) {
    const auto across = cross_axes(axis);
    std::array<std::set<DirectedEdge>, 2> drawn;
    for_each_cut([&](unsigned inside, unsigned joined, const CubeCut& cut) {
      const std::set<DirectedEdge> segments = face_segments(inside, joined);
      for (const auto& [edge, count] : directed_edges(cut)) {
        if (segments.count(edge) + segments.count({edge.second, edge.first}) > 0) continue;
        for (const int offset : {0, 1}) {
          const auto on_face = [&](int e) {
            const auto ends = edge_corners(e);
            return (ends[0] >> axis & 1) == offset && (ends[1] >> axis & 1) == offset;
          };
          if (!on_face(edge.first) || !on_face(edge.second)) continue;
          const auto in_face_terms = [&](int e) {
            const int lower = edge_corners(e)[0];
            return 4 * (e / 4) + 2 * (lower >> across[0] & 1) + (lower >> across[1] & 1);
          };
          drawn[offset].insert(std::minmax(in_face_terms(edge.first), in_face_terms(edge.second)));
        }
      }
    });
    for (const DirectedEdge& diagonal : drawn[0]) EXPECT_EQ(drawn[1].count(diagonal), 0U);
  }
}

TEST(Cube, NormalsPointOutside) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    const CubeCut& cut = cube_cut(static_cast<std::uint8_t>(1U << corner), 0, false);
    ASSERT_EQ(cut.triangle_count, 1);
    std::array<std::array<int, 3>, 3> p{};
    for (int i = 0; i < 3; ++i)
      for (const int end : edge_corners(cut.triangles[0][i]))
        for (int a = 0; a < 3; ++a) p[i][a] += end >> a & 1;
    const auto edge = [&](int i, int a) { return p[i][a] - p[0][a]; };
    int outward = 0;
    for (int a = 0; a < 3; ++a) {
      const auto [b, c] = cross_axes(a);
      const int normal = edge(1, b) * edge(2, c) - edge(1, c) * edge(2, b);
      outward += normal * (p[0][a] - 2 * static_cast<int>(corner >> a & 1U));
    }
    EXPECT_GT(outward, 0) << "corner " << corner;
  }
}

TEST(Cube, CellsArePartsOfTheCubesSurface) {
  for_each_cut([&](unsigned inside, unsigned joined, const CubeCut& cut) {
    // On a sphere, n disjoint closed curves leave n + 1 parts.
    if (cut.disc_count == 0) return;
    EXPECT_EQ(cut.cell_count[0] + cut.cell_count[1], cut.disc_count + 1) << inside << " " << joined;
  });
}

TEST(Cube, TheSaddleDecidesAmbiguousFaces) {
  EXPECT_TRUE(inside_is_joined({3, -1, 3, -1}));
  EXPECT_FALSE(inside_is_joined({1, -3, 1, -3}));
  EXPECT_TRUE(inside_is_joined({-1, 3, -1, 3}));
  EXPECT_FALSE(inside_is_joined({-3, 1, -3, 1}));
  EXPECT_FALSE(inside_is_joined({2, -2, 2, -2})) << "a tie keeps them apart";
}

}  // namespace
}  // namespace isoloop
