// Meshes: read, and voxelised where that is little work.
#pragma once

#include "tests/fuzz/target.h"
#include "volume/mesh/mesh.h"
#include "volume/voxelize/voxelize.h"

namespace isoloop::fuzz {

inline int read_as_mesh(const std::uint8_t* data, std::size_t size, MeshKind kind) {
  return expect_answer_or_error(data, size, [&](std::string_view bytes) {
    const Mesh mesh = parse_mesh(bytes, kind, "mesh");
    if (mesh.triangles.size() < 500) voxelize(mesh, {.resolution = 8}, {}, "mesh");
  });
}

}  // namespace isoloop::fuzz
