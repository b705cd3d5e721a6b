// Triangle meshes from files, strictly: a file that is cut or garbled is refused with its place.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/finding.h"
#include "core/grid/grid.h"

namespace isoloop {

struct Mesh {
  std::vector<Vec3> points{};  // finite; world coordinates, unit of the file
  std::vector<std::array<std::uint32_t, 3>> triangles{};  // corners, anticlockwise from outside
  std::size_t loose_points = 0;     // of an OBJ file, which states no counts: in none of its faces
  std::vector<Finding> warnings{};  // what was passed over or assumed; a sentence each
};

enum class MeshKind { stl, ply, obj, off };

/// By the extension: .stl, .ply, .obj or .off, whatever its case. Nothing for any other.
bool is_mesh(const std::filesystem::path& path);

/// Reads a mesh file: ASCII and binary STL, ASCII and binary PLY, Wavefront OBJ (polygons), OFF
/// (also with normals, colours and texture coordinates). Polygons become fans of triangles about
/// their first corner, which is the polygon itself if it is convex. Points of equal coordinates
/// become one, triangles that use one point twice are left out, and corners at open edges that
/// differ in their last bits become one too, with a warning (see weld_borders). Lines may end as on
/// any system.
/// What is whole but untidy is read, and Mesh::warnings say what was assumed: a binary STL file
/// that states fewer triangles than follow, statements that OBJ does not have, faces of fewer than
/// three corners in OFF and PLY.
/// Throws InvalidInput, naming line or byte: a file that is cut, garbled, longer than it states, or
/// that holds a corner that does not exist, a coordinate that is not finite, or no triangle.
/// Throws LimitExceeded if the file, the mesh and what joins its corners take more than `max_bytes`
/// (0: default_voxel_limit()), before they are asked for: by the count in the header of a binary
/// STL file, else by the size of the file, and by the mesh once its text is read.
/// The last line of a text needs no end where nothing can be missing from it: after the word
/// endsolid; after a corner of PLY and OFF to which no digit can be added; else if the mesh is
/// closed, as one whose last face is cut is not. An OBJ file cut at the end of a line, or within a
/// line that says nothing of the surface, is read: its mesh is open or has loose points, unless
/// nothing but whole shells with their points are gone.
Mesh read_mesh(const std::filesystem::path& path, std::uint64_t max_bytes = 0);

/// The same from a file's bytes; `what` opens the message of an error.
Mesh parse_mesh(std::string_view bytes, MeshKind kind, const std::string& what,
                std::uint64_t max_bytes = 0);

}  // namespace isoloop
