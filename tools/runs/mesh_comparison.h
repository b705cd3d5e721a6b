// Whether voxels have the topology of the mesh that they were made from.
#pragma once

#include <optional>
#include <string>

#include "core/analysis/analysis.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// Whether the counts of `analysis` are those of the mesh that was voxelised. Nothing if there is
/// none, if it has no counts of its own, or if the surface is open or runs elsewhere than where the
/// distance to the mesh is 0.
std::optional<bool> voxels_agree(const RunInput& run, const Analysis& analysis);

/// Where voxels and mesh differ, a sentence with both counts and the length of voxels to try: half
/// the least gap between two shells, if that is less than half the present length; else the latter.
/// Empty if they agree, if nothing is known, or if --resolution auto has said so.
std::string difference_text(const RunInput& run, const Analysis& analysis);

/// Adds difference_text() to the volume's warnings.
void compare_with_mesh(RunInput& run, const Analysis& analysis);

/// Of the volume's mesh: "2 shells: 2 components, 2 tunnels, 0 cavities", or why they are unknown.
std::string mesh_text(const MeshCounts& mesh);

}  // namespace isoloop
