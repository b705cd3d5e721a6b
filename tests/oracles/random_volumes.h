// Small volumes with rich topology, the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/grid/grid.h"

namespace isoloop::testing {

struct SmallVolume {
  std::vector<double> values;  // inside is value >= 0
  Index3 dims{};

  GridView<double> view() const { return {values, dims, {1.0, 1.0, 1.0}}; }
};

/// value(x, y, z) at each voxel.
SmallVolume sampled(const Index3& dims, const std::function<double(double, double, double)>& value);

/// Uniform in [-1, 1], independent.
SmallVolume white_noise(const Index3& dims, std::uint32_t seed);

/// White noise averaged over 3 x 3 x 3 voxels, `rounds` times, about its median.
SmallVolume smooth_noise(const Index3& dims, std::uint32_t seed, int rounds);

/// Smooth noise of 16 to 24 voxels a side and 1 to 3 rounds, as the seed has it.
SmallVolume noise_of_some_size(std::uint32_t seed);

/// Solid torus in the middle, axis along z; radii in shares of the least extent.
SmallVolume torus(const Index3& dims, double ring = 0.28, double tube = 0.12);

/// A torus hollowed out by a thinner torus round the same circle.
SmallVolume torus_shell(const Index3& dims);

/// Two rings through each other.
SmallVolume linked_tori(const Index3& dims);

/// +1 inside, -1 outside: bit n of `bits` is voxel n.
SmallVolume from_bits(const Index3& dims, std::uint32_t bits);

/// One of the 48 symmetries of the cube: axis a of the result is axis permutation[a] of `volume`,
/// turned round where flip[a].
SmallVolume transformed(const SmallVolume& volume, const std::array<int, 3>& permutation,
                        const std::array<bool, 3>& flip);

}  // namespace isoloop::testing
