// The Euler characteristic of a solid under the trilinear interpolant, summed over refined cubes.
#pragma once

#include <cstdint>

#include "tests/oracles/random_volumes.h"

namespace isoloop::testing {

/// Gaussian white noise smoothed by a Gaussian of `sigma` voxels, periodic, about its mean.
SmallVolume gaussian_field(const Index3& dims, double sigma, std::uint32_t seed);

struct RefinedEuler {
  std::int64_t euler = 0;       // of the inside, values >= 0; the grid lies in outside voxels
  std::int64_t cubes = 0;       // that M cuts
  std::int64_t unresolved = 0;  // of them: too fine for voxels, so counted by slices
};

/// Cubes - faces + edges - vertices, each by its Euler characteristic: cubes and ambiguous faces by
/// voxels at 8 and 16 (else 16 and 32, else 31 and 62) steps, where both adjacencies agree at both.
RefinedEuler refined_euler(const SmallVolume& volume);

}  // namespace isoloop::testing
