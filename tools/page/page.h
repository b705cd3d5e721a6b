// The result as one page to look at, which needs no network.
#pragma once

#include <cstddef>
#include <ostream>

#include "tools/runs/run_result.h"
#include "tools/words/cli_app.h"

namespace isoloop {

struct PageOptions {
  std::size_t most_triangles = 120'000;  // of the surface as it is drawn
  std::size_t most_voxels = 1'500'000;   // of the volume as its slices are drawn, a byte each
};

/// Adds --triangles. `options` must outlive the parse.
void add_page_flags(CLI::App& command, PageOptions& options);

/// Writes one HTML file: the surface, simplified without a change of its topology, the reported
/// loops as they are, the points of the surface that lie in the features if `run` has them, the
/// volume in blocks of voxels for slices, the counts, the scan if `run` has one, and the viewer
/// (tools/viewer). Positions are in the frame of the input, rounded to 1/65535 of the surface's
/// extent along each axis.
void write_page(std::ostream& out, const LoopsRun& run, const PageOptions& options = {});

}  // namespace isoloop
