// Iso values between which the counts of a scan stay as they are, and the one to propose.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/scan/scan.h"

namespace isoloop {

/// Rows first ... last of a scan, all with the same Betti numbers; as many as can be.
struct Plateau {
  std::size_t first = 0;
  std::size_t last = 0;
  double width = 0.0;  // from the first row's iso value to the last one's
  /// Wider than one value, and at each of them a solid that is neither next to nothing nor next to
  /// everything: it holds at least a thousandth of all voxels, and so does the outside.
  bool meaningful = false;
};

/// All plateaus, in the order of the rows. `voxel_count`: of the grid.
std::vector<Plateau> find_plateaus(std::span<const ScanRow> rows, std::int64_t voxel_count);

/// The row closest to the middle of the widest meaningful plateau, of several the first.
std::optional<std::size_t> proposed_row(std::span<const ScanRow> rows,
                                        std::span<const Plateau> plateaus);

}  // namespace isoloop
