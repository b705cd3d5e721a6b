#include "core/repair/local_surface.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/curves/curve.h"
#include "core/loops/certificate.h"

namespace isoloop {
namespace {

constexpr std::uint32_t carriers = first_ring_vertex + ring_size;  // of vertices of M, in a cube

/// Where M leaves the cubes along a face.
struct BorderSegment {
  std::array<std::uint32_t, 2> carriers;
  std::array<std::uint32_t, 2> vertices;  // of M
};

/// M within the cubes: patches, glued along the segments on faces between cubes.
/// Where two parts of the border touch at a vertex of M each has a copy of its own.
class PatchesOfCubes {
 public:
  /// `cut_at(cube)` gives its DecidedCube.
  template <class CutAt>
  PatchesOfCubes(const Workings& workings, std::span<const std::uint32_t> vertices,
                 const CutAt& cut_at)
      : workings_(workings),
        lattice_(workings.sides->lattice),
        cubes_(cubes_at(lattice_, vertices)),
        parts_(carriers * static_cast<std::uint32_t>(cubes_.size())),
        copies_(carriers * static_cast<std::uint32_t>(cubes_.size())) {
    for (std::uint32_t k = 0; k < cubes_.size(); ++k) read_cube(k, cut_at(cubes_[k]));
  }

  LocalSurface surface() {
    LocalSurface surface;
    surface.cubes = cubes_;
    DisjointSets curves(carriers * static_cast<std::uint32_t>(cubes_.size()));
    for (const BorderSegment& segment : border_)
      curves.unite(copies_.find(segment.carriers[0]), copies_.find(segment.carriers[1]));
    std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 2>>> by_curve;
    std::map<std::uint32_t, GeneratorSet> by_part;
    std::map<std::uint32_t, std::uint32_t> part_of_curve;
    for (const BorderSegment& segment : border_) {
      const std::uint32_t curve = curves.find(copies_.find(segment.carriers[0]));
      by_curve[curve].push_back(segment.vertices);
      part_of_curve[curve] = parts_.find(segment.carriers[0]);
      surface.part_of_segment.push_back(part_of_curve[curve]);
    }
    for (const auto& [curve, segments] : by_curve) {
      surface.curves.push_back(
          class_of(workings_.analysis.surface, workings_.classes, closed_curves(segments)));
      GeneratorSet& part = by_part[part_of_curve[curve]];
      part = sum_of(part, surface.curves.back());
    }
    for (const auto& [part, border] : by_part) surface.parts.push_back(border);
    std::set<std::uint32_t> all_parts;
    std::set<std::uint32_t> all_copies;
    for (const std::uint32_t carrier : used_) {
      all_parts.insert(parts_.find(carrier));
      all_copies.insert(copies_.find(carrier));
    }
    const std::int64_t euler = discs_ - segments_ + static_cast<std::int64_t>(all_copies.size());
    surface.has_handle = euler != 2 * static_cast<std::int64_t>(all_parts.size()) -
                                      static_cast<std::int64_t>(by_curve.size());
    return surface;
  }

 private:
  static std::vector<std::uint32_t> cubes_at(const Lattice& lattice,
                                             std::span<const std::uint32_t> vertices) {
    std::vector<std::uint32_t> cubes;
    for (const std::uint32_t vertex : vertices)
      for (unsigned c = 0; c < 8; ++c)
        cubes.push_back(
            lattice.corner(vertex - lattice.stride[0] - lattice.stride[1] - lattice.stride[2], c));
    std::sort(cubes.begin(), cubes.end());
    cubes.erase(std::unique(cubes.begin(), cubes.end()), cubes.end());
    return cubes;
  }

  void read_cube(std::uint32_t k, const DecidedCube& cube) {
    const CubeCut& cut = *cube.cut;
    discs_ += cut.disc_count;
    for (std::size_t t = 0; t < cut.triangle_count; ++t)
      for (const std::uint8_t corner : cut.triangles[t]) {
        parts_.unite(carriers * k + cut.triangles[t][0], carriers * k + corner);
        // The ring round a tunnel lies within its annulus, which counts as no disc.
        if (corner < first_ring_vertex) used_.insert(carriers * k + corner);
      }
    read_faces(k, cube);
  }

