// The table that people read first.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "tools/runs/run_result.h"

namespace isoloop {

/// Writes the counts of the surface and the solid, then one row for each of the largest components
/// of the surface.
void write_count_table(std::ostream& out, const CountRun& run);

/// Writes the counts, then one row for each reported loop, the total length of each kind and what
/// was verified. With `most_rows` above 0 the rows are those of so many largest loops, these first,
/// and how many more there are is said. Lengths, sizes and centres are in the unit of the spacing,
/// which stands in the heads where the file states it, with the digits that a hundredth of a voxel
/// asks for.
void write_table(std::ostream& out, const LoopsRun& run, std::size_t most_rows = 0);

/// The reported loops in the order of the table's rows.
std::vector<const Loop*> loops_in_rows(const LoopsRun& run, std::size_t most_rows);

/// "and 12 more: --top 0 shows all, --json lists all"; nothing if `rows` are `all`.
void write_more(std::ostream& out, std::size_t rows, std::size_t all);

/// "256 x 256 x 128 uint8", and which part of the file that is, unless it is all of it.
std::string volume_text(const Volume& volume);

/// "voxels 10:20,0:256,5:128 of 256 x 256 x 128".
std::string part_text(const Volume& volume, const VolumePart& part);

/// "note: ..." after an empty line, for the remark and the hint that the run has.
void write_hint(std::ostream& out, const RunInput& run);

/// "f >= 70" or "f <= 70": which voxels are inside.
std::string inside_text(const IsoLevel& level);

/// The same, and how --iso auto came to the value if it did.
std::string inside_text(const RunInput& run);

/// What a component of the surface closes off: "solid", or "cavity" within the solid; "unknown"
/// with an open boundary.
std::string bounds_text(Boundary boundary, const SurfaceComponent& component);

/// "handle", "tunnel" or "loop".
std::string kind_text(LoopKind kind);

/// What takes the loop's handle or tunnel away: "cut" or "fill"; "none" where neither is known to.
std::string fix_text(LoopKind kind);

/// The unit of lengths: "µm" and the like, "unit of the spacing" where the file does not state it.
std::string unit_text(const Volume& volume);

/// `name`, and in brackets the unit that the file states, to the power: "area (mm²)".
std::string with_unit(const std::string& name, const Volume& volume, int power = 1);

/// "frame index, spacing 1 1 1 in the unit of lengths": for comments in files. At most 70
/// characters unless the spacing takes many digits.
std::string frame_comment(const RunInput& run);

}  // namespace isoloop
