#include "tools/page/drawn_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/grid/vec3.h"

namespace isoloop {
namespace {

Vec3 world_point(const LoopsRun& run, std::uint32_t vertex) {
  const auto [x, y, z] = run.analysis.surface.points[vertex];
  return to_world(run.volume, {x, y, z});
}

/// All components, the largest area first.
std::vector<DrawnPiece> pieces_of(const LoopsRun& run) {
  const Surface& surface = run.analysis.surface;
  std::vector<DrawnPiece> pieces(surface.components.size());
  for (std::uint32_t c = 0; c < pieces.size(); ++c) pieces[c].component = c;
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3 corner = world_point(run, a);
    const Vec3 normal =
        cross(minus(world_point(run, b), corner), minus(world_point(run, c), corner));
    pieces[surface.component_of_vertex[a]].area += 0.5 * std::sqrt(dot(normal, normal));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const DrawnPiece& a, const DrawnPiece& b) { return a.area > b.area; });
  return pieces;
}

/// The vertices and triangles of M that `is_drawn`; `sources` are vertices of M.
TriangleMesh part_of(const LoopsRun& run, const std::vector<char>& is_drawn) {
  const Surface& surface = run.analysis.surface;
  TriangleMesh part;
  std::vector<std::uint32_t> point_of_vertex(surface.points.size(), not_drawn);
  for (std::uint32_t v = 0; v < surface.points.size(); ++v) {
    if (is_drawn[surface.component_of_vertex[v]] == 0) continue;
    point_of_vertex[v] = static_cast<std::uint32_t>(part.points.size());
    part.points.push_back(world_point(run, v));
    part.sources.push_back(v);
  }
  for (const auto& [a, b, c] : surface.triangles)
    if (point_of_vertex[a] != not_drawn)
      part.triangles.push_back({point_of_vertex[a], point_of_vertex[b], point_of_vertex[c]});
  return part;
}

/// simplified(), with `sources` as those of `mesh`.
TriangleMesh simplified_part(const TriangleMesh& mesh, std::size_t most_triangles,
                             HandleRule handles) {
  TriangleMesh result = simplified(mesh, most_triangles, handles);
  for (std::uint32_t& source : result.sources) source = mesh.sources[source];
  return result;
}

/// Puts the triangles in the order of the pieces and counts them.
void sort_by_piece(DrawnSurface& drawn, const std::vector<std::uint32_t>& component_of_vertex,
                   std::size_t component_count) {
  std::vector<std::uint32_t> place(component_count);
  for (std::uint32_t i = 0; i < drawn.pieces.size(); ++i) place[drawn.pieces[i].component] = i;
  const auto piece_of = [&](const std::array<std::uint32_t, 3>& triangle) {
    return place[component_of_vertex[drawn.mesh.sources[triangle[0]]]];
  };
  auto& triangles = drawn.mesh.triangles;
  for (const auto& triangle : triangles) ++drawn.pieces[piece_of(triangle)].triangles;
  std::stable_sort(triangles.begin(), triangles.end(),
                   [&](const auto& a, const auto& b) { return piece_of(a) < piece_of(b); });
}

}  // namespace

DrawnSurface drawn_surface(const LoopsRun& run, std::size_t most_triangles,
                           std::size_t most_pieces) {
  const Surface& surface = run.analysis.surface;
  // Small pieces keep some eight triangles each, and the large ones are to have most of them.
  constexpr std::size_t triangles_of_piece = 20;
  most_pieces =
      std::max<std::size_t>(1, std::min(most_pieces, most_triangles / triangles_of_piece));
  DrawnSurface drawn;
  drawn.pieces = pieces_of(run);
  if (drawn.pieces.size() > most_pieces) {
    drawn.pieces_left_out = drawn.pieces.size() - most_pieces;
    drawn.area_left_out = drawn.pieces[most_pieces].area;
    drawn.pieces.resize(most_pieces);
  }
  std::vector<char> is_drawn(surface.components.size(), 0);
  for (const DrawnPiece& piece : drawn.pieces) is_drawn[piece.component] = 1;
  const TriangleMesh part = part_of(run, is_drawn);
  drawn.mesh = simplified_part(part, most_triangles, HandleRule::keep);
  if (drawn.mesh.triangles.size() > 2 * most_triangles) {
    drawn.mesh = simplified_part(part, 2 * most_triangles, HandleRule::drop_small);
    drawn.same_topology = false;
  }
  sort_by_piece(drawn, surface.component_of_vertex, surface.components.size());
  drawn.point_of_vertex.assign(surface.points.size(), not_drawn);
  for (std::uint32_t point = 0; point < drawn.mesh.points.size(); ++point)
    drawn.point_of_vertex[drawn.mesh.sources[point]] = point;
  return drawn;
}

}  // namespace isoloop
