// The loops as a table for spreadsheets and scripts.
#pragma once

#include <ostream>

#include "tools/runs/run_result.h"

namespace isoloop {

/// One header line, then one line for each reported loop: id, kind, fix, length, size, component,
/// curves, center_index_i, _j, _k (voxel indices), center_world_x, _y, _z (the frame of the
/// input), certificate_inside, certificate_outside ("trivial" or "nontrivial"). Lengths and sizes
/// are in the unit of the spacing; an infinite size is "inf". Where reports tell of features:
/// label, area, depth, thickness, least_girth, mean_girth, axis_x, axis_y, axis_z (the frame of the
/// input).
void write_csv(std::ostream& out, const LoopsRun& run);

/// One header line, then one line for each component of the surface: component, vertices,
/// triangles, euler, genus, bounds (solid, cavity or unknown), borders.
void write_count_csv(std::ostream& out, const CountRun& run);

}  // namespace isoloop
