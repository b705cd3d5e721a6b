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
  /// Voxels: components and cavities of fewer, and tunnels narrower than about half the side of a
  /// cube of so many, do not break a plateau. Unset: 0, and where nothing is stable then, 64, 512
  /// and 4096, as long as that is at most a thousandth of the grid.
  std::optional<std::int64_t> ignore_below{};
  /// The same as a share of the largest component at Otsu's value, above 0 and below 1. Not with
  /// ignore_below.
  std::optional<double> ignore_share{};
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
  /// What is left of `betti` when what is below Scan::ignored_below is set aside: components and
  /// cavities of so many voxels and more, and the tunnels of the grid of means over blocks of
  /// voxels, which may be more than those of the grid itself. A block's side is half that of a cube
  /// of so many voxels; where that is less than two, all tunnels are left.
  Betti large{};
};

/// Most iso values in one scan.
inline constexpr std::size_t max_scan_values = 65'000;

/// Rows first ... last of a scan that all have the same `large` numbers; as many as can be,
/// but those where the solid, or the outside, holds less than a thousandth of all voxels stand
/// apart. Where something is set aside, a row whose two neighbours agree counts as they do.
struct Plateau {
  std::size_t first = 0;
  std::size_t last = 0;
  double width = 0.0;       // from the first row's iso value to the last one's
  std::int64_t voxels = 0;  // that change sides from the first row to the last
  /// A solid that a person might mean: the plateau reaches over a seventh of the solid's voxels, or
  /// the outside's, or of the iso values; solid and outside hold a thousandth of all voxels each;
  /// and in its middle the iso value parts the voxels at least two thirds as well as Otsu's does.
  bool meaningful = false;
};

/// Where a proposed iso value comes from: from the middle of the meaningful plateau of most voxels,
/// of several the first; where there is none, from Otsu's rule; from nothing where all voxels have
/// one value.
enum class ProposedBy { nothing, plateau, otsu };

/// What a scan found.
struct Scan {
  std::vector<ScanRow> rows;       // one for each iso value, in their order
  std::vector<Plateau> plateaus;   // in the order of the rows
  std::int64_t ignored_below = 0;  // voxels: what was set aside, see ScanOptions::ignore_below
  /// The row that parts the voxels best by their values alone (Otsu, A threshold selection method
  /// from gray-level histograms, IEEE Trans. SMC 1979).
  std::optional<std::size_t> otsu;
  std::optional<std::size_t> valley;    // the row in the deepest valley of the histogram
  std::optional<std::size_t> proposed;  // the row to look at first
  ProposedBy by = ProposedBy::nothing;
};

/// Counts at each of `iso_values` (strictly ascending, finite, no more than max_scan_values), all
/// at once. Takes about 24 bytes a voxel, and 4 for each face whose corners' values can alternate.
/// Deterministic: the same for any number of threads. Throws InvalidArgument (iso values,
/// dimensions, sizes to ignore), InvalidInput (NaN in the grid), LimitExceeded over
/// options.max_bytes, and SelfCheckFailed where the counts contradict each other.
Scan scan(const AnyGridView& grid, std::span<const double> iso_values,
          const ScanOptions& options = {});

}  // namespace isoloop
