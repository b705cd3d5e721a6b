// Betti numbers of the solid of a volume, cube by cube: shares nothing with core/.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/oracles/voxel_oracle.h"

namespace isoloop::oracle {

/// `levels`: not negative inside, of magnitude about 1, (i, j, k) at i + dims[0] * (j + dims[1] k);
/// one more layer of outside lies round them. Ties as sweep() has them. Cubes are followed from
/// slice to slice, tunnels within them included, or (`cubes_are_simple`) have as parts those of
/// their faces, all of them balls.
Betti count_by_sweep(const std::vector<double>& levels, const std::array<std::int64_t, 3>& dims,
                     bool cubes_are_simple, double lowered_by);

}  // namespace isoloop::oracle
