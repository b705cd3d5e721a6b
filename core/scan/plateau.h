// Iso values between which the counts of a scan stay as they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "isoloop/scan.h"

namespace isoloop {

/// Least share of Otsu's variance that a meaningful plateau has in its middle.
inline constexpr double least_parting = 2.0 / 3.0;

/// All plateaus by the rows' `large` numbers, in the order of the rows. `voxel_count`: of the grid.
/// `parting`: of core/scan/parting.h. `mend`: a row whose two neighbours agree counts as they do.
std::vector<Plateau> find_plateaus(std::span<const ScanRow> rows, std::int64_t voxel_count,
                                   std::span<const double> parting, bool mend = false);

/// The row closest to the middle of the plateau.
std::size_t middle_row(std::span<const ScanRow> rows, const Plateau& plateau);

/// Numbers of the meaningful plateaus, that of the most voxels first, then by their order.
std::vector<std::size_t> stablest_plateaus(std::span<const Plateau> plateaus);

}  // namespace isoloop
