#include "core/scan/scan.h"

#include <cmath>
#include <string>

#include "core/base/errors.h"
#include "core/base/run_both.h"
#include "core/scan/side_counts.h"
#include "core/scan/volume_sweep.h"

namespace isoloop {
namespace {

void check_iso_values(std::span<const double> values) {
  if (values.empty() || values.size() > max_scan_values)
    throw InvalidArgument({.text = "a scan takes 1 to " + std::to_string(max_scan_values) +
                                   " iso values, not " + std::to_string(values.size())},
                          Option::iso);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]) || (i > 0 && values[i] <= values[i - 1]))
      throw InvalidArgument({.text = "the iso values of a scan must be finite and ascend"},
                            Option::iso);
}

}  // namespace

SizedScan scan_sizes(const AnyGridView& grid, std::span<const double> iso_values,
                     std::span<const std::int64_t> sizes, const ScanOptions& options) {
  check_iso_values(iso_values);
  const VolumeSweep swept = sweep_volume(grid, iso_values, options);
  const RankedGrid& ranked = swept.ranked;
  const std::size_t steps = iso_values.size();
  if (options.progress) options.progress("components", 0.5);
  const ByStep vertices = vertices_by_step(ranked);
  SideCounts inside;
  SideCounts outside;
  run_both(
      [&] { inside = component_counts(ranked, vertices, swept.joins.inside, Side::inside, sizes); },
      [&] {
        outside = component_counts(ranked, vertices, swept.joins.outside, Side::outside, sizes);
      });
  SizedScan found{std::vector<ScanRow>(steps), std::vector(sizes.size(), std::vector<Betti>(steps)),
                  std::vector<std::int64_t>(steps)};
  std::int64_t discs = 0;
  std::int64_t cut_edges = 0;
  for (std::size_t s = 0; s < steps; ++s) {
    discs += swept.sums.discs[s];
    cut_edges += swept.sums.cut_edges[s];
    const std::size_t r = options.inside == InsideRule::above ? s : steps - 1 - s;
    ScanRow& row = found.rows[r];
    row.iso = ranked.isos[s];
    row.euler = discs - cut_edges;
    row.betti = {inside.all[s], 0, outside.all[s] - 1};
    row.betti.b1 = row.betti.b0 + row.betti.b2 - row.euler / 2;
    row.genus = row.betti.b1;
    row.inside_voxels = static_cast<std::int64_t>(ranked.rank.size() - vertices.first[s + 1]);
    found.largest[r] = inside.largest[s];
    for (std::size_t i = 0; i < sizes.size(); ++i)
      found.large[i][r] = {inside.large[i][s], 0, outside.large[i][s] - 1};
    if (row.euler % 2 != 0 || row.betti.b1 < 0)
      throw SelfCheckFailed("the components and the Euler characteristic contradict each other");
  }
  return found;
}

std::vector<ScanRow> scan_topology(const AnyGridView& grid, std::span<const double> iso_values,
                                   const ScanOptions& options) {
  return scan_sizes(grid, iso_values, {}, options).rows;
}

}  // namespace isoloop
