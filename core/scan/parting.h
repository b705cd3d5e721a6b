// How well an iso value parts the voxels of a scan into two classes, by their values alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "isoloop/scan.h"

namespace isoloop {

/// For each row the variance between the voxels on its two sides, as a share of the largest such
/// variance of all rows: 1 at Otsu's value, 0 where a side is empty. Values count as the middle
/// between two rows' iso values. `voxel_count`: of the grid.
std::vector<double> parting(std::span<const ScanRow> rows, std::int64_t voxel_count);

/// The row whose parting is 1, of several in a row the middle; none where no row has voxels on both
/// its sides.
std::optional<std::size_t> otsu_row(std::span<const double> parting);

/// The row at the bottom of the valley of the histogram that is deepest, by the ratio of the lower
/// of the hills on its sides to it, of those where the parting is at least `least_parting`. The
/// histogram is smoothed over a 64th of the rows to either side. None where there is no valley.
std::optional<std::size_t> valley_row(std::span<const ScanRow> rows, std::int64_t voxel_count,
                                      std::span<const double> parting, double least_parting);

}  // namespace isoloop
