// The whole pipeline: volume -> M -> closest vertices -> sizes -> order -> labels -> loops.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/memory_budget.h"
#include "core/base/progress.h"
#include "core/engines/pair.h"
#include "core/grid/grid.h"
#include "core/surface/betti.h"
#include "core/surface/surface.h"
#include "isoloop/loop.h"

namespace isoloop {

/// dual: the dual pass and a search for short loops. pair: the paper's PAIR and HANTUN, which take
/// the killed cycles as they are; the dual pass runs too: its classes certify the loops, and under
/// the order by size its killing pieces must be those of PAIR.
enum class Engine { dual, pair };

/// Loops of this length and more are found and proved, but not made short: whoever asks for short
/// ones alone has them sooner. Unit of the spacing.
struct ShortenBelow {
  double handles = std::numeric_limits<double>::infinity();
  double tunnels = std::numeric_limits<double>::infinity();
};

struct AnalysisOptions {
  Boundary boundary = Boundary::closed;
  GeodesicMode geodesic = GeodesicMode::hierarchy;
  Engine engine = Engine::dual;
  ComplexKind complex = ComplexKind::automatic;
  int grading = 1;                      // of an octree, see graded_leaves(): 0 to 2
  Tighten tighten = Tighten::basis;     // not read with an open boundary
  ShortenBelow shorten_below{};         // with an open boundary: by the side, inside as handles
  PairOptions pair{};                   // read by the engine `pair` alone
  bool count_volume_triangles = false;  // fills Analysis::volume_triangles
  Progress progress{};                  // may be empty
  std::uint64_t max_bytes = unlimited_bytes;  // to hold beside the grid's voxels
};

/// Wall-clock seconds of each stage, but for the last.
struct StageSeconds {
  double surface = 0.0;
  double closest = 0.0;
  double sizes = 0.0;
  double pass = 0.0;
  double pair = 0.0;  // of the engine `pair` alone
  double loops = 0.0;
  double slowest_loops = 0.0;  // CPU, within `loops`: slowest_hundredth() of both sides' searches
};

struct Analysis {
  Surface surface;
  ComplexKind complex = ComplexKind::automatic;  // grid or octree; automatic: no loops, no complex
  Betti betti;
  std::vector<Loop> loops;         // by kind, then by size; every one certified
  std::vector<SurfacePair> pairs;  // engine `pair`: what pair_simplices() returns
  /// No basis of the handle loops, or of the tunnel loops, has a smaller total length along edges
  /// of M; 0 where nothing is known. Unit of the spacing.
  double least_handle_length = 0.0;
  double least_tunnel_length = 0.0;
  std::uint64_t volume_triangles = 0;  // of K off M, both sides; 0 unless asked for
  StageSeconds seconds;
};

/// Both throw LimitExceeded before a stage that would take more than options.max_bytes.

/// The surface and the counts alone: no sizes, no loops (`seconds` past surface stay 0).
Analysis count_topology(const AnyGridView& grid, const IsoLevel& level,
                        const AnalysisOptions& options = {});

/// Finds and proves every handle loop and tunnel loop of the iso-surface. Deterministic: the same
/// bytes for any number of threads. Throws InvalidInput (NaN in the grid), LimitExceeded,
/// and SelfCheckFailed if any proof fails: no unproved loop is ever returned.
Analysis analyze(const AnyGridView& grid, const IsoLevel& level,
                 const AnalysisOptions& options = {});

}  // namespace isoloop
