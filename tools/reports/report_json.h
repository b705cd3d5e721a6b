// The machine-readable report, schema "isoloop/1".
#pragma once

#include <ostream>

#include <nlohmann/json_fwd.hpp>

#include "tools/runs/run_result.h"

namespace isoloop {

/// Writes one JSON object, one line for each loop, so that it can be read as it streams. Curves
/// are in the world frame of the input, which "conventions" names with its affine; lengths and
/// sizes are in the unit of the spacing. JSON has no infinity: an infinite size, which means that
/// the loop joins two components of the surface, is null. All but the lines "seconds" and
/// "peak_bytes" are the same bytes for any number of threads.
void write_json(std::ostream& out, const LoopsRun& run);

/// The same of a run that only counted: without loops, and without what loops alone depend on.
void write_count_json(std::ostream& out, const CountRun& run);

/// Which voxels of the file were read: `first` index along each axis, and the dims that the part is
/// `of`; null: all of them.
nlohmann::ordered_json part_json(const Volume& volume);

/// The counts of the mesh that was voxelised, and whether those of `analysis` are the same (null:
/// they cannot be held against each other); null for a volume.
nlohmann::ordered_json mesh_json(const RunInput& run, const Analysis& analysis);

}  // namespace isoloop
