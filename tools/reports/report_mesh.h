// The surface with its loops, as a mesh that any viewer opens.
#pragma once

#include <ostream>

#include "tools/runs/run_result.h"

namespace isoloop {

struct MeshOptions {
  double tube_radius = 0.25;  // of the tube round each loop; in smallest voxel edges
  bool loops = true;          // false: the surface alone, in grey
};

/// Writes a binary little-endian PLY: the surface in grey, its normals leading outside, and round
/// each reported loop a closed tube of triangles; handle loops green, tunnel loops red, loops of an
/// open boundary blue, and so are the surface's own vertices on them (green where two meet).
/// Where reports tell of features, each vertex has a label (see vertex_labels()), those of a tube
/// the loop's own.
/// Positions are in the world frame of the input, which a comment in the header names. Throws
/// LimitExceeded where the mesh outgrows 31-bit indices.
void write_ply(std::ostream& out, const LoopsRun& run, const MeshOptions& options = {});

}  // namespace isoloop
