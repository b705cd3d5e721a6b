// Reductions over Z2 of a complex that is written out, slowly and to the letter.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/oracles/explicit_complex.h"

namespace isoloop::oracle {

Chain sum(const Chain& a, const Chain& b);

/// Betti numbers of I closed up to M, by the ranks of its boundary matrices.
std::array<std::int64_t, 3> betti_inside(const ExplicitComplex& complex);

/// Betti numbers of M, in the same way. M may end at the border of the box.
std::array<std::int64_t, 3> betti_of_m(const ExplicitComplex& complex);

/// Euler characteristic of M.
std::int64_t euler_of_m(const ExplicitComplex& complex);

/// PAIR, slowly: M first, then the faces in `order` (all pieces on one side). Returns those whose
/// reduced boundary is a cycle on M that is not a boundary yet.
std::vector<int> killing_faces(const ExplicitComplex& complex, const std::vector<int>& order);

}  // namespace isoloop::oracle
