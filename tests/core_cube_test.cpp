#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/cube.h"

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
    EXPECT_EQ(euler, cut.polygon_count) << inside << " " << joined;
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
    if (cut.polygon_count == 0) return;
    EXPECT_EQ(cut.cell_count[0] + cut.cell_count[1], cut.polygon_count + 1)
        << inside << " " << joined;
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
