// The parts of a cube under the trilinear interpolant, followed from slice to slice across x:
// shares nothing with core/, which looks for roots along all axes at once.
#pragma once

#include <array>

namespace isoloop::oracle {

struct SweptCube {
  std::array<int, 8> part_of_corner{};  // equal for corners of one part of their side
  std::array<int, 2> parts{};           // of the outside (values < 0), of the inside
  std::array<int, 2> cycles{};          // b1 of each side
};

/// `values`: at corner dx + 2 dy + 4 dz, of magnitude about 1. Ties as if all values but those that
/// are 0 were lowered by next to nothing, which is `lowered_by`: a saddle at 0 is outside.
SweptCube sweep(const std::array<double, 8>& values, double lowered_by = 1e-9);

}  // namespace isoloop::oracle
