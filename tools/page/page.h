// The result as one page to look at, which needs no network.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>

#include "tools/runs/run_result.h"
#include "tools/words/cli_app.h"

namespace isoloop {

struct PageOptions {
  std::size_t most_triangles = 120'000;     // of the surface as it is drawn
  std::size_t most_pieces = 5'000;          // of the surface, the largest; 1 or more
  std::size_t most_loop_bytes = 6'000'000;  // for the loops, the largest; as JSON
  std::size_t most_voxels = 1'500'000;      // of the volume as its slices are drawn, a byte each
};

/// Adds --triangles. `options` must outlive the parse.
void add_page_flags(CLI::App& command, PageOptions& options);

/// What a page lacks: the smallest of each.
struct LeftOut {
  std::size_t pieces = 0;
  std::size_t loops = 0;  // of the reported ones
};

/// ", which leaves out 12 small pieces and 3 small loops"; empty where nothing is.
std::string left_out_text(const LeftOut& left_out);

/// Writes one HTML file: the surface, simplified (without a change of its topology, as far as that
/// goes with the limits), the reported loops as they are, the points of the surface that lie in the
/// features if `run` has them, the volume in blocks of voxels for slices, the counts, what was left
/// out, the scan if `run` has one, and the viewer (tools/viewer). Positions are in the frame of the
/// input, rounded to 1/65535 of the surface's extent along each axis.
LeftOut write_page(std::ostream& out, const LoopsRun& run, const PageOptions& options = {});

}  // namespace isoloop
