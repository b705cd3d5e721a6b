// Which killing piece each loop of a basis stands for.
#pragma once

#include <cstdint>
#include <vector>

#include "core/tighten/basis_exchange.h"
#include "core/z2/z2_basis.h"

namespace isoloop {

/// For each member the number of a loop, each number once, that is among the member's coordinates
/// in `border_classes`: the member closes that handle (or tunnel). There is always such a matching,
/// for the matrix of coordinates is not singular, so some product of its determinant is not zero.
/// Members that are a loop keep its number where that is a coordinate and no other needs it; the
/// others, in their order, take their last free coordinate, or make some member take another.
std::vector<std::uint32_t> match_loops(const std::vector<BasisMember>& members,
                                       const Z2Basis& border_classes);

}  // namespace isoloop
