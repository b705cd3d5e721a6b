// The counts of the solid at many iso values at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "isoloop/grid.h"
#include "isoloop/run.h"
#include "isoloop/surface.h"

namespace isoloop {

/// How to count, and with how much.
struct ScanOptions {
  InsideRule inside = InsideRule::above;
  Topology topology = Topology::trilinear;
  int threads = 0;                            // at most; 0: one for each core
  Progress progress{};                        // may be empty
  std::uint64_t max_bytes = unlimited_bytes;  // to hold beside the grid's voxels
};

/// What count() finds at one iso value, M closed.
struct ScanRow {
  double iso = 0.0;  // unit of the voxel values
  Betti betti;
  std::int64_t euler = 0;  // of M
  std::int64_t genus = 0;  // of M, all components together: b1
  std::int64_t inside_voxels = 0;
};

/// Most iso values in one scan.
inline constexpr std::size_t max_scan_values = 65'000;

/// Rows first ... last of a scan, all with the same Betti numbers; as many as can be.
struct Plateau {
  std::size_t first = 0;
  std::size_t last = 0;
  double width = 0.0;  // from the first row's iso value to the last one's
  /// Wider than one value, and at each of them a solid that is neither next to nothing nor next to
  /// everything: it holds at least a thousandth of all voxels, and so does the outside.
  bool meaningful = false;
};

/// What a scan found.
struct Scan {
  std::vector<ScanRow> rows;      // one for each iso value, in their order
  std::vector<Plateau> plateaus;  // in the order of the rows
  /// The row closest to the middle of the widest meaningful plateau, of several the first.
  std::optional<std::size_t> proposed;
};

/// Counts at each of `iso_values` (strictly ascending, finite, no more than max_scan_values) in two
/// passes over the voxels. Takes about 16 bytes a voxel, and 4 for each face whose corners' values
/// can alternate. Deterministic: the same for any number of threads. Throws InvalidArgument (iso
/// values, dimensions), InvalidInput (NaN in the grid), LimitExceeded over options.max_bytes, and
/// SelfCheckFailed where the counts contradict each other.
Scan scan(const AnyGridView& grid, std::span<const double> iso_values,
          const ScanOptions& options = {});

}  // namespace isoloop
