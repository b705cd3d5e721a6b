#include "core/repair/current_volume.h"

#include <array>

#include "core/grid/level.h"

namespace isoloop {
namespace {

/// By corners of a cube: whether they hang together along its edges.
constexpr std::array<bool, 256> whole_along_edges() {
  std::array<bool, 256> whole{};
  for (unsigned corners = 0; corners < 256; ++corners) {
    unsigned reached = corners & (~corners + 1);
    for (int step = 0; step < 8; ++step)
      reached |=
          corners & ((reached & 0x55U) << 1 | (reached & 0xAAU) >> 1 | (reached & 0x33U) << 2 |
                     (reached & 0xCCU) >> 2 | (reached & 0x0FU) << 4 | (reached & 0xF0U) >> 4);
    whole[corners] = reached == corners;
  }
  return whole;
}

constexpr std::array<bool, 256> is_whole_along_edges = whole_along_edges();

}  // namespace

CurrentVolume::CurrentVolume(const VoxelSides& sides, const IsoLevel& level, VoxelValues& values)
    : sides_(sides), level_(level), values_(values), inside_(sides.inside) {}

void CurrentVolume::set(std::size_t voxel, double value) {
  values_.set(voxel, value);
  inside_[vertex_at(voxel_index(voxel, values_.dims()))] = level_of(value, level_) >= 0.0 ? 1 : 0;
}

DecidedCube CurrentVolume::cube_at(const Index3& lowest) const {
  const Index3& dims = values_.dims();
  CornerLevels levels{};
  for (int c = 0; c < 8; ++c) {
    const std::int64_t x = lowest[0] + (c & 1);
    const std::int64_t y = lowest[1] + (c >> 1 & 1);
    const std::int64_t z = lowest[2] + (c >> 2 & 1);
    const bool is_in_grid = x >= 0 && y >= 0 && z >= 0 && x < dims[0] && y < dims[1] && z < dims[2];
    // No ambiguous face and no tunnel reaches round the grid: only the sign counts there.
    const double level =
        is_in_grid ? level_of(values_.at(static_cast<std::size_t>(x + dims[0] * (y + dims[1] * z))),
                              level_)
                   : -1.0;
    levels[static_cast<std::size_t>(c)] = deciding_level(level, level_.topology);
  }
  return decide_cube(levels, level_.topology != Topology::simple);
}

bool CurrentVolume::hangs_together_along_edges(std::uint32_t cube, bool inside) const {
  unsigned corners = 0;
  for (unsigned c = 0; c < 8; ++c)
    corners |= (is_inside(sides_.lattice.corner(cube, c)) == inside ? 1U : 0U) << c;
  return is_whole_along_edges[corners];
}

}  // namespace isoloop
