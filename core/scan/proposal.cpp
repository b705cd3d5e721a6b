#include "core/scan/proposal.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "core/base/errors.h"
#include "core/scan/blocks.h"
#include "core/scan/parting.h"
#include "core/scan/plateau.h"
#include "core/scan/scan.h"

namespace isoloop {
namespace {

/// Half the side of a cube of so many voxels, and no more than the grid's longest.
std::int64_t block_side(std::int64_t voxels, const AnyGridView& grid) {
  const Index3 dims = std::visit([](const auto& view) { return view.dims; }, grid);
  const auto longest = static_cast<std::uint64_t>(*std::max_element(dims.begin(), dims.end()));
  std::uint64_t side = 1;
  while (side < longest &&
         8 * (side + 1) * (side + 1) * (side + 1) <= static_cast<std::uint64_t>(voxels))
    ++side;
  return static_cast<std::int64_t>(side);
}

void check_ignored(const ScanOptions& options) {
  if (options.ignore_below && options.ignore_share)
    throw InvalidArgument("what to ignore is either voxels or a share");
  if (options.ignore_below && *options.ignore_below < 0)
    throw InvalidArgument("the size below which to ignore must not be negative");
  if (options.ignore_share && !(*options.ignore_share > 0.0 && *options.ignore_share < 1.0))
    throw InvalidArgument("the share below which to ignore must lie between 0 and 1");
}

std::vector<std::int64_t> sizes_to_count(const ScanOptions& options, std::int64_t voxel_count) {
  if (options.ignore_share) return {};
  if (!options.ignore_below) return default_ignored_sizes(voxel_count);
  if (*options.ignore_below <= 1) return {};
  return {*options.ignore_below};
}

/// Tunnels of the grid at half the resolution and less, row by row.
std::vector<std::int64_t> wide_tunnels(const AnyGridView& grid, std::int64_t side,
                                       std::span<const double> iso_values, ScanOptions options) {
  const Blocks blocks = means_of_blocks(grid, side);
  options.progress = {};
  std::vector<std::int64_t> tunnels;
  for (const ScanRow& row :
       scan_topology(GridView<float>{blocks.values, blocks.dims}, iso_values, options))
    tunnels.push_back(row.betti.b1);
  return tunnels;
}

/// Finds the plateaus of what is large. Whether one of them is proposed.
bool judge(Scan& scan, std::int64_t voxel_count, std::span<const double> parting,
           std::int64_t ignored) {
  scan.ignored_below = ignored;
  scan.plateaus = find_plateaus(scan.rows, voxel_count, parting, ignored > 0);
  const std::vector<std::size_t> best = stablest_plateaus(scan.plateaus);
  if (best.empty()) return false;
  scan.proposed = middle_row(scan.rows, scan.plateaus[best.front()]);
  scan.by = ProposedBy::plateau;
  return true;
}

void set_large(std::vector<ScanRow>& rows, const std::vector<Betti>& large,
               const std::vector<std::int64_t>& tunnels) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].large = {large[i].b0, tunnels.empty() ? rows[i].betti.b1 : tunnels[i], large[i].b2};
}

void set_all(std::vector<ScanRow>& rows) {
  for (ScanRow& row : rows) row.large = row.betti;
}

}  // namespace

std::vector<std::int64_t> default_ignored_sizes(std::int64_t voxel_count) {
  constexpr std::int64_t least_share = 1000;
  std::vector<std::int64_t> sizes;
  for (const std::int64_t size : {64, 512, 4096})
    if (size * least_share <= voxel_count) sizes.push_back(size);
  return sizes;
}

Scan scan_and_propose(const AnyGridView& grid, std::span<const double> iso_values,
                      const ScanOptions& options) {
  check_ignored(options);
  const std::int64_t voxel_count =
      std::visit([](const auto& view) { return std::ssize(view.values); }, grid);
  std::vector<std::int64_t> sizes = sizes_to_count(options, voxel_count);
  SizedScan counts = scan_sizes(grid, iso_values, sizes, options);
  Scan scan;
  scan.rows = std::move(counts.rows);
  set_all(scan.rows);
  const std::vector<double> parted = parting(scan.rows, voxel_count);
  scan.otsu = otsu_row(parted);
  scan.valley = valley_row(scan.rows, voxel_count, parted, least_parting);
  if (options.ignore_share && scan.otsu) {
    const auto largest = static_cast<double>(counts.largest[*scan.otsu]);
    sizes = {std::max<std::int64_t>(1, std::llround(*options.ignore_share * largest))};
    counts = scan_sizes(grid, iso_values, sizes, options);
  }
  const bool is_chosen = !options.ignore_below && !options.ignore_share;
  if ((is_chosen || sizes.empty()) && judge(scan, voxel_count, parted, 0)) return scan;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::int64_t side = block_side(sizes[i], grid);
    set_large(
        scan.rows, counts.large[i],
        side == 1 ? std::vector<std::int64_t>{} : wide_tunnels(grid, side, iso_values, options));
    if (judge(scan, voxel_count, parted, sizes[i])) return scan;
  }
  if (is_chosen) {  // what was tried in vain is not shown
    set_all(scan.rows);
    judge(scan, voxel_count, parted, 0);
  }
  scan.proposed = scan.otsu;
  scan.by = scan.otsu ? ProposedBy::otsu : ProposedBy::nothing;
  return scan;
}

}  // namespace isoloop