  /// Joins the patches on both sides of a face, or notes where they leave the cubes.
  void read_faces(std::uint32_t k, const DecidedCube& cube) {
    for (int face = 0; face < 6; ++face) {
      const auto ring = face_ring(face);
      unsigned ring_inside = 0;
      for (unsigned i = 0; i < 4; ++i) ring_inside |= (cube.inside >> ring[i] & 1U) << i;
      const FaceCut cut = face_cut(ring_inside, (cube.joined >> face & 1U) != 0);
      for (std::size_t s = 0; s < cut.segment_count; ++s)
        add_segment(k, face,
                    {edge_of(k, ring, cut.segments[s][0]), edge_of(k, ring, cut.segments[s][1])});
    }
  }

  /// The lattice edge from corner i of the ring to the next one.
  std::uint32_t edge_of(std::uint32_t k, std::span<const std::uint8_t, 4> ring, unsigned i) const {
    const std::uint32_t a = lattice_.corner(cubes_[k], ring[i]);
    const std::uint32_t b = lattice_.corner(cubes_[k], ring[(i + 1) % 4]);
    std::uint32_t axis = 0;
    while (lattice_.stride[axis] != std::max(a, b) - std::min(a, b)) ++axis;
    return 3 * std::min(a, b) + axis;
  }

  std::uint32_t carrier_of(std::uint32_t k, std::uint32_t edge) const {
    int cube_edge = 0;
    while (lattice_edge(lattice_, cubes_[k], cube_edge) != edge) ++cube_edge;
    return carriers * k + static_cast<std::uint32_t>(cube_edge);
  }

  void add_segment(std::uint32_t k, int face, const std::array<std::uint32_t, 2>& edges) {
    const std::uint32_t stride = lattice_.stride[static_cast<std::size_t>(face / 2)];
    const std::uint32_t beyond = face % 2 == 0 ? cubes_[k] - stride : cubes_[k] + stride;
    const auto at = std::lower_bound(cubes_.begin(), cubes_.end(), beyond);
    if (at == cubes_.end() || *at != beyond) {
      border_.push_back(
          {{carrier_of(k, edges[0]), carrier_of(k, edges[1])},
           {workings_.edges->vertex_on(edges[0]), workings_.edges->vertex_on(edges[1])}});
      ++segments_;
    } else if (const auto other = static_cast<std::uint32_t>(at - cubes_.begin()); other > k) {
      for (const std::uint32_t edge : edges) {
        parts_.unite(carrier_of(k, edge), carrier_of(other, edge));
        copies_.unite(carrier_of(k, edge), carrier_of(other, edge));
      }
      ++segments_;
    }
  }

  const Workings& workings_;
  const Lattice& lattice_;
  std::vector<std::uint32_t> cubes_;
  DisjointSets parts_;   // of `carriers` for each cube
  DisjointSets copies_;  // of a vertex of M
  std::set<std::uint32_t> used_;
  std::vector<BorderSegment> border_;
  std::int64_t discs_ = 0;
  std::int64_t segments_ = 0;
};

}  // namespace

LocalSurface local_surface(const Workings& workings, std::span<const std::uint32_t> vertices) {
  const VoxelSides& sides = *workings.sides;
  const auto cube_before = [&](std::uint32_t cube) {
    return DecidedCube{inside_corners(sides, cube), joined_faces(sides, cube),
                       &cut_at(sides, cube)};
  };
  return PatchesOfCubes(workings, vertices, cube_before).surface();
}

LocalSurface local_surface(const Workings& workings, const CurrentVolume& volume,
                           std::span<const std::uint32_t> vertices) {
  const auto cube_now = [&](std::uint32_t cube) {
    return volume.cube_at(volume.lattice().voxel_at(cube));
  };
  return PatchesOfCubes(workings, vertices, cube_now).surface();
}

}  // namespace isoloop
