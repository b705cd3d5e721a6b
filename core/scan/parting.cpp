#include "core/scan/parting.h"

#include <algorithm>
#include <cmath>

namespace isoloop {
namespace {

/// Voxels at or above each row's iso value, and below the next one's.
std::vector<double> histogram(std::span<const ScanRow> rows, std::int64_t voxel_count) {
  const bool above = rows.front().inside_voxels >= rows.back().inside_voxels;
  const auto reached = [&](std::size_t i) {
    return above ? rows[i].inside_voxels : voxel_count - rows[i].inside_voxels;
  };
  std::vector<double> voxels(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    voxels[i] = static_cast<double>(reached(i) - (i + 1 < rows.size() ? reached(i + 1) : 0));
  return voxels;
}

/// Of the logarithms, so that small hills beside large ones show.
std::vector<double> smooth_logarithms(const std::vector<double>& voxels) {
  const double reach = std::max(1.0, static_cast<double>(voxels.size()) / 64);
  const auto far = static_cast<std::ptrdiff_t>(3 * reach);
  const auto count = std::ssize(voxels);
  std::vector<double> smooth(voxels.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    double sum = 0.0;
    double weights = 0.0;
    for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, i - far); j <= std::min(count - 1, i + far);
         ++j) {
      const double away = static_cast<double>(j - i) / reach;
      const double weight = std::exp(-away * away / 2);
      sum += weight * std::log1p(std::max(0.0, voxels[static_cast<std::size_t>(j)]));
      weights += weight;
    }
    smooth[static_cast<std::size_t>(i)] = sum / weights;
  }
  return smooth;
}

}  // namespace

std::vector<double> parting(std::span<const ScanRow> rows, std::int64_t voxel_count) {
  std::vector<double> shares(rows.size(), 0.0);
  if (rows.size() < 2) return shares;
  const std::vector<double> voxels = histogram(rows, voxel_count);
  // What lies below the first row has its value, what lies above the last one the last one's.
  std::vector<double> value(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    value[i] = i + 1 < rows.size() ? (rows[i].iso + rows[i + 1].iso) / 2 : rows[i].iso;
  const auto all = static_cast<double>(voxel_count);
  double below = all;
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    below -= voxels[i];
    sum += voxels[i] * value[i];
  }
  sum += below * rows.front().iso;
  double low_sum = below * rows.front().iso;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double above = all - below;
    if (below > 0 && above > 0) {
      const double apart = low_sum / below - (sum - low_sum) / above;
      shares[i] = below * above * apart * apart;
    }
    below += voxels[i];
    low_sum += voxels[i] * value[i];
  }
  const double most = *std::max_element(shares.begin(), shares.end());
  for (double& share : shares) share = most > 0 ? share / most : 0.0;
  return shares;
}

std::optional<std::size_t> otsu_row(std::span<const double> parting) {
  const auto best = std::max_element(parting.begin(), parting.end());
  if (best == parting.end() || *best <= 0) return std::nullopt;
  const auto last = std::find_if(best, parting.end(), [&](double share) { return share < *best; });
  return static_cast<std::size_t>(best - parting.begin() + (last - best - 1) / 2);
}

std::optional<std::size_t> valley_row(std::span<const ScanRow> rows, std::int64_t voxel_count,
                                      std::span<const double> parting, double least_parting) {
  if (rows.size() < 3) return std::nullopt;
  const std::vector<double> height = smooth_logarithms(histogram(rows, voxel_count));
  std::vector<double> right(height);  // the highest from here on
  for (std::size_t i = right.size() - 1; i-- > 0;) right[i] = std::max(right[i], right[i + 1]);
  std::optional<std::size_t> valley;
  double deepest = 0.0;
  double left = height.front();
  for (std::size_t i = 1; i + 1 < height.size(); ++i) {
    left = std::max(left, height[i]);
    const double depth = std::min(left, right[i]) - height[i];
    if (parting[i] < least_parting || depth <= deepest) continue;
    deepest = depth;
    valley = i;
  }
  return valley;
}

}  // namespace isoloop
