// Label maps: voxels that name what they belong to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "volume/voxels/volume.h"

namespace isoloop {

/// A voxel has the whole number nearest to its value as its label, no farther off than this, in
/// voxel values: as far as scaling integers of 8 bits by a slope moves labels in practice.
inline constexpr double label_tolerance = 0.01;

/// Of so many voxels one may be farther off without being a reason to refuse them all.
inline constexpr std::int64_t voxels_for_each_stray = 1000;

/// The volume as a mask: uint8 voxels, 1 where the label is one of `labels`, else 0. A note says
/// how many of these voxels are no whole numbers and by how much at most; warnings name labels that
/// no voxel has, and count the voxels that have none. Throws InvalidArgument if no voxel has any of
/// the labels, listing labels that there are, and if more than one voxel in a thousand has none,
/// with examples of their values: that is no label map.
Volume mask_of_labels(Volume volume, const std::vector<std::int64_t>& labels,
                      const std::string& what);

/// A voxel of a label map, by its place in the order of the voxels, and the side that a repair of
/// the mask has put it on.
struct SidedVoxel {
  std::size_t voxel = 0;
  bool is_inside = false;
};

/// The labels that these voxels get: that which most of the 26 voxels round it on its side have, of
/// several the least; voxels that have got theirs count for those farther from the rim. Where no
/// voxel on that side is in reach, the least label of `asked` that occurs, or outside the least
/// from 0 on that is not asked for.
std::vector<std::int64_t> labels_of_sided(const AnyGridView& labels,
                                          std::span<const SidedVoxel> voxels,
                                          const std::vector<std::int64_t>& asked);

}  // namespace isoloop
