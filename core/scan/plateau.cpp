#include "core/scan/plateau.h"

#include <algorithm>
#include <cmath>

namespace isoloop {
namespace {

bool same_numbers(const Betti& a, const Betti& b) {
  return a.b0 == b.b0 && a.b1 == b.b1 && a.b2 == b.b2;
}

/// The row's numbers, or those of its two neighbours where they agree.
const Betti& mended(std::span<const ScanRow> rows, std::size_t i) {
  const bool agree =
      i > 0 && i + 1 < rows.size() && same_numbers(rows[i - 1].large, rows[i + 1].large);
  return rows[agree ? i - 1 : i].large;
}

/// Whether solid and outside hold a thousandth of all voxels each.
bool has_two_sides(const ScanRow& row, std::int64_t voxel_count) {
  constexpr std::int64_t share = 1000;
  return share * row.inside_voxels >= voxel_count &&
         share * (voxel_count - row.inside_voxels) >= voxel_count;
}

bool is_meaningful(std::span<const ScanRow> rows, const Plateau& plateau, std::int64_t voxel_count,
                   std::span<const double> parting) {
  constexpr double least_reach = 1.0 / 7;
  const auto [least, most] =
      std::minmax(rows[plateau.first].inside_voxels, rows[plateau.last].inside_voxels);
  if (plateau.last == plateau.first || !has_two_sides(rows[plateau.first], voxel_count))
    return false;
  const double range = rows.back().iso - rows.front().iso;
  const auto smaller_side = static_cast<double>(std::min(most, voxel_count - least));
  const bool reaches = static_cast<double>(plateau.voxels) >= least_reach * smaller_side ||
                       plateau.width >= least_reach * range;
  return reaches && parting[middle_row(rows, plateau)] >= least_parting;
}

}  // namespace

std::vector<Plateau> find_plateaus(std::span<const ScanRow> rows, std::int64_t voxel_count,
                                   std::span<const double> parting, bool mend) {
  std::vector<Plateau> plateaus;
  const auto numbers = [&](std::size_t i) -> const Betti& {
    return mend ? mended(rows, i) : rows[i].large;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || !same_numbers(numbers(i - 1), numbers(i)) ||
        has_two_sides(rows[i - 1], voxel_count) != has_two_sides(rows[i], voxel_count))
      plateaus.push_back({.first = i});
    plateaus.back().last = i;
  }
  for (Plateau& plateau : plateaus) {
    plateau.width = rows[plateau.last].iso - rows[plateau.first].iso;
    plateau.voxels = std::abs(rows[plateau.last].inside_voxels - rows[plateau.first].inside_voxels);
    plateau.meaningful = is_meaningful(rows, plateau, voxel_count, parting);
  }
  return plateaus;
}

std::size_t middle_row(std::span<const ScanRow> rows, const Plateau& plateau) {
  const double middle = rows[plateau.first].iso + plateau.width / 2;
  std::size_t best = plateau.first;
  for (std::size_t i = plateau.first; i <= plateau.last; ++i)
    if (std::abs(rows[i].iso - middle) < std::abs(rows[best].iso - middle)) best = i;
  return best;
}

std::vector<std::size_t> stablest_plateaus(std::span<const Plateau> plateaus) {
  std::vector<std::size_t> stablest;
  for (std::size_t i = 0; i < plateaus.size(); ++i)
    if (plateaus[i].meaningful) stablest.push_back(i);
  std::stable_sort(stablest.begin(), stablest.end(), [&](std::size_t a, std::size_t b) {
    return plateaus[a].voxels > plateaus[b].voxels;
  });
  return stablest;
}

}  // namespace isoloop
