// One run of `count`, `loops` or `scan`: what was read, how it was asked for, what came out, what
// it cost.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/loops/features.h"
#include "core/scan/plateau.h"
#include "core/scan/scan.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Which of the proved loops a report shows.
struct LoopFilter {
  double min_size = 0.0;                                      // unit of the spacing
  double max_size = std::numeric_limits<double>::infinity();  // unit of the spacing
  bool handles = true;
  bool tunnels = true;
};

/// The loops that pass the filter, in the order and with the ids of the full list.
std::vector<Loop> select_loops(const std::vector<Loop>& loops, const LoopFilter& filter);

struct RunCost {
  std::uint64_t max_bytes = 0;   // what --max-memory leaves once the volume is read
  double read_seconds = 0.0;     // wall clock
  double total_seconds = 0.0;    // wall clock, from the start of reading to the report
  std::uint64_t peak_bytes = 0;  // largest resident set of the process so far
};

/// Largest resident set of this process so far, in bytes.
std::uint64_t peak_resident_bytes();

/// All that a report is made from.
struct RunResult {
  std::string file;  // as named on the command line
  Volume volume;
  ValueRange range;
  std::optional<double> nan_as;  // the value that was read in place of NaN
  IsoLevel level;
  std::string hint{};  // what the values suggest, for a mask that was not read as one; or empty
  GeodesicMode geodesic = GeodesicMode::hierarchy;
  Engine engine = Engine::dual;
  Refinement refinement = Refinement::both;  // of the engine `pair`
  Tighten tighten = Tighten::basis;
  Analysis analysis;
  bool with_loops = true;  // false: counted only
  LoopFilter filter;
  std::vector<Loop> reported;             // select_loops(analysis.loops, filter)
  std::vector<Feature> features{};        // one for each of analysis.loops; empty: not looked for
  bool with_features = false;             // reports tell of them
  std::vector<ScanRow> scan{};            // of `scan`: one for each iso value, ascending
  std::vector<Plateau> plateaus{};        // of `scan`
  std::optional<std::size_t> proposed{};  // of `scan`: the row to look at first, if any
  RunCost cost;
};

/// The volume's notes and the hint.
std::vector<std::string> notes_of(const RunResult& run);

/// Throws SelfCheckFailed unless every component of the surface is closed (or, with an open
/// boundary, a surface with a border), the parts add up to the whole, and the Betti numbers are
/// those that the components imply.
void check_counts(const Analysis& analysis);

/// Throws SelfCheckFailed unless the loops are as many as the surface asks for, number 1, 2, ...
/// within their kind, close up along edges of M and carry the certificate of their kind.
void check_loops(const Analysis& analysis);

}  // namespace isoloop
