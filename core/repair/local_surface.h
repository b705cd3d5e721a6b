// What is M within a few cubes after a change, and how it meets the rest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/analysis/workings.h"
#include "core/repair/current_volume.h"
#include "core/z2/label.h"

namespace isoloop {

/// B: the cubes at some lattice vertices, none of them on the border of the box. Classes are those
/// of class_of() in the surface before all changes.
///
/// Walks on M outside B that differ by sums of `parts` do so by what bounds within B, and those
/// that do not, do not: by the exact sequence of M and what of it lies outside B.
struct LocalSurface {
  std::vector<std::uint32_t> cubes;  // B, ascending
  std::vector<GeneratorSet> curves;  // classes of the closed curves in which M meets B's border
  std::vector<GeneratorSet> parts;   // sums of these, of each connected part of M within B
  bool has_handle = false;           // a part is no sphere less discs
  /// Of the segments in which M meets B's border, which changes within B leave as they are.
  std::vector<std::uint32_t> part_of_segment;
};

/// As it was before all changes.
LocalSurface local_surface(const Workings& workings, std::span<const std::uint32_t> vertices);

/// As it is now. `volume` is changed at these vertices alone, among all that B's corners are.
LocalSurface local_surface(const Workings& workings, const CurrentVolume& volume,
                           std::span<const std::uint32_t> vertices);

}  // namespace isoloop
