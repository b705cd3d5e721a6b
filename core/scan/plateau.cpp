#include "core/scan/plateau.h"

#include <cmath>

namespace isoloop {
namespace {

bool same_numbers(const ScanRow& a, const ScanRow& b) {
  return a.betti.b0 == b.betti.b0 && a.betti.b1 == b.betti.b1 && a.betti.b2 == b.betti.b2;
}

}  // namespace

std::vector<Plateau> find_plateaus(std::span<const ScanRow> rows, std::int64_t voxel_count) {
  std::vector<Plateau> plateaus;
  const auto is_solid = [&](const ScanRow& row) {
    return 1000 * row.inside_voxels >= voxel_count &&
           1000 * (voxel_count - row.inside_voxels) >= voxel_count;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || !same_numbers(rows[i - 1], rows[i])) plateaus.push_back({i, i, 0.0, true});
    Plateau& plateau = plateaus.back();
    plateau.last = i;
    plateau.meaningful = plateau.meaningful && is_solid(rows[i]);
  }
  for (Plateau& plateau : plateaus) {
    plateau.width = rows[plateau.last].iso - rows[plateau.first].iso;
    plateau.meaningful = plateau.meaningful && plateau.last > plateau.first;
  }
  return plateaus;
}

std::optional<std::size_t> proposed_row(std::span<const ScanRow> rows,
                                        std::span<const Plateau> plateaus) {
  const Plateau* widest = nullptr;
  for (const Plateau& plateau : plateaus)
    if (plateau.meaningful && (widest == nullptr || plateau.width > widest->width))
      widest = &plateau;
  if (widest == nullptr) return std::nullopt;
  const double middle = rows[widest->first].iso + widest->width / 2;
  std::size_t best = widest->first;
  for (std::size_t i = widest->first; i <= widest->last; ++i)
    if (std::abs(rows[i].iso - middle) < std::abs(rows[best].iso - middle)) best = i;
  return best;
}

}  // namespace isoloop
