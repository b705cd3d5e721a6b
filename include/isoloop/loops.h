// Every handle loop and tunnel loop of a solid, proved.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "isoloop/count.h"
#include "isoloop/grid.h"
#include "isoloop/loop.h"
#include "isoloop/run.h"
#include "isoloop/surface.h"

namespace isoloop {

/// What to find, and how much that may take.
struct LoopOptions {
  Boundary boundary = Boundary::closed;
  GeodesicMode geodesic = GeodesicMode::hierarchy;
  ComplexKind complex = ComplexKind::automatic;
  /// Of an octree: a block of cubes is one cell if the surface crosses no block of its width within
  /// so many widths of it; 0 to 2.
  int grading = 1;
  Tighten tighten = Tighten::basis;  // not read with an open boundary
  /// Set: also says how far each handle and tunnel extends, until the front that leaves its loop is
  /// longer than this times the loop; 1.5 ends half a radius beyond the mouth of a bore. The
  /// boundary must be closed.
  std::optional<double> feature_ratio{};
  int threads = 0;                            // at most; 0: one for each core
  Progress progress{};                        // may be empty
  std::uint64_t max_bytes = unlimited_bytes;  // to hold beside the grid's voxels
};

/// All loops, and what they run on.
struct FoundLoops {
  Counts counts;
  SurfaceMesh surface;            // that the loops run on; drawn_curves() asks for it
  std::vector<Loop> loops;        // by kind, handles first, then by size; every one certified
  std::vector<Feature> features;  // of each loop, in their order; empty unless asked for
  ComplexKind complex = ComplexKind::automatic;  // grid or octree; automatic: there are no loops
  /// No basis of the handle loops, or of the tunnel loops, has a smaller total length along edges
  /// of M; 0 where nothing is known. Unit of the spacing.
  double least_handle_length = 0.0;
  double least_tunnel_length = 0.0;
};

/// Finds and proves them all: as many of each kind as the genus of M, independent of each other.
/// Deterministic: the same bytes for any number of threads. Throws what count() throws,
/// InvalidArgument for features with an open boundary and for a grading out of range, and
/// SelfCheckFailed if any proof fails: no unproved loop is ever returned.
FoundLoops find_loops(const AnyGridView& grid, const IsoLevel& level,
                      const LoopOptions& options = {});

}  // namespace isoloop
