// The cut that a cube has with given levels at its corners, and its comparison with voxel counts.
#pragma once

#include <atomic>
#include <optional>
#include <random>

#include <tbb/parallel_for.h>

#include "core/cube/cube_interior.h"
#include "tests/oracles/refined_cube.h"
#include "tests/oracles/swept_cube.h"

namespace isoloop::testing {

struct LevelCut {
  unsigned inside = 0;
  unsigned joined = 0;
  const CubeCut* plain = nullptr;
  std::optional<int> hub;
  const CubeCut* cut = nullptr;  // with the tunnel, if there is one
};

inline LevelCut cut_of(const CornerLevels& levels) {
  LevelCut cut;
  for (unsigned c = 0; c < 8; ++c) cut.inside |= (levels[c] >= 0 ? 1U : 0U) << c;
  for (int face = 0; face < 6; ++face) {
    std::array<double, 4> ring{};
    unsigned bits = 0;
    for (unsigned i = 0; i < 4; ++i) {
      ring[i] = levels[face_ring(face)[i]];
      bits |= (ring[i] >= 0 ? 1U : 0U) << i;
    }
    if (is_ambiguous(bits) && inside_is_joined(ring)) cut.joined |= 1U << face;
  }
  const auto inside = static_cast<std::uint8_t>(cut.inside);
  const auto joined = static_cast<std::uint8_t>(cut.joined);
  cut.plain = &cube_cut(inside, joined, false);
  cut.hub = tunnel_hub(*cut.plain, levels);
  cut.cut = cut.hub ? &tunnel_cut(inside, joined, false, *cut.hub).cut : cut.plain;
  return cut;
}

/// Parts and Euler characteristics as the cut has them: its cells are balls, but for a solid torus.
inline oracle::CubeParts parts_of(const LevelCut& cut) {
  oracle::CubeParts parts;
  for (std::size_t side = 0; side < 2; ++side) {
    const int cells = cut.cut->cell_count[side];
    const bool torus = cut.hub && (cut.inside >> *cut.hub & 1U) != side;
    parts[side] = {cells, cells - (torus ? 1 : 0)};
  }
  return parts;
}

/// How many of some cubes have cuts with other parts, cycles or patches than the interpolant's.
struct CubeComparison {
  int cubes = 0;
  int tunnels = 0;     // cubes that have one
  int unresolved = 0;  // too fine for voxels at any number of steps: compared with the sweep
  int misled = 0;      // where voxels agree at 8 and 16 steps, but otherwise at more steps
  int wrong = 0;
};

/// Random cubes, against voxels at 8 and 16 steps; where those are not clear or say something else
/// than the cut, at 16 and 32, then at 31 and 62.
inline CubeComparison compare_with_refined_cubes(int count, unsigned seed) {
  std::atomic<int> tunnels = 0;
  std::atomic<int> unresolved = 0;
  std::atomic<int> misled = 0;
  std::atomic<int> wrong = 0;
  tbb::parallel_for(0, count, [&](int i) {
    std::seed_seq seeds{seed, static_cast<unsigned>(i)};
    std::mt19937 random(seeds);
    CornerLevels levels{};
    for (double& level : levels) level = 2.0 * random() / 4294967295.0 - 1.0;
    const LevelCut cut = cut_of(levels);
    const oracle::CubeParts parts = parts_of(cut);
    if (cut.hub) ++tunnels;
    // What is thinner than the samples are dense may be missed twice: a difference must stay.
    std::optional<oracle::CubeParts> refined;
    int settled = 0;
    for (const int steps : {8, 16, 31})
      if (!refined || *refined != parts)
        if (const auto finer = oracle::converged_parts(levels, steps)) {
          refined = finer;
          ++settled;
        }
    if (settled > 1) ++misled;
    if (!refined) {
      ++unresolved;
      const oracle::SweptCube swept = oracle::sweep(levels);
      refined.emplace();
      for (std::size_t side = 0; side < 2; ++side)
        (*refined)[side] = {swept.parts[side], swept.parts[side] - swept.cycles[side]};
    }
    // M's patches share out the cube, of Euler characteristic 1, between the sides.
    const int patches = (*refined)[0].chi + (*refined)[1].chi - 1;
    if (*refined != parts || patches != cut.cut->disc_count) ++wrong;
  });
  return {count, tunnels, unresolved, misled, wrong};
}

}  // namespace isoloop::testing
