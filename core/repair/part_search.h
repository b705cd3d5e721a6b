// Whether vertices of one side hang together, told by going from all of them at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/repair/current_volume.h"

namespace isoloop {

/// Vertices of one side that hang together; beyond_box may be one of them.
using VertexGroup = std::vector<std::uint32_t>;

/// Searches one volume as it changes. A search ends when all groups have met, or all but one have
/// come to their ends: its cost follows the way round from one to the next.
class PartSearch {
 public:
  /// Keeps the reference. Takes four bytes a lattice vertex.
  explicit PartSearch(const CurrentVolume& volume)
      : volume_(volume), met_by_(volume.lattice().vertex_count()) {}

  /// How many components of a side the groups lie in. All must be on that side.
  std::int64_t parts_among(std::span<const VertexGroup> groups);

 private:
  const CurrentVolume& volume_;
  std::vector<std::uint32_t> met_by_;  // by lattice vertex: first_ and the group that met it
  std::uint32_t first_ = 1;            // numbers below are of earlier searches
};

}  // namespace isoloop
