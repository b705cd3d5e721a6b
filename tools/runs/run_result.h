// What the runs of `count`, `loops`, `scan` and `repair` give: what was read, how it was asked for,
// what came out, what it cost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/loops/features.h"
#include "core/repair/repair.h"
#include "isoloop/scan.h"
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

/// Of this process now, or the largest so far where the system does not tell.
std::uint64_t resident_bytes();

/// What every run has.
struct RunInput {
  std::string file{};                                     // as named on the command line
  std::shared_ptr<const std::filesystem::path> staged{};  // the copy of a pipe; null if it was none
  Volume volume{};
  std::optional<AnyGridView> voxels{};  // of a volume whose values are held elsewhere
  ValueRange range{};
  std::optional<double> nan_as{};  // the value that was read in place of NaN
  IsoLevel level{};
  std::string iso_choice{};  // how --iso auto came to the level's iso value; empty: it was stated
  std::string remark{};      // on the unit of lengths; or empty
  std::string hint{};  // what the values suggest, for a mask that was not read as one; or empty
  std::size_t warnings_told = 0;  // of the volume's, to the user
  RunCost cost{};
};

/// Adds a sentence to the volume's warnings, which commands tell and reports repeat.
void add_warning(RunInput& run, std::string sentence);

/// Prints the warnings that have not been told, one a line.
void tell_warnings(std::ostream& out, RunInput& run);

/// The voxels of the run's volume, wherever they are held.
AnyGridView voxels_of(const RunInput& run);

/// A run of `count`: the analysis has no loops.
struct CountRun : RunInput {
  Analysis analysis{};
};

/// A run of `loops` or `view`.
struct LoopsRun : CountRun {
  GeodesicMode geodesic = GeodesicMode::hierarchy;
  Engine engine = Engine::dual;
  Refinement refinement = Refinement::both;  // of the engine `pair`
  Tighten tighten = Tighten::basis;
  int grading = 1;  // of an octree, if analysis.complex is one
  LoopFilter filter{};
  std::vector<Loop> reported{};     // select_loops(analysis.loops, filter)
  std::vector<Feature> features{};  // one for each of analysis.loops; empty: not looked for
  bool with_features = false;       // reports tell of them
  std::optional<Scan> scan{};       // where a page is to show it
};

using LoopsReport = std::function<void(std::ostream&, const LoopsRun&)>;

/// A run of `scan`: `level` has the rule, its iso value means nothing.
struct ScanRun : RunInput {
  Scan scan{};
};

/// A run of `repair`; the volume is the repaired one once it is written.
struct RepairRun : RunInput {
  Repair repair{};
  std::string output{};  // the file written; empty on a dry run
};

/// The volume's notes, how its iso value was chosen, the remark and the hint.
std::vector<std::string> notes_of(const RunInput& run);

/// Throws SelfCheckFailed unless every component of the surface is closed (or, with an open
/// boundary, a surface with a border), the parts add up to the whole, and the Betti numbers are
/// those that the components imply.
void check_counts(const Analysis& analysis);

/// Throws SelfCheckFailed unless the loops are as many as the surface asks for, number 1, 2, ...
/// within their kind, close up along edges of M and carry the certificate of their kind.
void check_loops(const Analysis& analysis);

}  // namespace isoloop
