// Iso values between which the counts of a scan stay as they are, and the one to propose.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "isoloop/scan.h"

namespace isoloop {

/// All plateaus, in the order of the rows. `voxel_count`: of the grid.
std::vector<Plateau> find_plateaus(std::span<const ScanRow> rows, std::int64_t voxel_count);

/// The row closest to the middle of the widest meaningful plateau, of several the first.
std::optional<std::size_t> proposed_row(std::span<const ScanRow> rows,
                                        std::span<const Plateau> plateaus);

}  // namespace isoloop
