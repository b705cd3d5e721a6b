// Triangle meshes from files, strictly: a file that is cut or garbled is refused with its place.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/grid.h"

namespace isoloop {

struct Mesh {
  std::vector<Vec3> points{};  // finite; world coordinates, unit of the file
  std::vector<std::array<std::uint32_t, 3>> triangles{};  // corners, anticlockwise from outside
  std::size_t loose_points = 0;  // of an OBJ file, which states no counts: in none of its faces
};

enum class MeshKind { stl, ply, obj, off };

/// By the extension: .stl, .ply, .obj or .off, whatever its case. Nothing for any other.
bool is_mesh(const std::filesystem::path& path);

/// Reads a mesh file: ASCII and binary STL, ASCII and binary PLY, Wavefront OBJ (polygons), OFF
/// (also COFF and NOFF). Polygons become fans of triangles about their first corner, which is the
/// polygon itself if it is convex. Points of equal coordinates become one, triangles that use one
/// point twice are left out.
/// Throws InvalidInput, naming line or byte: a file that is cut, garbled, longer than it states, or
/// that holds a corner that does not exist, a coordinate that is not finite, or no triangle.
/// Throws LimitExceeded if the file and the mesh take more than `max_bytes` (0:
/// default_voxel_limit()), before they are asked for. Text must end with the end of a line: that is
/// how a cut within its last number is told. An OBJ file cut at the end of a line is read: its mesh
/// is open or has loose points, unless nothing but whole shells with their points are gone.
Mesh read_mesh(const std::filesystem::path& path, std::uint64_t max_bytes = 0);

/// The same from a file's bytes; `what` opens the message of an error.
Mesh parse_mesh(std::string_view bytes, MeshKind kind, const std::string& what);

}  // namespace isoloop
