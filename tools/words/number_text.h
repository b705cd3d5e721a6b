// Numbers as text, the same under every locale.
#pragma once

#include <cstdint>
#include <string>

#include "core/grid/grid.h"

namespace isoloop {

/// The shortest decimal that reads back as `value`; "inf", "-inf" or "nan" where it has none.
std::string shortest_text(double value);

/// `decimals` digits after the point; never "-0.00". "inf", "-inf" or "nan" as above.
std::string fixed_text(double value, int decimals);

/// Digits after the point that show a hundredth of the smallest voxel edge.
int length_decimals(const Vec3& spacing);

/// "309342 vertices", "1 vertex".
std::string counted(std::int64_t count, const std::string& one, const std::string& many);

}  // namespace isoloop
